"""Writing a bank: k variants of each problem, with numbers that no student is graded on."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from itertools import repeat
from pathlib import Path
from typing import Any

from exercises.catalogue import problem

from ..assignment.cells import Values
from ..assignment.chosen import as_asked
from ..assignment.spec import Spec
from ..course import CourseError
from ..course.files import write_bytes
from ..course.processes import process_pool
from ..practice.graded import same_for_all
from ..practice.twins import sets_of_numbers, twin
from . import canvas, moodle, qti
from .questions import Question, left_out, question

FORMATS = {
    "moodle": (moodle.write, ".xml"),
    "qti": (qti.write, ".zip"),
    "canvas": (canvas.write, ".zip"),
}


@dataclass(frozen=True)
class Bank:
    """A written bank: the number of problems and questions, and notes on what is left out or
    differs from a sheet.
    """

    path: Path
    problems: int
    questions: int
    notes: tuple[str, ...]


def write_bank(
    path: Path,
    spec: Spec,
    form: str,
    variants: int,
    seed: str,
    graded: Mapping[str, Sequence[Values]] | None = None,
    workers: int | None = None,
    done: Callable[[], object] = lambda: None,
) -> Bank:
    """Write ``variants`` sets of numbers of each problem of an assignment, drawn by ``seed``, as
    ``form``, one of :data:`FORMATS`. The file holds the right answers and is readable by its owner
    only.

    graded : {problem id: [numbers of a student's sheet]}: answers of the bank must not be near
        those of these sheets
    done : called after each problem
    """
    write, _ = FORMATS[form]
    no_help = {"help": "none"} if spec.late else {}  # an exam gives no help
    jobs = [
        (p.id, i.text, {**i.options, **no_help}, (graded or {}).get(p.id))
        for i in spec.items
        if (p := i.problem)
    ]
    notes = [*_of_sheet(spec)]
    questions: list[Question] = []
    problems = 0
    with process_pool(workers) as pool:
        for found, left_out in pool.map(variants_of, jobs, repeat(variants), repeat(seed)):
            questions += found
            notes += left_out
            problems += bool(found)
            done()
    if not questions:
        raise CourseError("no question is left: " + "; ".join(notes))
    if form == "canvas":
        notes.append("Canvas judges one number a question: each component is a question of its own")
    write_bytes(path, write(spec.name, questions))
    return Bank(path, problems, len(questions), tuple(notes))


def _of_sheet(spec):
    """Notes on what a sheet does and a bank does not."""
    if own := [*(i.question for i in spec.items if i.question), *spec.left_out]:
        yield f"{', '.join(own)} left out: cells of your own"
    if any(len(p.answers) > 1 for p in spec.problems):
        yield "each answer is judged by itself: one that follows from a wrong one earns nothing"
    if spec.late:
        yield "the window of the exam and the one attempt in it are for you to set on the platform"


def variants_of(
    job: tuple[str, str, Mapping[str, Any], Sequence[Values] | None], count: int, seed: str
) -> tuple[list[Question], list[str]]:
    """(the questions of one problem, notes)."""
    name, text, options, graded = job
    asked = as_asked(problem(name), options)
    p, points = twin(asked), options.get("points", len(asked.answers))
    notes = [f"{name} {a.key} left out: {why}" for a in p.answers if (why := left_out(a))]
    if len(notes) == len(p.answers):
        return [], [*notes, f"{name} left out: no answer is left"]
    changed = p is not asked
    if changed:
        notes.append(f"{name} asks for formulas on a sheet: asked with numbers for its symbols")
    diagnosed = options.get("help") != "none"
    if not diagnosed:
        notes.append(f"{name} has no diagnoses of wrong answers, since its sheet gives no help")
    sets = sets_of_numbers(
        p, count, graded or (), seed, book=not any(g.vary for g in p.givens.values())
    )
    if not sets:
        return [], [f"{name} left out: all its answers are near graded ones"]
    if graded is not None and (same := same_for_all(p, sets)):
        return [], [f"{name} left out: its {' and '.join(same)} would give away a graded answer"]
    if len(sets) < count:
        notes.append(f"{name} has {len(sets)} of {count} variants: there are no more numbers")
    made = [
        question(p, v, n, points, "" if changed else text, diagnosed) for n, v in enumerate(sets, 1)
    ]
    return made, notes

"""The graded numbers of a course and their answers, which practice avoids."""

import json
from collections.abc import Callable, Iterable, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from exercises.catalogue import CatalogueError, Problem, problem
from exercises.catalogue.variants import evaluate
from newton_euler.answers.tolerance import NOISE, RTOL, distance

from ..assignment.cells import Values
from ..assignment.options import HELP
from ..assignment.sheet import Task, tasks
from ..course import Course, read_json

FAR = 2  # tolerances: the least distance of practice answers from graded ones


def graded_numbers(
    path: str | Path, done: Callable[[int, int], object] = lambda n, of: None
) -> dict[str, list[Values]]:
    """{problem id: [{name: number} of each student's sheet]} for all assignments of the course in a
    folder: stored numbers, and those derived for students who have not fetched yet.

    done : called with the number of sheets read and the total
    """
    course = Course(path)
    asked: dict[str, list[Problem]] = {}
    for source in sorted((course.path / "source").glob("*/*.ipynb")):
        known = filter(None, map(_known, tasks(read_json(source))))
        asked.setdefault(source.parent.name, []).extend(known)
    found: dict[str, list[Values]] = {p.id: [] for problems in asked.values() for p in problems}
    sheets = [(assignment, student) for assignment in asked for student in course.roster()]
    for n, (assignment, student) in enumerate(sheets, 1):
        for name, values in course.values(assignment, student, asked[assignment]).items():
            found[name].append(values)
        done(n, len(sheets))
    for file in sorted((course.path / "numbers").glob("*/*.json")):
        for name, kept in json.loads(file.read_text(encoding="utf-8")).items():
            found.setdefault(name, []).append({n: x for n, (x, _) in kept.items()})
    return found


def rules_of(path: str | Path) -> dict[str, dict[str, Any]]:
    """{problem id: {"tolerance", "help"}} of all assignments of the course in a folder: the largest
    tolerance, the least help.
    """
    sources = sorted((Course(path).path / "source").glob("*/*.ipynb"))
    return strictest(task for source in sources for task in tasks(read_json(source)).values())


def strictest(asked: Iterable[Task]) -> dict[str, dict[str, Any]]:
    """:func:`rules_of` for some tasks."""
    found: dict[str, dict[str, Any]] = {}
    for task in asked:
        own = found.setdefault(task.problem, {})
        own["tolerance"] = max(task.tolerance or RTOL, own.get("tolerance", 0.0))
        if task.help is not None:
            own["help"] = min(task.help, own.get("help", HELP[-1]), key=HELP.index)
    return found


def _known(name):
    """A problem, or None if the catalogue no longer has it."""
    try:
        return problem(name)
    except CatalogueError:
        return None


class GradedAnswers:
    """The right answers for the numbers of a problem's graded sheets. Called with other numbers, it
    returns whether one of their answers is near one of a sheet's.
    """

    def __init__(self, p: Problem, sheets: Iterable[Values]):
        self._problem, self._numbers = p, [own for own in sheets if own]
        of_sheets = [self._answers({**p.book_values, **own}) for own in self._numbers]
        self._keys = {
            a: np.array([answers[a.key][0] for answers in of_sheets])
            for a in p.answers if of_sheets and not a.kind.is_word
        }  # fmt: skip

    def __call__(self, values: Values) -> bool:
        if any(all(values.get(n) == x for n, x in own.items()) for own in self._numbers):
            return True
        answers = self._answers(values) if self._keys else {}
        return any(
            _is_near(x, keys, FAR * a.rtol)
            for a, keys in self._keys.items()
            for x in answers[a.key]
        )

    def _answers(self, values):
        """{answer: its equivalent points}, for numeric answers."""
        p = self._problem
        right = evaluate(p, {n: values[n] for n in p.units})[0]
        return {
            a.key: a.kind.sealed(tuple(map(float, right[a.key])))
            for a in p.answers if not a.kind.is_word
        }  # fmt: skip


def same_for_all(p: Problem, sets: Sequence[Values]) -> list[str]:
    """The answers that are equal for all these numbers, up to round-off."""
    first, *others = (evaluate(p, values)[0] for values in sets)

    def is_same(a):
        if a.kind.is_word:
            return all(x[a.key] == first[a.key] for x in others)
        return all(distance(x[a.key], first[a.key]) <= NOISE for x in others)

    return [a.key for a in p.answers if is_same(a)]


def _is_near(point, keys, far):
    sizes = np.linalg.norm(keys, axis=1)
    return bool(np.any(np.linalg.norm(keys - np.array(point), axis=1) <= far * sizes))

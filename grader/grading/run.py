"""Grades all submissions of an assignment: on several workers, only what changed, in one
transaction of the gradebook.
"""

import hashlib
import json
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field
from functools import cache
from pathlib import Path

from ..assignment.personal import master_bytes
from ..course import CourseError, write_json
from ..sandbox import Harvester, HarvestError
from ..scoring import Part, Score
from ..submission import pipeline
from ..submission.rebuild import read_answers, rebuild_notebook
from .gradebook import points_by_cell, save_results, saved_points

VERSION = "1"  # part of the fingerprint: a new number grades everything again
MAX_BYTES = 64 * 2**20  # of a submitted notebook


@dataclass
class Result:
    """The result of one submission: {problem id: score}, or in ``problem`` the reason why it was
    not graded.
    """

    student: str
    scores: dict = field(default_factory=dict)
    note: str = ""
    problem: str = ""
    unchanged: bool = False

    @property
    def points(self):
        """The sum of the points of all problems."""
        return sum(s.points for s in self.scores.values())

    @property
    def out_of(self):
        """The maximum of points."""
        return sum(s.out_of for s in self.scores.values())

    def diagnoses(self):
        """The explained wrong answers: [(problem id, key, sentence)]."""
        return [
            (i, p.key, p.diagnosis) for i, s in self.scores.items() for p in s.parts if p.diagnosis
        ]


def grade(
    course, assignment, students=None, force=False, workers=None, sandbox=True, progress=None
):
    """Grade the submissions of an assignment and write gradebook and annotated notebooks; returns a
    list of :class:`Result`.

    students : ids to grade; default: all who submitted. force : also grade submissions that have
        not changed since they were graded.
    workers : number of processes; default: one per processor. sandbox : False runs student code
        without isolation. progress : called with each
    Result.
    A submission that cannot be graded is reported in its Result; other submissions, and an earlier
    grade of its own, stay as they are.
    """
    from nbgrader.api import MissingEntry

    submitted = course.submissions(assignment)
    missing = [s for s in students or () if s not in submitted]
    if missing:
        raise CourseError(
            f"no submission of {assignment} by {', '.join(missing)}; there are "
            f"{', '.join(submitted) or 'none'} in {course.path / 'submitted'}"
        )
    # raises CourseError early if nothing is released, as course.secret does if it is missing
    course.released(assignment)
    run = _Run(course, assignment, force, fingerprint(VERSION, course.secret.hex(), _code_state()))
    with course.gradebook() as book:
        try:
            book.find_assignment(assignment)
        except MissingEntry:
            raise CourseError(
                f"the gradebook does not know {assignment}; generate it again with: "
                f"nbgrader generate_assignment {assignment} --force"
            ) from None
        roster = {s.id for s in book.students}
        saved = saved_points(book, assignment)
    wanted = [s for s in submitted if not students or s in students]
    results = []
    with Harvester(workers, sandbox) as harvester, ThreadPoolExecutor(harvester.count) as pool:
        for result in pool.map(
            lambda s: run.grade(s, submitted[s], s in roster, harvester), wanted
        ):
            results.append(result)
            if progress:
                progress(result)
    save_results(
        course,
        assignment,
        [r for r in results if r.scores and saved.get(r.student) != points_by_cell(r)],
    )
    return results


@cache
def _code_state():
    """A hash of the code and the exercises: after a corrected key everything is graded again."""
    root = Path(__file__).parents[2]
    files = [
        f
        for folder in ("exercises", "grader", "newton_euler")
        for kind in ("*.py", "*.yaml")
        for f in sorted((root / folder).rglob(kind))
    ]
    return fingerprint(*(f.read_text(encoding="utf-8") for f in files))


def fingerprint(*contents):
    """A short hash of texts or bytes, to detect changes."""
    digest = hashlib.sha256()
    for content in contents:
        digest.update(content.encode() if isinstance(content, str) else content)
        digest.update(b"\0")
    return digest.hexdigest()[:20]


@dataclass(frozen=True)
class _Run:
    """What is common to all submissions of one run."""

    course: object
    assignment: str
    force: bool
    state: str

    def grade(self, student, path, on_roster, harvester):
        """The :class:`Result` of one submission; never raises."""
        if not on_roster:
            return Result(
                student,
                problem="is not on the roster; check the folder's name, or add the student with: "
                "nbgrader db student add " + student,
            )
        try:
            return self._grade(student, path, harvester)
        except Unreadable as error:
            return Result(
                student, problem=f"{error}; ask for it again. An earlier grade stays as it is"
            )
        except (CourseError, HarvestError) as error:
            return Result(student, problem=f"could not be graded: {error}")
        except Exception as error:  # one submission must not stop the grading of the others
            return Result(
                student,
                problem="could not be graded, which is a bug of the grader: "
                f"{type(error).__name__}: {error}. An earlier grade stays as it is",
            )

    def _grade(self, student, path, harvester):
        course, assignment = self.course, self.assignment
        content = _read(path)
        name = fingerprint(self.state, content, master_bytes(course, assignment, student))
        # not in autograded/: nbgrader copies that to the students
        record_path = course.path / "scores" / assignment / f"{student}.json"
        annotated_path = course.path / "autograded" / student / assignment / f"{assignment}.ipynb"
        if (
            not self.force
            and annotated_path.exists()
            and (earlier := _earlier_result(student, record_path, name))
        ):
            return earlier
        submitted = _notebook(path.name, content)
        own = pipeline.student_assignment(course, assignment, student)
        answers = read_answers(submitted, own.problems)
        receipts, note = pipeline.run_answers(harvester, own, answers)
        scores = pipeline.score_answers(own, answers, receipts)
        write_json(
            annotated_path,
            pipeline.annotate(rebuild_notebook(own.master, answers), scores, note),
            indent=None,
        )
        write_json(
            record_path,
            {
                "fingerprint": name,
                "note": note,
                "scores": [json.loads(s.json()) for s in scores.values()],
            },
        )
        return Result(student, scores, note)


class Unreadable(ValueError):
    """The submission is not a notebook, or cannot be read."""


def _read(path):
    if not path.exists():
        others = (
            [f.name for f in sorted(path.parent.iterdir()) if f.suffix == ".ipynb"]
            if path.parent.is_dir()
            else []
        )
        found = (
            f"it holds {', '.join(others)}; if that is the work, rename it"
            if others
            else "it holds no notebook"
        )
        raise Unreadable(f"expected the notebook {path.name} in {path.parent}, and {found}")
    if path.stat().st_size > MAX_BYTES:
        raise Unreadable(
            f"{path.name} has {path.stat().st_size / 1e6:.0f} MB, more than the "
            f"{MAX_BYTES / 1e6:.0f} MB that are read; have its outputs cleared"
        )
    try:
        return path.read_bytes()
    except OSError as error:
        raise Unreadable(f"{path.name} cannot be read ({error})") from error


def _notebook(name, content):
    try:
        submitted = json.loads(content)
    except (ValueError, RecursionError) as error:
        what = (
            "is empty"
            if not content.strip()
            else f"is damaged and cannot be read as a notebook ({error})"
        )
        raise Unreadable(f"{name} {what}") from error
    if not isinstance(submitted, dict) or not isinstance(submitted.get("cells"), list):
        raise Unreadable(f"{name} is not a notebook of format 4: it has no list of cells")
    return submitted


def _earlier_result(student, path, name):
    """The recorded result of the same submission under the same conditions, or None."""
    try:
        record = json.loads(path.read_text(encoding="utf-8"))
        if record["fingerprint"] != name:
            return None
        scores = {
            s["problem"]: Score(s["problem"], tuple(Part(**p) for p in s["parts"]), s["note"])
            for s in record["scores"]
        }
        return Result(student, scores, record["note"], unchanged=True)
    except (OSError, ValueError, LookupError, TypeError):
        return None

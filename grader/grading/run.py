"""``python -m grader grade``: all submissions of an assignment in one go, one transaction, several workers, and only what changed."""

import json
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field
from datetime import datetime
from functools import cache, cached_property
from pathlib import Path

from ..assignment import notebook as nb
from ..assignment.notebook import fingerprint
from ..course import CourseError, write_json
from ..sandbox.harvester import Harvester, HarvestError
from ..submission import pipeline

VERSION = "1"  # of the way of grading; part of the fingerprint, so that a change of it grades everything again
LARGEST = 64 * 2**20  # bytes of a submitted notebook


@dataclass
class Result:
    """How one submission fared. ``problem`` says in words what kept it from being graded, or is empty."""

    student: str
    scores: dict = field(default_factory=dict)
    note: str = ""
    problem: str = ""
    unchanged: bool = False

    @property
    def points(self):
        """Points of all problems together."""
        return sum(s.points for s in self.scores.values())

    @property
    def out_of(self):
        """The most that there is."""
        return sum(s.out_of for s in self.scores.values())

    def diagnoses(self):
        """[(problem, key, sentence)] of the wrong answers that could be explained."""
        return [(i, p.key, p.diagnosis) for i, s in self.scores.items() for p in s.parts if p.diagnosis]


def grade(course, assignment, students=None, force=False, workers=None, sandbox=True, progress=None):
    """Grade the submissions of an assignment and write gradebook and annotated notebooks; returns a list of :class:`Result`.

    students : ids to grade; default: everyone who submitted. force : also those whose notebook is the one graded before.
    A submission that cannot be graded is reported in its Result and leaves all others, and any earlier grade of its own, as they are.
    """
    from nbgrader.api import MissingEntry

    submitted = course.submissions(assignment)
    missing = [s for s in students or () if s not in submitted]
    if missing:
        raise CourseError(
            f"no submission of {assignment} by {', '.join(missing)}; there are {', '.join(submitted) or 'none'} in {course.path / 'submitted'}"
        )
    course.released(assignment)  # these fail early, with what to do
    run = _Run(course, assignment, force, fingerprint(VERSION, course.secret.hex(), _code_state()))
    with course.gradebook() as book:
        try:
            book.find_assignment(assignment)
        except MissingEntry:
            raise CourseError(
                f"the gradebook does not know {assignment}; generate it again with: nbgrader generate_assignment {assignment} --force"
            ) from None
        roster = {s.id for s in book.students}
        saved = _saved(book, assignment)
    wanted = [s for s in submitted if not students or s in students]
    results = []
    with Harvester(workers, sandbox) as harvester, ThreadPoolExecutor(harvester.count) as pool:
        for result in pool.map(lambda s: run.graded(s, submitted[s], s in roster, harvester), wanted):
            results.append(result)
            if progress:
                progress(result)
    _save(course, assignment, [r for r in results if r.scores and saved.get(r.student) != _points(r)])
    return results


@cache
def _code_state():
    """A name for what grading depends on besides submission and course: a corrected key grades everything again."""
    root = Path(__file__).parents[2]
    files = [f for folder in ("exercises", "grader", "newton_euler") for kind in ("*.py", "*.yaml") for f in sorted((root / folder).rglob(kind))]
    return fingerprint(*(f.read_text(encoding="utf-8") for f in files))


@dataclass(frozen=True)
class _Run:
    """What all submissions of one run have in common."""

    course: object
    assignment: str
    force: bool
    state: str

    def graded(self, student, path, known, harvester):
        """The :class:`Result` of one submission, whatever happens in it."""
        if not known:
            return Result(
                student, problem="is not on the roster; check the folder's name, or add the student with: nbgrader db student add " + student
            )
        try:
            return self._graded(student, path, harvester)
        except Unreadable as error:
            return Result(student, problem=f"{error}; ask for it again. An earlier grade stays as it is")
        except (CourseError, HarvestError) as error:
            return Result(student, problem=f"could not be graded: {error}")
        except Exception as error:  # one submission must not keep the others from their grades
            return Result(
                student,
                problem=f"could not be graded, which is a bug of the grader: {type(error).__name__}: {error}. An earlier grade stays as it is",
            )

    def _graded(self, student, path, harvester):
        course, assignment = self.course, self.assignment
        content = _read(path)
        name = fingerprint(self.state, content, course.master_bytes(assignment, student))
        record_path = course.path / "scores" / assignment / f"{student}.json"  # not in autograded/: nbgrader copies that to the students
        annotated_path = course.path / "autograded" / student / assignment / f"{assignment}.ipynb"
        if not self.force and annotated_path.exists() and (earlier := _restored(student, record_path, name)):
            return earlier
        submitted = _notebook(path.name, content)
        own = pipeline.sheet(course, assignment, student)
        answers = nb.answers(submitted, own.problems)
        receipts, note = pipeline.harvested(harvester, own, answers)
        scores = pipeline.scored(own, answers, receipts)
        write_json(annotated_path, pipeline.annotated(nb.rebuilt(own.master, answers), scores, note), indent=None)
        write_json(record_path, {"fingerprint": name, "note": note, "scores": [json.loads(s.json()) for s in scores.values()]})
        return Result(student, scores, note)


class Unreadable(ValueError):
    """A submission that is not a notebook that can be read."""


def _read(path):
    if not path.exists():
        others = [f.name for f in sorted(path.parent.iterdir()) if f.suffix == ".ipynb"] if path.parent.is_dir() else []
        found = f"it holds {', '.join(others)}; if that is the work, rename it" if others else "it holds no notebook"
        raise Unreadable(f"expected the notebook {path.name} in {path.parent}, and {found}")
    if path.stat().st_size > LARGEST:
        raise Unreadable(
            f"{path.name} has {path.stat().st_size / 1e6:.0f} MB, more than the {LARGEST / 1e6:.0f} MB that are read; have its outputs cleared"
        )
    try:
        return path.read_bytes()
    except OSError as error:
        raise Unreadable(f"{path.name} cannot be read ({error})") from error


def _notebook(name, content):
    try:
        submitted = json.loads(content)
    except (ValueError, RecursionError) as error:
        what = "is empty" if not content.strip() else f"is damaged and cannot be read as a notebook ({error})"
        raise Unreadable(f"{name} {what}") from error
    if not isinstance(submitted, dict) or not isinstance(submitted.get("cells"), list):
        raise Unreadable(f"{name} is not a notebook of format 4: it has no list of cells")
    return submitted


def _restored(student, path, name):
    """The earlier result of the same submission under the same conditions, or None."""
    from ..scoring.score import Part, Score

    try:
        record = json.loads(path.read_text(encoding="utf-8"))
        if record["fingerprint"] != name:
            return None
        scores = {s["problem"]: Score(s["problem"], tuple(Part(**p) for p in s["parts"]), s["note"]) for s in record["scores"]}
        return Result(student, scores, record["note"], unchanged=True)
    except (OSError, ValueError, LookupError, TypeError):
        return None


def _points(result):
    """{cell: points} of a result, as the gradebook has them."""
    return {f"answer-{nb.slug(i)}": s.points for i, s in result.scores.items()}


def _saved(book, assignment):
    """{student: {answer cell: automatic points}} in the gradebook: an interrupted run, a restored backup or another grader show here."""
    from nbgrader.api import Assignment, BaseCell, Grade, SubmittedAssignment, SubmittedNotebook

    rows = (
        book.db.query(SubmittedAssignment.student_id, BaseCell.name, Grade.auto_score)
        .select_from(Grade)
        .join(BaseCell, BaseCell.id == Grade.cell_id)
        .join(SubmittedNotebook, SubmittedNotebook.id == Grade.notebook_id)
        .join(SubmittedAssignment, SubmittedAssignment.id == SubmittedNotebook.assignment_id)
        .join(Assignment, Assignment.id == SubmittedAssignment.assignment_id)
        .filter(Assignment.name == assignment)
    )
    found = {}
    for student, cell, points in rows:
        if cell.startswith("answer-"):
            found.setdefault(student, {})[cell] = points
    return found


def _save(course, assignment, results):
    """All results into nbgrader's gradebook, in one transaction: all of them or none."""
    from nbgrader.api import Comment, Grade, SubmittedAssignment, SubmittedNotebook

    if not results:
        return
    late = _LatePenalties(course)
    with course.gradebook() as book:
        master = book.find_assignment(assignment)
        students = {s.id: s for s in book.students}
        existing = {s.student_id: s for s in master.submissions}
        cells = {n.name: ({c.name: c for c in n.grade_cells}, {c.name: c for c in n.solution_cells}) for n in master.notebooks}
        with book.db.no_autoflush:
            for result in results:
                entry = existing.get(result.student) or SubmittedAssignment(assignment=master, student=students[result.student])
                entry.timestamp = _timestamp(course, assignment, result.student) or entry.timestamp
                notebooks = {n.name: n for n in entry.notebooks}
                by_cell = {f"answer-{nb.slug(i)}": s for i, s in result.scores.items()}
                for notebook in master.notebooks:
                    own = notebooks.get(notebook.name) or SubmittedNotebook(notebook=notebook, assignment=entry)
                    grade_cells, solution_cells = cells[notebook.name]
                    grades, comments, total = {g.cell_id: g for g in own.grades}, {c.cell_id: c for c in own.comments}, 0
                    for name, cell in grade_cells.items():
                        grade = grades.get(cell.id) or Grade(cell_id=cell.id, notebook=own)
                        grade.auto_score = by_cell[name].points if name in by_cell else 0
                        grade.needs_manual_grade = grade.manual_score is not None
                        total += (grade.auto_score if grade.manual_score is None else grade.manual_score) + (grade.extra_credit or 0)
                    for name, cell in solution_cells.items():
                        said = comments.get(cell.id) or Comment(cell_id=cell.id, notebook=own)
                        said.auto_comment = pipeline.comment(by_cell[name]) if name in by_cell else None
                    own.late_submission_penalty = late.penalty(result.student, total, entry.total_seconds_late)
                book.db.add(entry)
        book.db.commit()


class _LatePenalties:
    """nbgrader's penalties for late submissions, by the plugin that the course's configuration names."""

    def __init__(self, course):
        self.course = course

    @cached_property
    def plugin(self):
        from nbgrader.preprocessors import AssignLatePenalties

        from ..assignment.build import course_config

        step = AssignLatePenalties(config=course_config(self.course))
        step.init_plugin()
        return step.plugin_inst

    def penalty(self, student, score, seconds_late):
        """The penalty, never less than nothing or more than the score; None if the submission was in time."""
        found = self.plugin.late_submission_penalty(student, score, seconds_late) if seconds_late > 0 else None
        return None if found is None else min(max(found, 0), score)


def _timestamp(course, assignment, student):
    path = course.path / "submitted" / student / assignment / "timestamp.txt"
    if not path.exists():
        return None
    from nbgrader.utils import parse_utc

    try:
        return parse_utc(path.read_text().strip())
    except ValueError:
        return datetime.fromtimestamp(path.stat().st_mtime)

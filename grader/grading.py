"""``python -m grader grade``: all submissions of an assignment in one go, one transaction, several workers, and only what changed."""

import json
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field
from datetime import datetime

from . import notebook as nb
from . import pipeline
from .course import CourseError, write_json
from .harvest import Harvester

VERSION = "1"  # of the way of grading; part of the fingerprint, so that a change of it grades everything again


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
    submitted = course.submissions(assignment)
    missing = [s for s in students or () if s not in submitted]
    if missing:
        raise CourseError(f"no submission of {assignment} by {', '.join(missing)}; there are {', '.join(submitted) or 'none'} in {course.path / 'submitted'}")
    course.released(assignment)  # fails early, with what to do
    with course.gradebook() as book:
        book.find_assignment(assignment)
        roster = {s.id for s in book.students}
    wanted = [s for s in submitted if not students or s in students]
    results = []
    with Harvester(workers, sandbox) as harvester, ThreadPoolExecutor(harvester.count) as pool:
        for result in pool.map(lambda s: _graded(course, assignment, s, submitted[s], s in roster, force, harvester), wanted):
            results.append(result)
            if progress:
                progress(result)
    _save(course, assignment, [r for r in results if r.scores and not r.unchanged])
    return results


def _graded(course, assignment, student, path, known, force, harvester):
    if not known:
        return Result(student, problem="is not on the roster; check the folder's name, or add the student with: nbgrader db student add " + student)
    try:
        text = path.read_text(encoding="utf-8")
    except (OSError, UnicodeDecodeError) as error:
        return Result(student, problem=f"{path.name} cannot be read ({error}); ask for it again. An earlier grade stays as it is")
    try:
        own = pipeline.sheet(course, assignment, student)
        name = nb.fingerprint(VERSION, text, json.dumps(own.master), course.secret.hex())
        record_path = course.path / "scores" / assignment / f"{student}.json"  # not in autograded/: nbgrader copies that to the students
        if not force and _earlier(record_path).get("fingerprint") == name:
            return _restored(student, _earlier(record_path))
        submitted = json.loads(text)
    except (ValueError, RecursionError) as error:
        if isinstance(error, CourseError):
            raise
        return Result(student, problem=f"{path.name} is damaged and cannot be read as a notebook ({error}); ask for it again. An earlier grade stays as it is")
    answers = nb.answers(submitted, own.problems)
    receipts, note = pipeline.harvested(harvester, own, answers)
    scores = pipeline.scored(own, answers, receipts)
    folder = course.path / "autograded" / student / assignment
    write_json(folder / f"{assignment}.ipynb", pipeline.annotated(nb.rebuilt(own.master, answers), scores, note))
    write_json(record_path, {"fingerprint": name, "note": note, "scores": [json.loads(s.json()) for s in scores.values()]})
    return Result(student, scores, note)


def _earlier(path):
    try:
        return json.loads(path.read_text(encoding="utf-8"))
    except (OSError, ValueError):
        return {}


def _restored(student, record):
    from .score import Part, Score

    scores = {s["problem"]: Score(s["problem"], tuple(Part(**p) for p in s["parts"]), s["note"]) for s in record["scores"]}
    return Result(student, scores, record["note"], unchanged=True)


def _save(course, assignment, results):
    """All results into nbgrader's gradebook, in one transaction: all of them or none."""
    from nbgrader.api import Comment, Grade, SubmittedAssignment, SubmittedNotebook

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
                for notebook in master.notebooks:
                    own = notebooks.get(notebook.name) or SubmittedNotebook(notebook=notebook, assignment=entry)
                    grade_cells, solution_cells = cells[notebook.name]
                    grades, comments = {g.cell_id: g for g in own.grades}, {c.cell_id: c for c in own.comments}
                    by_cell = {f"answer-{nb.slug(i)}": s for i, s in result.scores.items()}
                    for name, cell in grade_cells.items():
                        grade = grades.get(cell.id) or Grade(cell_id=cell.id, notebook=own)
                        grade.auto_score = by_cell[name].points if name in by_cell else 0
                        grade.needs_manual_grade = grade.manual_score is not None
                    for name, cell in solution_cells.items():
                        said = comments.get(cell.id) or Comment(cell_id=cell.id, notebook=own)
                        said.auto_comment = pipeline.comment(by_cell[name]) if name in by_cell else None
                book.db.add(entry)
        book.db.commit()


def _timestamp(course, assignment, student):
    path = course.path / "submitted" / student / assignment / "timestamp.txt"
    if not path.exists():
        return None
    from nbgrader.utils import parse_utc

    try:
        return parse_utc(path.read_text().strip())
    except ValueError:
        return datetime.fromtimestamp(path.stat().st_mtime)

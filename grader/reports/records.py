"""The scores that the grader has kept of an assignment, part by part, and the points of the
gradebook.
"""

import json
from collections import Counter
from dataclasses import dataclass

from newton_euler.answers import Cause

from ..assignment.released import released_notebooks
from ..assignment.sheet import tasks
from ..course import CourseError


@dataclass(frozen=True)
class Entry:
    """One student's score of one part."""

    student: str
    problem: str
    key: str
    points: float
    out_of: float
    verdict: str
    message: str = ""
    diagnosis: str | None = None
    causes: tuple[Cause, ...] = ()


def entries(course, assignment):
    """The :class:`Entry` of every part of every graded submission, by student."""
    found = []
    for path in sorted((course.path / "scores" / assignment).glob("*.json")):
        try:
            record = json.loads(path.read_text(encoding="utf-8"))
            found += [
                Entry(path.stem, score["problem"], **_known(part))
                for score in record["scores"]
                for part in score["parts"]
            ]
        except (OSError, ValueError, LookupError, TypeError) as error:
            raise CourseError(
                f"{path} is damaged ({error}); grade again with: python -m grader grade "
                f"{assignment} --course {course.path} --student {path.stem} --force"
            ) from error
    if not found:
        raise CourseError(
            f"nothing of {assignment} has been graded yet; grade first with: python -m grader "
            f"grade {assignment} --course {course.path}"
        )
    return found


BY_HAND = "by hand"  # in place of the name of a part: what a person gave or took


def questions(course, assignment, parts):
    """The :class:`Entry` of what the gradebook has besides ``parts`` (:func:`entries`): the graded
    cells of the instructor's own, and for a problem of ours what a person gave or took, so that the
    points of a student's entries sum up to those of the gradebook before the penalty for lateness.
    """
    numbers = {
        task.grade_id: number
        for notebook in released_notebooks(course, assignment).values()
        for number, task in tasks(notebook).items()
    }
    automatic = Counter()
    for e in parts:
        automatic[e.student, e.problem] += e.points
    with course.gradebook() as book:
        for submission in book.assignment_submissions(assignment):
            for grade in [g for n in submission.notebooks for g in n.grades]:
                student, points = submission.student_id, grade.score or 0.0
                if number := numbers.get(grade.name):
                    change = points - automatic[student, number]
                    if abs(change) > 1e-6:
                        yield Entry(student, number, BY_HAND, change, 0.0, "")
                elif grade.max_score:
                    waits = "waits for a person" if grade.needs_manual_grade else ""
                    yield Entry(student, grade.name, "", points, grade.max_score, "", waits)


def _known(part):
    known = {k: v for k, v in part.items() if k in Entry.__dataclass_fields__}
    return known | {"causes": tuple(Cause(*c) for c in part.get("causes", ()))}


@dataclass(frozen=True)
class Line:
    """A student of the roster, with the points of the gradebook: None if nothing was handed in."""

    id: str
    first_name: str
    last_name: str
    email: str
    lms_user_id: str
    points: float | None = None
    waiting: bool = False


def lines(course, assignment):
    """(:class:`Line` of every student by last name, maximum of points): points with what a person
    gave, extra credit, and without the late penalty, as ``nbgrader export`` has them.
    """
    from nbgrader.api import MissingEntry

    with course.gradebook() as book:
        try:
            maximum = book.find_assignment(assignment).max_score
        except MissingEntry:
            raise CourseError(
                f"the gradebook does not know {assignment}; generate it first: nbgrader "
                f"generate_assignment {assignment}"
            ) from None
        submissions = {s.student_id: s for s in book.assignment_submissions(assignment)}
        found = []
        for s in book.students:
            submission = submissions.get(s.id)
            points, waiting = None, False
            if submission is not None:
                points = max(0.0, submission.score - (submission.late_submission_penalty or 0))
                waiting = bool(submission.needs_manual_grade)
            names = (s.first_name, s.last_name, s.email, s.lms_user_id)
            found.append(Line(s.id, *(x or "" for x in names), points, waiting))
    return sorted(found, key=lambda x: (x.last_name.casefold(), x.id)), maximum

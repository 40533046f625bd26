"""The scores of an assignment, part by part, and the points of the gradebook."""

import json
from collections import defaultdict
from collections.abc import Iterable, Iterator
from dataclasses import dataclass

from newton_euler.answers import Cause

from ..assignment.released import released
from ..course import Course, CourseError
from ..grading.gradebook import in_gradebook


@dataclass(frozen=True)
class PartScore:
    """One student's score of one part; ``key`` is "" for a question of the instructor's own.
    ``waits``: it is to be graded by hand, and has no points yet.
    """

    student: str
    problem: str
    key: str
    points: float
    out_of: float
    verdict: str
    message: str = ""
    diagnosis: str | None = None
    causes: tuple[Cause, ...] = ()
    waits: bool = False


OF_A_PART = PartScore.__dataclass_fields__.keys() - {"student", "problem"}


def part_scores(course: Course, assignment: str) -> list[PartScore]:
    """The :class:`PartScore` of every part of every graded submission, by student."""
    found = []
    for path in sorted((course.path / "scores" / assignment).glob("*.json")):
        try:
            record = json.loads(path.read_text(encoding="utf-8"))
            found += [
                PartScore(path.stem, score["problem"], **_known(part))
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


def _known(part):
    causes = tuple(Cause(*cause) for cause in part.get("causes", ()))
    return {k: part[k] for k in part.keys() & OF_A_PART} | {"causes": causes}


BY_HAND = "by hand"  # the key of an entry for manual changes of points


def questions(course: Course, assignment: str, parts: Iterable[PartScore]) -> Iterator[PartScore]:
    """Entries for graded cells of the instructor's own, and for manual changes of points. With
    ``parts``, a student's entries sum to the gradebook's points before penalties.
    """
    notebooks = released(course, assignment)
    numbers = {  # grade ids are unique only within a notebook
        (name, task.grade_id): number
        for name, notebook in notebooks.items()
        for number, task in notebook.tasks.items()
    }
    automatic: defaultdict[tuple[str, str], float] = defaultdict(float)
    for e in parts:
        automatic[e.student, e.problem] += e.points
    with course.gradebook() as book:
        for submission in book.assignment_submissions(assignment):
            for name, grade in [(n.name, g) for n in submission.notebooks for g in n.grades]:
                student, points = submission.student_id, grade.score or 0.0
                if number := numbers.get((name, grade.name)):
                    change = points - automatic[student, number]
                    if abs(change) > 1e-6:
                        yield PartScore(student, number, BY_HAND, change, 0.0, "")
                elif grade.max_score:
                    question = f"{name}: {grade.name}" if len(notebooks) > 1 else grade.name
                    words = "waits for a person" if grade.needs_manual_grade else ""
                    waits = bool(words) and grade.manual_score is None
                    most = grade.max_score
                    yield PartScore(student, question, "", points, most, "", words, waits=waits)


@dataclass(frozen=True)
class StudentRow:
    """A student on the roster, with the points of the gradebook, None if nothing was handed in."""

    id: str
    first_name: str
    last_name: str
    email: str
    lms_user_id: str
    points: float | None = None
    waiting: bool = False
    penalty: float = 0.0


def student_rows(
    course: Course, assignment: str, penalties: bool = True
) -> tuple[list[StudentRow], float]:
    """(rows of all students by last name, maximum points): points with manual grades and extra
    credit, minus the penalty for lateness, as in ``nbgrader export``.

    penalties : False to ignore that penalty
    """
    with course.gradebook() as book:
        maximum = in_gradebook(book, assignment).max_score
        submissions = {s.student_id: s for s in book.assignment_submissions(assignment)}
        found = []
        for s in book.students:
            submission = submissions.get(s.id)
            points, waiting, penalty = None, False, 0.0
            if submission is not None:
                penalty = submission.late_submission_penalty or 0.0
                points = max(0.0, submission.score - penalties * penalty)
                waiting = bool(submission.needs_manual_grade)
            first, last, email, lms = (
                x or "" for x in (s.first_name, s.last_name, s.email, s.lms_user_id)
            )
            found.append(StudentRow(s.id, first, last, email, lms, points, waiting, penalty))
    return sorted(found, key=lambda x: (x.last_name.casefold(), x.id)), maximum

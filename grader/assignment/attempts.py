"""Another attempt at an assignment, with fresh numbers. The files of the earlier one move to
COURSE/attempts/ASSIGNMENT/STUDENT/N and can be put back; its grade stands until the new sheet is
graded.
"""

import contextlib
import shutil
from pathlib import Path

from ..course import Course, CourseError, check_id, load_json, write_json
from ..course.by_hand import give_student, of_student
from ..course.exam import refuse_exam
from .numbers import keep_numbers, numbers_path
from .personal import make_personal_copies
from .released import problems_on_sheet

BY_HAND = "by_hand.json"  # manual grades of an attempt


def parts(course: Course, assignment: str, student: str) -> dict[str, Path]:
    """{name in the folder of an attempt: path while it is the current one}."""
    return {
        "submitted": course.path / "submitted" / student / assignment,
        "autograded": course.path / "autograded" / student / assignment,
        "feedback": course.path / "feedback" / student / assignment,
        "personal": course.personal_path(assignment, student).parent,
        "numbers.json": numbers_path(course, assignment, student),
        "record.json": course.record_path(assignment, student),
    }


def attempts_folder(course: Course, assignment: str, student: str) -> Path:
    """The folder of a student's earlier attempts."""
    return course.path / "attempts" / assignment / check_id(student)


def earlier_attempts(course: Course, assignment: str, student: str) -> dict[int, Path]:
    """{number: folder} of the attempts that have been set aside."""
    found = attempts_folder(course, assignment, student).glob("*")
    return dict(sorted((int(f.name), f) for f in found if f.name.isdigit()))


def new_attempt(course: Course, assignment: str, student: str) -> tuple[int, Path]:
    """Set the current attempt aside and make a sheet with fresh numbers; returns (number, path)."""
    course.require_students([student])
    refuse_exam(
        course, assignment, "there is one attempt; build another exam for those who sit it again"
    )
    now = parts(course, assignment, student)
    if not now["submitted"].is_dir():
        raise CourseError(
            f"{student} has not handed in {assignment}, so there is nothing to try again"
        )
    done = max(earlier_attempts(course, assignment, student), default=0) + 1
    _set_aside(course, assignment, student, done)
    problems = problems_on_sheet(course, assignment)
    drawn = course.values(f"{assignment}, attempt {done + 1}", student, problems)
    keep_numbers(course, assignment, student, problems, drawn)
    paths = make_personal_copies(course, assignment, [student], workers=1)
    return done + 1, paths[student]


def put_back(course: Course, assignment: str, student: str, number: int) -> None:
    """Make an earlier attempt the current one; that one, if any, is set aside."""
    earlier = earlier_attempts(course, assignment, student)
    if number not in earlier:
        raise CourseError(
            f"{student} has no attempt {number} at {assignment} that was set aside; there are "
            f"{', '.join(map(str, earlier)) or 'none'}"
        )
    now = parts(course, assignment, student)
    if now["submitted"].is_dir():
        _set_aside(course, assignment, student, max(earlier) + 1)
    for name, path in now.items():
        if path.is_dir():  # a sheet not handed in
            shutil.rmtree(path)
        else:
            path.unlink(missing_ok=True)
        if (earlier[number] / name).exists():
            path.parent.mkdir(parents=True, exist_ok=True, mode=0o700)
            (earlier[number] / name).rename(path)
    by_hand = earlier[number] / BY_HAND
    if by_hand.exists():
        with course.gradebook() as book:
            give_student(book, assignment, student, load_json(by_hand.read_bytes()))
    shutil.rmtree(earlier[number])


def is_work_of_earlier(
    course: Course, assignment: str, student: str, name: str, content: bytes
) -> int | None:
    """The number of the earlier attempt with the same notebook, or None. nbgrader collects the last
    submission, even one made before the new sheet was handed out.
    """
    for number, folder in earlier_attempts(course, assignment, student).items():
        path = folder / "submitted" / f"{name}.ipynb"
        if path.is_file() and not path.is_symlink() and path.read_bytes() == content:
            return number
    return None


def _set_aside(course: Course, assignment: str, student: str, number: int) -> None:
    folder = attempts_folder(course, assignment, student) / str(number)
    folder.mkdir(parents=True, exist_ok=True, mode=0o700)
    with course.gradebook() as book, contextlib.suppress(ValueError):  # not graded yet
        write_json(folder / BY_HAND, of_student(book, assignment, student))
    for name, path in parts(course, assignment, student).items():
        if path.exists():
            path.rename(folder / name)

"""Another attempt at an assignment, with fresh numbers, where the instructor allows it.

What belongs to the earlier attempt moves to COURSE/attempts/ASSIGNMENT/STUDENT/N and can be put
back. The gradebook keeps its grade until the new sheet is handed in and graded; then that one
counts.
"""

import shutil

from ..course import CourseError, check_id
from .numbers import keep_numbers, numbers_path
from .personal import make_personal_copies
from .released import released_notebooks
from .sheet import problems_of


def parts(course, assignment, student):
    """{name in the folder of an attempt: where it is while the attempt counts}."""
    return {
        "submitted": course.path / "submitted" / student / assignment,
        "autograded": course.path / "autograded" / student / assignment,
        "feedback": course.path / "feedback" / student / assignment,
        "personal": course.personal_path(assignment, student).parent,
        "numbers.json": numbers_path(course, assignment, student),
        "record.json": course.record_path(assignment, student),
    }


def attempts_folder(course, assignment, student):
    """Where a student's earlier attempts are."""
    return course.path / "attempts" / assignment / check_id(student)


def earlier_attempts(course, assignment, student):
    """The folders of the attempts that do not count any more, by their numbers."""
    folder = attempts_folder(course, assignment, student)
    found = [f for f in folder.glob("*") if f.name.isdigit()] if folder.is_dir() else []
    return dict(sorted((int(f.name), f) for f in found))


def new_attempt(course, assignment, student):
    """Set a student's attempt aside and make a sheet with fresh numbers; returns (number of the new
    attempt, path of its notebook).
    """
    if student not in course.roster():
        raise CourseError(f"{student} is not on the roster")
    now = parts(course, assignment, student)
    if not now["submitted"].is_dir():
        raise CourseError(
            f"{student} has not handed in {assignment}, so that there is nothing to try again"
        )
    done = max(earlier_attempts(course, assignment, student), default=0) + 1
    _move(now, attempts_folder(course, assignment, student) / str(done))
    problems = {
        p.id: p for n in released_notebooks(course, assignment).values() for p in problems_of(n)
    }
    drawn = course.values(f"{assignment}, attempt {done + 1}", student, list(problems.values()))
    keep_numbers(course, assignment, student, list(problems.values()), drawn)
    paths = make_personal_copies(course, assignment, [student], workers=1)
    return done + 1, paths[student]


def put_back(course, assignment, student, number):
    """Let an earlier attempt count again; the present one, if there is any, is set aside."""
    earlier = earlier_attempts(course, assignment, student)
    if number not in earlier:
        raise CourseError(
            f"{student} has no attempt {number} at {assignment} that was set aside; there are "
            f"{', '.join(map(str, earlier)) or 'none'}"
        )
    now = parts(course, assignment, student)
    if now["submitted"].is_dir():
        _move(now, attempts_folder(course, assignment, student) / str(max(earlier) + 1))
    for path in now.values():  # a sheet that nobody handed in
        _remove(path)
    for name, path in now.items():
        _move({name: earlier[number] / name}, path.parent, {name: path.name})
    shutil.rmtree(earlier[number])


def is_work_of_earlier(course, assignment, student, name, content):
    """The number of the earlier attempt that has the same notebook, else None: nbgrader collects
    the last one that was handed in, also if that was before the new sheet.
    """
    for number, folder in earlier_attempts(course, assignment, student).items():
        path = folder / "submitted" / f"{name}.ipynb"
        if path.is_file() and not path.is_symlink() and path.read_bytes() == content:
            return number
    return None


def _move(places, target, names=None):
    target.mkdir(parents=True, exist_ok=True, mode=0o700)
    for name, path in places.items():
        if path.exists():
            path.rename(target / (names or {}).get(name, name))


def _remove(path):
    if path.is_dir():
        shutil.rmtree(path)
    else:
        path.unlink(missing_ok=True)

"""Each student's own copy of an assignment, and its place in nbgrader's exchange."""

import os
import shutil
import subprocess
from collections.abc import Callable, Iterable, Mapping
from pathlib import Path

from exercises.catalogue import problem

from ..course import Course, CourseError, check_id, write_json
from ..course.exam import refuse_before_opening, refuse_exam
from ..course.processes import process_pool
from .cells import hashable
from .figures import figure_png
from .notebook import personal_notebook
from .released import personal_path, released, sheet_numbers
from .seals import with_seals


def make_personal_copies(
    course: Course,
    assignment: str,
    students: Iterable[str] | None = None,
    progress: Callable[[float], object] = lambda share: None,
    workers: int | None = None,
    right_or_wrong: bool = False,
) -> dict[str, Path]:
    """Write the personal copies of an assignment for ``students`` (default: the roster), for all
    its notebooks with problems; returns {student: path}. Figures are drawn for each student's
    numbers, by ``workers`` processes.

    right_or_wrong : let receipts say whether an answer is right where the sheet has no help level,
        see :mod:`newton_euler.answers.seals`
    """
    if right_or_wrong:
        refuse_exam(course, assignment, "its receipts never say whether an answer is right")
    students = list(students) if students is not None else course.roster()
    course.require_students(students)
    if not students:
        raise CourseError(
            "nobody is on the roster; add students with: python -m grader enrol roster.csv"
        )
    notebooks = {n: r for n, r in released(course, assignment).items() if r.tasks}
    asked = sorted({number for r in notebooks.values() for number in r.tasks})
    values = {s: sheet_numbers(course, assignment, check_id(s)) for s in students}
    drawn = {(i, hashable(values[s][i])): None for s in students for i in asked}
    with process_pool(workers) as pool:
        for figure, png in zip(drawn, pool.map(_draw, drawn, chunksize=8), strict=True):
            drawn[figure] = png
            progress(1 / len(drawn))
    paths = {}
    for s in students:
        figures = {i: drawn[i, hashable(values[s][i])] for i in asked}
        paths[s] = course.personal_path(assignment, s)
        for name, original in notebooks.items():
            path = personal_path(course, assignment, s, name)
            notebook = personal_notebook(original.notebook, s, values[s], figures)
            write_json(path, with_seals(notebook, values[s], right_or_wrong))
    return paths


def _draw(figure):
    problem_id, values = figure
    return figure_png(problem(problem_id), dict(values))


# -- the exchange


def exchange_outbound(course: Course, assignment: str) -> Path:
    """The folder of a released assignment in the exchange of the course's configuration."""
    from nbgrader.exchange.default import Exchange

    refuse_before_opening(course, assignment)
    outbound = Path(Exchange(config=course.config()).root) / course.name / "outbound" / assignment
    if not outbound.is_dir():
        raise CourseError(
            f"{outbound} does not exist; release first: nbgrader release_assignment {assignment}"
        )
    return outbound


def copy_to_exchange(
    course: Course, assignment: str, outbound: str | Path, paths: Mapping[str, Path]
) -> list[str]:
    """Copy personal notebooks ({student: path}) next to ``outbound``, the released assignment in
    the exchange: not into it, so that a plain fetch gets no student's numbers. Returns the students
    whose copies others can read, as access cannot be limited to one user.
    """
    from .fetch import FOLDER, personal_name

    open_to_others = []
    folder = Path(outbound).parent / FOLDER / assignment
    folder.mkdir(parents=True, exist_ok=True)
    for student, path in paths.items():
        target = folder / personal_name(course.name, assignment, student)
        shutil.rmtree(target, ignore_errors=True)
        target.mkdir()
        for notebook in path.parent.glob("*.ipynb"):
            shutil.copy(notebook, target / notebook.name)
            os.chmod(target / notebook.name, 0o644)
        os.chmod(target, 0o755)
        if not _restrict_to_user(student, target):
            open_to_others.append(student)
    for place in (folder, folder.parent):
        os.chmod(place, 0o711)  # may be entered by name, but not listed
    return open_to_others


def warning(students: list[str]) -> str:
    """A warning about the copies that :func:`copy_to_exchange` left open to others, or ""."""
    if not students:
        return ""
    return (
        f"Others on this machine who know a student's login can read the sheets of {len(students)} "
        f"students ({', '.join(students[:3])}{', …' if len(students) > 3 else ''}). A sheet is its "
        "owner's alone where the login is a user of this machine, and you are root or setfacl is "
        "installed (apt install acl); else hand out COURSE/personal yourself, or by an LMS."
    )


def _restrict_to_user(student, target):
    """Make the copy readable by the student alone, if they are a user of this machine: root
    transfers ownership; others use an access list, if ``setfacl`` is installed. Returns whether it
    was done.
    """
    try:
        import pwd

        user = pwd.getpwnam(student)
    except (ImportError, KeyError):
        return False
    paths = [target, *target.iterdir()]
    if os.geteuid() == 0:
        for path in paths:
            os.chown(path, user.pw_uid, user.pw_gid)
            os.chmod(path, 0o700 if path.is_dir() else 0o600)
        return True
    if tool := shutil.which("setfacl"):
        who = f"user:{user.pw_uid}:rX,group::---,other::---"
        # fails on file systems without access lists
        command = [tool, "--modify", who, *paths]
        return subprocess.run(command, capture_output=True, check=False).returncode == 0
    return False

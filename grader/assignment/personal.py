"""Each student's own copy of an assignment, and its place in nbgrader's exchange."""

import os
import shutil
from concurrent.futures import ProcessPoolExecutor
from pathlib import Path

from exercises.catalogue import problem

from ..course import CourseError, check_id, read_json, write_json
from .figures import figure_png
from .notebook import personal_notebook, problems_of


def make_personal_copies(course, assignment, students=None, progress=None, workers=None):
    """Write the personal copies of an assignment for ``students`` (default: the roster); returns
    {student: path}.

    Figures depend on the numbers, so they are drawn for each student, on ``workers`` processes
    (default: one per processor).
    """
    students = list(students) if students is not None else course.roster()
    if unknown := sorted(set(students) - set(course.roster())):
        raise CourseError(
            f"{', '.join(unknown)}: not on the roster; add the student first: nbgrader db "
            f"student add {unknown[0]}"
        )
    if not students:
        raise CourseError(
            "nobody is on the roster; add students with: nbgrader db student add ID, or build "
            "--students roster.csv"
        )
    released = course.released(assignment)
    problems = problems_of(released)
    values = {s: course.values(assignment, s, problems) for s in students}
    drawn = {(p.id, _hashable(values[s][p.id])): None for s in students for p in problems}
    with ProcessPoolExecutor(workers or os.cpu_count()) as pool:
        for figure, png in zip(drawn, pool.map(_draw, drawn, chunksize=8), strict=True):
            drawn[figure] = png
            if progress:
                progress(1 / len(drawn))
    paths = {}
    for s in map(check_id, students):
        figures = {p.id: drawn[p.id, _hashable(values[s][p.id])] for p in problems}
        paths[s] = course.personal_path(assignment, s)
        write_json(paths[s], personal_notebook(released, s, values[s], figures))
    return paths


def _hashable(values):
    return tuple(sorted(values.items()))


def _draw(figure):
    problem_id, values = figure
    return figure_png(problem(problem_id), dict(values))


def master_notebook(course, assignment, student):
    """The trusted notebook of a student: the personal copy if there is one, otherwise one made now,
    without figures.
    """
    path = course.personal_path(assignment, student)
    released = course.released(assignment)
    if path.exists():
        own = read_json(path)
        if [c["id"] for c in own["cells"]] == [c["id"] for c in released["cells"]]:
            return own
    return personal_notebook(
        released, student, course.values(assignment, student, problems_of(released)), {}
    )


def master_bytes(course, assignment, student):
    """The bytes of the file that :func:`master_notebook` reads, to detect changes."""
    path = course.personal_path(assignment, student)
    return (path if path.exists() else course.released_path(assignment)).read_bytes()


# -- the exchange


def exchange_outbound(course, assignment):
    """The folder of a released assignment in the exchange that the course's nbgrader_config.py
    names.
    """
    from nbgrader.exchange.default import Exchange

    outbound = Path(Exchange(config=course.config()).root) / course.name / "outbound" / assignment
    if not outbound.is_dir():
        raise CourseError(
            f"{outbound} does not exist; release first: nbgrader release_assignment {assignment}"
        )
    return outbound


def copy_to_exchange(course, assignment, outbound, paths):
    """Copy personal notebooks ({student: path}) beside ``outbound``, the exchange's folder of the
    released assignment.

    Beside and not in it, so that a fetch without the course's configuration gets the released
    notebook and nobody's numbers.
    """
    from .fetch import FOLDER, personal_name

    folder = Path(outbound).parent / FOLDER / assignment
    folder.mkdir(parents=True, exist_ok=True)
    for student, path in paths.items():
        target = folder / personal_name(course.name, assignment, student)
        shutil.rmtree(target, ignore_errors=True)
        target.mkdir()
        shutil.copy(path, target / path.name)
        os.chmod(target / path.name, 0o644)
        os.chmod(target, 0o755)
        _restrict_to_user(student, target)
    for place in (folder, folder.parent):
        os.chmod(place, 0o711)  # can be entered by those who know a name, not listed


def _restrict_to_user(student, target):
    """Make the copy readable by the student only, if this process may (root, as on most hubs) and
    the student is a user of the machine.
    """
    if os.geteuid() != 0:
        return
    try:
        import pwd

        user = pwd.getpwnam(student)
    except (ImportError, KeyError):
        return
    for path in (target, *target.iterdir()):
        os.chown(path, user.pw_uid, user.pw_gid)
        os.chmod(path, 0o700 if path.is_dir() else 0o600)

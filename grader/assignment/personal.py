"""Everyone's own copy of an assignment, and its way into the exchange."""

import os
import shutil
from concurrent.futures import ProcessPoolExecutor
from pathlib import Path

from nbgrader.exchange.default import ExchangeReleaseAssignment

from exercises.catalogue import problem

from ..course import Course, CourseError, check_id, write_json
from . import notebook as nb
from .fetch import FOLDER, personal_name
from .figures import png


def make_personal(course, assignment, students=None, progress=None, workers=None):
    """Write the personal copies of an assignment for ``students`` (default: the roster); returns {student: path}.

    Figures depend on the numbers, so they are drawn for each student, on ``workers`` processes (default: one per processor).
    """
    students = list(students) if students is not None else course.roster()
    if strangers := sorted(set(students) - set(course.roster())):
        raise CourseError(f"{', '.join(strangers)}: not on the roster; add the student first: nbgrader db student add {strangers[0]}")
    if not students:
        raise CourseError("nobody is on the roster; add students with: nbgrader db student add ID, or build --students roster.csv")
    released = course.released(assignment)
    problems = nb.problems_of(released)
    values = {s: course.values(assignment, s, problems) for s in students}
    wanted = {(p.id, _key(values[s][p.id])): None for s in students for p in problems}
    with ProcessPoolExecutor(workers or os.cpu_count()) as pool:
        for name, picture in zip(wanted, pool.map(_draw, wanted, chunksize=8), strict=True):
            wanted[name] = picture
            if progress:
                progress(1 / len(wanted))
    paths = {}
    for s in map(check_id, students):
        figures = {p.id: wanted[p.id, _key(values[s][p.id])] for p in problems}
        paths[s] = course.personal_path(assignment, s)
        write_json(paths[s], nb.personal(released, s, values[s], figures))
    return paths


def _key(values):
    return tuple(sorted(values.items()))


def _draw(name):
    problem_id, values = name
    return png(problem(problem_id), dict(values))


def into_exchange(course, assignment, outbound, paths):
    """Put personal copies beside ``outbound`` (the exchange's folder of the released assignment), readable by name only.

    Beside and not in it, so that a fetch without the course's configuration gets the master copy and nobody's numbers.
    """
    folder = Path(outbound).parent / FOLDER / assignment
    folder.mkdir(parents=True, exist_ok=True)
    for student, path in paths.items():
        target = folder / personal_name(course.name, assignment, student)
        shutil.rmtree(target, ignore_errors=True)
        target.mkdir()
        shutil.copy(path, target / path.name)
        os.chmod(target / path.name, 0o644)
        os.chmod(target, 0o755)
        _give_to(student, target)
    for place in (folder, folder.parent):
        os.chmod(place, 0o711)  # can be entered by who knows a name, not listed


def _give_to(student, target):
    """Where the instructor may (root, as on most hubs) and the student is a user of the machine, only that user can read the copy."""
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


class ReleaseWithPersonal(ExchangeReleaseAssignment):
    """nbgrader's release, followed by everyone's own copy."""

    def copy_files(self):
        super().copy_files()
        course, assignment = Course(self.coursedir.root), self.coursedir.assignment_id
        students = course.roster()
        if not students:
            self.log.warning(
                "Nobody is on the roster: no personal copies. Add students, then: python -m grader personal %s --course . --exchange", assignment
            )
            return
        paths = make_personal(course, assignment, students)
        into_exchange(course, assignment, self.dest_path, paths)
        self.log.info("Made %d personal copies", len(paths))

"""The notebooks that nbgrader generated for release, and the student's copies of them that grading
trusts.
"""

import hashlib
import json
from functools import lru_cache

from ..course import CourseError, load_json, read_json
from .notebook import personal_notebook
from .numbers import kept_numbers
from .sheet import problems_of, tasks


def released_notebooks(course, assignment):
    """{name: notebook} of an assignment as it was generated for release; raises
    :class:`CourseError` if there is none. The result must not be modified.
    """
    folder = course.released_path(assignment).parent
    found = {f.stem: _read_once(f, f.stat().st_mtime_ns) for f in sorted(folder.glob("*.ipynb"))}
    if not found:
        course.released(assignment)  # raises, with what to do
    return found


@lru_cache(maxsize=16)
def _read_once(path, changed):
    """:func:`read_json` with a cache, since a run reads the same notebooks for every student."""
    return read_json(path)


def released_tasks(course, assignment):
    """{name: :func:`~grader.assignment.sheet.tasks`} of the notebooks of an assignment; not to be
    modified.
    """
    folder = course.released_path(assignment).parent
    names = released_notebooks(course, assignment)
    return {n: _tasks_once(f, f.stat().st_mtime_ns) for n in names for f in [folder / f"{n}.ipynb"]}


@lru_cache(maxsize=16)
def _tasks_once(path, changed):
    return tasks(_read_once(path, changed))


# marks of a cell that change what its work is worth, and not what it is
WORTH = ("points", "weights", "follow_through", "checksum")


def released_hashes(course, assignment, name):
    """(hash of a released notebook, hash of what of it the outcome of a run depends on: all but
    points, weights and figures).
    """
    path = course.released_path(assignment).with_name(f"{name}.ipynb")
    return _hashes(path, path.stat().st_mtime_ns)


@lru_cache(maxsize=16)
def _hashes(path, changed):
    cells = [
        {
            **cell,
            "attachments": None,
            "metadata": {
                key: {k: v for k, v in marks.items() if k not in WORTH}
                for key, marks in cell["metadata"].items()
                if isinstance(marks, dict)
            },
        }
        for cell in _read_once(path, changed)["cells"]
    ]
    ran = json.dumps(cells, sort_keys=True).encode()
    return tuple(hashlib.sha256(x).hexdigest()[:20] for x in (path.read_bytes(), ran))


def personal_path(course, assignment, student, name):
    """The path of a student's own copy of one notebook of an assignment."""
    return course.personal_path(assignment, student).with_name(f"{name}.ipynb")


def sheet_numbers(course, assignment, student):
    """A student's numbers for all problems of an assignment: {problem id: {name: number}}."""
    return kept_numbers(course, assignment, student, _all_problems(course, assignment))


def _all_problems(course, assignment):
    asked = released_tasks(course, assignment).values()
    return [task.exercise for task in {i: t for own in asked for i, t in own.items()}.values()]


def master_notebook(course, assignment, student, name=None, values=None):
    """The trusted notebook of a student: the released one as it is now, with the texts, numbers and
    figures of the copy that was handed out where it has the cell.

    name : of the notebook; default: that of the assignment. values : the student's numbers, where
        they are known; default: they are read
    """
    name = name or assignment
    released = released_notebooks(course, assignment).get(name)
    if released is None:
        raise CourseError(f"{assignment} has no notebook {name}.ipynb")
    if not problems_of(released):
        return released
    values = values or sheet_numbers(course, assignment, student)
    master = personal_notebook(released, student, values, {})
    path = personal_path(course, assignment, student, name)
    if path.exists():
        theirs = {c.get("id"): c for c in load_json(path.read_bytes())["cells"]}
        master["cells"] = [_as_handed_out(c, theirs.get(c.get("id"))) for c in master["cells"]]
    return master


def _as_handed_out(cell, copy):
    """A cell of the master, with the figure of the student's copy."""
    if copy and "attachments" in cell and "attachments" in copy:
        return {**cell, "attachments": copy["attachments"]}
    return cell

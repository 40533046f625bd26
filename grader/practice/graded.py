"""The numbers that a course grades, which nobody practises on."""

import json

from exercises.catalogue import CatalogueError, problem

from ..assignment.sheet import tasks
from ..course import Course, read_json


def graded_numbers(path, done=None):
    """{problem id: [{name: number} of each student's sheet]} of all assignments of the course in a
    folder: what is kept, and what is drawn for those on the roster who fetched nothing yet.

    done : called with the number of sheets read, and of all
    """
    course = Course(path)
    asked = {
        folder.name: [_known(name) for source in sorted(folder.glob("*.ipynb"))
                      for name in tasks(read_json(source))]
        for folder in sorted((course.path / "source").iterdir()) if folder.is_dir()
    }  # fmt: skip
    found = {p.id: [] for problems in asked.values() for p in problems if p}
    sheets = [(assignment, student) for assignment in asked for student in course.roster()]
    for n, (assignment, student) in enumerate(sheets, 1):
        problems = [p for p in asked[assignment] if p]
        for name, values in course.values(assignment, student, problems).items():
            found[name].append(values)
        if done:
            done(n, len(sheets))
    for file in sorted((course.path / "numbers").glob("*/*.json")):
        for name, kept in json.loads(file.read_text(encoding="utf-8")).items():
            found.setdefault(name, []).append({n: x for n, (x, _) in kept.items()})
    return found


def _known(name):
    """A problem, None where the catalogue has it no longer."""
    try:
        return problem(name)
    except CatalogueError:
        return None

"""What a notebook asks for, read from its cells: they are the assignment, whatever it was built
from. Problems with their points, and the cells that an instructor wrote.
"""

from dataclasses import dataclass
from functools import cached_property

from exercises.catalogue import CatalogueError
from exercises.catalogue import problem as find_problem

from ..course import CourseError


@dataclass(frozen=True)
class Task:
    """A problem on a sheet: its number and what its answer cell is worth.

    weights : {key: weight} where the instructor shares the points otherwise than the exercise
    asked : {key: form} of what is asked for; None on sheets that do not say it
    follow_through : the share that a part earns which is right after a wrong one; None for that of
        the exercise
    The instructor writes "weights" and "follow_through" into the metadata of the answer cell,
    beside what stands there under "newton_euler".
    """

    problem: str
    grade_id: str
    points: float
    weights: dict | None
    asked: dict | None
    follow_through: float | None = None

    @cached_property
    def text(self):
        """All of it as text, for those who compare."""
        return repr(self)

    @property
    def forms(self):
        """:attr:`asked` in the order of the exercise, since nbgrader sorts what it writes; None if
        the sheet does not say it.
        """
        if self.asked is None:
            return None
        known = {a.key: self.asked[a.key] for a in self.exercise.answers if a.key in self.asked}
        return {**known, **self.asked}

    @property
    def exercise(self):
        """The exercise as it is today; raises :class:`CourseError` if there is none."""
        try:
            return find_problem(self.problem)
        except CatalogueError as error:
            raise CourseError(
                f"the sheet asks for problem {self.problem}, which is not among the exercises: "
                f"{error}"
            ) from error


def tasks(notebook):
    """The problems that a notebook asks for, in its order: {problem id: :class:`Task`}.

    A problem is asked for where its answer cell is; its points are those of the cell, 0 if it is
    not graded.
    """
    found = {}
    for cell in notebook["cells"]:
        own = own_metadata(cell)
        if own.get("role") != "answer":
            continue
        marks = nbgrader_metadata(cell)
        task = Task(
            own["problem"],
            str(marks.get("grade_id", "")),
            marks.get("points", 0) if marks.get("grade") else 0,
            own.get("weights"),
            own.get("asked"),
            own.get("follow_through"),
        )
        found.setdefault(task.problem, task)
    return found


def problems_of(notebook):
    """The problems that a notebook asks for, in its order."""
    return [task.exercise for task in tasks(notebook).values()]


def own_metadata(cell):
    """The metadata that this package wrote into a cell, {"role", "problem", …}; {} for others."""
    metadata = cell.get("metadata")
    own = metadata.get("newton_euler") if isinstance(metadata, dict) else None
    return own if isinstance(own, dict) else {}


def nbgrader_metadata(cell):
    """What nbgrader wrote into a cell; {} for other cells, and where it is no dict."""
    metadata = cell.get("metadata")
    marks = metadata.get("nbgrader") if isinstance(metadata, dict) else None
    return marks if isinstance(marks, dict) else {}


def kind(cell):
    """What a trusted cell is to grading.

    Ours are "introduction", "setup", "statement", "givens", "answer" and "receipt"; an instructor's
    "test" (autograder tests), "hand" (an answer that a person grades), "task" (one without a place
    for the answer), "solution" (an answer that tests of other cells grade), "locked", and "plain"
    for all without nbgrader's marks.
    """
    role = own_metadata(cell).get("role")
    if role:
        return role
    marks = nbgrader_metadata(cell)
    if marks.get("task"):
        return "task"
    if marks.get("solution"):
        return "hand" if marks.get("grade") else "solution"
    if marks.get("grade"):
        return "test" if cell["cell_type"] == "code" else "hand"
    return "locked" if marks.get("locked") else "plain"

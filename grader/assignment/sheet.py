"""The problems that a notebook asks for, read from its cells, whatever it was built from."""

import json
from dataclasses import asdict, dataclass
from functools import cached_property

from exercises.catalogue import CatalogueError, Problem
from exercises.catalogue import problem as find_problem

from ..course import CourseError
from .cells import Notebook, nbgrader_metadata, own_metadata


@dataclass(frozen=True)
class Task:
    """A problem on a sheet: its number and what its answer cell is worth.

    weights : {key: weight} where the instructor distributes the points unlike the exercise
    asked : {key: form} of what is asked for; None on sheets of earlier versions, which lack it
    follow_through : the share that a part earns if it follows correctly from a wrong one; None for
        that of the exercise
    The instructor adds "weights" and "follow_through" to the "newton_euler" metadata of the answer
    cell.
    """

    problem: str
    grade_id: str
    points: float
    weights: dict[str, float] | None
    asked: dict[str, str] | None
    follow_through: float | None = None

    @cached_property
    def as_json(self) -> str:
        """All of it as JSON, to detect changes."""
        return json.dumps(asdict(self), sort_keys=True)

    @property
    def forms(self) -> dict[str, str] | None:
        """:attr:`asked` in the order of the exercise, since nbgrader sorts what it writes."""
        if self.asked is None:
            return None
        known = {a.key: self.asked[a.key] for a in self.exercise.answers if a.key in self.asked}
        return {**known, **self.asked}

    @property
    def exercise(self) -> Problem:
        """The exercise as it is today; raises :class:`CourseError` if there is none."""
        try:
            return find_problem(self.problem)
        except CatalogueError as error:
            raise CourseError(
                f"the sheet asks for problem {self.problem}, which is not among the exercises: "
                f"{error}"
            ) from error


def tasks(notebook: Notebook) -> dict[str, Task]:
    """The problems that a notebook asks for, in its order: those with an answer cell. The points
    are those of the cell, 0 if it is not graded.
    """
    found: dict[str, Task] = {}
    for cell in notebook["cells"]:
        own = own_metadata(cell)
        if own.get("role") != "answer":
            continue
        marks = nbgrader_metadata(cell)
        points = marks.get("points", 0) if marks.get("grade") else 0
        as_asked = own.get("weights"), own.get("asked"), own.get("follow_through")
        task = Task(own["problem"], str(marks.get("grade_id", "")), points, *as_asked)
        found.setdefault(task.problem, task)
    return found


def problems_of(notebook: Notebook) -> list[Problem]:
    """The problems that a notebook asks for, in its order."""
    return [task.exercise for task in tasks(notebook).values()]

"""The problems of a notebook, read from its cells."""

import json
from dataclasses import asdict, dataclass, replace
from functools import cached_property, lru_cache

from exercises.catalogue import CatalogueError, Problem
from exercises.catalogue import problem as find_problem

from ..course import CourseError
from .cells import Notebook, nbgrader_metadata, own_metadata
from .options import read_option

LATER = ("tolerance", "help")  # options unknown to sheets of earlier versions


@dataclass(frozen=True)
class Task:
    """A problem on a sheet: its number and the options of its answer cell.

    weights : {key: weight} if the instructor's differ from the exercise's
    asked : {key: form} of the answers; None on sheets of earlier versions
    follow_through : the share that a part earns if it follows from a wrong one; None for the
        exercise's
    tolerance : relative, of its numbers; None for the default (0.005)
    help : the most that a student is shown, one of :data:`~.options.HELP`; None if unspecified

    The instructor may change weights, follow_through, tolerance and help in the "newton_euler"
    metadata of the answer cell.
    """

    problem: str
    grade_id: str
    points: float
    weights: dict[str, float] | None
    asked: dict[str, str] | None
    follow_through: float | None = None
    tolerance: float | None = None
    help: str | None = None

    @cached_property
    def as_json(self) -> str:
        """The task as JSON, to detect changes; options of later versions only if they are set."""
        known = {n: x for n, x in asdict(self).items() if n not in LATER or x is not None}
        return json.dumps(known, sort_keys=True)

    @property
    def forms(self) -> dict[str, str] | None:
        """:attr:`asked` in the order of the exercise: nbgrader sorts metadata."""
        if self.asked is None:
            return None
        known = {a.key: self.asked[a.key] for a in self.exercise.answers if a.key in self.asked}
        return {**known, **self.asked}

    @property
    def exercise(self) -> Problem:
        """Today's exercise, with the tolerance of the sheet; raises :class:`CourseError` if it no
        longer exists.
        """
        try:
            return with_tolerance(find_problem(self.problem), self.tolerance)
        except CatalogueError as error:
            raise CourseError(
                f"the sheet asks for problem {self.problem}, which is not among the exercises: "
                f"{error}"
            ) from error


@lru_cache(maxsize=1000)
def with_tolerance(p: Problem, tolerance: float | None) -> Problem:
    """The problem with this relative tolerance, or its own for None."""
    if tolerance is None:
        return p
    return replace(p, answers=tuple(replace(a, rtol=tolerance) for a in p.answers))


def tasks(notebook: Notebook) -> dict[str, Task]:
    """The problems of a notebook in order: those with an answer cell. Points are those of the cell,
    0 if it is not graded.
    """
    found: dict[str, Task] = {}
    for cell in notebook["cells"]:
        own = own_metadata(cell)
        if own.get("role") != "answer":
            continue
        marks = nbgrader_metadata(cell)
        points = marks.get("points", 0) if marks.get("grade") else 0
        task = Task(
            own["problem"], str(marks.get("grade_id", "")), points, own.get("weights"),
            own.get("asked"), own.get("follow_through"), *(_read(own, n) for n in LATER),
        )  # fmt: skip
        found.setdefault(task.problem, task)
    return found


def _read(own, name):
    """An option in the metadata of an answer cell, or None."""
    if name not in own:
        return None
    try:
        return read_option(name, own[name])
    except ValueError as error:
        raise CourseError(f"the answer cell of {own['problem']}: {name}: {error}") from error


def problems_of(notebook: Notebook) -> list[Problem]:
    """The problems of a notebook, in order."""
    return [task.exercise for task in tasks(notebook).values()]

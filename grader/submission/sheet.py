"""A student's sheet, as known before the submission is read."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property, lru_cache

from ..assignment.attempts import earlier_attempts
from ..assignment.cells import Notebook, SheetValues, Sources, Values
from ..assignment.numbers import numbers_in
from ..assignment.released import ReleasedNotebook, master_notebook, released, sheet_numbers
from ..assignment.sheet import Task
from ..course import Course
from .recognition import Places, places_by_name


@dataclass(frozen=True)
class Sheet:
    """One notebook of a student's assignment, known from the course alone; ``sources`` have the
    hidden tests, which the released notebook has not.
    """

    course: Course
    assignment: str
    student: str
    name: str
    released: ReleasedNotebook
    values: SheetValues
    sources: Sources
    earlier: Mapping[str, Sequence[Values]]  # the numbers of earlier attempts, by problem

    @cached_property
    def master(self) -> Notebook:
        """The trusted notebook with the student's numbers and figures."""
        return master_notebook(self.course, self.assignment, self.student, self.name, self.values)

    @property
    def places(self) -> Places:
        """The places of its cells by their names."""
        return _places(self.released)

    @property
    def tasks(self) -> dict[str, Task]:
        """The problems that it asks for."""
        return self.released.tasks


@lru_cache(maxsize=16)
def _places(notebook):
    return places_by_name(notebook.notebook)


def student_sheet(
    course: Course, assignment: str, student: str, name: str, sources: Sources
) -> Sheet:
    """The :class:`Sheet` of a student."""
    notebook = released(course, assignment)[name]
    values = sheet_numbers(course, assignment, student) if notebook.tasks else {}
    folders = earlier_attempts(course, assignment, student).values()
    problems = [task.exercise for task in notebook.tasks.values()] if folders else []
    earlier = [numbers_in(folder / "numbers.json", problems) for folder in folders]
    by_problem = {i: [sheet[i] for sheet in earlier if i in sheet] for i in notebook.tasks}
    return Sheet(course, assignment, student, name, notebook, values, sources, by_problem)

"""What grading knows of a student's sheet before it looks at the submission."""

from dataclasses import dataclass
from functools import cached_property

from ..assignment.cells import Notebook, SheetValues, Sources
from ..assignment.released import Released, master_notebook, released, sheet_numbers
from ..assignment.sheet import Task
from ..course import Course


@dataclass(frozen=True)
class Sheet:
    """One notebook of a student's assignment, known from the course alone; ``sources`` have the
    hidden tests that the released notebook lacks.
    """

    course: Course
    assignment: str
    student: str
    name: str
    released: Released
    values: SheetValues
    sources: Sources

    @cached_property
    def master(self) -> Notebook:
        """The trusted notebook with the student's numbers and figures."""
        return master_notebook(self.course, self.assignment, self.student, self.name, self.values)

    @property
    def tasks(self) -> dict[str, Task]:
        """The problems that it asks for."""
        return self.released.tasks


def student_sheet(
    course: Course, assignment: str, student: str, name: str, sources: Sources
) -> Sheet:
    """The :class:`Sheet` of a student."""
    notebook = released(course, assignment)[name]
    values = sheet_numbers(course, assignment, student) if notebook.tasks else {}
    return Sheet(course, assignment, student, name, notebook, values, sources)

"""nbgrader's gradebook, written for a whole class in one transaction.

Rows are recomputed from the submissions, so that a changed late policy, due date or timestamp takes
effect, and both routes agree.
"""

from collections import defaultdict
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from datetime import datetime, timedelta
from functools import cached_property
from typing import TYPE_CHECKING, Any

from ..assignment.cells import Sources
from ..course import Course, CourseError
from ..course.due import extensions
from ..submission import NotebookGrade

if TYPE_CHECKING:
    from nbgrader.api import Gradebook

FEW = 100  # up to this many students, only their rows are read, not those of the whole class


@dataclass
class Entry:
    """The entry of one student: graded notebooks by name, time of submission (None: unchanged),
    whether the work is new, so that manual points need a second look, and whether it is another
    attempt, which inherits no manual points.
    """

    student: str
    notebooks: Mapping[str, NotebookGrade]
    timestamp: datetime | None = None
    changed: bool = True
    again: bool = False


@dataclass(kw_only=True)
class Total:
    """A student's points in the gradebook: automatic or manual, with extra credit, minus the
    penalty for lateness; ``waiting``: the number of cells to grade by hand.
    """

    points: float = 0.0
    out_of: float = 0.0
    extra: float = 0.0
    penalty: float = 0.0
    waiting: int = 0


@dataclass
class Cells:
    """The cells of one notebook of an assignment: ids in the gradebook by grade id."""

    id: str
    grades: dict[str, str] = field(default_factory=dict)
    comments: dict[str, str] = field(default_factory=dict)
    most: dict[str, float] = field(default_factory=dict)


def in_gradebook(book: "Gradebook", assignment: str) -> Any:
    """The assignment in the gradebook; raises :class:`CourseError` if it is not there."""
    from nbgrader.api import MissingEntry

    try:
        return book.find_assignment(assignment)
    except MissingEntry:
        raise CourseError(
            f"the gradebook does not know {assignment}; generate it again with: "
            f"nbgrader generate_assignment {assignment} --force"
        ) from None


def instructors_cells(book: "Gradebook", assignment: str) -> dict[str, Sources]:
    """{notebook: {grade id: (text, checksum)}} of an assignment, with the hidden tests."""
    from nbgrader.api import Notebook, SourceCell

    master = in_gradebook(book, assignment)
    found: dict[str, Sources] = {n.name: {} for n in master.notebooks}
    columns = (Notebook.name, SourceCell.name, SourceCell.source, SourceCell.checksum)
    rows = book.db.query(*columns).join(Notebook, Notebook.id == SourceCell.notebook_id)
    for notebook, name, source, checksum in rows.filter(Notebook.assignment_id == master.id):
        found[notebook][name] = source, checksum
    return found


def save(
    course: Course,
    book: "Gradebook",
    assignment: str,
    entries: Iterable[Entry],
    only: str | None = None,
) -> dict[str, Total]:
    """Write the entries, of the notebook ``only`` if given; returns {student: total}."""
    students = [e.student for e in entries]
    saving = _Saving(course, book, book.find_assignment(assignment), only, students)
    totals = {}
    with book.db.no_autoflush:
        for entry in entries:
            totals[entry.student] = saving.write(entry)
        saving.flush()
    book.db.commit()
    return totals


class _Saving:
    """The rows of one assignment in the gradebook, and the changes to them."""

    def __init__(self, course, book, master, only, students):
        from nbgrader import api

        self.api, self.db, self.master, self.late = api, book.db, master, _LatePenalties(course)
        self.extensions = extensions(course, master.name, master.duedate)
        self.cells = {n.name: self._cells(n) for n in master.notebooks if only in (None, n.name)}
        self.inserts, self.updates = defaultdict(list), defaultdict(list)
        sub, nb = api.SubmittedAssignment, api.SubmittedNotebook
        grade, comment = api.Grade, api.Comment
        here = sub.assignment_id == master.id
        if len(students) <= FEW:
            here = here & sub.student_id.in_(students)
        submitted = self.db.query(sub.student_id, sub.id, sub.timestamp, sub.extension)
        self.submissions = {r[0]: r for r in submitted.filter(here)}
        columns = nb.assignment_id, nb.notebook_id, nb.id, nb.late_submission_penalty
        notebooks = self.db.query(*columns).join(sub, sub.id == nb.assignment_id)
        self.notebooks = {r[:2]: r for r in notebooks.filter(here)}

        def of_notebooks(table, *columns):
            """Rows of a table by notebook and cell."""
            rows = self.db.query(table.notebook_id, table.cell_id, table.id, *columns)
            rows = rows.join(nb, nb.id == table.notebook_id).join(sub, sub.id == nb.assignment_id)
            return {r[:2]: r for r in rows.filter(here)}

        given = grade.manual_score, grade.extra_credit, grade.needs_manual_grade
        self.grades = of_notebooks(grade, grade.auto_score, *given)
        self.comments = of_notebooks(comment, comment.auto_comment)

    def _cells(self, notebook):
        cells, graded = Cells(notebook.id), (self.api.GradeCell, self.api.TaskCell)
        for table in graded:
            columns = (table.name, table.id, table.max_score)
            for name, own, most in self.db.query(*columns).filter_by(notebook_id=notebook.id):
                cells.grades[name], cells.most[name] = own, most
        for table in (self.api.SolutionCell, self.api.TaskCell):
            rows = self.db.query(table.name, table.id).filter_by(notebook_id=notebook.id)
            cells.comments.update((name, own) for name, own in rows)
        return cells

    def write(self, entry: Entry) -> Total:
        """Collect the changes for one student; returns the :class:`Total`."""
        known = self.submissions.get(entry.student)
        _, own, timestamp, before = known or (None, self.api.new_uuid(), None, None)
        extension = self.extensions.get(entry.student, before)
        row = {"id": own, "timestamp": entry.timestamp or timestamp, "extension": extension}
        if not known:
            row |= {"assignment_id": self.master.id, "student_id": entry.student}
            self.inserts["SubmittedAssignment"].append(row)
        elif (row["timestamp"], extension) != (timestamp, before):
            self.updates["SubmittedAssignment"].append(row)
        seconds, total = self._seconds_late(row["timestamp"], extension), Total()
        for name, cells in self.cells.items():
            known = self.notebooks.get((own, cells.id))
            _, _, notebook, before = known or (None, None, self.api.new_uuid(), None)
            points, extra = self._write_cells(notebook, cells, entry, name, total)
            penalty = self.late.penalty(entry.student, points + extra, seconds)
            row = {"id": notebook, "late_submission_penalty": penalty}
            if not known:
                row |= {"assignment_id": own, "notebook_id": cells.id}
                self.inserts["SubmittedNotebook"].append(row)
            elif penalty != before:
                self.updates["SubmittedNotebook"].append(row)
            total.points += points + extra - (penalty or 0.0)
            total.extra, total.penalty = total.extra + extra, total.penalty + (penalty or 0.0)
        return total

    def _write_cells(self, notebook, cells, entry, name, total):
        """Collect the changes to one notebook; returns its points and extra points."""
        graded, points, extra_points = entry.notebooks.get(name), 0.0, 0.0
        for grade_id, cell in cells.grades.items():
            # 0 for a missing notebook; None for a cell to grade by hand
            automatic = graded.points.get(grade_id) if graded else 0.0
            known = self.grades.get((notebook, cell))
            _, _, row_id, before, manual, extra, needs = known or (None,) * 7
            if entry.again:
                manual = extra = None
            # manual points for other work need a second look
            waits = automatic is None if manual is None else needs or entry.changed
            row = {"auto_score": automatic, "needs_manual_grade": waits}
            if not known:
                row |= {"cell_id": cell, "notebook_id": notebook}
                self.inserts["Grade"].append({"id": self.api.new_uuid(), **row})
            elif (automatic, waits) != (before, needs) or entry.again:
                row |= {"manual_score": manual, "extra_credit": extra}
                self.updates["Grade"].append({"id": row_id, **row})
            points += (manual if manual is not None else automatic) or 0.0
            extra_points += extra or 0.0
            total.waiting += waits
            total.out_of += cells.most[grade_id]
        for grade_id, cell in cells.comments.items():
            text = graded.comments.get(grade_id) if graded else None
            known = self.comments.get((notebook, cell))
            if not known:
                row = {"cell_id": cell, "notebook_id": notebook, "auto_comment": text}
                self.inserts["Comment"].append({"id": self.api.new_uuid(), **row})
            elif text != known[3] or entry.again:
                row = {"id": known[2], "auto_comment": text}
                self.updates["Comment"].append(
                    row | {"manual_comment": None} if entry.again else row
                )
        return points, extra_points

    def _seconds_late(self, timestamp, extension):
        due = self.master.duedate
        if due is None or timestamp is None:
            return 0.0
        return max(0.0, (timestamp - due - (extension or timedelta())).total_seconds())

    def flush(self) -> None:
        """Send the changes to the database."""
        for table in ("SubmittedAssignment", "SubmittedNotebook", "Grade", "Comment"):
            kind = getattr(self.api, table)
            self.db.bulk_insert_mappings(kind, self.inserts[table])
            self.db.bulk_update_mappings(kind, self.updates[table])
        self.db.expire_all()


class _LatePenalties:
    """The penalties for late submissions, by the plugin in the course's configuration."""

    def __init__(self, course):
        self.course = course

    @cached_property
    def plugin(self):
        """The plugin of nbgrader."""
        from nbgrader.preprocessors import AssignLatePenalties

        step = AssignLatePenalties(config=self.course.config())
        step.init_plugin()
        return step.plugin_inst

    def penalty(self, student: str, score: float, seconds_late: float) -> float | None:
        """The penalty, between 0 and the score; None if the submission was in time."""
        if not seconds_late > 0:
            return None
        penalty = self.plugin.late_submission_penalty(student, score, seconds_late)
        return None if penalty is None else min(max(penalty, 0.0), score)

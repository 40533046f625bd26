"""Reads and writes the scores in nbgrader's gradebook."""

from datetime import datetime
from functools import cached_property

from ..assignment.notebook import answer_id
from ..submission import feedback_comment


def points_by_cell(result):
    """{id of the answer cell: points} of a :class:`~grader.grading.run.Result`, as
    :func:`saved_points` reads them.
    """
    return {answer_id(i): s.points for i, s in result.scores.items()}


def saved_points(book, assignment):
    """The automatic points in the gradebook: {student: {id of the answer cell: points}}.

    They differ from the recorded results after an interrupted run, a restored backup, or a run of
    another grader.
    """
    from nbgrader.api import Assignment, BaseCell, Grade, SubmittedAssignment, SubmittedNotebook

    rows = (
        book.db.query(SubmittedAssignment.student_id, BaseCell.name, Grade.auto_score)
        .select_from(Grade)
        .join(BaseCell, BaseCell.id == Grade.cell_id)
        .join(SubmittedNotebook, SubmittedNotebook.id == Grade.notebook_id)
        .join(SubmittedAssignment, SubmittedAssignment.id == SubmittedNotebook.assignment_id)
        .join(Assignment, Assignment.id == SubmittedAssignment.assignment_id)
        .filter(Assignment.name == assignment)
    )
    found = {}
    for student, cell, points in rows:
        if cell.startswith("answer-"):
            found.setdefault(student, {})[cell] = points
    return found


def save_results(course, assignment, results):
    """Write all results into nbgrader's gradebook in one transaction: all of them or none."""
    from nbgrader.api import SubmittedAssignment, SubmittedNotebook

    if not results:
        return
    late = _LatePenalties(course)
    with course.gradebook() as book:
        master = book.find_assignment(assignment)
        students = {s.id: s for s in book.students}
        existing = {s.student_id: s for s in master.submissions}
        cells = {
            n.name: ({c.name: c for c in n.grade_cells}, {c.name: c for c in n.solution_cells})
            for n in master.notebooks
        }
        with book.db.no_autoflush:
            for result in results:
                entry = existing.get(result.student) or SubmittedAssignment(
                    assignment=master, student=students[result.student]
                )
                entry.timestamp = _timestamp(course, assignment, result.student) or entry.timestamp
                notebooks = {n.name: n for n in entry.notebooks}
                by_cell = {answer_id(i): s for i, s in result.scores.items()}
                for notebook in master.notebooks:
                    own = notebooks.get(notebook.name) or SubmittedNotebook(
                        notebook=notebook, assignment=entry
                    )
                    total = _write_notebook(own, *cells[notebook.name], by_cell)
                    own.late_submission_penalty = late.penalty(
                        result.student, total, entry.total_seconds_late
                    )
                book.db.add(entry)
        book.db.commit()


def _write_notebook(own, grade_cells, solution_cells, by_cell):
    """Write automatic points and comments into a submitted notebook of the gradebook; returns its
    score, with what a person has graded.
    """
    from nbgrader.api import Comment, Grade

    grades, comments, total = (
        {g.cell_id: g for g in own.grades},
        {c.cell_id: c for c in own.comments},
        0,
    )
    for name, cell in grade_cells.items():
        grade = grades.get(cell.id) or Grade(cell_id=cell.id, notebook=own)
        grade.auto_score = by_cell[name].points if name in by_cell else 0
        grade.needs_manual_grade = grade.manual_score is not None
        total += (grade.auto_score if grade.manual_score is None else grade.manual_score) + (
            grade.extra_credit or 0
        )
    for name, cell in solution_cells.items():
        comment = comments.get(cell.id) or Comment(cell_id=cell.id, notebook=own)
        comment.auto_comment = feedback_comment(by_cell[name]) if name in by_cell else None
    return total


class _LatePenalties:
    """The penalties for late submissions, from the plugin that the course's configuration names."""

    def __init__(self, course):
        self.course = course

    @cached_property
    def plugin(self):
        from nbgrader.preprocessors import AssignLatePenalties

        step = AssignLatePenalties(config=self.course.config())
        step.init_plugin()
        return step.plugin_inst

    def penalty(self, student, score, seconds_late):
        """The penalty, between 0 and the score; None if the submission was in time."""
        penalty = (
            self.plugin.late_submission_penalty(student, score, seconds_late)
            if seconds_late > 0
            else None
        )
        return None if penalty is None else min(max(penalty, 0), score)


def _timestamp(course, assignment, student):
    path = course.path / "submitted" / student / assignment / "timestamp.txt"
    if not path.exists():
        return None
    from nbgrader.utils import parse_utc

    try:
        return parse_utc(path.read_text().strip())
    except ValueError:
        return datetime.fromtimestamp(path.stat().st_mtime)

"""Takes one submitted notebook to its points: reads it, puts the student's work into the trusted
notebook, runs it in the sandbox, scores it, annotates the notebook.
"""

from .files import UnreadableError, parse_notebook, read_notebook
from .pipeline import (
    Graded,
    Sheet,
    annotate,
    execute,
    feedback_comment,
    grade_notebook,
    student_sheet,
)
from .rebuild import Work, as_handed_out, rebuild
from .timestamps import read_timestamp

__all__ = [
    "Graded",
    "Sheet",
    "UnreadableError",
    "Work",
    "annotate",
    "as_handed_out",
    "execute",
    "feedback_comment",
    "grade_notebook",
    "parse_notebook",
    "read_notebook",
    "read_timestamp",
    "rebuild",
    "student_sheet",
]

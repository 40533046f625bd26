"""Takes one submitted notebook to its scores: reads the answers, runs them in the sandbox, scores
them, annotates the notebook.
"""

from .pipeline import (
    StudentAssignment,
    annotate,
    feedback_comment,
    run_answers,
    score_answers,
    student_assignment,
)
from .rebuild import SubmittedAnswer, is_untouched, read_answers, rebuild_notebook

__all__ = [
    "StudentAssignment",
    "SubmittedAnswer",
    "annotate",
    "feedback_comment",
    "is_untouched",
    "read_answers",
    "rebuild_notebook",
    "run_answers",
    "score_answers",
    "student_assignment",
]

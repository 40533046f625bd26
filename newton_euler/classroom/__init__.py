"""Answers, receipts and widgets of a student's notebook."""

from .answers import expect, receipt
from .forms import AnswerError, Form
from .givens import given
from .practising import Practice, PracticeFileError, PracticeProblem, practice
from .reading.formula_trees import TreeError
from .widgets import error_message, interactive_figure

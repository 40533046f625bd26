"""Answers, receipts and widgets of a student's notebook."""

from .answers import expect, receipt
from .forms import AnswerError, Form
from .formula_trees import TreeError
from .givens import given
from .widgets import error_message, interactive_figure

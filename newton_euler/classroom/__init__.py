"""Answers, receipts and widgets of a student's notebook."""

from .answers import expect, receipt
from .forms import AnswerError, Form
from .givens import given
from .practising import Practice, PracticeFileError, PracticeProblem, practice, try_problem
from .reading.formula_trees import TreeError
from .widgets.interactive import interactive_figure
from .widgets.messages import error_message
from .widgets.pictures import show_figure
from .widgets.sliders import Slider

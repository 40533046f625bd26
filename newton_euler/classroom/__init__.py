"""Answers, receipts and widgets of a student's notebook."""

from ..algebra.names import guide as _guide
from ..answers.forms import AnswerError, Form
from ..answers.givens import given
from ..answers.receipts import expect, receipt
from ..answers.trees import TreeError
from .practising import Practice, PracticeFileError, PracticeProblem, practice, try_problem
from .predicting import Prediction, predict, predict_again, tally
from .quantities import show
from .widgets.interactive import interactive_figure
from .widgets.messages import error_message
from .widgets.pictures import show_figure
from .widgets.sliders import Slider

_guide(__name__)

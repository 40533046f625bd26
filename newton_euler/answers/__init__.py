"""A student's answer: how it is read, compared with the right one, and explained where it is wrong.

It holds no key. Notebooks of courses released before version 0.2 import ``expect`` and ``receipt``
from here; today they are in :mod:`newton_euler.classroom`.
"""

from ..algebra.names import guide as _guide
from .causes import Cause, sentence
from .forms import AnswerError, Form
from .kinds import KINDS, Kind
from .receipts import expect, receipt
from .verdicts import NO_ANSWER, Diagnosis, JudgedAnswer, explain, judge

_guide(__name__)

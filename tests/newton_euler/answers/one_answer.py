"""Reads one answer of a receipt, for the tests of every step of reading."""

import sympy

from newton_euler import Frame
from newton_euler.answers.forms import AnswerError, Form
from newton_euler.answers.receipts import record

ground = Frame("ground")
SYMBOLS = {"r": "m", "omega": "rad/s", "theta": "rad"}
r, omega, theta = sympy.symbols("r omega theta", real=True)


def one(form, value, symbols=None):
    """What a receipt reads in one answer; raises AnswerError if it cannot be read."""
    read, faults = record({"x": Form.read(form)}, symbols or {}, {"x": value})
    if faults:
        raise AnswerError(faults["x"])
    return read["x"]

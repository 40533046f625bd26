"""The error of an answer that cannot be read, and any value as a line of a message."""

import reprlib
import textwrap
from typing import Any, Protocol

from ..algebra.errors import NewtonEulerError
from ..algebra.language import _


class SpokenError(NewtonEulerError, ValueError):
    """An error with its sentence in the reader's language, as :func:`~..algebra.language._`."""

    def __init__(self, sentence: str, /, **values: object):
        super().__init__(_(sentence, **values))


class AnswerError(SpokenError):
    """An answer that cannot be read. The message says what was expected, what came, what to do."""

    def _render_traceback_(self) -> list[str]:
        """What IPython shows: the message alone, in lines that nbgrader's Validate does not cut."""
        lines = f"{type(self).__name__}: {self}".splitlines()
        return [textwrap.fill(line, 70) for line in lines]


class OpenAnswer(AnswerError):
    """An answer not given yet; the error is for nbgrader's Validate to show."""


class StatedForm(Protocol):
    """The form in which an answer is asked for, as far as reading needs it: the unit, the words to
    choose from, and the error of an answer that does not have this form.
    """

    @property
    def unit(self) -> str: ...
    @property
    def of(self) -> tuple[str, ...]: ...
    @property
    def words(self) -> str: ...
    def error(self, fault: str, /, **values: object) -> AnswerError: ...


_bounded = reprlib.Repr()
_bounded.maxstring = _bounded.maxother = 400


def one_line(value: Any) -> str:
    """Any value as one printable line: students control the text of error messages, which are
    written to files, tables and pages.
    """
    text = value[:4000] if isinstance(value, str) else _bounded.repr(value)
    line = " ".join(text.split())[:400]
    return "".join(c if c.isprintable() else "\ufffd" for c in line)

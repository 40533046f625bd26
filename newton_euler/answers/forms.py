"""The forms of answers, as "vector, mm/s"."""

import textwrap
from dataclasses import dataclass

from ..algebra.errors import NewtonEulerError, checked

SHAPES = {
    "number": 1, "vector": 3, "matrix": 9, "interval": 2,
    "expression": 1, "vector_expression": 3, "matrix_expression": 9,
}  # fmt: skip
WORDS = frozenset({"choice", "count"})  # kinds that have no unit and no size
_IN_WORDS = {
    "number": "one number",
    "vector": "a vector, three numbers as in [1.0, 0, -2.5]",
    "matrix": "a 3 x 3 matrix of numbers, as in [[1, 0, 0], [0, 1, 0], [0, 0, 1]]",
    "interval": "an interval, two numbers as in [low, high]",
    "count": "a whole number",
    "choice": "one of the words",
    "expression": "a formula in the problem's symbols",
    "vector_expression": "a vector of three formulas, as in [r*omega, 0, 0]",
    "matrix_expression": "a 3 x 3 matrix of formulas",
}


class AnswerError(NewtonEulerError, ValueError):
    """An answer that cannot be read. The message has what was expected, what came, what to do."""

    def _render_traceback_(self):
        """What IPython shows: the message alone, in lines that nbgrader's Validate does not cut."""
        lines = f"AnswerError: {self}".splitlines()
        return [textwrap.fill(line, 70) for line in lines]


@dataclass(frozen=True)
class Form:
    """The kind of one answer, its unit, and for a choice the words.

    >>> Form.read("vector, mm/s")
    Form(kind='vector', unit='mm/s', of=())
    """

    kind: str
    unit: str
    of: tuple = ()

    @classmethod
    @checked
    def read(cls, text: str) -> "Form":
        """The form that a notebook states as text: "vector, mm/s", "choice: stable | unstable"."""
        separator = ":" if text.startswith("choice") else ","
        kind, _, rest = (part.strip() for part in text.partition(separator))
        if kind not in _IN_WORDS:
            raise AnswerError(f"no such kind of answer: {kind!r}; there are {', '.join(_IN_WORDS)}")
        if kind == "choice":
            return cls(kind, "1", tuple(w.strip() for w in rest.split("|")))
        return cls(kind, rest or "1")

    def __str__(self):
        choice = self.kind == "choice"
        return f"choice: {' | '.join(self.of)}" if choice else f"{self.kind}, {self.unit}"

    @property
    def is_formula(self) -> bool:
        """True for formulas, vectors and matrices of formulas."""
        return self.kind.endswith("expression")

    @property
    def words(self) -> str:
        """The form in words for a reader."""
        if self.kind == "choice":
            return f"one of {', '.join(map(repr, self.of))}"
        pure = self.kind == "count" or self.unit == "1"
        return _IN_WORDS[self.kind] + ("" if pure else f", in {self.unit}")

    @checked
    def error(self, fault: str) -> AnswerError:
        """An :class:`AnswerError` with what was expected, and then the fault."""
        return AnswerError(f"expected {self.words}; {fault}")


def clipped(value):
    """The ``repr`` of a value, at most 80 characters of it."""
    text = " ".join(repr(value).split())
    return text if len(text) < 80 else text[:77] + "..."

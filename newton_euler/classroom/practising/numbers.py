"""The right numbers and wrong models of one set of numbers, as :mod:`~..checking.verdicts` asks for
them.
"""

from collections.abc import Collection
from dataclasses import dataclass
from functools import cached_property
from typing import Any

from ...answers.forms import WORDS, Form
from .programs import Program


@dataclass(frozen=True)
class Quantity:
    """A step or an answer: what a practice file says of it."""

    key: str
    kind: str
    unit: str
    means: str
    plain: str
    section: str
    equation: str
    latex: str
    atol: float
    of: tuple[str, ...]
    sum: str
    step: bool

    @property
    def form(self) -> Form:
        """The form in which it is answered."""
        return Form(self.kind, self.unit, self.of)


class KeptNumbers:
    """The numbers of one variant of a problem; ``book`` is that with the book's numbers."""

    def __init__(self, quantities, labels, variant, book=None):
        self.answers = [q for q in quantities if q.key in variant["right"]]
        self._labels, self._variant, self._book = labels, variant, book
        self.program = Program(variant["program"])
        self.tried: Collection[str] = ()
        self.symbols: dict[str, Any] = {}  # all is numbers in practice

    @cached_property
    def key(self):
        """{quantity: points}."""
        return _points(self._variant["right"])

    @cached_property
    def book(self):
        """{quantity: points} for the book's numbers; {} if these are asked."""
        return _points(self._book["right"]) if self._book else {}

    @cached_property
    def _wrong(self):
        found: dict[str, list] = {q.key: [] for q in self.answers}
        for label, numbers in self._variant["wrong"]:
            key, group, text = self._labels[label]
            if key in found:
                found[key].append((group, text, _point(numbers)))
        return found

    def wrong(self, key):
        """[(group, text, points)] of the wrong models of a quantity."""
        return self._wrong[key]

    @property
    def earlier(self):
        """{quantity: those through which it is computed and that were tried}."""
        return {q.key: sorted(self._tried_before(q.key, set())) for q in self.answers}

    def _tried_before(self, key, seen):
        for name in self.program.earlier.get(key, ()):
            if name in self.tried:
                yield name
            elif name not in seen:
                seen.add(name)
                yield from self._tried_before(name, seen)

    def following(self, key, earlier):
        """The points that follow from {earlier quantity: points}; None for words."""
        if any(q.key in earlier and q.kind in WORDS for q in self.answers):
            return None
        found = self.program.following(key, {name: x[0] for name, x in earlier.items()})
        return found and (found,)


def _points(right):
    return {key: _point(x) for key, x in right.items()}


def _point(x):
    return (tuple(x),) if isinstance(x, list) else ((x,),)

"""The right numbers and wrong models of one set of numbers, from a practice file."""

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

from ...algebra.language import ENGLISH, Words, _, from_stored, language
from ...answers.causes import INSTEAD, Cause
from ...answers.forms import Form, kind_named
from ...answers.kinds import Kind
from ...answers.near import NO_SLIPS, Ranked, Slips
from ...answers.tolerance import RTOL, Points
from .programs import Program


@dataclass(frozen=True)
class Quantity:
    """A step or an answer: what a practice file says of it."""

    key: str
    kind: Kind
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
    rtol: float = RTOL

    @classmethod
    def read(cls, data: Mapping[str, Any]) -> "Quantity":
        """A quantity from a practice file."""
        return cls(**{**data, "kind": kind_named(data["kind"]), "of": tuple(data["of"])})

    @property
    def form(self) -> Form:
        """The form in which it is answered."""
        return Form(self.kind, self.unit, self.of)


class KeptNumbers:
    """The numbers of a variant, by its ``number``, on the ``page`` of a problem."""

    sheets = ()

    def __init__(self, quantities: Sequence[Quantity], page: Mapping[str, Any], number: int):
        self._variant = variant = page["variants"][number]
        self._book = page["variants"][0] if number and page["book"] else None
        self._labels, self.program = page["labels"], Program(variant["program"])
        self._own = page.get("language", ENGLISH) == language()
        self.answers = [q for q in quantities if q.key in variant["right"]]
        self.where = from_stored(page["where"])
        self.tried: Collection[str] = ()
        self.slips = KeptSlips(page["slips"], variant.get("slips", ()))
        self.symbols: dict[str, Any] = {}  # practice is numeric

    @cached_property
    def key(self) -> dict[str, Points]:
        """{quantity: points}."""
        return _points(self._variant["right"])

    @cached_property
    def book(self) -> dict[str, Points]:
        """{quantity: points} for the book's numbers; {} if these are asked."""
        return _points(self._book["right"]) if self._book else {}

    @cached_property
    def _wrong(self):
        found: dict[str, list] = {q.key: [] for q in self.answers}
        for label, numbers in self._variant["wrong"]:
            key, *cause = self._labels[label]
            if key in found:
                group, name, *texts, subject, does, of = cause
                known = group, name, *map(self._read, texts), *map(from_stored, (subject, does, of))
                found[key].append((Cause(*known), _point(numbers)))
        return found

    def _read(self, stored):
        """The text of a cause; one in another language than the reader's is quoted."""
        text = from_stored(stored)
        if self._own or isinstance(text, Words) or not text:
            return text
        return ": ".join(_("“{english}”", english=part) for part in text.split(": ", 1))

    def wrong(self, key: str) -> list[tuple[Cause, Points]]:
        """What the wrong models make of a quantity."""
        return self._wrong[key]

    @property
    def earlier(self) -> dict[str, list[str]]:
        """{quantity: the earlier ones from which it is computed and that were tried}."""
        return {q.key: sorted(self._tried_before(q.key)) for q in self.answers}

    def _tried_before(self, key):
        waiting, seen = [key], set[str]()
        while waiting:
            new = {*self.program.earlier.get(waiting.pop(), ())} - seen
            seen |= new
            waiting += new - {*self.tried}
        return seen & {*self.tried}

    def sequel(self, key: str, earlier: Mapping[str, Points]) -> Slips:
        """No slips: the computation of later quantities from earlier ones is one of numbers."""
        return NO_SLIPS

    def following(self, key: str, earlier: Mapping[str, Points]) -> Points | None:
        """The points that follow from {earlier quantity: points}; None for words."""
        if any(q.key in earlier and q.kind.is_word for q in self.answers):
            return None
        found = self.program.following(key, {name: x[0] for name, x in earlier.items()})
        return (found,) if found else None

    def other_ways(self, key: str) -> tuple[()]:
        """None: every quantity is computed in one way."""
        return ()


class KeptSlips(Slips):
    """The slips of one variant: ``labels`` of all, [key, rank, name, text, where,
    subject, does, of], and the numbers that these make, [place among the labels, numbers].
    """

    def __init__(self, labels: Sequence[Sequence[Any]], kept: Sequence[tuple[int, Any]]):
        self._found: dict[str, list] = {}
        for n, numbers in kept:
            key, rank, *texts = labels[n]
            name, text, where, subject, does, of = map(from_stored, texts)
            cause = Cause("computed", name, text, where, subject, does, of)
            if cause.does == INSTEAD:
                cause = replace(cause, of="", answers=tuple(cause.of.split()))
            self._found.setdefault(key, []).append(((rank, cause), numbers))

    def ranked(self, key: str) -> Ranked | None:
        """As for :class:`~newton_euler.answers.near.Slips`."""
        return Ranked([slip for slip, _ in self._found[key]]) if key in self._found else None

    def at(self, key: str, point: int) -> Any:
        """As for :class:`~newton_euler.answers.near.Slips`."""
        return [numbers for _, numbers in self._found[key]]


def _points(right):
    return {key: _point(x) for key, x in right.items()}


def _point(x):
    return (tuple(x),) if isinstance(x, list) else ((x,),)

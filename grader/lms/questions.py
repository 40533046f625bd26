"""A problem with one set of numbers in a form for every platform: numbers within a margin, and
choices.
"""

from dataclasses import dataclass, replace
from typing import Any

from exercises.catalogue import Problem
from exercises.catalogue.model import Answer
from newton_euler.answers.kinds import Kind
from newton_euler.answers.notation import bare_unit, is_word

from ..assignment.cells import Values
from ..assignment.figures import figure_png
from ..assignment.notebook import slug, statement, statement_with, typeset
from ..practice.plain import plain
from ..practice.quantities import quantities, wrong_numbers
from ..scoring.margins import margins

Point = tuple[float, ...]


@dataclass(frozen=True)
class Wrong:
    """A wrong answer by a listed mistake: numbers with their margins, or a word."""

    point: Any
    off: Point
    text: str


@dataclass(frozen=True)
class QuestionPart:
    """An answer of a question: meaning and unit, in Markdown and LaTeX; the right numbers with
    their margins, or the right word.
    """

    asked: Answer
    means: str
    symbol: str
    unit: str
    key: Any
    off: Point
    wrong: tuple[Wrong, ...]

    @property
    def options(self) -> tuple[str, ...]:
        """The words to choose from, () for numbers."""
        return self.asked.of

    @property
    def count(self) -> int:
        """The number of its blanks: one for a choice."""
        return 1 if self.options else len(self.key)

    @property
    def weight(self) -> float:
        """Its share of the points, relative to the other parts."""
        return self.asked.weight

    @property
    def kind(self) -> Kind:
        """The kind of answer."""
        return self.asked.kind

    @property
    def blanks(self) -> list["Blank"]:
        """Its numbers, for platforms that judge them one by one."""
        return [
            Blank(x, off, _merged(Wrong((w.point[n],), (w.off[n],), w.text) for w in self.wrong
                                  if abs(w.point[n] - x) > off))
            for n, (x, off) in enumerate(zip(self.key, self.off, strict=True))
        ]  # fmt: skip

    @property
    def wholes(self) -> list[Wrong]:
        """Its wrong answers, for platforms that judge all numbers together."""
        return _merged(self.wrong)

    def says(self, word: str) -> str:
        """The diagnosis of a wrong word, or ""."""
        return next((w.text for w in self.wholes if w.point == word), "")


@dataclass(frozen=True)
class Blank:
    """One number: the right value, its margin, and wrong values."""

    key: float
    off: float
    wrong: list[Wrong]


@dataclass(frozen=True)
class Question:
    """A problem with one set of numbers: ``text`` in Markdown, ``figure`` as PNG."""

    ident: str
    problem: str
    title: str
    text: str
    figure: bytes | None
    words: str
    parts: tuple[QuestionPart, ...]
    points: float

    def points_of(self, part: QuestionPart) -> float:
        """The points of one of its parts."""
        return self.points * part.weight / sum(p.weight for p in self.parts)


def question(
    p: Problem, values: Values, number: int, points: float, text: str = "", diagnosed: bool = True
) -> Question:
    """Variant ``number`` of a problem without symbols, and without parts that no platform can
    judge, see :func:`left_out`; ``text``: the problem's as an instructor changed it; ``diagnosed``:
    with listed mistakes.
    """
    described, right = quantities(p, values)
    every = wrong_numbers(p, values, described, right) if diagnosed else ()
    wrong = [w for w in every if w[1].group == "listed"]
    parts = tuple(_part(p, a, right[a.key], wrong) for a in p.answers if not left_out(a))
    shown = statement_with(p, text, values) if text else statement(p, values, False, code=False)
    shown = shown.partition("\n")[2].strip()  # the heading is the name of the question
    ident = f"{slug(p.id)}-{number}"
    figure = figure_png(p, values)
    return Question(
        ident, p.id, f"{p.id} {p.title}", shown, figure, plain(p.figure, p.units), parts, points
    )


def left_out(a: Answer) -> str:
    """Why an answer is left out, or ""."""
    if a.kind.is_formula:
        return "a formula"
    return a.kind.many


def _part(p, a, right, wrong):
    symbol = "" if is_word(a.key) and not a.latex else p.notation[a.key]
    unit = "" if a.unit == "1" else bare_unit(a.unit)
    means = typeset(a.means, p)
    found = tuple(
        Wrong(x, (), " ".join(plain(cause.text, p.units).split()))
        for key, cause, x in wrong
        if key == a.key and (not a.of or x in a.of)
    )
    part = QuestionPart(a, means[:1].upper() + means[1:], symbol, unit, right, (), found)
    if a.of:
        return part
    if a.kind.is_word:  # a count
        whole = tuple(replace(w, point=(float(w.point),), off=(0.0,)) for w in part.wrong)
        return replace(part, key=(float(right),), off=(0.0,), wrong=whole)
    key = tuple(right)
    numbers = (
        replace(w, point=tuple(w.point), off=_off(a, w.point, key))
        for w in part.wrong
        if not a.kind.is_right((tuple(w.point),), (key,), a.atol, a.rtol)
    )
    return replace(part, key=key, off=margins(a, key), wrong=tuple(numbers))


def _off(a, point, key):
    """The margins of a wrong answer; for zeros, those of the key."""
    return tuple(m or k for m, k in zip(margins(a, tuple(point)), margins(a, key), strict=True))


def _merged(wrong):
    """Wrong answers, with indistinguishable ones merged and all their diagnoses."""
    found: list[tuple[Wrong, list[str]]] = []
    for w in wrong:
        texts = next((texts for other, texts in found if _alike(w, other)), None)
        if texts is None:
            found.append((w, [w.text]))
        elif w.text not in texts:
            texts.append(w.text)
    fitting = "It fits a solution that {}.".format
    return [replace(w, text=fitting("; or one that ".join(texts))) for w, texts in found]


def _alike(a, b):
    if not a.off:
        return a.point == b.point
    rows = zip(a.point, b.point, a.off, b.off, strict=True)
    return all(abs(x - y) <= max(p, q) for x, y, p, q in rows)

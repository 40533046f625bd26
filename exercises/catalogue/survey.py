"""What problems are chosen by: section, kinds of answers, equations, steps, how hard and how long.

It gives no answer away. Difficulty and time are estimates from what is computed, on a scale that
spreads the problems of this catalogue; what students of a course found hard is measured apart
(:mod:`grader.reports.measured`).
"""

import math
import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from functools import cache

from newton_euler.algebra.source import uses

from .model import Problem
from .tracing import traced_quantities
from .variants import sheets

# where difficulties 2 to 5 begin: fifths of the catalogue
FIFTHS = (5.0, 6.5, 8.0, 9.5)


@dataclass(frozen=True)
class Entry:
    """A problem in the catalogue.

    kinds : of its answers. equations : of the book, cited by its steps. steps : on the way to its
    answers, without the terms of sums. operations : of the whole computation.
    sheets : how many sets of numbers can be drawn. words : all its texts, in lower case
    """

    id: str
    chapter: str
    section: str
    title: str
    kinds: tuple[str, ...]
    equations: tuple[str, ...]
    steps: int
    terms: int
    operations: int
    answers: int
    sheets: int
    figure: bool
    words: str

    @property
    def difficulty(self) -> int:
        """From 1 to 5, by the steps, their equations, the operations, and formulas to be found."""
        formula = any("expression" in kind for kind in self.kinds)
        size = self.steps + self.terms / 3 + len(self.equations) / 2 + formula
        size += math.log2(1 + self.operations) / 2
        return 1 + sum(size >= limit for limit in FIFTHS)

    @property
    def minutes(self) -> int:
        """The time for a student who knows the section: to read, and for each step, term, answer
        and operation; a multiple of five.
        """
        reading = 2 + len(self.words.split()) / 80
        work = 2 * self.steps + self.terms + self.answers + self.operations / 5
        return 5 * max(1, round((reading + work) / 5))


@cache
def entry(p: Problem) -> Entry:
    """The entry of a problem."""
    found = traced_quantities(p)
    terms = [s for s in found.steps if s.term]
    needed = uses(found.trace, [x for numbers in found.components.values() for x in numbers])
    operations = sum(s.op != "argument" for s in found.trace.steps if s.number in needed)
    means = [*(a.means for a in p.answers), *(s.means for s in found.steps)]
    return Entry(
        p.id, p.chapter, p.section, p.title,
        tuple(dict.fromkeys(a.kind.name for a in p.answers)),
        tuple(sorted({s.equation for s in found.steps if s.equation}, key=_natural)),
        len(found.steps) - len(terms), len(terms), operations, len(p.answers), sheets(p),
        bool(p.figure), " ".join(" ".join((p.title, p.text, p.figure, *means)).lower().split()),
    )  # fmt: skip


def _natural(number):
    return [int(x) if x.isdigit() else x for x in re.split(r"(\d+)", number)]


Span = tuple[float, float]


@dataclass(frozen=True)
class Wanted:
    """What is looked for; what is empty is not asked. A problem has one of the ``sections`` (4.1 is
    not 4.10, 4 is all of the chapter) and ``kinds``, all of the ``equations`` and ``words``.
    """

    sections: tuple[str, ...] = ()
    kinds: tuple[str, ...] = ()
    equations: tuple[str, ...] = ()
    words: tuple[str, ...] = ()
    spans: Mapping[str, Span] | None = None  # of the numbers of an entry, by name

    def has(self, e: Entry) -> bool:
        """True if an entry is what is looked for."""
        section = (e.section, e.section.partition(".")[0])
        return (
            (not self.sections or any(s in section for s in self.sections))
            and (not self.kinds or any(k in e.kinds for k in self.kinds))
            and all(number in e.equations for number in self.equations)
            and all(_found(word, e) for word in self.words)
            and all(low <= getattr(e, n) <= high for n, (low, high) in (self.spans or {}).items())
        )


def _found(word, e):
    """True if a word of the entry begins so, or it is its number, section or equation."""
    exact = (e.id.lower(), e.section, e.chapter.lower(), *e.equations)
    return word.lower() in exact or re.search(rf"\b{re.escape(word.lower())}", e.words) is not None


def chosen(problems: Iterable[Problem], wanted: Wanted) -> list[Entry]:
    """The entries of the problems that are looked for."""
    return [e for e in map(entry, problems) if wanted.has(e)]

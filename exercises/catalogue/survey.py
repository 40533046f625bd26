"""Choosing problems: by section, kinds of answers, equations, steps, difficulty and time.

No answer is given away. Difficulty and time are estimated from the computation, on a scale that
spreads this catalogue; what students found hard is in :mod:`grader.reports.measured`.
"""

import math
import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from functools import cache

from newton_euler.algebra.source import uses
from newton_euler.answers.kinds import Kind

from .model import Problem
from .places import natural_order
from .tracing import traced_quantities
from .variants import sheets

# lower limits of difficulties 2 to 5: fifths of the catalogue
FIFTHS = (5.0, 6.5, 8.0, 9.5)


@dataclass(frozen=True)
class ProblemEntry:
    """A problem as it is searched for.

    kinds : of its answers. equations : cited by its steps. steps : without the terms of sums.
    operations : of the whole computation. sheets : number of variants. words : its texts, in lower
    case
    """

    id: str
    chapter: str
    section: str
    title: str
    kinds: tuple[Kind, ...]
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
        """From 1 to 5, by steps, equations, operations, and whether a formula is asked for."""
        formula = any(kind.is_formula for kind in self.kinds)
        size = self.steps + self.terms / 3 + len(self.equations) / 2 + formula
        size += math.log2(1 + self.operations) / 2
        return 1 + sum(size >= limit for limit in FIFTHS)

    @property
    def minutes(self) -> int:
        """The time for a student who knows the section, to the next five minutes."""
        reading = 2 + len(self.words.split()) / 80
        work = 2 * self.steps + self.terms + self.answers + self.operations / 5
        return 5 * max(1, round((reading + work) / 5))


@cache
def entry(p: Problem) -> ProblemEntry:
    """The problem ``p`` as an entry."""
    found = traced_quantities(p)
    terms = [s for s in found.steps if s.term]
    needed = uses(found.trace, [x for numbers in found.components.values() for x in numbers])
    operations = sum(s.op != "argument" for s in found.trace.steps if s.number in needed)
    means = [*(a.means for a in p.answers), *(s.means for s in found.steps)]
    return ProblemEntry(
        p.id, p.chapter, p.section, p.title,
        tuple(dict.fromkeys(a.kind for a in p.answers)),
        tuple(sorted({s.equation for s in found.steps if s.equation}, key=natural_order)),
        len(found.steps) - len(terms), len(terms), operations, len(p.answers), sheets(p),
        bool(p.figure), " ".join(" ".join((p.title, p.text, p.figure, *means)).lower().split()),
    )  # fmt: skip


Span = tuple[float, float]


@dataclass(frozen=True)
class Wanted:
    """A search: any of ``sections`` (4: all 4.x) and ``kinds``, all ``equations`` and ``words``."""

    sections: tuple[str, ...] = ()
    kinds: tuple[str, ...] = ()
    equations: tuple[str, ...] = ()
    words: tuple[str, ...] = ()
    spans: Mapping[str, Span] | None = None  # ranges of the numbers of an entry, by name

    def has(self, e: ProblemEntry) -> bool:
        """True if the entry matches."""
        section = (e.section, e.section.partition(".")[0])
        return (
            (not self.sections or any(s in section for s in self.sections))
            and (not self.kinds or any(k.name in self.kinds for k in e.kinds))
            and all(number in e.equations for number in self.equations)
            and all(_found(word, e) for word in self.words)
            and all(low <= getattr(e, n) <= high for n, (low, high) in (self.spans or {}).items())
        )


def _found(word, e):
    """True if ``word`` begins a word of the entry, or is its number, section or equation."""
    exact = (e.id.lower(), e.section, e.chapter.lower(), *e.equations)
    return word.lower() in exact or re.search(rf"\b{re.escape(word.lower())}", e.words) is not None


def matching(problems: Iterable[Problem], wanted: Wanted) -> list[ProblemEntry]:
    """The entries that match."""
    return [e for e in map(entry, problems) if wanted.has(e)]

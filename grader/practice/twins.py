"""A problem with numbers in place of its symbols: practice is numeric, and does not give away
formulas that an assignment asks for.
"""

from collections.abc import Sequence
from dataclasses import replace
from functools import cache

from exercises.catalogue import Given, Problem
from exercises.catalogue.variants import draw, drawn_value, practice_seed

from ..assignment.cells import Values
from .graded import GradedAnswers

TRIES = 50  # draws per set that must be far from all sheets of a class


@cache
def twin(p: Problem) -> Problem:
    """Problem ``p``, with givens in place of any symbols."""
    if not p.symbols:
        return p
    numbers = {n: _given(s) for n, s in p.symbols.items()}
    answers = tuple(replace(a, kind=a.kind.numeric) for a in p.answers)
    numeric = replace(p, givens={**p.givens, **numbers}, symbols={}, answers=answers, checked={})
    # the system of units of its code must not change
    vars(numeric)["system"] = p.system
    return numeric


def _given(s):
    given = Given(s.name, 0.0, s.unit, "", s.vary, latex=s.latex)
    return replace(given, value=drawn_value(given, _Middle()))


class _Middle:
    """Takes the place of a random generator: always the middle of a range."""

    def randint(self, first, last):
        return (first + last) // 2


def sets_of_numbers(
    p: Problem, count: int, graded: Sequence[Values] = (), seed: str = "practice", book: bool = True
) -> list[Values]:
    """The numbers of the ``book`` (the middle of the range for symbols) and drawn ones, up to
    ``count`` different sets, none with an answer near one of the ``graded`` sheets.
    """
    near = GradedAnswers(p, graded)
    found = [p.book_values] if book and not near(p.book_values) else []
    for n in range((TRIES if graded else 10) * count):
        if len(found) >= count:
            break
        values = draw(p, practice_seed(p, n, seed))
        if values not in found and not near(values):
            found.append(values)
    return found

"""Answers and steps with simple slips in the computation, for a practice file."""

import math
import re
from collections.abc import Collection
from typing import Any

from exercises.catalogue import Problem
from grader.scoring.slips.typed import NOUNS
from newton_euler.algebra.language import Words
from newton_euler.answers.kinds import KINDS
from newton_euler.answers.near import RARER, SIMPLE

from ..assignment.cells import Values
from ..scoring.computation import perturbed


def slip_numbers(
    p: Problem, values: Values, described: list[dict[str, Any]], right: dict[str, Any]
) -> list[tuple]:
    """[(key, rank, cause, numbers)] of slips in answers up to rank :data:`RARER`, and of the
    simplest in steps; the first of those with the same words and numbers. Formulas are not
    included: they would give the answers for other numbers.
    """
    answers, steps = perturbed(p, values), perturbed(p, values, of_steps=True)
    found: dict[Any, tuple] = {}
    for q in described:
        key, slips, rarest = q["key"], *((steps, SIMPLE) if q["step"] else (answers, RARER))
        ranked = None if KINDS[q["kind"]].is_word else slips.ranked(key)
        rows = slips.at(key, 0).tolist() if ranked else []
        for (rank, cause), row in zip(ranked.slips if ranked else (), rows, strict=True):
            if rank <= rarest and _differs(row, right[key]):
                same = key, cause.text, *(f"{x:.6g}" for x in row)
                found.setdefault(same, (key, rank, cause, row))
    return list(found.values())


_BY_NAMES = dict(NOUNS.values())  # {template with a formula: the same with its names}
_FORMULA = re.compile(r"[+-]?[\w.(][\w.()*/^']*(?: [+-] [\w.(][\w.()*/^']*)*")


def without_formulas(text: str, names: Collection[str]) -> str:
    """The words of a mistake in which formulas of these ``names`` are called by the names in them,
    or left out within a text: where a formula is asked for, those of all mistakes together would be
    the answer.

    >>> term = Words("the term {formula}", formula="2*m*g")
    >>> without_formulas(Words("leaves out {term}", term=term), {"m", "g"})
    'leaves out the term in m, g'
    >>> without_formulas("gives m*g/2: that is half of it", {"m", "g"})
    'gives …: that is half of it'
    """
    if isinstance(text, Words):
        own = {name: without_formulas(x, names) for name, x in text.values.items()}
        inside = own.get("formula")
        if isinstance(inside, Words) and text.template in _BY_NAMES:
            return Words(_BY_NAMES[text.template], **inside.values)
        return Words(text.template, **own)

    def named(formula):
        found = dict.fromkeys(re.findall(r"[A-Za-z]\w*", formula))
        return [x for x in found if x in names and re.search(r"[*/^]| [+-] ", formula)]

    if _FORMULA.fullmatch(text) and (found := named(text)):
        return Words("an expression in {names}", names=", ".join(found))
    return _FORMULA.sub(lambda m: "…" if named(m[0]) else m[0], text)


def _differs(row, right):
    gap = math.dist(row, right)
    return math.isfinite(gap) and gap > 0.02 * math.hypot(*right)

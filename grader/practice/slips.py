"""What simple slips in the computation make of the answers, as numbers for a practice file."""

import math
from typing import Any

from exercises.catalogue import Problem
from newton_euler.answers.formulas import RARER
from newton_euler.answers.kinds import KINDS

from ..assignment.cells import Values
from ..scoring.computation import perturbed


def slip_numbers(
    p: Problem, values: Values, described: list[dict[str, Any]], right: dict[str, Any]
) -> list[tuple]:
    """[(key, rank, cause, numbers)] of the slips in the answers that are at most as rare as
    :data:`RARER`; of those with the same words and numbers, the first. The formulas themselves are
    not in it: they would give the answers for other numbers.
    """
    slips = perturbed(p, values)
    found: dict[Any, tuple] = {}
    for q in described:
        key = q["key"]
        ranked = None if q["step"] or KINDS[q["kind"]].is_word else slips.ranked(key)
        rows = slips.at(key, 0).tolist() if ranked else []
        for (rank, cause), row in zip(ranked.slips if ranked else (), rows, strict=True):
            if rank <= RARER and _differs(row, right[key]):
                same = key, cause.text, *(f"{x:.6g}" for x in row)
                found.setdefault(same, (key, rank, cause, row))
    return list(found.values())


def _differs(row, right):
    gap = math.dist(row, right)
    return math.isfinite(gap) and gap > 0.02 * math.hypot(*right)

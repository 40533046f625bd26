"""Answers and steps with simple slips in the computation, for a practice file."""

import math
from typing import Any

from exercises.catalogue import Problem
from newton_euler.answers.formulas import RARER, SIMPLE
from newton_euler.answers.kinds import KINDS

from ..assignment.cells import Values
from ..scoring.computation import perturbed, perturbed_steps


def slip_numbers(
    p: Problem, values: Values, described: list[dict[str, Any]], right: dict[str, Any]
) -> list[tuple]:
    """[(key, rank, cause, numbers)] of slips in answers up to rank :data:`RARER`, and of the
    simplest in steps; the first of those with the same words and numbers. Formulas are not
    included: they would give the answers for other numbers.
    """
    answers, steps = perturbed(p, values), perturbed_steps(p, values)
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


def _differs(row, right):
    gap = math.dist(row, right)
    return math.isfinite(gap) and gap > 0.02 * math.hypot(*right)

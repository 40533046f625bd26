"""What any answer to a problem must be, whoever's numbers it has: told to students, whose receipts
warn of an answer that cannot be.
"""

import math
import random
from functools import cache

import numpy as np

from newton_euler.answers.sanity import KINETIC

from .model import Problem
from .variants import at_points, drawn_value

DRAWS = 100  # sets of numbers
ROOM = 3.0  # beyond what these give; rounded outward to powers of ten, which tell no key


@cache
def sane_answers(p: Problem) -> dict[str, tuple[float, float] | str]:
    """{answer: (low, high) of its size, or "kinetic energy"} of problem ``p``; an answer of which
    nothing is known is left out.
    """
    # not the change of one, which may be negative
    found: dict[str, tuple[float, float] | str] = {
        a.key: KINETIC for a in p.answers if a.means.lower().startswith(KINETIC)
    }
    asked = [a for a in p.answers if a.kind.has_size]
    if not asked:
        return found
    rng = random.Random(f"sizes of {p.id}")
    values = {
        n: np.array([g.value, *(drawn_value(g, rng) for _ in range(DRAWS))])
        for n, g in p.givens.items()
    }
    values |= {n: np.array([rng.uniform(*s.vary) for _ in range(DRAWS + 1)])
               for n, s in p.symbols.items()}  # fmt: skip
    right, _ = at_points(p, values)
    bounds = {a.key: _bounds(right[a.key]) for a in asked if a.key not in found}
    return found | {key: b for key, b in bounds.items() if b}


def _bounds(points):
    sizes = [s for s in (math.hypot(*x) for x in points) if math.isfinite(s)]
    high = max(sizes, default=0.0)
    if high <= 1e-9:  # round-off for zero
        return None
    low = min(sizes)
    least = 10.0 ** math.floor(math.log10(low / ROOM)) if low > 1e-6 * high else 0.0
    return least, 10.0 ** math.ceil(math.log10(ROOM * high))

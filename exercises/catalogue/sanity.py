"""Bounds on the answers of a problem over all variants, for receipts to warn students by."""

import math
import random
from functools import cache
from typing import TypeAlias

from newton_euler.algebra.late import np
from newton_euler.answers.sanity import KINETIC, MAGNITUDE

from .model import Problem
from .variants import at_points, drawn_value

Sane: TypeAlias = tuple[float, float] | tuple[float, float, str] | str
DRAWS = 100  # sets of numbers
ROOM = 3.0  # factor beyond these sizes, rounded outward to powers of ten, which give no key away


@cache
def sane_answers(p: Problem) -> dict[str, Sane]:
    """{answer: (low, high) of its size, "kinetic energy", "magnitude" or "magnitude of" another
    answer, or size and word} of problem ``p``, for answers of which something is known.
    """
    words = {a.key: KINETIC for a in p.answers if a.quantity == KINETIC}
    rng = random.Random(f"sizes of {p.id}")
    values = {
        n: np.array([g.value, *(drawn_value(g, rng) for _ in range(DRAWS))])
        for n, g in p.givens.items()
    }
    values |= {n: np.array([rng.uniform(*s.vary) for _ in range(DRAWS + 1)])
               for n, s in p.symbols.items()}  # fmt: skip
    asked = [a for a in p.answers if a.kind.has_size and a.key not in words]
    magnitudes = [a for a in p.answers if a.quantity == MAGNITUDE]
    if not asked and not magnitudes:
        return dict(words)
    right, _ = at_points(p, values)
    words |= {a.key: _magnitude(p, a, right) for a in magnitudes}
    bounds = {a.key: b for a in asked if (b := _bounds(right[a.key]))}
    both = {key: (*bounds[key], words[key]) for key in bounds.keys() & words.keys()}
    return {key: x for key, x in ({**words, **bounds, **both}).items() if x}


def _magnitude(p, a, right):
    """ "magnitude", with the name of the vector if it is an answer; "" where it may be negative."""
    sizes = [x for (x,) in right[a.key]]
    if min(sizes) < 0:
        return ""
    for b in p.answers:
        if b.kind.is_vector and b.unit == a.unit:
            others = [math.hypot(*point) for point in right[b.key]]
            if np.allclose(sizes, others, rtol=1e-9, atol=0.0):
                return f"{MAGNITUDE} of {b.key}"
    return MAGNITUDE


def _bounds(points):
    sizes = [s for s in (math.hypot(*x) for x in points) if math.isfinite(s)]
    high = max(sizes, default=0.0)
    if high <= 1e-9:  # round-off for zero
        return None
    low = min(sizes)
    least = 10.0 ** math.floor(math.log10(low / ROOM)) if low > 1e-6 * high else 0.0
    return least, 10.0 ** math.ceil(math.log10(ROOM * high))

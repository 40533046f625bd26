"""When an answer is right: how near to the key it must be.

An answer is a tuple of points, and a point a tuple of components: a number has one point, a formula
one for each place at which it is compared.
"""

import math

RTOL = 0.005  # of the size of the key: accepts three significant figures, rounded up or down
FORMULA_RTOL = 3e-5  # formulas are exact; this accepts 3.1416 for pi, 6.283 for 2 pi, 0.33333
# a component that is smaller than this, relative to the whole, is round-off for zero
NOISE = 1e-9
# a mistake must differ from the key by this much of its size, or it could not be told from rounding
SEPARATION = 0.02


def is_right(kind, given, key, atol):
    """True if the points of ``given`` are near enough to those of ``key``; ``atol`` is the absolute
    tolerance for a key that is zero.
    """
    if kind.endswith("expression"):
        return _formula_is_right(given, key, atol)
    (given,), (key,) = given, key
    # each bound separately: relative to a wide interval, an error of its lower bound would be small
    if kind == "interval":
        return all(_is_near((x,), (k,), atol) for x, k in zip(given, key, strict=True))
    return _is_near(given, key, atol)


def _is_near(given, key, atol):
    """Within half a percent of the size of the key; and no component, however small, is off by more
    than half of itself, so that one left out or with the wrong sign is not right.
    """
    size, gap = math.hypot(*key), math.dist(given, key)
    if not math.isfinite(size):
        return False
    if size <= atol:
        return gap <= atol
    return gap <= RTOL * size and all(
        abs(x - k) <= abs(k) / 2 for x, k in zip(given, key, strict=True) if abs(k) > NOISE * size
    )


def _formula_is_right(given, key, atol):
    """Each component by itself, at every point where the key is finite, relative to its value there
    or its mean over the points, whichever is larger: near a zero of the key, 3.1416 for pi is seen.
    """
    points = [(x, k) for x, k in zip(given, key, strict=True) if all(map(math.isfinite, k))]
    if not points:
        return False
    means = [sum(map(abs, column)) / len(points) for column in zip(*(k for _, k in points))]  # noqa: B905
    zero = max(means) <= atol
    for x, k in points:
        noise = atol if zero else NOISE * math.hypot(*k)
        for a, b, mean in zip(x, k, means, strict=True):
            if not abs(a - b) <= FORMULA_RTOL * max(abs(b), mean) + noise:
                return False
    return True

"""All tolerances by which answers are judged, and the comparisons that use them."""

import math
from collections.abc import Sequence
from typing import Any

Point = tuple[Any, ...]
Points = tuple[Point, ...]

RTOL = 0.005  # relative: accepts three significant figures of the key, rounded up or down
DIGITS = 3  # significant figures that are asked for
FORMULA_RTOL = 3e-5  # formulas are exact; this accepts 3.1416 for pi, 6.283 for 2 pi, 0.33333
FORMULA_FIT = 6e-5  # between a wrong formula and a model: numbers may be typed in five digits
NOISE = 1e-9  # a component smaller than this, relative to the whole, is round-off for zero
# a mistake differs from the key by this much of its size, or it might be rounding
SEPARATION = 0.02
MAJORITY = 0.5  # share of the points of comparison at which a difference must show
# a component of a key is zero, or at least this share of the whole: one left out must show
COMPONENT = 0.01
ROUND_OFF = 1e-6  # an answer with all its digits is nearer than this to its own model
NUMBER_RTOL = 6e-4  # a single number meets a wrong model by chance much sooner than a vector does
NEARLY = 0.03  # relative: a wrong answer so near the key was rounded too early
TWO_DIGITS = 0.05  # NEARLY for the first digits of the key: 30 for 26.6 may be computed
SAME_SIZE = 1e-4  # relative: the size of a vector is right although its direction is not
ONE_VECTOR = 1e-6  # relative: components in two frames have one size, or are of two vectors
EARLY = 1e-3  # relative: a right answer farther from the key was rounded too early
ROOM = 1e-3  # relative, for rounding, where an answer is checked without the key


def is_near(given: Sequence[float], key: Sequence[float], atol: float, rtol: float = RTOL) -> bool:
    """True if a point is within ``rtol`` of the size of the key, and no component, however small,
    is off by more than half of itself, as one left out or of the wrong sign is; ``atol`` is the
    absolute tolerance for a key that is zero.
    """
    size, gap = math.hypot(*key), math.dist(given, key)
    if not math.isfinite(size):
        return False
    if size <= atol:
        return gap <= atol
    return gap <= rtol * size and all(
        abs(x - k) <= abs(k) / 2 for x, k in zip(given, key, strict=True) if abs(k) > NOISE * size
    )


def formula_is_near(given: Points, key: Points, atol: float) -> bool:
    """True if each component by itself is near, at every point where the key is finite, relative to
    its value there or its mean over the points, whichever is larger.
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


def distance(a: Sequence[float], b: Sequence[float]) -> float:
    """The distance of two points relative to the size of ``b``; absolute where b is zero."""
    return math.dist(a, b) / (math.hypot(*b) or 1.0)


def is_apart(numbers: Points, key: Points) -> bool:
    """True if a model is far from the key at half of the points at least; words, if they differ."""
    if isinstance(key[0][0], str) or isinstance(numbers[0][0], str):
        return numbers != key
    far = [
        math.dist(x, k) >= SEPARATION * math.hypot(*k)
        for x, k in zip(numbers, key, strict=True)
        if math.isfinite(math.hypot(*x)) and math.isfinite(math.hypot(*k))
    ]
    return sum(far) >= MAJORITY * len(far)

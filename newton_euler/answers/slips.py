"""Slips that are made in any problem and that need nothing but the key: a factor of a unit, a sign,
components exchanged, two listed mistakes at once. Each is [(cause, points)] for a
:class:`~newton_euler.answers.fit.Fit`.
"""

import math
from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction
from functools import cache
from itertools import combinations

from ..algebra.units import Dimension, unit
from . import causes
from .causes import Cause
from .fit import Fit, most_digits, written
from .tolerance import DIGITS, NOISE, NUMBER_RTOL, Points

Models = Iterator[tuple[Cause, Points]]

PURE = {"a factor of 2": 2.0, "revolutions against radians": 2 * math.pi}
ANGLES = {"degrees against radians": 180 / math.pi, "rev/min against rad/s": 30 / math.pi}
LENGTHS = {
    "m against mm": 1000.0, "ft against in": 12.0, "in against mm": 25.4,
    "ft against m": 1 / 0.3048, "ft against mm": 304.8,
}  # fmt: skip
WEIGHTS = {
    "weight against mass (g = 9.81)": 9.81, "weight against mass (g = 32.2)": 32.2,
}  # fmt: skip


@cache
def factors(stated_in: str) -> Mapping[str, float]:
    """{words: factor} of the units that an answer, stated in this unit, may be in by mistake."""
    found = PURE | ANGLES
    if unit(stated_in).factor == Fraction(1, 100) and unit(stated_in).dimension == Dimension():
        found |= {"a fraction against percent": 100.0}
    mass, length, _ = unit(stated_in).dimension.powers
    if length:
        found |= {words: factor ** abs(float(length)) for words, factor in LENGTHS.items()}
    return found | WEIGHTS if mass else found


def multiples(fit: Fit, found: Mapping[str, float]) -> Models:
    """The key times the factors that may fit, found by the first point of the answer."""
    if fit.index is None:
        return
    given, key, size = fit.first
    ratio = math.hypot(*given) / (size or math.inf)
    if 0.9 < ratio < 1.1:
        yield causes.OPPOSITE if len(key) > 1 else causes.OPPOSITE_NUMBER, _times(-1.0, fit.key)
    for words, factor in found.items():
        if 0.9 * factor < ratio < 1.1 * factor:
            yield causes.multiplied(words, factor, True), _times(factor, fit.key)
        if 0.9 / factor < ratio < 1.1 / factor:
            yield causes.multiplied(words, factor, False), _times(1 / factor, fit.key)


def _times(factor, points):
    return tuple(tuple(factor * x for x in point) for point in points)


def of_matrix(fit: Fit) -> Models:
    """A matrix transposed, or with products of inertia of the other sign."""
    yield causes.TRANSPOSED, _ordered((0, 3, 6, 1, 4, 7, 2, 5, 8), fit.key)
    yield causes.OFF_DIAGONAL, _signed((1, -1, -1, -1, 1, -1, -1, -1, 1), fit.key)


def of_interval(fit: Fit) -> Models:
    """The bounds of an interval exchanged."""
    yield causes.BOUNDS, _ordered((1, 0), fit.key)


def of_vector(fit: Fit) -> Models:
    """The key with components reversed, left out or exchanged, as the first point suggests."""
    if fit.index is not None:
        yield from _signs(fit)
        yield from exchanged(fit)


def _signs(fit):
    """Some components reversed, or one left out, where the others are right."""
    given, key, size = fit.first
    near = fit.rtol * size + fit.rounding
    there = [n for n, k in enumerate(key) if abs(k) > NOISE * size]
    off = [n for n in there if abs(given[n] - key[n]) > min(near, abs(key[n]) / 2)]
    if not 0 < len(off) < max(len(there), 2):
        return
    if all(abs(given[n] + key[n]) <= near for n in off):
        signs = [-1 if n in off else 1 for n in range(len(key))]
        yield causes.reversed_components(off), _signed(signs, fit.key)
    if len(off) == 1 and abs(given[off[0]]) <= NOISE * size and any(given):
        kept = [0 if n in off else 1 for n in range(len(key))]
        yield causes.left_out_component(off[0]), _signed(kept, fit.key)


def _signed(signs, points):
    return tuple(tuple(s * x for s, x in zip(signs, p, strict=True)) for p in points)


def exchanged(fit: Fit) -> Models:
    """Two components of a vector exchanged, or all three."""
    given, key, size = fit.first
    near = fit.rtol * size + fit.rounding
    if abs(sum(given) - sum(key)) > 3 * near:
        return
    for order in ((1, 0, 2), (2, 1, 0), (0, 2, 1), (1, 2, 0), (2, 0, 1)):
        if all(abs(given[n] - key[m]) <= near for n, m in enumerate(order)):
            moved = [n for n in range(3) if order[n] != n]
            yield causes.exchanged_components(moved), _ordered(order, fit.key)


def _ordered(order, points):
    return tuple(tuple(point[n] for n in order) for point in points)


def rates_as_scalars(fit: Fit, rates: Sequence[Points]) -> Models:
    """The sum of the sizes of ``rates``, a list of points of each, along the axis of each."""
    if len(rates) < 2 or fit.index is None:
        return
    given, _, _ = fit.first
    if not math.isclose(
        sum(math.hypot(*rate[fit.index]) for rate in rates), math.hypot(*given), rel_tol=0.01
    ):
        return
    sizes = [[math.hypot(*point) for point in rate] for rate in rates]
    sums = [sum(column) for column in zip(*sizes, strict=True)]
    for points, own in zip(rates, sizes, strict=True):
        if all(own):
            scaled = [s / size for s, size in zip(sums, own, strict=True)]
            yield (
                causes.AS_SCALARS,
                tuple(tuple(x * f for x in p) for p, f in zip(points, scaled, strict=True)),
            )


def pairs(
    fit: Fit, listed: Sequence[tuple[Cause, Points]]
) -> Iterator[tuple[Cause, Cause, Points]]:
    """(cause, cause, points) of two listed mistakes at once, in vectors, where each changes the key
    by an amount of its own (as terms do).
    """
    if len(listed) < 2 or fit.index is None or len(fit.first[1]) < 2:
        return
    index, (given, key, size) = fit.index, fit.first
    near = NUMBER_RTOL * (math.hypot(*given) + size) + fit.rounding
    changed = [
        (cause, x, [a - b for a, b in zip(x[index], key, strict=True)]) for cause, x in listed
    ]
    for (first, a, da), (second, b, db) in combinations(changed, 2):
        if all(abs(k + p + q - g) <= near for k, p, q, g in zip(key, da, db, given)):  # noqa: B905
            together = tuple(
                tuple(x + y - k for x, y, k in zip(*point, strict=True))
                for point in zip(a, b, fit.key, strict=True)
            )
            yield first, second, together


def is_rounded(given: Points, key: Points) -> bool:
    """True if an answer is the key rounded to one or two digits, or at one decimal place."""
    if len(key) != 1:
        return False
    size = math.hypot(*key[0])
    if not math.dist(given[0], key[0]) <= 0.34 * size:  # 1.5 rounded to 2 is the most
        return False
    if most_digits(given[0]) >= DIGITS:
        return False
    least = min(written(x)[1] for x in given[0] if x)
    # round-off for zero, and the 0 that is written for it
    components = [
        (k if abs(k) > NOISE * size else 0.0, x) for k, x in zip(key[0], given[0], strict=True)
    ]
    if any(k and not x for k, x in components):
        return False  # left out, more likely
    ways = (
        lambda k: float(f"{k:.1g}"),
        lambda k: float(f"{k:.2g}"),
        lambda k: round(k, -least),
    )
    return any(all(math.isclose(way(k), x, rel_tol=NOISE) for k, x in components) for way in ways)

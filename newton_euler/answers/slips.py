"""Slips that are made in any problem and that need nothing but the key: a factor of a unit, a sign,
components exchanged, two listed mistakes at once. Each is [(text, points)] for a
:class:`~newton_euler.answers.fit.Fit`.
"""

import math
from functools import cache
from itertools import combinations

from ..algebra.units import unit
from .fit import written
from .tolerance import NOISE

OPPOSITE = "has the opposite sign in every component: check the direction"
OPPOSITE_NUMBER = "has the opposite sign: check the direction"
TRANSPOSED = "writes the transposed matrix: rows for columns"
OFF_DIAGONAL = "has the opposite sign in every entry off the diagonal"
BOUNDS = "has its bounds in the wrong order"
OTHER_ORDER = "has its components in another order"
AS_SCALARS = "adds the rates of turning as numbers, as if about one axis, instead of as vectors"
ROUNDED = "rounds the right answer too far: give three significant figures or more"
ORDINALS = ("first", "second", "third")
NUMBER_RTOL = 1e-3  # a single number is met by chance much sooner than a vector
LISTED_RTOL = 2e-3  # of a single number that a listed mistake gives: there are few of these
ANGLES = {
    "revolutions against radians": 2 * math.pi, "degrees against radians": 180 / math.pi,
    "rev/min against rad/s": 30 / math.pi,
}  # fmt: skip
LENGTHS = {
    "m against mm": 1000.0, "ft against in": 12.0, "in against mm": 25.4,
    "ft against m": 1 / 0.3048, "ft against mm": 304.8,
}  # fmt: skip
WEIGHTS = {
    "weight against mass (g = 9.81)": 9.81, "weight against mass (g = 32.2)": 32.2,
}  # fmt: skip


@cache
def factors(kind, stated_in):
    """{text: factor} of the units that an answer of this kind, stated in this unit, may be in."""
    found = {"a factor of 2": 2.0, "revolutions against radians": 2 * math.pi}
    if kind.endswith("expression"):
        return found  # a formula is in no unit
    found |= ANGLES
    mass, length, _ = unit(stated_in).dimension.powers
    if length:
        found |= {text: factor ** abs(float(length)) for text, factor in LENGTHS.items()}
    return found | WEIGHTS if mass else found


def multiples(fit, found):
    """The key times the factors that may fit, found by the first point of the answer."""
    if fit.index is None:
        return
    given, key, size = fit.first
    ratio = math.hypot(*given) / (size or math.inf)
    if 0.9 < ratio < 1.1:
        yield OPPOSITE if len(key) > 1 else OPPOSITE_NUMBER, _times(-1.0, fit.key)
    for text, factor in found.items():
        if 0.9 * factor < ratio < 1.1 * factor:
            yield f"is {factor:.4g} times too large ({text})", _times(factor, fit.key)
        if 0.9 / factor < ratio < 1.1 / factor:
            yield f"is {factor:.4g} times too small ({text})", _times(1 / factor, fit.key)


def _times(factor, points):
    return tuple(tuple(factor * x for x in point) for point in points)


def components(fit, kind):
    """The key with components turned, exchanged or left out, as the first point suggests."""
    if fit.index is None or kind in ("number", "expression"):
        return
    if kind.startswith("matrix"):
        yield from _entries(fit)
    elif kind == "interval":
        yield BOUNDS, _ordered((1, 0), fit.key)
    else:
        yield from _signs(fit)
        yield from _orders(fit)


def _entries(fit):
    yield TRANSPOSED, _ordered((0, 3, 6, 1, 4, 7, 2, 5, 8), fit.key)
    signs = (1, -1, -1, -1, 1, -1, -1, -1, 1)
    yield OFF_DIAGONAL, _signed(signs, fit.key)


def _signs(fit):
    """Some components turned, or one left out, where the others are right."""
    given, key, size = fit.first
    near = fit.rtol * size + fit.rounding
    there = [n for n, k in enumerate(key) if abs(k) > NOISE * size]
    off = [n for n in there if abs(given[n] - key[n]) > min(near, abs(key[n]) / 2)]
    if not 0 < len(off) < max(len(there), 2):
        return
    names = " and ".join(ORDINALS[n] for n in off)
    if all(abs(given[n] + key[n]) <= near for n in off):
        signs = [-1 if n in off else 1 for n in range(len(key))]
        plural = "s" if len(off) > 1 else ""
        yield f"has the opposite sign in its {names} component{plural}", _signed(signs, fit.key)
    if len(off) == 1 and abs(given[off[0]]) <= NOISE * size:
        kept = [0 if n in off else 1 for n in range(len(key))]
        yield f"leaves out its {names} component", _signed(kept, fit.key)


def _signed(signs, points):
    return tuple(tuple(s * x for s, x in zip(signs, p, strict=True)) for p in points)


def _orders(fit):
    """Two components exchanged, or all three."""
    given, key, size = fit.first
    near = fit.rtol * size + fit.rounding
    if len(key) != 3 or abs(sum(given) - sum(key)) > 3 * near:
        return
    for order in ((1, 0, 2), (2, 1, 0), (0, 2, 1), (1, 2, 0), (2, 0, 1)):
        if all(abs(given[n] - key[m]) <= near for n, m in enumerate(order)):
            moved = [ORDINALS[n] for n in range(3) if order[n] != n]
            exchanged = f"exchanges its {' and '.join(moved)} components"
            yield exchanged if len(moved) == 2 else OTHER_ORDER, _ordered(order, fit.key)


def _ordered(order, points):
    return tuple(tuple(point[n] for n in order) for point in points)


def rates_as_scalars(fit, rates):
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
    for rate, own in zip(rates, sizes, strict=True):
        if all(own):
            scaled = [s / size for s, size in zip(sums, own, strict=True)]
            yield (
                AS_SCALARS,
                tuple(tuple(x * f for x in point) for point, f in zip(rate, scaled, strict=True)),
            )


def pairs(fit, listed):
    """(text, text, points) of two listed mistakes at once, in vectors, where each changes the key
    by an amount of its own (as terms do).
    """
    if len(listed) < 2 or fit.index is None or len(fit.first[1]) < 2:
        return
    index, (given, key, size) = fit.index, fit.first
    near = NUMBER_RTOL * (math.hypot(*given) + size) + fit.rounding
    changed = [(text, x, [a - b for a, b in zip(x[index], key, strict=True)]) for text, x in listed]
    for (first, a, da), (second, b, db) in combinations(changed, 2):
        if all(abs(k + p + q - g) <= near for k, p, q, g in zip(key, da, db, given)):  # noqa: B905
            both = tuple(
                tuple(x + y - k for x, y, k in zip(*point, strict=True))
                for point in zip(a, b, fit.key, strict=True)
            )
            yield first, second, both


def is_rounded(given, key):
    """True if an answer is the key rounded to one or two digits, or at one decimal place."""
    if len(key) != 1:
        return False
    (given,), (key,) = given, key
    size = math.hypot(*key)
    if not math.dist(given, key) <= 0.34 * size:  # 1.5 rounded to 2 is the most
        return False
    digits, places = zip(*(written(x) for x in given if x), strict=True)
    if max(digits) > 2:
        return False
    # round-off for zero, and the 0 that is written for it
    pairs = [(k if abs(k) > NOISE * size else 0.0, x) for k, x in zip(key, given, strict=True)]
    if any(k and not x for k, x in pairs):
        return False  # left out, more likely
    ways = (
        lambda k: float(f"{k:.1g}"),
        lambda k: float(f"{k:.2g}"),
        lambda k: round(k, -min(places)),
    )
    return any(all(math.isclose(way(k), x, rel_tol=1e-9) for k, x in pairs) for way in ways)

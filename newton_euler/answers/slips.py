"""Slips that can be made in any problem and need nothing but the key: a factor of a unit, a sign,
components exchanged. Each function yields (cause, points) for a
:class:`~newton_euler.answers.fit.Fit` that has a first point.
"""

import math
from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction
from functools import cache
from itertools import combinations

from ..algebra.language import Words
from ..algebra.units import Dimension, unit
from . import causes
from .causes import Cause
from .fit import Fit, digits_written, most_digits
from .tolerance import DIGITS, NOISE, Points

Models = Iterator[tuple[Cause, Points]]

PURE: dict[str, float] = {
    Words("a factor of 2"): 2.0,
    Words("revolutions against radians"): 2 * math.pi,
}
BARE = {  # factors that say little about their cause
    "3": 3.0, "4": 4.0, "3/2": 1.5, "sqrt(2)": 2**0.5, "pi": math.pi,
}  # fmt: skip
TENS = {Words("one decimal place"): 10.0, Words("two decimal places"): 100.0}
ANGLES: dict[str, float] = {
    Words("degrees against radians"): 180 / math.pi,
    Words("rev/min against rad/s"): 30 / math.pi,
}
LENGTHS: dict[str, float] = {
    Words("m against mm"): 1000.0, Words("ft against in"): 12.0, Words("in against mm"): 25.4,
    Words("ft against m"): 1 / 0.3048, Words("ft against mm"): 304.8,
}  # fmt: skip
WEIGHTS: dict[str, float] = {
    Words("weight against mass (g = 9.81)"): 9.81, Words("weight against mass (g = 32.2)"): 32.2,
    Words("N against lb"): 4.4482216,
}  # fmt: skip


@cache
def factors(stated_in: str) -> Mapping[str, float]:
    """{words: factor} of the units in which an answer in this unit may be given by mistake."""
    found = PURE | ANGLES
    if unit(stated_in).factor == Fraction(1, 100) and unit(stated_in).dimension == Dimension():
        found |= {Words("a fraction against percent"): 100.0}
    mass, length, _ = unit(stated_in).dimension.powers
    if length:
        power = abs(float(length))
        found |= {words: factor**power for words, factor in LENGTHS.items()}
        less = Words("{units}, in one factor too few")
        lengths = LENGTHS if power > 1 else {}
        found |= {Words(less, units=words): f ** (power - 1) for words, f in lengths.items()}
    return found | WEIGHTS if mass else found


def multiples(fit: Fit, found: Mapping[str, float], is_along_axes: bool) -> Models:
    """The key times the factors that may fit, chosen by the first point of the answer."""
    ratio = _ratio(fit)
    if 0.9 < ratio < 1.1:
        yield causes.OPPOSITE if is_along_axes else causes.OPPOSITE_NUMBER, fit.times(-1.0)
    yield from _factors(fit, ratio, found)


def bare(fit: Fit) -> Models:
    """The key times a simple number, which many slips give."""
    ratio = _ratio(fit)
    for name, _, large, times in _both_ways(BARE):
        if 0.9 * times < ratio < 1.1 * times:
            yield causes.bare(name, large), fit.times(times)
    yield from _factors(fit, ratio, TENS)


def _ratio(fit):
    given, _, size = fit.first
    return math.hypot(*given) / (size or math.inf)


def of_powers(fit: Fit, is_vector: bool) -> Models:
    """A power of ten; the square, the root and the inverse of the key; a vector with components
    left out.
    """
    yield from _factors(fit, _ratio(fit), TENS)
    if len(fit.first[1]) > 2:
        if is_vector:
            yield from left_out(fit)
            sizes = zip(fit.key, fit.sizes, strict=True)
            yield causes.UNIT_VECTOR, tuple(tuple(x / (n or 1) for x in k) for k, n in sizes)
        return
    for cause, power in (causes.SQUARED, 2.0), (causes.ROOT, 0.5), (causes.INVERTED, -1.0):
        yield cause, tuple(tuple(_power(x, power) for x in point) for point in fit.key)


def _power(x, power):
    try:
        return abs(x) ** power if x or power > 0 else math.inf
    except OverflowError:
        return math.inf


def of_components(fit: Fit, is_vector: bool) -> Models:
    """A factor of some components of a vector, where the others are right."""
    off, (given, key, _) = _off(fit) if is_vector else [], fit.first
    if not 0 < len(off) < sum(map(bool, key)) or not all(key[n] for n in off):
        return
    for words, factor, large, f in _both_ways(PURE):
        if all(0.99 < given[n] / (f * key[n]) < 1.01 for n in off):
            scales = [f if m in off else 1.0 for m in range(3)]
            yield causes.component_multiplied(off, words, factor, large), _signed(scales, fit.key)


def of_none(fit: Fit, is_vector: bool) -> Models:
    """Components where there are none, of a vector of which all others are right."""
    off = _off(fit) if is_vector else []
    if 0 < len(off) < 3 and all(abs(fit.first[1][n]) <= NOISE * fit.first[2] for n in off):
        yield causes.added_components(off), fit.given


def _off(fit):
    """The components of a vector that are not those of the key, at the first point."""
    given, key, size = fit.first
    return [n for n in range(3) if abs(given[n] - key[n]) > fit.rtol * size]


def _factors(fit, ratio, found):
    for words, factor, large, f in _both_ways(found):
        if 0.9 * f < ratio < 1.1 * f:
            yield causes.multiplied(words, factor, large), fit.times(f)


def _both_ways(found):
    """(words, factor, whether it is too large, by how much) of each factor and its inverse."""
    for words, factor in found.items():
        yield from ((words, factor, True, factor), (words, factor, False, 1 / factor))


def of_matrix(fit: Fit) -> Models:
    """A matrix transposed; one of inertia, which is symmetric, with other moments, or products of
    inertia of the other sign.
    """
    transposed = _ordered((0, 3, 6, 1, 4, 7, 2, 5, 8), fit.key)
    yield causes.TRANSPOSED, transposed
    pairs = zip(transposed, fit.key, strict=True)
    if not all(math.dist(x, y) <= NOISE * math.hypot(*x) for x, y in pairs):
        return
    for cause, own, others in (causes.POLAR, 0.5, 0.5), (causes.PLANAR, -0.5, 0.5):
        yield cause, tuple(_with_moments(point, own, others) for point in fit.key)
    yield causes.OFF_DIAGONAL, _signed((1, -1, -1, -1, 1, -1, -1, -1, 1), fit.key)
    yield causes.DIAGONAL_ONLY, _signed((1, 0, 0, 0, 1, 0, 0, 0, 1), fit.key)
    yield from _of_one_entry(fit)


def _with_moments(point, own, others):
    """A matrix in which each moment is the sum of these parts of itself and of the two others."""
    whole = others * sum(point[::4])
    return tuple(whole + (own - others) * x if n % 4 == 0 else x for n, x in enumerate(point))


def _of_one_entry(fit):
    """An entry left out or reversed, with its mirror image; two moments or products exchanged."""
    for n in range(3):
        yield causes.entry_left_out(n, n), _signed([x != 4 * n for x in range(9)], fit.key)
    for n, m in combinations(range(3), 2):
        pair = 3 * n + m, 3 * m + n
        for cause, factor in ((causes.entry_left_out(n, m), 0), (causes.entry_reversed(n, m), -1)):
            if fit.first[1][pair[0]]:
                yield cause, _signed([factor if x in pair else 1 for x in range(9)], fit.key)
        k = 3 - n - m
        for one, other in (((n, n), (m, m)), ((n, k), (m, k))):
            (a1, a2), (b1, b2) = ((3 * i + j, 3 * j + i) for i, j in (one, other))
            order = {a1: b1, a2: b2, b1: a1, b2: a2}
            moved = [order.get(x, x) for x in range(9)]
            points = _ordered(moved, fit.key)
            cause = causes.exchanged_entries(one, other)
            yield cause, points
            if one != (n, n):
                signs = [-1 if x in order else 1 for x in range(9)]
                if two := causes.both(cause, causes.OFF_DIAGONAL):
                    yield two, _signed(signs, points)


def of_interval(fit: Fit) -> Models:
    """The bounds of an interval exchanged."""
    yield causes.BOUNDS, _ordered((1, 0), fit.key)


def of_vector(fit: Fit) -> Models:
    """The key with components reversed, left out or exchanged, as the first point suggests."""
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
    if len(off) == 1:
        yield from left_out(fit)
    yield from _moved(fit, near)


def _moved(fit, near):
    """One component added to another, with zero in its place."""
    given, key, size = fit.first
    places = range(len(key))
    zeros = [n for n in places if abs(given[n]) <= NOISE * size < abs(key[n])]
    for n, m in ((n, m) for n in zeros for m in places if m != n):
        rest = all(abs(given[k] - key[k]) <= near for k in {0, 1, 2} - {n, m})
        for sign in (1, -1) if rest else ():
            if abs(given[m] - key[m] - sign * key[n]) <= near and abs(key[m]) > NOISE * size:
                moved = [[*point] for point in fit.key]
                for point in moved:
                    point[n], point[m] = 0.0, point[m] + sign * point[n]
                yield causes.moved_component(n, m), tuple(map(tuple, moved))


def left_out(fit: Fit) -> Models:
    """The key without the components that are zero in the answer, unless all are."""
    given, key, size = fit.first
    off = [n for n, k in enumerate(key) if abs(k) > NOISE * size >= abs(given[n])]
    if off and any(given):
        kept = [0 if n in off else 1 for n in range(len(key))]
        yield causes.left_out_components(off), _signed(kept, fit.key)


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
            return


def _ordered(order, points):
    return tuple(tuple(point[n] for n in order) for point in points)


def rates_as_scalars(fit: Fit, rates: Sequence[Points]) -> Models:
    """The sum of the sizes of ``rates``, a list of points of each, along the axis of each."""
    if len(rates) < 2:
        return
    whole = sum(math.hypot(*rate[fit.index]) for rate in rates)
    if not math.isclose(whole, math.hypot(*fit.first[0]), rel_tol=0.01):
        return
    sizes = [[math.hypot(*point) for point in rate] for rate in rates]
    sums = [sum(column) for column in zip(*sizes, strict=True)]
    for points, own in zip(rates, sizes, strict=True):
        if all(own):
            scaled = [(p, s / size) for p, s, size in zip(points, sums, own, strict=True)]
            yield causes.AS_SCALARS, tuple(tuple(x * f for x in p) for p, f in scaled)


def is_rounded(given: Points, key: Points) -> bool:
    """True if an answer is the key rounded to one or two digits, or at one decimal place."""
    if len(key) != 1:
        return False
    size = math.hypot(*key[0])
    if not math.dist(given[0], key[0]) <= 0.34 * size:  # 1.5 rounded to 2 is the most
        return False
    if most_digits(given[0]) >= DIGITS:
        return False
    least = min(digits_written(x)[1] for x in given[0] if x)
    # round-off counts as zero, for which a student writes 0
    right = (k if abs(k) > NOISE * size else 0.0 for k in key[0])
    components = [*zip(right, given[0], strict=True)]
    if any(k and not x for k, x in components):
        return False  # left out, more likely
    ways = (lambda k: float(f"{k:.1g}"), lambda k: float(f"{k:.2g}"), lambda k: round(k, -least))
    return any(all(math.isclose(way(k), x, rel_tol=NOISE) for k, x in components) for way in ways)

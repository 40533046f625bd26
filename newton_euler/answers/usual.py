"""Numbers by which students know a body: the factor of its moment of inertia, the place of its
centre of mass. A formula with such a number in place of the right one is that of another body.
"""

import math
from collections.abc import Iterator, Mapping
from fractions import Fraction
from typing import Any

from ..algebra.language import Words
from ..algebra.late import is_here, np
from ..algebra.units import Dimension
from .causes import Cause, in_components, usual
from .fit import Fit
from .tolerance import FORMULA_FIT, NOISE, Points

INERTIA, LENGTH = Dimension(1, 2), Dimension(0, 1)
MOMENTS: dict[Fraction, str] = {
    Fraction(1): Words("a ring"),
    Fraction(1, 2): Words("a disk about its axis"),
    Fraction(1, 4): Words("a disk about a diameter"),
    Fraction(1, 3): Words("a rod about its end"),
    Fraction(1, 12): Words("a rod or rectangle about its centre"),
    Fraction(2, 5): Words("a solid sphere"),
    Fraction(2, 3): Words("a spherical shell"),
}  # fmt: skip
OTHER_MOMENTS: dict[Fraction, str] = {
    Fraction(1, 6): Words("a triangle about a side"),
    Fraction(1, 18): Words("a triangle about its centre"),
    Fraction(1, 36): Words("the second moment of area of a triangle"),
    Fraction(3, 10): Words("a cone about its axis"),
    Fraction(3, 2): Words("a disk about a point of its rim"),
    Fraction(7, 5): Words("a solid sphere about a tangent"),
    Fraction(2): Words("a ring about a point of it"),
}  # fmt: skip
CENTRES: dict[Fraction | float, str] = {
    Fraction(1, 2): Words("a rod or half a spherical shell"),
    Fraction(1, 3): Words("a triangle or a conical shell"),
    Fraction(2, 3): Words("a triangle, from its apex"),
    Fraction(1, 4): Words("a cone"),
    Fraction(3, 4): Words("a cone, from its apex"),
    Fraction(3, 8): Words("a solid half sphere"),
    4 / (3 * math.pi): Words("half a disk"),
    2 / math.pi: Words("half a ring"),
}  # fmt: skip


def of_other_bodies(
    fit: Fit, dimension: Dimension, symbols: Mapping[str, Any], is_place: bool
) -> Iterator[tuple[Cause, Points]]:
    """[(cause, points)] of a formula with the number of another body, where the right one is a
    number times powers of ``symbols``; ``is_place``: it is a position vector.
    """
    of: dict[Any, str] = {}
    if dimension == INERTIA:
        of = MOMENTS | OTHER_MOMENTS
    elif dimension == LENGTH and is_place:
        of = CENTRES
    found = _multiple(fit) if of and len(fit.key) > 1 else None
    if found is None or not is_here("numpy"):  # on a page of the site
        return
    off, ratio = found
    of_moments = is_place or all(n % 4 == 0 for n in off)
    own = _number([point[off[0]] for point in fit.key], symbols, (1,) if is_place else (1, 2))
    if own is None or not of_moments or (is_place and not _known(own, of)):
        return
    for number, body in _known(own * ratio, of):
        times = float(number) / own
        points = tuple(
            tuple(times * x if n in off else x for n, x in enumerate(point)) for point in fit.key
        )
        cause = usual(_spelled(number), body, is_place)
        there = [n for n, x in enumerate(fit.first[1]) if x]
        yield (cause if len(off) == len(there) else in_components(cause, off, fit.first[1])), points


def _known(number, of):
    """[(number, body)] of the table that is this one, as closely as formulas are compared."""
    return [(n, b) for n, b in of.items() if math.isclose(n, abs(number), rel_tol=FORMULA_FIT)]


def _spelled(number):
    if isinstance(number, Fraction):
        return str(number)
    part = Fraction(number * math.pi).limit_denominator(9)
    below = f"({part.denominator}*pi)" if part.denominator > 1 else "pi"
    return f"{part.numerator}/{below}"


def _multiple(fit):
    """(the components that are wrong, their one ratio to the right ones); None without one."""
    if fit.index is None:
        return None
    given, key, size = fit.first
    off = [n for n, (x, k) in enumerate(zip(given, key, strict=True)) if abs(x - k) > NOISE * size]
    ratios = [
        x[n] / k[n] if k[n] else math.inf
        for x, k in zip(fit.given, fit.key, strict=True)
        if all(map(math.isfinite, k))
        for n in off
    ]
    alike = ratios and all(abs(r - ratios[0]) <= fit.rtol * abs(ratios[0]) for r in ratios)
    return (off, ratios[0]) if alike and math.isfinite(ratios[0]) else None


def _number(column, symbols, powers):
    """The number in front of these powers of symbols; None of another formula."""
    rows = [np.broadcast_to(np.log(np.abs(x)), len(column)) for x in symbols.values()]
    matrix = np.column_stack([np.ones(len(column)), *rows])
    with np.errstate(all="ignore"):
        wanted = np.log(np.abs(column))
    if matrix.shape[1] > len(column) or not np.isfinite(wanted).all():
        return None
    (number, *found), *_ = np.linalg.lstsq(matrix, wanted, rcond=None)
    exact = abs(matrix @ [number, *np.round(found)] - wanted).max() < NOISE
    is_of_powers = tuple(sorted(filter(None, np.round(found)))) == powers
    return math.exp(number) if exact and is_of_powers else None

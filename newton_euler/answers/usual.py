"""Numbers by which students know a body: the factor of its moment of inertia, the place of its
centre of mass. A formula with such a number in place of the right one is that of another body.
"""

import math
from collections.abc import Iterator, Mapping
from fractions import Fraction
from functools import lru_cache
from typing import Any, NamedTuple

from ..algebra.language import Words
from ..algebra.late import is_here, np
from ..algebra.units import Dimension
from .causes import Cause, of_number, of_term, powers, usual
from .fit import Fit, mixed
from .kinds import Kind
from .tolerance import FORMULA_FIT, NOISE, Points

INERTIA, LENGTH = Dimension(1, 2), Dimension(0, 1)
SIMPLE = 12  # the largest number, and denominator, of a simple factor
MOMENTS: dict[Fraction, str] = {
    Fraction(1): Words("a ring"),
    Fraction(1, 2): Words("a disk about its axis"),
    Fraction(1, 4): Words("a disk about a diameter"),
    Fraction(1, 3): Words("a rod or rectangle about its end"),
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
    fit: Fit, dimension: Dimension, symbols: Mapping[str, Any], kind: Kind
) -> Iterator[tuple[Cause, Points]]:
    """[(cause, points)] of a formula with the number of another body, in all components that are
    wrong or in each by itself, where the right one is a number times powers of ``symbols``.
    """
    is_place = kind.is_vector
    of: dict[Any, str] = {INERTIA: MOMENTS | OTHER_MOMENTS}.get(dimension, {})
    of = CENTRES if dimension == LENGTH and is_place else of
    off = _off(fit) if of else []
    found: dict[Any, list[int]] = {}
    for n in [n for n in off if n % 4 == 0] if kind.is_matrix else off:
        own = _monomial([x[n] for x in fit.key], symbols)
        ratio = _monomial(_ratios(fit, n), symbols)
        if not own or not ratio or ratio.powers or own.powers != ((1,) if is_place else (1, 2)):
            continue
        known = _known(own.number, of)
        for number in _known(own.number * ratio.number, of):
            if number not in known and (known or not is_place):
                found.setdefault(number, []).append(n)
    for number, every in found.items():
        cause = usual(_spelled(number), of[number], is_place)
        # two moments are evidence even where products of inertia are wrong, too
        if every == off or (not is_place and len(every) > 1):
            yield _in(every, cause, fit, kind), fit.given
        else:
            for n in every:
                yield _in([n], cause, fit, kind), mixed(fit.given, fit.key, [n])


def of_other_powers(fit: Fit, symbols: Mapping[str, Any], kind: Kind) -> Iterator[Cause]:
    """Why an answer is wrong that is the right one times powers of ``symbols``, in every component
    that is wrong the same.
    """
    off = _off(fit)
    ratios = [_ratios(fit, n) for n in off]
    if not ratios or max(ratios[0]) - min(ratios[0]) <= NOISE * abs(ratios[0][0]):
        return  # a number has no powers
    first, *others = (_monomial(column, symbols) for column in ratios)
    if first and first.names and all(x and x[1:] == first[1:] for x in others):
        yield _in(off, powers(first.names), fit, kind)


def of_a_number(fit: Fit, kind: Kind) -> Iterator[Cause]:
    """Why a formula is wrong that is a simple number times the right one, in every component that
    is wrong the same.
    """
    off = _off(fit)
    ratios = [x for n in off for x in _ratios(fit, n)]
    first = ratios[0] if ratios else math.nan
    near = Fraction(first if math.isfinite(first) else 0).limit_denominator(SIMPLE)
    if 0 < abs(near) <= SIMPLE and all(abs(x - near) <= FORMULA_FIT * abs(near) for x in ratios):
        yield _in(off, of_number(str(near)), fit, kind)


def of_one_term(fit: Fit, symbols: Mapping[str, Any], kind: Kind) -> Iterator[Cause]:
    """Why a formula is wrong that differs from the right one by a number times powers of
    ``symbols``, in one component.
    """
    off = _off(fit)
    if len(off) != 1 or len(fit.key) == 1:
        return
    (n,) = off
    ratios = _ratios(fit, n)
    if not max(ratios) - min(ratios) > NOISE * abs(ratios[0]):
        return  # another number in the only term
    gaps = [x[n] - k[n] for x, k in zip(fit.given, fit.key, strict=True)]
    is_one = all(x > 0 for x in gaps) or all(x < 0 for x in gaps)
    found = _monomial(gaps, symbols) if is_one else None
    if found and found.names:
        yield _in(off, of_term(found.names), fit, kind)


def _in(places, cause, fit, kind):
    """The cause, in some components if others are right."""
    _, key, size = fit.first
    is_all = {*places}.issuperset(n for n, x in enumerate(key) if abs(x) > NOISE * size)
    return cause if is_all else kind.in_part(cause, places, key)


class _Monomial(NamedTuple):
    """A number times powers of symbols: the powers in order, the names that have one."""

    number: float
    powers: tuple[float, ...]
    names: tuple[str, ...]


def _known(number, of):
    """The numbers of the table that are this one, as closely as formulas are compared."""
    return [n for n in of if math.isclose(n, abs(number), rel_tol=FORMULA_FIT)]


def _spelled(number):
    if isinstance(number, Fraction):
        return str(number)
    part = Fraction(number * math.pi).limit_denominator(9)
    below = f"({part.denominator}*pi)" if part.denominator > 1 else "pi"
    return f"{part.numerator}/{below}"


def _off(fit):
    """The components that are wrong, of a formula that is compared at several points."""
    none = fit.index is None or len(fit.key) == 1 or not is_here("numpy")  # a page of the site
    return [] if none else fit.off()


def _ratios(fit, n):
    pairs = zip(fit.given, fit.key, strict=True)
    return [x[n] / k[n] if k[n] else math.nan for x, k in pairs]


def _monomial(column, symbols):
    """The :class:`_Monomial` with these values, as closely as numbers are typed, or None."""
    with np.errstate(all="ignore"):  # a student may write 0
        wanted = np.log(np.abs(column))
    values = (np.ravel(x).tolist() for x in symbols.values())
    rows = tuple(tuple(x * (len(column) // len(x))) for x in values)  # one is the same at all
    logs, inverse = _logarithms(rows, len(column))
    if logs is None or not np.isfinite(wanted).all():
        return None
    found = np.round(2 * (inverse @ wanted)[1:]) / 2
    gaps = (wanted - logs[:, 1:] @ found).tolist()
    if max(gaps) - min(gaps) > NOISE:
        return None
    names = tuple(n for n, power in zip(symbols, found, strict=True) if power)
    with np.errstate(all="ignore"):  # a student may write 1e307
        number = float(np.exp(sum(gaps) / len(gaps)))
    return _Monomial(number, tuple(sorted(filter(None, found.tolist()))), names)


@lru_cache(maxsize=64)  # shared by the answers of a problem
def _logarithms(rows, count):
    """Logarithms of the symbols beside ones, and the pseudo-inverse; None of too few points."""
    with np.errstate(all="ignore"):
        logs = np.log(np.abs(np.array([[math.e] * count, *rows]))).T
    if logs.shape[1] >= count or not np.isfinite(logs).all():
        return None, None
    return logs, np.linalg.pinv(logs)

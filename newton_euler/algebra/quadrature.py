"""Integrals with an estimated error: adaptive, of floats, and in several variables."""

from collections.abc import Callable, Sequence
from heapq import heappush, heapreplace
from itertools import pairwise
from sys import float_info
from typing import Any

from . import scalars
from .integrals import WorkError, by_formula, gauss, integral
from .late import np
from .places import at_a_place, raised_by_the_caller
from .scalars import ZERO, Scalar, SingularError, epsilon, max_abs, scalar, short

INTERVALS = 400  # intervals: the most of an adaptive integral; each takes 21 values
# subdivisions of an adaptive cubature by dimension; each one makes 2, 4 or 8 boxes of 21^n places
BOXES = {1: 4000, 2: 400, 3: 40}
# places of the two Gauss rules on an interval, whose difference is the error of the coarser
PLACES = 10, 21
# parts in which each piece begins, so that of their 21 places none is farther from the next than
# 1.1 % of it; odd, since an integrand has no value in the middle more often than elsewhere
PARTS = 7
# errors of a formula where it has no value; any other is the caller's
NO_VALUE = ZeroDivisionError, OverflowError, FloatingPointError, SingularError


def quadrature(
    f: Callable[[Scalar], Scalar],
    start: Scalar,
    end: Scalar,
    rtol: float = 1e-10,
    exact: bool = False,
    breaks: Sequence[Scalar] = (),
) -> tuple[Scalar, Scalar]:
    """(integral of ``f``, its estimated error); arguments as in :func:`.work.work_integral`."""
    pieces = [_piece(f, a, b, rtol, exact) for a, b in pairwise((start, *breaks, end))]
    return sum((value for value, _ in pieces), ZERO), sum(error for _, error in pieces)


def _piece(f, start, end, rtol, exact):
    """(value, estimated error) of one smooth piece."""
    if exact:
        return by_formula(lambda x: (f(x),), start, end)[0], 0.0
    kinds = start, end, _value(f, start + (end - start) / 32)
    if not all(map(scalars.is_numeric, kinds)) or any(hasattr(x, "_parts") for x in kinds):
        return integral(f, start, end), 0.0
    width = end - start
    samples = [_finite(f, start + width * (n + 0.5) / 16) for n in range(16)]
    scale = max_abs(scalar(width)) * sum(map(max_abs, samples)) / 16
    one = samples[0] + width  # an array, or an mpf of more digits than a float?
    if getattr(one, "shape", ()) or epsilon(one) < 2.0**-53:
        try:
            value = integral(lambda x: _finite(f, x), start, end)
        except SingularError as problem:
            if raised_by_the_caller(problem):
                raise
            raise WorkError(
                f"the integral from {start!r} to {end!r} does not converge; divide it with "
                "breaks=(...) where the force has a corner"
            ) from None
        # the rule stops when its last but one value has half of the digits: mostly this one has all
        return scalars.to_plain(value), 1e-3 * scale * float(scalars.sqrt(epsilon(value)))
    value, error = _adaptive(f, float(start), float(end), rtol, scale)
    # a component that is zero by structure has no dimension, and can be added to the others
    return (ZERO if all(s is ZERO for s in samples) and value == 0 else value), error


def _value(f, x):
    try:
        return scalar(f(x))
    except NO_VALUE as problem:
        at_a_place(problem, WorkError, f"the integrand has no value at {short(x)}")
        raise


def _finite(f, x):
    value = _value(f, x)
    if not scalars.is_finite(value):
        raise WorkError(f"the integrand is {value} at {short(x)}")
    return value


def _adaptive(f, start, end, rtol, scale):
    import warnings

    inner = [start + (end - start) * n / PARTS for n in range(1, PARTS)]
    try:
        from scipy.integrate import IntegrationWarning, quad
    except ModuleNotFoundError:
        return _bisected(f, (start, *inner, end), rtol, scale)
    with warnings.catch_warnings():
        warnings.simplefilter("error", IntegrationWarning)
        try:
            wanted = {"epsabs": rtol * scale, "epsrel": rtol, "limit": INTERVALS, "points": inner}
            return quad(lambda x: float(_finite(f, x)), start, end, **wanted)
        except IntegrationWarning as problem:
            raise _slow(start, end, rtol, str(problem).split(".")[0].strip()) from None


def _slow(start, end, rtol, why):
    return WorkError(
        f"the integral from {start:.6g} to {end:.6g} did not converge to {rtol:.1g}: {why}. Divide "
        "it with breaks=(...) where the force has a corner or a jump, or pass a larger rtol="
    )


def _bisected(f, ends, rtol, scale):
    """The same without SciPy: the part with the largest error is halved until all are small."""
    parts = sorted(_by_gauss(f, a, b) for a, b in pairwise(ends))
    while True:
        value, error = sum(part[3] for part in parts), -sum(part[0] for part in parts)
        if error <= rtol * max(scale, abs(value)):
            return value, error
        _, a, b, *_ = parts[0]
        middle = a + (b - a) / 2
        if len(parts) >= INTERVALS or not min(a, b) < middle < max(a, b):
            why = f"{len(parts)} intervals leave an error of {error:.1g}"
            raise _slow(ends[0], ends[-1], rtol, why)
        heapreplace(parts, _by_gauss(f, a, middle))
        heappush(parts, _by_gauss(f, middle, b))


def _by_gauss(f, start, end):
    """(-error, start, end, integral), with the errors of the rules and of round-off."""
    way, sums = end - start, []
    for count in PLACES:
        values = [(w, float(_finite(f, start + way * x))) for x, w in gauss(count, epsilon())]
        sums.append(sum(w * y for w, y in values))
    seen, size = [y for _, y in values], sum(w * abs(y) for w, y in values)
    error = abs(way) * max(abs(sums[1] - sums[0]), 50 * float_info.epsilon * size)
    rounded = float_info.epsilon * max(abs(start), abs(end)) * (max(seen) - min(seen))
    return -error - rounded, start, end, way * sums[1]


def cubature(
    f: Callable[[Any], Any], n: int, rtol: float, name: str, error: type = WorkError
) -> tuple[Any, float]:
    """The integrals of the components of ``f`` over the unit cube of ``n`` dimensions, to ``rtol``,
    and the largest of their estimated errors; ``error`` of ``name`` if they do not converge. f is a
    function of an array of places, one a row, that returns an array with their values as rows.
    """
    from scipy.integrate import cubature

    how = {"rule": "gk21", "rtol": rtol, "atol": rtol, "max_subdivisions": BOXES[n]}
    found = cubature(f, [0.0] * n, [1.0] * n, **how)
    off = float(np.max(found.error))
    if not np.isfinite(found.estimate).all():
        raise error(f"the integrals over {name} are not finite: look at limits and density")
    if found.status != "converged":
        raise error(
            f"the integrals over {name} did not converge: after {found.subdivisions} "
            f"subdivisions their relative error is about {off:.1g}, and {rtol:.1g} was asked for. "
            "Split the body where the formula has a corner or a jump, choose coordinates that "
            "follow its edges, or pass a larger rtol="
        )
    return found.estimate, off

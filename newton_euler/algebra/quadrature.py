"""Integrals of a function of numbers: adaptive quadrature for floats, the tanh-sinh rule for arrays
and mpf, SymPy for formulas.
"""

from itertools import count, pairwise

from .scalars import (
    NewtonEulerError,
    ScalarError,
    SingularError,
    clipped,
    cosh,
    epsilon,
    exp,
    is_finite,
    is_numeric,
    max_abs,
    pi,
    real,
    scalar,
    short,
    sinh,
    sqrt,
    to_plain,
)

INTERVALS = 400  # of an adaptive integral, at most; each takes 21 values
# subdivisions of an adaptive cubature by dimension; each one makes 2, 4 or 8 boxes of 21^n places
BOXES = {1: 4000, 2: 400, 3: 40}
_NUMBERS = count()  # so that the variables of nested integrals have names of their own


class WorkError(NewtonEulerError, ValueError):
    """An integral does not converge, or a force or path has no value where it is needed."""


def quadrature(f, start, end, rtol=1e-10, exact=False, breaks=()):
    """(value, estimated error) of the integral of ``f`` from ``start`` to ``end``; arguments as for
    :func:`newton_euler.dynamics.work.work_integral`.
    """
    if not 0 < real(rtol, "rtol") < 1:
        raise WorkError(f"rtol is a relative error between 0 and 1, as 1e-10; got {clipped(rtol)}")
    pieces = [_piece(f, a, b, rtol, exact) for a, b in pairwise((start, *breaks, end))]
    return sum(value for value, _ in pieces), sum(error for _, error in pieces)


def _piece(f, start, end, rtol, exact):
    """(value, estimated error) of one smooth piece."""
    if exact:
        return _by_formula(f, start, end), 0.0
    if not (is_numeric(scalar(start)) and is_numeric(scalar(end))):
        raise WorkError(
            f"the limits {start!r} and {end!r} are no numbers: pass exact=True, or put numbers in"
        )
    if isinstance(start, complex) or isinstance(end, complex):
        raise WorkError(f"the limits are real numbers, got {start!r} and {end!r}")
    width = end - start
    samples = [_finite(f, start + width * (n + 0.5) / 16) for n in range(16)]
    scale = max_abs(scalar(width)) * sum(map(max_abs, samples)) / 16
    one = samples[0] + width  # an array, or an mpf of more digits than a float?
    if getattr(one, "shape", ()) or epsilon(one) < 2.0**-53:
        try:
            value = width * integral(
                lambda s: _finite(f, start + width * s), 0 * width, 0 * width + 1
            )
        except SingularError:
            raise WorkError(
                f"the integral from {start!r} to {end!r} does not settle; divide it with "
                "breaks=(...) where the force has a corner"
            ) from None
        # the rule stops when its last but one value has half of the digits: mostly this one has all
        return to_plain(value), 1e-3 * scale * float(sqrt(epsilon(value)))
    return _adaptive(f, float(start), float(end), rtol, scale)


def _finite(f, x):
    try:
        value = scalar(f(x))
    except (ArithmeticError, ValueError) as problem:
        raise WorkError(f"the integrand has no value at {short(x)}: {problem}") from problem
    if not is_numeric(value):
        raise WorkError(
            f"the integrand is {to_plain(value)!r} at {short(x)}: pass exact=True, or put "
            "numbers in"
        )
    if not is_finite(value):
        raise WorkError(f"the integrand is {to_plain(value)} at {short(x)}")
    return value


def _adaptive(f, start, end, rtol, scale):
    import warnings

    from scipy.integrate import IntegrationWarning, quad

    with warnings.catch_warnings():
        warnings.simplefilter("error", IntegrationWarning)
        try:
            return quad(
                lambda x: float(_finite(f, x)),
                start,
                end,
                epsabs=rtol * scale,
                epsrel=rtol,
                limit=INTERVALS,
            )
        except IntegrationWarning as problem:
            raise WorkError(
                f"the integral from {start:.6g} to {end:.6g} did not converge to {rtol:.1g}: "
                f"{str(problem).split('.')[0].strip()}. Divide it with breaks=(...) where the "
                "force has a corner or a jump, or pass a larger rtol="
            ) from None


def _by_formula(f, start, end):
    import sympy

    # SymEngine would lose a Dummy, and the assumptions of a symbol
    name, q = sympy.Symbol(f"_q{next(_NUMBERS)}"), sympy.Dummy("q", real=True)
    try:
        start, end, y = (sympy.sympify(to_plain(scalar(x))) for x in (start, end, f(name)))
        value = sympy.integrate(y.xreplace({name: q}), (q, start, end))
    except (sympy.SympifyError, ScalarError) as problem:
        raise WorkError(
            f"SymPy cannot read the integrand or the limits {start!r} and {end!r}: {problem}"
        ) from None
    if value.has(sympy.Integral):
        raise WorkError(
            "SymPy finds no formula for this integral; put numbers in, without exact=True"
        )
    return value


def integral(f, start, end):
    """The integral of ``f`` from ``start`` to ``end``, by the tanh-sinh rule, to nearly the
    accuracy of the numbers.

    f may be infinite at ``start`` = 0 if integrable, as x**-0.5, but at no other end. Arrays are
    many integrals at once. Raises :class:`SingularError` if the rule does not settle (f jumps, or
    oscillates too fast), and :class:`ScalarError` for expressions.

    The places of f are a fraction 1/(1 + exp(pi sinh t)) of the way from either end, at equal steps
    of t (H. Takahasi and M. Mori, Publ. RIMS 9, 721, 1974); halving the step squares the error of a
    smooth f.

    >>> integral(lambda x: x**-0.5, 0.0, 4.0) - 4 < 1e-14
    True
    """
    if not (is_numeric(start) and is_numeric(end)):
        raise ScalarError(
            f"an integral from {start!r} to {end!r} needs numbers; integrate by hand or with SymPy"
        )
    width, small = end - start, epsilon(end - start)
    # A place nearer to an end than a round-off of the way is rounded to the end itself, where f may
    # be infinite. Next to 0 all floats are distinct, and the part of the integral of x**-0.5 up to
    # the fraction p is sqrt(p): one round-off for p its square.
    nearest = small * small if max_abs(start) == 0 else small

    def total(f, t, step):
        """Weight times f over the places at ±t, ±(t + step), …"""
        out = 0 * width
        while (near := 1 / (1 + exp(pi(t) * sinh(t)))) >= nearest:
            weight = pi(t) * cosh(t) * near * (1 - near)
            out = out + weight * f(start + width * near)
            if near > small:
                out = out + weight * f(start + width * (1 - near))
            t = t + step
        return out

    def first(f):
        return pi(step) / 4 * f(start + width / 2) + total(f, step, step)

    step = small / small  # 1, with all digits
    found, value = first(f), None
    # the change at the last halving: the error is about its square, less than a round-off
    allowed = 1e-3 * sqrt(small) * max_abs(width * first(lambda x: abs(f(x))))
    for _ in range(9):
        found, step, before = found + total(f, step / 2, step), step / 2, value
        value = found * step * width
        if before is not None and max_abs(value - before) <= allowed:
            return value
    raise SingularError(
        f"the integral from {start!r} to {end!r} does not settle: the function must be smooth in "
        "between. Split it where it is not"
    )


def cubature(f, n, rtol, name, error=WorkError):
    """The integrals of the components of ``f`` over the unit cube of ``n`` dimensions, to ``rtol``,
    and the largest of their estimated errors.

    f : function of an array of places, one a row, that returns an array with their values as rows
    name, error : what is integrated, for messages, and the class of error raised if the integrals
        do not converge
    """
    import numpy as np
    from scipy.integrate import cubature

    found = cubature(
        f, [0.0] * n, [1.0] * n, rule="gk21", rtol=rtol, atol=rtol, max_subdivisions=BOXES[n]
    )
    off = float(np.max(found.error))
    if not np.isfinite(found.estimate).all():
        raise error(
            f"the integrals over {name} are not finite: the formula or the density grows without "
            "bound within the limits"
        )
    if found.status != "converged":
        raise error(
            f"the integrals over {name} did not converge: after {found.subdivisions} "
            f"subdivisions their relative error is about {off:.1g}, and {rtol:.1g} was asked for. "
            "Split the body where the formula has a corner or a jump, choose coordinates that "
            "follow its edges, or pass a larger rtol="
        )
    return found.estimate, off

"""Integrals of every kind of number: over an interval by the tanh-sinh rule, or SymPy; over the
unit cube by products of Gauss rules, for numbers that SciPy's adaptive cubature does not take.
"""

from collections.abc import Callable, Sequence
from functools import cache, lru_cache, reduce, wraps
from itertools import count, pairwise, product
from typing import Any

from .errors import checked
from .late import is_here, np, sympy
from .scalars import (
    ZERO,
    NewtonEulerError,
    Scalar,
    ScalarError,
    SingularError,
    cos,
    cosh,
    epsilon,
    exp,
    highest,
    integer_like,
    is_finite,
    is_numeric,
    max_abs,
    pi,
    promote,
    real_scalar,
    scalar,
    sinh,
    sqrt,
    to_plain,
    without_rates,
)
from .vectors import Vector

HALVINGS = 9  # halvings of the step of the tanh-sinh rule
ORDERS = 8, 16, 32, 48, 64, 96  # nodes along each dimension of a cube
MOST = 300_000  # nodes in a cube
NEAR_MIDDLE = 0.4375  # a point for a trial; in the middle, by symmetry, f may have no value
_NUMBERS = count()  # so that the variables of nested integrals have names of their own


class WorkError(NewtonEulerError, ValueError):
    """An integral does not converge, or a force or path has no value where it is needed."""


@checked
def integral(
    f: Callable[..., Any], start: Scalar, end: Scalar, breaks: Sequence[Scalar] = ()
) -> Scalar:
    """The integral of ``f`` from ``start`` to ``end``: floats and mpf to nearly their accuracy,
    many integrals at once of arrays, the dimension of dimensions, the rates of moving numbers, a
    step of a formula that is compiled, and of expressions a formula of SymPy.

    f : function of one number that returns a scalar, a Vector, or a tuple of them, smooth between
        the limits and ``breaks``. It may be infinite only at ``start`` = 0, as x**-0.5
    breaks : in order, where f has corners or jumps
    Raises :class:`SingularError` where it does not converge, :class:`WorkError` where SymPy finds
    no formula.

    >>> round(integral(lambda x: x**-0.5, 0.0, 4.0), 12)
    4.0
    """
    places = [start, *map(scalar, breaks), end]
    return reduce(_sum, [_piece(f, a, b) for a, b in pairwise(places)])


def _sum(a, b):
    return tuple(map(_sum, a, b)) if isinstance(a, tuple) else a + b


def _piece(f, start, end):
    like = f((start + end) / 2)
    found = iter(integrals(wraps(f)(lambda x: _flat(f(x), like)), start, end))
    return _like(like, found)


def _flat(value, like):
    """The scalars in a value of f, which has the form of ``like``."""
    if isinstance(like, Vector):
        return (value if value.frame is like.frame else value.expressed_in(like.frame)).c
    if isinstance(like, (tuple, list)):
        count = len(value) if isinstance(value, (tuple, list)) else "no tuple"
        if count != len(like):
            raise ScalarError(
                f"the integrand returns a tuple of {len(like)} at one place, and {count} at "
                "another; return as many values everywhere"
            )
        return tuple(x for v, part in zip(value, like, strict=True) for x in _flat(v, part))
    return (real_scalar(value),)


def _like(like, scalars):
    """A value of the form of ``like`` from its scalars, in order."""
    if isinstance(like, Vector):
        return Vector(tuple(next(scalars) for _ in range(3)), like.frame)
    if isinstance(like, (tuple, list)):
        return tuple(_like(part, scalars) for part in like)
    return to_plain(next(scalars))


def integrals(
    f: Callable[[Scalar], Sequence[Scalar]], start: Scalar, end: Scalar
) -> tuple[Scalar, ...]:
    """The integrals of a function that returns a tuple of scalars, as :func:`integral`."""
    start, end = scalar(start), scalar(end)
    sample = f((start + end) / 2)
    present = [x for x in (start, end, *sample) if x is not ZERO]
    kind = highest(present)
    if hasattr(kind, "_parts"):
        return _by_parts(kind, f, start, end)
    if kind is not None:
        return kind._integrals(f, start, end)
    if all(map(is_numeric, present)):
        return _tanh_sinh(f, start, end, sample)
    return by_formula(f, start, end)


def _by_parts(kind, f, start, end):
    """Integrals of numbers with rates: those of the parts, over limits that are fixed."""
    g = f
    if hasattr(start, "_parts") or hasattr(end, "_parts"):
        low, width = start, end - start

        def g(s):
            return tuple(width * y for y in f(low + width * s))

        start, end = ZERO, integer_like(1, without_rates(width))
    found = integrals(lambda x: tuple(p for y in g(x) for p in kind._of(y)._parts()), start, end)
    count = len(kind._parts())
    return tuple(kind._of_parts(found[n : n + count]) for n in range(0, len(found), count))


def _tanh_sinh(f, start, end, sample):
    """By nodes at the fraction 1/(1 + exp(pi sinh t)) of the way from either end, for equal steps
    of t (H. Takahasi and M. Mori, Publ. RIMS 9, 721, 1974); halving these squares the error.
    """
    if not (is_finite(start) and is_finite(end)):
        raise SingularError(
            f"the limits of an integral are finite; got {start!r} and {end!r}: change the variable"
        )
    start, end, *_ = promote(start, end, *sample)
    width, small = end - start, epsilon(end - start)
    # A node nearer to an end than a round-off of the interval is rounded to the end itself, where f
    # may be infinite. Next to 0 all floats are distinct, and the integral of x**-0.5 up to the
    # fraction p is the share sqrt(p): one round-off for p its square.
    nearest = small * small if max_abs(start) == 0 else small
    step = small / small  # 1, with all digits
    sums = [pi(step) / 4 * y for y in f(start + width / 2)]
    sizes = [abs(s) for s in sums]

    def add(t, step):
        """Weight times f over the nodes at ±t, ±(t + step), …"""
        while (near := 1 / (1 + exp(pi(t) * sinh(t)))) >= nearest:
            weight = pi(t) * cosh(t) * near * (1 - near)
            for part in (near, 1 - near) if near > small else (near,):
                for n, y in enumerate(f(start + width * part)):
                    sums[n] = sums[n] + weight * y
                    sizes[n] = sizes[n] + weight * abs(y)
            t = t + step

    add(step, step)
    before = None
    for _ in range(HALVINGS):
        add(step / 2, step)
        step = step / 2
        values = [s * step * width for s in sums]
        # the change at the last halving: the error is about its square, less than a round-off
        allowed = [1e-3 * sqrt(small) * max_abs(width * s * step) for s in sizes]
        if before is not None and _converged(values, before, allowed):
            return tuple(values)
        before = values
    raise SingularError(
        f"the integral from {start!r} to {end!r} does not converge: the function must be smooth in "
        "between. Split it where it is not, with breaks=(...)"
    )


def _converged(values, before, allowed):
    """True if no value differs from the previous one by more than is allowed."""
    return all(max_abs(x - y) <= a for x, y, a in zip(values, before, allowed, strict=True))


def by_formula(
    f: Callable[[Scalar], Sequence[Scalar]], start: Scalar, end: Scalar
) -> tuple[Scalar, ...]:
    """The integrals by SymPy, where a limit or the function is an expression."""
    # SymEngine would lose a Dummy, and the assumptions of a symbol
    name = sympy.Symbol(f"_q{next(_NUMBERS)}")
    values = f(name)
    try:
        start, end, *values = map(_exact, (start, end, *values))
        found = [_by_sympy(y.xreplace({name: _variable()}), start, end) for y in values]
    except (sympy.SympifyError, ScalarError) as problem:
        raise WorkError(
            f"SymPy cannot read the integrand or the limits {start!r} and {end!r}: {problem}"
        ) from None
    if any(x.has(sympy.Integral) for x in found):
        raise WorkError(
            "SymPy finds no formula for this integral; put numbers in, without exact=True"
        )
    return tuple(found)


@cache
def _variable():
    return sympy.Dummy("q", real=True)


@lru_cache(maxsize=64)
def _by_sympy(y, start, end):
    """The integral of y over the variable; SymPy searches for seconds where there is no formula."""
    return sympy.integrate(y, (_variable(), start, end))


def _exact(x):
    """A scalar for SymPy; a whole float, as the limit 0.0, becomes exact."""
    x = to_plain(scalar(x))
    return sympy.sympify(int(x) if isinstance(x, float) and x.is_integer() else x)


def over_cube(f: Callable[..., tuple[Scalar, ...]], n: int) -> tuple[Scalar, ...]:
    """The integrals of the scalars in the tuple ``f(t_1, …, t_n)`` over the unit cube;
    :class:`SingularError` if they do not converge. f is smooth, also at the faces, and called with
    arrays of points, or, where it returns numbers of mpmath, with one point at a time.
    """
    sample = tuple(map(scalar, f(*(NEAR_MIDDLE,) * n)))
    present = [x for x in sample if x is not ZERO]
    kind = highest(present)
    if kind is not None:
        return kind._over_cube(f, n)
    if not all(map(is_numeric, present)):
        raise SingularError(f"an integral over a cube takes numbers, got {sample!r}")
    small = min(map(epsilon, present), default=epsilon())
    rule = _by_arrays if small >= 2.0**-53 and is_here("numpy") else _one_by_one
    before, last = None, 1
    for order in (m for m in ORDERS if m**n <= MOST):
        found, sizes = rule(f, n, order, sample)
        # the error falls geometrically: if the last order had correct a share last/order of the
        # digits, this one has all of them correct
        allowed = [1e-2 * small ** (last / order) * max_abs(size) for size in sizes]
        if before is not None and _converged(found, before, allowed):
            return found
        before, last = found, order
    raise SingularError(
        "an integral over a body does not converge: its formula and density must be smooth within "
        "the limits. Divide it where they are not"
    )


def _by_arrays(f, n, order, sample):
    """The sums over all nodes at once; along an axis next to those of arrays that f returns."""
    depth = max(len(getattr(x, "shape", ())) for x in sample)
    nodes, weights = np.polynomial.legendre.leggauss(order)
    places = np.array(list(product((nodes + 1) / 2, repeat=n))).T
    shares = np.array(list(product(weights / 2, repeat=n))).prod(axis=1)
    column = (-1, *(1,) * depth)
    values = f(*(p.reshape(column) for p in places))
    shares = shares.reshape(column)

    def total(y):
        if y is ZERO:
            return ZERO
        y = np.broadcast_to(y, np.broadcast_shapes(np.shape(y), shares.shape))
        y = (shares * y).sum(axis=0)
        return y if depth else float(y)

    return tuple(map(total, values)), [total(abs(y)) for y in values]


def _one_by_one(f, n, order, sample):
    """The sums node by node, with all the digits of mpmath, or of floats."""
    found, sizes = [ZERO] * len(sample), [ZERO] * len(sample)
    for pairs in product(gauss(order, epsilon(sum(sample))), repeat=n):
        share = 1
        for _, weight in pairs:
            share = share * weight
        for k, y in enumerate(f(*(place for place, _ in pairs))):
            found[k] = found[k] + share * y
            sizes[k] = sizes[k] + share * abs(y)
    return tuple(found), sizes


@cache
def gauss(order: int, small: float) -> list[tuple[Scalar, Scalar]]:
    """Gauss nodes and weights on (0, 1), to this round-off, by Newton's method."""
    one = scalar(1.0)
    if small < 2.0**-53:
        from mpmath import mpf

        one = mpf(1)
    pairs = []
    for k in range(order):
        x = cos(pi(one) * (k + 3 * one / 4) / (order + one / 2))
        for _ in range(10):
            before, value = one, x
            for m in range(2, order + 1):
                before, value = value, ((2 * m - 1) * x * value - (m - 1) * before) / m
            slope = order * (before - x * value) / (1 - x * x)
            x = x - value / slope
        pairs.append(((1 + x) / 2, 1 / ((1 - x * x) * slope**2)))
    return pairs

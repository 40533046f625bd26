"""The root of an equation in one unknown, bracketed by two values, of every kind of number."""

from collections.abc import Callable

from .errors import checked
from .jets import Moving, as_moving
from .scalars import (
    ZERO,
    Scalar,
    ScalarError,
    SingularError,
    anywhere,
    clipped,
    epsilon,
    highest,
    is_finite,
    is_numeric,
    promote,
    scalar,
    to_plain,
    vanishes,
    where,
)

STEPS = 2000  # some 15 are enough, a thousand if the function is flat at a root of 1e-300


@checked
def root(f: Callable[[Scalar], Scalar], low: Scalar, high: Scalar) -> Scalar:
    """The number between ``low`` and ``high`` at which ``f`` vanishes: a transcendental equation.

    f : continuous function of one number, whose signs at ``low`` and ``high`` differ
    Floats, mpf and arrays (an equation for each instant): to round-off. Moving numbers: with the
    rates of the root. Dimensions: that of the root, once f has run on it. Also in formulas that are
    compiled. Exact numbers of SymPy: as a float. Raises :class:`SingularError` if the signs are the
    same, :class:`ScalarError` for expressions with symbols.

    >>> from newton_euler import cos
    >>> round(root(lambda x: cos(x) - x, 0.0, 1.0), 12)
    0.739085133215
    """
    sample = scalar(f((low + high) / 2))
    present = [x for x in (low, high, sample) if x is not ZERO]
    if (kind := highest(present)) is not None:
        if isinstance(kind, Moving):
            return _moving_root(f, as_moving(low).value, as_moving(high).value)
        if not hasattr(kind, "_root"):
            raise ScalarError(f"an equation in {clipped(kind)} has no root that can be found")
        return kind._root(f, low, high)
    if not all(is_numeric(x) or _is_constant(x) for x in present):
        raise ScalarError(
            f"put numbers in: the root of {clipped(sample)} = 0 has no formula in general"
        )
    if not (is_finite(low) and is_finite(high)):
        raise SingularError(f"a root is bracketed by two finite values; got {low!r} and {high!r}")
    # exact numbers of SymPy have no exact root in general, and their fractions grow without end
    if any(map(_is_constant, present)):
        return _bracketed(lambda x: float(f(x)), float(low), float(high))
    low, high, _ = promote(low, high, sample)
    return to_plain(_bracketed(f, low, high))


def _is_constant(x):
    """True of an expression without symbols, as pi/4 of SymPy."""
    return not getattr(x, "free_symbols", True)


def _moving_root(f, low, high):
    """The root u with its rates, from f(u, t) = 0 differentiated once and twice by t."""

    def at(*u):
        return as_moving(f(Moving(*u)))

    u = scalar(root(lambda x: at(scalar(x)).value, low, high))
    resting = at(u)
    # f_u u' + f_t = 0, linear in u'; of dimensions only that of u' is wanted
    if not is_numeric(u) and not is_numeric(resting.value) and hasattr(u, "powers"):
        per_time = resting.rate / resting.value
        return Moving(u, u * per_time, u * per_time * per_time)
    slope = at(u, 1).rate - resting.rate
    if vanishes(slope):
        raise SingularError(f"the root {u!r} has no rate: the function touches zero there, slope 0")
    rate = -resting.rate / slope
    return Moving(u, rate, -at(u, rate).acceleration / slope)


def _bracketed(f, a, b):
    """The root between a and b by inverse quadratic interpolation or bisection (T. R. Chandrupatla,
    Advances in Engineering Software 28 (1997) 145); all instants of arrays at once.
    """
    fa, fb = _value(f, a), _value(f, b)
    if anywhere(_sign(fa) * _sign(fb) > 0):
        raise SingularError(
            f"no root is bracketed by {a!r} and {b!r}: there the function is {fa!r} and "
            f"{fb!r}; give values at which its signs differ"
        )
    small, either = epsilon(a + b), where if getattr(fa + fb, "shape", ()) else _either
    c, fc, first = a, fa, abs(fa) + abs(fb)
    for _ in range(STEPS):
        # a is the last point, c an earlier one on its side; the sign changes between a and b, or f
        # is zero at one of them
        wide = abs(b - a) > small * (abs(a) + abs(b)) / 2
        open_ = (_sign(fa) * _sign(fb) < 0) * wide
        if not anywhere(open_):
            break
        t = either(open_, _between((a, b, c), (fa, fb, fc), small, either), a)
        ft = _value(f, t)
        same = _sign(ft) == _sign(fa)
        c, fc = either(same, a, b), either(same, fa, fb)
        b, fb = either(same, b, a), either(same, fb, fa)
        a, fa = t, ft
    better = abs(fb) < abs(fa)
    a, fa = either(better, b, a), either(better, fb, fa)
    if anywhere(abs(fa) > first):
        raise SingularError(f"the function has a pole at {a!r}, no root: it is {fa!r} there")
    return a


def _between(places, values, small, either):
    """The next point: by interpolation where the inverse of f looks monotonic, else the middle."""

    def over(x, y):
        """x/y, of which nothing is used where y is zero."""
        return x / either(y == 0, 1 + 0 * y, y)

    (a, b, c), (fa, fb, fc) = places, values
    smaller = either(abs(fa) < abs(fc), fa, fc)  # as in bisection, where f does not shrink
    x, y = over(a - b, c - b), over(smaller - fb, fc - fb)
    t = over(fa, fb - fa) * over(fc, fb - fc)
    t = t + over(c - a, b - a) * over(smaller, fc - smaller) * over(fb, fc - fb)
    # steps of a unit in the last place at least, so that the last one crosses the root
    least = over(0.75 * small * abs(a), abs(b - a))
    least = either(least < 0.5, least, 0.5)
    t = either(t < least, least, either(t > 1 - least, 1 - least, t))
    # zero as the middle: from both sides it is reached by halving only after a thousand steps
    middle = either(_sign(a) * _sign(b) < 0, 0 * abs(a), (a + b) / 2)
    return either((y * y < x) * ((1 - y) * (1 - y) < 1 - x), a + t * (b - a), middle)


def _either(condition, a, b):
    return a if condition else b


def _value(f, x):
    value = to_plain(scalar(f(x))) + 0 * x
    if anywhere(value != value):
        raise SingularError(f"the function has no value at {x!r}: it is {value!r}")
    return value


def _sign(x):
    return (x > 0) * 1 - (x < 0) * 1

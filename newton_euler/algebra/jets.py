"""Scalars with their first and second time derivatives: exact rates of any formula."""

from collections.abc import Callable
from typing import Any

from .names import ArgumentError, guided, misfit
from .otherwise import built
from .places import at_a_place
from .scalars import (
    FUNCTIONS,
    LIBRARIES,
    ZERO,
    DivisionError,
    RangeError,
    Scalar,
    ScalarError,
    Scaled,
    Unordered,
    _Own,
    _root,
    acos,
    asin,
    atan,
    atan2,
    clipped,
    cos,
    cosh,
    exp,
    function,
    integer_like,
    is_numeric,
    log,
    min_abs,
    real_scalar,
    short_repr,
    sin,
    sinh,
    sqrt,
    tan,
    tanh,
    to_plain,
    where,
    without_rates,
)


class _Derived:
    """In place of a rate that is not given."""

    def __repr__(self):
        return "derived"


DERIVED: Any = _Derived()


class Moving(Unordered, _Own):
    """A scalar at one instant with its first and second time derivative (a jet of order two), made
    by :func:`moving` or :func:`at`. Arithmetic and functions compute the rates by the product and
    chain rules (forward automatic differentiation: A. Griewank and A. Walther, Evaluating
    Derivatives, 2008, chapter 13).

    >>> from newton_euler import cos
    >>> cos(Moving(0.0, 2.0))
    moving(1.0, rate=-0.0, acceleration=-4.0)
    """

    __slots__ = ("acceleration", "rate", "value")
    __array_priority__ = 1000.0  # NumPy hands operators over, and calls methods for its functions
    rank = 9  # it wraps the other kinds
    advice = "write sin(x) of newton_euler for math.sin(x), and where(t.value > 1.0, a, b) for if"

    def is_numeric(self) -> bool:
        """True if its value can be compared."""
        return is_numeric(self.value)

    def without_rates(self) -> Scalar:
        """The value alone."""
        return without_rates(self.value)

    def __init__(self, value: Scalar, rate: Scalar = ZERO, acceleration: Scalar = ZERO):
        self.value, self.rate, self.acceleration = value, rate, acceleration

    def __repr__(self):
        rates = f"rate={short_repr(self.rate)}, acceleration={short_repr(self.acceleration)}"
        return f"moving({short_repr(self.value)}, {rates})"

    @staticmethod
    def _of(x: Scalar) -> "Moving":
        """The moving number that ``x`` is, or one that rests."""
        return as_moving(x)

    def _parts(self) -> tuple:
        """Value, rate and acceleration."""
        return self.value, self.rate, self.acceleration

    @staticmethod
    def _of_parts(parts: tuple) -> "Moving":
        """The moving number of these parts."""
        return Moving(*parts)

    def _of_table(self, table):
        """The value of a :class:`~newton_euler.algebra.tables.Table` with its rates."""
        slope = table.derivative()
        first, second = slope(self.value), slope.derivative()(self.value)
        acceleration = second * self.rate * self.rate + first * self.acceleration
        return Moving(table(self.value), first * self.rate, acceleration)

    def __add__(self, other: Scalar) -> "Moving":
        o = as_moving(other)
        return Moving(self.value + o.value, self.rate + o.rate, self.acceleration + o.acceleration)

    __radd__ = __add__

    def __neg__(self) -> "Moving":
        return Moving(-self.value, -self.rate, -self.acceleration)

    def __abs__(self) -> "Moving":
        if self.rests():
            return Moving(abs(self.value))
        value = to_plain(self.value)
        if not is_numeric(value):
            return self * (value / abs(value))
        if min_abs(value) == 0:
            raise DivisionError(
                f"abs(x) has no rate where x = 0, as in {self!r}: take the sign before or after"
            )
        return self * where(value < 0, -1, 1)

    def __mul__(self, other: Scalar) -> Scalar:
        if other is ZERO:
            return ZERO
        if isinstance(other, Scaled):
            return NotImplemented
        o = as_moving(other)
        return Moving(
            self.value * o.value,
            self.rate * o.value + self.value * o.rate,
            self.acceleration * o.value + 2 * (self.rate * o.rate) + self.value * o.acceleration,
        )

    __rmul__ = __mul__

    def __truediv__(self, other: Scalar) -> "Moving":
        o = as_moving(other)
        q = self.value / o.value
        dq = (self.rate - q * o.rate) / o.value
        return Moving(q, dq, (self.acceleration - 2 * (dq * o.rate) - q * o.acceleration) / o.value)

    def __rtruediv__(self, other: Scalar) -> "Moving":
        return as_moving(other) / self

    def __pow__(self, power: Scalar) -> Scalar:
        if isinstance(power, Moving):
            raise ScalarError(
                "a moving number takes a constant power only; otherwise write exp(power*log(x))"
            )
        if power is ZERO or (type(power) in (int, float) and power in (0, 1)):
            return self if power else 1
        u, power = self.value, to_plain(real_scalar(power))
        if self.rests():
            return Moving(u**power)
        slope, curvature = power * u ** (power - 1), power * (power - 1) * u ** (power - 2)
        return self._chain(u**power, slope, curvature)

    def rests(self) -> bool:
        """True if it is constant by structure: then a function needs no derivative at the value."""
        return self.rate is ZERO and self.acceleration is ZERO

    def __rpow__(self, base: Scalar) -> Scalar:
        # the logarithm in the kind of the value, with all its digits
        return exp(self * log(self.value * 0 + real_scalar(base)))

    def _chain(self, f, df, ddf):
        """The number f(self), given f and its first two derivatives at the value."""
        return Moving(f, df * self.rate, ddf * (self.rate * self.rate) + df * self.acceleration)

    def function(self, name: str, *args: Scalar) -> "Moving":
        """The function of this name with its rates, by the chain rule."""
        if isinstance(name, str) and name == "atan2":
            y, x = (as_moving(a) for a in args)
            square = x.value * x.value + y.value * y.value
            rate = (x.value * y.rate - y.value * x.rate) / square
            growth = 2 * (x.value * x.rate + y.value * y.rate)
            turn = x.value * y.acceleration - y.value * x.acceleration
            return Moving(atan2(y.value, x.value), rate, (turn - rate * growth) / square)
        if not isinstance(name, str) or name not in _DERIVATIVES:
            known = ", ".join(FUNCTIONS)
            raise ScalarError(f"{clipped(name)} is not a function; there are {known}")
        if self.rests():
            return Moving(function(name, self.value))
        try:
            f, df, ddf = _DERIVATIVES[name](self.value)
            parts = self.rate, self.acceleration, df, ddf
            rate, acceleration, df, ddf = built("chain", parts, (self.value,))
            return Moving(self.value, rate, acceleration)._chain(f, df, ddf)
        except ZeroDivisionError as error:
            raise DivisionError(f"no rate of {name}({short_repr(self.value)}): {error}") from None


class _Refusal:
    """In place of the method that a function of NumPy calls: what to write instead of np.sin."""

    def __init__(self, numpys, ours):
        self.words = f"np.{numpys} takes no moving number: write {ours}(...) of newton_euler"

    def __call__(self, *_):
        raise ScalarError(self.words)


_NUMPYS = {"asin": "arcsin", "acos": "arccos", "atan": "arctan", "atan2": "arctan2"}
for _ours in (*FUNCTIONS, "radians", "atan2"):
    setattr(Moving, _NUMPYS.get(_ours, _ours), _Refusal(_NUMPYS.get(_ours, _ours), _ours))


def _reciprocal(f, df_inverse, ddf_factor):
    """(f, f', f'') where 1/f' and f''/f' are given."""
    df = 1 / df_inverse
    return f, df, ddf_factor * df


# name: (f, f', f'') at u. (1 - u)(1 + u) and not 1 - u*u, which cancels near the ends.
_DERIVATIVES = {
    "sin": lambda u: (sin(u), cos(u), -sin(u)),
    "cos": lambda u: (cos(u), -sin(u), -cos(u)),
    "tan": lambda u: (tan(u), 1 + tan(u) ** 2, 2 * tan(u) * (1 + tan(u) ** 2)),
    "asin": lambda u: _reciprocal(asin(u), sqrt((1 - u) * (1 + u)), u / ((1 - u) * (1 + u))),
    "acos": lambda u: _reciprocal(acos(u), -sqrt((1 - u) * (1 + u)), u / ((1 - u) * (1 + u))),
    "atan": lambda u: _reciprocal(atan(u), 1 + u * u, -2 * u / (1 + u * u)),
    "sinh": lambda u: (sinh(u), cosh(u), sinh(u)),
    "cosh": lambda u: (cosh(u), sinh(u), cosh(u)),
    "tanh": lambda u: (tanh(u), 1 - tanh(u) ** 2, -2 * tanh(u) * (1 - tanh(u) ** 2)),
    "exp": lambda u: (exp(u),) * 3,
    "log": lambda u: (log(u), 1 / u, -1 / (u * u)),
    "sqrt": lambda u: _reciprocal(sqrt(u), 2 * sqrt(u), -1 / (2 * u)),
}


def as_moving(x: Scalar) -> "Moving":
    """The moving number ``x``, or one of the value ``x`` whose rates are zero by structure."""
    return x if isinstance(x, Moving) else Moving(real_scalar(x))


def moving(
    value: Scalar, rate: Scalar = DERIVED, acceleration: Scalar = DERIVED, **other: Scalar
) -> Moving:
    """A scalar with its rates at the instant, for angles and coordinates that change: d/dt and
    d2/dt2 of ``value``. Without them, the derivatives of a SymPy or SymEngine expression in the
    symbol ``t`` are taken; those of other values are zero.

    >>> moving(2.0, rate=3.0)**2
    moving(4.0, rate=12.0, acceleration=18.0)
    """
    if type(value) is float and value == value and not other:  # nan is not equal to itself
        if rate is DERIVED:
            if acceleration is DERIVED:
                return Moving(value)
        elif type(rate) is float and rate == rate and acceleration is DERIVED:
            return Moving(value, rate)
    if other:
        raise ArgumentError(misfit(_moving, (value,), other))
    if isinstance(value, Moving):
        if rate is not DERIVED or acceleration is not DERIVED:
            raise ScalarError(f"{value!r} already has its rates; leave out rate= and acceleration=")
        return value
    if callable(value) and _root(type(value)) not in LIBRARIES:
        raise ScalarError("a function of time needs an instant: pass at(f, t) instead of f")
    value = _known(value, "value")
    rates = [value]
    for x, what in ((rate, "rate"), (acceleration, "acceleration")):
        given = x is not DERIVED
        rates.append(integer_like(_known(x, what), value) if given else _derived(rates[-1]))
    return Moving(*rates)


def _moving(value, rate=DERIVED, acceleration=DERIVED):
    """The arguments of :func:`moving`."""


_moving.__qualname__ = "moving"


def _known(x, what):
    """The real scalar ``x``; None and nan, as of a value not computed yet, are refused."""
    if x is None or (isinstance(x, float) and x != x):
        raise ScalarError(
            f"the {what} is {x}, which is not a number: look at what it was computed from"
            + (f", or leave {what}= out" if what != "value" else "")
        )
    return real_scalar(x)


def _derived(x):
    """dx/dt of a symbolic expression in any symbol named t; zero for other numbers."""
    if x is ZERO or type(x) is float or _root(type(x)) not in ("sympy", "symengine"):
        return ZERO
    times = [s for s in x.free_symbols if str(s) == "t"]
    if len(times) > 1:
        raise ScalarError(f"{x} holds {len(times)} different symbols named t; use one")
    derivative = x.diff(times[0]) if times else ZERO
    return ZERO if derivative == 0 else derivative


@guided
def at(f: Callable[..., Scalar], t: Scalar) -> Moving:
    """The function of time ``f`` at the instant ``t`` (s), of any kind, with its first and second
    rate, exact up to round-off. ``f`` uses the functions of this package.

    >>> at(lambda t: t**3, 2.0)
    moving(8.0, rate=12.0, acceleration=12.0)
    """
    if not callable(f) or isinstance(f, type):
        raise ScalarError(f"at takes a function, as at(lambda t: t**2, 2.0); got {clipped(f)}")
    t = to_plain(real_scalar(t))
    # the rate 1 in the kind of t: else constants are multiplied with 16 digits before they meet t
    try:
        return as_moving(f(Moving(t, integer_like(1, t))))
    except OverflowError as error:
        place = f"the function is too large for a float at {short_repr(t)}"
        at_a_place(error, RangeError, place)
        raise

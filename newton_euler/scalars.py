"""Numbers of every kind behind one set of functions.

Every formula of the engine is written once, in plain arithmetic, over *scalars*. A scalar is a Python float, a NumPy
array (many instants at once), an ``mpmath.mpf``, a SymPy, SymEngine or heyoka expression, or one of the kinds below:

``ZERO``        a zero known from the structure of a formula; it vanishes from sums and products
``Moving``      a value with its first and second rate in time
``Dimension``   no value at all, only powers of mass, length and time: a formula that runs on it has consistent units
``Step``        a value being traced by :func:`newton_euler.tracing.compiled`

This is the only module that knows them apart. The others call ``sin``, ``sqrt`` … from here and otherwise use ``+ - * /``.
None of the heavy libraries is imported here: a number brings its own library along.
"""

import importlib
import math
from fractions import Fraction

FUNCTIONS = ("sin", "cos", "tan", "asin", "acos", "atan", "sinh", "cosh", "tanh", "exp", "log", "sqrt")
_LIBRARIES = {"numpy", "mpmath", "sympy", "symengine", "heyoka"}


class ScalarError(TypeError):
    """Something that is not a number of any known kind, or an operation that a kind of number does not have."""


class DimensionError(ScalarError):
    """Quantities of different dimension were added, or a function was taken of one that is not a pure number."""


class _Own:
    """Base of the kinds of number defined here. NumPy must hand operations over instead of looping over them."""

    __slots__ = ()
    __array_ufunc__ = None
    rank = 0  # of several kinds in one call, the highest decides

    def __pos__(self):
        return self


class _Zero(_Own):
    """The structural zero; there is one, :data:`ZERO`. Adding it costs nothing and leaves nothing behind."""

    __slots__ = ()

    def __add__(self, other):
        return other

    __radd__ = __add__

    def __sub__(self, other):
        return -other

    def __rsub__(self, other):
        return other

    def __mul__(self, other):
        return self

    __rmul__ = __mul__

    def __truediv__(self, other):
        if isinstance(other, _Zero):
            raise ZeroDivisionError("0/0: both are zero by the structure of the formula")
        return self

    def __rtruediv__(self, other):
        raise ZeroDivisionError(f"{other!r} is divided by a quantity that is zero by the structure of the formula")

    def __pow__(self, power):
        if power == 0:
            return 1
        if power < 0:
            raise ZeroDivisionError(f"0 to the power {power}")
        return self

    def __neg__(self):
        return self

    def __abs__(self):
        return self

    def __eq__(self, other):
        return isinstance(other, _Zero) or other == 0

    def __hash__(self):
        return hash(0)

    def __bool__(self):
        return False

    def __float__(self):
        return 0.0

    def __int__(self):
        return 0

    __index__ = __int__

    def __repr__(self):
        return "0"

    def _sympy_(self):
        return importlib.import_module("sympy").Integer(0)

    def __reduce__(self):
        return "ZERO"

    def function(self, name, *others):
        if name in ("cos", "cosh", "exp"):
            return 1
        if name in ("log", "acos"):
            return getattr(math, name)(0.0)
        return self


ZERO = _Zero()


def scalar(x):
    """``x`` as the engine keeps it: a literal ``0`` becomes the structural zero, anything else stays what it is.

    Raises :class:`ScalarError` for what is not a number (text, None, lists).

    >>> scalar(0) is ZERO, scalar(0.0), scalar(1.5)
    (True, 0.0, 1.5)
    """
    if type(x) is float or isinstance(x, _Own):
        return x
    if type(x) is int or (type(x) is bool):
        return x or ZERO
    if isinstance(x, (float, int, Fraction, complex)) or _root(type(x)) in _LIBRARIES:
        return x
    raise ScalarError(
        f"expected a number (float, array, mpf, SymPy, SymEngine or heyoka expression), got {x!r} of type {type(x).__name__}"
    )


def plain(x):
    """``x`` as a user meets it: the structural zero as the integer 0, a moving number as its value."""
    if x is ZERO:
        return 0
    return plain(x.value) if isinstance(x, Moving) else x


_roots = {}


def _root(kind):
    root = _roots.get(kind)
    if root is None:
        root = _roots[kind] = kind.__module__.partition(".")[0]
    return root


def _library(values):
    """The library that has functions for these values; of several, an expression decides before mpmath before NumPy."""
    roots = {_root(type(v)) for v in values}
    for name in ("heyoka", "sympy", "symengine", "mpmath", "numpy"):
        if name in roots:
            return importlib.import_module(name)
    if any(isinstance(v, complex) for v in values):
        return importlib.import_module("cmath")
    return math


def function(name, *args):
    """The function ``name`` (one of :data:`FUNCTIONS`, or ``atan2``) of scalars of any kind."""
    own = [a for a in args if isinstance(a, _Own)]
    if own:
        chosen = max(own, key=lambda a: a.rank)
        return chosen.function(name, *args) if name == "atan2" else chosen.function(name)
    return getattr(_library(args), name)(*args)


def _define(name):
    quick = getattr(math, name)

    def f(x):
        return quick(x) if type(x) is float else function(name, x)

    f.__name__ = f.__qualname__ = name
    f.__doc__ = f"{name} of a scalar of any kind; angles in radians."
    return f


sin, cos, tan, asin, acos, atan, sinh, cosh, tanh, exp, log, sqrt = (_define(name) for name in FUNCTIONS)


def atan2(y, x):
    """Angle of the point (x, y) from the x axis, in (-pi, pi], for scalars of any kind.

    >>> atan2(1.0, -1.0) == 3*math.pi/4
    True
    """
    if y is ZERO and x is ZERO:
        raise ZeroDivisionError("the direction of a zero vector is undefined: atan2(0, 0)")
    if type(y) is float and type(x) is float:
        return math.atan2(y, x)
    if isinstance(y, _Zero) and not isinstance(x, _Own):
        return function("atan2", 0 * x, x)
    if isinstance(x, _Zero) and not isinstance(y, _Own):
        return function("atan2", y, 0 * y)
    return function("atan2", y, x)


def pi(like=0.0):
    """The number pi in the kind of ``like``: to 30 digits for an mpf, as a symbol for an expression.

    >>> pi(1.0)
    3.141592653589793
    """
    if isinstance(like, _Own):
        return like.pi() if hasattr(like, "pi") else math.pi
    library = _library((like,))
    return +library.pi if library.__name__ == "mpmath" else getattr(library, "pi", math.pi)


def radians(degrees):
    """The angle in radians, exactly as far as the kind of number allows.

    >>> radians(180.0) == math.pi
    True
    """
    return degrees * pi(degrees) / 180


def is_numeric(x):
    """True where ``x`` has a value that can be compared: float, array, mpf, but not an expression or a dimension."""
    if isinstance(x, Moving):
        return is_numeric(x.value)
    if isinstance(x, _Own):
        return x is ZERO
    root = _root(type(x))
    return root in ("builtins", "numpy", "mpmath", "fractions") or (root in ("sympy", "symengine") and bool(x.is_Number))


def is_zero(x):
    """True where ``x`` is certainly zero: structurally, or a number equal to 0 (an array only if all of it is)."""
    if not is_numeric(x):
        return False
    equal = plain(x) == 0
    return bool(equal.all()) if hasattr(equal, "all") else bool(equal)


def is_finite(x):
    """True unless ``x`` is a number (or has an element) that is nan or infinite; expressions count as finite."""
    if not is_numeric(x):
        return True
    x = plain(x)
    finite = importlib.import_module("numpy").isfinite(x) if _root(type(x)) == "numpy" else abs(x) < float("inf")
    return bool(finite.all()) if hasattr(finite, "all") else bool(finite)


def size(x):
    """The largest absolute value in ``x``, as a float, to compare with a tolerance.

    >>> size(-3.0), size(ZERO)
    (3.0, 0.0)
    """
    x = plain(x)
    largest = abs(x)
    return float(largest.max()) if hasattr(largest, "max") else float(largest)


class Moving(_Own):
    """A scalar at one instant together with its first and second time rate (a jet of order two).

    Arithmetic and functions carry the rates along by the product and chain rules, so no step size enters.
    Make one with :func:`moving` or :func:`at`.
    """

    __slots__ = ("value", "rate", "acceleration")
    rank = 9  # it wraps the other kinds

    def __init__(self, value, rate=ZERO, acceleration=ZERO):
        self.value, self.rate, self.acceleration = value, rate, acceleration

    def __repr__(self):
        return f"moving({plain(self.value)!r}, rate={plain(self.rate)!r}, acceleration={plain(self.acceleration)!r})"

    def __add__(self, other):
        o = _as_moving(other)
        return Moving(self.value + o.value, self.rate + o.rate, self.acceleration + o.acceleration)

    __radd__ = __add__

    def __neg__(self):
        return Moving(-self.value, -self.rate, -self.acceleration)

    def __sub__(self, other):
        return self + (-_as_moving(other))

    def __rsub__(self, other):
        return _as_moving(other) + (-self)

    def __mul__(self, other):
        if other is ZERO:
            return ZERO
        o = _as_moving(other)
        return Moving(
            self.value * o.value,
            self.rate * o.value + self.value * o.rate,
            self.acceleration * o.value + 2 * (self.rate * o.rate) + self.value * o.acceleration,
        )

    __rmul__ = __mul__

    def __truediv__(self, other):
        o = _as_moving(other)
        q = self.value / o.value
        dq = (self.rate - q * o.rate) / o.value
        return Moving(q, dq, (self.acceleration - 2 * (dq * o.rate) - q * o.acceleration) / o.value)

    def __rtruediv__(self, other):
        return _as_moving(other) / self

    def __pow__(self, power):
        if isinstance(power, _Own):
            raise ScalarError("a moving number can be raised to a constant power only")
        u = self.value
        return self._chain(u**power, power * u ** (power - 1), power * (power - 1) * u ** (power - 2) if power != 1 else ZERO)

    def _chain(self, f, df, ddf):
        """The number f(self), given f and its first two derivatives at the value."""
        return Moving(f, df * self.rate, ddf * (self.rate * self.rate) + df * self.acceleration)

    def function(self, name, *args):
        if name == "atan2":
            y, x = (_as_moving(a) for a in args)
            angle = atan(y / x) if not is_zero(x.value) else -atan(x / y)
            return Moving(atan2(y.value, x.value), angle.rate, angle.acceleration)
        return self._chain(*_DERIVATIVES[name](self.value))

    def pi(self):
        return pi(self.value)


def _reciprocal(f, df_inverse, ddf_factor):
    df = 1 / df_inverse
    return f, df, ddf_factor * df


_DERIVATIVES = {
    "sin": lambda u: (sin(u), cos(u), -sin(u)),
    "cos": lambda u: (cos(u), -sin(u), -cos(u)),
    "tan": lambda u: (tan(u), 1 + tan(u) ** 2, 2 * tan(u) * (1 + tan(u) ** 2)),
    "asin": lambda u: _reciprocal(asin(u), sqrt(1 - u * u), u / (1 - u * u)),
    "acos": lambda u: _reciprocal(acos(u), -sqrt(1 - u * u), u / (1 - u * u)),
    "atan": lambda u: _reciprocal(atan(u), 1 + u * u, -2 * u / (1 + u * u)),
    "sinh": lambda u: (sinh(u), cosh(u), sinh(u)),
    "cosh": lambda u: (cosh(u), sinh(u), cosh(u)),
    "tanh": lambda u: (tanh(u), 1 - tanh(u) ** 2, -2 * tanh(u) * (1 - tanh(u) ** 2)),
    "exp": lambda u: (exp(u),) * 3,
    "log": lambda u: (log(u), 1 / u, -1 / (u * u)),
    "sqrt": lambda u: _reciprocal(sqrt(u), 2 * sqrt(u), -1 / (2 * u)),
}


def _as_moving(x):
    return x if isinstance(x, Moving) else Moving(scalar(x))


def moving(value, rate=None, acceleration=None):
    """A scalar with its rates at the instant, for angles and coordinates that change.

    ``rate`` and ``acceleration`` are d/dt and d2/dt2 of ``value``, in its unit per second and per second squared. Where they are left
    out, they are derived if ``value`` is a SymPy or SymEngine expression in the symbol ``t``, and zero otherwise.

    >>> moving(2.0, rate=3.0)**2
    moving(4.0, rate=12.0, acceleration=18.0)
    """
    if isinstance(value, Moving):
        if rate is not None or acceleration is not None:
            raise ScalarError(f"{value!r} already has its rates; leave out rate= and acceleration=, or pass its value alone")
        return value
    if callable(value) and _root(type(value)) not in _LIBRARIES:
        raise ScalarError("a function of time needs an instant: pass at(f, t) instead of f")
    value = scalar(value)
    if rate is None and acceleration is None and _root(type(value)) in ("sympy", "symengine"):
        t = importlib.import_module(_root(type(value))).Symbol("t")
        return Moving(value, _structural(value.diff(t)), _structural(value.diff(t).diff(t)))
    return Moving(value, scalar(0 if rate is None else rate), scalar(0 if acceleration is None else acceleration))


def _structural(x):
    return ZERO if x == 0 else x


def at(f, t):
    """The function of time ``f`` at the instant ``t`` (s), with its first and second rate, exactly and without a step size.

    ``f`` uses the functions of this module (``from newton_euler import sin, sqrt …``); ``t`` may be of any kind.

    >>> at(lambda t: t**3, 2.0)
    moving(8.0, rate=12.0, acceleration=12.0)
    """
    return _as_moving(f(Moving(t, 1)))


class Dimension(_Own):
    """What remains of a quantity without its value: its powers of mass, length and time.

    Angles, and numbers written in a formula, are pure. Adding unlike dimensions raises :class:`DimensionError`, so
    one run of a formula on dimensions proves its units.

    >>> length, time = Dimension(0, 1, 0), Dimension(0, 0, 1)
    >>> length/time**2 + 2*length/time**2
    Dimension(L^1 T^-2)
    """

    __slots__ = ("powers",)
    rank = 1

    def __init__(self, mass=0, length=0, time=0):
        self.powers = (Fraction(mass), Fraction(length), Fraction(time))

    def __repr__(self):
        named = [f"{n}^{p}" for n, p in zip("MLT", self.powers, strict=True) if p]
        return f"Dimension({' '.join(named) or '1'})"

    def __eq__(self, other):
        return isinstance(other, Dimension) and self.powers == other.powers

    def __hash__(self):
        return hash(self.powers)

    def __add__(self, other):
        if other is ZERO:
            return self
        if isinstance(other, Moving):
            return NotImplemented
        if _as_dimension(other) != self:
            raise DimensionError(f"cannot add {_as_dimension(other)} to {self}: look at the units of the two terms")
        return self

    __radd__ = __sub__ = __rsub__ = __add__

    def __neg__(self):
        return self

    __abs__ = __neg__

    def __mul__(self, other):
        if other is ZERO:
            return ZERO
        if isinstance(other, Moving):
            return NotImplemented
        return Dimension(*(a + b for a, b in zip(self.powers, _as_dimension(other).powers, strict=True)))

    __rmul__ = __mul__

    def __truediv__(self, other):
        if isinstance(other, Moving):
            return NotImplemented
        return Dimension(*(a - b for a, b in zip(self.powers, _as_dimension(other).powers, strict=True)))

    def __rtruediv__(self, other):
        return _as_dimension(other) / self

    def __pow__(self, power):
        return Dimension(*(a * Fraction(power) for a in self.powers))

    def function(self, name, *args):
        if name == "sqrt":
            return self ** Fraction(1, 2)
        if name == "atan2":
            _ = args[0] + args[1] if args[0] is not ZERO and args[1] is not ZERO else None
        elif any(self.powers):
            raise DimensionError(f"{name} of a quantity with {self}: its argument must be a pure number (an angle, a ratio)")
        return Dimension()


def _as_dimension(x):
    return x if isinstance(x, Dimension) else Dimension()

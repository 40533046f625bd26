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
import zlib
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
    _op_priority = 1000.0  # SymPy's word for the same
    rank = 0  # of several kinds in one call, the highest decides

    def __pos__(self):
        return self

    def __rpow__(self, base):
        return exp(self * log(base))


class Scaled:
    """Base of what is no scalar but can be multiplied by one (vectors): the numbers defined here leave the product to it."""

    __slots__ = ()
    __array_ufunc__ = None


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
        return NotImplemented if isinstance(other, Scaled) else self

    __rmul__ = __mul__

    def __truediv__(self, other):
        if isinstance(other, _Zero):
            raise ZeroDivisionError("0/0: both are zero by the structure of the formula")
        return self

    def __rtruediv__(self, other):
        raise ZeroDivisionError(f"{other!r} is divided by a quantity that is zero by the structure of the formula")

    def __pow__(self, power):
        power = _value(power)
        if not is_numeric(power):
            return self
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

    def __reduce__(self):
        return "ZERO"

    def function(self, name, *others):
        """The function of this name, for :func:`function`."""
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
    if isinstance(x, (float, int, Fraction, complex)) or (_root(type(x)) in _LIBRARIES and _dtype(x) in "biufcO"):
        return x
    raise ScalarError(f"expected a number (float, array, mpf, SymPy, SymEngine or heyoka expression), got {x!r} of type {type(x).__name__}")


def whole(x, like):
    """A whole number in the kind of ``like``, so that its root and its quotients are as exact as ``like`` is; others unchanged.

    >>> whole(2, 1.5)
    2
    """
    return like * 0 + x if type(x) is int and _root(type(like)) in ("mpmath", "sympy", "symengine") else x


def plain(x):
    """``x`` as a user meets it: the structural zero as the integer 0."""
    return 0 if x is ZERO else x


def _value(x):
    """The number behind ``x``, without its rates, to compare or to measure it."""
    return _value(x.value) if isinstance(x, Moving) else plain(x)


def _dtype(x):
    return x.dtype.kind if hasattr(x, "dtype") else "O"


_roots = {}


def _root(kind):
    root = _roots.get(kind)
    if root is None:
        module = next(k.__module__ for k in kind.__mro__ if k.__module__)  # SymPy's q(t) has a class without a module
        root = _roots[kind] = module.partition(".")[0]
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
        return function("atan2", 0 * x + 0, x)  # +0.0, also where x is negative
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
    if isinstance(x, (Moving, Linear)):
        return isinstance(x, Moving) and is_numeric(x.value)
    if isinstance(x, _Own):
        return x is ZERO
    root = _root(type(x))
    return root in ("builtins", "numpy", "mpmath", "fractions") or (root in ("sympy", "symengine") and bool(x.is_Number))


def of_one_kind(*values):
    """The values, each with all the digits and instants of the others: if one is an mpf or an array, all are. What is traced stays as it is.

    >>> of_one_kind(1, 2.5)
    (1.0, 2.5)
    """
    values = tuple(map(plain, values))
    if not all(map(is_numeric, values)):
        return values
    like = 0.0 * sum(values)
    return tuple(x + like for x in values)


def is_comparable(x):
    """True where ``x`` may stand in the comparison of a :func:`where`: numbers, and values that are being traced.

    >>> is_comparable(1.0), is_comparable(Dimension(1))
    (True, False)
    """
    return is_numeric(x) or hasattr(x, "where")


def is_zero(x):
    """True where ``x`` is certainly zero: structurally, or a number equal to 0 (an array only if all of it is)."""
    if not is_numeric(x):
        return False
    equal = _value(x) == 0
    return bool(equal.all()) if hasattr(equal, "all") else bool(equal)


def is_finite(x):
    """True unless ``x`` is a number (or has an element) that is nan or infinite; expressions count as finite."""
    if not is_numeric(x):
        return True
    x = _value(x)
    root = _root(type(x))
    if root == "numpy":
        return bool(importlib.import_module("numpy").isfinite(x).all())
    if root in ("sympy", "symengine"):  # SymEngine does not know of its own floats whether they are finite
        return bool(importlib.import_module("sympy").sympify(x).is_finite)
    return abs(x) < float("inf")


def size(x):
    """The largest absolute value in ``x``, as a float, to compare with a tolerance.

    >>> size(-3.0), size(ZERO)
    (3.0, 0.0)
    """
    x = _value(x)
    largest = abs(x)
    return float(largest.max(initial=0)) if hasattr(largest, "max") else float(largest)


def where(condition, a, b):
    """``a`` where the condition holds, else ``b``; instant by instant if it is an array of conditions.

    For numbers and traced values, which can be compared; expressions and dimensions cannot. Both are computed before one is chosen: a divisor that
    is zero where the quotient is not wanted must be replaced first.

    >>> where(2.0 > 1.0, "larger", "smaller")
    'larger'
    """
    if isinstance(condition, _Own):
        return condition.where(a, b)
    if getattr(condition, "shape", ()):
        return importlib.import_module("numpy").where(condition, plain(a), plain(b))
    return a if condition else b


def epsilon(like=0.0):
    """The relative round-off of numbers of the kind of ``like``: 2.2e-16, or for an mpf what its working precision gives.

    >>> epsilon(1.0) == 2.0**-52
    True
    """
    library = _library((like,))
    return +library.eps if library.__name__ == "mpmath" else 2.0**-52


def coarseness(values):
    """The largest relative round-off among numbers of several kinds; whole numbers and fractions have none.

    >>> coarseness([1, 2.0]) == 2.0**-52
    True
    """
    return max((epsilon(x) for x in values if x is not ZERO and _root(type(x)) != "fractions" and type(x) is not int), default=epsilon())


def unrounded(f, *values):
    """``f(*values)`` of numbers taken as exact, computed with four times their digits or more and rounded once: for differences in which the digits
    cancel.

    >>> (1 + 1e-20) - 1, unrounded(lambda x: (1 + x) - 1, 1e-20)
    (0.0, 1e-20)
    """
    mpmath, library = importlib.import_module("mpmath"), _library(values).__name__

    def once(*numbers):
        with mpmath.workprec(max(256, 4 * mpmath.mp.prec)):
            out = f(*map(mpmath.mpf, numbers))
        return +out if library == "mpmath" else float(out)

    if library != "numpy":
        return once(*values)
    numpy = importlib.import_module("numpy")
    return numpy.asarray(numpy.frompyfunc(once, len(values), 1)(*values), dtype=float)


def sampled(x):
    """A number for ``x``, to see whether it vanishes without simplifying it: a float, array or mpf itself; of a SymPy or SymEngine expression its
    value where every symbol (and function, and derivative) has a number of its own between 0.2 and 0.9; None where no value can be had.

    >>> sampled(2.0), sampled(ZERO)
    (2.0, 0)
    """
    if _root(type(x)) not in ("sympy", "symengine"):
        return x if is_numeric(x) else None
    sympy = importlib.import_module("sympy")
    x = sympy.sympify(x)
    parts = x.free_symbols | x.atoms(sympy.core.function.AppliedUndef, sympy.Derivative)
    chosen = {p: sympy.Float(0.2 + 0.7 * zlib.crc32(str(p).encode()) / 2**32, 40) for p in parts}
    try:
        value = complex(_inside_out(x, chosen))
    except TypeError:
        return None
    return 0.0 if abs(value) < 1e-25 else value.real or abs(value)


def _inside_out(x, known):
    """The value of a SymPy expression to 40 digits, each part computed once; evalf takes a time exponential in the depth where sums cancel."""
    if x not in known:
        value = x.func(*(_inside_out(a, known) for a in x.args)) if x.args else x
        known[x] = value if value.is_Rational else value.evalf(40)
    return known[x]


def least(x):
    """The smallest absolute value in ``x``, as a float: the instant of an array at which a divisor is nearest to zero."""
    smallest = abs(_value(x))
    return float(smallest.min(initial=math.inf)) if hasattr(smallest, "min") else float(smallest)


class Moving(_Own):
    """A scalar at one instant together with its first and second time rate (a jet of order two).

    Arithmetic and functions carry the rates along by the product and chain rules, so no step size enters.
    Make one with :func:`moving` or :func:`at`.
    """

    __slots__ = ("acceleration", "rate", "value")
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
        if isinstance(other, Scaled):
            return NotImplemented
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
        if isinstance(power, (Moving, Dimension)):
            raise ScalarError("a moving number can be raised to a constant power only; for others write exp(power*log(x))")
        if power is ZERO or (type(power) in (int, float) and power in (0, 1)):
            return self if power else 1
        u = self.value
        if self.rests():
            return Moving(u**power)
        return self._chain(u**power, power * u ** (power - 1), power * (power - 1) * u ** (power - 2))

    def rests(self):
        """Known to be constant: then a function may have no derivative here, as a square root at 0."""
        return self.rate is ZERO and self.acceleration is ZERO

    def __rpow__(self, base):
        return exp(self * log(self.value * 0 + base))  # the logarithm in the kind of the value, with all its digits

    def _chain(self, f, df, ddf):
        """The number f(self), given f and its first two derivatives at the value."""
        return Moving(f, df * self.rate, ddf * (self.rate * self.rate) + df * self.acceleration)

    def function(self, name, *args):
        """The function of this name, for :func:`function`."""
        if name == "atan2":
            y, x = (_as_moving(a) for a in args)
            square = x.value * x.value + y.value * y.value
            rate = (x.value * y.rate - y.value * x.rate) / square
            growth = 2 * (x.value * x.rate + y.value * y.rate)
            return Moving(atan2(y.value, x.value), rate, (x.value * y.acceleration - y.value * x.acceleration - rate * growth) / square)
        if self.rests():
            return Moving(function(name, self.value))
        return self._chain(*_DERIVATIVES[name](self.value))

    def pi(self):
        """The number pi in the kind of the value."""
        return pi(self.value)


def _reciprocal(f, df_inverse, ddf_factor):
    df = 1 / df_inverse
    return f, df, ddf_factor * df


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


def _as_moving(x):
    return x if isinstance(x, Moving) else Moving(scalar(x))


def moving(value, rate=None, acceleration=None):
    """A scalar with its rates at the instant, for angles and coordinates that change.

    ``rate`` and ``acceleration`` are d/dt and d2/dt2 of ``value``, in its unit per second and per second squared. One that is left
    out is derived if what precedes it is a SymPy or SymEngine expression in the symbol ``t``, and zero otherwise.

    >>> moving(2.0, rate=3.0)**2
    moving(4.0, rate=12.0, acceleration=18.0)
    """
    if type(value) is float and rate is None and acceleration is None:
        return Moving(value)
    if isinstance(value, Moving):
        if rate is not None or acceleration is not None:
            raise ScalarError(f"{value!r} already has its rates; leave out rate= and acceleration=, or pass its value alone")
        return value
    if callable(value) and _root(type(value)) not in _LIBRARIES:
        raise ScalarError("a function of time needs an instant: pass at(f, t) instead of f")
    value = scalar(value)
    rate = _derived(value) if rate is None else whole(scalar(rate), value)
    return Moving(value, rate, _derived(rate) if acceleration is None else whole(scalar(acceleration), value))


def _derived(x):
    """dx/dt of a symbolic expression in ``t``, whatever the assumptions that ``t`` was made with; zero for any other number."""
    if x is ZERO or type(x) is float or _root(type(x)) not in ("sympy", "symengine"):
        return ZERO
    times = [s for s in x.free_symbols if str(s) == "t"]
    if len(times) > 1:
        raise ScalarError(f"{x} holds {len(times)} different symbols named t; make one t = Symbol('t') and use it throughout")
    derivative = x.diff(times[0]) if times else ZERO
    return ZERO if derivative == 0 else derivative


def at(f, t):
    """The function of time ``f`` at the instant ``t`` (s), with its first and second rate, exactly and without a step size.

    ``f`` uses the functions of this module (``from newton_euler import sin, sqrt …``); ``t`` may be of any kind.

    >>> at(lambda t: t**3, 2.0)
    moving(8.0, rate=12.0, acceleration=12.0)
    """
    return _as_moving(f(Moving(t, whole(1, t))))  # a rate of the kind of t, or constants of 16 digits are multiplied before they meet it


class Linear(_Own):
    """``value + c[0]*u[0] + c[1]*u[1] + …``: a scalar that is linear in unknowns, for the equations of :mod:`newton_euler.linear`.

    Running conditions on it reads off their coefficients, each in its own unit. A product of unknowns, or a function of one, raises
    :class:`ScalarError`.

    >>> 3.0 * Linear(2.0, (1, ZERO)) - Linear(ZERO, (ZERO, 1))
    Linear(6.0, (3.0, -1))
    """

    __slots__ = ("coefficients", "value")
    rank = 5

    def __init__(self, value, coefficients):
        self.value, self.coefficients = value, tuple(coefficients)

    def __repr__(self):
        return f"Linear({plain(self.value)!r}, {tuple(map(plain, self.coefficients))!r})"

    def _each(self, change):
        return Linear(change(self.value), map(change, self.coefficients))

    def __add__(self, other):
        if isinstance(other, Moving):
            return NotImplemented
        if isinstance(other, Linear):
            return Linear(self.value + other.value, (a + b for a, b in zip(self.coefficients, other.coefficients, strict=True)))
        return Linear(self.value + scalar(other), self.coefficients)

    __radd__ = __add__

    def __neg__(self):
        return self._each(lambda x: -x)

    def __sub__(self, other):
        return self + -other

    def __rsub__(self, other):
        return -self + other

    def __mul__(self, other):
        if other is ZERO:
            return ZERO
        if isinstance(other, (Moving, Scaled)):
            return NotImplemented
        if isinstance(other, Linear):
            raise ScalarError("two unknowns are multiplied; the conditions must be linear in them, as velocities are in rates")
        return self._each(lambda x: x * other)

    __rmul__ = __mul__

    def __truediv__(self, other):
        if isinstance(other, Linear):
            raise ScalarError("an unknown stands in a denominator; the conditions must be linear in the unknowns, as velocities are in rates")
        return NotImplemented if isinstance(other, Moving) else self._each(lambda x: x / other)

    def __rtruediv__(self, other):
        raise ScalarError("an unknown stands in a denominator; the conditions must be linear in the unknowns, as velocities are in rates")

    def function(self, name, *args):
        """The function of this name, for :func:`function`."""
        raise ScalarError(f"{name} is taken of an unknown; the conditions must be linear in the unknowns, as velocities are in rates")

    def __pow__(self, power):
        raise ScalarError("an unknown is raised to a power; the conditions must be linear in the unknowns, as velocities are in rates")

    def pi(self):
        """The number pi in the kind of the value."""
        return pi(self.value)


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
        if isinstance(other, (Moving, Linear)):
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
        if isinstance(other, (Moving, Linear, Scaled)):
            return NotImplemented
        return Dimension(*(a + b for a, b in zip(self.powers, _as_dimension(other).powers, strict=True)))

    __rmul__ = __mul__

    def __truediv__(self, other):
        if isinstance(other, (Moving, Linear, _Zero)):
            return NotImplemented
        return Dimension(*(a - b for a, b in zip(self.powers, _as_dimension(other).powers, strict=True)))

    def __rtruediv__(self, other):
        return _as_dimension(other) / self

    def __pow__(self, power):
        if isinstance(power, (Moving, Dimension)):
            if any(self.powers):
                raise DimensionError(f"{self} is raised to a power that varies: its dimension would vary too")
            return NotImplemented if isinstance(power, Moving) else exp(power)
        power = Fraction(power if isinstance(power, Fraction) else float(power)).limit_denominator(1000)  # 1/3 is not a float
        return Dimension(*(a * power for a in self.powers))

    def function(self, name, *args):
        """The function of this name, for :func:`function`."""
        if name == "sqrt":
            return self ** Fraction(1, 2)
        if name == "atan2":
            _ = args[0] + args[1] if args[0] is not ZERO and args[1] is not ZERO else None
        elif any(self.powers):
            raise DimensionError(f"{name} of a quantity with {self}: its argument must be a pure number (an angle, a ratio)")
        return Dimension()


def _as_dimension(x):
    if isinstance(x, Dimension):
        return x
    scalar(x)  # or it is no number at all
    return Dimension()

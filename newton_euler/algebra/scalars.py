"""Functions of numbers of every kind: sin, sqrt, where …, and the structural zero.

Every formula of the engine is written once over *scalars*: a Python float, a NumPy array (many
instants at once), an ``mpmath.mpf``, an expression of SymPy, SymEngine or heyoka, or one of these:

``ZERO``        a zero known from the structure of a formula; it vanishes from sums and products
``Moving``      a value with its first and second rate in time (:mod:`newton_euler.algebra.jets`)
``Dimension``   no value at all, only powers of mass, length and time: a formula that runs on it has
    consistent units (:mod:`newton_euler.algebra.units`)
``LinearForm``  a sum of unknowns with coefficients (:mod:`newton_euler.algebra.linear`)
``Step``        a value being traced by :func:`newton_euler.algebra.compile.compiled`

This is the only module that tests the type of a number. It imports none of the heavy libraries:
that of a number is found by the number's type.
"""

import math
import sys
import zlib
from collections.abc import Callable, Iterable
from contextlib import suppress
from fractions import Fraction
from functools import cache, reduce, wraps
from importlib import import_module
from types import ModuleType, SimpleNamespace
from typing import TYPE_CHECKING, Any, TypeAlias

FUNCTIONS = (
    "sin", "cos", "tan", "asin", "acos", "atan", "sinh", "cosh", "tanh", "exp", "log", "sqrt",
)  # fmt: skip
_by_type: Any = cache  # for a type checker classes are not hashable
LIBRARIES = {"numpy", "mpmath", "sympy", "symengine", "heyoka"}

# The type of a number of any kind. The kinds share their operators but no base class, so a type
# checker cannot know more; when a program runs, it is a class by which annotations are read.
if TYPE_CHECKING:
    Scalar: TypeAlias = Any
else:

    class Scalar:
        """A number of any kind: float, array, mpf, expression."""


Triple: TypeAlias = tuple[Scalar, ...]  # three of them: components, moments, coordinates
Rows: TypeAlias = tuple[Triple, ...]  # three of them: a matrix


class NewtonEulerError(Exception):
    """Base of the engine's errors; each is also the built-in error that fits it, as ValueError.

    >>> from newton_euler import Frame, NewtonEulerError
    >>> try:
    ...     Frame("ground").point("P", 1.0, 0, 0).velocity()
    ... except NewtonEulerError as error:
    ...     print(type(error).__name__)
    FrameError
    """


class ScalarError(NewtonEulerError, TypeError):
    """An argument is not a number of any known kind, or its kind does not have the operation."""


class SingularError(NewtonEulerError, ValueError):
    """A direction, radius, rate or integral does not exist here, as on an axis, at a pole."""


class DivisionError(SingularError, ZeroDivisionError):
    """A quotient does not exist here: its divisor is zero."""


class RangeError(SingularError, OverflowError):
    """A number is too large for a float."""


class _Own:
    """Base of the kinds of number that the engine defines."""

    __slots__ = ()
    _op_priority = 1000.0  # SymPy hands operations over
    rank = 0  # the kind of the highest rank in an operation decides

    def __init_subclass__(cls) -> None:
        if not hasattr(cls, "__array_priority__"):
            # NumPy hands operations over, too, and does not loop over elements
            cls.__array_ufunc__ = None  # type: ignore[attr-defined]

    def is_numeric(self) -> bool:
        """True if the number has a value that can be compared."""
        return False

    def without_rates(self) -> Scalar:
        """The value alone, for :func:`without_rates`."""
        return self

    def __pos__(self):
        return self

    def __sub__(self, other):
        return self + -scalar(other)

    def __rsub__(self, other):
        return -self + other

    def __rpow__(self, base):
        return exp(self * log(base))


class Unordered:
    """Base of numbers that are not one value; where one is needed, an error says what to write.

    advice : what to write instead
    """

    __slots__ = ()
    advice = ""

    def _no_value(self, *_):
        raise ScalarError(
            f"{clipped(self)} is not one value, which could be compared, rounded (int, round, %, "
            f"//) or passed to math and NumPy: {self.advice}"
        )

    __lt__ = __le__ = __gt__ = __ge__ = __bool__ = __float__ = __int__ = __round__ = _no_value
    __mod__ = __rmod__ = __floordiv__ = __rfloordiv__ = __divmod__ = __rdivmod__ = _no_value
    __trunc__ = __floor__ = __ceil__ = _no_value

    def __eq__(self, other: object) -> bool:
        return self is other or self._no_value()

    __hash__ = object.__hash__


def outranks(x: object, kind: _Own | type[_Own]) -> bool:
    """True if ``x``, a number of the engine, carries out an operation with one of this ``kind``."""
    return isinstance(x, _Own) and x.rank > kind.rank


def highest(values: Iterable[Scalar]) -> Any:
    """The one of these values, of the engine's kinds, that carries out an operation; or None."""
    own = [x for x in values if isinstance(x, _Own)]
    return max(own, key=lambda x: x.rank) if own else None


class Scaled:
    """Base of vectors and other quantities that carry out the product with a scalar."""

    __slots__ = ()
    __array_ufunc__ = None


class _Zero(_Own):
    """The only object of its class is :data:`ZERO`. A sum with it is the other term itself."""

    __slots__ = ()

    def is_numeric(self) -> bool:
        """True: it is the number 0."""
        return True

    def without_rates(self) -> int:
        """The integer 0."""
        return 0

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
            raise DivisionError("0/0: both are zero by the structure of the formula")
        return self

    def __rtruediv__(self, other):
        raise DivisionError(f"{other!r} is divided by a structural zero: its divisor is always 0")

    def __pow__(self, power):
        power = without_rates(power)
        if is_numeric(power) and power < 0:
            raise DivisionError(f"0 to the power {power}")
        return 1 if is_numeric(power) and power == 0 else self

    def __neg__(self):
        return self

    __abs__ = __neg__

    def __eq__(self, other):
        return isinstance(other, _Zero) or other == 0

    def __hash__(self):
        return hash(0)

    def __bool__(self) -> bool:
        return False

    def __float__(self) -> float:
        return 0.0

    def __int__(self):
        return 0

    __index__ = __int__

    def __repr__(self):
        return "0"

    def __reduce__(self):
        return "ZERO"

    def function(self, name: str, *others: Scalar) -> Scalar:
        """The value of this function at 0."""
        if name in ("cos", "cosh", "exp"):
            return 1
        if name in ("log", "acos"):
            return getattr(math, name)(0.0)
        return self


ZERO = _Zero()


def scalar(x: object) -> Scalar:
    """The scalar ``x``; a literal ``0`` becomes the structural zero.

    Whole numbers of NumPy, which overflow silently, become numbers that do not: an array of them
    (and of bool, and of floats of fewer digits) an array of 64-bit floats, which rounds entries
    above 2**53, a single one a Python integer, which is exact. Raises :class:`ScalarError` if ``x``
    is not a number (text, None, lists, arrays without entries), or has a unit of its own, as those
    of pint and astropy.

    >>> scalar(0) is ZERO, scalar(0.0), scalar(1.5)
    (True, 0.0, 1.5)
    """
    if type(x) is float or isinstance(x, _Own):
        return x
    if type(x) in (int, bool):
        return x or ZERO
    kind = _kind(type(x))
    if kind == "number":
        return x
    if kind == "numpy":
        return _of_numpy(x)
    raise ScalarError(
        f"expected a number (float, array, mpf or expression), got {clipped(x)} of type "
        f"{type(x).__name__}{advice(x)}"
    )


@_by_type
def _kind(kind):
    """ "number" for a type of numbers, "numpy" for one of NumPy, which has more than numbers."""
    root, name = _root(kind), kind.__name__
    if (
        issubclass(kind, (float, int, Fraction, complex))  # np.float64 too
        or (root == "sympy" and issubclass(kind, import_module("sympy").Expr))
        or (root == "symengine" and "Matrix" not in name and hasattr(kind, "diff"))
        or (root == "mpmath" and name != "matrix")
        or (root == "heyoka" and name == "expression")
    ):
        return "number"
    array = root == "numpy" and hasattr(kind, "dtype") and not hasattr(kind, "mask")
    return "numpy" if array and name != "matrix" else "none"


def _of_numpy(x):
    """The number or array ``x`` of NumPy with at least the digits of a Python float."""
    kind, size = x.dtype.kind, x.dtype.itemsize
    if x.size == 0:
        raise ScalarError(f"expected numbers, got {clipped(x)} of {x.dtype}, which is empty")
    if (kind == "f" and size >= 8) or (kind == "c" and size >= 16):
        return x
    array = hasattr(x, "__setitem__")
    if kind in "biufc":
        if array:
            return x.astype(complex if kind == "c" else float)
        return scalar(x.item() if kind != "b" else int(x))
    if kind != "O" or not array:
        raise ScalarError(
            f"expected a number or an array of numbers, got {clipped(x)} of type "
            f"{type(x).__name__} of {x.dtype}; convert it to floats first"
        )
    kinds = {type(scalar(entry)) for entry in x.flat}
    try:
        return x.astype(float) if kinds <= {float, int, bool, Fraction, _Zero} else x
    except OverflowError as error:
        raise RangeError(f"an array has an entry that is no float: {error}") from error


def real_scalar(x: object) -> Scalar:
    """The :func:`scalar` of a quantity of mechanics. Raises :class:`ScalarError` also for complex
    numbers and arrays without numbers, which have no meaning there.

    >>> real_scalar(1 + 2j)
    Traceback (most recent call last):
        ...
    newton_euler.algebra.scalars.ScalarError: expected real numbers, got (1+2j) of type complex; \
give its real part, if that is meant
    """
    if type(x) is float:
        return x
    y = scalar(x)
    if type(y) is not int and not isinstance(y, _Own) and _is_unreal(y):
        raise ScalarError(
            f"expected real numbers, got {clipped(x)} of type {type(x).__name__}{advice(x)}"
        )
    return y


def _is_unreal(x):
    if (dtype := getattr(x, "dtype", None)) is None:
        return isinstance(x, complex) or type(x).__name__ == "mpc"
    size, kind = getattr(x, "size", 1), getattr(dtype, "kind", "")  # others have a dtype, too
    return not size or kind == "c" or (kind == "O" and any(map(_is_unreal, getattr(x, "flat", ()))))


def advice(x: object) -> str:
    """What to do with a value that is not a number, as the end of a message."""
    if getattr(x, "shape", ()) and getattr(x, "size", 1) == 0:
        return "; it is empty"
    if _is_unreal(x):
        return "; give its real part, if that is meant"
    if hasattr(x, "magnitude") and hasattr(x, "to"):
        return "; it has a unit: pass the number in your base units, as q.to('m').magnitude"
    if hasattr(x, "unit"):
        return "; it has a unit: pass the number in your base units, as q.to_value('m')"
    if isinstance(x, str):
        return "; write numbers without quotation marks"
    if hasattr(x, "compressed"):
        return "; what is masked has no value: pass x.compressed()"
    if isinstance(x, (list, tuple)):
        return "; for many values at once pass an array, as numpy.array([...])"
    if _root(type(x)) == "decimal":
        return "; pass float(x), or mpmath.mpf(str(x)) for more digits"
    if callable(x):
        return "; a function of time needs an instant, as at(f, t)"
    return ""


def clipped(x: object) -> str:
    """The ``repr`` of a value for a message, at most 80 characters of it."""
    text = ""
    try:
        for piece in _pieces(x):
            text += piece
            if len(text) > 80:
                return text[:77] + "..."
    except Exception:  # an object of any library may fail to describe itself
        return f"an object of {type(x).__name__}"
    return text


def _pieces(x):
    """The ``repr`` of a value in pieces: that of a list of a million numbers takes a second."""
    first, last = {list: "[]", tuple: "()", dict: "{}"}.get(type(x), ("", ""))
    if not first:
        yield short_repr(x)
        return
    yield first
    for n, y in enumerate(x):
        yield ", " * bool(n)
        yield from _pieces(y)
        if type(x) is dict:
            yield ": "
            yield from _pieces(x[y])
    yield "," * (type(x) is tuple and len(x) == 1) + last


LONGEST = 400  # operations: the most of an expression that is printed


def short_repr(x: Scalar) -> str:
    """The ``repr`` of a scalar; of an expression with more than :data:`LONGEST` operations only
    their number, since its text repeats the parts that are shared.
    """
    if _root(type(x)) not in ("sympy", "symengine") or not hasattr(x, "args"):
        return repr(x)
    count = operations(x)
    if count <= LONGEST:
        return repr(x)
    many = f"{count}" if count < 1e9 else f"{float(count):.1e}"
    return f"<expression of {many} operations>"


def operations(x: Scalar) -> int:
    """The number of operations in the text of an expression; each part is visited once."""
    known: dict = {}
    waiting = [x]
    while waiting:
        part = waiting[-1]
        if part in known:
            waiting.pop()
            continue
        if missing := [a for a in part.args if a not in known]:
            waiting += missing
        else:
            own = max(len(part.args) - 1, 1) if part.args else 0
            known[waiting.pop()] = own + sum(known[a] for a in part.args)
    return known[x]


def real(x: object, what: str) -> Scalar:
    """One real number ``x``, as a tolerance is; ``what`` names it in the error."""
    if type(x) is float:
        return x
    y = to_plain(scalar(x))
    several = isinstance(y, _Own) or bool(getattr(y, "shape", ()))
    if several or not is_numeric(y) or _is_unreal(y) or y != y:
        raise ScalarError(f"{what} is one real number; got {clipped(x)}")
    return y


def allowed(tolerance: object) -> float:
    """A tolerance: one real number that is not negative, a float."""
    y = real(tolerance, "a tolerance")
    try:
        y = float(y)
    except OverflowError:  # an integer beyond floats
        y = math.inf if y > 0 else -math.inf
    if not y >= 0:
        raise ScalarError(f"a tolerance is not negative; got {clipped(tolerance)}")
    return y


def integer_like(x: Scalar, like: Scalar) -> Scalar:
    """The integer ``x`` in the kind of ``like``, to be as exact as that; others unchanged."""
    exact = type(x) is int and _root(type(like)) in ("mpmath", "sympy", "symengine")
    return like * 0 + x if exact else x


def to_plain(x: Scalar) -> Scalar:
    """The number ``x``; the structural zero as the integer 0."""
    return 0 if x is ZERO else x


def without_rates(x: Scalar) -> Scalar:
    """The value of ``x`` alone, to be compared; the structural zero as the integer 0."""
    return x.without_rates() if isinstance(x, _Own) else x


def short(x: Scalar) -> str:
    """The number as text with six digits, for messages; expressions and arrays in full."""
    if is_numeric(x) and not getattr(x, "shape", ()) and not isinstance(x, complex):
        return f"{float(x):.6g}"
    return short_repr(x) if _root(type(x)) in ("sympy", "symengine") else str(x)


@_by_type
def _root(kind):
    """The name of the library that a type belongs to."""
    # SymPy's q(t) has a class without a module
    return next(k.__module__ for k in kind.__mro__ if k.__module__).partition(".")[0]


def library_of(values: Iterable[Scalar]) -> ModuleType:
    """The module of functions of these values: that of an expression before mpmath before NumPy."""
    roots = {_root(type(v)) for v in values}
    for name in ("heyoka", "sympy", "symengine", "mpmath", "numpy"):
        if name in roots:
            return _library(name)
    return import_module("cmath") if complex in map(type, values) else math


@cache
def _library(name):
    """The module of this name; mpmath without complex values of real numbers, as for floats."""
    if name != "mpmath":
        return import_module(name)
    import mpmath

    def real(f):
        def of_real(x):
            y = f(x)
            if isinstance(y, mpmath.mpc) and not isinstance(x, (mpmath.mpc, complex)):
                raise ValueError("math domain error")
            return y

        return of_real

    changed = {name: real(getattr(mpmath, name)) for name in ("asin", "acos", "log", "sqrt")}
    return SimpleNamespace(**{**vars(mpmath), **changed})


def in_range(f: Callable[..., Any]) -> Callable[..., Any]:
    """A decorator: a result that is too large for a float is refused in words."""

    @wraps(f)
    def call(*args, **named):
        try:
            return f(*args, **named)
        except OverflowError as error:
            raise RangeError(f"{f.__name__} has no value here: {error}") from error

    return call


def function(name: str, *args: Scalar) -> Scalar:
    """The function ``name`` (of :data:`FUNCTIONS`, or ``atan2``) of scalars of any kind."""
    if (chosen := highest(args)) is not None:
        return chosen.function(name, *args)
    args = tuple([0 if (x := scalar(a)) is ZERO else x for a in args])
    try:
        return getattr(library_of(args), name)(*args)
    except (ValueError, OverflowError) as error:
        raise _outside(name, args, error) from None
    except (AttributeError, TypeError) as error:
        given = ", ".join(map(clipped, args))
        raise ScalarError(f"there is no {name} of {given}: {error}") from None


def _outside(name, args, error):
    """The error for an argument at which a function has no value, or one that is not a float."""
    kind = RangeError if isinstance(error, OverflowError) else SingularError
    return kind(f"{name}({', '.join(map(clipped, args))}) has no value: {error}")


def _define(name):
    quick = getattr(math, name)

    def f(x: Scalar) -> Scalar:
        if type(x) is float:
            try:
                return quick(x)
            except (ValueError, OverflowError) as error:
                raise _outside(name, (x,), error) from None
        return function(name, x)

    f.__name__ = f.__qualname__ = name
    f.__doc__ = f"The {name} of a scalar of any kind; angles in radians."
    return f


sin, cos, tan, asin, acos, atan, sinh, cosh, tanh, exp, log, sqrt = map(_define, FUNCTIONS)


def hypot(*values: Scalar) -> Scalar:
    """The root of the sum of the squares, though the squares overflow or underflow as floats.

    >>> hypot(3e-200, 4e-200), hypot(ZERO, ZERO)
    (5e-200, 0)
    """
    some = [x for x in values if x is not ZERO]
    for x in some:
        if type(x) is not float:
            break
    else:
        return math.hypot(*some) if some else ZERO
    if all(type(x) in (float, int, Fraction) for x in some):
        with suppress(OverflowError):  # a whole number beyond floats: the root below says so
            return math.hypot(*some)
    if all(type(x) is float or getattr(getattr(x, "dtype", None), "kind", "") == "f" for x in some):
        return _hypot_of_arrays(import_module("numpy"), some)
    return sqrt(sum((x * x for x in some), ZERO))


def _hypot_of_arrays(numpy, values):
    if max(numpy.size(x) for x in values) < 100:  # longer: it takes ten times as long as the root
        return reduce(numpy.hypot, values, 0.0)
    with numpy.errstate(over="ignore"):
        square = sum(x * x for x in values)
        root = numpy.sqrt(square)
    if square.min() > 1e-280 and square.max() < 1e300:
        return root
    lost = ~((square > 1e-280) & (square < 1e300))  # digits of the squares, or all of them
    root[lost] = reduce(numpy.hypot, (numpy.broadcast_to(x, root.shape)[lost] for x in values), 0.0)
    return root


def atan2(y: Scalar, x: Scalar) -> Scalar:
    """The angle of the point (x, y) from the x axis, in (-pi, pi], for scalars of any kind.

    >>> atan2(1.0, -1.0) == 3*math.pi/4
    True
    """
    if y is ZERO and x is ZERO:
        raise DivisionError("the direction of a zero vector is undefined: atan2(0, 0)")
    if type(y) is float and type(x) is float:
        return math.atan2(y, x)
    if isinstance(y, _Zero) and not isinstance(x, _Own):
        return function("atan2", 0 * x + 0, x)  # +0.0, even where x is negative
    if isinstance(x, _Zero) and not isinstance(y, _Own):
        return function("atan2", y, 0 * y)
    return function("atan2", y, x)


def pi(like: Scalar = 0.0) -> Scalar:
    """The number pi in the kind of ``like``: with all digits of an mpf; for an expression a symbol.

    >>> pi(1.0)
    3.141592653589793
    """
    if isinstance(like, _Own):
        return like.pi() if hasattr(like, "pi") else pi(getattr(like, "value", 0.0))
    if type(like) is not float:
        scalar(like)  # or it is not a number
    library = library_of((like,))
    return +library.pi if library.__name__ == "mpmath" else getattr(library, "pi", math.pi)


@in_range
def radians(degrees: Scalar) -> Scalar:
    """The angle in radians, as exact as the kind of number allows.

    >>> radians(180.0) == math.pi
    True
    """
    degrees = to_plain(scalar(degrees))
    return degrees * pi(degrees) / 180


def is_numeric(x: Scalar) -> bool:
    """True if ``x`` has a value that can be compared; not for an expression or a dimension.

    >>> from newton_euler import Dimension
    >>> is_numeric(1.0), is_numeric(Dimension(1))
    (True, False)
    """
    if type(x) is float:
        return True
    if isinstance(x, _Own):
        return x.is_numeric()
    kind = _kind(type(x))
    if kind != "number":
        return kind == "numpy"
    root = _root(type(x))
    if root in ("sympy", "symengine"):
        return bool(x.is_Number)
    return root != "heyoka"


def is_expression(x: Scalar) -> bool:
    """True of an expression with symbols: no number, and no kind of the engine's own."""
    return not is_numeric(x) and not isinstance(x, _Own)


def promote(*values: Scalar) -> tuple[Scalar, ...]:
    """The values, each with the digits and instants of the others; others stay."""
    values = tuple(to_plain(scalar(x)) for x in values)
    if not all(map(is_numeric, values)):
        return values
    like = 0.0 * sum(values)
    return tuple(x + like for x in values)


def is_comparable(x: Scalar) -> bool:
    """True if ``x`` can be compared for a :func:`where`: numbers, and values being traced."""
    return is_numeric(x) or hasattr(x, "where")


def is_zero(x: Scalar) -> bool:
    """True if ``x`` is certainly zero: structurally, or a number (all of an array) equal to 0.

    >>> is_zero(0.0), is_zero(ZERO), is_zero(1e-300)
    (True, True, False)
    """
    if not is_numeric(x):
        return False
    equal = without_rates(x) == 0
    return bool(equal.all() if hasattr(equal, "all") else equal)


def vanishes(x: Scalar, small: float = 0) -> bool:
    """True if the number ``x``, or an element of it, is at most ``small`` in size."""
    return is_numeric(x) and min_abs(x) <= small


def is_positive(x: Scalar) -> bool:
    """True if the number ``x`` (all of an array) is positive; True of an expression."""
    x = without_rates(x)
    return not is_numeric(x) or (min_abs(x) > 0 and max_abs(x - abs(x)) == 0)


def is_finite(x: Scalar) -> bool:
    """False if ``x`` (or an element of it) is nan or infinite; True of expressions."""
    if not is_numeric(x):
        return True
    x = without_rates(x)
    root = _root(type(x))
    if root == "numpy":
        return bool(import_module("numpy").isfinite(x).all())
    # SymEngine does not know of its own floats whether they are finite
    if root in ("sympy", "symengine"):
        return bool(import_module("sympy").sympify(x).is_finite)
    return abs(x) < float("inf")


def max_abs(x: Scalar) -> float:
    """The largest absolute value in ``x``, as a float, to be compared with a tolerance."""
    largest = abs(without_rates(x))
    return _float(largest.max(initial=0) if hasattr(largest, "max") else largest)


def _float(size):
    """A size as a float, which is 0 only of 0."""
    return float(size) or math.ulp(0.0) * (size != 0)


def largest_abs(values: Iterable[Scalar]) -> float:
    """The largest absolute value among those that are numbers; 0.0 without any."""
    return max((max_abs(x) for x in values if is_numeric(x)), default=0.0)


def min_abs(x: Scalar) -> float:
    """The smallest absolute value in ``x``, as a float: that of a divisor nearest to zero."""
    smallest = abs(without_rates(x))
    return _float(smallest.min(initial=math.inf) if hasattr(smallest, "min") else smallest)


def where(condition: Scalar, a: Scalar, b: Scalar) -> Scalar:
    """``a`` where the condition holds, else ``b``; instant by instant for an array of conditions.
    For numbers, traced values and dimensions, not expressions. Both are computed before one is
    chosen: a divisor that is zero where the quotient is not chosen must be replaced first.

    >>> where(2.0 > 1.0, "larger", "smaller")
    'larger'
    """
    if isinstance(condition, _Own) and hasattr(condition, "where"):
        return condition.where(a, b)
    if not isinstance(condition, (bool, int, float)) and _root(type(condition)) not in LIBRARIES:
        raise ScalarError(f"where chooses by a comparison, as x > 0, got {clipped(condition)}")
    if getattr(condition, "shape", ()):
        # words may be chosen too
        a, b = (x if isinstance(x, str) else to_plain(scalar(x)) for x in (a, b))
        return sys.modules["numpy"].where(condition, a, b)  # the condition is of NumPy
    try:
        return a if condition else b
    except (TypeError, ValueError) as error:
        raise ScalarError(f"{clipped(condition)} is not known to hold or not: {error}") from None


def anywhere(condition: Scalar) -> bool:
    """True if the condition holds; of an array of conditions, if it holds at any instant."""
    return bool(max_abs(where(condition, 1, 0)))


def epsilon(like: Scalar = 0.0) -> Scalar:
    """The relative round-off of numbers of the kind of ``like``: 2.2e-16, or mpmath's."""
    library = library_of((like,))
    return +library.eps if library.__name__ == "mpmath" else 2.0**-52


def unit_roundoff(values: Iterable[Scalar]) -> Scalar:
    """The largest relative round-off among numbers of several kinds; integers have none."""
    rounded = (x for x in values if x is not ZERO and type(x) not in (int, Fraction))
    return max(map(epsilon, rounded), default=epsilon())


def with_extra_digits(f: Callable[..., Scalar], *values: Scalar) -> Scalar:
    """``f(*values)`` of numbers taken as exact, with four times their digits or more, rounded once.

    >>> (1 + 1e-20) - 1, with_extra_digits(lambda x: (1 + x) - 1, 1e-20)
    (0.0, 1e-20)
    """
    mpmath, library = import_module("mpmath"), library_of(values).__name__

    def once(*numbers):
        with mpmath.workprec(max(256, 4 * mpmath.mp.prec)):
            out = f(*map(mpmath.mpf, numbers))
        return +out if library == "mpmath" else float(out)

    if library != "numpy":
        return once(*values)
    numpy = import_module("numpy")
    return numpy.asarray(numpy.frompyfunc(once, len(values), 1)(*values), dtype=float)


def probe(x: Scalar) -> Scalar:
    """A number that tells whether ``x`` vanishes without simplifying it: a float, array or mpf
    itself; of a SymPy or SymEngine expression its value where every symbol (and function, and
    derivative) has a number of its own between 0.2 and 0.9; None if there is no value.

    >>> probe(2.0), probe(ZERO)
    (2.0, 0)
    """
    if _root(type(x)) not in ("sympy", "symengine"):
        return x if is_numeric(x) else None
    sympy = import_module("sympy")
    x = sympy.sympify(x)
    # numbers by a checksum of what the parts are (symbols may share a name): the same in every run,
    # without a pattern
    parts = x.free_symbols | x.atoms(sympy.core.function.AppliedUndef, sympy.Derivative)
    shares = {p: zlib.crc32(sympy.srepr(p).encode()) / 2**32 for p in parts}
    known = {p: sympy.Float(0.2 + 0.7 * s, 40) for p, s in shares.items()}
    try:
        value = complex(_inside_out(x, known))
    except TypeError:
        return None
    return None if value != value else value.real or abs(value)


def _inside_out(x, known):
    """The value of a SymPy expression to 40 digits, each part once; evalf may take very long. A sum
    in which 25 of them cancel is zero.
    """
    if x not in known:
        args = [_inside_out(a, known) for a in x.args]
        value = x.func(*args) if args else x
        known[x] = value = value if value.is_Rational else value.evalf(40)
        if x.is_Add and abs(value) < 1e-25 * max(map(abs, args)):
            known[x] = x.func()
    return known[x]

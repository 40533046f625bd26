"""Dimensions, and units by name with exact factors to the coherent base kg, m, s, rad.

``Unit("rev/min")`` or ``Unit("slug*ft^2")``: names joined by ``*`` and ``/``, powers by ``^``.
``lb`` is the pound of force, ``slug`` what it accelerates at 1 ft/s^2; angles are pure.
"""

import re
from fractions import Fraction
from functools import cache
from operator import add, sub

from . import scalars
from .names import did_you_mean
from .scalars import ZERO, Scalar, Scaled, _Own, clipped, outranks, pi, scalar, to_plain


class DimensionError(scalars.ScalarError):
    """Different dimensions are added, or a function is taken of one that is not a pure number."""


class Dimension(_Own):
    """The powers of mass, length and time in a quantity, as a scalar without a value. Angles, and
    numbers written in a formula, are pure. Adding unlike dimensions raises :class:`DimensionError`,
    so one run of a formula on dimensions proves its units.

    >>> length, time = Dimension(0, 1, 0), Dimension(0, 0, 1)
    >>> length/time**2 + 2*length/time**2
    Dimension(L^1 T^-2)
    """

    __slots__ = ("powers",)
    rank = 1

    def __init__(self, mass: Scalar = 0, length: Scalar = 0, time: Scalar = 0):
        try:
            self.powers = tuple(map(Fraction, (mass, length, time)))
        except (TypeError, ValueError, OverflowError, ZeroDivisionError):
            raise DimensionError(
                f"a dimension is three numbers, as (1, 2, -2), not {clipped((mass, length, time))}"
            ) from None

    def __repr__(self):
        named = [f"{n}^{p}" for n, p in zip("MLT", self.powers, strict=True) if p]
        return f"Dimension({' '.join(named) or '1'})"

    def __str__(self):
        """In SI units, "kg m/s^2"; of a pure number in words."""
        named = [f"{u}^{p}".removesuffix("^1") for u, p in self._units if p > 0]
        below = [f"{u}^{-p}".removesuffix("^1") for u, p in self._units if p < 0]
        if not named and not below:
            return "a pure number"
        over = f"({' '.join(below)})" if len(below) > 1 else "".join(below)
        return (" ".join(named) or "1") + (f"/{over}" if over else "")

    @property
    def _units(self):
        return zip(("kg", "m", "s"), self.powers, strict=True)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Dimension) and self.powers == other.powers

    def __hash__(self):
        return hash(self.powers)

    def __add__(self, other: Scalar) -> "Dimension":
        if _is_nothing(other):  # sum() begins with 0
            return self
        if outranks(other, self):
            return NotImplemented
        if (other := _as_dimension(other)) != self:
            raise DimensionError(f"cannot add {other} to {self}: look at the units")
        return self

    __radd__ = __sub__ = __rsub__ = __add__

    def __neg__(self) -> "Dimension":
        return self

    __abs__ = __neg__

    def __mul__(self, other: Scalar) -> Scalar:
        if _is_nothing(other):
            return ZERO
        if isinstance(other, Scaled) or outranks(other, self):
            return NotImplemented
        return Dimension(*map(add, self.powers, _as_dimension(other).powers))

    __rmul__ = __mul__

    def __truediv__(self, other: Scalar) -> "Dimension":
        if other is ZERO or outranks(other, self):
            return NotImplemented
        return Dimension(*map(sub, self.powers, _as_dimension(other).powers))

    def __rtruediv__(self, other: Scalar) -> Scalar:
        return ZERO if _is_nothing(other) else _as_dimension(other) / self

    def __lt__(self, other: Scalar) -> "Compared":
        """A comparison for :func:`~newton_euler.where`; of unlike quantities it raises."""
        if outranks(other, self):
            return NotImplemented
        if to_plain(other) != 0 and _as_dimension(other) != self:
            raise DimensionError(f"cannot compare {self} with {other}: look at their units")
        return Compared()

    __le__ = __gt__ = __ge__ = __lt__

    def __pow__(self, power: Scalar) -> "Dimension":
        if isinstance(power, Dimension) or outranks(power, self):
            if any(self.powers):
                raise DimensionError(
                    f"{self} is raised to a power that varies: its dimension would vary too"
                )
            return scalars.exp(power) if isinstance(power, Dimension) else NotImplemented
        # a float is not 1/3 exactly, but the power 1/3 of L^3 is to be L
        try:
            power = Fraction(power if isinstance(power, Fraction) else float(power))
        except (TypeError, ValueError, OverflowError):
            raise DimensionError(f"{self} is raised to {clipped(power)}, not a number") from None
        power = power.limit_denominator(1000)
        return Dimension(*(a * power for a in self.powers))

    def _integrals(self, f, start, end):
        """The dimensions of the integrals of a tuple of scalars, for :func:`.integral`."""
        width = end - start  # raises unless the dimensions agree
        return tuple(y * width for y in f(start + width))

    def _over_cube(self, f, n):
        """The dimensions of integrals over the unit cube: those of the integrands."""
        return tuple(f(*(0.5,) * n))

    def _root(self, f, low, high):
        """The dimension of the root between ``low`` and ``high``, once f has run on it."""
        either = high - low
        f(low + either)
        return _as_dimension(either)

    def function(self, name: str, *args: Scalar) -> "Dimension":
        """The dimension of a function of a pure number; of sqrt and atan2 also of others."""
        if not isinstance(name, str):
            raise DimensionError(f"a function is named by a text, as 'sqrt'; got {clipped(name)}")
        if name == "sqrt":
            return self ** Fraction(1, 2)
        if name == "atan2":
            _ = args[0] + args[1]  # raises unless the dimensions agree
        elif any(self.powers):
            raise DimensionError(f"{name} of a quantity in {self}: it must be a pure number")
        return Dimension()


class Compared(_Own):
    """Comparing dimensions is neither true nor false: :func:`where` checks both its values."""

    __slots__ = ()

    def __bool__(self) -> bool:
        raise DimensionError("dimensions have no values to compare: choose by where(x < y, a, b)")

    def where(self, a: Scalar, b: Scalar) -> Scalar:
        """The dimension of ``a`` and ``b``; of words the first."""
        if isinstance(a, str) or isinstance(b, str):
            return a
        a, b = scalar(a), scalar(b)
        # a sum checks that both have one dimension
        return a + b if isinstance(a, Dimension) or isinstance(b, Dimension) else a


def _is_nothing(x):
    """True of a zero that is known from the structure of a formula, which has every dimension."""
    return x is ZERO or (type(x) is int and x == 0)


def _as_dimension(x):
    if isinstance(x, Dimension):
        return x
    scalars.real_scalar(x)  # or it is not a number at all
    return Dimension()


# exact by the international agreement of 1959, and the standard gravity of 1901
_INCH, _POUND_MASS, _STANDARD_G = map(Fraction, ("0.0254", "0.45359237", "9.80665"))
_POUND = _POUND_MASS * _STANDARD_G
_LENGTH, _TIME, _MASS = Dimension(0, 1, 0), Dimension(0, 0, 1), Dimension(1, 0, 0)
_PURE = Dimension()
_FORCE = _MASS * _LENGTH / _TIME**2

# name: (exact factor or its text, power of pi in it, dimension)
UNITS: dict[str, tuple[int | str | Fraction, int, Dimension]] = {
    "1": (1, 0, _PURE), "%": ("0.01", 0, _PURE), "rad": (1, 0, _PURE),
    "deg": ("1/180", 1, _PURE), "rev": (2, 1, _PURE),
    "m": (1, 0, _LENGTH), "mm": ("0.001", 0, _LENGTH),
    "cm": ("0.01", 0, _LENGTH), "km": (1000, 0, _LENGTH),
    "in": (_INCH, 0, _LENGTH), "ft": (12 * _INCH, 0, _LENGTH), "mi": (63360 * _INCH, 0, _LENGTH),
    "s": (1, 0, _TIME), "min": (60, 0, _TIME), "h": (3600, 0, _TIME),
    "rpm": ("1/30", 1, _PURE / _TIME),
    "kg": (1, 0, _MASS), "g": ("0.001", 0, _MASS),
    "slug": (_POUND / (12 * _INCH), 0, _MASS),
    "N": (1, 0, _FORCE), "kN": (1000, 0, _FORCE),
    "lb": (_POUND, 0, _FORCE), "oz": (_POUND / 16, 0, _FORCE),
    "J": (1, 0, _FORCE * _LENGTH), "W": (1, 0, _FORCE * _LENGTH / _TIME),
    "Pa": (1, 0, _FORCE / _LENGTH**2),
}  # fmt: skip


_FEET = {"in", "ft", "mi", "slug", "lb", "oz"}
_ANGLES = {"rad", "deg", "rev"}


class UnitError(scalars.NewtonEulerError, ValueError):
    """A unit is not known, or not written as names joined by ``*`` and ``/``."""


class System:
    """A coherent system of units: its units of length and mass, and the second.

    >>> Unit("in").to_base(6.0, US), Unit("lb").to_base(6.0, US)
    (0.5, 6.0)
    """

    def __init__(self, length: Fraction | int, mass: Fraction | int):
        self.length, self.mass = map(Fraction, (length, mass))

    def factor(self, dimension: Dimension) -> Fraction:
        """The unit of this dimension, in kg, m and s."""
        mass, length, _ = dimension.powers
        if mass.denominator != 1 or length.denominator != 1:
            raise UnitError(f"a unit has whole powers of mass and length, not {dimension}")
        return self.mass ** int(mass) * self.length ** int(length)


SI = System(1, 1)
# foot, slug and second: a pound is one slug foot per second squared
US = System(12 * _INCH, _POUND / (12 * _INCH))


def _size(system, dimension):
    if not isinstance(system, System):
        raise UnitError(f"the system of units is SI, US or another System, got {clipped(system)}")
    return system.factor(dimension)


class Unit:
    """A unit, with its exact factor (a fraction times a power of pi) and its dimension.

    >>> Unit("rev/min").to_base(60.0) == 2*pi(), Unit("mm").from_base(0.25)
    (True, 250.0)
    """

    def __init__(self, text: str):
        self.text = text
        self.factor, self.pi_power, self.dimension = Fraction(1), 0, Dimension()
        self.parts = tuple(name for name, _ in _parts(text))
        for name, power in _parts(text):
            if name not in UNITS:
                known = f"known are {', '.join(UNITS)}{did_you_mean(name, UNITS)}"
                raise UnitError(f"unknown unit {name!r} in {text!r}; {known}")
            factor, pi_power, dimension = UNITS[name]
            self.factor *= Fraction(factor) ** power
            self.pi_power += pi_power * power
            self.dimension *= dimension**power

    def __repr__(self):
        return f"Unit({self.text!r})"

    @property
    def is_of_turning(self) -> bool:
        """True of degrees and revolutions, and of rates in them: their factors have pi in them."""
        return self.pi_power != 0

    @property
    def is_of_angle(self) -> bool:
        """True of an angle, as opposed to a rate of it or a pure number."""
        return len(self.parts) == 1 and not _ANGLES.isdisjoint(self.parts)

    @property
    def is_of_feet(self) -> bool:
        """True if a part of it is one of the units of feet and pounds."""
        return not _FEET.isdisjoint(self.parts)

    @scalars.in_range
    def to_base(self, x: Scalar, system: System = SI) -> Scalar:
        """The quantity of ``x`` (a scalar or a Vector) such units, in the units of ``system``."""
        return self._scaled(x, self.factor / _size(system, self.dimension), self.pi_power)

    @scalars.in_range
    def from_base(self, x: Scalar, system: System = SI) -> Scalar:
        """The reverse of :meth:`to_base`: the number of such units in the quantity ``x``."""
        return self._scaled(x, _size(system, self.dimension) / self.factor, -self.pi_power)

    @staticmethod
    def _scaled(x, factor, pi_power):
        # the kind of a vector is that of a component that is not zero by structure
        if isinstance(x, Scaled):
            like = next((c for c in x.c if c is not ZERO), 0.0) if hasattr(x, "c") else None
        else:
            like = x = to_plain(scalars.real_scalar(x))
        if like is None:
            raise UnitError(f"a number or a Vector has units, got {clipped(x)}")
        power_of_pi = pi(like) ** abs(pi_power) if pi_power else 1
        if pi_power < 0:
            x = x / power_of_pi  # first, so that 2 pi rad/s are 60 rev/min to the last digit
        if factor.numerator != 1:
            x = x / 1 * factor.numerator
        if factor.denominator != 1:
            x = x / factor.denominator
        return x * power_of_pi if pi_power > 0 else x


def unit(text: str) -> Unit:
    """The :class:`Unit` of this text; the same object each time.

    >>> unit("km/h").to_base(36.0)
    10.0
    """
    return _unit(text) if isinstance(text, str) else Unit(text)  # which refuses it


_unit = cache(Unit)


def pint_name(unit_text: str) -> str:
    """The name of a unit in pint, in which lb and oz are masses.

    >>> pint_name("lb*ft^2")
    'lbf*ft**2'
    """
    names = {"rev": "revolution", "lb": "lbf", "oz": "force_ounce", "%": "percent"}
    names["1"] = "dimensionless"
    text = re.sub(r"[A-Za-z%]+|(?<!\^)\b1\b", lambda m: names.get(m[0], m[0]), unit_text)
    return text.replace("^", "**")


def _parts(text):
    """Pairs of a unit's name and its power."""
    if not isinstance(text, str):
        raise UnitError(f"cannot read the unit {text!r}; write it as text, as in 'kg*m^2/s'")
    sign, parts = 1, []
    for token in re.split(r"([*/])", text.replace(" ", "")):
        if token in ("*", "/"):
            sign = 1 if token == "*" else -1
            continue
        if not (match := re.fullmatch(r"([A-Za-z%]+|1)(?:\^(-?\d\d?))?", token)):
            raise UnitError(f"cannot read the unit {text!r} at {token!r}; write it as 'kg*m^2/s'")
        parts.append((match[1], sign * int(match[2] or 1)))
    return parts

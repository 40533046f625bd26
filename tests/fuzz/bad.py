"""Values that do not belong where they are put: each replaces one argument of a valid call."""

import datetime
from decimal import Decimal
from fractions import Fraction
from functools import cache

import mpmath
import numpy as np
import sympy

from newton_euler import Dimension, Force, Frame, moving, particle, unit


class OfPint:
    """A quantity as pint makes it: a number and its unit, with arithmetic of its own."""

    def __init__(self, magnitude, units="km"):
        self.magnitude, self.units = magnitude, units

    def to(self, unit):
        raise ValueError(f"cannot convert {self.units} to {unit}")

    def __float__(self):
        return float(self.magnitude)

    def __mul__(self, other):
        return OfPint(self.magnitude * other, self.units)

    def __add__(self, other):
        return OfPint(self.magnitude + other, self.units)

    __rmul__, __radd__, __sub__, __rsub__, __truediv__ = __mul__, __add__, __add__, __add__, __mul__


class OfAstropy(np.ndarray):
    """A quantity as astropy makes it: an array with a unit, which np.asarray drops."""

    unit = "km"


@cache
def quantities():
    """{name: value}: what has a unit; those of pint and astropy where they are installed."""
    found = {"like pint": OfPint(2.0), "like astropy": np.array([1.0, 2.0]).view(OfAstropy)}
    try:
        import pint

        found["pint"] = pint.UnitRegistry().Quantity(2.0, "km")
    except ImportError:
        pass
    try:
        import astropy.units

        found["astropy"] = 2.0 * astropy.units.km
        found["astropy array"] = np.array([1.0, 2.0, 3.0]) * astropy.units.km
    except ImportError:
        pass
    return found


@cache
def bad_values():
    """{name: function that makes the value}."""
    other = Frame("another ground")
    here = {
        "None": None, "text": "text", "'30'": "30", "''": "", "bytes": b"", "()": (), "object()": object(),
        "nan": float("nan"), "inf": float("inf"), "-1.0": -1.0, "0": 0, "0.0": 0.0, "1e308": 1e308,
        "1e-320": 1e-320, "10**400": 10**400, "True": True, "1+2j": 1 + 2j,
        "(1.0, 2.0)": (1.0, 2.0), "('a', 'b', 'c')": ("a", "b", "c"), "(nan, 0, 0)": (float("nan"), 0, 0),
        "a frame": other, "a point": other.point("P", 1.0, 2.0, 3.0),
        "a vector": other.vector(1.0, 2.0, 3.0), "a body": particle(2.0, other),
        "a force": Force(other.i, other.origin), "moving": moving(1.0, 2.0, 3.0),
        "Dimension": Dimension(1, 2, 3), "Unit": unit("kg"), "type": int, "module": np,
        "Decimal": Decimal("1.5"), "Fraction": Fraction(1, 3), "datetime": datetime.datetime(2026, 1, 1),
        "timedelta": datetime.timedelta(1), "symbol": sympy.Symbol("q"), "mpf": mpmath.mpf(2),
        "lambda: None": lambda *_: None, "lambda: text": lambda *_: "text", "lambda: ()": lambda *_: (),
        "lambda: nan": lambda *_: float("nan"), "lambda without arguments": lambda: 1.0, "no end": range(10**12),
    }  # fmt: skip
    made = {
        "[]": list, "{}": dict, "set()": set, "{'a': 1}": lambda: {"a": 1},
        "a generator": lambda: (x for x in "abc"), "empty array": lambda: np.zeros(0),
        "array (2, 3, 4)": lambda: np.zeros((2, 3, 4)), "array (7,)": lambda: np.linspace(0.1, 0.7, 7),
        "array of None": lambda: np.array([1, None, 2.0], dtype=object),
        "array of text": lambda: np.array(["a", "b", "c"]), "array of dates": lambda: np.array(["2026-01-01"], "M8[D]"),
        "int array": lambda: np.array([1, 2, 3]), "uint8 array": lambda: np.array([1, 2, 3], np.uint8),
        "bool array": lambda: np.array([True, False, True]), "matrix": lambda: np.ones((2, 2)).view(np.matrix),
        "np.int64": lambda: np.int64(3), "np.float32": lambda: np.float32(0.1),
    }  # fmt: skip
    return {name: lambda x=x: x for name, x in {**here, **quantities()}.items()} | made

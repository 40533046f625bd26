"""Numbers and components from values of any library: NumPy, SymPy, mpmath, pandas, pint, and the
engine's own. A value that cannot be read is refused with what to write instead.
"""

import contextlib
import math
import sys
from collections.abc import Mapping, Set
from importlib import import_module
from typing import Any

from ..algebra.language import Words
from ..algebra.scalars import clipped, without_rates
from ..algebra.units import pint_name
from ..algebra.vectors import Vector

LONGEST = 5000  # numbers in one answer; the largest form has nine


def components(value: Any, form: Any) -> list:
    """The numbers or formulas in a scalar, vector, matrix or sequence of any library, as a list,
    row by row; of a pint quantity in the unit that is asked for.
    """
    found: list = []
    _gather(value, form, found)
    return found


def _library(value):
    return str(type(value).__module__).partition(".")[0]


def _gather(value, form, found):
    if len(found) > LONGEST:
        raise form.error("got more than {LONGEST} numbers", LONGEST=LONGEST)
    value = _plain(value, form)
    if (inner := _parts(value, form)) is None:
        found.append(value)
        return
    for part in inner:
        if part is value:  # such as the only character of a text
            raise form.error("got {value}", value=clipped(value))
        _gather(part, form, found)


def _plain(value, form):
    """The magnitude of a quantity; the entries of a table, sparse or unevaluated matrix."""
    if hasattr(value, "magnitude") and hasattr(value, "to"):
        try:
            return value.to(pint_name(form.unit)).magnitude
        except Exception as error:
            raise form.error(
                "the quantity {value} cannot be converted: {error}", value=value, error=error
            ) from None
    for method in ("to_numpy", "toarray"):  # methods of pandas and polars, and of sparse matrices
        if hasattr(value, method) and not isinstance(value, type):
            return getattr(value, method)()
    root, shape = _library(value), getattr(value, "shape", ())
    if root == "sympy" and (shape or getattr(getattr(value, "expr", None), "shape", ())):
        value = value.doit()  # an unevaluated product or derivative of matrices
        return value.as_explicit() if hasattr(value, "as_explicit") else value
    if root == "numpy" and shape and not hasattr(value, "mask"):
        # a row of a numpy.matrix would be a matrix again, without end
        return import_module("numpy").asarray(value)
    return value


def _parts(value, form):
    """The contents of a container; None for a scalar."""
    _refuse(value, form)
    if isinstance(value, Vector):
        return value.components()
    if _library(value) == "numpy":
        if hasattr(value, "mask") and value.mask.any():
            raise form.error("some of its numbers are masked; give all of them")
        if getattr(value, "shape", ()):
            return value.ravel().tolist()
        return [value.item()] if value.dtype == object else None
    # an array without dimensions has __iter__, but it cannot be iterated over
    shape = getattr(value, "shape", None)
    return value if shape or (shape is None and hasattr(value, "__iter__")) else None


def _refuse(value, form):
    """Raise an error that says what to write instead of a value without numbers or order."""
    kind, module = type(value).__name__, str(type(value).__module__)
    if isinstance(value, str | bytes):
        raise form.error(
            "got the text {value}; write it without quotation marks", value=clipped(value)
        )
    if isinstance(value, Mapping | Set) or kind == "FiniteSet":
        raise form.error("got a {kind}, which has no order; write it as in [x, y, z]", kind=kind)
    if module.startswith(("sympy.physics.vector", "sympy.vector")) and hasattr(value, "to_matrix"):
        raise form.error(
            "got a vector of SymPy, {value}; write v.to_matrix(N), with the frame N in "
            "whose axes it is asked for",
            value=str(value)[:80],
        )
    if hasattr(value, "to_value") and hasattr(value, "unit"):
        text = Words("got a quantity, {value}; write the number alone, q.to_value('{unit}')")
        raise form.error(text, value=clipped(value), unit=form.unit)
    if isinstance(value, range) and len(value) > LONGEST:
        raise form.error("got {value} numbers", value=len(value))
    if callable(value) and not hasattr(value, "free_symbols"):
        raise form.error(
            "cannot make a number of {value}, which is a function: call it", value=clipped(value)
        )


def read_number(x: Any, form: Any) -> float:
    """A number of any library as a finite float."""
    x = without_rates(x)
    if x is None or type(x).__name__ in ("bool", "bool_", "BooleanTrue", "BooleanFalse"):
        raise form.error("got {x}", x=repr(x))
    refuse_equation(x, form)
    if free := getattr(x, "free_symbols", None):
        names = ", ".join(sorted(map(str, free)))
        raise form.error(
            "{x} still contains {names}; put in the numbers", x=clipped(x), names=names
        )
    number = _real(x, form)
    if not math.isfinite(number):
        raise form.error(
            "got {number}, which comes from a division by zero or the root of a negative number",
            number=number,
        )
    return number


def _real(x, form):
    if (number := _complex(x)) is None:
        raise form.error("cannot make a number of {x}", x=clipped(x))
    if abs(number.imag) > 1e-12 * abs(number):  # above round-off
        raise form.error("got {x}, a complex number", x=repr(x))
    return number.real


def _complex(x):
    """The value of ``x``, of SymPy also once it is evaluated; None if it has none."""
    for make in (complex, lambda x: complex(x.doit().evalf())):
        with contextlib.suppress(AttributeError, TypeError, ValueError):
            return make(x)
    return None


def refuse_equation(x: Any, form: Any) -> None:
    """Raise an error that says what to write instead of an equation or unit of SymPy."""
    if getattr(x, "is_Relational", False):
        raise form.error("got {x}, an equation; give the side that is asked for", x=clipped(x))
    quantities = sys.modules.get("sympy.physics.units.quantities")
    if quantities and _library(x) == "sympy" and (units := x.atoms(quantities.Quantity)):
        text = Words("it contains the unit {units}; give the number alone, which is in {unit}")
        raise form.error(text, units=units.pop(), unit=form.unit)

"""Scalars of every kind, vectors, sums with named terms, linear equations, compiled code."""

from .compile import compiled
from .errors import NewtonEulerError
from .integrals import WorkError, integral
from .jets import Moving, at, moving
from .ledger import Amount, Equation, Explanation, TermError
from .linear import LinearError, LinearForm, Solution, solve_linear, solve_rates
from .names import guide as _guide
from .roots import root
from .scalars import (
    ZERO,
    ScalarError,
    SingularError,
    acos,
    asin,
    atan,
    atan2,
    cos,
    cosh,
    exp,
    is_numeric,
    is_zero,
    log,
    pi,
    radians,
    sin,
    sinh,
    sqrt,
    tan,
    tanh,
    where,
)
from .tables import Table, TableError, table
from .units import Dimension, DimensionError, Unit, UnitError, unit
from .vectors import FrameError, Vector, cross, dot, same

_guide(__name__)

"""Newton-Euler dynamics of particles and rigid bodies in three dimensions: a small engine for teaching and for work.

>>> from newton_euler import Frame
>>> ground = Frame("ground")
>>> shaft = ground.rotate("shaft", "z", rate=0.6)
>>> print(shaft.point("P", 2.0, 0, 0).acceleration(ground))
[-0.72, 0, 0] in shaft
"""

from .frames import Frame, Point, solve_rates
from .scalars import (
    ZERO,
    Dimension,
    DimensionError,
    ScalarError,
    acos,
    asin,
    at,
    atan,
    atan2,
    cos,
    cosh,
    exp,
    log,
    moving,
    pi,
    radians,
    sin,
    sinh,
    sqrt,
    tan,
    tanh,
)
from .tracing import compiled
from .vectors import Explanation, FrameError, Vector, cross, dot, same

__version__ = "0.1.0"

__all__ = [name for name in dir() if not name.startswith("_") and name not in ("frames", "scalars", "tracing", "vectors")]

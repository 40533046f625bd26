"""The types in the annotations of a problem's functions and of the devices."""

from newton_euler.algebra.scalars import Scalar, Triple
from newton_euler.drawing import AnyAxes

from .catalogue import Givens
from .catalogue.model import Answers, Draw, Follows, Mistakes, Solve
from .catalogue.proofs.digits import Coordinate, Matrix, Motion, Number, Orientation, Path, Points
from .catalogue.steps import Functions, Steps, StepsOf

__all__ = [
    "Answers", "AnyAxes", "Coordinate", "Draw", "Follows", "Functions", "Givens", "Matrix",
    "Mistakes", "Motion", "Number", "Orientation", "Path", "Points", "Scalar", "Solve", "Steps",
    "StepsOf", "Triple",
]  # fmt: skip

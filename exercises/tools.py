"""Imports for a problem's code, besides the engine: steps, figures, proofs, mpmath, types."""

from typing import Any

from mpmath import mp, mpf

from newton_euler import Frame
from newton_euler.algebra.scalars import Scalar, Triple
from newton_euler.drawing import AnyAxes, Sketch

from .catalogue import Givens, in_frame, proofs
from .catalogue.following import acceleration_of
from .catalogue.model import Answers, Draw, Follows, Mistakes, Solve
from .catalogue.proofs import *  # noqa: F403
from .catalogue.proofs.digits import Matrix, Motion, Number, Points
from .catalogue.steps import Step, Steps, StepsOf, terms

__all__ = ["Sketch", "Step", "acceleration_of", "in_frame", "mp", "mpf", "on_ground", "terms"]
__all__ += ["proofs", *proofs.__all__]
# types: of a problem's functions, of the engine's numbers, and of those of a proof
__all__ += ["Answers", "AnyAxes", "Draw", "Follows", "Givens", "Mistakes", "Solve"]
__all__ += ["Steps", "StepsOf"]
__all__ += ["Scalar", "Triple"]
__all__ += ["Matrix", "Motion", "Number", "Points"]


def on_ground(ax: AnyAxes, **view: Any) -> tuple[Frame, Sketch]:
    """A ground of its own for a figure, and the sketch on it."""
    ground = Frame("ground")
    return ground, Sketch(ax, ground, **view)

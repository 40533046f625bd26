"""Imports for a problem's code, besides the engine: steps, figures, proofs, mpmath."""

from typing import Any

from mpmath import mp, mpf

from newton_euler import Frame
from newton_euler.drawing import AnyAxes, Sketch

from .catalogue import in_frame, proofs
from .catalogue.following import acceleration_of
from .catalogue.proofs import *  # noqa: F403
from .catalogue.steps import Step, terms

__all__ = ["Sketch", "Step", "acceleration_of", "in_frame", "mp", "mpf", "on_ground", "terms"]
__all__ += ["proofs", *proofs.__all__]


def on_ground(ax: AnyAxes, **view: Any) -> tuple[Frame, Sketch]:
    """A ground of its own for a figure, and the sketch on it."""
    ground = Frame("ground")
    return ground, Sketch(ax, ground, **view)

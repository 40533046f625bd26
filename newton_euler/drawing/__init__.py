"""Figures to scale and animations."""

from .animation import Animation, AnimationError, animate
from .sketch import Sketch

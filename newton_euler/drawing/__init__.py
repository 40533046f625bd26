"""Figures to scale and animations."""

from ..algebra.names import guide as _guide
from .animation import Animation, AnimationError, animate
from .page.svg import dark_css
from .sketch import Sketch
from .writing import svg_of

_guide(__name__)

"""Figures to scale and animations."""

from ..algebra.names import guide as _guide
from .animation import Animation, AnimationError, animate
from .page.paper import AnyAxes
from .page.svg import dark_css, svg_of
from .sketch import Sketch

_guide(__name__)

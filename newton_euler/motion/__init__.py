"""Models and the integration of their motion."""

from ..algebra.names import guide as _guide
from .events import Event
from .integration import integrate, prepare
from .methods.table import METHODS
from .model import Model, ModelError, Neglected, second_order
from .solution import (
    AccuracyError,
    FarError,
    LongError,
    Motion,
    MotionError,
    NoValueError,
    StickingError,
    UnfitError,
)

_guide(__name__)

"""Libraries that are imported when first used: code that does not need them works without them."""

from importlib import import_module
from typing import TYPE_CHECKING, Any


def is_here(library: str) -> bool:
    """Whether a library can be imported."""
    try:
        return bool(import_module(library))
    except ModuleNotFoundError:
        return False


class _Late:
    """A module, or a class of it."""

    def __init__(self, module, name=None):
        self._late, self.__name__ = (module, name), name or module

    def _found(self):
        module, name = self._late
        found = import_module(module)
        return getattr(found, name) if name else found

    def __getattr__(self, name):
        if name.startswith("__"):  # as inspect asks of everything
            raise AttributeError(name)
        found = getattr(self._found(), name)
        setattr(self, name, found)  # found directly the next time
        return found

    def __call__(self, *args, **named):
        return self._found()(*args, **named)


if TYPE_CHECKING:
    import mpmath
    import numpy as np
    import sympy
else:
    np, mpmath, sympy = map(_Late, ("numpy", "mpmath", "sympy"))
plt: Any = _Late("matplotlib.pyplot")
Figure: Any = _Late("matplotlib.figure", "Figure")
EngFormatter: Any = _Late("matplotlib.ticker", "EngFormatter")
Line2D: Any = _Late("matplotlib.lines", "Line2D")
Rotation: Any = _Late("scipy.spatial.transform", "Rotation")

"""Libraries that a figure may ask for when it is drawn: where there are none, the others draw."""

from importlib import import_module
from typing import Any


class _Late:
    """A module that is imported when something of it is used first."""

    def __init__(self, name):
        self._name = name

    def __getattr__(self, name):
        return getattr(import_module(self._name), name)


mpmath: Any = _Late("mpmath")
np: Any = _Late("numpy")
plt: Any = _Late("matplotlib.pyplot")

"""Packages that a page does not have from the start: after ``import numpy`` in a cell, NumPy is
imported when the first of its names is used.
"""

import builtins
import sys
from importlib import import_module, invalidate_caches
from importlib.util import find_spec
from types import ModuleType
from typing import Any

TITLES = {
    "numpy": "NumPy", "scipy": "SciPy", "sympy": "SymPy", "mpmath": "mpmath",
    "matplotlib": "Matplotlib",
}  # fmt: skip
WHERE = "__main__", "newton_euler.chapters."  # cells, and what draws their figures


def missing(error: Exception) -> str:
    """The missing package that an error is about, "" for other errors."""
    top = (error.name or "").partition(".")[0] if isinstance(error, ModuleNotFoundError) else ""
    return top if top in TITLES else ""


def missing_in_words(package: str) -> str:
    """What a reader needs to know about a missing package."""
    return f"this needs {TITLES[package]}, which the page does not have; an installed notebook does"


class Late(ModuleType):
    """A package that is imported when it is used."""

    def __getattr__(self, name: str) -> Any:
        top = self.__name__.partition(".")[0]
        if name.startswith("__"):
            raise AttributeError(name)
        invalidate_caches()
        if find_spec(top) is None:
            raise ModuleNotFoundError(missing_in_words(top), name=top)
        return getattr(import_module(self.__name__), name)


def install() -> None:
    """Let cells import missing packages, which fail when they are used."""
    plain = builtins.__import__

    def imported(name, globals=None, locals=None, fromlist=(), level=0):
        top, *inner = name.split(".")
        place = (globals or {}).get("__name__", "")
        if level or top not in TITLES or not place.startswith(WHERE) or top in sys.modules:
            return plain(name, globals, locals, fromlist, level)
        module = first = Late(top)
        for part in inner:
            below = Late(f"{module.__name__}.{part}")
            setattr(module, part, below)
            module = below
        return module if fromlist else first

    builtins.__import__ = imported

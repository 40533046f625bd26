"""The :data:`SCENES` of the book and :data:`LADDERS` of models, by name.

>>> model, t, start = scene("pendulum").motion
>>> model.states, t, start
(('theta', 'omega'), 10.0, (1.0, 0.0))
>>> ladder("satellite", t=600.0).t
600.0
"""

from functools import cache
from importlib import import_module

from ..algebra.names import unknown as _unknown
from ..motion.model import ModelError
from . import catalogue
from .ladders import Ladder, Rung, smallest


@cache
def _table(name):
    """One of the tables, in the order of the book; importing all modules of scenes takes 30 ms."""
    from pkgutil import walk_packages

    for module in walk_packages(__path__, f"{__name__}."):
        import_module(module.name)
    entries = getattr(catalogue, name).values()
    return {
        s.name: s
        for s in sorted(entries, key=lambda s: ([int(n) for n in s.section.split(".")], s.name))
    }


def __getattr__(name):
    if name not in ("SCENES", "LADDERS"):
        _unknown(__name__, name)
    return _table(name)


def scene(name: str) -> catalogue.Scene:
    """The scene of this name; :class:`~newton_euler.motion.model.ModelError` lists all names."""
    return _found("SCENES", name)


def ladder(name: str, **given: object) -> Ladder:
    """The ladder of this name, with its default values or those ``given``, as ``start`` and t."""
    return _found("LADDERS", name).make(**given)


def _found(table, name):
    known = _table(table)
    if not isinstance(name, str) or name not in known:
        raise ModelError(f"there is no {table.lower()[:-1]} {name!r}; there are {', '.join(known)}")
    return known[name]

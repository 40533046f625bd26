"""The tables of scenes and of ladders of models, filled by the decorator :func:`scene`."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any, TypeVar

from ..motion.model import Model, ModelError

F = TypeVar("F", bound=Callable)
# scenes of the modules imported so far, all in newton_euler.scenes
SCENES: "dict[str, Scene]" = {}
LADDERS: "dict[str, Scene]" = {}


@dataclass(frozen=True)
class Scene:
    """A scene: ``name``, ``section`` of the book, ``description``; ``make()`` returns the Model,
    the end time and the start; of a ladder, ``make(**given)`` the Ladder.
    """

    name: str
    section: str
    description: str
    make: Callable[..., Any]

    @cached_property
    def motion(self) -> tuple[Model, float, Sequence[float]]:
        """(model, t, start), made once, since what is traced and compiled belongs to the model."""
        return self.make()


def scene(
    section: str,
    name: str,
    description: str,
    t: float | None = None,
    start: Sequence[float] | None = None,
    ladder: bool = False,
    **values: Any,
) -> Callable[[F], F]:
    """A decorator that registers the model which a function returns for these ``values``, until
    ``t`` from ``start``; with ``ladder=True`` a ladder, whose function needs no arguments.
    """
    table = LADDERS if ladder else SCENES
    if name in table:
        raise ModelError(f"two scenes have the name {name!r}")

    def register(make):
        made = make if ladder else lambda: (make(**values), t, start)
        table[name] = Scene(name, section, description, made)
        return make

    return register

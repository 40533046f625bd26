"""Where the scenes that move, and the ladders of their models, are registered: by the decorator
:func:`scene`, beside each model.
"""

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property

from ..motion.model import ModelError

SCENES, LADDERS = {}, {}  # of the modules imported so far; all are in newton_euler.scenes


@dataclass(frozen=True)
class Scene:
    """A scene: ``name``, ``section`` of the book, ``description``; ``make()`` returns the Model,
    the time at which to end, and the start.

    For a ladder of models ``make(**given)`` returns the Ladder.
    """

    name: str
    section: str
    description: str
    make: Callable

    @cached_property
    def motion(self):
        """(model, t, start), made when first asked for and then kept, since what is traced and
        compiled belongs to the model.
        """
        return self.make()


def scene(section, name, description, t=None, start=None, ladder=False, **values):
    """A decorator that registers the model which a function makes of these ``values``, with the
    time ``t`` at which to end, and the ``start``.

    With ``ladder=True`` the function makes a :class:`~newton_euler.scenes.ladders.Ladder`, and all
    of its parameters have values.
    """
    table = LADDERS if ladder else SCENES
    if name in table:
        raise ModelError(f"two scenes have the name {name!r}")

    def register(make):
        table[name] = Scene(
            name, section, description, make if ladder else lambda: (make(**values), t, start)
        )
        return make

    return register

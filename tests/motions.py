"""Motions for tests: all scenes of the catalogue and a few that only tests need, with their final
states to 30 digits.
"""

from newton_euler import scenes
from newton_euler.accuracy.measurements import work_precision as precision
from newton_euler.scenes.catalogue import Scene
from newton_euler.scenes.spatial.top import SPIN
from newton_euler.scenes.spatial.top import tilted as top_start
from tests.models import forced, oscillator

__all__ = ["ALL", "SCENES", "SPIN", "reference", "sizes", "top_start", "true_error"]

ONLY_HERE = {
    "forced": Scene("forced", "0", "driven and damped", lambda: (forced(), 25.0, (0.3, 0.0))),
    "oscillator": Scene(
        "oscillator",
        "0",
        "its exact solution kept back",
        lambda: (oscillator(exact=False), 20.0, (1.0, 0.3)),
    ),
}
ALL = scenes.SCENES | ONLY_HERE
SCENES = {name: scene.motion for name, scene in ALL.items()}


def reference(name):
    """The final state, as floats."""
    return precision.final_state(ALL[name])


def sizes(name):
    """What the error of each state is relative to."""
    return dict(zip(SCENES[name][0].states, precision.state_sizes(ALL[name]), strict=True))


def true_error(name, motion):
    """The error of the last state, as ``Motion.error`` measures it."""
    return precision.Reference(ALL[name]).error(motion)

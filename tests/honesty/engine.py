"""What the harness takes from the engine besides its public names, in one place, so that it is
easily redirected.
"""

from newton_euler import where
from newton_euler.motion import METHODS
from newton_euler.scenes.particles.orbit import orbit
from newton_euler.scenes.planar.pendulum import physical_pendulum
from newton_euler.scenes.spatial.free_body import free_body

METHOD_NAMES = tuple(METHODS)

__all__ = ["METHOD_NAMES", "free_body", "orbit", "physical_pendulum", "where"]

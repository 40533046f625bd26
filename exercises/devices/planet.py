"""A planet whose mass is radially symmetric, for the proofs of 5/17 and 5/18."""

from exercises.annotations import Number
from exercises.tools import mean, shell


def pull(mass: Number, radius: Number, distance: Number) -> Number:
    """Proof: the force on a unit mass at a distance from the centre, for a gravitational constant
    of 1, as a sum over mass points. The radial distribution of mass must not matter; here all of it
    is in a shell far below the surface.
    """

    def component(place):
        x, y, z = place[0], place[1], distance - place[2]
        return z / (x * x + y * y + z * z) ** 1.5

    return mass * mean(component, shell(radius / 6, order=16))

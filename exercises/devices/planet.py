"""A planet whose mass is radially symmetric, for the proofs of 5/17 and 5/18."""

from exercises.tools import mean, shell


def pull(mass, radius, distance):
    """For ``prove``: the force on a unit mass at a distance from the centre, in units in which the
    constant of gravitation is 1: the attraction of mass points added up.

    How the mass depends on the distance from the centre must not matter; here all of it is in a
    shell far below the surface.
    """

    def component(place):
        x, y, z = place[0], place[1], distance - place[2]
        return z / (x * x + y * y + z * z) ** 1.5

    return mass * mean(component, shell(radius / 6, order=16))

"""7/2: the inertia matrix of two spheres that touch."""

from exercises.devices.inertia import added, answer, matrix, of_points, steps_of, together
from exercises.devices.satellite import SATELLITE, figure, parts, spheres
from newton_euler.bodies import spherical_shell

draw = figure


def solve(g):
    return answer(together(SATELLITE, parts(g)))


def steps(g):
    units = {"mass": "slug", "length": "ft", "inertia": "slug*ft^2"}
    yield from steps_of(SATELLITE, parts(g), at_O=["larger sphere"], **units)


def prove(g):
    larger, smaller = (of_points(*sphere) for sphere in spheres(g))
    return {"I_O": added((1, larger), (1, smaller)), "I_larger": larger, "I_smaller": smaller}


def mistakes(g):
    larger, smaller = parts(g)
    xx, yy, zz = together(SATELLITE, [larger, smaller]).moments
    transfer = smaller.about(SATELLITE).terms["transfer"]
    return {
        "no_own": answer(larger.about(SATELLITE) + transfer),
        "along_x_too": matrix(SATELLITE, (xx + transfer.moments[1], yy, zz)),
        "R1_for_distance": answer(together(SATELLITE, parts(g, distance=g.R1))),
        "hollow": answer(together(SATELLITE, parts(g, shape=spherical_shell))),
    }

"""7/2: the inertia matrix of two spheres that touch."""

from exercises.devices.inertia import answer, matrix, problem_of, together, whole
from exercises.devices.inertia_proof import added, of_points
from exercises.devices.satellite import SATELLITE, draw, parts, spheres
from newton_euler.bodies import spherical_shell

solve, steps = problem_of(
    SATELLITE, parts, "slug", "ft", "slug*ft^2", at_O=["larger sphere"], given=("larger", "smaller")
)


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
        "R1_for_distance": whole(SATELLITE, parts(g, distance=g.R1)),
        "hollow": whole(SATELLITE, parts(g, shape=spherical_shell)),
    }

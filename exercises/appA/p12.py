"""A/12: the gradient of a dot product at a point."""

from exercises.tools import proofs
from newton_euler import Frame
from newton_euler.kinematics.curvilinear_systems import gradient

AXES = Frame("axes")
A = lambda x, y, z: (x * y, y * z, z * x)
B = lambda x, y, z: (y, z, x)


def point(g):
    return g.x_1, g.y_1, g.z_1


def minus_product(A, B):
    """V as a function of place, from two vector functions."""
    return lambda *place: -sum(a * b for a, b in zip(A(*place), B(*place), strict=True))


def at_point(g, V):
    return gradient(V, AXES.point("P", *point(g)))


def solve(g):
    found = steps(g)
    return {"grad": found["part_A"] + found["part_B"]}


def steps(g):
    here = point(g)
    A_here, B_here = A(*here), B(*here)
    return {
        "A_1": AXES.vector(*A_here),
        "B_1": AXES.vector(*B_here),
        "part_A": at_point(g, minus_product(A, lambda *_: B_here)),
        "part_B": at_point(g, minus_product(lambda *_: A_here, B)),
    }


def prove(g):
    """The dot product multiplied out, its slopes along slanted lines."""
    return {"grad": proofs.gradient(lambda x, y, z: -x * y**2 - y * z**2 - z * x**2, point(g))}


def mistakes(g):
    right = solve(g)["grad"]
    # the factors without a square in x y^2 + y z^2 + z x^2 held constant
    held = lambda *r: -sum(a * b**2 for a, b in zip(point(g), B(*r), strict=True))
    return {
        "no_minus": {"grad": -right},
        "point_first": {"grad": 0 * right},
        "squares_only": {"grad": at_point(g, held)},
    }

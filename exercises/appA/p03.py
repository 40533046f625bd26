"""A/3: the sum of two vectors and its direction, in a plane."""

from exercises.tools import Sketch, integral, minus, mp, size
from newton_euler import Frame, acos, radians

AXES = Frame("axes")
follows = {"angle": lambda g, R: R.angle_to(R.frame.i)}


def vectors(g):
    return AXES.vector(g.P_x, g.P_y, 0), AXES.vector(g.G_x, g.G_y, 0)


def answers(R):
    return {"R": R, "angle": acos(R.x / R.norm())}


def solve(g):
    P, G = vectors(g)
    return answers(P + G)


def steps(g):
    return {"size": solve(g)["R"].norm()}


def prove(g):
    """R as the displacement at velocities P, then G; the angle from a triangle with i."""
    P, G = [g.P_x, g.P_y, 0], [g.G_x, g.G_y, 0]
    R = integral(lambda t: P if t < 1 else G, 0, 2, breaks=(1,))
    cosine = (size(R) ** 2 + 1 - size(minus(R, [1, 0, 0])) ** 2) / (2 * size(R))
    return {"R": R, "angle": mp.acos(cosine), "size": size(R)}


def mistakes(g):
    P, G = vectors(g)
    right = solve(g)
    return {
        "lost_sign": solve(g.but(G_y=-g.G_y)),
        "angle_with_j": {"angle": right["R"].angle_to(AXES.j)},
        "in_radians": {"angle": radians(right["angle"])},
        "difference": answers(P - G),
    }


def draw(g, ax):
    P, G = vectors(g)
    s = Sketch(ax, AXES, plane="xy")
    O = (0, 0, 0)
    s.axes(O, AXES, length=0.6 * g.P_y, labels=["i", "j", ""])
    for name, v in (("P", P), ("G", G)):
        s.arrow(O, v.components())
        s.label(v.components(), name)
    s.label(O, "O", offset=(-12, -6))

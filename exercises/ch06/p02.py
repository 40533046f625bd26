"""6/2: the acceleration of a particle by a force."""

from exercises.tools import rate, root
from newton_euler import Frame, dynamics

AXES = Frame("axes")
G = 32.2  # the number in ft/s^2, for a mistake


def solve(g):
    return {"a": dynamics.acceleration_by(g.m, force=steps(g)["F"])}


def steps(g):
    return {"F": AXES.vector(g.F_x, g.F_y, g.F_z)}


def prove(g):
    """From rest, the work of each component is the kinetic energy of motion along its axis."""
    place = lambda a: lambda t: a * t**2 / 2
    surplus = lambda F, a: F * place(a)(1) - g.m * rate(place(a), 1) ** 2 / 2
    along = lambda F: root(lambda a: surplus(F, a), F / g.m / 10, 10 * F / g.m)
    return {"a": [along(F) for F in (g.F_x, g.F_y, g.F_z)]}


def mistakes(g):
    a = solve(g)["a"]
    return {
        "by_weight": {"a": a / G},
        "slugs_as_pounds": {"a": a * G},
        "minus_lost": {"a": solve(g.but(F_z=-g.F_z))["a"]},
        "times_mass": {"a": a * g.stated("m") ** 2},
    }

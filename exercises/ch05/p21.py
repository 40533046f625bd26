"""5/21: the degrees of freedom of a particle on a sphere. The radius is only drawn."""

from exercises.tools import at_angle, freedom, mp, mpf, on_ground
from newton_euler import dynamics

sphere = lambda P: sum(x * x for x in P) - 1  # P stays at unit distance from O


def count(**constraints):
    return dynamics.degrees_of_freedom({"P": "particle"}, constraints)


def solve(g):
    # the weight is a force, not a constraint
    return {"dof": count(sphere=sphere)}


def steps(g):
    return {"coordinates": count().unknowns, "constraints": 1}


def prove(g):
    """By the longitude and latitude of P."""
    place = lambda longitude, lat: at_angle(mp.cos(lat), longitude, mp.sin(lat))
    return {"dof": freedom(place, mpf("0.4"), mpf("-0.7"))}


def mistakes(g):
    return {
        "planar": {"dof": count(sphere=sphere, plane=lambda P: P[1])},
        "weight": {"dof": count(sphere=sphere, weight=lambda P: P[2] + 0.5)},  # holds the height
        "no_surface": {"dof": count()},
    }


def draw(g, ax):
    ground, s = on_ground(ax, azimuth=35, elevation=35)
    down, side = -ground.k, ground.vector(0, -0.8, -0.6)
    O = (0, 0, 0)
    P = tuple(g.R * x for x in side.components())
    s.hemisphere(O, down, g.R, open=True)
    s.line(O, P)
    s.vector(P, down, "weight", kind="force")
    s.dimension(O, (0, g.R, 0), label="R")
    s.dot(O, "O")
    s.dot(P, "P")

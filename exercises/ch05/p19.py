"""5/19: the degrees of freedom of two particles on one surface."""

from exercises.tools import Sketch, freedom, mp, mpf
from newton_euler import Frame, cos, dynamics, sin

TWO = {"P1": "particle", "P2": "particle"}
f = lambda x, y, z: x**2 + 2 * y**2 + 3 * z**2 - 1  # one surface for all: an ellipsoid


def count(bodies, **constraints):
    return dynamics.degrees_of_freedom(bodies, constraints)


def solve(g):
    return {"dof": count(TWO, first=lambda P1: f(*P1), second=lambda P2: f(*P2))}


def steps(g):
    return {"coordinates": count(TWO).unknowns, "constraints": 2}


def prove(g):
    """By two coordinates of each particle, here on a wavy surface."""
    places = lambda *q: [x for a, b in (q[:2], q[2:]) for x in (a, b, mp.sin(a) * mp.cos(2 * b))]
    return {"dof": freedom(places, mpf("0.3"), mpf("0.7"), mpf("-0.5"), mpf("0.1"))}


def mistakes(g):
    return {
        "one_for_all": {"dof": count(TWO, first=lambda P1: f(*P1))},
        "one_particle": {"dof": count({"P1": "particle"}, first=lambda P1: f(*P1))},
        "no_surface": {"dof": count(TWO)},
    }


def draw(g, ax):
    s = Sketch(ax, Frame("space"), azimuth=35, elevation=28)
    place = lambda x, y: (x, y, 0.5 * cos(0.8 * x) * sin(0.8 * y))
    ways = [n / 4 for n in range(-6, 7)]
    for a in ways[::4]:
        s.path([place(a, b) for b in ways])
        s.path([place(b, a) for b in ways])
    for name, x, y in (("$P_1$", -0.1, 0.9), ("$P_2$", 0.1, -1.15)):
        s.dot(place(x, y))
        s.label(place(x, y), name, offset=(14, 2), bold=False)
    s.label(place(-1.5, 0), "f(x, y, z) = 0", offset=(10, 24), bold=False)

"""5/18: the weight on the moon."""

from exercises.devices.planet import pull
from exercises.tools import Sketch
from newton_euler import Frame, dynamics


def weight(g, mass, radius):
    """The weight on a planet of this mass and radius, those of the Earth being 1."""
    return dynamics.gravity_at_surface(mass, radius, K=g.W0)


def solve(g):
    return {"W": weight(g, 1 / g.n_M, 1 / g.n_R)}


def steps(g):
    return {"W_1": weight(g, 1 / g.n_M, 1), "growth": g.n_R**2}


def prove(g):
    earth = pull(1, 1, 1)
    moon = pull(1 / g.n_M, 1 / g.n_R, 1 / g.n_R)
    large_moon = pull(1 / g.n_M, 1, 1)
    return {"W": g.W0 * moon / earth, "W_1": g.W0 * large_moon / earth, "growth": moon / large_moon}


def mistakes(g):
    return {
        "only_mass": {"W": weight(g, 1 / g.n_M, 1)},
        "no_square": {"W": g.W0 * g.n_R / g.n_M},
        "upside_down": {"W": weight(g, 1 / g.n_M, g.n_R)},
    }


def draw(g, ax):
    space = Frame("space")
    s = Sketch(ax, space, plane="xz")
    small = 1 / g.n_R
    for x, radius, name, planet in ((0, 1, "$W_0$", "earth"), (1.8, small, "W", "moon")):
        O, top = (x, 0, 0), (x, 0, radius)
        s.disk(O, space.j, radius)
        s.dot(top)
        # of equal length, since the ratio is asked for
        s.arrow((x, 0, radius + 0.5), top, name, kind="force")
        s.label((x, 0, -radius), planet, offset=(0, -12), bold=False)

"""11/11: a collar on a hoop in a horizontal plane, pulled by a spring: the weight does no work."""

from exercises.devices.spring_to_pin import pull
from exercises.tools import Sketch, minus, mp, size, speed_along
from newton_euler import Frame
from newton_euler.dynamics import mass_from_weight, speed_after, spring_between, weight_potential

follows = {"v_A": lambda g, v_B: speed_after(v_B, energy(g, "B"), mass_from_weight(g.W, g.g))}


def scene(g):
    """The ground, seen from above: O, x toward A, and the points."""
    ground = Frame("ground")
    places = {"A": (g.R, 0), "B": (0, g.R), "C": (-g.R, 0), "P": (g.R + g.d, 0)}
    return ground, {name: ground.point(name, *xy, 0) for name, xy in places.items()}


def length(g, name):
    """The length of the spring, with the collar at A, B or C."""
    _, points = scene(g)
    return (points[name] - points["P"]).norm()


def energy(g, name):
    """The energy of the spring."""
    _, points = scene(g)
    return spring_between(g.k, length(g, "A"), points["P"], points[name])


def work(g, end):
    """The work of the spring, from C."""
    return energy(g, "C") - energy(g, end)


def speeds(g, U_B, U_A, v_C=None):
    m, start = mass_from_weight(g.W, g.g), g.v_C if v_C is None else v_C
    T_C = m * start**2 / 2
    return {key: speed_after(0, T_C + U, m) for key, U in (("v_B", U_B), ("v_A", U_A))}


def solve(g):
    return speeds(g, work(g, "B"), work(g, "A"))


def steps(g):
    for name in "CB":
        yield f"x_{name}", length(g, name) - length(g, "A")
        yield f"V_{name}", energy(g, name)
    yield "T_C", mass_from_weight(g.W, g.g) * g.v_C**2 / 2


def prove(g):
    """The pull of the spring, integrated along the hoop."""
    hoop = lambda phi: [-g.R * mp.cos(phi), g.R * mp.sin(phi), 0]
    P = [g.R + g.d, 0, 0]
    at_C, at_B = hoop(0), hoop(mp.pi / 2)
    m, spring = g.W / g.g, pull(g.k, g.d, P)
    v_B = speed_along(m, spring, hoop, 0, mp.pi / 2, g.v_C)
    v_A = speed_along(m, spring, hoop, mp.pi / 2, mp.pi, v_B)
    x_C, x_B = (size(minus(P, place)) - g.d for place in (at_C, at_B))
    return {"v_B": v_B, "v_A": v_A, "x_C": x_C, "x_B": x_B}


def mistakes(g):
    U_B, U_A = work(g, "B"), work(g, "A")
    upright = weight_potential(mass_from_weight(g.W, g.g), g.R, g.g)
    return {
        "upright": {"v_B": speeds(g, U_B - upright, U_A)["v_B"]},
        "stretch_R": {"v_B": speeds(g, energy(g, "C") - g.k * g.R**2 / 2, U_A)["v_B"]},
        "from_rest": speeds(g, U_B, U_A, v_C=0),
        "inches": speeds(g, 12 * U_B, 12 * U_A),
    }


def draw(g, ax):
    ground, points = scene(g)
    s = Sketch(ax, ground, plane="xy")
    O, A, B, C, P = ground.origin, *(points[name] for name in "ABCP")
    s.wire([*s.around((0, 0, 0), (g.R, 0, 0), ground.k), (g.R, 0, 0)])
    collar = ground.point("collar", -0.6 * g.R, 0.8 * g.R, 0)
    s.line(C, P, style="centre")
    s.line(O, B)
    s.spring(P, collar)
    s.sphere(collar, 0.08 * g.R)
    s.hinge(P)
    s.dot(O, "O", offset=(10, -12))
    s.dot(A, "A", offset=(-14, -14))
    s.dot(B, "B", offset=(0, 14))
    s.dot(C, "C", offset=(-14, 0))
    s.dimension(A, P, label="d", offset=-0.35 * g.R)
    s.arrow(O, (-0.6 * g.R, -0.8 * g.R, 0), label="R")
    s.label(P, "P", offset=(16, 0))
    s.vector(C, ground.j, "$v_C$", kind="velocity")

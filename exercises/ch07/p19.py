"""7/19: a cylinder with a conical cavity."""

from exercises.tools import Sketch, proofs
from newton_euler import Frame, sqrt
from newton_euler.bodies import cone, cylinder

PART = Frame("part")  # its origin is the middle of the lower end
follows = {"k_y": lambda g, I_y: sqrt(I_y / g.m)}


def solids(g):
    """The cylinder and the cone, of density 1 and any height, here 3 a/2."""
    h = 3 * g.a / 2
    apex = PART.point("apex", 0, h - g.q * h, 0)
    full = cylinder(g.a, h, PART.point("C", 0, h / 2, 0), "y", density=1)
    return full, cone(g.p * g.a, g.q * h, apex, "y", density=1)


def of_part(g, k_y):
    return {"I_y": g.m * k_y**2, "k_y": k_y}


def shares(g):
    """The mass of the cone over that of the full cylinder, and the moments of inertia of both."""
    full, cavity = solids(g)
    share = cavity.mass / full.mass
    m_full = g.m / (1 - share)
    moment = lambda m, body: m * body.inertia.radius_of_gyration("y") ** 2
    return share, m_full, moment(m_full, full), moment(m_full * share, cavity)


def solve(g):
    *_, I_full, I_cone = shares(g)
    I_y = I_full - I_cone
    return {"I_y": I_y, "k_y": sqrt(I_y / g.m)}


def steps(g):
    share, m_full, I_full, I_cone = shares(g)
    return {"share": share, "m_full": m_full, "I_full": I_full, "I_cone": I_cone}


def prove(g):
    """By thin tubes about the y axis, which reach from the lower face up to the cavity."""
    edge = g.p * g.a
    height = lambda r: 1 - g.q * (1 - r / edge) if r < edge else 1  # over h
    total = lambda f: proofs.integral(lambda r: r * height(r) * f(r), 0, g.a, (edge,))
    square = total(lambda r: r**2) / total(lambda r: 1)
    return {"I_y": g.m * square, "k_y": sqrt(square), "share": 1 - total(lambda r: 1) * 2 / g.a**2}


def mistakes(g):
    full, cavity = solids(g)
    share = cavity.mass / full.mass
    disk, own = (body.inertia.radius_of_gyration("y") for body in (full, cavity))
    right = solve(g)["k_y"]
    return {
        "full_mass": of_part(g, right * sqrt(1 - share)),
        "cone_added": of_part(g, sqrt((disk**2 + share * own**2) / (1 + share))),
        "cone_like_cylinder": of_part(g, sqrt((1 - share * g.p**2) / (1 - share)) * disk),
        "no_root": {"k_y": right**2 / g.a},
    }


def draw(g, ax):
    h = 3 * g.a / 2
    s = Sketch(ax, PART, plane="xy")
    apex, top = (0, h - g.q * h, 0), (0, h, 0)
    left, right = (-g.a, 0, 0), (g.a, 0, 0)
    brim = [(side * g.p * g.a, h, 0) for side in (1, -1)]
    s.plate([left, right, (g.a, h, 0), brim[0], apex, brim[1], (-g.a, h, 0)])
    s.line((-g.a, h, 0), (g.a, h, 0), style="dotted")
    s.line((0, -0.15 * h, 0), top, style="centre")
    s.arrow(top, (0, 1.4 * h, 0), "y")
    s.dimension((0, 0, 0), right, label="a", offset=-0.15 * h)
    s.dimension(top, brim[0], label="$p\\,a$", offset=0.1 * h)
    s.dimension((g.a, h, 0), right, label="h", offset=0.2 * g.a)
    side = (-g.a, h - g.q * h, 0)
    s.line(side, apex, style="dotted")
    s.dimension(side, (-g.a, h, 0), label="$q\\,h$", offset=0.2 * g.a)

"""7/28: the cone with equal moments of inertia about all axes through its centre of mass."""

from exercises.tools import Sketch, mp, proofs
from newton_euler import Frame, atan, bodies, sqrt

CONE = Frame("cone")  # its origin is the apex, z points to the base


def shares(g):
    """Height of G, axial moment, integral of squared heights, for a cone as wide as high."""
    cone = bodies.cone(g.one, g.one, CONE, "z", mass=g.one)
    d, own = cone.centre.position(CONE).z, cone.inertia.moment("z")
    return d, own, cone.about(CONE).moment("x") - own / 2


def angle(own, tall):
    """The alpha at which both moments are equal, tan(alpha)^2 own/2 = tall."""
    return atan(sqrt(2 * tall / own))


def solve(g):
    d, own, square = shares(g)
    return {"alpha": angle(own, square - d**2)}


def steps(g):
    d, own, square = shares(g)
    return {"d": d, "own": own, "square": square, "tall": square - d**2}


def prove(g):
    """Disks that grow from the apex; a wider cone is a stretched one."""
    body = proofs.cone(1, 1)
    d = proofs.mean(lambda p: p[2], body)
    across, along = proofs.mean(lambda p: [p[0] ** 2, (p[2] - d) ** 2], body)
    radius = proofs.root(lambda r: 2 * across * r**2 - (across * r**2 + along), mp.mpf(1) / 10, 5)
    return {
        "alpha": mp.atan2(radius, 1),
        "d": d,
        "own": 2 * across,
        "square": along + d**2,
        "tall": along,
    }


def mistakes(g):
    d, own, square = shares(g)
    return {
        "at_the_apex": {"alpha": angle(own, square)},
        "full_angle": {"alpha": 2 * angle(own, square - d**2)},
        "quarter_from_the_apex": {"alpha": angle(own, square - (d / 3) ** 2)},
    }


def draw(g, ax):
    s = Sketch(ax, CONE, plane="xz")
    r, h = 0.36, 1  # not the shape asked for
    apex, left, right = (0, 0, 0), (-r, 0, -h), (r, 0, -h)
    s.plate([apex, left, right])
    s.line((0, 0, 0.25), (0, 0, -1.2), style="centre")
    s.line((-0.6, 0, -0.75), (0.6, 0, -0.75), style="centre")
    s.arc(apex, (0, 0, -h), right, label=r"$\alpha$")
    s.label((0, 0, 0.25), "A", offset=(9, -4))
    s.label((0, 0, -1.2), "A'", offset=(9, 4))
    s.label((-0.6, 0, -0.75), "B", offset=(0, 9))
    s.label((0.6, 0, -0.75), "B'", offset=(0, 9))

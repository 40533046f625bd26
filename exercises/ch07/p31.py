"""7/31: the products of inertia of a slanting rod."""

from exercises.devices.inertia import named
from exercises.tools import Sketch, proofs
from newton_euler import Frame, bodies

AXES = Frame("axes")
PAIRS = "xy", "yz", "zx"


def ends(g):
    return AXES.point("A", g.xA, g.yA, g.zA), AXES.point("B", g.xB, g.yB, g.zB)


def rod(g):
    return bodies.simplex(*ends(g), mass=g.m)


def solve(g):
    return named(rod(g).about(AXES).products)


def steps(g):
    body = rod(g)
    yield "d", body.centre.position(AXES)
    transfer = body.about(AXES).terms["transfer"].products
    for pair, own, moved in zip(PAIRS, body.inertia.products, transfer, strict=True):
        yield f"own_{pair}", own
        yield f"transfer_{pair}", moved


def prove(g):
    """Along the rod, from A to B."""
    A, B = [g.xA, g.yA, g.zA], [g.xB, g.yB, g.zB]

    def total(f):
        at = lambda t: f(*(a + t * (b - a) for a, b in zip(A, B, strict=True)))
        return proofs.integral(at, 0, 1)

    d = total(lambda *p: list(p))
    found = total(lambda x, y, z: [g.m * x * y, g.m * y * z, g.m * z * x])
    own = total(lambda x, y, z: g.m * (x - d[0]) * (y - d[1]))
    return {**named(found), "d": d, "own_xy": own}


def mistakes(g):
    body = rod(g)
    I = body.about(AXES)
    lengths = {name: 1000 * getattr(g, name) for name in ("xA", "yA", "zA", "xB", "yB", "zB")}
    return {
        "particle": named(I.terms["transfer"].products),
        "in_the_matrix": named([-x for x in I.products]),
        "no_transfer": named(body.inertia.products),
        "millimeters": solve(g.but(**lengths)),
    }


def draw(g, ax):
    s = Sketch(ax, AXES, azimuth=35, elevation=22)
    A, B = ends(g)
    s.axes((0, 0, 0), AXES, length=1.15 * max(g.xB, g.yB, g.zA))
    s.rod(A, B)
    for P, x, y, z in (A, g.xA, g.yA, g.zA), (B, g.xB, g.yB, g.zB):
        foot = (x, y, 0)
        s.line((x, y, z), foot)
        s.line(foot, (x, 0, 0))
        s.line(foot, (0, y, 0))
        s.label(P, P.name)
        s.label((x, 0, 0), f"$x_{P.name}$", offset=(-12, 6), bold=False)
    # y_A may be zero, and the rod comes near z_B
    s.label((0, g.yB, 0), "$y_B$", offset=(6, 10), bold=False)
    s.label((g.xA, g.yA, g.zA / 2), "$z_A$", offset=(-12, 0), bold=False)

"""7/32: the products of inertia of a block at a corner."""

from exercises.devices.inertia import named
from exercises.tools import Sketch, proofs
from newton_euler import Frame, bodies

CORNER = Frame("corner")


def block(g):
    middle = CORNER.point("G", g.a / 2, g.b / 2, -g.c / 2)
    return bodies.box(g.a, g.b, g.c, middle, "x", mass=g.W / g.g)


def solve(g):
    return named(block(g).about(CORNER).products)


def steps(g):
    body = block(g)
    return {"m": body.mass, "d": body.centre.position(CORNER)}


def prove(g):
    """By mass points all over the block."""
    m = g.W / g.g

    def total(f):
        moved = lambda p: f(p[0] + g.a / 2, p[1] + g.b / 2, p[2] - g.c / 2)
        return proofs.mean(moved, proofs.box(g.a, g.b, g.c, order=2))

    d = total(lambda *p: list(p))
    return {**named(total(lambda x, y, z: [m * x * y, m * y * z, m * z * x])), "d": d}


def mistakes(g):
    turned = {key: -x for key, x in solve(g).items()}
    return {
        "symmetric": named(block(g).inertia.products),
        "signs": {key: x for key, x in turned.items() if "z" in key},
        "in_the_matrix": {"I_xy": turned["I_xy"]},
        "weight": solve(g.but(W=g.W * g.g)),
    }


def draw(g, ax):
    s = Sketch(ax, CORNER, azimuth=35, elevation=22)
    s.box((g.a / 2, g.b / 2, -g.c / 2), CORNER, (g.a, g.b, g.c))
    s.axes((0, 0, 0), CORNER, length=1.7 * max(g.a, g.b, g.c))
    s.dimension((g.a, 0, -g.c), (g.a, g.b, -g.c), label="b")
    s.dimension((g.a, 0, 0), (g.a, 0, -g.c), label="c")
    s.dimension((0, g.b, -g.c), (g.a, g.b, -g.c), label="a")

"""10/12: two cones, joined at their vertices, without precession."""

from exercises.devices.wobbling import difference, neutral_length
from exercises.tools import mpf, on_ground, proofs
from newton_euler import Frame, composite, root, sqrt
from newton_euler.bodies import cone, cylinder


def cones(g, ratio):
    """Two cones of unit mass and base radius; the frame is at their common vertex."""
    frame = Frame("cones")
    O = frame.point("O", 0, 0, 0)
    upper = cone(g.one, ratio, O, "z", mass=g.one, name="upper")
    lower = cone(g.one, ratio, O, "-z", mass=g.one, name="lower")
    return composite("cones", [upper, lower], frame=frame), O


def limit(g, excess):
    return {"ratio": root(excess, g.one / 100, 10 * g.one)}


def shares(g):
    """The moments of a cone as wide as high, to be scaled with the height."""
    body, O = cones(g, g.one)
    I = body.parts[0].about(O)
    axial = I.moment("z")
    return {"axial": axial, "flat": axial / 2, "tall": I.moment("x") - axial / 2}


steps = shares


def solve(g):
    """Equal moments of inertia about all axes through the vertices."""
    of = shares(g)
    return {"ratio": sqrt((of["axial"] - of["flat"]) / of["tall"])}


def prove(g):
    """The height at which mass points turn about a slanting axis without a moment."""
    half = proofs.cone(1, 1)

    def points(ratio):
        return [(u / 2, [x, y, side * ratio * z]) for u, (x, y, z) in half for side in (1, -1)]

    ratio = neutral_length(points, mpf(1))
    axial, flat, tall = proofs.mean(lambda p: [p[0] ** 2 + p[1] ** 2, p[1] ** 2, p[2] ** 2], half)
    return {"ratio": ratio, "axial": axial, "flat": flat, "tall": tall}


def mistakes(g):
    def one(ratio):
        """A cone, and the centre of its base."""
        upper = cones(g, ratio)[0].parts[0]
        return upper, upper.frame.point("base", 0, 0, ratio)

    def about_center(ratio):
        upper, _ = one(ratio)
        return difference(upper, upper.centre)

    def of_cylinder(ratio):
        frame = Frame("cylinder")
        body = cylinder(g.one, ratio, frame.point("G", 0, 0, ratio / 2), "z", mass=g.one)
        return difference(body, frame.point("O", 0, 0, 0))

    return {
        "about_center": limit(g, about_center),
        "at_the_bases": limit(g, lambda ratio: difference(*one(ratio))),
        "cylinders": limit(g, of_cylinder),
    }


def draw(g, ax):
    ground, s = on_ground(ax, azimuth=-60, elevation=15)
    r, h = 1.0, 1.6  # not the shape asked for
    O, high = (0, 0, 0), (0, 0, h)
    for side in (1, -1):
        s.cone(O, ground.k * side, h, r)
    s.line((0, 0, h), (0, 0, 1.6 * h), style="centre")
    s.turn((0, 0, 1.35 * h), ground.k, label="spin")
    s.dimension(high, (r, 0, h), label="r", offset=0)
    s.dimension((1.2 * r, 0, h), (1.2 * r, 0, 0), label="h", offset=0)
    s.dimension((1.2 * r, 0, 0), (1.2 * r, 0, -h), label="h", offset=0)

"""10/10: for which lengths a thin tube precesses in the sense of its spin."""

from exercises.devices.wobbling import difference, needed_spin, neutral_length, sense
from exercises.tools import Sketch, Step, mpf, proofs
from newton_euler import Frame, root
from newton_euler.bodies import cylinder, cylindrical_shell, rod


def shell(g, ratio):
    """A shell of the mass and the radius 1; its frame is at its centre, z along the axis."""
    return cylindrical_shell(g.one, ratio, Frame("shell"), "z", mass=g.one)


def excess(body):
    return difference(body, body.centre)


def limit(g, excess_at):
    return root(excess_at, g.one / 10, 10 * g.one)


def right_limit(g):
    return limit(g, lambda ratio: excess(shell(g, ratio)))


def side(g, ratio):
    """The word, from a shell that is a little longer than the limit."""
    longer = shell(g, 1.1 * ratio)
    return "above" if sense(longer, longer.centre) == "direct" else "below"


def solve(g):
    ratio = right_limit(g)
    return {"ratio": ratio, "side": lambda: side(g, ratio)}


def steps(g):
    ratio = right_limit(g)
    I, of_height = shell(g, ratio).inertia, rod(ratio, Frame("rod"), "z", mass=g.one)
    along = of_height.inertia.moment("x")
    yield Step("axial", I.moment("z"), "1", "moment of inertia about the axis, over m*r^2", "7.3")
    yield Step("flat", I.moment("x") - along, "1",
               "part of the transverse moment that does not depend on l, over m*r^2",
               "7.3")  # fmt: skip
    yield Step("square", ratio**2, "1", "square of l/r at which both moments are equal and there "
               "is no precession, from (l/r)^2/12 = 1 - 1/2", "10.8", "10.36")  # fmt: skip


def prove(g):
    """The length at which the shell turns about a slanting axis without a moment; the sense from
    the spin that a longer one needs to precess without a moment.
    """
    rim = proofs.ring(mpf(1), order=2)

    def points(ratio):
        heights = proofs.box(0, 0, ratio, order=2)
        return [(u * v, proofs.plus(p, q)) for u, p in rim for v, q in heights]

    ratio = neutral_length(points, mpf(1))
    longer, flat = needed_spin(points(2 * ratio)), proofs.mean(lambda p: p[1] ** 2, rim)
    return {
        "ratio": ratio,
        "side": lambda: "above" if longer > 0 else "below",
        "axial": proofs.mean(lambda p: p[0] ** 2 + p[1] ** 2, points(ratio)),
        "flat": flat,
        "square": ratio**2,
    }


def mistakes(g):
    def solid(ratio):
        return excess(cylinder(g.one, ratio, Frame("solid"), "z", mass=g.one))

    def no_radius(ratio):
        thin = rod(ratio, Frame("rod"), "z", mass=g.one)
        return thin.inertia.moment("x") - shell(g, ratio).inertia.moment("z")

    return {
        "solid": {"ratio": limit(g, solid)},
        "retrograde": {"side": "below"},
        "no_radius": {"ratio": limit(g, no_radius)},
    }


def draw(g, ax):
    ground = Frame("ground")
    s = Sketch(ax, ground, azimuth=-60, elevation=20)
    r, l = 1.0, 3.2  # not of the asked shape
    low, high = (-l / 2, 0, 0), (l / 2, 0, 0)
    s.line((-0.85 * l, 0, 0), (l, 0, 0), style="centre")
    s.cylinder(low, high, r, bore=0.94 * r)
    s.turn((0.85 * l, 0, 0), ground.i, label="spin")
    s.dimension((-l / 2, 0, -r), (l / 2, 0, -r), label="l", offset=-0.4)
    s.dimension(high, (l / 2, 0, r), label="r", offset=0)

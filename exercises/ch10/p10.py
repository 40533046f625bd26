"""10/10: the lengths at which a thin tube with a ring has direct precession."""

from exercises.devices.wobbling import WOBBLE, needed_spin, neutral_length
from exercises.tools import mpf, on_ground, proofs
from newton_euler import Frame, root
from newton_euler.applications import free_precession
from newton_euler.bodies import cylinder, cylindrical_shell, ring, rod


def tube(g, ratio, kind):
    """Transverse and axial moment of inertia of a tube of unit mass and radius."""
    I = kind(g.one, ratio, Frame("tube"), "z", mass=g.one).inertia
    return I.moment("x"), I.moment("z")


def whole(g, ratio, kind=cylindrical_shell):
    """The same with the ring."""
    I = ring(g.one, Frame("ring"), "z", mass=g.one).inertia
    around = g.n * I.moment("x"), g.n * I.moment("z")
    return tuple(a + b for a, b in zip(tube(g, ratio, kind), around, strict=True))


def limit(g, moments):
    """The ratio at which two moments, functions of it, are equal."""

    def excess(ratio):
        across, axial = moments(ratio)
        return across - axial

    return root(excess, g.one / 10, 10 * g.one)


def sense(g):
    return free_precession(*whole(g, g.q), WOBBLE, spin=1.0).sense


def solve(g):
    return {"ratio": limit(g, lambda ratio: whole(g, ratio)), "sense": lambda: str(sense(g))}


def steps(g):
    across, axial = whole(g, g.one)
    flat = across - rod(g.one, Frame("rod"), "z", mass=g.one).inertia.moment("x")
    return {"axial": axial, "flat": flat}


def prove(g):
    """The length without precession (:func:`neutral_length`); the sense from the points' spin."""
    rim = proofs.ring(mpf(1), order=2)

    def points(ratio):
        shell = proofs.raised(rim, ratio)
        return [(u / (1 + g.n), p) for u, p in shell] + [(g.n * u / (1 + g.n), p) for u, p in rim]

    spin = needed_spin(points(g.q))
    axial, across = proofs.mean(lambda p: [p[0] ** 2 + p[1] ** 2, p[1] ** 2], rim)
    return {
        "ratio": neutral_length(points, mpf(1)),
        "sense": lambda: "direct" if spin > 0 else "retrograde",
        "axial": (1 + g.n) * axial,
        "flat": (1 + g.n) * across,
    }


def mistakes(g):
    def no_radius(ratio):
        across, axial = whole(g, ratio)
        return across - g.one / 2, axial

    return {
        "solid": {"ratio": limit(g, lambda ratio: whole(g, ratio, cylinder))},
        "opposite": {"sense": lambda: "retrograde" if sense(g) == "direct" else "direct"},
        "no_radius": {"ratio": limit(g, no_radius)},
        "no_ring": {"ratio": solve(g.but(n=0 * g.n))["ratio"]},
    }


def draw(g, ax):
    ground, s = on_ground(ax, azimuth=-60, elevation=20)
    r, l = 1.0, 3.2  # not the shape asked for
    low, high = (-l / 2, 0, 0), (l / 2, 0, 0)
    s.line((-0.85 * l, 0, 0), (l, 0, 0), style="centre")
    s.cylinder(low, high, r, bore=0.94 * r)
    s.ring((0, 0, 0), ground.i, r)
    s.turn((0.85 * l, 0, 0), ground.i, label="spin")
    s.dimension((-l / 2, 0, -r), (l / 2, 0, -r), label="l", offset=-0.4)
    s.dimension(high, (l / 2, 0, r), label="r", offset=0)

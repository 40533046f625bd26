"""5/15: the centre of mass of four particles on light rods."""

from exercises.proofs import rate, root
from exercises.steps import Step
from newton_euler import Frame, centre_of_mass
from newton_euler.drawing import Sketch


def particles(g):
    """The frame, and a pair (mass, point) for each particle, the one at O first."""
    ground = Frame("ground")
    places = (0, 0, 0), (g.a, 0, 0), (g.a, g.b, 0), (g.a, g.b, g.c)
    points = [ground.point(f"P_{n}", *at) for n, at in enumerate(places, 1)]
    return ground, list(zip((g.m1, g.m2, g.m3, g.m4), points, strict=True))


def centre(ground, parts):
    return {"d": centre_of_mass(parts, ground).position(ground)}


def solve(g):
    return centre(*particles(g))


def steps(g):
    ground, parts = particles(g)
    yield Step("m", sum(m for m, _ in parts), "kg", "mass of all four particles", "5.2")
    for _, P in parts[1:]:
        yield Step(f"r_{P.name[-1]}", P.position(ground), "m", f"position of particle {P.name[-1]}",
                   "5.2")  # fmt: skip
    (m2, P2), (m3, P3), (m4, P4) = parts[1:]
    moment = m2 * P2.position(ground) + m3 * P3.position(ground) + m4 * P4.position(ground)
    yield Step("Q", moment, "kg*m", "sum of mass times position", "5.2", "5.4")


def prove(g):
    """On a knife edge square to each axis in turn, the weights have no moment."""
    masses = g.m1, g.m2, g.m3, g.m4

    def balance(*places):
        def moment(edge):
            return sum(m * (x - edge) for m, x in zip(masses, places, strict=True))

        return root(moment, -max(places), 2 * max(places))

    d = [balance(0, g.a, g.a, g.a), balance(0, 0, g.b, g.b), balance(0, 0, 0, g.c)]
    # Q is the rate of half the sum of m (r + t e)^2 with t, for each axis e
    Q = [
        rate(
            lambda t, along=along: (
                sum(m * (x + t) ** 2 for m, x in zip(masses, along, strict=True)) / 2
            )
        )
        for along in ((0, g.a, g.a, g.a), (0, 0, g.b, g.b), (0, 0, 0, g.c))
    ]
    return {"d": d, "Q": Q, "r_4": [g.a, g.b, g.c]}


def mistakes(g):
    ground, parts = particles(g)
    rods = (g.a, 0, 0), (0, g.b, 0), (0, 0, g.c)
    from_before = [
        (m, ground.point("P", *rod)) for (m, _), rod in zip(parts[1:], rods, strict=True)
    ]
    return {
        "no_masses": solve(g.but(m2=g.m1, m3=g.m1, m4=g.m1)),
        "without_the_first": centre(ground, parts[1:]),
        "from_the_one_before": centre(ground, [parts[0], *from_before]),
    }


def draw(g, ax):
    ground, parts = particles(g)
    s = Sketch(ax, ground, azimuth=-60, elevation=22)
    x, z = ground.i, ground.k
    span, mass = g.a + g.b + g.c, sum(m for m, _ in parts)
    s.axes((0, 0, 0), ground, length=0.5 * span)
    for (_, A), (_, B), name, away in zip(
        parts, parts[1:], "abc", (-0.12 * span * z, -0.12 * span * z, 0.12 * span * x), strict=False
    ):
        s.rod(A, B)
        s.dimension(A, B, label=name, offset=away)
    corners = (-24, -6), (-6, 20), (-22, 8), (-24, 6)
    for n, ((m, P), offset) in enumerate(zip(parts, corners, strict=True), 1):
        s.sphere(P, 0.045 * span * (m / mass) ** (1 / 3))  # all of one density
        s.label(P, f"$m_{n}$", offset=offset, bold=False)
    s.label((0, 0, 0), "O", offset=(-14, 14))

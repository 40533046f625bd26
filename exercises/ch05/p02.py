"""5/2: the centre of mass of two spheres that touch."""

from exercises import proofs
from exercises.devices.put_together import centre, proved, steps_of
from newton_euler import Frame
from newton_euler.bodies import sphere
from newton_euler.drawing import Sketch

SATELLITE = Frame("satellite")


def parts(g, distance=None):
    far = SATELLITE.point("centre", g.R1 + g.R2 if distance is None else distance, 0, 0)
    return [
        sphere(g.R1, SATELLITE, mass=g.m1, name="larger sphere"),
        sphere(g.R2, far, mass=g.m2, name="smaller sphere"),
    ]


def solve(g):
    return centre(SATELLITE, parts(g))


def steps(g):
    yield from steps_of(SATELLITE, parts(g), content="mass", mass="slug", length="ft")


def prove(g):
    """By the mass points of the two."""
    points = [(g.m1 * share, place) for share, place in proofs.ball(g.R1)]
    for share, place in proofs.ball(g.R2):
        points.append((g.m2 * share, proofs.plus(place, [g.R1 + g.R2, 0, 0])))
    whole = sum(m for m, _ in points)
    return proved("mass", whole, [sum(m * place[n] for m, place in points) for n in range(3)])


def mistakes(g):
    whole = g.m1 + g.m2
    return {
        "by_volume": solve(g.but(m1=g.R1**3, m2=g.R2**3)),
        "R1_for_distance": centre(SATELLITE, parts(g, distance=g.R1)),
        "larger_mass_only": {"d": solve(g)["d"] * (whole / g.m1)},
    }


def draw(g, ax):
    s = Sketch(ax, SATELLITE, plane="xz")
    O, C = (0, 0, 0), (g.R1 + g.R2, 0, 0)
    s.sphere(O, g.R1)
    s.sphere(C, g.R2)
    s.axes(O, SATELLITE, length=1.35 * (g.R1 + g.R2), labels=["x", "", "z"])
    s.dot(O)
    s.dot(C)
    s.dimension(O, (-0.6 * g.R1, 0, 0.8 * g.R1), label="$R_1$", offset=0)
    s.dimension(C, (g.R1 + 1.6 * g.R2, 0, 0.8 * g.R2), label="$R_2$", offset=0)
    s.label(O, "O")

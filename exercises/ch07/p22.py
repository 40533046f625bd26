"""7/22: moments of inertia from the integrals of the squares of the coordinates."""

from math import cos, pi, sin

from exercises.tools import Sketch, mean, mp, rate, rot, size, times
from newton_euler import Frame, bodies
from newton_euler.bodies.inertia import from_second_moments

BODY = Frame("body")
PLANE, LINE = "all mass in the plane x = 0", "all mass on the x axis"


def moments(Jx, Jy, Jz):
    return bodies.Inertia(BODY, *from_second_moments((Jx, Jy, Jz, 0, 0, 0)), tolerance=None).moments


def gap(I_xx, I_yy, I_zz):
    return I_yy + I_zz - I_xx


def gap_sym(I_xx, I_yy, I_zz):
    return I_yy - I_xx / 2


def solve(g):
    return {
        "gap": gap(*moments(g.Jx, g.Jy, g.Jz)),
        "when_zero": lambda: PLANE if gap(*moments(0.0, 1.0, 2.0)) == 0 else "never",
        "gap_sym": gap_sym(*moments(g.Jx, g.Jy, g.Jy)),
    }


def steps(g):
    xx, yy, zz = moments(g.Jx, g.Jy, g.Jz)
    return {"I_xx": xx, "I_yy": yy, "I_zz": zz, "I_xx_sym": moments(g.Jx, g.Jy, g.Jy)[0]}


def cloud(Jx, Jy, Jz):
    """Proof: a unit mass with these integrals, as eight mass points."""
    a, b, c = (mp.sqrt(J) for J in (Jx, Jy, Jz))
    places = [[p * a, q * b, r * c] for p in (-1, 1) for q in (-1, 1) for r in (-1, 1)]
    return [(mp.mpf(1) / 8, place) for place in places]


def by_points(points):
    """Proof: (I_xx, I_yy, I_zz) from the speeds of the points as the body turns at unit rate."""
    speed = lambda axis, place: size(rate(lambda t: times(rot(axis, t), place)))
    moment = lambda axis: mean(lambda place: speed(axis, place) ** 2, points)
    return [moment(axis) for axis in "xyz"]


def prove(g):
    """By mass points turned about each axis, for a cloud and the same cloud turned."""
    points = cloud(g.Jx, g.Jy, g.Jz)
    spun = [(w / 2, place) for w, (x, y, z) in points for place in ([x, y, z], [x, -z, y])]

    def word():
        flat, line = cloud(0, 1, 2), cloud(1, 0, 0)
        zero = {name for name, body in ((PLANE, flat), (LINE, line))
                if abs(gap(*by_points(body))) < mp.mpf(10) ** -10}  # fmt: skip
        return zero.pop() if len(zero) == 1 else "never"

    return {"gap": gap(*by_points(points)), "when_zero": word, "gap_sym": gap_sym(*by_points(spun))}


def mistakes(g):
    return {
        "squares_for_moments": {"gap": gap(g.Jx, g.Jy, g.Jz), "gap_sym": gap_sym(g.Jx, g.Jy, g.Jz)},
        "no_symmetry": {"gap_sym": gap_sym(*moments(g.Jx, g.Jy, g.Jz))},
        "line_for_plane": {"when_zero": LINE},
        "no_sum_vanishes": {"when_zero": "never"},
        "all_distances": {"when_zero": "only a single particle"},
    }


def draw(g, ax):
    s = Sketch(ax, BODY, azimuth=35, elevation=22)
    O, P = (0, 0, 0), (0.55, 0.75, 0.45)
    # an outline in the plane of the figure
    across, up = (-sin(0.61), cos(0.61), 0), (-0.31, -0.21, 0.93)
    wave = [2 * pi * n / 60 for n in range(61)]
    s.path([tuple((1.25 + 0.12 * sin(3 * t)) * (cos(t) * u + 0.75 * sin(t) * v)
                  + 0.35 * u + 0.15 * v for u, v in zip(across, up, strict=True))
            for t in wave])  # fmt: skip
    s.axes(O, BODY, length=1.9)
    foot = (P[0], P[1], 0)
    s.line(foot, P)
    s.line((P[0], 0, 0), foot)
    s.line((0, P[1], 0), foot)
    s.dot(P)
    s.label(P, "dm", bold=False)

"""3/1: the position from acceleration components that depend on time."""

from exercises.tools import Sketch, proofs
from newton_euler import Frame, kinematics

GROUND = Frame("ground")


def acceleration(g):
    """The components of a, each a function of time."""
    return (lambda t: g.a0 + g.a1 * t, lambda t: g.b2 * t**2, lambda t: g.c3 * t**3 - g.c0)


def start(g):
    return GROUND.vector(g.x0, g.y0, g.z0)


def motion(g, t):
    """Position and velocity at the time t."""
    along = [kinematics.from_time(a, t, x) for a, x in zip(acceleration(g), start(g), strict=True)]
    return [GROUND.vector(*c) for c in zip(*along, strict=True)]


def solve(g):
    return {"r": motion(g, g.t)[0]}


def steps(g):
    return {"v": motion(g, g.t)[1]}


def prove(g):
    """Mean velocity times time, the velocity likewise from the mean acceleration."""
    instants = proofs.box(1, 0, 0, order=3)  # from -1/2 to 1/2; exact for t^4

    def up_to(t, f):
        return proofs.scaled(t, proofs.mean(lambda p: f(t * (p[0] + g.one / 2)), instants))

    velocity = lambda t: up_to(t, lambda s: [g.a0 + g.a1 * s, g.b2 * s * s, g.c3 * s**3 - g.c0])
    return {"r": proofs.plus([g.x0, g.y0, g.z0], up_to(g.t, velocity)), "v": velocity(g.t)}


def mistakes(g):
    r, v = motion(g, g.t)
    a = GROUND.vector(*(f(g.t) for f in acceleration(g)))
    return {
        "start_left_out": {"r": r - start(g)},
        "a_taken_constant": {"r": start(g) + a * g.t**2 / 2},
        "integrated_once": {"r": start(g) + v},
    }


def draw(g, ax):
    s = Sketch(ax, GROUND, azimuth=55, elevation=22)
    foot = (g.x0, g.y0, 0)
    s.axes((0, 0, 0), GROUND, length=1.2 * max(1, *map(abs, start(g))))
    for A, B in ((foot, start(g)), (foot, (g.x0, 0, 0)), (foot, (0, g.y0, 0))):
        if tuple(B) != A:
            s.line(A, B, style="dotted")
    s.path([motion(g, 1.6 * n / 40)[0] for n in range(41)], style="dashed")
    s.dot(start(g), "$P_0$")
    s.label((0, 0, 0), "O")

"""2/6: a sprinkler on a sloping lawn."""

from exercises.tools import Sketch, mp, root
from newton_euler import Frame, cos, pi, sin

SIDES = {"d_C": -1, "d_B": 1}  # downhill and uphill: along -x and x


def scene(g, side):
    """The ground with z up, the lawn, rising along x, and the water's velocity and acceleration."""
    ground = Frame("ground")
    lawn = ground.rotate("lawn", "-y", angle=g.alpha)
    start = ground.vector(side * g.v_0 * sin(g.phi), 0, g.v_0 * cos(g.phi))
    return ground, lawn, start, ground.vector(0, 0, -g.g)


def time(g, side):
    """The time of flight, from the velocity at the start and the acceleration along the normal."""
    _, lawn, start, fall = scene(g, side)
    return -2 * start.dot(lawn.k) / fall.dot(lawn.k)


def landing(g, side):
    """The place of landing, from A."""
    _, _, start, fall = scene(g, side)
    T = time(g, side)
    return start * T + fall * (T**2 / 2)


def solve(g):
    return {key: side * landing(g, side).x for key, side in SIDES.items()}


def steps(g):
    return {f"t_{key[-1]}": time(g, side) for key, side in SIDES.items()}


def prove(g):
    """The time at which the water is at the height of the lawn."""
    answers, times = {}, {}
    for key, side in SIDES.items():

        def above(t, side=side):
            x = side * g.v_0 * mp.sin(g.phi) * t
            return g.v_0 * mp.cos(g.phi) * t - g.g / 2 * t**2 - x * mp.tan(g.alpha)

        T = root(above, g.v_0 / g.g / 100, 10 * g.v_0 / g.g)
        answers[key], times[f"t_{key[-1]}"] = g.v_0 * mp.sin(g.phi) * T, T
    return answers | times


def mistakes(g):
    return {
        "from_the_horizontal": solve(g.but(phi=pi(g.phi) / 2 - g.phi)),
        "level": solve(g.but(alpha=0 * g.alpha)),
        "along_the_slope": {key: landing(g, side).norm() for key, side in SIDES.items()},
    }


def draw(g, ax):
    s = Sketch(ax, scene(g, 1)[0], plane="xz")
    A = (0, 0, 0)
    B, C = (landing(g, SIDES[key]).components() for key in ("d_B", "d_C"))
    s.road([tuple(1.25 * x for x in C), tuple(1.8 * x for x in B)])
    for side in SIDES.values():
        _, _, start, fall = scene(g, side)
        T = time(g, side)
        times = [T * n / 40 for n in range(41)]
        s.path([(start * t + fall * (t**2 / 2)).components() for t in times])
        s.vector(A, start.components(), "$v_0$")
    top = (0, 0, 0.8 * abs(C[0]))
    s.line(A, top)
    s.line(A, (B[0] * 1.8, 0, 0))
    toward_C = scene(g, -1)[2] * (0.5 * top[2] / g.v_0)
    s.arc(A, top, toward_C.components(), label=r"$\phi$")
    s.arc(A, (1, 0, 0), B, label=r"$\alpha$", radius=1.5 * B[0])
    s.dot(A)
    for P, name, offset in ((A, "A", (4, -14)), (B, "B", (9, 10)), (C, "C", (-9, 6))):
        s.label(P, name, offset=offset)
    low = C[2] - 0.3 * abs(C[0])
    s.dimension((C[0], 0, low), (0, 0, low), "$d_C$", offset=0)
    s.dimension((0, 0, low), (B[0], 0, low), "$d_B$", offset=0)

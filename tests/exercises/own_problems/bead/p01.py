"""bead/1: a bead that slides along a turning rod."""

from exercises.tools import Sketch, rate, rot, second_rate, size, times
from newton_euler import Frame, moving


def bead(g):
    ground = Frame("ground")
    rod = ground.rotate("rod", "z", rate=g.omega)
    return ground, rod, rod.point("B", moving(g.r, rate=g.v), 0, 0)


def solve(g):
    ground, rod, B = bead(g)
    v = B.velocity(ground, via=rod)
    a = B.acceleration(ground, via=rod)
    return {
        "v_B": v.expressed_in(ground),
        "speed": v.norm(),
        "a_B": a.expressed_in(ground),
        "time": (g.L - g.r) / g.v,
    }


def steps(g):
    ground, rod, _ = bead(g)
    return {"omega_rod": rod.angular_velocity(ground)}


follows = {"speed": lambda g, v_B: v_B.norm()}


def prove(g):
    B = lambda t: times(rot("z", g.omega * t), [g.r + g.v * t, 0, 0])
    velocity = rate(B)
    left = g.L - g.r
    return {"v_B": velocity, "speed": size(velocity), "a_B": second_rate(B), "time": left / g.v}


def mistakes(g):
    ground, rod, B = bead(g)
    v = B.velocity(ground, via=rod)
    a = B.acceleration(ground, via=rod)
    return {
        "no_turning": {"v_B": v.without("rotation").expressed_in(ground), "speed": g.v},
        "speeds_added": {"speed": g.v + g.omega * g.r},
        "no_coriolis": {"a_B": a.without("coriolis").expressed_in(ground)},
        "from_the_axle": {"time": g.L / g.v},
    }


def draw(g, ax):
    ground, rod, B = bead(g)
    s = Sketch(ax, ground, azimuth=-60, elevation=25)
    O, end = (0, 0, 0), rod.point("end", g.L, 0, 0)
    s.shaft((0, 0, -0.3 * g.L), (0, 0, 0.4 * g.L))
    s.rod(O, end)
    s.dot(B)
    s.label(O, "O", offset=(-12, -8))
    s.label(B, "B", offset=(0, -12))
    s.vector(B, rod.i, "v")
    s.turn((0, 0, 0.3 * g.L), ground.k, label=r"$\omega$")
    s.dimension(O, B, label="r", offset=0.12 * g.L)
    s.dimension(O, end, label="L", offset=0.3 * g.L)

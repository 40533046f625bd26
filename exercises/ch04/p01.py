"""4/1: the handle of a screw-jack, by a frame that rises with the screw without turning."""

from mpmath import mp

from exercises.proofs import rate, second_rate, size
from newton_euler import Frame, cos, moving, pi, sin
from newton_euler.drawing import Sketch


def rise(g):
    """Axial speed of the screw: one lead for each turn."""
    return g.lead * g.n / (2 * pi(g.n))


def screw_in_nut(g, rise, n):
    """Ground with Z up along the screw; a frame at B that rises with it; the screw turning in that frame."""
    ground = Frame("ground")
    rising = ground.translate("rising", ground.point("B", 0, 0, moving(0, rate=rise)))
    screw = rising.rotate("screw", "z", rate=n)
    return ground, rising, screw.point("A", g.a, 0, 0)


def speed_and_acceleration(ground, rising, A):
    return {"speed": A.velocity(ground, via=rising).norm(), "acc_mag": A.acceleration(ground, via=rising).norm()}


def solve(g):
    return speed_and_acceleration(*screw_in_nut(g, rise(g), g.n))


def prove(g):
    def A(t):
        turns = g.n * t / (2 * mp.pi)
        return [g.a * mp.cos(g.n * t), g.a * mp.sin(g.n * t), g.lead * turns]

    return {"speed": size(rate(A)), "acc_mag": size(second_rate(A))}


def mistakes(g):
    ground, rising, A = screw_in_nut(g, rise(g), g.n)
    v = A.velocity(ground, via=rising).terms
    coriolis = 2 * g.n * rise(g)
    return {
        "n_as_rad_per_s": speed_and_acceleration(*screw_in_nut(g, rise(g), g.stated("n"))),
        "lead_per_radian": {"speed": speed_and_acceleration(*screw_in_nut(g, g.lead * g.n, g.n))["speed"]},
        "speeds_added": {"speed": v["origin"].norm() + v["relative"].norm()},
        "extra_coriolis": {"acc_mag": A.acceleration(ground).norm() + coriolis},
    }


def draw(g, ax):
    ground, rising, A = screw_in_nut(g, rise(g), g.n)
    B, thick, low = rising.origin, 0.15 * g.a, -0.3 * g.a - 2.5 * g.lead
    s = Sketch(ax, ground, azimuth=-110, elevation=18)
    s.box((0, 0, low), ground, (0.9 * g.a, 0.7 * g.a, 0.3 * g.a))
    s.cylinder((0, 0, low + 0.15 * g.a), B, thick)
    left, lowest, nearer = -200 * pi() / 180, -0.1 * g.a - 2.4 * g.lead, [2 * thick * x for x in s.view.eye]
    for n in range(3):  # the near half of each turn, moved toward the eye so that it is not lost in the cylinder
        turn = [(w, lowest + g.lead * (n + w / (2 * pi()))) for w in (k * pi() / 24 for k in range(25))]
        thread = [(thick * cos(left + w), thick * sin(left + w), z) for w, z in turn]
        s.path([[x + dx for x, dx in zip(P, nearer, strict=True)] for P in thread])
        ends = (thread[-1], (*thread[-1][:2], thread[-1][2] - g.lead))
    s.rod(B, A)
    s.ground((-0.45 * g.a, 0, low - 0.15 * g.a), normal=ground.k)
    s.turn((0, 0, 0.25 * g.a), ground.k, label="n")
    s.axes(B, rising, length=0.5 * g.a)
    s.dimension(B, A, label="a")
    s.dimension(*ends, label="lead")
    s.label(A, "A")

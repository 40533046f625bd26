"""4/1: the handle of a screw-jack, by a frame that rises with the screw but does not turn."""

from exercises.devices.moving_frame import seen_in
from exercises.devices.screw_jack import figure, handle_in_time, rise, screw_in_nut
from exercises.tools import rate, second_rate, size


def speed_and_acceleration(ground, rising, A):
    v, a = A.velocity(ground, via=rising), A.acceleration(ground, via=rising)
    return {"speed": v.norm(), "acc_mag": a.norm()}


def solve(g):
    return speed_and_acceleration(*screw_in_nut(g, rise(g), g.n))


def steps(g):
    ground, rising, A = screw_in_nut(g, rise(g), g.n)
    yield "omega", g.n
    yield "v_B", rise(g)
    frame = "the moving frame, which rises with B and does not turn"
    yield from seen_in(rising, A, ground, "in", frame, "B, with x toward A and z up")
    yield "v_A", A.velocity(ground, via=rising).expressed_in(ground)


def prove(g):
    A = handle_in_time(g)
    seen = lambda t: [*A(t)[:2], 0]  # from the axis, at the height of A
    answers = {"speed": size(rate(A)), "acc_mag": size(second_rate(A))}
    return answers | {
        "v_B": rate(lambda t: A(t)[2]),
        "r": seen(0),
        "v_r": rate(seen),
        "a_r": second_rate(seen),
        "v_A": rate(A),
    }


def mistakes(g):
    ground, rising, A = screw_in_nut(g, rise(g), g.n)
    v = A.velocity(ground, via=rising).terms
    coriolis = 2 * g.n * rise(g)
    by_radian = speed_and_acceleration(*screw_in_nut(g, g.lead * g.n, g.n))
    return {
        "n_as_rad_per_s": speed_and_acceleration(*screw_in_nut(g, rise(g), g.stated("n"))),
        "circular_only": {"speed": g.a * g.stated("n")},
        "lead_per_radian": {"speed": by_radian["speed"]},
        "speeds_added": {"speed": v["origin"].norm() + v["relative"].norm()},
        "extra_coriolis": {"acc_mag": A.acceleration(ground).norm() + coriolis},
    }


def draw(g, ax):
    frames = _, rising, _ = screw_in_nut(g, rise(g), g.n)
    figure(g, ax, *frames).axes(rising.origin, rising, length=0.5 * g.a)

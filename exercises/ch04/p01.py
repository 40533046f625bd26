"""4/1: the handle of a screw-jack, by a frame that rises with the screw without turning."""

from exercises.devices.moving_frame import seen_in
from exercises.devices.screw_jack import figure, handle_in_time, rise, screw_in_nut
from exercises.tools import Step, rate, second_rate, size


def speed_and_acceleration(ground, rising, A):
    return {
        "speed": A.velocity(ground, via=rising).norm(),
        "acc_mag": A.acceleration(ground, via=rising).norm(),
    }


def solve(g):
    return speed_and_acceleration(*screw_in_nut(g, rise(g), g.n))


def steps(g):
    ground, rising, A = screw_in_nut(g, rise(g), g.n)
    yield "omega", g.n
    means = "speed at which B, on the axis at the height of A, rises: one lead in each turn"
    yield Step("v_B", rise(g), "in/s", means)
    frame = "the moving frame, which rises with B and does not turn"
    yield from seen_in(rising, A, ground, "in", frame, "B, with x toward A and z up")
    means = "velocity of A: v_B upward and v_r together, as the moving frame does not turn"
    v = A.velocity(ground, via=rising).expressed_in(ground)
    yield Step("v_A", v, "in/s", means, "4.8", "4.17")


def prove(g):
    A = handle_in_time(g)

    def seen(t):  # from the axis, at the height of A
        return [*A(t)[:2], 0]

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
    return {
        "n_as_rad_per_s": speed_and_acceleration(*screw_in_nut(g, rise(g), g.stated("n"))),
        "circular_only": {"speed": g.a * g.stated("n")},
        "lead_per_radian": {
            "speed": speed_and_acceleration(*screw_in_nut(g, g.lead * g.n, g.n))["speed"]
        },
        "speeds_added": {"speed": v["origin"].norm() + v["relative"].norm()},
        "extra_coriolis": {"acc_mag": A.acceleration(ground).norm() + coriolis},
    }


def draw(g, ax):
    frames = _, rising, _ = screw_in_nut(g, rise(g), g.n)
    figure(g, ax, *frames).axes(rising.origin, rising, length=0.5 * g.a)

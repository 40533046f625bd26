"""2/32: as 2/31, with both speeds changing."""

from exercises.devices import two_cars as device

solve, steps, prove, draw = device.solve, device.steps, device.prove, device.draw


def mistakes(g):
    without = lambda *names: {"a_rel": device.seen_acceleration(*device.cars(g), *names)}
    return {
        "no_alpha": without("euler"),
        "B_speeds_up": solve(g.but(c_B=-g.c_B)),
        "no_coriolis": without("coriolis"),
        "a_B_minus_a_A": without("coriolis", "euler", "centripetal"),
    }

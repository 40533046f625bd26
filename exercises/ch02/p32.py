"""2/32: as 2/31, with both speeds changing."""

from exercises.devices.two_cars import cars, draw, prove, seen_acceleration, solve, steps


def mistakes(g):
    without = lambda *names: {"a_rel": seen_acceleration(*cars(g), *names)}
    return {
        "no_alpha": without("euler"),
        "B_speeds_up": solve(g.but(c_B=-g.c_B)),
        "no_coriolis": without("coriolis"),
        "a_B_minus_a_A": without("coriolis", "euler", "centripetal"),
    }

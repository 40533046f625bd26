"""2/32: as 2/31, with both speeds changing."""

from exercises.devices import two_cars


def scene(g):
    return two_cars.cars(g, g.c_A, -g.c_B)


def solve(g):
    return {"a_rel": two_cars.seen_acceleration(*scene(g))}


def steps(g):
    yield from two_cars.acceleration_steps(*scene(g))


def prove(g):
    velocities, accelerations = two_cars.prove(g, g.c_A, -g.c_B)
    return accelerations | velocities


def mistakes(g):
    without = lambda *names: {"a_rel": two_cars.seen_acceleration(*scene(g), *names)}
    return {
        "no_alpha": without("euler"),
        "B_speeds_up": solve(g.but(c_B=-g.c_B)),
        "no_coriolis": without("coriolis"),
        "a_B_minus_a_A": without("coriolis", "euler", "centripetal"),
    }


def draw(g, ax):
    s, ground, long = two_cars.figure(g, ax)
    s.vector((-2 * long, long, 0), ground.j * g.c_A, "$c_A$", kind="acceleration")
    s.vector((g.x + 2 * long, long, 0), ground.j * g.c_B, "$c_B$", kind="acceleration")

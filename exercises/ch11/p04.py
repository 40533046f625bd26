"""11/4: a collar sliding down a quarter hoop into a spring."""

from exercises.devices.quarter_hoop import sketch, slides, work_of_weight
from exercises.tools import until
from newton_euler import pi, sqrt
from newton_euler.dynamics import speed_after, spring_potential

follows = {"x_max": lambda g, v_B: compression(g, v_B)}


def compression(g, v):
    """The compression at which the spring has absorbed the collar's energy at the speed v."""
    return sqrt(g.m * v**2 / 2 / spring_potential(g.k, g.one))


def answers(g, U):
    v = speed_after(0, U, g.m)
    return {"v_B": v, "x_max": compression(g, v)}


def solve(g):
    return answers(g, work_of_weight(g))


def steps(g):
    return {"U_w": work_of_weight(g)}


def prove(g):
    """The motion over time, down the hoop and then against the spring."""
    t, v = slides(g)

    def against(state):
        x, u = state
        return [u, -g.k * x / g.m]

    _, (x, _) = until(against, [0 * t, v], lambda s: s[1], t / 40)
    return {"v_B": v, "x_max": x}


def mistakes(g):
    return {
        "balance_of_forces": {"x_max": g.m * g.g / g.k},
        "kilo_overlooked": {"x_max": solve(g.but(k=g.k / 1000))["x_max"]},
        "no_half": {"x_max": solve(g.but(k=2 * g.k))["x_max"]},
        "arc_as_drop": answers(g, work_of_weight(g) * pi(g.R) / 2),
    }


def draw(g, ax):
    s, (ground, O, A, B) = sketch(g, ax)
    end = (1.3 * g.R, -g.R, 0)
    s.wire([B, end])
    s.spring((0.02 * g.R, -g.R, 0), end, radius=0.07 * g.R, coils=10)
    s.ground(end, -ground.i, size=0.4 * g.R)
    s.dimension(A, O, label="R", offset=0)
    s.dot(O)
    s.label((0.65 * g.R, -g.R, 0), "k", offset=(0, 18), bold=False)

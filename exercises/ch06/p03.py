"""6/3: the force on a particle from its position over time."""

from exercises.tools import rate
from newton_euler import Frame, dynamics, kinematics

AXES = Frame("axes")
G = 32.2  # the number in ft/s^2, for a mistake


def particle(g):
    path = lambda t: (g.c_0 - g.c_1 * t**2, g.c_2 * t**3, g.c_3 * t**2 - g.c_4 * t)
    return AXES.point("P", *kinematics.along(path, g.t_1))


def solve(g):
    return {"F": dynamics.resultant_force(g.m, particle(g).acceleration(AXES))}


def steps(g):
    P = particle(g)
    return {"v": P.velocity(AXES), "a": P.acceleration(AXES)}


def prove(g):
    """Each force component as power over velocity, the power as a rate of kinetic energy."""
    axes = (
        lambda t: g.c_0 - g.c_1 * t**2,
        lambda t: g.c_2 * t**3,
        lambda t: g.c_3 * t**2 - g.c_4 * t,
    )
    force = lambda x: rate(lambda t: g.m * rate(x, t) ** 2 / 2, g.t_1) / rate(x, g.t_1)
    return {"F": [force(x) for x in axes], "v": [rate(x, g.t_1) for x in axes]}


def mistakes(g):
    F = solve(g)["F"]
    return {
        "mass_times_velocity": {"F": g.m * particle(g).velocity(AXES)},
        "time_first": {"F": 0 * F},
        "weight_for_mass": {"F": G * F},
        "minus_lost": {"F": solve(g.but(c_1=-g.c_1))["F"]},
    }

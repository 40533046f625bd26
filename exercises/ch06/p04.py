"""6/4: the force on a particle from its velocity over time."""

from exercises.tools import mp, scaled, second_rate
from newton_euler import Frame, cos, dynamics, moving, radians, sin

AXES = Frame("axes")


def tip(g):
    """The tip of the velocity drawn from a fixed point, which moves at the acceleration."""
    t = moving(g.t_1, rate=g.one)
    angle = g.omega * t
    return AXES.point("tip", g.A * cos(angle), g.B * t**2, -g.A * sin(angle))


def solve(g):
    return {"F": dynamics.resultant_force(g.m, tip(g).velocity(AXES))}


def steps(g):
    return {"a": tip(g).velocity(AXES)}


def prove(g):
    """Seen along j the particle circles at the radius A/omega: place, velocity, second rate."""
    radius = g.A / g.omega
    place = lambda t: [radius * mp.sin(g.omega * t), g.B * t**3 / 3, radius * mp.cos(g.omega * t)]
    a = second_rate(place, g.t_1)
    return {"F": scaled(g.m, a), "a": a}


def mistakes(g):
    F = solve(g)["F"]
    n = g.stated("omega")
    angle = radians(n * g.stated("t_1"))
    turning = AXES.vector(sin(angle), 0, cos(angle)) * -g.m * g.A * g.omega
    return {
        "no_inner_derivative": {"F": AXES.vector(F.x / n, F.y, F.z / n)},
        "degrees": {"F": turning + AXES.vector(0, F.y, 0)},
        "twice": {"F": g.m * tip(g).acceleration(AXES)},
        "minus_lost": {"F": AXES.vector(-F.x, F.y, F.z)},
    }

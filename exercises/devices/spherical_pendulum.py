"""A particle at a constant distance from a fixed point O, 11/26 to 11/28: as the bob of a spherical
pendulum, or in a ring without mass that turns freely about its vertical diameter. Either gives it
a force along the line to O alone, so that its angular momentum about the vertical is kept.
"""

from exercises.tools import mp, proofs
from newton_euler import Frame, particle, sqrt
from newton_euler.dynamics import kinetic_energy, weight_potential


def level_motion(m, radius, depth, rate):
    """Kinetic energy and angular momentum about the vertical through O on a level circle."""
    ground = Frame("ground")
    turning = ground.rotate("turning", "z", rate=rate)
    P = particle(m, turning.point("P", sqrt(radius**2 - depth**2), 0, -depth))
    return kinetic_energy(P, ground).value, P.angular_momentum(ground, about=turning.origin).z


def sine_of_descent(m, radius, rate, g, share=1):
    """Of the greatest angle below the level of O, s, if the particle starts there with this rate.

    With the angular momentum kept, its kinetic energy T_0 becomes T_0/(1 - s^2), and it loses
    m g radius s of potential energy: (T_0/(m g radius)) s = 1 - s^2. ``share`` weighs T_0.
    """
    T_0, _ = level_motion(m, radius, 0 * radius, rate)
    k = share * T_0 / weight_potential(m, radius, g)
    return (sqrt(k**2 + 4) - k) / 2


# -- the motion, for proofs and figures


def rates(g):
    """Of the state, z upward: the force toward O keeps the distance, r.a + v^2 = 0."""

    def of(state):
        r, v = state[:3], state[3:]
        pull = (g * r[2] - sum(x * x for x in v)) / sum(x * x for x in r)
        return [*v, pull * r[0], pull * r[1], pull * r[2] - g]

    return of


def start(depth, radius, speed):
    """Level, along y; in floats if these are floats."""
    zero = 0 * speed
    away = (radius * radius - depth * depth) ** (speed / speed / 2)
    return [away, zero, -depth, zero, speed, zero]


def other_level(g, depth, radius, speed):
    """Place and velocity at the next moment without vertical velocity."""
    hint = radius / (speed + (g * radius) ** (speed / speed / 2))
    _, state = proofs.until(rates(g), start(depth, radius, speed), lambda s: s[5], hint)
    return state[:3], state[3:]


def way(g, depth, radius, speed, duration, pieces=60):
    """Places on the trajectory, in floats."""
    state, places = start(*map(float, (depth, radius, speed))), []
    for _ in range(pieces + 1):
        places.append(tuple(state[:3]))
        state = proofs.after(rates(float(g)), state, float(duration) / pieces)
    return places


def depth_angle(place):
    """The angle of the line from O to this place, below the horizontal plane."""
    return mp.atan2(-place[2], mp.hypot(*place[:2]))

"""A particle at a constant distance from a fixed point O (11/26 to 11/28): the bob of a spherical
pendulum, or a bead in a massless ring that turns freely about its vertical diameter. Both
constraints conserve the angular momentum about the vertical.
"""

from collections.abc import Callable, Sequence

from exercises.annotations import Number, Scalar
from exercises.tools import mp, proofs
from newton_euler import Frame, particle, sqrt
from newton_euler.dynamics import kinetic_energy, weight_potential


def level_motion(m: Scalar, radius: Scalar, depth: Scalar, rate: Scalar) -> tuple[Scalar, Scalar]:
    """Kinetic energy and angular momentum about the vertical through O, on a horizontal circle."""
    ground = Frame("ground")
    turning = ground.rotate("turning", "z", rate=rate)
    P = particle(m, turning.point("P", sqrt(radius**2 - depth**2), 0, -depth))
    return kinetic_energy(P, ground).value, P.angular_momentum(ground, about=turning.origin).z


def sine_of_descent(
    m: Scalar, radius: Scalar, rate: Scalar, g: Scalar, share: Scalar = 1
) -> Scalar:
    """The sine s of the greatest angle below the level of O, for a start at that level at this
    rate.

    As the angular momentum is conserved, the kinetic energy T_0 becomes T_0/(1 - s^2) while m g
    radius s of potential energy is lost: (T_0/(m g radius)) s = 1 - s^2. ``share`` multiplies T_0.
    """
    T_0, _ = level_motion(m, radius, 0 * radius, rate)
    k = share * T_0 / weight_potential(m, radius, g)
    return (sqrt(k**2 + 4) - k) / 2


# -- the motion, for proofs and figures


def rates(g: Number) -> Callable[[list[Number]], list[Number]]:
    """The rates of the state, z upward; the force toward O follows from r.a + v^2 = 0."""

    def of(state):
        r, v = state[:3], state[3:]
        pull = (g * r[2] - sum(x * x for x in v)) / sum(x * x for x in r)
        return [*v, pull * r[0], pull * r[1], pull * r[2] - g]

    return of


def start(depth: Number, radius: Number, speed: Number) -> list[Number]:
    """The state of a horizontal start along y, in the arithmetic of the arguments."""
    zero = 0 * speed
    away = (radius * radius - depth * depth) ** (speed / speed / 2)
    return [away, zero, -depth, zero, speed, zero]


def other_level(
    g: Number, depth: Number, radius: Number, speed: Number
) -> tuple[list[Number], list[Number]]:
    """Position and velocity at the next instant without vertical velocity."""
    hint = radius / (speed + (g * radius) ** (speed / speed / 2))
    _, state = proofs.until(rates(g), start(depth, radius, speed), lambda s: s[5], hint)
    return state[:3], state[3:]


def way(
    g: Scalar, depth: Scalar, radius: Scalar, speed: Scalar, duration: Scalar, pieces: int = 60
) -> list[tuple[float, ...]]:
    """Points of the trajectory, in floats."""
    state, places = start(*map(float, (depth, radius, speed))), []
    for _ in range(pieces + 1):
        places.append(tuple(state[:3]))
        state = proofs.after(rates(float(g)), state, float(duration) / pieces)
    return places


def depth_angle(place: Sequence[Number]) -> Number:
    """The angle of the line from O to this place, below the horizontal plane."""
    return mp.atan2(-place[2], mp.hypot(*place[:2]))

"""Worked examples of chapter 6, Newton's law: a mass on a guide (6.2), the forces on the ball of a
screw-jack (6.5), the rim of a space station (6.7), the forces on an aircraft (6.12).
"""

from typing import NamedTuple

from newton_euler import Frame, Vector, atan2, moving, sqrt
from newton_euler.algebra.scalars import Scalar, to_plain
from newton_euler.chapters.examples.ch03 import screw_jack_ball
from newton_euler.dynamics.newton import path_force, reaction, resultant_force


def guide_force(m: Scalar, v: Scalar, radius: Scalar, g: Scalar) -> Scalar:
    """The force of a smooth guide in a vertical plane on the mass that passes its top (6.2): m
    (v^2/radius - g), by (6.5); N if in SI.

    Positive down, towards the centre of curvature; negative where the guide supports the mass; zero
    where free flight would follow the same curve. The speed v may have either sign.

    >>> round(guide_force(2.0, 4.8, 0.5, 9.81), 2)
    72.54
    """
    _, F_n = path_force(m, v, 0, 1 / radius)
    return to_plain(F_n - m * g)


def screw_jack_force(
    ground: Frame, m: Scalar, a: Scalar, K: Scalar, lead: Scalar, t: Scalar
) -> Vector:
    """The resultant force on the ball of :func:`.screw_jack_ball` at the time ``t`` (6.5), (6.8): a
    Vector along the ball's cylindrical axes, N if in SI. The book calls it the force of the arm;
    but the arm carries the weight too, see :func:`screw_jack_arm_force`.

    >>> print(screw_jack_force(Frame("ground"), 0.2, 0.1, 10.0, 0.5, 1.0))
    [-2, 0.2, 0.159155] in cylindrical axes of ball
    """
    return resultant_force(m, screw_jack_ball(ground, a, K, lead, t).acceleration(ground))


def screw_jack_arm_force(
    ground: Frame, m: Scalar, a: Scalar, K: Scalar, lead: Scalar, t: Scalar, g: Scalar
) -> Vector:
    """The force of the arm on the ball at the time ``t`` (6.5): the resultant less the weight, with
    both as terms; N if in SI.

    >>> print(screw_jack_arm_force(Frame("ground"), 0.2, 0.1, 10.0, 0.5, 1.0, 9.81))
    [-2, 0.2, 2.12115] in cylindrical axes of ball
    """
    acceleration = screw_jack_ball(ground, a, K, lead, t).acceleration(ground)
    return reaction(m, acceleration, weight=m * g * -ground.k)


def rim_speed(g: Scalar, radius: Scalar) -> Scalar:
    """The speed of the rim of a space station on which a body at the rim weighs as much as on the
    Earth (6.7): sqrt(g radius). A person who runs as fast against the rotation is at rest in the
    inertial frame and has no weight.

    >>> round(rim_speed(9.81, 100.0), 3)
    31.321
    """
    return sqrt(g * radius)


class FlightForces(NamedTuple):
    """The forces of a flight: ``excess``, thrust less drag; ``lift``; and the ``bank`` angle in
    rad, positive in a turn to the right.
    """

    excess: Scalar
    lift: Scalar
    bank: Scalar


def flight_forces(m: Scalar, g: Scalar, v: Scalar, gamma: Scalar, chi: Scalar = 0) -> FlightForces:
    """The forces of a given flight (6.12): :class:`FlightForces`, from the moving speed, path angle
    and heading.

    v, gamma, chi : numbers, or moving ones with their first rates

    >>> from newton_euler import moving
    >>> flight_forces(2.0, 9.81, moving(50.0, rate=10.0), 0.0)  # straight and level, gaining speed
    FlightForces(excess=20.0, lift=19.62, bank=0.0)
    """
    north = Frame("ground")  # i along the heading 0, k up
    path = north.rotate("heading", "-z", chi).rotate("path", "-y", gamma)
    force = reaction(m, path.vector(moving(v), 0, 0).rate(north), weight=m * g * -north.k)
    excess, left, up = force.expressed_in(path).c
    return FlightForces(to_plain(excess), to_plain(sqrt(left * left + up * up)), atan2(-left, up))

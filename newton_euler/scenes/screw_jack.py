"""The ball on the arm of a screw-jack (3.6, 6.5): it turns about a vertical axis, ever faster, and rises by the lead each turn."""

from ..components import cylindrical
from ..jets import at
from ..kinetics import reaction, resultant_force
from ..scalars import pi, sqrt


def ball(ground, a, K, lead, t):
    """The ball at time ``t`` after the start from rest at theta = 0, as a point of ``ground`` in cylindrical coordinates.

    a : length of the arm; K : angular acceleration, rad/s^2; lead : rise in one turn

    >>> from newton_euler import Frame
    >>> ground = Frame("ground")
    >>> print(ball(ground, 0.1, 10.0, 0.5, 1.0).velocity(ground))
    [0, 1, 0.795775] in cylindrical axes of ball
    """
    theta = at(lambda time: K * time * time / 2, t)
    return cylindrical(ground, "ball", a, theta, theta * lead / (2 * pi(K)))


def time_of_turns(turns, K):
    """The time of so many turns from rest."""
    return 2 * sqrt(pi(K) * turns / K)


def force_on_ball(ground, m, a, K, lead, t):
    """The resultant force on the ball at time ``t`` (6.8), along its cylindrical axes.

    The book calls it the force of the arm; but the arm carries the weight too, see :func:`force_of_arm`.
    """
    return resultant_force(m, ball(ground, a, K, lead, t).acceleration(ground))


def force_of_arm(ground, m, a, K, lead, t, g):
    """The force of the arm on the ball at time ``t``: the resultant, less the weight, with both as terms."""
    return reaction(m, ball(ground, a, K, lead, t).acceleration(ground), weight=m * g * -ground.k)

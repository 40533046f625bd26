"""A unit vector that turns in a plane (App. A, example 1)."""

from ..frames import Frame
from ..jets import moving


def turning_unit_vector(theta, rate):
    """The unit vector e = cos theta i + sin theta j and its rate theta' e_theta, as Vectors in the ground.

    theta : rad, from i towards j; rate : theta' in rad/s

    >>> e, e_dot = turning_unit_vector(0.0, 3.0)
    >>> e_dot, e.dot(e_dot)
    (Vector(-0.0, 3.0, 0 in ground), 0.0)
    """
    ground = Frame("ground")
    turning = ground.rotate("turning", "z", moving(theta, rate))
    return turning.i.expressed_in(ground), turning.i.rate(ground).expressed_in(ground)

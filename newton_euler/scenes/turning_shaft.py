"""A rod, or any flat or slender body, hinged at the end of a vertical shaft that turns at a constant rate (10.7).

theta is the angle from the *downward* vertical to the rod. ``distance`` is that from the hinge to G, on the rod; ``excess`` is I_n - I_r about the
hinge: the moment of inertia about the axis normal to both rod and hinge, less that about the rod (m L^2/3 for the rod itself).
"""

from ..gyros import GyroError
from ..models import Model
from ..scalars import acos, cos, is_numeric, plain, sin, size, sqrt


def rod(mass, length, omega, g):
    """The parameters of the thin rod of the book: a dict for :func:`swing_out`, :func:`least_rate` and :func:`hinged`.

    >>> rod(3.0, 2.0, 4.0, 9.81)["excess"]
    4.0
    """
    return {"weight_moment": mass * g * length / 2, "excess": mass * (length * length) / 3, "omega": omega}


def least_rate(weight_moment, excess, **_):
    """The rate sqrt(m g d/(I_n - I_r)) (rad/s) above which the body swings out; for the rod sqrt(3 g/(2 L)). Up to it, hanging down is stable.

    >>> round(least_rate(**rod(3.0, 2.0, 4.0, 9.81)), 6)
    2.712471
    """
    return sqrt(weight_moment / excess)


def swing_out(weight_moment, excess, omega, **_):
    """The angle theta (rad) at which the body stays, for a rate above :func:`least_rate`: acos(m g d/((I_n - I_r) omega^2)), (10.31) with I = 0.

    weight_moment : m g d. Raises :class:`~newton_euler.gyros.GyroError` for a rate that is too low: then it hangs straight down.

    >>> round(swing_out(**rod(3.0, 2.0, 4.0, 9.81)), 6)
    1.092977
    """
    c = weight_moment / (excess * (omega * omega))
    if is_numeric(c) and size(c) > 1:
        raise GyroError(f"at {plain(omega)} rad/s the body hangs straight down; it swings out above {plain(least_rate(weight_moment, excess))} rad/s")
    return acos(c)


def stiffness(theta, weight_moment, excess, omega, about_hinge=None):
    """The square of the angular frequency of small swings about theta, 0 or :func:`swing_out`; stable where it is positive.

    (m g d cos(theta) - (I_n - I_r) omega^2 cos(2 theta))/I_hinge; I_hinge is ``excess`` unless given.

    >>> stiffness(0.0, **rod(3.0, 2.0, 2.0, 9.81)) > 0, stiffness(0.0, **rod(3.0, 2.0, 4.0, 9.81)) > 0
    (True, False)
    """
    return (weight_moment * cos(theta) - excess * (omega * omega) * cos(2 * theta)) / (excess if about_hinge is None else about_hinge)


def hinged(weight_moment, excess, omega, about_hinge=None):
    """The swinging as a Model, states theta and theta_rate; invariant the energy seen in the turning frame.

    >>> hinged(**rod(3.0, 2.0, 4.0, 9.81)).derivative((0.0, 1.0))
    (1.0, 0.0)
    """
    parameters = {"weight_moment": weight_moment, "excess": excess, "omega": omega, "about_hinge": excess if about_hinge is None else about_hinge}
    return Model("hinged on a turning shaft", parameters, ("theta", "theta_rate"), _rates, {"energy": _energy})


def _rates(s, p, t):
    return s.theta_rate, sin(s.theta) * (p.excess * (p.omega * p.omega) * cos(s.theta) - p.weight_moment) / p.about_hinge


def _energy(s, p, t):
    return (p.about_hinge * s.theta_rate**2 - p.excess * (p.omega * sin(s.theta)) ** 2) / 2 - p.weight_moment * cos(s.theta)

"""The energy of the heavy symmetric top (11.16); its motion: :mod:`.top`."""

from ..energy import gyroscope_energy
from ..scalars import cos, scalar
from ..work import summed


def top_energy(I0, I, mgr, theta, theta_rate, precession, spin):
    """T + V of a top about its fixed point, an Amount with the terms ``transverse``, ``axial`` and ``weight``; constant during the motion.

    I0, I, ``mgr`` and angles as in :mod:`newton_euler.gyros`. V = + mgr cos(theta), since theta is counted from the *upward* vertical and the moment
    of the weight, + mgr sin(theta) (10.30), makes it grow. The book prints a minus sign here, with which the sum is not constant.

    >>> top_energy(1.5, 1.0, 10.0, 0.0, 0.0, 2.0, 3.0).terms
    {'transverse': 0.0, 'axial': 12.5, 'weight': 10.0}
    """
    T = gyroscope_energy(I0, I, theta, theta_rate, precession, spin)
    return summed({**T.terms, "weight": scalar(mgr) * cos(theta)}, "energy", "11.32")

"""One vector in rectangular, cylindrical and spherical components (3.8, 3.9 example 2)."""

from ..components import T_phi, T_theta
from ..rotations import apply


def three_systems(Q, theta, phi):
    """(rectangular, cylindrical, spherical) components of the vector with the rectangular components ``Q``, at azimuth theta and elevation phi.

    theta, phi : rad; the spherical components are in the order R, theta, phi (3.32), (3.38).

    >>> three_systems((5.0, 0, 0), 0.0, 0.0)
    ((5.0, 0, 0), (5.0, -0.0, 0.0), (5.0, 0.0, 0.0))
    """
    cylindrical = apply(T_theta(theta), Q)
    return tuple(Q), cylindrical, apply(T_phi(phi), cylindrical)

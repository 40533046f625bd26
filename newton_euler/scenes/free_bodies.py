"""Symmetric bodies on which no moment acts (10.8): a football, a space station, the Earth's wobble.

Each is data for :func:`newton_euler.gyros.free_precession`. The precession of the Earth's axis in about 26 000 years is no example of it: the Sun and
the Moon force it by their moments on the equatorial bulge; what is free is the wobble, with a period of about 10 months if the Earth were rigid.
"""

from ..gyros import free_precession
from ..solids import cylinder


def football(theta, spin):
    """The book's football, I0 = 3 I: direct precession at psi' = phi'/(2 cos(theta)).

    >>> football(0.0, 10.0).rate
    5.0
    """
    return free_precession(3.0, 1.0, theta, spin)


def station_moments(radius, length, centre):
    """I0 and I of a space station like a homogeneous cylinder of unit mass; ``centre`` a Point.

    >>> from newton_euler import Frame
    >>> station_moments(3.0, 30.0, Frame("station").origin)
    (77.25, 4.5)
    """
    along, across, _ = cylinder(radius, length, centre, "x", mass=1.0).inertia.moments
    return across, along


def wobble_period(ellipticity, day):
    """The period, in units of ``day``, in which the axis of rotation goes around the axis of symmetry of a rigid body, seen from the body.

    ellipticity : (I - I0)/I0, 0.003285 for the Earth. The rate is (I - I0) omega_z/I0, and with theta small phi' = -(I - I0) omega_z/I0.

    >>> round(wobble_period(0.003285, 1.0))  # days; 14 months are seen, since the Earth is elastic
    304
    """
    return day / ellipticity

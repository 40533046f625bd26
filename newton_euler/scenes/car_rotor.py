"""A rotor that takes the overturning moment off the wheels of a car in a turn (10.10).

The axis of the rotor is parallel to the axles, and it spins against the sense of the wheels.
"""


def rotor_moment(mass, height, speed, turn_radius):
    """The moment that the car needs so that its wheels on both sides carry the same: h m v^2/r, N m if in SI.

    >>> rotor_moment(1000.0, 0.5, 20.0, 100.0)
    2000.0
    """
    return height * mass * speed * speed / turn_radius


def rotor_spin(mass, height, speed, rotor_mass, gyration):
    """The spin phi' = h m v/(K^2 m_R) (rad/s) that gives this moment in every turn, from I psi' phi' = h m v^2/r with psi' = v/r (10.37).

    gyration : the radius of gyration K of the rotor. Masses may be weights, both. The book's 1000 rad/s, 9549 rpm:

    >>> rotor_spin(3000.0, 4.0, 100.0, 300.0, 2.0)
    1000.0
    """
    return height * mass * speed / (gyration * gyration * rotor_mass)


def wheel_loads(mass, height, speed, turn_radius, track, g, rotor=0.0):
    """The vertical forces on the inner and the outer wheels of a car with an angular momentum ``rotor`` = I phi' (kg m^2/s) of the rotor.

    Moments about G: (outer - inner) track/2 = h m v^2/r - I phi' v/r; with :func:`rotor_spin` both are m g/2.

    >>> wheel_loads(1000.0, 0.5, 20.0, 100.0, 1.6, 10.0)
    (3750.0, 6250.0)
    """
    shift = (rotor_moment(mass, height, speed, turn_radius) - rotor * speed / turn_radius) / track
    return mass * g / 2 - shift, mass * g / 2 + shift

"""What gyroscopes are used for (10.11): the wheel of a bicycle, the rate sensor, the inertial platform; the gyrocompass: :mod:`.gyrocompass`.

All rest on M = I psi' phi' (10.37): a moment makes the axis of a spinning body precess, and turning the axis takes a moment.
"""


def uprighting_moment(I, speed, wheel_radius, steering_rate):
    """The moment with which a rolling wheel, steered at ``steering_rate``, acts about the line of travel: I phi' psi' with phi' = v/r.

    Positive: steered to the left, the wheel leans the bicycle to the right. It is not the only reason why a bicycle stays up.

    >>> uprighting_moment(0.1, 5.0, 0.25, 0.5)
    1.0
    """
    return I * (speed / wheel_radius) * steering_rate


def sensed_tilt(I, spin, rate, stiffness):
    """The tilt (rad) of a rate gyroscope about its line of nodes: I phi' psi'/stiffness, a spring of N m/rad holding it. For small tilts.

    >>> round(sensed_tilt(0.001, 1000.0, 0.02, 0.5), 6)
    0.04
    """
    return I * spin * rate / stiffness


def drift(moment, I, spin):
    """The rate (rad/s) at which friction in a gimbal turns the axis of an inertial platform: M/(I phi').

    >>> drift(1e-6, 0.001, 1000.0)
    1e-06
    """
    return moment / (I * spin)

"""A cable at rest in a horizontal plane under tension and a load along its length (3.3)."""

from ..frames import Frame
from ..jets import at
from ..paths import frenet_along
from ..vectors import Vector


def out_of_balance(tension, tension_rate, flexure, load):
    """The three sums that must vanish: (dT/ds + R1, T f + R2, R3).

    tension, tension_rate : T and dT/ds; flexure : f of the cable; load : (R1, R2, R3), the force per length on the cable along e_t, e_n, e_b

    >>> out_of_balance(100.0, -2.0, 0.5, (2.0, -50.0, 0.0))
    (0.0, 0.0, 0.0)
    """
    R1, R2, R3 = load
    return tension_rate + R1, tension * flexure + R2, R3


def load_for_rest(path, tension, q, ground=None):
    """The force per length that holds the cable at rest, a Vector along e_t, e_n, e_b: R1 = -dT/ds, R2 = -T f, R3 = 0.

    path : function of a parameter that returns (x, y, z) of the cable; tension : T as a function of the same parameter; q : its value here
    Raises :class:`~newton_euler.scalars.SingularError` where the cable is straight.

    >>> from newton_euler import cos, sin
    >>> print(load_for_rest(lambda q: (2.0*cos(q), 2.0*sin(q), 0), lambda q: 100.0, 0.3))  # round a smooth post: it pushes outwards with T/r
    [0, -50, 0] in e_t, e_n, e_b of the cable
    """
    cable = frenet_along(path, q, ground or Frame("ground"), name="the cable")
    T = at(tension, q)
    return Vector((-T.rate / cable.speed, -T.value * cable.flexure, 0), cable.frame)

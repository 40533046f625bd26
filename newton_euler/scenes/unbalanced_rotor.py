"""Any body on a level shaft, at a varying rate, with its dead weight (9.5).

The shaft lies along Z of the ground, Y... see :func:`general_rotor`. As the book has it, the first axis J of the ground points vertically down, psi
is counted from it, z = Z lies along the shaft from bearing A to bearing B, and O is the origin of the body's axes.
"""

from ..mass import Body, Inertia
from ..models import Model
from ..scalars import cos, sin
from .off_centre_disk import on_shaft


def general_rotor(mass, centre, moments, products, a, b, psi, omega, alpha=0):
    """The body of (9.7)-(9.10) with its bearings: a :class:`~newton_euler.scenes.off_centre_disk.RotorScene`.

    centre : coordinates of G in the body's axes from O; moments, products : (I_xx, I_yy, I_zz) and the integrals (I_xy, I_yz, I_zx) about O
    The downward vertical is ``scene.ground.i``: ``scene.reactions(gravity=9.81*scene.ground.i)``.

    >>> scene = general_rotor(2.0, (0.1, 0, 0), (1.0, 1.0, 1.0), (0, 0, 0), 0.5, 0.5, 0.0, 3.0)
    >>> found = scene.reactions(gravity=10.0*scene.ground.i)
    >>> round(found.A.x, 6)  # -10 of the weight, -0.9 of m omega^2 x
    -10.9
    """
    shaft, scene = on_shaft("z", a, b, psi, omega, alpha)
    G = shaft.point("G", *centre)
    about_O = Inertia(shaft.origin, moments, products, mass, G, shaft)
    return scene(Body("rotor", mass, G, about_O.about(G), shaft))


def turning_rotor(mass, x, y, I, g, moment=0.0):
    """The motion of that body under a moment M about the shaft (9.10): a Model with the states psi and omega.

    x, y : coordinates of G in the body's axes; I about the axis of the shaft; moment : a number or a law (s, p, t)
    """
    return Model(
        "rotor with dead weight",
        {"mass": mass, "x": x, "y": y, "I": I, "g": g, "moment": moment},
        ("psi", "omega"),
        lambda s, p, t: (s.omega, (p.moment - p.mass * p.g * (p.x * sin(s.psi) + p.y * cos(s.psi))) / p.I),
        {} if callable(moment) else {"energy": _energy},
    )


def _energy(s, p, t):
    """Kinetic energy, less the works of weight and moment."""
    return p.I * s.omega**2 / 2 - p.mass * p.g * (p.x * cos(s.psi) - p.y * sin(s.psi)) - p.moment * s.psi

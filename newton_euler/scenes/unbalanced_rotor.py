"""Any body on a level shaft, at a varying rate, with its dead weight (9.5).

As the book has it, the axis X of the ground points vertically down, and psi is counted from it; z = Z lies along the shaft from bearing A
to bearing B, at -a and b from O, the origin of the body's axes.
"""

from ..mass import Body, Inertia
from ..models import Model
from ..scalars import cos, sin
from .shaft import on_shaft


def unbalanced_rotor(mass, centre, moments, products, a, b, psi, omega, alpha=0):
    """The body of (9.7)-(9.10) in its bearings: a :class:`~newton_euler.scenes.shaft.RotorScene`.

    centre : coordinates of G in the body's axes from O; moments, products : (I_xx, I_yy, I_zz) and the integrals (I_xy, I_yz, I_zx) about O
    The downward vertical is ``scene.ground.i``: ``scene.reactions(gravity=9.81*scene.ground.i)``.

    >>> scene = unbalanced_rotor(2.0, (0.1, 0, 0), (1.0, 1.0, 1.0), (0, 0, 0), 0.5, 0.5, 0.0, 3.0)
    >>> round(scene.reactions(gravity=10.0*scene.ground.i).A.x, 6)  # -10 of the weight, -0.9 of m omega^2 x
    -10.9
    """
    shaft, scene = on_shaft("z", a, b, psi, omega, alpha)
    G = shaft.point("G", *centre)
    return scene(Body("rotor", mass, G, Inertia(shaft.point("O", 0, 0, 0), moments, products, mass, G), shaft))


def turning_rotor(mass, x, y, I, g, moment=0):
    """The motion of that body under a moment M about the shaft (9.10): a Model with the states psi and omega.

    x, y : coordinates of G in the body's axes; I about the axis of the shaft; moment : a number or a law (s, p, t)

    >>> turning_rotor(2.0, 0.1, 0.0, 0.5, 10.0, moment=1.0).derivative((0.0, 3.0))
    (3.0, 2.0)
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

"""A body on a shaft in two bearings (chapter 9), and any body on a level shaft, at a varying rate,
with its dead weight (9.5).

As the book has it, the axis X of the ground points vertically down, and psi is counted from it; z =
Z lies along the shaft from bearing A to bearing B, at -a and b from O, the origin of the body's
axes.

:func:`ladder` has three models of its rotation: at a constant rate, without its weight, and with
it.
"""

from dataclasses import dataclass

from ...algebra.scalars import cos, sin, sqrt
from ...applications.rotors import reactions
from ...bodies.body import Body
from ...bodies.inertia import Inertia
from ...kinematics.frames import Frame, Point
from ...motion.model import Model, Neglected
from ..catalogue import scene
from ..closed_forms.harmonic import uniform_acceleration
from ..ladders import Ladder, Rung, observed_states

ANGLE = "angle psi, rad"


@dataclass(frozen=True)
class RotorScene:
    """A body on a shaft: the frames ``ground`` and ``shaft``, the ``body``, its bearings A and B,
    and O between them.
    """

    ground: Frame
    shaft: Frame
    body: Body
    A: Point
    B: Point
    O: Point

    def reactions(self, gravity=None):
        """The :class:`newton_euler.applications.rotors.Reactions`; ``gravity`` a Vector, or None to
        leave the weight out.
        """
        return reactions(self.body, self.A, self.B, self.ground, gravity, self.O)


def on_shaft(axis, a, b, psi, omega, alpha=0):
    """A shaft turned by psi about ``axis`` ("x" or "z") of the ground, its bearings at -a and b
    from O.

    Returns the frame of the shaft, and a function that makes the :class:`RotorScene` of a body in
    it.

    >>> from newton_euler.bodies.solids import disk
    >>> shaft, scene = on_shaft("x", 0.2, 0.3, 0.0, 10.0)
    >>> scene(disk(0.1, shaft, "x", mass=1.0)).reactions().A.norm()
    0
    """
    ground = Frame("ground")
    shaft = ground.rotate("shaft", axis, psi, omega, alpha)
    A, B = (
        shaft.point(name, *((s, 0, 0) if axis == "x" else (0, 0, s)))
        for name, s in (("A", -a), ("B", b))
    )
    return shaft, lambda body: RotorScene(ground, shaft, body, A, B, shaft.point("O", 0, 0, 0))


def unbalanced_rotor(mass, centre, moments, products, a, b, psi, omega, alpha=0):
    """The body of (9.7)-(9.10) in its bearings: a :class:`RotorScene`.

    centre : coordinates of G in the body's axes from O; moments, products : (I_xx, I_yy, I_zz) and
        the integrals (I_xy, I_yz, I_zx) about O
    The downward vertical is ``scene.ground.i``: ``scene.reactions(gravity=9.81*scene.ground.i)``.

    >>> scene = unbalanced_rotor(2.0, (0.1, 0, 0), (1.0, 1.0, 1.0), (0, 0, 0), 0.5, 0.5, 0.0, 3.0)
    >>> round(scene.reactions(gravity=10.0*scene.ground.i).A.x, 6)  # -10 of the weight, -0.9 of m omega^2 x
    -10.9
    """
    shaft, scene = on_shaft("z", a, b, psi, omega, alpha)
    G = shaft.point("G", *centre)
    return scene(
        Body(
            "rotor", mass, G, Inertia(shaft.point("O", 0, 0, 0), moments, products, mass, G), shaft
        )
    )


@scene(
    "9.5", "rotor", "a rotor with dead weight, started from rest by a constant moment", 8.0, (0.0, 0.0),
    mass=2.0, x=0.1, y=0.0, I=0.5, g=10.0, moment=2.5,
)  # fmt: skip
def turning_rotor(mass, x, y, I, g, moment=0):
    """The motion of that body under a moment M about the shaft (9.10): a Model with the states psi
    and omega.

    x, y : coordinates of G in the body's axes; I about the axis of the shaft; moment : a number or
        a law (s, p, t)

    >>> turning_rotor(2.0, 0.1, 0.0, 0.5, 10.0, moment=1.0).derivative((0.0, 3.0))
    (3.0, 2.0)
    """
    return Model(
        "rotor with dead weight",
        locals(),
        ("psi", "omega"),
        _rates,
        {} if callable(moment) else {"energy": _energy},
    )


@scene("9.5", "rotor", "constant rate, no weight, dead weight", ladder=True)
def ladder(mass=20.0, x=2e-4, y=0.0, I=0.5, g=9.81, moment=0.5, start=(0.0, 10.0), t=20.0):
    """The models of a rotor that a constant moment turns, the coarsest first: a
    :class:`~newton_euler.scenes.ladders.Ladder` for psi, in rad, until ``t``.

    start : psi, omega; the rest as in :func:`turning_rotor`

    >>> from newton_euler import smallest
    >>> [smallest(ladder(), radians).model.name for radians in (1000.0, 10.0, 1e-3)]
    ['rotor at a constant rate', 'rotor without weight', 'rotor with dead weight']
    """
    full = turning_rotor(mass, x, y, I, g, moment)
    steady = Model(
        "rotor at a constant rate",
        {**full.parameters, "omega": start[1]},
        ("psi",),
        _steady,
        {},
        _turned,
        (MOMENT, WEIGHT),
    )
    light = Model(
        "rotor without weight",
        full.parameters,
        ("psi", "omega"),
        _light,
        {"energy": _light_energy},
        _sped_up,
        (WEIGHT,),
    )
    return Ladder(
        "rotor",
        ANGLE,
        t,
        tuple(
            Rung(model, start[: len(model.states)], observed_states("psi"))
            for model in (steady, light, full)
        ),
    )


def _steady(s, p, t):
    return (p.omega,)


def _turned(s, p, t):
    return (s.psi + p.omega * t,)


def _light(s, p, t):
    return s.omega, p.moment / p.I


def _sped_up(s, p, t):
    return uniform_acceleration(s.psi, s.omega, p.moment / p.I, t)


def _light_energy(s, p, t):
    return p.I * s.omega**2 / 2 - p.moment * s.psi


def _rates(s, p, t):
    return s.omega, (p.moment - p.mass * p.g * (p.x * sin(s.psi) + p.y * cos(s.psi))) / p.I


def _energy(s, p, t):
    """Kinetic energy, less the works of weight and moment."""
    return (
        p.I * s.omega**2 / 2
        - p.mass * p.g * (p.x * cos(s.psi) - p.y * sin(s.psi))
        - p.moment * s.psi
    )


# -- what may be neglected: at any angle the weight has at most the moment m g d


def _by_moment(s, p, t):
    return sqrt(p.moment * p.moment) / p.I * (t * t) / 2


def _by_weight(s, p, t):
    return p.mass * p.g * sqrt(p.x * p.x + p.y * p.y) / p.I * (t * t) / 2


MOMENT = Neglected("the moment about the shaft", _by_moment, ANGLE)
WEIGHT = Neglected("the dead weight", _by_weight, ANGLE)

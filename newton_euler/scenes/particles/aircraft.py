"""An aircraft as a particle over a ground taken as inertial: in a vertical plane (6.3) and in space
(6.12).

Thrust acts along the velocity, drag against it, lift normal to it and, in a coordinated turn,
tilted by the *bank* angle to the right. The *path angle* gamma is upward from the horizontal, the
*heading* chi from the y axis toward the x axis (north toward east, if y is north); both in rad.
Each force, and the bank, is a number or a law ``(s, p, t)`` of the states, the parameters and the
time.

:func:`ladder` has four models of a flight at fixed controls: straight, in a level turn, in a
vertical plane, and in space.
"""

from typing import NamedTuple

from ...algebra.jets import moving
from ...algebra.scalars import atan2, cos, plain, sin, sqrt, tan
from ...dynamics.newton import reaction
from ...kinematics.frames import Frame
from ...motion.model import Model, Neglected, is_absent
from ..catalogue import scene
from ..ladders import Ladder, Rung, observed_states

POSITION = "position, m"
PLANE, SPACE = ("v", "gamma", "x", "y"), ("v", "chi", "gamma", "x", "y", "h")


def _drag_of_scene(s, p, t):
    return 0.004 * s.v * s.v


@scene(
    "6.3", "aircraft", "an aircraft in a vertical plane, with thrust, lift and the drag of the air", 20.0, (50.0, 0.1, 0.0, 100.0),
    m=2.0, g=9.81, thrust=12.0, drag=_drag_of_scene, lift=25.0,
)  # fmt: skip
def vertical_flight(m, g, thrust=0, drag=0, lift=0):
    """The model of flight in a vertical plane (6.3): states v, gamma, x, y (y up).

    Without thrust and drag the energy v^2/2 + g y is an invariant; without lift as well the
    parabola is its exact solution.

    >>> vertical_flight(2.0, 9.81, thrust=30.0, drag=10.0, lift=19.62).derivative((50.0, 0.0, 0.0, 100.0))
    (10.0, 0.0, 50.0, 0.0)
    """
    parameters, coasting = locals(), is_absent(thrust) and is_absent(drag)
    energy = {"energy over mass": lambda s, p, t: s.v * s.v / 2 + p.g * s.y} if coasting else {}
    return Model(
        "aircraft in a vertical plane",
        parameters,
        PLANE,
        _in_plane,
        energy,
        _parabola if coasting and is_absent(lift) else None,
    )


@scene(
    "6.12", "aircraft in space", "an aircraft in a turn, banked by 0.5 rad, with a little more lift than it needs", 20.0,
    (50.0, 0.0, 0.0, 0.0, 0.0, 100.0), m=2.0, g=9.81, thrust=12.0, drag=_drag_of_scene, lift=22.5, bank=0.5,
)  # fmt: skip
def flight(m, g, thrust=0, drag=0, lift=0, bank=0):
    """The model of flight in space (6.12): states v, chi, gamma, x, y, h (h up). For bank 0 it is
    that of :func:`vertical_flight`.

    The heading does not exist in vertical flight, gamma = pi/2 or -pi/2.

    >>> turning = flight(2.0, 10.0, lift=25.0, bank=0.6435011087932844)  # sin(bank) is 0.6: a level turn
    >>> [round(x, 9) + 0 for x in turning.derivative((30.0, 0.0, 0.0, 0.0, 0.0, 100.0))]
    [0.0, 0.25, 0.0, 0.0, 30.0, 0.0]
    """
    parameters, coasting = locals(), is_absent(thrust) and is_absent(drag)
    energy = {"energy over mass": lambda s, p, t: s.v * s.v / 2 + p.g * s.h} if coasting else {}
    return Model("aircraft in space", parameters, SPACE, _in_space, energy)


@scene("6.12", "aircraft", "straight, in a level turn, in a vertical plane, in space", ladder=True)
def ladder(
    m=1000.0,
    g=9.81,
    thrust=1000.0,
    lift=2.8,
    drag=0.27,
    bank=0.05,
    start=(60.0, 0.5, 0.0, 0.0, 0.0, 1000.0),
    t=20.0,
):
    """The models of a flight at fixed controls, the coarsest first: a
    :class:`~newton_euler.scenes.ladders.Ladder` for the position, in m, until ``t``.

    lift, drag : the forces over the square of the speed, kg/m; start : v, chi, gamma, x, y, h. All
        are numbers. Without bank there is no turn, and
    the ladder has three rungs.

    >>> from newton_euler import smallest
    >>> [smallest(ladder(), metres).model.name for metres in (200.0, 50.0, 1.0)]
    ['aircraft, straight', 'aircraft in a level turn', 'aircraft in space']
    >>> smallest(ladder(bank=1e-4), 10.0).model.name
    'aircraft in a vertical plane'
    """
    v, chi, gamma, x, y, h = start
    forces = {
        "m": m,
        "g": g,
        "thrust": thrust,
        "drag": _drag,
        "lift": _lift,
        "k_lift": lift,
        "k_drag": drag,
    }
    ground, begun = {"chi0": chi, "x0": x, "y0": y}, {"v0": v, "h0": h}
    straight = Model(
        "aircraft, straight",
        {**ground, **begun, "gamma0": gamma},
        ("s",),
        _straight,
        {},
        _gone,
        (UNBALANCED, BANK),
    )
    turn = Model(
        "aircraft in a level turn",
        {**ground, **begun, "g": g, "bank": bank},
        ("chi",),
        _turning,
        {},
        _turned,
        (UNBALANCED,),
    )
    plane = Model(
        "aircraft in a vertical plane", {**forces, **ground}, PLANE, _in_plane, neglects=(BANK,)
    )
    space = Model("aircraft in space", {**forces, "bank": bank}, SPACE, _in_space)
    turns = () if is_absent(bank) else (Rung(turn, (chi,), _on_circle),)
    freer = (
        Rung(plane, (v, gamma, 0.0, h), _in_ground),
        Rung(space, start, observed_states("x", "y", "h")),
    )
    return Ladder("aircraft", POSITION, t, (Rung(straight, (0.0,), _on_line), *turns, *freer))


def _lift(s, p, t):
    return p.k_lift * s.v * s.v


def _drag(s, p, t):
    return p.k_drag * s.v * s.v


def _straight(s, p, t):
    return (p.v0,)


def _gone(s, p, t):
    return (s.s + p.v0 * t,)


def _on_line(s, p, t):
    level = s.s * cos(p.gamma0)
    return p.x0 + level * sin(p.chi0), p.y0 + level * cos(p.chi0), p.h0 + s.s * sin(p.gamma0)


def _turning(s, p, t):
    """The lift carries the weight, so its level part is m g tan(bank)."""
    return (p.g * tan(p.bank) / p.v0,)


def _turned(s, p, t):
    return (s.chi + p.g * tan(p.bank) / p.v0 * t,)


def _on_circle(s, p, t):
    chord, mean = (
        2 * p.v0 * p.v0 / (p.g * tan(p.bank)) * sin((s.chi - p.chi0) / 2),
        (s.chi + p.chi0) / 2,
    )
    return p.x0 + chord * sin(mean), p.y0 + chord * cos(mean), p.h0


def _in_ground(s, p, t):
    return p.x0 + s.x * sin(p.chi0), p.y0 + s.x * cos(p.chi0), s.y


def _in_plane(s, p, t):
    v, gamma = _along_path(s, p, p.lift)
    return v, gamma, s.v * cos(s.gamma), s.v * sin(s.gamma)


def _in_space(s, p, t):
    v, gamma = _along_path(s, p, p.lift * cos(p.bank))
    chi = p.lift * sin(p.bank) / (p.m * s.v * cos(s.gamma))
    level = s.v * cos(s.gamma)
    return v, chi, gamma, level * sin(s.chi), level * cos(s.chi), s.v * sin(s.gamma)


def _along_path(s, p, lift):
    """(v', gamma') by the forces along the path and, of the lift, its part in the vertical plane."""
    return (p.thrust - p.drag) / p.m - p.g * sin(s.gamma), (lift / p.m - p.g * cos(s.gamma)) / s.v


def _parabola(s, p, t):
    level, climb = s.v * cos(s.gamma), s.v * sin(s.gamma) - p.g * t
    return (
        sqrt(level * level + climb * climb),
        atan2(climb, level),
        s.x + level * t,
        s.y + (s.v * sin(s.gamma) - p.g * t / 2) * t,
    )


UNBALANCED = Neglected("that the forces do not balance along the path and upwards", None, POSITION)
BANK = Neglected("the bank", None, POSITION)


class FlightForces(NamedTuple):
    """What a given flight needs: ``excess``, thrust less drag; ``lift``; ``bank`` in rad, positive
    in a turn to the right.
    """

    excess: object
    lift: object
    bank: object


def flight_forces(m, g, v, gamma, chi=0):
    """The forces that make this motion: :class:`FlightForces` from the moving speed, path angle and
    heading (6.12).

    v, gamma, chi : numbers, or moving ones with their first rates

    >>> from newton_euler import moving
    >>> flight_forces(2.0, 9.81, moving(50.0, rate=10.0), 0.0)  # straight and level, gaining speed
    FlightForces(excess=20.0, lift=19.62, bank=0.0)
    """
    north = Frame("ground")  # i along the heading 0, k up
    path = north.rotate("heading", "-z", chi).rotate("path", "-y", gamma)
    force = reaction(
        m, path.vector(moving(v), 0, 0).rate(north), weight=m * g * -north.k
    ).expressed_in(path)
    excess, left, up = force.c
    return FlightForces(plain(excess), plain(sqrt(left * left + up * up)), atan2(-left, up))

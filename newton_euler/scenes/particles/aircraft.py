"""An aircraft as a particle over inertial ground: in a vertical plane (6.3), in space (6.12).

Thrust acts along the velocity, drag against it, lift normal to it and, in a coordinated turn,
tilted by the *bank* angle to the right; each, and the bank, is a number or a law ``(s, p, t)``. The
*path angle* gamma is upward from the horizontal, the *heading* chi from the y axis toward the x
axis (north toward east, if y is north); in rad.
"""

from collections.abc import Callable
from operator import attrgetter

from ...algebra.scalars import Scalar, atan2, cos, sin, sqrt, tan
from ...motion.model import Model, Neglected, is_absent
from ..catalogue import scene
from ..closed_forms.harmonic import constant_rate, uniform_acceleration
from ..ladders import Ladder, Rung, observed_states

POSITION = "position, m"
PLANE, SPACE = ("v", "gamma", "x", "y"), ("v", "chi", "gamma", "x", "y", "h")
SQUARE_LAWS = {
    "lift": lambda s, p, t: p.k_lift * s.v * s.v,
    "drag": lambda s, p, t: p.k_drag * s.v * s.v,
}


def _drag_of_scene(s, p, t):
    return 0.004 * s.v * s.v


@scene(
    "6.3", "aircraft", "flight in a vertical plane, with thrust, lift and drag",
    20.0, (50.0, 0.1, 0.0, 100.0),
    m=2.0, g=9.81, thrust=12.0, drag=_drag_of_scene, lift=25.0,
)  # fmt: skip
def vertical_flight(
    m: Scalar, g: Scalar, thrust: Scalar | Callable = 0, drag: Scalar | Callable = 0,
    lift: Scalar | Callable = 0,
) -> Model:  # fmt: skip
    """The Model of flight in a vertical plane (6.3): states v, gamma, x, y (y up). Without thrust
    and drag the energy over mass is an invariant; without lift as well it is a parabola.

    >>> plane = vertical_flight(2.0, 9.81, thrust=30.0, drag=10.0, lift=19.62)
    >>> plane.derivative((50.0, 0.0, 0.0, 100.0))
    (10.0, 0.0, 50.0, 0.0)
    """
    parameters, coasting = locals(), is_absent(thrust) and is_absent(drag)
    energy = {"energy over mass": lambda s, p, t: s.v * s.v / 2 + p.g * s.y} if coasting else {}
    exact = _parabola if coasting and is_absent(lift) else None
    return Model("aircraft in a vertical plane", parameters, PLANE, _in_plane, energy, exact)


@scene(
    "6.12", "aircraft in space", "a climbing turn, banked by 0.5 rad",
    20.0,
    (50.0, 0.0, 0.0, 0.0, 0.0, 100.0),
    m=2.0, g=9.81, thrust=12.0, drag=_drag_of_scene, lift=22.5, bank=0.5,
)  # fmt: skip
def flight(
    m: Scalar, g: Scalar, thrust: Scalar | Callable = 0, drag: Scalar | Callable = 0,
    lift: Scalar | Callable = 0, bank: Scalar | Callable = 0,
) -> Model:  # fmt: skip
    """The Model of flight in space (6.12): states v, chi, gamma, x, y, h (h up); for bank 0 that of
    :func:`vertical_flight`. Singular in vertical flight, which has no heading.

    >>> # sin(bank) is 0.6: a level turn
    >>> turning = flight(2.0, 10.0, lift=25.0, bank=0.6435011087932844)
    >>> [round(x, 9) + 0 for x in turning.derivative((30.0, 0.0, 0.0, 0.0, 0.0, 100.0))]
    [0.0, 0.25, 0.0, 0.0, 30.0, 0.0]
    """
    parameters, coasting = locals(), is_absent(thrust) and is_absent(drag)
    energy = {"energy over mass": lambda s, p, t: s.v * s.v / 2 + p.g * s.h} if coasting else {}
    return Model("aircraft in space", parameters, SPACE, _in_space, energy)


@scene("6.12", "aircraft", "straight, in a level turn, in a vertical plane, in space", ladder=True)
def ladder(
    m: Scalar = 1000.0, g: Scalar = 9.81, thrust: Scalar = 1000.0, lift: Scalar = 2.8,
    drag: Scalar = 0.27, bank: Scalar = 0.05,
    start: tuple[Scalar, ...] = (60.0, 0.5, 0.0, 0.0, 0.0, 1000.0), t: Scalar = 20.0,
) -> Ladder:  # fmt: skip
    """The models of a flight at fixed controls, for the position (m) until ``t``: straight, in a
    level turn (none without bank), in a vertical plane, in space.

    lift, drag : numbers, force over speed squared, kg/m; start : v, chi, gamma, x, y, h.

    >>> from newton_euler import smallest
    >>> [smallest(ladder(), metres).model.name for metres in (200.0, 50.0, 1.0)]
    ['aircraft, straight', 'aircraft in a level turn', 'aircraft in space']
    """
    v, chi, gamma, x, y, h = start
    ground = {"chi0": chi, "x0": x, "y0": y}
    begun = {**ground, "v0": v, "h0": h}
    name, given = "aircraft, straight", {**begun, "gamma0": gamma}
    straight = constant_rate(name, given, _straight, "s", neglects=(UNBALANCED, BANK))
    name, given = "aircraft in a level turn", {**begun, "g": g, "bank": bank}
    turn = constant_rate(name, given, _turning, "chi", neglects=(UNBALANCED,))
    forces = {"m": m, "g": g, "thrust": thrust, "k_lift": lift, "k_drag": drag}
    forces |= SQUARE_LAWS
    name = "aircraft in a vertical plane"
    plane = Model(name, {**forces, **ground}, PLANE, _in_plane, neglects=(BANK,))
    space = Model("aircraft in space", {**forces, "bank": bank}, SPACE, _in_space)
    rungs = (
        Rung(straight, (0.0,), _on_line),
        *[Rung(turn, (chi,), _on_circle)] * (not is_absent(bank)),
        Rung(plane, (v, gamma, 0.0, h), _in_ground),
        Rung(space, start, observed_states("x", "y", "h")),
    )
    return Ladder("aircraft", POSITION, t, rungs)


_straight = attrgetter("v0")


def _on_line(s, p, t):
    level = s.s * cos(p.gamma0)
    return p.x0 + level * sin(p.chi0), p.y0 + level * cos(p.chi0), p.h0 + s.s * sin(p.gamma0)


def _turning(p):
    """The lift carries the weight, so its level part is m g tan(bank)."""
    return p.g * tan(p.bank) / p.v0


def _on_circle(s, p, t):
    # by the chord, in which nothing cancels for a small bank
    chord = 2 * p.v0 / _turning(p) * sin((s.chi - p.chi0) / 2)
    mean = (s.chi + p.chi0) / 2
    return p.x0 + chord * sin(mean), p.y0 + chord * cos(mean), p.h0


def _in_ground(s, p, t):
    return p.x0 + s.x * sin(p.chi0), p.y0 + s.x * cos(p.chi0), s.y


def _in_plane(s, p, t):
    return *_along_path(s, p, p.lift), s.v * cos(s.gamma), s.v * sin(s.gamma)


def _in_space(s, p, t):
    v, gamma = _along_path(s, p, p.lift * cos(p.bank))
    level = s.v * cos(s.gamma)
    chi = p.lift * sin(p.bank) / (p.m * level)
    return v, chi, gamma, level * sin(s.chi), level * cos(s.chi), s.v * sin(s.gamma)


def _along_path(s, p, lift):
    """(v', gamma') by the forces along the path and the upright component of the lift."""
    return (p.thrust - p.drag) / p.m - p.g * sin(s.gamma), (lift / p.m - p.g * cos(s.gamma)) / s.v


def _parabola(s, p, t):
    level, (y, climb) = s.v * cos(s.gamma), uniform_acceleration(s.y, s.v * sin(s.gamma), -p.g, t)
    return sqrt(level * level + climb * climb), atan2(climb, level), s.x + level * t, y


UNBALANCED = Neglected("that the forces do not balance along the path and upwards", None, POSITION)
BANK = Neglected("the bank", None, POSITION)

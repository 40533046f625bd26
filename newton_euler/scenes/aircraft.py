"""An aircraft as a particle over a ground taken as inertial: in a vertical plane (6.3) and in space (6.12).

Thrust acts along the velocity, drag against it, lift normal to it and, in a coordinated turn, tilted by the *bank* angle to the right. The *path
angle* gamma is upward from the horizontal, the *heading* chi from the y axis toward the x axis (north toward east, if y is north); both in rad.
Each force, and the bank, is a number or a law ``(s, p, t)`` of the states, the parameters and the time.
"""

from typing import NamedTuple

from ..frames import Frame
from ..kinetics import reaction
from ..models import Model, is_law
from ..scalars import atan2, cos, is_zero, moving, plain, scalar, sin, sqrt


def vertical_flight(m, g, thrust=0, drag=0, lift=0):
    """The model of flight in a vertical plane (6.3): states v, gamma, x, y (y up).

    Without thrust and drag the energy v^2/2 + g y is an invariant; without lift as well the parabola is its exact solution.

    >>> vertical_flight(2.0, 9.81, thrust=30.0, drag=10.0, lift=19.62).derivative((50.0, 0.0, 0.0, 100.0))
    (10.0, 0.0, 50.0, 0.0)
    """

    def rhs(s, p, t):
        v, gamma = _along_path(s, p, p.lift)
        return v, gamma, s.v * cos(s.gamma), s.v * sin(s.gamma)

    coasting = _none(thrust) and _none(drag)
    parameters = {"m": m, "g": g, "thrust": thrust, "drag": drag, "lift": lift}
    energy = {"energy over mass": lambda s, p, t: s.v * s.v / 2 + p.g * s.y}
    exact = _parabola if coasting and _none(lift) else None
    return Model("aircraft in a vertical plane", parameters, ("v", "gamma", "x", "y"), rhs, invariants=energy if coasting else {}, exact=exact)


def flight(m, g, thrust=0, drag=0, lift=0, bank=0):
    """The model of flight in space (6.12): states v, chi, gamma, x, y, h (h up). For bank 0 it is that of :func:`vertical_flight`.

    The heading does not exist in vertical flight, gamma = pi/2 or -pi/2.

    >>> turning = flight(2.0, 10.0, lift=25.0, bank=0.6435011087932844)  # sin(bank) is 0.6: a level turn
    >>> [round(x, 9) + 0 for x in turning.derivative((30.0, 0.0, 0.0, 0.0, 0.0, 100.0))]
    [0.0, 0.25, 0.0, 0.0, 30.0, 0.0]
    """

    def rhs(s, p, t):
        v, gamma = _along_path(s, p, p.lift * cos(p.bank))
        chi = p.lift * sin(p.bank) / (p.m * s.v * cos(s.gamma))
        level = s.v * cos(s.gamma)
        return v, chi, gamma, level * sin(s.chi), level * cos(s.chi), s.v * sin(s.gamma)

    parameters = {"m": m, "g": g, "thrust": thrust, "drag": drag, "lift": lift, "bank": bank}
    energy = {"energy over mass": lambda s, p, t: s.v * s.v / 2 + p.g * s.h} if _none(thrust) and _none(drag) else {}
    return Model("aircraft in space", parameters, ("v", "chi", "gamma", "x", "y", "h"), rhs, invariants=energy)


def _along_path(s, p, lift):
    """(v', gamma') by the forces along the path and, of the lift, its part in the vertical plane."""
    return (p.thrust - p.drag) / p.m - p.g * sin(s.gamma), (lift / p.m - p.g * cos(s.gamma)) / s.v


def _none(force):
    return not is_law(force) and is_zero(scalar(force))


def _parabola(s, p, t):
    level, climb = s.v * cos(s.gamma), s.v * sin(s.gamma) - p.g * t
    return sqrt(level * level + climb * climb), atan2(climb, level), s.x + level * t, s.y + (s.v * sin(s.gamma) - p.g * t / 2) * t


class FlightForces(NamedTuple):
    """What a given flight needs: ``excess``, thrust less drag; ``lift``; ``bank`` in rad, positive in a turn to the right."""

    excess: object
    lift: object
    bank: object


def flight_forces(m, g, v, gamma, chi=0):
    """The forces that make this motion: :class:`FlightForces` from the moving speed, path angle and heading (6.12).

    v, gamma, chi : numbers, or moving ones with their first rates

    >>> from newton_euler import moving
    >>> flight_forces(2.0, 9.81, moving(50.0, rate=10.0), 0.0)  # straight and level, gaining speed
    FlightForces(excess=20.0, lift=19.62, bank=0.0)
    """
    north = Frame("ground")  # i along the heading 0, k up
    path = north.rotate("heading", "-z", chi).rotate("path", "-y", gamma)
    force = reaction(m, path.vector(moving(v), 0, 0).rate(north), weight=m * g * -north.k).expressed_in(path)
    excess, left, up = force.c
    return FlightForces(plain(excess), plain(sqrt(left * left + up * up)), atan2(-left, up))

"""A rigid body that swings about a level axis: the physical pendulum (11.17).

m mass, I moment of inertia about the parallel to the axis through G, l distance of G from the axis, theta from the downward vertical.
"""

from ..elliptic import counted, coupled
from ..energy import plane_kinetic_energy, speed_after
from ..models import Model, ModelError
from ..potential import weight_potential
from ..scalars import cos, is_comparable, of_one_kind, scalar, sin, where
from ..work import summed


def physical_pendulum(m, I, l, g):
    """The motion as a Model with the states theta and omega; the energy (11.32), by :func:`pendulum_energy`, is an invariant.

    The exact solution counts theta through all turns. It is that of a start within a few round-offs of the one given, and from there right to a few
    round-offs of t times the rate of the motion: where the pendulum only just reaches the upright, small differences of the start grow.

    >>> swing = physical_pendulum(2.0, 0.5, 0.5, 10.0)
    >>> swing.derivative((1.5707963267948966, 0.0))
    (0.0, -10.0)
    >>> [round(x, 6) for x in swing.solution(10.0, (0.0, 6.5))]  # over the top, several times
    [34.990743, 2.024268]
    """
    parameters = {"m": m, "I": I, "l": l, "g": g}
    return Model("physical pendulum", parameters, ("theta", "omega"), _rates, {"energy": _energy}, _exact)


def _stiffness(p):
    return p.m * p.g * p.l / (p.I + p.m * p.l * p.l)


def _rates(s, p, t):
    return s.omega, -(_stiffness(p) * sin(s.theta))


def _energy(s, p, t):
    return pendulum_energy(p.m, p.I, p.l, p.g, s.theta, s.omega).value


def _exact(s, p, t):
    """cos(theta/2), sin(theta/2) and omega/2 change at rates that are products of the others; with g or l negative, sine and cosine change places."""
    theta, omega, k, t = of_one_kind(s.theta, s.omega, _stiffness(p), t)
    if not all(map(is_comparable, (theta, omega, k, t))):
        raise ModelError("the exact solution of the pendulum needs numbers: its branches compare them; put values in first")
    half, upright = theta / 2, k < 0
    start = cos(half), sin(half)
    x, y = where(upright, start[1], start[0]), where(upright, start[0], start[1])
    one = where(upright, 1, -1)
    gap = abs(k) * (x * x) - (omega / 2) * (omega / 2)
    x, y, rate, phase = coupled((one, -one, one * abs(k)), (x, y, omega / 2), gap, t)
    now = where(upright, y, x), where(upright, x, y)
    turns = where(gap > 0, 0, where(omega < 0, -phase, phase))
    return 2 * counted(half, start, now, turns), 2 * rate


def pendulum_energy(m, I, l, g, theta, omega):
    """T + V = (I + m l^2) omega^2/2 - m g l cos(theta), with the terms ``translation``, ``rotation`` (11.51) and ``weight``, zero at the axis.

    >>> pendulum_energy(2.0, 0.5, 0.5, 10.0, 0.0, 3.0).terms
    {'translation': 2.25, 'rotation': 2.25, 'weight': -10.0}
    """
    T = plane_kinetic_energy(m, scalar(l) * omega, I, omega)
    return summed({**T.terms, "weight": weight_potential(m, -(scalar(l) * cos(theta)), g)}, "energy", "11.32")


def swing_rate(m, I, l, g, theta, theta0, omega0=0):
    """The size of omega at the angle theta, from that at theta0, without cancellation as theta -> theta0.

    :class:`~newton_euler.energy.EnergyError` if it does not swing so far.

    >>> round(swing_rate(2.0, 0.5, 0.5, 10.0, 0.0, 1.5707963267948966), 6)
    4.472136
    """
    drop = 2 * sin((scalar(theta0) + theta) / 2) * sin((scalar(theta0) - theta) / 2)  # cos(theta) - cos(theta0)
    return speed_after(omega0, scalar(m) * g * l * drop, I + scalar(m) * l * l)

"""A rigid body that swings about a level axis: the physical pendulum (11.17).

m mass, I moment of inertia about the parallel to the axis through G, l distance of G from the axis, theta from the downward vertical.
"""

from ..energy import plane_kinetic_energy, speed_after
from ..models import Model
from ..potential import weight_potential
from ..scalars import cos, scalar, sin
from ..work import summed


def physical_pendulum(m, I, l, g):
    """The motion as a Model with the states theta and omega; the energy (11.32), by :func:`pendulum_energy`, is an invariant.

    >>> physical_pendulum(2.0, 0.5, 0.5, 10.0).derivative((1.5707963267948966, 0.0))
    (0.0, -10.0)
    """
    return Model(
        "physical pendulum", {"m": m, "I": I, "l": l, "g": g}, ("theta", "omega"),
        lambda s, p, t: (s.omega, -(p.m * p.g * p.l * sin(s.theta)) / (p.I + p.m * p.l * p.l)),
        invariants={"energy": lambda s, p, t: pendulum_energy(p.m, p.I, p.l, p.g, s.theta, s.omega).value},
    )  # fmt: skip


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

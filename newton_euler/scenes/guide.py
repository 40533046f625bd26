"""A mass that passes the top of a smooth guide in a vertical plane (6.2)."""

from ..kinetics import path_force
from ..scalars import plain


def guide_force(m, v, radius, g):
    """The force of the guide on the mass at the top, positive down, toward the centre of curvature: m (v^2/radius - g), by (6.5).

    Negative where the guide holds the mass up, zero where it would fly along the same curve. The speed v may have any sign.

    >>> round(guide_force(2.0, 4.8, 0.5, 9.81), 2)
    72.54
    """
    _, F_n = path_force(m, v, 0, 1 / radius)
    return plain(F_n - m * g)

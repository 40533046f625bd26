"""The symmetric top with a fixed point under gravity (10.5, 10.6) as models of three kinds, and the free symmetric body (10.8).

All take I0, I, ``mgr`` and angles as in :mod:`newton_euler.gyros`; ``omega_z``, the whole rate about the axis, is constant and so a parameter. Which one:
:func:`reduced` for the nutation alone, :func:`rolled_out` where the axis comes near the vertical, :func:`euler` where the angles psi and phi are wanted.
"""

from ..models import Model
from ..rotations import matrix_from_quaternion, quaternion, quaternion_product, quaternion_rate
from ..scalars import cos, sin, sqrt, tan
from ..vectors import dot3


def surplus(I0, I, theta, precession, omega_z):
    """p_psi - p_phi, the constant by which the angular momentum about the vertical exceeds that about the axis, I omega_z.

    It is I0 psi' sin^2(theta) - I omega_z (1 - cos(theta)), and zero for a top that can pass through the upright position.

    >>> surplus(0.02, 0.01, 0.0, 3.0, 100.0)
    0.0
    """
    return I0 * precession * sin(theta) ** 2 - 2 * I * omega_z * sin(theta / 2) ** 2


def precession_rate(I0, I, theta, omega_z, surplus):
    """psi' at the angle theta, from the constants: (p_psi - p_phi cos(theta))/(I0 sin^2(theta)).

    It has a limit as theta goes to 0 if ``surplus`` is 0, and keeps it if that is given as the integer 0.

    >>> precession_rate(0.02, 0.01, 0.0, 100.0, 0)
    25.0
    """
    both = 2 * I * omega_z + surplus
    there = both / (4 * I0 * cos(theta / 2) ** 2)
    return there + surplus / (4 * I0 * sin(theta / 2) ** 2) if surplus is not 0 else there

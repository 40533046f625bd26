"""Tools for ``prove``: explicit motions differentiated, integrals, roots and sums over mass points,
at 50 digits.

Nothing here comes from the engine. A proof differentiates the position of a point as a function of
time, with rotation matrices multiplied out, or sums over the mass points of a body. It uses no
Coriolis term, no law of composition and no table of inertia, so it agrees with ``solve`` only if
both are right. Vectors are lists of three mpmath numbers, matrices lists of rows.
"""

from .digits import DIGITS, ProofError
from .flow import after, until
from .freedom import freedom
from .gradients import gradient
from .integrals import integral
from .local_axes import cylindrical_axes, elevation, spherical_axes
from .mass_points import along_x, ball, box, cone, disk, mean, raised, ring, shell
from .motions import angular_acceleration, angular_velocity, rate, second_rate, spun
from .moved import angular_momentum, carried, force_needed, kinetic_energy, let_go, moment_needed
from .roots import root, vanishing
from .tracks import speed_along
from .vectors import at_angle, cross, minus, plus, rot, scaled, size, times, transposed

__all__ = [
    "DIGITS", "ProofError", "after", "along_x", "angular_acceleration", "angular_momentum",
    "angular_velocity", "at_angle", "ball", "box", "carried", "cone", "cross", "cylindrical_axes",
    "disk", "elevation", "force_needed", "freedom", "gradient", "integral", "kinetic_energy",
    "let_go", "mean", "minus", "moment_needed", "plus", "raised", "rate", "ring", "root", "rot",
    "scaled", "second_rate", "shell", "size", "speed_along", "spherical_axes", "spun", "times",
    "transposed", "until", "vanishing",
]  # fmt: skip

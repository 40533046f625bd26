"""Forces, constraints, Newton's and Euler's equations, work and energy (chapters 5, 6, 8, 11)."""

from ..algebra.names import guide as _guide
from .constraints import ConstraintError, degrees_of_freedom
from .energy import (
    Audit,
    EnergyError,
    audit,
    gyroscope_energy,
    kinetic_energy,
    kinetic_energy_about,
    kinetic_energy_rate,
    plane_kinetic_energy,
    rigid_power,
    speed_after,
)
from .euler import (
    angular_acceleration,
    euler_moment,
    euler_moments,
    fixed_line_moment,
    fixed_line_momentum,
    planar_moment,
)
from .force_systems import Couple, Force, ForceError, ForceSystem
from .gravity import (
    attraction,
    gravitation,
    gravitational_field,
    gravity_at_height,
    gravity_at_surface,
    mass_from_weight,
    weight,
)
from .momentum import angular_momentum, equations_of_motion, resultant_moment
from .newton import (
    acceleration_by,
    coordinate_accelerations,
    path_force,
    path_rates,
    reaction,
    relative_acceleration,
    resultant_force,
)
from .potential import (
    NoPotential,
    Potential,
    conservative_force,
    curl,
    find_potential,
    gravitational_potential,
    jacobian,
    spring_between,
    spring_potential,
    weight_potential,
)
from .work import constant_force_work, pair_power, power, work_along, work_in_time, work_integral

_guide(__name__)

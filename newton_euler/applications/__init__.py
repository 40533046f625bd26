"""The Earth as a frame, rotors, gyroscopes (chapters 6, 9, 10)."""

from ..algebra.names import guide as _guide
from .earth import (
    EARTH_GM,
    EARTH_RADIUS,
    EARTH_RATE,
    EarthError,
    apparent_acceleration,
    buoyancy,
    coriolis_acceleration,
    coriolis_parameter,
    earth_frame,
    earth_rate,
    effective_gravity,
    flight_time,
    force_near_earth,
    gradient_wind,
    ground_acceleration,
    ground_frame,
    launch_velocity,
    projectile,
    projectile_position,
    projectile_to_order,
    projectile_velocity,
    range_east,
    range_error,
    shot_range,
    support_force,
    wind_acceleration,
)
from .gyroscopes import (
    GyroError,
    fast_spin,
    free_precession,
    gyro_moment,
    gyro_momentum,
    instantaneous_axis,
    least_spin,
    normal_moment,
    nutation_stiffness,
    sleeping_top,
    steady_moment,
    steady_precession,
    steady_spin,
)
from .rotors import (
    RotorError,
    balance,
    balancing_masses,
    corrections,
    imbalance,
    reactions,
    shaft_axis,
)

_guide(__name__)

"""Newton-Euler dynamics of particles and rigid bodies in three dimensions: a small engine for teaching and for work.

>>> from newton_euler import Frame
>>> ground = Frame("ground")
>>> shaft = ground.rotate("shaft", "z", rate=0.6)
>>> print(shaft.point("P", 2.0, 0, 0).acceleration(ground))
[-0.72, 0, 0] in shaft
"""

from .components import (
    T_phi,
    T_theta,
    T_theta_phi,
    cylindrical,
    cylindrical_coordinates,
    cylindrical_frame,
    polar,
    polar_coordinates,
    spherical,
    spherical_coordinates,
    spherical_frame,
)
from .constraints import ConstraintError, degrees_of_freedom
from .coordinates import curvilinear, curvilinear_rates, gradient
from .earth import (
    EARTH_GM,
    EARTH_ORBIT_RADIUS,
    EARTH_ORBIT_RATE,
    EARTH_RADIUS,
    EARTH_RATE,
    EarthError,
    apparent_acceleration,
    buoyancy,
    coriolis_acceleration,
    coriolis_parameter,
    drop_deflection,
    earth_frame,
    earth_rate,
    effective_gravity,
    flight_time,
    force_near_earth,
    geostrophic_wind,
    gradient_wind,
    ground_acceleration,
    ground_frame,
    inertial_circle,
    launch_velocity,
    projectile,
    projectile_position,
    projectile_to_order,
    projectile_velocity,
    range_east,
    range_error,
    rotation_error,
    shot_range,
    support_force,
    weightless_speed,
    wind_acceleration,
)
from .forces import attraction, gravitation, gravitational_field, gravity_at_height, gravity_at_surface, mass_from_weight, weight
from .frames import Frame, Point, solve_rates
from .inertia import Inertia, MassError
from .integration import integrated
from .kinetics import (
    acceleration_by,
    coordinate_accelerations,
    path_force,
    path_rates,
    reaction,
    relative_acceleration,
    resultant_force,
)
from .mass import Body, centre_of_mass, composite, particle
from .models import Model, ModelError, Neglected, second_order, smallest
from .paths import Frenet, along, at_speed, flexure, frenet, frenet_along, speed_rate
from .rectilinear import from_place, from_speed, from_time, integral
from .scalars import (
    ZERO,
    Dimension,
    DimensionError,
    ScalarError,
    acos,
    asin,
    at,
    atan,
    atan2,
    cos,
    cosh,
    exp,
    log,
    moving,
    pi,
    radians,
    sin,
    sinh,
    sqrt,
    tan,
    tanh,
)
from .tracing import compiled
from .triads import SingularError, Triad
from .vectors import Explanation, FrameError, Vector, cross, dot, same

__version__ = "0.1.0"

__all__ = [name for name in dir() if not name.startswith("_") and not hasattr(globals()[name], "__spec__")]  # modules have a spec

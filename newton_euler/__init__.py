"""Newton-Euler dynamics of particles and rigid bodies in three dimensions: a small engine for teaching and for work.

>>> from newton_euler import Frame
>>> ground = Frame("ground")
>>> shaft = ground.rotate("shaft", "z", rate=0.6)
>>> print(shaft.point("P", 2.0, 0, 0).acceleration(ground))
[-0.72, 0, 0] in shaft

A name is imported from its room when it is first asked for, so that ``import newton_euler`` costs next to nothing.
"""

from importlib import import_module

__version__ = "0.1.0"

# room: the names that it gives to the public, in the order of the book
ROOMS = {
    "algebra.errors": "NewtonEulerError",
    "algebra.scalars": """ZERO ScalarError SingularError acos asin atan atan2 cos cosh exp log pi radians sin sinh sqrt tan tanh where""",
    "algebra.jets": "at moving",
    "algebra.codegen.compiled": "compiled",
    "algebra.units": "Dimension DimensionError UnitError unit",
    "algebra.vectors": "FrameError Vector cross dot same",
    "algebra.quadrature": "WorkError",
    "algebra.ledger": "Amount Explanation TermError",
    "kinematics.triads": "Triad",
    "kinematics.rectilinear": "from_place from_speed from_time",
    "kinematics.paths": "Frenet along at_speed flexure frenet frenet_along speed_rate",
    "kinematics.coordinates": """T_phi T_theta T_theta_phi cylindrical cylindrical_coordinates cylindrical_frame polar polar_coordinates
        spherical spherical_coordinates spherical_frame""",
    "kinematics.curvilinear": "curvilinear curvilinear_rates gradient",
    "kinematics.frames": "Frame Point",
    "algebra.linear": "LinearError solve_linear solve_rates",
    "kinematics.rotations": """RotationError axis_angle direction_cosines euler_angles euler_body_rates euler_frame euler_from_quaternion
        euler_matrix euler_rates in_sequence matrix_from_quaternion normalised quaternion quaternion_from_euler quaternion_from_matrix
        quaternion_product quaternion_rate rotation_matrix unwound""",
    "bodies.admissibility": "MassError",
    "bodies.inertia": "Inertia",
    "bodies.body": "Body centre_of_mass composite particle",
    "bodies.principal_axes": "Principal Symmetry",
    "bodies.parametric": "integrated",
    "dynamics.gravitation": "attraction gravitation gravitational_field gravity_at_height gravity_at_surface mass_from_weight weight",
    "dynamics.constraints": "ConstraintError degrees_of_freedom",
    "dynamics.newton": "acceleration_by coordinate_accelerations path_force path_rates reaction relative_acceleration resultant_force",
    "motion.model": "Model ModelError Neglected second_order",
    "scenes.ladders": "Ladder Rung smallest",
    "scenes": "ladder",
    "motion.integration": "integrate prepare",
    "motion.events": "Event",
    "motion.solution": "Motion MotionError",
    "applications.earth": """EARTH_GM EARTH_ORBIT_RADIUS EARTH_ORBIT_RATE EARTH_RADIUS EARTH_RATE EarthError apparent_acceleration buoyancy coriolis_acceleration
        coriolis_parameter drop_deflection earth_frame earth_rate effective_gravity flight_time force_near_earth geostrophic_wind gradient_wind
        ground_acceleration ground_frame inertial_circle launch_velocity projectile projectile_position projectile_to_order projectile_velocity
        range_east range_error rotation_error shot_range support_force weightless_speed wind_acceleration""",
    "dynamics.angular_momentum": "angular_momentum equations_of_motion resultant_moment",
    "dynamics.euler": "angular_acceleration euler_moment euler_moments fixed_line_moment fixed_line_momentum planar_moment",
    "dynamics.force_systems": "Couple Force ForceError ForceSystem Wrench",
    "applications.rotors": "RotorError balance balancing_masses corrections imbalance reactions shaft_axis",
    "applications.gyroscopes": """GyroError fast_spin free_precession gyro_moment gyro_momentum instantaneous_axis least_spin normal_moment nutation_stiffness
        sleeping_top steady_moment steady_precession steady_spin""",
    "dynamics.work": "Amount constant_force_work pair_power power work_along work_in_time work_integral",
    "dynamics.potential": """NoPotential Potential conservative_force curl find_potential gravitational_potential jacobian spring_between
        spring_potential weight_potential""",
    "dynamics.energy": """Audit EnergyError audit gyroscope_energy kinetic_energy kinetic_energy_about kinetic_energy_rate plane_kinetic_energy
        rigid_power speed_after""",
}
_ROOM_OF = {name: room for room, names in ROOMS.items() for name in names.split()}
__all__ = sorted(_ROOM_OF)


def __getattr__(name):
    room = _ROOM_OF.get(name)
    if room is None:
        raise AttributeError(f"module 'newton_euler' has no attribute {name!r}")
    value = globals()[name] = getattr(import_module(f"{__name__}.{room}"), name)
    return value


def __dir__():
    return sorted({*globals(), *__all__, *ROOMS})

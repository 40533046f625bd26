"""Frames and points, rotations, coordinates, paths (chapters 2 to 4 and 10)."""

from ..algebra.names import guide as _guide
from .coordinates import (
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
from .curvilinear_systems import curvilinear, gradient
from .frames import AngleWarning, Frame, Point
from .paths import Frenet, along, at_speed, flexure, frenet, frenet_along, speed_rate
from .rectilinear import from_speed, from_time
from .rotations import (
    RotationError,
    apply,
    axis_angle,
    determinant,
    direction_cosines,
    euler_angles,
    euler_body_rates,
    euler_frame,
    euler_from_quaternion,
    euler_matrix,
    euler_rates,
    in_sequence,
    matrix_from_quaternion,
    normalised,
    product,
    quaternion,
    quaternion_from_euler,
    quaternion_from_matrix,
    quaternion_product,
    quaternion_rate,
    rotation_matrix,
    transpose,
)
from .triads import Triad

_guide(__name__)

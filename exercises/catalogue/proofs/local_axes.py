"""Unit vectors at a place, as rows: ``times(axes, v)`` are the components of v along them."""

from collections.abc import Sequence

from mpmath import mp

from .digits import Matrix, Number
from .vectors import cross, scaled, size


def elevation(r: Sequence[Number]) -> Number:
    """The angle of r above the x, y plane."""
    return mp.atan2(r[2], mp.hypot(r[0], r[1]))


def cylindrical_axes(r: Sequence[Number]) -> Matrix:
    """e_r, e_theta, k at the place r: away from the z axis, about it, along it."""
    e_r = scaled(1 / mp.hypot(r[0], r[1]), [r[0], r[1], 0])
    k = [0, 0, mp.mpf(1)]
    return [e_r, cross(k, e_r), k]


def spherical_axes(r: Sequence[Number]) -> Matrix:
    """e_R, e_theta, e_phi at the place r: away from the origin, about the z axis, upward."""
    e_R, e_theta = scaled(1 / size(r), r), cylindrical_axes(r)[1]
    return [e_R, e_theta, cross(e_R, e_theta)]

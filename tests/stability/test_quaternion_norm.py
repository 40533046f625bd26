"""The norm of a quaternion drifts under explicit integration; a matrix that divides by it is a
rotation all the same (10.2).
"""

import math

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from newton_euler.kinematics.rotations import (
    RotationError,
    checked_rotation,
    determinant,
    matrix_from_quaternion,
    normalised,
    product,
    quaternion_rate,
    transpose,
)
from newton_euler.scenes.spatial import top
from tests.kinds import close

OMEGA = (0.3, 4.0, 8.0)  # rad/s in the body, about 9 in size
UNIT = ((1, 0, 0), (0, 1, 0), (0, 0, 1))


def textbook(q):
    """The matrix formula for unit quaternions."""
    w, x, y, z = q
    return np.array([
        [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
        [2 * (x * y + w * z), 1 - 2 * (z * z + x * x), 2 * (y * z - w * x)],
        [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
    ])  # fmt: skip


def test_solve_ivp_changes_it_by_half_a_percent_and_the_printed_matrix_is_no_rotation_any_more():
    rates = lambda t, q: np.array(quaternion_rate(q.tolist(), OMEGA))
    q = solve_ivp(rates, (0, 100), [1.0, 0, 0, 0]).y[:, -1]
    assert abs(np.linalg.norm(q) - 1) > 4e-3
    with pytest.raises(RotationError, match=r"R\^T R differs from the unit matrix"):
        checked_rotation(textbook(q))


@pytest.mark.parametrize("size", [1.0, 0.999, 1.086, 1e-100, 1e100, 3.0])
def test_from_a_quaternion_of_any_length_the_engine_makes_a_rotation_to_5_round_offs(size):
    q = tuple(size * x for x in (0.8, 0.36, -0.288, 0.384))
    R = matrix_from_quaternion(q)
    assert close(product(transpose(R), R), UNIT, 1e-15)
    assert close(determinant(R), 1, 1e-15)
    assert close(R, matrix_from_quaternion((0.8, 0.36, -0.288, 0.384)), 1e-15)
    assert close(np.linalg.norm(normalised(q)), 1, 3e-16)


def test_the_moment_of_gravity_does_not_grow_with_the_length_of_the_quaternion():
    model = top.nonspinning_frame(1.5, 1.0, 5.0, 8.0)
    unit = math.cos(0.3), math.sin(0.3), 0.0, 0.0
    short, long = (model.derivative((*(x * q for q in unit), 0.1, 0.2)) for x in (1, 1.086))
    assert close(long[4:], short[4:], 1e-14)  # rad/s^2

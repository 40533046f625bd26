"""Euler angles at theta = 0 and pi, where the axes of precession and spin coincide (10.5), (10.12)."""

import math

import mpmath
import numpy as np
import pytest

from newton_euler.kinematics.rotations import (
    RotationError,
    euler_from_quaternion,
    euler_matrix,
    euler_rates,
    matrix_from_quaternion,
)
from newton_euler.motion.model import ModelError
from newton_euler.scenes.spatial import top
from tests.kinds import close
from tests.stability.naive import TIGHT, solved

# W: transverse angular velocity at the closest approach to the vertical, rad/s
I0, I, OMEGA_Z, W = 1.5, 1.0, 2.0, 0.7


def passage(eps):
    """States of the free symmetric body 1 s before and 1 s after its axis passes the vertical at
    the angle ``eps``.
    """
    body = top.free(I0, I, OMEGA_Z)
    closest = (math.cos(eps / 2), math.sin(eps / 2), 0.0, 0.0, 0.0, W)
    return body.solution(-1.0, closest), body.solution(1.0, closest)


def axis_of(state):
    return np.array(matrix_from_quaternion(state[:4]))[:, 2]


def run(model, start):
    found = solved(model, 2.0, start, **TIGHT)
    return found.y[:, -1], found.nfev


def in_euler_angles(start):
    psi, theta, phi = euler_from_quaternion(start[:4])
    psi_rate, theta_rate, _ = euler_rates(psi, theta, phi, (start[4], start[5], OMEGA_Z))
    y, calls = run(top.euler(I0, I, 0.0, OMEGA_Z), (psi, theta, phi, psi_rate, theta_rate))
    return np.array(euler_matrix(*y[:3]))[:, 2], calls


def test_integration_in_euler_angles_costs_seven_times_more_as_the_axis_passes_the_vertical_at_1e_minus_8_rad():
    calls = []
    for eps in (1e-1, 1e-4, 1e-8):
        start, end = passage(eps)
        axis, n = in_euler_angles(start)
        # DOP853 at 1e-10 pays with steps, not with digits
        assert np.linalg.norm(axis - axis_of(end)) < 1e-9
        calls.append(n)
    assert calls[1] > 3 * calls[0]
    assert calls[2] > 6 * calls[0]


@pytest.mark.parametrize("eps", [1e-1, 1e-4, 1e-8, 0.0])
def test_the_frame_that_does_not_spin_passes_the_vertical_with_the_same_steps_to_1e_minus_9_rad(
    eps,
):
    start, end = passage(eps)
    y, calls = run(top.nonspinning_frame(I0, I, 0.0, OMEGA_Z), start)
    assert np.linalg.norm(axis_of(y) - axis_of(end)) < 1e-9
    assert calls < 200


def test_the_exact_motion_through_the_vertical_is_right_to_1e_minus_15():
    closest = (1.0, 0.0, 0.0, 0.0, 0.0, W)
    body = top.free(I0, I, OMEGA_Z)
    assert close(
        body.solution(1.0, closest),
        body.solution(mpmath.mpf(1), tuple(map(mpmath.mpf, closest))),
        1e-15,
    )


def test_the_printed_rates_divide_by_zero_where_the_engine_refuses_in_words():
    with np.errstate(divide="ignore"):
        # psi' = (w_x sin phi + w_y cos phi)/sin theta
        assert np.isinf(np.float64(1.0) / np.sin(np.float64(0.0)))
    for theta in (0.0, math.pi):
        with pytest.raises(RotationError, match="axes of precession and spin coincide"):
            euler_rates(0.3, theta, 0.1, (0.0, 1.0, 2.0))
    with pytest.raises(ModelError, match="coordinates are singular"):
        top.euler(I0, I, 0.0, OMEGA_Z).derivative((0.0, 0.0, 0.0, 1.0, 1.0))

"""Euler angles at theta = 0 and pi, where the axes of precession and spin coincide (10.5), (10.12)."""

import math

import numpy as np
import pytest

from newton_euler.kinematics.rotations import matrix_from_quaternion
from newton_euler.scenes.spatial import top
from tests.stability.naive import TIGHT, solved

# W: transverse angular velocity at the closest approach to the vertical, rad/s
I0, I, OMEGA_Z, W = 1.5, 1.0, 2.0, 0.7


def passage(eps):
    """States 1 s before and 1 s after the axis passes the vertical at the angle ``eps``."""
    body = top.free(I0, I, OMEGA_Z)
    closest = (math.cos(eps / 2), math.sin(eps / 2), 0.0, 0.0, 0.0, W)
    return body.solution(-1.0, closest), body.solution(1.0, closest)


def axis_of(state):
    return np.array(matrix_from_quaternion(state[:4]))[:, 2]


@pytest.mark.parametrize("eps", [1e-1, 1e-4, 1e-8, 0.0])
def test_the_frame_without_spin_passes_the_vertical_with_the_same_steps_to_1e_minus_9_rad(eps):
    start, end = passage(eps)
    found = solved(top.nonspinning_frame(I0, I, 0.0, OMEGA_Z), 2.0, start, **TIGHT)
    assert np.linalg.norm(axis_of(found.y[:, -1]) - axis_of(end)) < 1e-9
    assert found.nfev < 200  # Euler's angles take seven times as many beside the vertical

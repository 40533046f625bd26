"""Angles that count turns: after 1e9 of them a float resolves 1e-6 rad, and a slow precession
stands still; an attitude does not count turns (10.36).
"""

import math

import mpmath
import pytest

from newton_euler.kinematics.rotations import apply, matrix_from_quaternion
from newton_euler.motion.integration import integrate
from newton_euler.scenes.spatial import top
from tests.turning import cross

I0, I, MGR, OMEGA_Z = 1.5, 1.0, 5.0, 8.0
TURNS = 2 * math.pi * 1e9  # rad
TILTED = (math.cos(0.3), math.sin(0.3), 0.0, 0.0)  # theta = 0.6


def axis(state):
    """The axis of the body, along the ground's axes, from the quaternion."""
    return apply(matrix_from_quaternion(tuple(state)[:4]), (0, 0, 1))


def apart(a, b):
    return max(abs(float(x - y)) for x, y in zip(a, b, strict=True))


def test_integrated_from_1e9_turns_on_the_angles_lose_six_digits_and_the_quaternion_none():
    """A nutating top for 1 s: by Euler angles that have counted turns, and by a quaternion."""
    angles, rolling = (f(I0, I, MGR, OMEGA_Z) for f in (top.euler, top.nonspinning_frame))
    end = lambda model, *start: integrate(model, 1.0, start, 1e-12, "dop853").end
    fresh, counted = (end(angles, x, 0.6, x, 0.0, 0.0) for x in (0.0, TURNS))
    assert abs((counted["psi"] - TURNS) - fresh["psi"]) > 1e-8
    assert abs((counted["phi"] - TURNS) - fresh["phi"]) > 1e-8
    theta, psi = fresh["theta"], fresh["psi"]
    expected = math.sin(theta) * math.sin(psi), -math.sin(theta) * math.cos(psi), math.cos(theta)
    assert apart(axis(end(rolling, *TILTED, 0.0, 0.0).values()), expected) < 1e-11


@pytest.mark.parametrize("turns", [1e3, 1e6, 1e9])
def test_the_exact_attitude_is_right_to_a_round_off_of_the_turns_and_in_30_digits_to_1e_minus_29(
    turns,
):
    start, t = (*TILTED, 0.0, 2.0), 2 * math.pi * turns / math.hypot(2.0, I * OMEGA_Z / I0)
    exact = carried_around(start, t)
    assert apart(axis(top.free(I0, I, OMEGA_Z).solution(t, start)), exact) < 2e-15 * turns
    with mpmath.workdps(30):
        body = top.free(*map(mpmath.mpf, (I0, I, OMEGA_Z)))
        precise = body.solution(mpmath.mpf(t), tuple(map(mpmath.mpf, start)))
        assert apart(axis(precise), exact) < 1e-29 * turns


def carried_around(start, t):
    """In 60 digits (Rodrigues): the axis goes around the constant momentum H at the rate H/I0."""
    with mpmath.workdps(60):
        start = tuple(map(mpmath.mpf, start))
        k, H = mpmath.matrix(axis(start)), mpmath.matrix(axis_of_momentum(start))
        e, angle = H / mpmath.norm(H), mpmath.norm(H) / I0 * mpmath.mpf(t)
        c, s = mpmath.cos(angle), mpmath.sin(angle)
        return tuple(c * k + s * cross(e, k) + (1 - c) * (e.T * k)[0] * e)


def axis_of_momentum(state):
    """H along the ground's axes."""
    *q, w_x, w_y = state
    return apply(matrix_from_quaternion(tuple(q)), (I0 * w_x, I0 * w_y, I * OMEGA_Z))

"""Angles that count turns: after 1e9 of them a float resolves 1e-6 rad, and a slow precession
stands still; an attitude forgets the turns (10.36).
"""

import math

import mpmath
import pytest

from newton_euler.kinematics.rotations import apply, matrix_from_quaternion
from newton_euler.motion.integration import integrate
from newton_euler.scenes.spatial import top

I0, I, MGR, OMEGA_Z = 1.5, 1.0, 5.0, 8.0
TURNS = 2 * math.pi * 1e9  # rad
TILTED = (math.cos(0.3), math.sin(0.3), 0.0, 0.0)  # theta = 0.6


def axis(state):
    """The axis of the body, along the ground's axes, from the quaternion."""
    return apply(matrix_from_quaternion(tuple(state)[:4]), (0, 0, 1))


def apart(a, b):
    return max(abs(float(x - y)) for x, y in zip(a, b, strict=True))


def test_a_precession_added_in_small_steps_to_a_large_angle_does_not_go_on_at_all():
    psi, step = TURNS, 1e-3 * 1e-4  # rad: 1e-3 rad/s in steps of 0.1 ms
    for _ in range(10_000):
        psi += step
    assert psi == TURNS  # not TURNS + 1e-3


@pytest.mark.parametrize("turns", [1e6, 1e9, 1e12])
def test_the_cosine_of_a_large_angle_knows_it_to_its_last_place_only(turns):
    # 1e-8 and more after 1e9 turns
    assert abs(math.cos(2 * math.pi * turns + 0.1) - math.cos(0.1)) > 1e-17 * turns


def test_integrated_from_1e9_turns_on_the_angles_lose_six_digits_and_the_quaternion_none():
    """One second of a nutating top: by Euler's angles with psi and phi counted from before, and by
    the frame that does not spin.
    """
    start = (0.0, 0.6, 0.0, 0.0, 0.0)
    angles = top.euler(I0, I, MGR, OMEGA_Z)
    fresh = integrate(angles, 1.0, start, 1e-12, "dop853").end
    counted = integrate(angles, 1.0, (TURNS, 0.6, TURNS, 0.0, 0.0), 1e-12, "dop853").end
    assert abs((counted["psi"] - TURNS) - fresh["psi"]) > 1e-8
    assert abs((counted["phi"] - TURNS) - fresh["phi"]) > 1e-8
    rolled = integrate(
        top.nonspinning_frame(I0, I, MGR, OMEGA_Z), 1.0, (*TILTED, 0.0, 0.0), 1e-12, "dop853"
    ).end
    theta, psi = fresh["theta"], fresh["psi"]
    expected = math.sin(theta) * math.sin(psi), -math.sin(theta) * math.cos(psi), math.cos(theta)
    assert apart(axis(rolled.values()), expected) < 1e-11


@pytest.mark.parametrize("turns", [1e3, 1e6, 1e9])
def test_the_exact_attitude_of_a_free_body_is_right_to_a_round_off_of_the_turns_and_in_30_digits_to_1e_minus_29_of_them(
    turns,
):
    start = (*TILTED, 0.0, 2.0)
    t = 2 * math.pi * turns / math.hypot(2.0, I * OMEGA_Z / I0)
    exact = carried_around(start, t)
    assert apart(axis(top.free(I0, I, OMEGA_Z).solution(t, start)), exact) < 2e-15 * turns
    with mpmath.workdps(30):
        body = top.free(*map(mpmath.mpf, (I0, I, OMEGA_Z)))
        assert (
            apart(axis(body.solution(mpmath.mpf(t), tuple(map(mpmath.mpf, start)))), exact)
            < 1e-29 * turns
        )


def carried_around(start, t):
    """The axis at the time t, in 60 digits: the momentum H is constant, and the axis goes around it
    at the rate H/I0 (Rodrigues).
    """
    with mpmath.workdps(60):
        start = tuple(map(mpmath.mpf, start))
        k, H = mpmath.matrix(axis(start)), mpmath.matrix(axis_of_momentum(start))
        size = mpmath.norm(H)
        e, angle = H / size, size / I0 * mpmath.mpf(t)
        across = mpmath.matrix(
            [e[1] * k[2] - e[2] * k[1], e[2] * k[0] - e[0] * k[2], e[0] * k[1] - e[1] * k[0]]
        )
        along = (e.T * k)[0]
        return tuple(
            mpmath.cos(angle) * k + mpmath.sin(angle) * across + (1 - mpmath.cos(angle)) * along * e
        )


def test_the_body_comes_back_after_1e9_turns_to_a_millionth_of_a_radian():
    """The period is rounded to a float before it is multiplied: 1e9 turns make 1e-7 rad and more of
    that.
    """
    body, start = top.free(I0, I, OMEGA_Z), (*TILTED, 0.0, 2.0)
    H = axis_of_momentum(start)
    rate = math.sqrt(sum(x * x for x in H)) / I0
    end = body.solution(2 * math.pi / rate * 1e9, start)
    assert apart(axis(end), axis(start)) < 5e-6
    kept = axis_of_momentum(end)
    # what does not turn keeps its digits
    assert apart(H, kept) < 5e-15 * math.sqrt(sum(x * x for x in H))


def axis_of_momentum(state):
    """H along the ground's axes."""
    *q, w_x, w_y = state
    return apply(matrix_from_quaternion(tuple(q)), (I0 * w_x, I0 * w_y, I * OMEGA_Z))

"""Worked examples of chapter 10: the spherical pendulum, the top, the gyrocompass."""

import pytest

from newton_euler import cos, moving, sin
from newton_euler.chapters.examples import ch10
from newton_euler.kinematics.rotations import quaternion_from_euler
from newton_euler.scenes.spatial import top
from newton_euler.scenes.spatial.gyrocompass import gyrocompass
from tests.explicit import by_scipy
from tests.kinds import close, every_kind, numbers, small

MOTION = ("0.4", "1.2", "-0.7"), ("0.9", "0.5", "0.3"), ("1.3", "2.5", "0.8")  # psi, theta, phi


@every_kind
def test_eqn_10_11_to_10_16_angular_momentum_of_the_spherical_pendulum(kind):
    m, L = numbers(kind, 3, 2)
    angles = [numbers(kind, *v) for v in MOTION]
    H, bar = ch10.spherical_pendulum_momentum(m, L, *(moving(*v) for v in angles))
    (_, dpsi, _), (theta, dtheta, _), (phi, dphi, _) = angles
    factor = m * L * L / 3
    x = dtheta * cos(phi) + dpsi * sin(theta) * sin(phi)
    y = -dtheta * sin(phi) + dpsi * sin(theta) * cos(phi)
    omega = x, y, dphi + dpsi * cos(theta)
    assert close(bar.angular_velocity(bar.parent.parent.parent), omega, small(kind, 0.1))
    assert close(H.components(bar), (factor * x, factor * y, 0), small(kind))
    # in the frame that does not spin
    assert close(H, (factor * dtheta, factor * dpsi * sin(theta), 0), small(kind))


def test_section_10_11_the_gyrocompass_swings_about_north_with_its_period():
    data = (0.002, 0.003, 1000.0, 7.292e-5, 0.8)
    period = ch10.compass_period(*data)
    azimuth, rate = by_scipy(gyrocompass(*data), (1e-4, 0.0), period, rtol=1e-11).y[:, -1]
    assert azimuth == pytest.approx(1e-4, rel=1e-6)
    assert rate == pytest.approx(0, abs=1e-9)


def test_eqn_10_24_the_precession_of_a_top_from_its_constants():
    difference = top.momentum_difference(0.6, 0.25, 0.9, 1.2, 9.0)
    assert ch10.precession_rate(0.6, 0.25, 0.9, 9.0, difference) == pytest.approx(1.2, rel=1e-14)


def test_the_spin_turns_the_frame_that_does_not_spin_into_the_body():
    state = (*quaternion_from_euler(0.3, 0.8, 0.0), 0.0, 0.0)
    assert ch10.body_quaternion(state, 0.5) == pytest.approx(quaternion_from_euler(0.3, 0.8, 0.5))

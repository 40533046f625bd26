"""Angles across +-pi: unwrapping fails for steps of more than half a turn; an angle that is a state
of the motion is followed through all turns.
"""

import math

import numpy as np

from newton_euler import Model, integrate
from newton_euler.scenes.spatial import top


def unwrapped(angle):
    """An angle read from sines and cosines at some instants, unwrapped."""
    return np.unwrap(np.arctan2(np.sin(angle), np.cos(angle)))


def test_unwrap_takes_a_turn_of_10_rad_per_sample_for_minus_2_6():
    angle = 10.0 * np.arange(0.0, 20.0)
    assert abs(np.diff(unwrapped(angle))[0] - (10 - 4 * math.pi)) < 1e-12  # -2.57 rad


def test_a_spin_that_speeds_up_is_followed_over_thousands_of_turns_in_100_samples():
    t = np.linspace(0.0, 10.0, 101)
    angle = 50 * t + 40 * t**2
    spin = Model("spin", {}, ("angle", "rate"), lambda s, p, t: (s.rate, 80.0))
    found = integrate(spin, 10.0, (0.0, 50.0), 1e-12, samples=t).states["angle"]
    assert np.max(np.abs(unwrapped(angle) - angle)) > 1000
    assert np.max(np.abs(found - angle)) < 1e-9


def test_the_precession_of_a_top_through_many_turns_is_that_of_its_steady_rate():
    # I omega_z/(I0 cos(theta)) without a moment (10.35), at 1 rad from the vertical
    I0, I, omega_z, theta, end = 1.5, 1.0, 20.0, 1.0, 100.0
    rate = I * omega_z / (I0 * math.cos(theta))
    start = (0.0, theta, 0.0, rate, 0.0)
    psi = integrate(top.euler(I0, I, 0.0, omega_z), end, start, 1e-10, samples=20).states["psi"]
    exact = rate * np.linspace(0.0, end, 20)
    assert np.max(np.abs(unwrapped(exact) - exact)) > 1000
    assert np.max(np.abs(psi - exact)) < 1e-6

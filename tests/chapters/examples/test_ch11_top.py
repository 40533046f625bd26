"""The energy of a top (11.16)."""

import math

import numpy as np

from newton_euler import Body, Frame, euler_frame, kinetic_energy, moving
from newton_euler.chapters.examples.ch11 import top_energy
from newton_euler.scenes.spatial.top import euler
from tests.explicit import integrated
from tests.kinds import close, every_kind, numbers, small


@every_kind
def test_example_11_16_energy_of_the_top_by_a_body_in_frames(kind):
    I0, I, mgr, theta, nod, precession, spin = numbers(kind, "1.5", 1, 10, "0.8", "0.4", 2, 9)
    ground = Frame("ground")
    turning = moving(theta, precession), moving(theta, nod), moving(theta, spin)
    frame = euler_frame(ground, "top", *turning)
    T = kinetic_energy(Body("top", I, frame, (I0, I0, I)), ground).value
    height = frame.point("G", 0, 0, 1).position(ground).z
    E = top_energy(I0, I, mgr, theta, nod, precession, spin)
    assert close(E.value, T + mgr * height, small(kind, 10))


def test_example_11_16_with_the_books_sign_the_sum_is_not_constant():
    """Against the integrated motion of a nodding top: plus stays, minus (as printed) does not."""
    I0, I, mgr, omega_z = 0.02, 0.01, 0.5, 60.0
    states = integrated(euler(I0, I, mgr, omega_z), (0.0, 0.6, 0.0, 0.0, 0.0), 0.5)
    right, printed = [], []
    for t in np.linspace(0.0, 0.5, 11):
        s = states(t)
        spin = omega_z - s["psi_rate"] * math.cos(s["theta"])
        E = top_energy(I0, I, mgr, s["theta"], s["theta_rate"], s["psi_rate"], spin)
        right.append(E.value)
        printed.append(E.reweighted(weight=-1))
    assert np.ptp(right) < 1e-9 * abs(right[0])
    assert np.ptp(printed) > 1e-2 * mgr

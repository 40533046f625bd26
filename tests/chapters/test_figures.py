"""What figures compute themselves."""

import numpy as np
import pytest

from newton_euler import Frame, integrate
from newton_euler.chapters.figures.ch08 import attitudes
from newton_euler.scenes.spatial.free_body import free_body


def test_the_attitudes_of_a_free_body_keep_its_angular_momentum_in_space():
    moments, times = (3.6e-4, 1.7e-4, 5.3e-4), np.linspace(0, 2, 401)
    states = integrate(free_body(*moments), 2.0, (10.0, 0.1, 0.1)).at(times)
    rates, ground = np.transpose([states[f"w_{x}"] for x in "xyz"]), Frame("ground")
    start = np.multiply(moments, rates[0])
    assert min(states["w_x"]) < -9  # it has flipped
    for n in range(0, 401, 50):
        axis, angle = attitudes(times, rates)[n]
        body = ground.rotate("body", axis=tuple(axis), angle=angle)
        H = body.vector(*np.multiply(moments, rates[n])).expressed_in(ground)
        assert H.components() == pytest.approx(start, abs=3e-3 * start[0])

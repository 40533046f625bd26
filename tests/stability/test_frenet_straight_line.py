"""Frenet axes on a straight line: rounding noise must not be normalised into a direction (3.5)."""

import numpy as np
import pytest

from newton_euler import Frame, at
from newton_euler.algebra.scalars import SingularError
from newton_euler.kinematics.paths import frenet, frenet_along

ground = Frame("ground")
LINE = (0.1, 0.7, 0.3)  # its direction


def line(t):
    s = t + t**3 / 3  # along it at a varying speed
    return tuple(c * s for c in LINE)


def test_the_printed_formula_makes_a_confident_unit_normal_of_rounding_noise():
    t = 0.3
    v, a = (np.array(LINE) * (1 + t * t)), (np.array([0.1 * (2 * t), 0.7 * 2 * t, 0.6 * t]))
    e = np.cross(np.cross(v, a), v)
    assert 0 < np.linalg.norm(e) < 1e-15
    assert abs(np.linalg.norm(e / np.linalg.norm(e)) - 1) < 1e-12  # and no warning


@pytest.mark.parametrize("t", [0.0, 0.3, 0.7, 1.1, 123.456])
def test_the_engine_refuses_a_straight_path_in_words_wherever_it_is_asked(t):
    with pytest.raises(SingularError, match="the path is straight here"):
        frenet_along(line, t, ground)
    P = ground.point("P", *at_time(line, t))
    with pytest.raises(SingularError, match="e_n, e_b and the torsion do not exist"):
        frenet(P.velocity(ground), P.acceleration(ground))


def at_time(path, t):
    return tuple(at(lambda s, n=n: path(s)[n], t) for n in range(3))

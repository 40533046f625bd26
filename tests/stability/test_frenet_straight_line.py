"""Frenet axes on a straight line: rounding noise must not be normalised into a direction (3.5)."""

import pytest

from newton_euler import Frame
from newton_euler.algebra.scalars import SingularError
from newton_euler.kinematics import along
from newton_euler.kinematics.paths import frenet, frenet_along

ground = Frame("ground")


def line(t):
    s = t + t**3 / 3  # along it at a varying speed
    return tuple(c * s for c in (0.1, 0.7, 0.3))


@pytest.mark.parametrize("t", [0.0, 0.3, 0.7, 1.1, 123.456])
def test_the_engine_refuses_a_straight_path_in_words_wherever_it_is_asked(t):
    with pytest.raises(SingularError, match="the path is straight here"):
        frenet_along(line, t, ground)
    P = ground.point("P", *along(line, t))
    with pytest.raises(SingularError, match="e_n, e_b and the torsion do not exist"):
        frenet(P.velocity(ground), P.acceleration(ground))

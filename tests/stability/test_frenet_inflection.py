"""Frenet axes at an inflection: e_n and e_b do not exist there, and jump across it (3.5)."""

import mpmath
import numpy as np
import pytest

from newton_euler import Frame
from newton_euler.algebra.scalars import SingularError
from newton_euler.kinematics.paths import flexure, frenet, frenet_along, speed_rate

ground = Frame("ground")


def cubic(t):
    """y = x^3, with the inflection at t = 0."""
    return t, t**3, 0


def textbook(t):
    """e_n as printed, (v x a) x v normalised."""
    v, a = np.array([1.0, 3 * t * t, 0]), np.array([0, 6 * t, 0])
    e = np.cross(np.cross(v, a), v)
    with np.errstate(invalid="ignore"):
        return e / np.linalg.norm(e)


def test_the_printed_normal_is_nan_at_the_inflection_and_turns_over_across_it():
    assert np.isnan(textbook(0.0)).all()
    assert textbook(1e-9)[1] == 1.0
    assert textbook(-1e-9)[1] == -1.0


def test_at_the_inflection_the_engine_refuses_in_words_and_names_what_still_exists():
    with pytest.raises(SingularError, match=r"inflection.*speed_rate"):
        frenet_along(cubic, 0.0, ground)
    v, a = ground.vector(1.0, 0, 0), ground.vector(0.5, 0, 0)
    with pytest.raises(SingularError, match="radius of curvature is infinite"):
        frenet(v, a)
    assert speed_rate(v, a) == 0.5
    assert flexure(v, a) == 0.0


@pytest.mark.parametrize("t", [1e-3, -1e-3, 1e-6, -1e-9, 1e-12])
def test_beside_the_inflection_flexure_and_normal_are_right_to_1e_minus_14(t):
    found = frenet_along(cubic, t, ground)
    x = mpmath.mpf(t)
    exact = abs(6 * x) / (1 + 9 * x**4) ** mpmath.mpf("1.5")
    assert abs(found.flexure - exact) < 1e-14 * exact
    normal = found.e_n.components(ground)
    assert abs(normal[1] - (1 if t > 0 else -1) / mpmath.sqrt(1 + 9 * x**4)) < 1e-15


def test_an_inflection_elsewhere_where_rounding_leaves_no_exact_zero_is_refused_as_well():
    def moved(t):  # the inflection at t = 0.1, where 6 (t - 0.1) and the like are rounding noise
        return t, t**3 - 3 * t**2 / 10 + 3 * t / 100, 0

    # the second derivative: noise, of which a direction could be made
    assert 6 * 0.1 - 6 / 10 == 1.1102230246251565e-16
    with pytest.raises(SingularError, match="inflection"):
        frenet_along(moved, 0.1, ground)
    assert frenet_along(moved, 0.1 + 1e-6, ground).flexure == pytest.approx(6e-6, rel=1e-9)

"""Splitting methods near separatrices, and rates that are zero: a fixed step that looks fine at
the start is too long where the motion is faster, and the estimated error is true.
"""

import math

import mpmath
import pytest

from newton_euler import sin, where
from newton_euler.motion import AccuracyError, ModelError, integrate, second_order
from newton_euler.scenes.spatial.free_body import free_body
from tests.honesty import closed_forms

SPLITTING = ("verlet", "yoshida4", "yoshida6", "yoshida8")


def pendulum():
    return second_order("pendulum", {}, ("a",), lambda s, p, t: (-sin(s.a),))


def swing(t, rate):
    """The angle after a start at the lowest point with this rate, below the separatrix's, 2."""
    with mpmath.workdps(40):
        return closed_forms.pendulum(mpmath, *map(mpmath.mpf, (1, 0, rate, t)))[0]


FINE = pytest.param(1e-8, marks=pytest.mark.slow)  # millions of steps of a low order


@pytest.mark.parametrize("rtol", [1e-3, 1e-6, FINE])
@pytest.mark.parametrize("below", [1e-2, 1e-5, FINE])
@pytest.mark.parametrize("method", SPLITTING)
def test_a_swing_nearly_to_the_top_is_as_accurate_as_estimated(method, below, rtol):
    """It begins at the lowest point, where nothing shows how it will linger at the top."""
    t, start = 25.0, (0.0, 2.0 - below)
    true = float(swing(t, start[1]))
    try:
        motion = integrate(pendulum(), t, start, rtol, method)
    except AccuracyError as refused:
        motion = refused.reached
    except ModelError as refused:  # too many steps of a low order, or less than its least rtol
        assert "steps" in str(refused) or "the least is" in str(refused)  # noqa: PT017
        return
    assert abs(motion.end["a"] - true) / math.pi <= motion.error


@pytest.mark.parametrize("method", ["lie-poisson4", "lie-poisson8", "dop853"])
def test_a_body_that_turns_over_is_as_accurate_as_estimated(method):
    """About the intermediate axis: it lingers, and turns over."""
    start = (1e-6, 1.0, 1e-6)
    true = integrate(free_body(1.0, 2.0, 3.0), 30.0, start, 1e-9, "exact").end
    motion = integrate(free_body(1.0, 2.0, 3.0), 30.0, start, 1e-6, method)
    assert max(abs(motion.end[n] - true[n]) for n in true) <= 2 * motion.error <= 2e-6


def test_a_splitting_method_refuses_kinks():
    model = second_order(
        "floor", {}, ("h",), lambda s, p, t: (where(s.h < 0, -1e4 * s.h, 0.0) - 9.81,)
    )
    with pytest.raises(ModelError, match="have kinks, at which it loses its order"):
        integrate(model, 2.0, (1.0, 0.0), 1e-6, "yoshida8")

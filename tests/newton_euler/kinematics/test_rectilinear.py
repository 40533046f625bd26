"""Motion along a line from its acceleration: against closed solutions, on floats, arrays and mpf,
and where the end is not reached.
"""

import math

import mpmath as mp
import numpy as np
import pytest

from newton_euler import compiled, cos, log, moving
from newton_euler.algebra import DimensionError, SingularError
from newton_euler.kinematics import from_speed, from_time
from tests.kinds import LENGTH, TIME, close, numbers, within

three_kinds = pytest.mark.parametrize("kind", ["float", "array", "mpmath"])
small = within(2e-14, 26)


@three_kinds
def test_acceleration_in_time_is_integrated_twice(kind):
    t, x0, v0 = numbers(kind, "1.7", "-0.4", "2.5")
    x, v = from_time(lambda t: cos(t), t, x0, v0)
    module = mp if kind == "mpmath" else np
    assert close(x, x0 + v0 * t + 1 - module.cos(t), small(kind))
    assert close(v, v0 + module.sin(t), small(kind))


@three_kinds
def test_linear_drag_slows_exponentially(kind):
    k, v0, v = numbers(kind, "0.5", 4, "1.5")
    t, x = from_speed(lambda v: -k * v, v, v0)
    assert close(t, log(v0 / v) / k, small(kind))
    assert close(x, (v0 - v) / k, small(kind))


def test_a_speed_that_is_not_reached_is_refused_and_a_terminal_one_approached():
    with pytest.raises(SingularError, match=r"velocity 5\.0 is not reached from 0\.0"):
        from_speed(lambda v: 2.0 - v, 5.0, v0=0.0)
    with pytest.raises(SingularError, match="not reached"):
        from_speed(lambda v: -1.0, 5.0, v0=0.0)
    with pytest.raises(SingularError, match="not reached"):
        from_speed(lambda v: 0.2 - v, 0.5, v0=0.0)
    t, x = from_speed(lambda v: 5.0 - v, 4.0, v0=1.0)  # a vanishes beyond 4 only
    assert (t, x) == (pytest.approx(math.log(4), abs=1e-14), pytest.approx(5 * t - 3, abs=1e-14))
    for missing in (1e-3, 1e-6):
        t, _ = from_speed(lambda v: 2.0 - v, 2.0 - missing, v0=0.0)
        assert abs(t - math.log(2 / missing)) < 1e-15 / missing
    # there 2 - v has lost half of its digits
    with pytest.raises(SingularError, match="does not converge"):
        from_speed(lambda v: 2.0 - v, 2.0 - 1e-9, v0=0.0)
    with pytest.raises(SingularError, match="not reached"):
        from_speed(lambda v: 2.0 - v, 2.0, v0=0.0)


def slides(t, c, k):
    """From rest at 0: position and velocity at t under a(t) = c - k t."""
    return from_time(lambda s: c - k * s, t)


def brakes(v, v0, c):
    """The time and the distance from v0 to v under a(v) = -c v^2."""
    return from_speed(lambda u: -c * u * u, v, v0)


def test_motion_from_its_acceleration_has_dimensions_and_rates_and_is_traced():
    speed = LENGTH / TIME
    assert slides(TIME, speed / TIME, speed / TIME**2) == (LENGTH, speed)
    assert brakes(speed, speed, 1 / LENGTH) == (TIME, LENGTH)
    with pytest.raises(DimensionError, match="cannot add"):
        slides(TIME, speed, speed / TIME**2)
    by_hand = {
        slides: (2.0, 3.0, 0.6, (3.0 * 2 - 0.1 * 8, 6 - 1.2)),
        brakes: (2.0, 5.0, 0.1, ((0.5 - 0.2) / 0.1, math.log(2.5) / 0.1)),
    }
    for motion, (*given, expected) in by_hand.items():
        assert compiled(motion)(*given) == pytest.approx(expected, rel=1e-13)
        many = [np.array([x, x]) for x in given]
        assert np.allclose(compiled(motion)(*many), np.array([expected] * 2).T, rtol=1e-13)
    growing = moving(2.0, rate=1.0)
    x, v = slides(growing, 3.0, 0.6)
    assert x.rate == pytest.approx(v.value, rel=1e-13)
    assert x.acceleration == pytest.approx(3.0 - 0.6 * 2.0, rel=1e-13)

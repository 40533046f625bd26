"""Close approach on an eccentric orbit: steps and digits are lost near the centre, but not by
Kepler's equation solved between bounds (6.4).
"""

import math

import mpmath
import pytest
import sympy

from newton_euler.motion import ModelError, integrate
from newton_euler.scenes.particles.orbit import orbit
from tests.models import from_farthest
from tests.stability.naive import solved

ORBIT = orbit(1.0)
PERIOD = 2 * math.pi


def distance(a, b):
    return math.hypot(*(float(p - q) for p, q in zip(tuple(a)[:2], tuple(b)[:2], strict=True)))


def exact(e, t):
    return ORBIT.solution(mpmath.mpf(t), from_farthest(1.0, 1.0, e))


@pytest.mark.parametrize("e", [0.9, 0.99, 0.999])
def test_the_default_solver_is_lost_by_the_size_of_the_orbit_after_10_periods(e):
    t, start = 10 * PERIOD, from_farthest(1.0, 1.0, e)
    assert distance(solved(ORBIT, t, start).y[:, -1], exact(e, t)) > 0.5  # of the semi-axis
    assert distance(ORBIT.solution(t, start), exact(e, t)) < 3e-14


@pytest.mark.parametrize("e", [0.9, 0.999])
def test_it_obeys_keplers_equation_in_30_digits(e):
    with mpmath.workdps(30):
        E, e = mpmath.mpf(2), mpmath.mpf(e)
        start = -(1 + e), mpmath.mpf(0), mpmath.mpf(0), -mpmath.sqrt((1 - e) / (1 + e))
        t = E - e * mpmath.sin(E) + mpmath.pi  # from the farthest point, half a period before E = 0
        x, y, *_ = orbit(mpmath.mpf(1)).solution(t, start)
        assert abs(x - mpmath.cos(E) + e) < 1e-25
        assert abs(y - mpmath.sqrt(1 - e**2) * mpmath.sin(E)) < 1e-25


@pytest.mark.parametrize("less", [1e-2, 1e-9, 1e-12, 1e-15])
def test_an_ellipse_that_is_almost_a_parabola_is_as_accurate_as_any(less):
    start = (1.0, 0.0, -0.3, math.sqrt((math.sqrt(2) - less) ** 2 - 0.09))
    for t in (2.0, 100.0, -50.0):
        x, true = ORBIT.solution(t, start), ORBIT.solution(mpmath.mpf(t), start)
        assert distance(x, true) < 2e-14 * max(1.0, math.hypot(*x[:2]), abs(t))


@pytest.mark.parametrize("start", [
    (1.0, 0.0, 0.0, math.sqrt(2) + 1e-9),
    (1.0, 0.0, -0.3, 3.0),
    (2.0, 0.0, 0.6, 0.8),
    (-3.3, -0.5, 5.3, -0.004),
])  # fmt: skip
def test_a_parabola_or_hyperbola_is_refused_in_words_and_integrated(start):
    with pytest.raises(ModelError, match=r"not an ellipse .* integrate it"):
        ORBIT.solution(1.0, start)
    motion = integrate(ORBIT, 2.0, start, 1e-10)
    assert motion.method.name != "exact"
    end = tuple(motion.end.values())
    for name in ORBIT.invariants:
        assert abs(ORBIT.invariant(name, end) - ORBIT.invariant(name, start)) < 1e-8


def test_an_orbit_through_the_centre_and_expressions_are_refused_in_words():
    with pytest.raises(ModelError, match="straight line through the centre"):
        ORBIT.solution(1.0, (1.0, 0.0, -0.5, 0.0))
    with pytest.raises(ModelError, match="needs numbers"):
        ORBIT.solution(sympy.Symbol("t"), (1.0, 0.0, 0.0, 1.0))
    with pytest.raises(ModelError, match="mu > 0"):
        orbit(-1.0).solution(1.0, (1.0, 0.0, 0.0, 1.0))
    # close to it: e = 1 - 7e-13
    assert math.isfinite(ORBIT.solution(50.0, (1.0, 0.0, -0.5, 1e-6))[0])

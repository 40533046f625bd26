"""One root, over every kind of number, against equations with known solutions."""

import math
import pickle

import mpmath
import numpy as np
import pytest
import sympy

from newton_euler import asin, compiled, cos, exp, moving, root, sin, tan
from newton_euler.algebra import DimensionError, LinearForm, Moving, ScalarError, SingularError
from tests.kinds import LENGTH, TIME


def rod_angle(length, radius, crank):
    """The angle b of the rod of a slider crank: length sin(b) = radius sin(crank)."""
    return root(lambda b: length * sin(b) - radius * sin(crank), -1.5, 1.5)


def rod_angle_by_hand(length, radius, crank):
    return asin(radius * sin(crank) / length)


def asked(f):
    """The function, and the list of points at which it is evaluated."""
    places = []

    def counted(x):
        places.append(x)
        return f(x)

    return counted, places


@pytest.mark.parametrize(("f", "low", "high", "expected", "most"), [
    (lambda x: x * x - 2, 0.0, 5.0, math.sqrt(2), 15),
    (lambda x: x - 1e-200, -1.0, 1.0, 1e-200, 15),
    (lambda x: 1e-200 * (x - 0.25), 0.0, 1.0, 0.25, 15),
    (lambda x: x, 0, 1, 0, 3),
    (lambda x: x - 1, 0, 1, 1, 3),
    (lambda x: x**9 - 1e-12, 0.0, 1.0, 1e-12 ** (1 / 9), 80),
    (lambda x: 3 * x - 2, -4.0, 1000.0, 2 / 3, 15),
    (lambda x: 7.0 - 0.3 * x * x - x, 0.28, 1.1e3, (math.sqrt(9.4) - 1) / 0.6, 30),
    (lambda x: x**3, -1.0, 2.0, 0.0, 10),
    (lambda x: sin(x) ** 5, -3.0, 1.0, 0.0, 10),
    (lambda x: (x - 0.3) ** 3, -1.0, 5.0, 0.3, 80),
    (lambda x: exp(300 * (x - 0.4)) - 1, 0.0, 1.0, 0.4, 40),
    (lambda x: exp(-1 / x) - 1e-100, 0.001, 1.0, 0.01 / math.log(10), 40),
    (lambda x: 1 / (x - 0.99999) + 3, 1.0 - 1e-3, 0.0, 0.99999 - 1 / 3, 40),
    (lambda x: (x > 0.7) - 0.5, 0.0, 1.0, 0.7, 70),
    (lambda x: 1e300 * (x - 0.1) * (1 + x * x), -1.0, 2.0, 0.1, 30),
])  # fmt: skip
def test_a_root_is_exact_to_round_off_after_few_steps_within_the_bracket(
    f, low, high, expected, most
):
    for ends in ((low, high), (high, low)):
        counted, places = asked(f)
        assert root(counted, *ends) == pytest.approx(expected, rel=1e-14, abs=0.0)
        assert min(low, high) <= min(places) <= max(places) <= max(low, high)
        assert len(places) <= most


def test_the_slowest_row_of_an_array_is_no_slower_than_alone():
    power, target = np.array([1, 2, 3, 9, 1, 3]), np.array([0.0, 1e-9, 8.0, 1e-12, 1e3, 0.0])
    counted, places = asked(lambda x: x**power - target)
    found = root(
        counted, np.array([-1e-3, 0, -1, 0, -1e-3, -1]), np.array([5.0, 1.0, 1e4, 1.0, 1e3, 1.0])
    )
    np.testing.assert_allclose(found, target ** (1 / power), rtol=1e-14)
    assert len(places) < 60


@pytest.mark.parametrize("digits", [30, 50])
def test_roots_of_many_digits_take_few_steps(digits):
    with mpmath.workdps(digits):
        counted, places = asked(lambda x: x**3 - 2)
        found = root(counted, mpmath.mpf(0), mpmath.mpf(100))
        assert abs(found - mpmath.cbrt(2)) < mpmath.mpf(10) ** (2 - digits)
        assert len(places) < 30
        counted, places = asked(lambda x: x**3)
        assert root(counted, mpmath.mpf(-1), mpmath.mpf(3)) == 0
        assert len(places) < 10


def test_an_equation_for_each_instant():
    crank = np.linspace(0.0, 2 * np.pi, 7)
    np.testing.assert_allclose(
        rod_angle(3.0, 1.0, crank), rod_angle_by_hand(3.0, 1.0, crank), rtol=1e-14, atol=1e-16
    )
    ends = root(lambda x: x - np.array([0.0, 0.5, 1.0]), 0.0, 1.0)
    np.testing.assert_allclose(ends, [0.0, 0.5, 1.0], rtol=1e-15)


def test_a_root_has_dimensions_and_the_rates_of_moving_numbers():
    assert root(lambda x: x * x - LENGTH * LENGTH, 0, LENGTH) == LENGTH
    with pytest.raises(DimensionError, match="cannot add"):
        root(lambda x: x - TIME, 0, LENGTH)
    crank = moving(0.7, rate=2.0, acceleration=0.3)
    found, expected = rod_angle(3.0, 1.0, crank), rod_angle_by_hand(3.0, 1.0, crank)
    assert found._parts() == pytest.approx(expected._parts(), rel=1e-13)
    a = Moving(LENGTH, LENGTH / TIME, LENGTH / TIME**2)
    assert root(lambda x: x * x - a * a, 0, LENGTH).rate == LENGTH / TIME
    with pytest.raises(SingularError, match=r"has no rate.*slope 0"):
        root(lambda x: x**3 - moving(0.0, rate=1.0), -1.0, 2.0)


def test_traced_roots_are_pickled_and_carry_rates():
    run = compiled(rod_angle)
    assert pickle.loads(pickle.dumps(run))(3.0, 1.0, 0.7) == run(3.0, 1.0, 0.7)
    moves = compiled(lambda rate: rod_angle(3.0, 1.0, Moving(0.7, rate)).rate)
    assert moves(2.0) == pytest.approx(rod_angle_by_hand(3.0, 1.0, moving(0.7, 2.0)).rate)


def test_what_has_no_root_is_refused_in_words():
    with pytest.raises(SingularError, match=r"bracketed by 0.0 and 1.0.*1.0 and 2.0"):
        root(lambda x: x * x + 1, 0.0, 1.0)
    with pytest.raises(SingularError, match=r"two finite values; got 0\.0 and inf"):
        root(lambda x: x - 1, 0.0, math.inf)
    with pytest.raises(SingularError, match=r"the function has no value at .*nan"):
        root(lambda x: x + math.nan, 0.0, 1.0)
    with pytest.raises(SingularError, match=r"a pole at 1\.5707963267948\d*, no root"):
        root(tan, 1.0, 2.0)
    with pytest.raises(SingularError, match="no root is bracketed"):
        root(lambda x: 1e-200 * (x + 1), 0.0, 1.0)
    with pytest.raises(ScalarError, match=r"put numbers in: .* has no formula in general"):
        root(lambda x: cos(x) - sympy.Symbol("k"), 0, 1)
    with pytest.raises(ScalarError, match="no root that can be found"):
        root(lambda x: x - LinearForm(1.0, (1.0,)), 0.0, 1.0)


@pytest.mark.parametrize(("square", "low", "high"), [(2, 0, 2), (6, "1/10", 10)])
def test_exact_numbers_without_symbols_have_a_root_in_floats(square, low, high):
    """SymPy's fractions would grow without end."""
    found = root(lambda x: x * x - square, sympy.Rational(low), sympy.Rational(high))
    assert type(found) is float
    assert found == pytest.approx(square**0.5, rel=1e-15)

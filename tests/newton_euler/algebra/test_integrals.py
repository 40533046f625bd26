"""One integral over every kind of number, against antiderivatives by hand."""

import math
import pickle

import mpmath
import numpy as np
import pytest
import sympy

from newton_euler import Frame, compiled, cos, integral, moving, sin, sqrt
from newton_euler.algebra import ZERO, DimensionError, LinearForm, Moving, SingularError, WorkError
from newton_euler.algebra.partial_evaluation import folded
from tests.kinds import LENGTH, MASS, TIME, compiled_by

ground = Frame("ground")


def wire(a, k):
    """The integral of k x sin(x/a) over x from 0 to 2 a, as in a centre of mass."""
    return integral(lambda x: k * x * sin(x / a), 0, 2 * a)


def wire_by_hand(a, k):
    two = a / a * 2
    return k * a * a * (sin(two) - 2 * cos(two))


def triangle(b, h):
    """The integral of x y over the right triangle with legs b and h, by two integrals."""
    return integral(lambda x: integral(lambda y: x * y, 0, h * (1 - x / b)), 0, b)


def test_floats_arrays_and_expressions_of_symengine():
    a, k = np.array([0.5, 2.0, 3.0]), 1.7
    np.testing.assert_allclose(wire(a, k), wire_by_hand(a, k), rtol=1e-14)
    np.testing.assert_allclose(triangle(a, 2.0), a**2 * 4 / 24, rtol=1e-14)
    symengine = pytest.importorskip("symengine")
    a, k = symengine.symbols("a k")
    assert symengine.expand(triangle(a, k) - a**2 * k**2 / 24) == 0


def test_fixed_limits_take_the_digits_and_the_instants_of_the_function():
    with mpmath.mp.workdps(50):
        third = mpmath.mpf(1) / 3
        assert abs(integral(lambda x: third * x, 0, 2) - 2 * third) < mpmath.mpf(10) ** -48
        assert abs(integral(lambda x: third * x, 0.0, 2.0) - 2 * third) < mpmath.mpf(10) ** -48
    gains = np.array([1.0, 2.0])
    np.testing.assert_allclose(integral(lambda x: gains * x, 0, 1), gains / 2, rtol=1e-14)


@pytest.mark.parametrize("digits", [30, 50])
def test_numbers_of_many_digits(digits):
    with mpmath.mp.workdps(digits):
        a, k = mpmath.mpf("0.7"), mpmath.mpf("1.7")
        assert abs(wire(a, k) - wire_by_hand(a, k)) < mpmath.mpf(10) ** (2 - digits)
        quarter = integral(lambda x: sqrt(a * a - x * x), 0, a)
        assert abs(quarter - mpmath.pi * a * a / 4) < mpmath.mpf(10) ** (2 - digits)


def test_dimensions():
    assert wire(LENGTH, MASS / LENGTH) == MASS * LENGTH
    assert triangle(LENGTH, LENGTH) == LENGTH**4
    assert integral(lambda t: LENGTH * t, 0.0, 1.0) == LENGTH
    assert integral(lambda x: ZERO, 0, LENGTH) == 0
    with pytest.raises(DimensionError, match="cannot add"):
        integral(lambda x: x, TIME, LENGTH)
    with pytest.raises(DimensionError, match="sin of a quantity"):
        integral(sin, 0, LENGTH)


def test_expressions():
    a, k = sympy.symbols("a k", positive=True)
    assert sympy.simplify(wire(a, k) - wire_by_hand(a, k)) == 0
    assert sympy.expand(triangle(a, k) - a**2 * k**2 / 24) == 0
    assert integral(lambda x: k * x, 0.0, 2.0) == 2 * k
    assert integral(lambda x: sqrt(a**2 - x**2), -a, a) == sympy.pi * a**2 / 2
    with pytest.raises(WorkError, match="SymPy finds no formula"):
        integral(lambda x: sin(k * cos(x**3)), 0, a)


def test_integrals_of_moving_numbers_units_and_unknowns():
    a = moving(0.7, rate=1.3, acceleration=-0.4)
    for found, expected in ((wire(a, 2.0), wire_by_hand(a, 2.0)), (triangle(a, a), a**4 / 24)):
        assert found._parts() == pytest.approx(expected._parts(), rel=1e-13)
    a = Moving(LENGTH, LENGTH / TIME, LENGTH / TIME**2)
    assert wire(a, MASS).rate == MASS * LENGTH**2 / TIME
    found = integral(lambda x: x * LinearForm(3.0, (1.0, ZERO)) + 2.0, 0.0, 2.0)
    assert found.value == pytest.approx(10.0)
    assert found.coefficients[0] == pytest.approx(2.0)
    assert found.coefficients[1] is ZERO


def test_vectors_and_tuples():
    turned = ground.rotate("turned", "z", 0.3)
    load = integral(lambda x: ground.vector(x, 0, 1.0) * x, 0.0, 3.0)
    assert load.frame is ground
    assert tuple(load) == pytest.approx((9.0, 0, 4.5))
    mixed = integral(
        lambda x: (ground.i if x < 0.5 else turned.i.expressed_in(turned)) * x, 0.0, 0.5
    )
    assert tuple(mixed) == pytest.approx((0.125, 0, 0))
    assert integral(lambda x: (x, (x * x, 1)), 0.0, 3.0)[1][0] == pytest.approx(9.0)


def test_traced_integrals_carry_rates_and_may_lie_in_integrals():
    found, expected = (f(moving(0.7, 1.0), 2.0) for f in (compiled(wire), wire_by_hand))
    assert found.rate == pytest.approx(expected.rate, rel=1e-13)
    run = compiled(triangle)
    assert run(2.0, 3.0) == pytest.approx(36 / 24, rel=1e-14)
    assert compiled(lambda b: run(b, 2 * b))(2.0) == pytest.approx(64 / 24, rel=1e-14)
    assert pickle.loads(pickle.dumps(run))(2.0, 3.0) == run(2.0, 3.0)
    nested = lambda a: integral(lambda s: s * integral(lambda p: (s * p, a)[1], 0, 1), 0, a)
    assert nested(2.0) == pytest.approx(4, rel=1e-14)  # a^3/2
    assert compiled(nested)(2.0) == pytest.approx(4, rel=1e-14)


def test_a_traced_integral_computes_outer_steps_once_and_equal_ones_once():
    calls = []

    def f(a, b):
        calls.append(1)
        outer = sin(a) * cos(b)
        return integral(lambda x: x * outer, 0, 1) + integral(lambda x: x * outer, 0, 1)

    run = compiled(f)
    assert run.source.count("integral(") == 1
    assert run.source.count("sin(") == 1
    assert run(0.3, 0.4) == pytest.approx(np.sin(0.3) * np.cos(0.4), rel=1e-14)
    other = compiled(lambda a: integral(lambda x: x * a, 0, 1) + integral(lambda x: x + a, 0, 1))
    assert other.source.count("integral(") == 2


def test_a_traced_integral_of_a_vector_is_one_and_of_parameters_alone_done_before_a_motion():
    run = compiled(lambda a: integral(lambda x: ground.vector(a * x, 0, x * x), 0, 1))
    assert run(4.0) == pytest.approx((2.0, 0, 1 / 3))
    assert run.source.count("integral(") == 1
    rest, constants = folded(compiled(lambda x, a, k: x * wire(a, k)), 1)
    assert "integral(" not in rest.source
    assert constants(2.0, 1.7)[0] == pytest.approx(wire_by_hand(2.0, 1.7))


def test_heyoka_refuses_an_integral_inside_a_formula_and_arrays_go_by_numpy():
    hy = pytest.importorskip("heyoka")
    run = compiled_by("heyoka", wire)
    np.testing.assert_allclose(run(np.array([2.0]), 1.7), wire_by_hand(2.0, 1.7), rtol=1e-14)
    with pytest.raises(TypeError, match="heyoka has no integrals and roots inside a formula"):
        run(hy.expression("a"), hy.expression("k"))


def test_complex_values_and_corners_that_are_not_named_are_refused():
    with pytest.raises(TypeError, match="expected real numbers"):
        integral(lambda x: x**0.5, 0.0, -1.0)
    with pytest.raises(SingularError, match=r"does not converge.*breaks"):
        integral(lambda x: abs(x - 0.3), 0.0, 1.0)
    assert integral(lambda x: abs(x - 0.3), 0.0, 1.0, breaks=(0.3,)) == pytest.approx(0.29)


@pytest.mark.parametrize(("f", "start", "end", "value"), [
    (lambda x: x**-0.5, 0.0, 4.0, 4.0), (math.exp, 0.0, 1.0, math.e - 1), (math.sin, 0.0, math.pi, 2.0), (lambda x: x, -1.0, 1.0, 0.0),
    (lambda x: 1 / (1 + 25 * x * x), -1.0, 1.0, 0.4 * math.atan(5)), (lambda x: 0.0, 0.0, 1.0, 0.0), (math.log, 0.0, 1.0, -1.0),
    (math.exp, 1.0, 0.0, 1 - math.e), (math.sqrt, 0.0, 1.0, 2 / 3),
])  # fmt: skip
def test_integrals_known_in_closed_form(f, start, end, value):
    assert abs(integral(f, start, end) - value) < 2e-15

"""Data as functions, against SciPy's splines, data of known polynomials, and every kind of number."""

import copy
import pickle
from functools import partial

import mpmath as mp
import numpy as np
import pytest
import sympy
from scipy.interpolate import CubicSpline, interp1d

from newton_euler import compiled, moving, sin, table
from newton_euler.algebra import DimensionError, ScalarError, SingularError, TableError
from newton_euler.algebra.errors import ArgumentError
from newton_euler.algebra.scalars import RangeError
from tests.kinds import LENGTH, MASS, TIME, close, compiled_by, every_kind, numbers

KINDS = "linear", "cubic", "natural", "previous"
XS = [-1.0, -0.25, 0.5, 0.75, 2.0, 3.5]
YS = [2.0, -1.0, 0.5, 4.0, 4.0, -3.0]
SCIPY = {"linear": interp1d, "cubic": CubicSpline, "previous": partial(interp1d, kind="previous")}
SCIPY["natural"] = partial(CubicSpline, bc_type="natural")
RNG = np.random.default_rng(5)
RANDOM = {
    n: (np.sort(10.0 ** RNG.uniform(-2, 2, n)).cumsum(), RNG.normal(size=n)) for n in (2, 3, 4, 60)
}


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("data", [(XS, YS), *RANDOM.values()], ids=["few", *map(str, RANDOM)])
def test_a_table_is_what_scipy_makes_of_the_data(kind, data):
    xs, ys = data
    f, known = table(xs, ys, kind), SCIPY[kind](xs, ys)
    places = np.concatenate((xs, np.linspace(xs[0], xs[-1], 997)))
    scale = abs(known(places)).max()
    assert abs(f(places) - known(places)).max() < 1e-12 * scale
    assert max(abs(f(x) - known(x)) for x in places.tolist()) < 1e-12 * scale


@pytest.mark.parametrize("kind", ["cubic", "natural"])
@pytest.mark.parametrize("order", [1, 2, 3])
def test_its_derivatives_are_those_of_scipys_spline(kind, order):
    f, known = table(XS, YS, kind), SCIPY[kind](XS, YS)
    for _ in range(order):
        f = f.derivative()
    places = np.linspace(XS[0], XS[-1], 101)
    assert np.allclose(f(places), known(places, order), rtol=1e-11, atol=1e-11)


@every_kind
@pytest.mark.parametrize("degree", range(4))
def test_a_spline_of_a_cubic_is_this_cubic_in_all_digits(kind, degree):
    xs = numbers(kind if kind != "array" else "float", 0, "1/3", 1, "5/2", "8/3", 4)
    f = table(xs, [x**degree for x in xs], "cubic")
    x = numbers(kind, "7/5")
    assert close(f(x), x**degree, 1e-13 if kind in ("float", "array") else mp.mpf(10) ** -27)


@every_kind
@pytest.mark.parametrize("rule", KINDS)
def test_data_of_floats_have_the_digits_of_the_place(kind, rule):
    x = numbers(kind, "1/3")
    exact = table(*[[sympy.Rational(v) for v in data] for data in (XS, YS)], rule)
    third = sympy.Rational(1, 3) if kind in ("mpmath", "sympy") else None
    places = [third] if third else [sympy.Rational(v) for v in np.atleast_1d(x).tolist()]
    expected = [exact(place) for place in places]
    expected = np.array(expected, dtype=float) if kind == "array" else expected[0]
    tolerance = 1e-13 if kind in ("float", "array", "sympy") else mp.mpf(10) ** -27
    assert close(table(XS, YS, rule)(x), expected, tolerance)


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("hold", ["refuse", "hold"])
def test_an_expression_has_a_formula_with_the_same_values(kind, hold):
    f, x = table(XS, YS, kind, hold), sympy.Symbol("x")
    formula = f(x)
    for place in (*XS, 0.1, 0.6, 3.0, *((-5.0, 7.0) if hold == "hold" else ())):
        assert close(float(formula.subs(x, place)), f(place), 1e-12)
    if hold == "refuse":
        assert all(formula.subs(x, place) is sympy.nan for place in (-5.0, 7.0))


@pytest.mark.parametrize("kind", KINDS)
def test_the_dimension_is_that_of_the_values(kind):
    force = MASS * LENGTH / TIME**2
    f = table([TIME] * 5, [force] * 5, kind)
    assert f(TIME) == force
    with pytest.raises(DimensionError):
        f(LENGTH)
    with pytest.raises(DimensionError):
        table(XS, YS, kind)(TIME)
    assert f.derivative()(TIME) == force / TIME or kind == "previous"


def test_a_moving_place_gives_the_rates():
    f, known = table(XS, YS, "cubic"), CubicSpline(XS, YS)
    found = f(sin(moving(0.4, 2.0, 0.5)))
    x = sin(moving(0.4, 2.0, 0.5))
    rate, acceleration = known(x.value, 1) * x.rate, known(x.value, 2) * x.rate**2
    assert close(found.rate, rate, 1e-12)
    assert close(found.acceleration, acceleration + known(x.value, 1) * x.acceleration, 1e-12)


@pytest.mark.parametrize("kind", KINDS)
def test_a_compiled_formula_reads_it_as_a_plain_one_does(kind):
    f = table(XS, YS, kind)
    formula = compiled(lambda x, c: c * f(x) + f(2 * x))
    again = pickle.loads(pickle.dumps(formula))
    for x in (0.3, np.linspace(-0.5, 1.5, 9), mp.mpf(1) / 3, sympy.Rational(1, 3)):
        for run in (formula, again):
            assert close(run(x, 3.0), 3.0 * f(x) + f(2 * x), 1e-12)


def test_arrays_of_any_length_are_computed_without_heyoka():
    f = table(XS, YS)
    formula = compiled_by("heyoka", lambda x: f(x) + x)
    x = np.linspace(-1.0, 3.5, 100_003)
    assert np.allclose(formula(x), np.interp(x, XS, YS) + x, rtol=1e-14)
    assert f(np.zeros((0, 2))).shape == (0, 2)
    assert f(np.full((2, 3), 0.5)).shape == (2, 3)


def test_equal_tables_are_one_step_and_others_are_not():
    f, same, other = table(XS, YS), table(np.array(XS), tuple(YS)), table(XS, YS, "cubic")
    assert f == same
    assert hash(f) == hash(same)
    assert f != other != f.derivative()
    assert compiled(lambda x: f(x) - same(x) + other(x)).source.count("(x)") == 3  # one in its def
    assert copy.deepcopy(f) == pickle.loads(pickle.dumps(f)) == f


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize(
    "x", [-1.001, 3.5001, -1e300, float("inf"), float("nan"), mp.mpf(4), np.array([0.0, 4.0]), np.array([np.nan, 1.0])],
    ids=str,
)  # fmt: skip
def test_outside_it_has_no_value(kind, x):
    with pytest.raises(SingularError, match=r"a table from -1\.0 to 3\.5 has no value at"):
        table(XS, YS, kind)(x)


@pytest.mark.parametrize("kind", KINDS)
def test_outside_it_holds_its_ends_if_asked(kind):
    f = table(XS, YS, kind, outside="hold")
    assert (f(-9.0), f(-1.0), f(3.5), f(9.0)) == (2.0, 2.0, -3.0, -3.0)
    assert f(np.array([-9.0, 9.0])).tolist() == [2.0, -3.0]
    assert f.derivative()(9.0) == 0.0
    with pytest.raises(SingularError, match="nan"):
        f(float("nan"))


@pytest.mark.parametrize("kind", KINDS)
def test_a_place_outside_by_round_off_has_the_value_at_the_end(kind):
    f = table([0.0, 0.1, 0.3], [1.0, 2.0, 5.0], kind)
    assert close(f(0.1 + 0.2), 5.0)
    assert f(-1e-16) == pytest.approx(1.0)


@pytest.mark.parametrize(("arguments", "words"), [
    (([0, 1], [1, 2, 3]), "2 places and 3 values"),
    (([0, 1, 1], [1, 2, 3]), "increase; got 1 after 1"),
    (([0, 1], [1, float("nan")]), "values of a table are finite"),
    (([0, float("inf")], [1, 2]), "places of a table are finite"),
    (([0, 1], [1, 2j]), "finite real"),
    (([0, sympy.Symbol("a")], [1, 2]), "places of a table are numbers"),
    (([0, 1], [1, 2], "quintic"), "kind is one of 'linear', 'cubic'"),
    (([0, 1], [1, 2], "linear", "zero"), "outside is one of 'refuse', 'hold'"),
    (([0, 1], np.ones((2, 2))), "one number per place"),
])  # fmt: skip
def test_data_that_do_not_make_a_table_are_refused(arguments, words):
    with pytest.raises((TableError, ScalarError, ArgumentError), match=words):
        table(*arguments)


@pytest.mark.parametrize("kind", KINDS)
def test_whole_numbers_beyond_floats_are_refused_where_a_value_is_a_float(kind):
    huge = 10**400
    values, places = table([0, 1, 2, 3], [0, huge, 2, 3], kind), table([0, 1, huge], YS[:3], kind)
    for data, place in ((values, 0.5), (places, 0.5), (places, np.array([huge], dtype=object))):
        with pytest.raises(RangeError, match="too large"):
            data(place)
    if kind == "previous":
        assert values(1) == huge
    else:
        with pytest.raises(RangeError, match="too large"):
            values(1)

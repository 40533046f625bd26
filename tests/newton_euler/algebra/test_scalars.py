"""Numbers of every kind: the structural zero, functions, moving numbers against mpmath's
derivatives, dimensions.
"""

import copy
import math
import pickle
from fractions import Fraction

import mpmath
import numpy as np
import pytest
import sympy
from hypothesis import given
from hypothesis import strategies as st

from newton_euler import Dimension, Frame, at, atan2, compiled, moving, pi, radians, where
from newton_euler.algebra import (
    ZERO,
    DimensionError,
    LinearForm,
    Moving,
    ScalarError,
    is_numeric,
    is_zero,
    scalars,
)
from tests.kinds import KINDS, LENGTH, MASS, TIME, close, numbers


def symbol(library):
    return pytest.importorskip(library).Symbol("x")


EVERY_KIND = {
    "int": lambda: 3, "float": lambda: 1.5, "complex": lambda: 1j,
    "fraction": lambda: Fraction(1, 3), "numpy scalar": lambda: np.float64(1.5),
    "array": lambda: np.array([1.5, 2.5]), "empty array": lambda: np.array([]),
    "mpf": lambda: mpmath.mpf("0.1"), "sympy": lambda: symbol("sympy"),
    "symengine": lambda: symbol("symengine"), "dimension": lambda: Dimension(1, 1, -2),
    "moving": lambda: moving(1.5, 2.0, 3.0),
}  # fmt: skip


@pytest.fixture(params=EVERY_KIND)
def x(request):
    return EVERY_KIND[request.param]()


# -- the structural zero


def equal(a, b):
    if isinstance(a, Moving):
        return a._parts() == b._parts()
    return type(a) is type(b) and bool(np.all(a == b))


def test_zero_vanishes_from_sums_and_swallows_products_and_quotients(x):
    for total in (x + ZERO, ZERO + x, x - ZERO):
        assert equal(total, x)
    assert equal(ZERO - x, -x)
    for product in (x * ZERO, ZERO * x, ZERO / x):
        assert product is ZERO
    with pytest.raises(ZeroDivisionError, match="is divided by a structural zero"):
        x / ZERO


def test_zero_on_heyoka_expressions_folds_away():
    v = pytest.importorskip("heyoka").expression("x")
    assert str(v + ZERO) == str(ZERO + v) == "x"
    assert ZERO * v is ZERO
    assert str(v * ZERO).startswith("0.0")


def test_zero_and_zero():
    for same in (ZERO + ZERO, -ZERO, +ZERO, abs(ZERO), ZERO - ZERO, ZERO * ZERO, ZERO**2):
        assert same is ZERO
    assert ZERO**0 == 2.0**ZERO == 1
    assert (bool(ZERO), hash(ZERO), float(ZERO)) == (False, hash(0), 0.0)
    assert ZERO == 0
    for wrong, words in (
        (lambda: ZERO / ZERO, "0/0"),
        (lambda: ZERO**-1, "to the power -1"),
        (lambda: atan2(ZERO, ZERO), "direction of a zero vector"),
    ):
        with pytest.raises(ZeroDivisionError, match=words):
            wrong()


def test_there_is_one_zero_and_a_literal_zero_is_it():
    assert copy.deepcopy(ZERO) is ZERO
    assert pickle.loads(pickle.dumps(ZERO)) is ZERO
    assert scalars.scalar(0) is ZERO
    assert scalars.scalar(False) is ZERO
    assert scalars.scalar(0.0) is not ZERO
    assert scalars.scalar(True) is True
    assert scalars.to_plain(ZERO) == 0
    assert type(scalars.to_plain(ZERO)) is int


@pytest.mark.parametrize("name", scalars.FUNCTIONS)
def test_functions_of_zero_are_exact(name):
    if name == "log":
        with pytest.raises(ValueError, match=r".*"):
            scalars.function(name, ZERO)
        return
    value = scalars.function(name, ZERO)
    assert scalars.to_plain(value) == getattr(mpmath, name)(0) or name == "acos"
    assert (value is ZERO) == (name in ("sin", "tan", "asin", "atan", "sinh", "tanh", "sqrt"))


@pytest.mark.parametrize("bad", [
    "1", None, [1], (1, 2), {}, b"1", object(), np.array(["a"]), np.str_("a"),
    np.datetime64("2020-01-01"), np.ma.array([1.0, 2.0], mask=[0, 1]), np.ma.masked,
])  # fmt: skip
def test_what_is_not_a_number_is_refused_and_named(bad):
    with pytest.raises(ScalarError, match="expected a number") as error:
        scalars.scalar(bad)
    assert type(bad).__name__ in str(error.value)


@pytest.mark.parametrize("kind", sorted(EVERY_KIND.keys() - {"complex", "empty array"}))
def test_real_numbers_times_vectors_are_vectors_whatever_the_kind(kind):
    x = EVERY_KIND[kind]()
    v = Frame("ground").vector(1.0, 2.0, 0)
    for product in (x * v, v * x):
        assert hasattr(product, "frame")
        assert product.z == 0
    assert (ZERO * v).components() == (0, 0, 0)


# -- functions


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("name", scalars.FUNCTIONS)
def test_functions_on_every_kind_agree_with_mpmath(kind, name):
    u = numbers(kind, "0.4")
    exact = kind in ("mpmath", "sympy")
    results = np.atleast_1d(scalars.function(name, u))
    for value, result in zip(np.atleast_1d(u), results, strict=True):
        x = mpmath.mpf(4) / 10 if exact else mpmath.mpf(float(value))
        assert close(result, getattr(mpmath, name)(x), 1e-27 if exact else 1e-15)


@pytest.mark.parametrize("library", ["sympy", "symengine"])
@pytest.mark.parametrize("name", scalars.FUNCTIONS)
def test_functions_stay_symbolic_on_symbols(library, name):
    result = scalars.function(name, symbol(library))
    assert name in str(result) or name == "sqrt"
    assert type(result).__module__.startswith(library)


@pytest.mark.parametrize("number", [1, Fraction(1, 4), True, np.float32(0.5)])
def test_functions_take_whole_rational_and_complex_numbers(number):
    assert scalars.function("sqrt", number) == pytest.approx(math.sqrt(number))
    assert scalars.function("sin", 1j * number) == pytest.approx(1j * math.sinh(number))


@pytest.mark.parametrize(("name", "x"), [("sqrt", -1), ("log", -1), ("asin", 2), ("acos", -2)])
def test_of_real_numbers_there_are_real_values_or_none(name, x):
    for number in (float(x), mpmath.mpf(x)):
        with pytest.raises(ValueError, match="has no value: math domain error"):
            scalars.function(name, number)
    with pytest.raises(OverflowError, match="radians has no value here"):
        radians(10**400 * x)


@pytest.mark.parametrize(("y", "x", "expected"), [
    (0, -1, 1), (0, 1, 0), (1, 0, 0.5), (-1, 0, -0.5), (1, -1, 0.75), (-1, -1, -0.75),
])  # fmt: skip
@pytest.mark.parametrize("kind", KINDS)
def test_atan2_with_structural_zeros_lies_in_minus_pi_to_pi(kind, y, x, expected):
    """A structural zero above a negative x is +0.0: the angle is pi, not -pi."""
    y, x = (numbers(kind, v) if v else ZERO for v in (y, x))
    angle = atan2(y, x)
    assert close(angle if kind != "array" else angle[0], expected * pi(mpmath.mpf(1)), 1e-15)


def test_pi_and_radians_have_30_digits_in_mpmath():
    assert mpmath.mp.dps == 30
    with mpmath.workdps(40):
        exact = +mpmath.pi
    assert abs(pi(mpmath.mpf(1)) - exact) < 1e-29
    assert abs(radians(mpmath.mpf(30)) - mpmath.pi / 6) < 1e-30
    assert pi(sympy.Symbol("x")) is sympy.pi
    assert radians(sympy.Integer(30)) == sympy.pi / 6
    assert pi() == pi(1) == pi(np.zeros(3)) == pi(Dimension()) == math.pi
    assert radians(180) == math.pi
    assert abs(pi(moving(mpmath.mpf(1))) - exact) < 1e-29


def test_whole_numbers_take_the_kind_of_another():
    assert type(scalars.integer_like(3, mpmath.mpf(1))) is mpmath.mpf
    assert scalars.integer_like(3, sympy.Symbol("x")) == sympy.Integer(3)
    assert type(scalars.integer_like(3, 1.0)) is int
    assert scalars.integer_like(0.5, mpmath.mpf(1)) == 0.5


# -- questions about values


def test_questions_about_values():
    x = sympy.Symbol("x")
    for number in (1.0, np.zeros(2), sympy.Rational(1, 3), moving(1.0)):
        assert is_numeric(number)
    for other in (x, Dimension(), moving(x)):
        assert not is_numeric(other)
    assert is_zero(np.zeros(3))
    assert is_zero(mpmath.mpf(0))
    assert not is_zero(np.array([0.0, 1.0]))
    assert not is_zero(x)
    assert scalars.max_abs(np.array([-3.0, 2.0])) == 3.0
    assert scalars.max_abs(np.array([])) == 0.0
    assert scalars.min_abs(np.array([-3.0, 2.0])) == 2.0
    assert scalars.max_abs(moving(-2.0, 5.0)) == 2.0


def test_what_is_not_finite_is_seen_in_every_kind():
    for x in (
        math.nan, math.inf, np.array([1.0, np.nan]), np.array([np.inf]), mpmath.mpf("nan"),
        mpmath.inf, sympy.nan, sympy.oo,
    ):  # fmt: skip
        assert not scalars.is_finite(x), x
    for x in (
        1.0, 3, np.zeros(2), mpmath.mpf(1), sympy.Symbol("x"), sympy.Rational(1, 3), ZERO,
        Dimension(), moving(1.0),
    ):  # fmt: skip
        assert scalars.is_finite(x), x


# -- moving numbers

COMPOSITES = {
    "polynomial": lambda t: 3 * t**3 - t / 2 + 1,
    "negative power": lambda t: t**-2 + 1 / t,
    "fractional power": lambda t: (t * t + 1) ** 1.5 - t**0.5,
    "power of a power": lambda t: (t**2) ** 3 / (1 + t) ** 4,
    "constant to a moving power": lambda t: 2**t + 0.5 ** (t * t),
    "quotient of functions": lambda t: scalars.sin(t * t) / (1 + scalars.cos(3 * t) ** 2),
    "nested": lambda t: scalars.exp(-scalars.sqrt(1 + scalars.sinh(t) ** 2)) * scalars.tan(t / 3),
    "inverses": lambda t: (
        scalars.asin(t / 2) * scalars.acos(t / 3) + scalars.atan(t**2) - scalars.log(1 + t)
    ),
    "atan2 first quadrant": lambda t: scalars.atan2(scalars.sin(t), t),
    "atan2 second quadrant": lambda t: scalars.atan2(t * t, -1 - t),
    "atan2 third quadrant": lambda t: scalars.atan2(-t * t, -1 - t),
    "atan2 with a constant": lambda t: scalars.atan2(2.0, t) + scalars.atan2(t, 2),
    "atan2 with a structural zero": lambda t: scalars.atan2(ZERO, t) + scalars.atan2(t, ZERO),
    "first power": lambda t: t**1 + t**0 + t**1.0,
}


def is_differentiated(f, t, tolerance):
    """True if a number moving with t gives the value and two rates of f that mpmath finds."""
    with mpmath.workdps(60):
        expected = [
            +mpmath.diff(lambda x: scalars.to_plain(f(x)), mpmath.mpf(t), n) for n in range(3)
        ]
    found = map(scalars.to_plain, at(f, t)._parts())
    pairs = zip(found, expected, strict=True)
    return all(abs(x - y) < tolerance * max(1, abs(y)) for x, y in pairs)


@pytest.mark.parametrize("name", COMPOSITES)
@pytest.mark.parametrize("t", ["0.3", "1.1"])
def test_moving_numbers_against_mpmath_in_composites(name, t):
    tolerance = 1e-14 if "constant" in name or "fractional" in name else 1e-25
    assert is_differentiated(COMPOSITES[name], mpmath.mpf(t), tolerance)


@pytest.mark.parametrize("name", scalars.FUNCTIONS)
@pytest.mark.parametrize("t", ["0.05", "0.3", "0.8"])
def test_moving_numbers_against_mpmath_for_each_function(name, t):
    f = lambda t: scalars.function(name, t * t / 3 + t / 2)
    assert is_differentiated(f, mpmath.mpf(t), 1e-24)
    assert is_differentiated(f, float(t), 1e-13)


@given(st.floats(-0.999999999, 0.999999999))
def test_the_rate_of_asin_is_right_up_to_the_edge(u):
    """1 - u*u loses half the digits there; (1 - u)(1 + u) does not."""
    rate = scalars.function("asin", moving(u, 1.0)).rate
    with mpmath.workdps(40):
        expected = 1 / mpmath.sqrt(1 - mpmath.mpf(u) ** 2)
    assert abs(rate - expected) < 1e-14 * expected


def test_a_constant_has_no_rates_even_where_a_function_has_no_derivative():
    edges = ("sqrt", 0.0), ("asin", 1.0), ("acos", -1.0)
    for m in (moving(0.0) ** 0.5, *(scalars.function(name, moving(u)) for name, u in edges)):
        assert m.rate is ZERO
        assert m.acceleration is ZERO
    assert scalars.function("atan2", moving(0.0, 2.0), moving(1.0)).rate == 2.0


def test_the_magnitude_of_a_moving_number_has_the_rates_of_its_sign_and_none_at_zero():
    for u in (-2.0, 3.0, np.array([-2.0, 3.0]), mpmath.mpf(-2)):
        size, root = abs(Moving(u, 5.0, -7.0)), scalars.sqrt(Moving(u, 5.0, -7.0) ** 2)
        assert close(size._parts(), root._parts(), 1e-14)
    x = sympy.Symbol("x", real=True)
    assert abs(Moving(x, 2)).rate == 2 * x / abs(x)
    length, speed = Dimension(0, 1, 0), Dimension(0, 1, -1)
    assert abs(Moving(length, speed)).rate == speed
    assert compiled(lambda u, v: abs(Moving(u, v)).rate)(-2.0, 5.0) == -5.0
    assert abs(Moving(0.0)).value == 0
    with pytest.raises(ZeroDivisionError, match=r"abs\(x\) has no rate where x = 0"):
        abs(Moving(0.0, 1.0))


def test_moving_expressions_derive_their_rates_in_t():
    for library in ("sympy", "symengine"):
        lib = pytest.importorskip(library)
        t = lib.Symbol("t")
        m = moving(lib.sin(t) * 3)
        assert m.rate == 3 * lib.cos(t)
        assert m.acceleration == -3 * lib.sin(t)
        assert moving(lib.Symbol("a")).rate is ZERO
        assert moving(t, rate=lib.Integer(4)).rate == 4
    q = sympy.Function("q")(sympy.Symbol("t"))
    assert moving(q).acceleration == q.diff("t", 2)


@pytest.mark.parametrize(("wrong", "message"), [
    (lambda: moving(2.0, 1.0) ** moving(1.0, 1.0), "constant power only"),
    (lambda: moving(moving(1.0), rate=2.0), "already has its rates"),
    (lambda: moving(lambda t: t), r"pass at\(f, t\) instead of f"),
    *((lambda f=f: at(f, 1.0), "is not one value, which could be compared, rounded") for f in (
        math.sin, round, lambda t: t % 2, lambda t: t if t > 2 else 0, lambda t: t if t == 1 else 0,
    )),
    *((wrong, "expected a number") for wrong in (
        lambda: moving("1"), lambda: moving(1.0) + "1", lambda: LENGTH + "m", lambda: at(lambda t: (t, t), 1.0),
        *(lambda bad=bad: Frame("ground").i * bad for bad in ("2", None, [1.0])),
    )),
])  # fmt: skip
def test_moving_numbers_refuse_what_has_no_meaning(wrong, message):
    with pytest.raises(ScalarError, match=message):
        wrong()


def test_at_takes_constants_and_arrays_and_keeps_the_digits_of_an_mpf():
    assert tuple(map(scalars.to_plain, at(lambda t: 5.0, 1.0)._parts())) == (5.0, 0, 0)
    assert np.array_equal(at(lambda t: t**3, np.arange(3.0)).acceleration, [0.0, 6.0, 12.0])
    t, c = mpmath.mpf("0.9"), mpmath.mpf(0.8)
    found = at(lambda t: 0.3 * scalars.sin(0.8 * t), t)
    exact = -mpmath.mpf(0.3) * c * c * mpmath.sin(c * t)
    # with a rate of plain 1, 0.8*0.8 would be multiplied in floats
    assert abs(found.acceleration - exact) < 1e-28


# -- dimensions


def test_dimension_algebra():
    speed = LENGTH / TIME
    assert speed == Dimension(0, 1, -1)
    assert 2 * speed * TIME / 3 == LENGTH
    assert speed**2 == Dimension(0, 2, -2)
    assert (LENGTH**2) ** 0.5 == scalars.sqrt(LENGTH**2) == LENGTH
    assert (LENGTH**3) ** (1 / 3) == LENGTH
    assert (LENGTH**2) ** mpmath.mpf("0.5") == LENGTH
    assert Dimension(time=-1) == 1 / TIME
    assert -speed == +speed == abs(speed) == speed - speed == speed + speed == speed
    assert Dimension() == LENGTH / LENGTH
    assert Dimension() + 1.5 == 1.5 + Dimension() == Dimension()
    assert LENGTH + ZERO == LENGTH
    assert LENGTH * ZERO is LENGTH * 0 is 0 * LENGTH is 0 / LENGTH is ZERO
    assert sum([LENGTH, 2 * LENGTH]) == LENGTH  # which begins with the integer 0
    force = MASS * LENGTH / TIME**2
    assert (repr(force), str(force)) == ("Dimension(M^1 L^1 T^-2)", "kg m/s^2")
    assert [str(x) for x in (1 / TIME, 1 / (MASS * TIME), Dimension())] == [
        "1/s", "1/(kg s)", "a pure number",
    ]  # fmt: skip
    assert len({LENGTH, Dimension(0, 1, 0), TIME}) == 2
    assert LENGTH != 1
    assert 2 ** Dimension() == Dimension()
    assert Dimension() ** Dimension() == Dimension()
    assert atan2(LENGTH, LENGTH) == atan2(ZERO, LENGTH) == atan2(LENGTH, ZERO) == Dimension()
    assert (moving(Dimension()) ** Dimension()).value == Dimension()


@pytest.mark.parametrize(("wrong", "words"), [
    *((wrong, "cannot add .*: look at the units") for wrong in (
        lambda: LENGTH + TIME, lambda: LENGTH - 1.0, lambda: 1 + TIME,
        lambda: MASS + LENGTH * MASS, lambda: LENGTH + np.zeros(3),
        lambda: scalars.atan2(LENGTH, TIME), lambda: where(LENGTH > 0, LENGTH, TIME),
        lambda: moving(LENGTH, LENGTH / TIME) + moving(LENGTH, LENGTH), lambda: compiled(lambda v, g: v + g)(LENGTH, TIME),
    )),
    *((wrong, "its dimension would vary too") for wrong in (
        lambda: LENGTH ** Dimension(), lambda: moving(LENGTH) ** Dimension(),
    )),
    (lambda: 2**LENGTH, "be a pure number"),
    (lambda: where(LENGTH > TIME, LENGTH, LENGTH), "cannot compare m with s"),
    (lambda: where(LENGTH > 1.0, LENGTH, LENGTH), r"cannot compare .* with 1\.0"),
    (lambda: max(LENGTH, 2 * LENGTH), r"choose by where\(x < y, a, b\)"),
])  # fmt: skip
def test_unlike_dimensions_are_refused(wrong, words):
    with pytest.raises(DimensionError, match=words):
        wrong()


@pytest.mark.parametrize("name", [n for n in scalars.FUNCTIONS if n != "sqrt"])
def test_functions_take_pure_numbers_only(name):
    with pytest.raises(DimensionError, match=rf"{name} of a quantity in m: .* be a pure number"):
        scalars.function(name, LENGTH)
    assert scalars.function(name, Dimension()) == Dimension()


def test_a_choice_between_like_quantities_has_their_dimension():
    assert where(LENGTH > 2 * LENGTH, LENGTH, 3 * LENGTH) == LENGTH
    assert where(LENGTH > 0, TIME, 0) == TIME
    assert where(LENGTH >= 0, 0, TIME) == TIME
    assert where(Dimension() < 1.5, 1.0, 2.0) == 1.0
    assert where(LENGTH < LENGTH, "rises", "falls") in ("rises", "falls")


@pytest.mark.parametrize("name", scalars.FUNCTIONS)
def test_a_function_of_no_numbers_is_refused(name):
    with pytest.raises(ScalarError, match="which is empty"):
        scalars.function(name, np.zeros((0, 3)))


@pytest.mark.parametrize("other", [1j, np.array([1j]), np.zeros(0), mpmath.mpc(0, 1)])
def test_quantities_of_mechanics_take_no_complex_numbers_and_no_empty_arrays(other):
    ground = Frame("ground")
    for quantity in (ground.vector(1.0, 2.0, 3.0), Dimension(1, 1, -2), LinearForm(2.0, (1.0,))):
        for operation in (lambda a, b: a * b, lambda a, b: a / b):
            with pytest.raises(ScalarError, match="expected"):
                operation(quantity, other)
    with pytest.raises(ScalarError, match=r"one real number|which is empty"):
        scalars.allowed(other)

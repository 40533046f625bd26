"""A formula traced once computes what the formula itself computes, on every kind of number and with
every backend.
"""

import importlib.util
import math
import statistics
import threading
from concurrent.futures import ThreadPoolExecutor
from fractions import Fraction

import mpmath
import numpy as np
import pytest
import sympy

from newton_euler import (
    Dimension,
    Frame,
    acos,
    asin,
    at,
    atan,
    atan2,
    compiled,
    cos,
    cosh,
    exp,
    log,
    moving,
    pi,
    radians,
    sin,
    sinh,
    sqrt,
    table,
    tan,
    tanh,
    where,
)
from newton_euler.algebra import ZERO, Moving, ScalarError
from newton_euler.algebra.compile import BLOCK
from newton_euler.algebra.scalars import FUNCTIONS, DivisionError
from newton_euler.algebra.trace import Step
from tests.kinds import KINDS, close, compiled_by, numbers

FORMULAS = {
    "arithmetic": lambda x, y: (x + y) * (x - y) / (3 + x * y) - 2 * x + y / 5 - 1,
    "negations": lambda x, y: -x + -(y - x) - (-(x * y)),
    "quotients of negations": lambda x, y: (
        (-x) / y + 2 * (x / (-y)) + 4 * ((-x) / (-y)) + 8 / (-x) + (-y) / 16
        + 3 * ((-x) * (-y) * (-2))
    ),
    "sums of negations": lambda x, y: (
        ((-x) + y) * 2 + (x + (-y)) * 3 + ((-x) - y) * 5 + (x - (-y)) * 7 + (1 - (-x)) * 11
        + (1 + (-y)) * 13
    ),
    "odd and even": lambda x, y: (
        sin(-x) + 2 * cos(-x) + tan(-y) + cosh(-y) + sinh(-x) - tanh(-y) + asin(-x / 2) + atan(-x)
        + acos(-x / 2) + exp(-x)
    ),
    "powers": lambda x, y: (x**2 + x**3 - y**-1 + (1 + x) ** -2 + (x * x + y) ** 0.5 + y**1.5 + x**1 + x**0),
    "rational powers": lambda x, y: (x + y) ** (1 / 3) + 2.0**x - 3 ** (y / 2),
    "circular": lambda x, y: (
        sin(x) * cos(y) + tan(x * y) - asin(x / 3) + acos(y / 3) + atan(x - y) + atan2(y, x)
        + atan2(-y, -x)
    ),
    "hyperbolic": lambda x, y: sinh(x) + cosh(y) - tanh(x * y) + exp(-x) * log(1 + y) + sqrt(x + y),
    "pi": lambda x, y: pi(x) * x + radians(y),
    "structural zeros": lambda x, y: (ZERO * x + (y - ZERO) + ZERO / x + (ZERO - x) + atan2(ZERO, x) + atan2(y, ZERO)),
    "constants": lambda x, y: (
        1e-300 * x + 1.5e300 * y * 1e-300 + np.float64(1.5) * x - y * np.int64(2)
        + Fraction(1, 4).numerator * x
    ),
    "moving inside": lambda x, y: (lambda m: m.value + m.rate - m.acceleration)(
        at(lambda t: sin(x * t) * t**2 + atan2(t, y), 0.5 * y)
    ),
    "long": lambda x, y: sum((sin(n * x) / n * y**2 for n in range(1, 60)), start=ZERO),
    "unused argument": lambda x, y: x * x,
    "constant": lambda x, y: 4.0 + 0 * x,
}  # fmt: skip


@pytest.fixture(params=FORMULAS)
def formula(request):
    return FORMULAS[request.param]


@pytest.fixture
def backend(request):
    """The name of a backend that is installed."""
    if request.param == "heyoka":
        pytest.importorskip("heyoka")
    return request.param


def with_backends(*names):
    return pytest.mark.parametrize("backend", names, indirect=True)


# -- the same values


@pytest.mark.parametrize("kind", KINDS)
def test_compiled_is_direct_on_every_kind(formula, kind):
    x, y = numbers(kind, "0.4", "1.3")
    direct = formula(x, y)
    if kind == "array":
        direct = np.broadcast_to(direct, 3)
    tolerance = {"sympy": 1e-15, "mpmath": 1e-28}.get(kind, 1e-13)
    assert close(compiled(formula)(x, y), direct, tolerance)


def test_every_shape_of_arrays_and_numbers_that_broadcast(formula):
    f = compiled(formula)
    grid = np.linspace(0.1, 1.2, 6)
    for x, y in [
        (grid, grid[::-1]), (grid, 0.7), (0.3, grid), (grid.reshape(2, 3), 0.7), (grid.reshape(6, 1), grid), (grid[::2], grid[1::2]),
        (np.array(0.4), np.array(0.5)), (np.array(0.4), grid), (np.float64(0.4), 0.5), (grid[:1], grid), (grid.reshape(2, 3).T, 0.2),
    ]:  # fmt: skip
        got = f(x, y)
        direct = np.broadcast_to(formula(x, y), np.broadcast_shapes(np.shape(x), np.shape(y)))
        assert np.shape(got) == direct.shape
        assert isinstance(got, np.ndarray) == (direct.shape != ())
        assert np.allclose(got, direct, rtol=1e-13, atol=1e-13)


def test_whole_numbers_as_arguments():
    f = compiled(lambda x, y: x / y + sqrt(x))
    assert f(9, 2) == f(9.0, 2.0) == 7.5
    assert f(np.array([9, 4]), 2).tolist() == [7.5, 4.0]
    assert compiled(lambda x: x * x)(np.array([4 * 10**9])).tolist() == [1.6e19]  # no int64
    assert f(True, 2.0) == 1.5
    assert f(Fraction(9), Fraction(2)) == 7.5


def test_a_choice_is_the_one_of_its_comparison():
    f = compiled(lambda x, y: where(x < y, x, 10 * y) + where(x >= y, 100.0, 200 * x))
    assert (f(1.0, 2.0), f(2.0, 1.0)) == (201.0, 110.0)
    assert f(np.array([1.0, 2.0]), np.array([2.0, 1.0])).tolist() == [201.0, 110.0]
    # of one number at a time the other branch is not taken
    assert compiled(lambda x: where(x > 0, 1 / x, 0.0) + x * x)(0.0) == 0.0


@with_backends("auto", "numpy", "heyoka")
def test_empty_arrays_give_empty_arrays(backend):
    f = compiled_by(backend, lambda x: (sin(x), x * x))
    assert [r.shape for r in f(np.array([]))] == [(0,), (0,)]
    assert [r.shape for r in f(np.zeros((3, 0)))] == [(3, 0), (3, 0)]


def test_arrays_longer_than_a_block_join_without_a_seam():
    t = np.linspace(0, 10, 3 * BLOCK + 17)
    f = compiled(lambda t, a: (sin(a * t), 2.0, ZERO))
    wave, two, zero = f(t, 3.0)
    assert np.allclose(wave, np.sin(3 * t), atol=1e-14)
    assert two.shape == zero.shape == t.shape
    assert set(two) == {2.0}
    assert set(zero) == {0.0}


@with_backends("auto", "numpy", "heyoka")
def test_backends_agree(formula, backend):
    rng = np.random.default_rng(1)
    x, y = rng.uniform(0.1, 1.4, (2, 1000))
    got = compiled_by(backend, formula)(x, y)
    assert np.allclose(got, np.broadcast_to(formula(x, y), 1000), rtol=1e-13, atol=1e-13)


def test_auto_turns_to_heyoka_only_when_it_pays(monkeypatch):
    pytest.importorskip("heyoka")
    f = compiled(lambda x: sin(x) + x)
    monkeypatch.setattr(
        "newton_euler.algebra.compile.HEYOKA_BREAK_EVEN", {True: 3000, False: math.inf}
    )
    x = np.linspace(0, 1, 1000)
    first = f(x)
    assert f._heyoka is None
    f(x), f(x)
    assert f._buffer is not None  # heyoka has written into it
    assert np.allclose(f(x), first, atol=1e-15)


def test_symengine_and_heyoka_expressions_as_arguments():
    symengine, hy = pytest.importorskip("symengine"), pytest.importorskip("heyoka")
    f = compiled(lambda x, y: sin(x) * y + atan2(y, x) + pi(x))
    x = symengine.Symbol("x")
    assert float(f(x, 2.0).subs({x: 0.5})) == pytest.approx(f(0.5, 2.0))
    v = hy.expression("v")
    assert hy.cfunc([f(v, 2.0)], vars=[v])([0.5])[0] == pytest.approx(f(0.5, 2.0))


def test_moving_arguments_carry_their_rates_through_with_30_digits():
    x, y = moving(0.4, 1.0, 2.0), moving(1.3, -0.5, 0.25)
    for name in FORMULAS.keys() - {"moving inside"}:
        got, direct = compiled(FORMULAS[name])(x, y), FORMULAS[name](x, y)
        assert close(got._parts(), direct._parts(), 1e-12), name
    got = compiled(lambda n, x: pi(x) * x * n)(2, moving(mpmath.mpf(1), mpmath.mpf(2)))
    assert abs(got.rate - 4 * mpmath.pi) < 1e-28


def test_dimensions_run_through_and_are_checked():
    f = compiled(lambda v, g: v**2 / (2 * g))
    m_s, m_s2 = Dimension(0, 1, -1), Dimension(0, 1, -2)
    assert f(m_s, m_s2) == Dimension(length=1)


# -- how the steps are simplified


def test_steps_that_are_common_or_not_needed_are_computed_once_or_never():
    f = compiled(lambda x, y: (sin(x * y) + 1) * (sin(y * x) + 2) - sin(x * y))
    assert f.source.count("sin(") == 1
    assert f.operations == 6  # x*y, sin, +1, +2, *, -

    def wasteful(x):
        exp(x) * 3 - log(x)
        return x * x

    f = compiled(wasteful)
    assert "exp" not in f.source
    assert f.operations == 1
    assert f(-1.0) == 1.0  # log(-1) is never taken
    f = compiled(lambda x, y, z: (x * x, sin(x) + y, 2.0))
    assert f.dependencies == [{"x"}, {"x", "y"}, set()]


def test_constants_fold_and_neutral_operations_vanish():
    f = compiled(lambda x: 2 * 3 * (x * 1 + 0) / 1 + x**1 - 0.0 + ZERO - (-1 * (-x)) * 1.0)
    assert f.operations == 3
    assert "6" in f.source
    assert compiled(lambda x: -1 * x).source.count("*") == 0
    assert compiled(lambda x: x + 0).operations == compiled(lambda x: x - ZERO).operations == 0
    for turned, plain in (
        (lambda x, y: cos(-x), lambda x, y: cos(x)),
        (lambda x, y: -sin(-x), lambda x, y: sin(x)),
        (lambda x, y: x - (-y), lambda x, y: x + y),
        (lambda x, y: x + (-y), lambda x, y: x - y),
        (lambda x, y: where(x < y, y, y), lambda x, y: y),
        (lambda x, y: x**ZERO + y, lambda x, y: 1 + y),
    ):
        assert compiled(turned).source == compiled(plain).source


def test_the_explanation_shows_the_lines():
    f = compiled(lambda v, elevation, g: (v * sin(elevation)) ** 2 / (2 * g))
    assert f.source.startswith("def formula(v, elevation, g):\n    s0 = v * (sin(elevation))\n")
    assert repr(f) == "<compiled <lambda>(v, elevation, g), 5 operations>"


@with_backends("numpy", "heyoka")
def test_dicts_tuples_vectors_and_nests_of_them_come_back(backend):
    def f(x):
        ground = Frame("ground")
        pair = (x, [x * x, {"deep": 3}])
        return {"v": ground.vector(x, 0, 2 * x), "pair": pair, "n": 1, "none": ()}

    g = compiled_by(backend, f)
    assert g(2.0) == {"v": (2.0, 0, 4.0), "pair": (2.0, (4.0, {"deep": 3})), "n": 1, "none": ()}
    many = g(np.array([2.0, 3.0]))
    assert many["v"][2].tolist() == [4.0, 6.0]
    assert many["pair"][1][1]["deep"].tolist() == [3.0, 3.0]


def test_matrices_of_components_come_back_as_nested_tuples():
    assert compiled(lambda x: np.array([[x, 2 * x], [1, 0]]))(3.0) == ((3.0, 6.0), (1, 0))
    rotation = compiled(lambda q: (g := Frame("ground")).rotate("a", "z", q).rotation(g))
    c, s = math.cos(0.3), math.sin(0.3)
    assert rotation(0.3) == ((c, -s, 0), (s, c, 0), (0, 0, 1))


# -- constants of every kind inside a formula

third = mpmath.mpf(1) / 3


@pytest.mark.parametrize("constant", [
    1e-300, -0.0, -2.5, 1.7976931348623157e308, 5e-324, 2**70, -3, np.float64(1.5),
    np.float32(0.1), np.int64(7), True, Fraction(1, 3),
])  # fmt: skip
def test_constants_survive_to_the_last_bit(constant):
    f = compiled(lambda x: (x * constant, x / 1 + constant, constant))
    product, total, alone = f(1.25)
    assert product == 1.25 * float(constant)
    assert total == 1.25 + float(constant)
    assert float(alone) == float(constant)
    assert math.copysign(1, float(alone)) == math.copysign(1, float(constant))


def test_infinite_undefined_and_negative_constants_survive():
    f = compiled(lambda x: (x * math.inf, x - math.inf, x * math.nan, math.inf))
    a, b, c, d = f(2.0)
    assert (a, b, d) == (math.inf, -math.inf, math.inf)
    assert math.isnan(c)
    assert f(np.array([2.0]))[0].tolist() == [math.inf]
    f = compiled(lambda x: (atan2(x, 0.0), atan2(x, -0.0), atan2(0.0, x), atan2(-0.0, x)))
    assert f(-1.0) == (-math.pi / 2, -math.pi / 2, math.pi, -math.pi)


def test_constants_keep_their_digits_and_kind_and_symbols_may_be_some():
    f = compiled(lambda x: x * third)
    assert abs(f(mpmath.mpf(3)) - 1) < 1e-29
    assert type(f(3.0)) is float
    assert f(np.array([3.0, 6.0])).tolist() == [1.0, 2.0]
    g = compiled(lambda x: x * (third + mpmath.mpf("1e-28")) - x * third)
    assert 0.9e-28 < g(mpmath.mpf(1)) < 1.1e-28
    x = sympy.Symbol("x")
    broken, exact = compiled(lambda y: (y / 2.0, y / 2))(x)
    assert exact == x / 2
    assert broken.has(sympy.Float)
    k = sympy.Symbol("k")
    f = compiled(lambda x: x * k + sympy.Rational(1, 3))
    x = sympy.Symbol("x")
    assert f(x) == x * k + sympy.Rational(1, 3)
    assert f(2.0).subs(k, 3) == pytest.approx(6 + 1 / 3)
    with pytest.raises(ScalarError, match="pass it as an argument"):
        compiled(lambda x, m: m * x, m=np.array([1.0, 2.0]))


def test_arguments_may_be_fixed_by_default_or_by_name_or_absent():
    f = compiled(lambda x, n, f: f * x**n, n=3, f=np.float64(0.5))
    assert f.parameters == ["x"]
    assert f(2.0) == 4.0
    with pytest.raises(TypeError, match="has no argument 'm'"):
        compiled(lambda x: x, m=3)
    f = lambda x, /, y=2.0, *, z=3.0: x + 10 * y + 100 * z
    g = compiled(f)
    assert g(1.0) == f(1.0)
    assert g(1.0, z=4.0) == f(1.0, z=4.0)
    assert g(1.0, 5.0, 6.0) == f(1.0, 5.0, z=6.0)
    assert compiled(lambda: 2.0)() == 2.0
    assert compiled(lambda x: ())(1.0) == ()


@pytest.mark.parametrize("names", [
    "s0, s1", "c0, c1", "pi, sin", "formula, space", "atan2, e", "_s0, s0", "x, args", "pow, x",
    "pi, pi_", "self, x", "f, where_",
])  # fmt: skip
def test_names_of_arguments_do_not_collide_with_names_inside(names):
    a, b = names.split(", ")
    # third is a constant that needs a name of its own
    scope = {"sine": sin, "pi_of": pi, "third": third}
    f = eval(
        f"lambda {names}: (sine({a} * {b}) * ({a} * {b}) + pi_of({a}) * third, {a} + {b})", scope
    )
    got = compiled(f)(**{b: np.float64(0.7), a: 0.5})
    assert {*map(type, got)} == {float}  # not by NumPy, which takes six times as long
    assert got == pytest.approx((math.sin(0.35) * 0.35 + math.pi / 3, 1.2))
    assert compiled(f)(np.array([0.5]), np.array([0.7]))[0] == pytest.approx(got[0])


# -- errors in words


@pytest.mark.parametrize(("call", "message"), [
    (lambda f: f(1.0), "f takes x, y; missing: y"),
    (lambda f: f(1.0, 2.0, 3.0), "f takes x, y; left over: 3.0"),
    (lambda f: f(1.0, 2.0, z=3.0), "f takes x, y; unknown: z"),
    (lambda f: f(1.0, 2.0, x=3.0), "f takes x, y; given twice: x"),
    (lambda f: f(1.0, yy=3.0), "f takes x, y; missing: y; unknown: yy"),
])  # fmt: skip
def test_wrong_arguments_are_reported_by_name(call, message):
    def f(x, y):
        return x + y

    with pytest.raises(TypeError) as error:
        call(compiled(f))
    assert str(error.value) == message


@pytest.mark.parametrize(("args", "message"), [
    *(((bad, 1.0), "expected a number")
      for bad in ("1", None, [1.0, 2.0], (1.0,), Frame("g").i, np.array(["a"]))),
    ((np.zeros(3), np.zeros(4)), r"shapes that do not fit together: x \(3,\), y \(4,\)"),
    *(((bad, 1.0), "takes arrays of real numbers, got")
      for bad in (np.array([1j]), np.array([mpmath.mpf(1)], dtype=object))),
])  # fmt: skip
def test_arguments_other_than_real_numbers_of_one_shape_are_refused(args, message):
    with pytest.raises(ScalarError, match=message):
        compiled(lambda x, y: x + y)(*args)


def of_argument(f, *others):
    return lambda x: f(x, *others)


@pytest.mark.parametrize("branching", [
    lambda x: x if x else 0.0,
    lambda x: 1.0 if x > 0 else -1.0,
    lambda x: 1.0 if x == 0 else x,
    lambda x: max(x, 0.0),
    lambda x: 0.0 if x in (0.0, 1.0) else x,
    lambda x: float(x),
    *(of_argument(getattr(m, n)) for m in (math, np) for n in FUNCTIONS),
    *map(of_argument, (np.abs, np.sign)),
    *(of_argument(f, 1.0) for f in (math.atan2, np.atan2, np.maximum, np.hypot, np.add)),
    lambda x: np.where(x > 0, x, 0.0),
    lambda x: np.sqrt(np.array([x, 1.0])),
])  # fmt: skip
def test_a_formula_must_not_branch_on_values_nor_use_math_or_numpy(branching):
    advice = r"takes sin, cos, sqrt \.\.\. from newton_euler, not from math or numpy"
    with pytest.raises(TypeError, match=rf"must not branch on them .*, and {advice}"):
        compiled(branching)


@pytest.mark.parametrize(("f", "error", "message"), [
    *((f, ScalarError, "returns scalars, Vectors, or tuples and dicts of them, got") for f in (
        lambda x: None, lambda x: "text", lambda x: (x, None), lambda x: Frame("g"),
        lambda x: Frame("g").point("P", x, 0, 0),
    )),
    (lambda x: x / ZERO, ZeroDivisionError, "is divided by a structural zero"),
    (lambda x: x + "1", ScalarError, "expected a number"),
    (lambda x: x * np.array([1.0, 2.0]), ScalarError, "pass it as an argument"),
    (lambda x: compiled(lambda y: x * y)(2.0), ScalarError,
     "a value of another formula is used here"),
    *((f, TypeError, "names all its arguments") for f in (lambda *x: x[0], lambda **x: 1.0)),
    (max, ScalarError, "names its arguments: no signature"),
])  # fmt: skip
def test_what_cannot_be_compiled_is_refused_while_tracing(f, error, message):
    with pytest.raises(error, match=message):
        compiled(f)


def test_without_heyoka_and_of_tables_arrays_go_by_numpy(monkeypatch):
    monkeypatch.setattr("newton_euler.algebra.compile.HEYOKA_BREAK_EVEN", {True: 0, False: 0})
    for f in (compiled(table([0.0, 9.0], [1.0, 10.0])), compiled(lambda x: x + 1)):
        assert f(np.array([1.0, 2.0])).tolist() == [2.0, 3.0]
        assert f._heyoka is None
        monkeypatch.setattr(importlib.util, "find_spec", lambda name, *a: None)


def test_warnings_of_numpy_are_not_hidden():
    with pytest.warns(RuntimeWarning, match="divide by zero"):
        assert compiled(lambda x: 1 / x)(np.array([0.0]))[0] == math.inf


def test_results_through_heyoka_are_not_touched_by_the_next_call_nor_by_other_lengths():
    """Blocks pass through a buffer that is kept between calls."""
    pytest.importorskip("heyoka")
    f = compiled_by("heyoka", lambda x, a: (x * a, x + a))
    lengths = (5, 1 << 15, (1 << 15) + 7, 5)
    inputs = [np.linspace(0.0, 1.0 + n, length) for n, length in enumerate(lengths)]
    results = [f(x, 2.0) for x in inputs]
    for x, (product, total) in zip(inputs, results, strict=True):
        assert np.array_equal(product, 2.0 * x)
        assert np.array_equal(total, x + 2.0)


# -- several threads, and one formula on several kinds of number


class Paused(Moving):
    """A moving number whose products wait until the other thread has come as far."""

    barrier = threading.Barrier(2, timeout=10)

    def __mul__(self, other):
        self.barrier.wait()
        return super().__mul__(other)


def in_two_threads(*calls):
    with ThreadPoolExecutor(2) as pool:
        return [future.result() for future in [pool.submit(call) for call in calls]]


def test_two_threads_each_have_their_own_pi():
    f = compiled(lambda x: x * x + pi(x))
    precise, rounded = in_two_threads(
        lambda: f(Paused(mpmath.mpf(1))).value, lambda: f(Paused(1.0)).value
    )
    assert abs(precise - 1 - mpmath.pi) < 1e-28
    assert type(rounded) is float


def test_two_threads_trace_one_formula_inside_others(monkeypatch):
    barrier, multiply = threading.Barrier(2, timeout=10), Step.__mul__

    def paused(self, other):
        barrier.wait()
        return multiply(self, other)

    inner = compiled(lambda x: x * x * pi(x))
    monkeypatch.setattr(Step, "__mul__", paused)
    two, three = in_two_threads(
        lambda: compiled(lambda y: inner(2.0 + y)), lambda: compiled(lambda y: inner(3.0 + y))
    )
    assert two(0.0) == inner(2.0)
    assert three(0.0) == inner(3.0)


def test_pi_inside_a_moving_number_that_is_traced_keeps_its_digits():
    inner = compiled(lambda x: pi(x) * x)
    assert abs(compiled(lambda y: inner(moving(y, 1.0)).value)(mpmath.mpf(1)) - mpmath.pi) < 1e-28


@pytest.mark.parametrize("f", [
    lambda x: x.real_part, lambda x: {1: 2}[x], lambda x: x @ x, mpmath.sin, Fraction,
    lambda x: statistics.pstdev([x, 1.0]), lambda x: np.linalg.inv([[x, 1.0], [1.0, 2.0]])[0, 0],
])  # fmt: skip
def test_what_a_traced_value_does_not_have_is_refused_with_the_line(f):
    with pytest.raises(ScalarError, match=r"in .*: a formula is traced without values"):
        compiled(lambda x: f(x))


@pytest.mark.parametrize(
    ("f", "error"),
    [
        (lambda x: (x, 2.0)[5], IndexError),
        (lambda x: x * statistics.mean([]), statistics.StatisticsError),
        (lambda x: x * np.linalg.inv(np.zeros((2, 2)))[0, 0], np.linalg.LinAlgError),
    ],
)
def test_what_a_formula_raises_of_itself_is_raised_as_it_is(f, error):
    with pytest.raises(error) as found:
        compiled(f)
    assert type(found.value) is error


def test_without_a_value_of_mpmath_the_arguments_are_named():
    with pytest.raises(DivisionError, match=r"<lambda> has no value: x = mpf\('0\.0'\): "):
        compiled(lambda x: 1 / x)(mpmath.mpf(0))

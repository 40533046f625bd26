"""The record of a scene's equations of motion: its answers over every kind of number, and its
refusals in words.
"""

import math
import pickle
import random
import time
from dataclasses import FrozenInstanceError
from statistics import fmean
from types import SimpleNamespace

import mpmath as mp
import numpy as np
import pytest
import sympy
from scipy import interpolate

from newton_euler import Dimension, cos, exp, integrate, sin, table, where
from newton_euler.algebra import ZERO
from newton_euler.algebra.scalars import RangeError
from newton_euler.motion.model import (
    Model,
    ModelError,
    comparable,
    has_unit,
    is_absent,
    real_numbers,
    second_order,
)
from tests.kinds import KINDS, close, numbers


def oscillator(m=2.0, k=8.0, **more):
    return second_order(
        "oscillator", {"m": m, "k": k}, ("x",), lambda s, p, t: (-p.k * s.x / p.m,),
        invariants={"energy": lambda s, p, t: (p.m * s.dx**2 + p.k * s.x**2) / 2}, **more,
    )  # fmt: skip


# -- answers


@pytest.mark.parametrize("kind", KINDS)
def test_derivative_over_every_kind_of_number(kind):
    m, k, x, v = numbers(kind, 2, 8, "0.3", "-0.7")
    model = oscillator(m, k)
    wanted = (v, -k * x / m)
    assert close(model.derivative((x, v)), wanted, 0)
    assert close(model.derivative({"dx": v, "x": x}), wanted, 0)
    assert close(model.invariant("energy", (x, v)), (m * v * v + k * x * x) / 2, 1e-14)


def test_derivative_of_symbols_and_dimensions():
    m, k, x, v = sympy.symbols("m k x v")
    assert oscillator(m, k).derivative((x, v)) == (v, -k * x / m)
    length, time = Dimension(0, 1, 0), Dimension(0, 0, 1)
    model = oscillator(Dimension(1), Dimension(1, 0, -2))
    assert model.derivative((length, length / time)) == (length / time, length / time**2)


def test_compiled_with_parameters_fixed_or_free():
    model = oscillator()
    assert model.compiled_rhs()(0.0, 0.5, 1.0) == (1.0, -2.0)
    free = model.compiled_rhs("k")
    assert free.parameters == ["t", "x", "dx", "k"]
    assert free(0.0, 0.5, 1.0, 16.0) == (1.0, -4.0)
    assert close(free(0.0, np.array([0.5, 1.0]), 1.0, 16.0)[1], np.array([-4.0, -8.0]), 0)
    third = free(mp.mpf(0), mp.mpf(1) / 3, mp.mpf(1), mp.mpf(16))
    assert close(third, (1, mp.mpf(-8) / 3), mp.mpf(10) ** -29)


def test_laws_see_states_parameters_and_time():
    rocket = Model("rocket", {"m0": 10.0, "burn": 0.5, "thrust": lambda s, p, t: p.m0 * 20 - 3 * t + s.v}, ("v",),
                   lambda s, p, t: (p.thrust / (p.m0 - p.burn * t),))  # fmt: skip
    assert rocket.derivative((4.0,), 2.0) == ((200 - 6 + 4) / 9,)
    assert rocket.compiled_rhs()(2.0, 4.0) == ((200 - 6 + 4) / 9,)
    assert rocket.changed(thrust=90.0).derivative((4.0,), 2.0) == (10.0,)
    assert rocket.changed(thrust=lambda s, p, t: 18.0).derivative((4.0,), 2.0) == (2.0,)


def test_changed_leaves_the_model_as_it_was():
    model = oscillator()
    assert model.changed(k=2.0).derivative((1.0, 0.0)) == (0.0, -1.0)
    assert model.parameters["k"] == 8.0
    with pytest.raises(FrozenInstanceError):
        model.name = "other"
    with pytest.raises(TypeError):
        model.parameters["k"] = 2.0
    assert repr(model) == "Model('oscillator': x, dx; m, k)"
    odd = Model("odd", {"self": 1.0}, ("_what",), lambda s, p, t: (p.self * s._what,))
    assert odd.changed(self=3.0).derivative((2.0,)) == (6.0,)


def test_an_exact_solution_is_over_every_kind_of_number_and_an_invariant_stays():
    def swing(s, p, t):
        w = (p.k / p.m) ** 0.5
        return s.x * cos(w * t) + s.dx / w * sin(w * t), s.dx * cos(w * t) - w * s.x * sin(w * t)

    model, t = oscillator(exact=swing), np.linspace(0.0, 2.0, 5)
    x, v = model.solution(t, (1.0, 2.0))
    c, s = np.cos(2 * t), np.sin(2 * t)
    assert close((x, v), (c + s, 2 * c - 2 * s), 1e-14)
    assert close(model.invariant("energy", (x, v)), 8.0 + 0 * t, 1e-14)
    third = mp.mpf(1) / 3
    assert close(model.solution(third, (mp.mpf(1), 0))[0], mp.cos(2 * third), mp.mpf(10) ** -29)


# -- refusals


def rhs(s, p, t):
    return s.v, -p.g


@pytest.mark.parametrize(("parameters", "states", "rates", "words"), [
    ({"g": 9.81}, "hv", lambda s, p, t: (s.v,), "returns 1 rates for the 2 states h, v"),
    ({"G": 9.81}, "hv", rhs, "fails when it is tried: there is no parameter 'g'; there are G"),
    ({"g": 9.81}, "hw", rhs, "fails when it is tried: there is no state 'v'; there are h, w"),
    ({"g": 9.81}, "hv", lambda s, p, t: (s.v, -p.g if s.h > 0 else 0), "a formula is traced without values: it must not branch"),
    ({"g": 9.81}, "hv", lambda s, p, t: (s.v, "down"), "returns scalars, Vectors, or tuples"),
    ({"g": 9.81}, "hv", lambda s, p, t: None, "returns the rates of its states, a tuple in the order h, v; got one NoneType"),
    ({"g": 9.81}, "hv", lambda s, p, t: (s.v, 1j * s.h), "takes real numbers, got 1j"),
    ({"g": 9.81}, "hv", lambda s, p, t: (setattr(s, "v", 0), s.v), "the states are only read, but 'v' was set"),
    ({"g": 9.81}, "hv", lambda s, p, t: (s.v, 1 / ZERO), "fails when it is tried"),
    ({"g": "9.81"}, "hv", rhs, r"the parameter g of 'fall' is a number or a function \(s, p, t\), not '9.81'"),
    ({"g": 9.81}, "hv", lambda s, p, t: (s.v, -np.array(s).sum()), r"the states are read by name, as s\.h, s\.v"),
    ({"g": 9.81}, "hg", rhs, "'g' occurs twice in 'fall'"),
    ({"g": 9.81}, "hv", lambda s, p, t: {s.v, -p.g}, "a tuple in the order h, v; got one set"),
    ({"g": 9.81}, ["h", "ﬁ"], rhs, "'ﬁ' cannot name a state or parameter"),
    ({"g": lambda t: 9.81}, "hv", rhs, r"the parameter g of 'fall' is a number or a function \(s, p, t\)"),
    ({"g": interpolate.interp1d([0, 1], [9, 9])}, "hv", rhs, r"make a table\(ts, values\), for p\.g\(t\)"),
    ({"g": 1j}, "hv", rhs, "give its real part"),
    ({"g": [9.8]}, "hv", rhs, "for many values at once pass an array"),
    ({"g": 9.81}, "hv", lambda s, p, t: (s.v, fmean([s.h, 1])), "is traced without values"),
    ({"g": 9.81}, "ht", rhs, "'t' cannot name a state or parameter"),
    ({"g": 9.81}, ["h", "v max"], rhs, "'v max' cannot name a state or parameter"),
    ({"lambda": 9.81}, "hv", rhs, "'lambda' cannot name"),
    ("", "hv", rhs, "the parameters of a model are a dict of values by name"),
])  # fmt: skip
def test_a_model_that_does_not_fit_together_says_so_when_made(parameters, states, rates, words):
    with pytest.raises(ModelError, match=words):
        Model("fall", parameters, tuple(states), rates)


DATA = np.linspace(0.0, 3.0, 7)
TABLE, LINEAR = r"table\(ts, values\)", "solve_linear and sqrt"


@pytest.mark.parametrize(("rate", "words"), [
    *((lambda s, p, t, f=f: f(s.v), "round them") for f in (
        round, int, math.trunc, math.ceil, complex, np.sinc, DATA.__getitem__, [1.0, 2.0].__getitem__,
        lambda v: v % 2.0, lambda v: 2.0 % v, lambda v: v // 2.0, lambda v: divmod(7.0, v)[0],
        lambda v: v @ v, lambda v: float(f"{v}"),
    )),
    (lambda s, p, t: where((s.v > 0) | (t > 1), 1.0, 2.0), r"\(if, and,"),
    (lambda s, p, t: where(~(s.v > 0), 1.0, 2.0), r"\(if, and,"),
    (lambda s, p, t: interpolate.RegularGridInterpolator((DATA,), DATA)((t,))[0], TABLE),
    (lambda s, p, t: mp.sin(s.v), "from newton_euler"),
    (lambda s, p, t: round(s.v, 1), r"in '\(lambda s, p, t: round\(s.v, 1\), .*: a formula"),
    (lambda s, p, t: next(iter(s)), "the states are read by name, as s.v"),
    (lambda s, p, t: s[0], "the states are read by name, as s.v"),
    (lambda s, p, t: np.interp(s.v, DATA, DATA), TABLE),
    (lambda s, p, t: DATA[np.searchsorted(DATA, t)], TABLE),
    (lambda s, p, t: interpolate.CubicSpline(DATA, DATA)(t), TABLE),
    (lambda s, p, t: interpolate.interp1d(DATA, DATA)(t), TABLE),
    (lambda s, p, t: np.linalg.solve([[2.0, s.v], [0.0, 1.0]], [s.v, t])[0], LINEAR),
    (lambda s, p, t: np.linalg.norm(np.array([s.v, t])), LINEAR),
    (lambda s, p, t: np.array([1.0, 2.0]) * s.v, r"an array \(2,\) meets a traced value"),
])  # fmt: skip
def test_what_needs_values_is_refused_with_what_does_the_same(rate, words):
    with pytest.raises(ModelError, match=words):
        Model("q", {}, ("v",), lambda s, p, t: (rate(s, p, t),))


def test_constants_of_numpy_are_numbers_and_its_own_errors_stay():
    rates = lambda s, p, t: (np.array(2.0) * sin(np.array(3) * t) - s.v / np.float32(2),)
    model = Model("driven", {}, ("v",), rates)
    assert close(model.derivative((1.0,), 0.5), (2 * math.sin(1.5) - 0.5,), 1e-15)
    with pytest.raises(np.linalg.LinAlgError):
        Model("q", {}, ("v",), lambda s, p, t: (s.v * np.linalg.inv(np.zeros((2, 2)))[0, 0],))


RNG = np.random.default_rng(1)


@pytest.mark.parametrize(
    "draw", [random.random, lambda: np.random.normal(), RNG.normal, time.perf_counter, lambda: next(COUNT)]
)  # fmt: skip
@pytest.mark.parametrize("law", [False, True])
def test_rates_that_differ_from_call_to_call_are_refused(draw, law):
    parameters = {"F": lambda s, p, t: draw()} if law else {"F": 1.0}
    with pytest.raises(ModelError, match="not the same at each call"):
        Model("q", parameters, ("v",), lambda s, p, t: ((p.F if law else draw()) - s.v,))


COUNT = iter(range(10**6))


def test_what_a_model_reads_in_lists_and_arrays_is_the_same_at_each_call():
    known = {"c": [1.0, 2.0], "log": []}
    rates = lambda s, p, t: (known["log"].append(t), -known["c"][1] * s.v)[1:]
    assert Model("q", {}, ("v",), rates).derivative((3.0,), 0.0) == (-6.0,)


def test_print_in_the_rates_is_reported(capsys):
    def rates(s, p, t):
        print("v is", s.v)
        return (-s.v,)

    with pytest.warns(UserWarning, match="'q' prints when it is traced, without values"):
        Model("q", {}, ("v",), rates)
    assert "v is <traced v>" in capsys.readouterr().out


PULLED = Model("pulled", {}, ("x",), lambda s, p, t: (-1 / s.x,))


@pytest.mark.parametrize(("ask", "words"), [
    (lambda m: m.derivative((1.0,)), r"oscillator has the 2 states x, dx; got 1 values: \(1.0,\)"),
    (lambda m: m.derivative(iter([0.0] * 1000)), "has the 2 states x, dx; got 1000 values: "),
    (lambda m: m.derivative(iter([0.0] * 1001)), "has the 2 states x, dx; got more values: "),
    (lambda m: m.derivative({"x": 1.0}), "the state of 'oscillator' has no dx; give all of x, dx"),
    (lambda m: m.solution(1.0, (1.0, 0.0)), "no exact solution of 'oscillator' is known; integrate it"),
    (lambda m: m.invariant("momentum", (1.0, 0.0)), "oscillator has no invariant 'momentum'; it has energy"),
    (lambda m: m.changed(c=1.0), "oscillator has no parameter 'c'; it has m, k"),
    (lambda m: m.compiled_rhs("c"), "oscillator has no parameter 'c'"),
    (lambda m: PULLED.changed(c=1.0), "pulled has no parameter 'c'; it has none"),
    (lambda m: second_order("s", {}, ("x",), 3), r"accelerations of 's' is a function \(s, p, t\), got 3"),
])  # fmt: skip
def test_questions_that_a_model_cannot_answer(ask, words):
    with pytest.raises(ModelError, match=words):
        ask(oscillator())


def test_where_a_formula_has_no_value_the_kind_of_error_is_that_of_the_numbers():
    with pytest.raises(ZeroDivisionError, match=r"pulled has no rates at \{'x': 0.0\};.* singular"):
        PULLED.derivative((0.0,))
    exact = lambda s, p, t: (exp(t) / s.x,)
    grows = Model("grows", {}, ("x",), lambda s, p, t: (s.x,), exact=exact)
    with pytest.raises(RangeError, match="the exact solution of 'grows' has no value at t = 1000"):
        grows.solution(1000.0, (1.0,))
    words = "the exact solution of 'grows' has no value at t = 1"
    with pytest.raises(ZeroDivisionError, match=words):
        grows.solution(1.0, (0.0,))


# -- what is a number


def test_what_is_absent_comparable_or_in_sequences_is_known():
    assert [is_absent(x) for x in (0, 0.0, mp.mpf(0), 1e-300, lambda s, p, t: 0.0)] == [
        True, True, True, False, False,
    ]  # fmt: skip
    assert comparable("orbit", 1, 2.5) == (1, 2.5)
    with pytest.raises(ModelError, match="the exact solution of the orbit needs numbers"):
        comparable("orbit", 1.0, sympy.Symbol("e"))


@pytest.mark.parametrize(
    ("attributes", "found"),
    [(("unit",), True), (("magnitude", "to"), True), (("magnitude",), False), (("to",), False)],
)
def test_a_quantity_is_known_by_its_attributes(attributes, found):
    assert has_unit(SimpleNamespace(**dict.fromkeys(attributes))) is found
    assert has_unit(np.timedelta64(3, "s"))
    assert not has_unit(np.float64(3.0))


def test_numbers_in_sequences_are_an_array_and_the_one_bad_entry_is_named():
    assert real_numbers([[1, 2.5], (3, 4)], "numbers").tolist() == [[1.0, 2.5], [3.0, 4.0]]
    with pytest.raises(ModelError, match=r"^numbers; got 'x'$"):
        real_numbers([1.0, ["x"]], "numbers")


def test_a_table_among_the_parameters_is_read_by_formulas_and_laws():
    torque = table([0.0, 2.0, 9.0], [1.0, 5.0, -2.0], outside="hold")
    rates = lambda s, p, t: (p.k * p.torque(s.w) + p.load,)
    load = lambda s, p, t: -p.torque(t)
    model = Model("motor", {"torque": torque, "k": 0.5, "load": load}, ("w",), rates)
    assert close(model.derivative((1.0,), 0.5), (0.5 * 3.0 - 2.0,), 1e-15)
    assert close(
        model.changed(torque=table([0.0, 4.0], [2.0, 2.0])).derivative((1.0,), 0.5), (-1.0,), 0
    )
    end = integrate(model, 4.0, (0.5,)).end["w"]
    many = integrate(model.changed(k=np.array([0.5, 0.6])), 4.0, (0.5,))
    assert many.end["w"][0] == pytest.approx(end, rel=1e-9)


def test_rates_beyond_floats_are_named_with_their_place():
    spring = Model("spring", {"k": 1.5}, ("x", "v"), lambda s, p, t: (s.v, -p.k * s.x))
    with pytest.raises(OverflowError, match=r"(?s)too large.*spring has no rates at "):
        spring.derivative((10**400, 0.0))


@pytest.mark.parametrize("name", ["_of", "_asked", "_trace", "name", "self", "items"])
def test_a_pickled_model_has_states_of_any_name(name):
    swing = Model("swing", {"k": 2.0}, (name, "v"), lambda s, p, t: (s.v, -p.k * getattr(s, name)))
    again = pickle.loads(pickle.dumps(swing))
    assert again.derivative((0.5, 1.0)) == swing.derivative((0.5, 1.0)) == (1.0, -1.0)

"""A model prepared for integration: its functions on floats, and where they have no value."""

import math

import numpy as np
import pytest

from newton_euler import Model, cos, sqrt
from newton_euler.algebra import ZERO
from newton_euler.motion import ModelError, second_order
from newton_euler.motion.prepared import PreparedModel, prepared_model

SPRING = second_order("spring", {"k": 4.0, "c": 0}, ("x",), lambda s, p, t: (-p.k * s.x - p.c,))


# -- the model


@pytest.mark.parametrize("model", [None, "spring", lambda t, y: y])
def test_only_models_are_prepared(model):
    with pytest.raises(ModelError, match=r"integrate takes a Model.*, got"):
        prepared_model(model)


def test_numbers_are_arguments_but_for_what_is_left_out_and_for_laws():
    for c, free, values, rate in (
        (ZERO, ("k",), (4.0,), -4.0),
        (lambda s, p, t: 2.0 * p.k, ("k",), (4.0,), -12.0),
        (1, ("k", "c"), (4.0, 1.0), -5.0),
    ):
        system = PreparedModel(SPRING.changed(c=c))
        assert (system.free, system.p, system.many) == (free, values, False)
        assert system.rates(0.0, (1.0, 3.0)) == (3.0, rate)
    assert PreparedModel(SPRING.changed(k=np.ones(3))).many


@pytest.mark.parametrize(
    ("k", "words"),
    [
        (math.nan, "the parameter k of 'spring' is nan; a motion needs finite numbers"),
        (math.inf, "the parameter k of 'spring' is inf; a motion needs finite numbers"),
        (10**400, "the parameter k of 'spring' has no number"),
    ],
)
def test_a_parameter_without_a_finite_number_is_refused(k, words):
    with pytest.raises(ModelError, match=words):
        PreparedModel(SPRING.changed(k=k))


SHIFT = 1.0


def test_what_only_an_invariant_reads_is_looked_at_too(monkeypatch):
    shifted = {"shifted": lambda s, p, t: s.x + SHIFT}
    model = Model("still", {}, ("x",), lambda s, p, t: (0 * s.x,), shifted)
    before = prepared_model(model)
    assert prepared_model(model) is before
    monkeypatch.setitem(globals(), "SHIFT", 2.0)
    after = prepared_model(model)
    assert [one.function(shifted["shifted"])(0.0, 5.0) for one in (before, after)] == [6.0, 7.0]


@pytest.mark.parametrize(("rate", "found"), [(lambda t: t, False), (lambda t: 1.0, True)])
def test_rates_in_which_the_time_does_not_occur_are_autonomous(rate, found):
    model = Model("any", {}, ("x",), lambda s, p, t: (s.x * rate(t),))
    assert prepared_model(model).autonomous is found


def test_parameters_that_give_no_numbers_have_no_constants():
    model = Model("any", {"a": 1.0, "b": 1.0}, ("x",), lambda s, p, t: (s.x / (p.a - p.b),))
    constants = prepared_model(model).constants
    assert constants
    assert all(map(math.isnan, constants))


# -- the closed form on floats


def closed(formula):
    return prepared_model(Model("any", {}, ("x",), lambda s, p, t: (1.0 + 0 * s.x,), exact=formula))


def test_a_closed_form_is_its_values_on_floats_and_called_as_it_is_where_it_branches():
    system = closed(lambda s, p, t: (s.x + t,))
    assert system.solution(2.0, (3.0,)) == system.exact_on_floats(2.0, 3.0) == (5.0,)
    assert system.solutions(np.array([1.0, 2.0]), (3.0,)).tolist() == [[4.0, 5.0]]
    system = closed(lambda s, p, t: (s.x + t if t > 1 else s.x,))
    assert system.exact_on_floats is None
    assert [system.solution(t, (3.0,)) for t in (0.5, 2.0)] == [(3.0,), (5.0,)]


@pytest.mark.parametrize(
    ("formula", "why"),
    [(lambda s, p, t: (1 / (s.x - t),), ": "), (lambda s, p, t: (s.x * 1e300 * 1e300,), "")],
)
def test_a_closed_form_without_a_value_is_reported_with_its_place(formula, why):
    words = rf"^the exact solution of 'any' has no value at t = 3 after \(3.0,\){why}"
    with pytest.raises(ModelError, match=words + ("" if why else "$")):
        closed(formula).solution(3.0, (3.0,))


def test_a_function_of_a_model_is_one_of_the_time_and_the_states():
    system = prepared_model(SPRING)
    traced = lambda s, p, t: p.k * s.x + t
    branching = lambda s, p, t: cos(s.x) if s.x > 0 else sqrt(p.k) + t
    assert system.function(traced)(1.0, 2.0, 3.0) == 9.0
    assert system.function(branching)(1.0, -2.0, 3.0) == 3.0
    assert system.untraced(branching)(1.0, 0.0, 3.0) == 3.0

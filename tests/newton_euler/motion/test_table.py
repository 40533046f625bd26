"""The methods as values: which run a run is compared with, and why a method cannot be used."""

import pickle

import pytest

from newton_euler import Model, integral, prepare, root, where
from newton_euler.motion import second_order
from newton_euler.motion.methods.table import MAX_COARSE_TOLERANCE, METHODS
from newton_euler.motion.methods.taylor import LEVELS, installed, level_of
from newton_euler.motion.prepared import prepared_model
from tests.models import SPRING, free_body

RUNGE_KUTTA, SERIES = METHODS["dop853"], METHODS["taylor"]
FLOOR = second_order("floor", {}, ("x",), lambda s, p, t: (where(s.x < 0, -s.x, -1.0),))


@pytest.mark.parametrize(
    ("tolerance", "other"), [(1e-12, 1e-9), (1e-6, MAX_COARSE_TOLERANCE), (5e-5, 5e-4)]
)
def test_runge_kutta_is_compared_with_a_coarser_run_unless_that_shows_nothing(tolerance, other):
    assert RUNGE_KUTTA.other(tolerance) == pytest.approx(other)


def test_a_series_is_compared_with_a_finer_one_as_long_as_there_is_one():
    """The series are two orders apart: a little less than a factor e^4."""
    assert SERIES.other(1e-6) == pytest.approx(1e-6 / 54)
    assert SERIES.other(LEVELS[-2]) == pytest.approx(54 * LEVELS[-2])
    assert level_of(SERIES.other(LEVELS[3])) == LEVELS[5]


@pytest.mark.parametrize("name", METHODS)
def test_a_method_is_sent_by_its_name_in_which_its_order_is(name):
    method = METHODS[name]
    assert pickle.loads(pickle.dumps(method)) is method
    digits = "".join(c for c in name if c.isdigit())
    if name.startswith(("yoshida", "lie-poisson")):
        assert method.order == int(digits)


def why(name, model, *t0):
    return METHODS[name].unusable_because(prepared_model(model), *t0)


def test_what_a_splitting_method_cannot_split_is_reported():
    assert why("verlet", SPRING) is why("lie-poisson4", free_body()) is None
    assert "'floor' have kinks, at which it loses its order" in why("verlet", FLOOR)
    assert "'free body' are not two groups" in why("verlet", free_body())
    assert "'spring' is not Euler's equations of a free body" in why("lie-poisson4", SPRING)


@pytest.mark.skipif(not installed(), reason="needs heyoka")
def test_a_root_or_an_integral_of_a_state_has_no_series():
    for name, f in (
        ("root", lambda x: root(lambda q: q**3 - x, 0.0, 9.0)),
        ("integral", lambda x: integral(lambda q: q, 0.0, x)),
    ):
        model = Model("inner", {}, ("x",), lambda s, p, t, f=f: (-f(s.x),))
        assert f"no series of the {name} in the rates of 'inner'" in why("taylor", model)
        assert prepare(model).method == "dop853"


def test_a_closed_form_of_rates_that_depend_on_time_starts_at_zero():
    exact = lambda s, p, t: (s.x + t * t,)
    model = Model("driven", {}, ("x",), lambda s, p, t: (2 * t,), exact=exact)
    assert why("exact", model) is why("exact", model, 0.0) is None
    assert "its exact solution starts at t = 0" in why("exact", model, 1.0)
    assert why("exact", SPRING) == "no exact solution of 'spring' is known"

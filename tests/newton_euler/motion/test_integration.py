"""Integration of models: orders of convergence, dense output, prepared runs, and refusals."""

import math

import numpy as np
import pytest

from newton_euler import Model, sqrt
from newton_euler.motion import ModelError
from newton_euler.motion.integration import integrate, prepare
from newton_euler.motion.methods.table import METHODS
from newton_euler.motion.solution import MotionError
from tests.models import FALL, TAYLOR, free_body, needs_heyoka, oscillator

ADAPTIVE = (TAYLOR, "dop853", "scipy DOP853", "scipy RK45", "scipy LSODA")


# -- orders and accuracy


@pytest.mark.parametrize(
    ("method", "first"),
    [("dop853", 1.2), ("lie-poisson2", 0.1), ("lie-poisson4", 0.1), ("lie-poisson6", 0.2), ("lie-poisson8", 0.3)],
)  # fmt: skip
def test_on_a_free_body_methods_converge_with_their_order(method, first):
    start, steps = (1.0, 0.1, 0.4), [first / 1.5**k for k in range(4)]
    exact = integrate(free_body(), 6.0, start, 1e-12).end
    ends = [integrate(free_body(), 6.0, start, method=method, step=h).end for h in steps]
    errors = [max(abs(end[n] - exact[n]) for n in "xyz") for end in ends]
    slope = np.polyfit(np.log(steps), np.log(errors), 1)[0]
    assert slope == pytest.approx(METHODS[method].order, abs=0.45), errors


@pytest.mark.parametrize("method", ADAPTIVE)
def test_dense_output_is_nearly_as_accurate_as_the_steps(method):
    motion = integrate(oscillator(), 10.0, (1.0, 0.3), 1e-8, method)
    t = np.linspace(0, 10, 301)
    exact = oscillator().solution(t, (1.0, 0.3))
    found = motion.at(t)
    assert max(abs(found["x"] - exact[0])) < 1e-7
    assert max(abs(found["dx"] - exact[1])) < 2e-7
    assert motion.at(10.0) == motion.end


# -- refusals


@pytest.mark.parametrize(
    ("given", "words"),
    [
        ({"method": "lie-poisson2"}, "is not Euler's equations of a free body"),
        ({"events": 3}, "events are an Event, or several, got 3"),
        ({"samples": [0.5, 2.0]}, "times from t = 0 to 1, the time of the motion; got 2"),
        ({"progress": 3}, "progress is a function of the fraction that is done, got 3"),
        ({"step": "long", "method": "verlet"}, "the step is a positive time, got 'long'"),
    ],
)
def test_each_argument_is_checked(given, words):
    with pytest.raises(ModelError, match=words):
        integrate(oscillator(), 1.0, (1.0, 0.0), 1e-3, **given)


@pytest.mark.parametrize("method", ["dop853", TAYLOR, "scipy RK45", "auto"])
def test_a_singular_point_ends_it_with_what_was_reached(method):
    with pytest.raises(MotionError, match=r"fall could .* beyond t = 0\.[45].*singular") as refused:
        integrate(FALL, 2.0, (1.0,), 1e-6, method)
    reached = refused.value.reached
    assert 0.49 < reached.t_end <= 0.5 + 1e-6
    assert reached.at(0.3)["x"] == pytest.approx(math.sqrt(0.4), rel=1e-5)


# -- prepared runs


@pytest.mark.parametrize("method", ["auto", "exact", TAYLOR, "dop853", "verlet"])
def test_a_prepared_run_is_that_of_integrate(method):
    run = prepare(oscillator(), 1e-7, method)
    for t, start in ((3.0, (1.0, 0.0)), (7.5, (0.2, -2.0))):
        whole = integrate(oscillator(), t, start, 1e-7, "dop853")
        assert run(t, start) == pytest.approx(tuple(whole.end.values()), abs=5e-7)


ROUGH = Model("rough", {}, ("v",), lambda s, p, t: (-1.0 - sqrt(s.v * s.v) * s.v,))  # has a corner


@needs_heyoka
@pytest.mark.parametrize(
    ("model", "method"),
    [(oscillator(), "exact"), (oscillator(exact=False), "taylor"), (ROUGH, "dop853")],
)
def test_a_prepared_run_takes_the_fastest_method(model, method):
    assert prepare(model).method == method


@pytest.mark.parametrize("method", ["exact", TAYLOR])
def test_a_prepared_run_does_not_integrate_where_it_need_not(method, monkeypatch):
    run = prepare(oscillator(), 1e-7, method)
    run(3.0, (1.0, 0.0))  # the first series is compared with another one
    monkeypatch.setattr("newton_euler.motion.integration.Run", None)
    for start in (1.0, 1.001):
        assert run(3.0, (start, 0.0))[0] == pytest.approx(start * math.cos(6.0), abs=1e-7)


@needs_heyoka
def test_the_finer_series_of_a_long_run_vouches_for_no_other():
    """The same start again, with fewer terms, was once wrong by 6 times the tolerance."""
    run = prepare(oscillator(exact=False), 1e-3, "taylor")
    for start in (1.0, 1.0, 1.003):
        end = run(1.5e5, (start, 0.0))[0]
        assert end == pytest.approx(start * math.cos(3e5), abs=1e-3)


@pytest.mark.parametrize("method", [TAYLOR, "dop853"])
def test_a_prepared_run_into_a_singular_point_says_so(method):
    run = prepare(FALL, 1e-6, method)
    assert run(0.4, (1.0,))[0] == pytest.approx(math.sqrt(0.2), rel=1e-5)
    with pytest.raises(MotionError, match="could not be followed beyond t = 0"):
        run(2.0, (1.0,))
    # afterwards the run works as before
    assert run(0.4, (1.0,))[0] == pytest.approx(math.sqrt(0.2), rel=1e-5)


@pytest.mark.parametrize("method", ["exact", TAYLOR, "dop853"])
@pytest.mark.parametrize(
    ("t", "start", "words"),
    [(1.0, (1.0,), "has the 2 states x, dx; got 1 values"), (1.0, (1.0, "fast"), "needs a number for dx"), ("soon", (1.0, 0.0), "t is the time"),
     (math.nan, (1.0, 0.0), "time runs forward"), (1.0, (math.nan, 0.0), "needs finite numbers"),
     (np.array([1.0, 2.0]), (1.0, 0.0), "takes one time"), (1.0, (np.array([1.0, 2.0]), 0.0), "one start, integrate many")],
)  # fmt: skip
def test_what_a_prepared_run_cannot_do_is_reported_as_by_integrate(method, t, start, words):
    run = prepare(oscillator(), 1e-7, method)
    with pytest.raises(ModelError, match=words):
        run(t, start)
    assert run(3.0, (1.0, 0.0))[0] == pytest.approx(math.cos(6.0), abs=3e-7)


def test_only_one_model_is_prepared_at_a_time():
    words = "prepare takes a model with numbers, but parameters of 'oscillator' are arrays"
    with pytest.raises(ModelError, match=words):
        prepare(oscillator().changed(k=np.ones(3)))

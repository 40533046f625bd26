"""Scenes of the book, integrated: orders of convergence, honest errors, events."""

import statistics

import mpmath
import numpy as np
import pytest

from newton_euler.motion import METHODS, integrate
from newton_euler.motion.prepared import PreparedModel, prepared_model
from newton_euler.scenes.planar.pendulum import physical_pendulum
from tests.honesty.closed_forms import pendulum
from tests.motions import SCENES, reference, true_error


def swing(**more):
    return integrate(physical_pendulum(2.0, 0.5, 0.5, 10.0), 10.0, (1.0, 0.0), **more)


@pytest.mark.parametrize(
    ("method", "first"),
    [("verlet", 0.1), ("yoshida4", 0.05), ("scipy RK45", 0.1), ("yoshida6", 0.12), ("yoshida8", 0.06)],
)  # fmt: skip
def test_methods_converge_with_their_order(method, first):
    """The slope of log error over log step, for a pendulum with its closed form to 30 digits."""
    steps = [first / 1.5**k for k in range(4)]
    exact = reference_of_the_pendulum()
    errors = [abs(swing(method=method, step=h).end["theta"] - exact) for h in steps]
    slope = np.polyfit(np.log(steps), np.log(errors), 1)[0]
    assert slope == pytest.approx(METHODS[method].order, abs=0.45), errors


def reference_of_the_pendulum(t=10.0):
    with mpmath.workdps(30):
        return float(pendulum(mpmath, *map(mpmath.mpf, (10, 1, 0, t)))[0])


def test_the_reference_of_these_tests_agrees_with_a_closed_form():
    pytest.importorskip("heyoka")
    assert abs(reference("pendulum")[0] - reference_of_the_pendulum()) < 1e-15


def honesty(method, scenes, tolerances):
    """The true error over the error asked for, and over the error reported."""
    asked, reported = [], []
    for scene in scenes:
        model, t, start = SCENES[scene]
        if METHODS[method].unusable_because(PreparedModel(model)):
            continue
        for rtol in (x for x in tolerances if x >= METHODS[method].min_rtol):
            motion = integrate(model, t, start, rtol, method)
            error = true_error(scene, motion)
            asked.append(error / rtol)
            reported.append(error / motion.error)
    return asked, reported


SOME = ("top", "free body", "pendulum", "turning shaft", "planet", "forced", "aircraft")
FEW, EVERY = (1e-3, 1e-5, 1e-7, 1e-9, 1e-11), tuple(10.0**-n for n in range(3, 13))
LEAST = {  # the least median of error over error asked for: no method is far too exact
    "taylor": 1e-4, "dop853": 1e-3, "scipy DOP853": 1e-3, "scipy RK45": 1e-3, "scipy LSODA": 1e-3,
    "scipy Radau": 1e-4, "yoshida4": 1e-3, "yoshida6": 1e-4, "yoshida8": 1e-4, "lie-poisson4": 1e-3,
    "lie-poisson6": 1e-4,
}  # fmt: skip


@pytest.mark.parametrize(("method", "scenes", "tolerances", "least"), [
    ("dop853", SOME, FEW, 3e-3), ("taylor", SOME, FEW, 1e-4),
    *[pytest.param(method, SCENES, EVERY[:6] if "Radau" in method else EVERY, least, marks=pytest.mark.slow)
      for method, least in LEAST.items()],
], ids=lambda x: x if isinstance(x, str) else "")  # fmt: skip
def test_errors_are_what_was_asked_for(method, scenes, tolerances, least):
    """The median heyoka run is more accurate than asked: its error falls in steps."""
    pytest.importorskip("heyoka")
    asked, reported = honesty(method, scenes, tolerances)
    assert np.mean(np.array(asked) <= 1) >= (1 if scenes is SOME else 0.95)
    assert scenes is SCENES or np.mean(np.array(reported) <= 1) >= 0.97
    assert statistics.median(asked) >= least


@pytest.mark.parametrize("scene", SCENES)
def test_what_parameters_alone_give_is_computed_once(scene):
    """The rest of the formula has other arguments, fewer operations, and the same rates."""
    model, _, start = SCENES[scene]
    system = prepared_model(model)
    rest, _ = system.traced.folded
    states = [x + 0.01 * n for n, x in enumerate(start, 1)]
    whole, rates = system.rates(0.3, states), system.folded_rates(0.3, *states, *system.constants)
    scale = max(map(abs, whole))
    assert max(abs(a - b) for a, b in zip(whole, rates, strict=True)) <= 4e-15 * scale
    count = lambda source: sum(source.count(f" {op} ") for op in "*/+-")
    assert count(rest.source) <= count(system.traced.rhs.source)
    assert not set(rest.source.split("(", 1)[1].split(")")[0].split(", ")) & set(model.parameters)

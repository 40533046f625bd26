"""The error of a run, predicted from its difference from a run with another tolerance."""

import itertools
import math
from types import SimpleNamespace

import pytest

from newton_euler import Model, cos, integrate, sin
from newton_euler.motion import second_order
from newton_euler.motion.error_estimates import (
    IRREGULAR,
    MIN_STEPS,
    REGULAR,
    RESIDUAL_SAFETY,
    ROUND_OFF,
    SAFETY,
    SERIES_ROUND_OFF,
    SERIES_SAFETY,
    STEPS_OFF,
    error_by_comparison,
    error_by_difference,
    reported_error,
)
from newton_euler.motion.methods.table import METHODS
from newton_euler.motion.prepared import prepared_model
from newton_euler.motion.run import Run
from newton_euler.motion.solution import AccuracyError
from newton_euler.motion.trajectory import Segment
from tests.models import TAYLOR, kepler

PENDULUM = second_order("pendulum", {}, ("a",), lambda s, p, t: (-sin(s.a),))
START = (1.0, 0.0)


ORBIT = kepler()  # e = 0.3: three orbits end at the start
PERIAPSIS = 0.7, 0.0, 0.0, math.sqrt(1.3 / 0.7)
DRIVEN = Model("driven", {"n": 2.0}, ("x",), lambda s, p, t: (cos(p.n * t) * s.x,))


def growth(n):
    return (math.exp(math.sin(10.0 * n) / n),)


@pytest.mark.parametrize(
    ("model", "method", "rtol", "start", "t", "end"),
    [
        (ORBIT, "dop853", 1e-3, PERIAPSIS, 6 * math.pi, PERIAPSIS),
        (ORBIT, "scipy RK45", 1e-8, PERIAPSIS, 6 * math.pi, PERIAPSIS),
        (ORBIT, "scipy DOP853", 1e-5, PERIAPSIS, 6 * math.pi, PERIAPSIS),
        (DRIVEN, "dop853", 1e-3, (1.0,), 10.0, growth(2)),
        (DRIVEN.changed(n=5.0), "scipy RK45", 1e-3, (1.0,), 10.0, growth(5)),
        (DRIVEN.changed(n=5.0), "scipy DOP853", 1e-5, (1.0,), 10.0, growth(5)),
    ],
)
def test_the_prediction_covers_the_error_even_where_it_is_tight(model, method, rtol, start, t, end):
    """Of 240 runs of 14 models with closed forms, these few have a true error of more than half
    the predicted one.
    """
    method, run = METHODS[method], Run(prepared_model(model), 0.0, t, start, rtol)
    tolerance = min(rtol / 100, method.max_tolerance)
    before = run.compared(method, method.other(tolerance), tolerance)
    fine = run.trajectory(method, tolerance, before.sizes())
    scales = fine.segments[-1].stepper.scales
    true = max(abs(x - y) / s for x, y, s in zip(fine.segments[-1].x1, end, scales, strict=True))
    predicted = error_by_comparison(before, fine, method)
    assert 0.5 * predicted < true <= predicted


@pytest.mark.parametrize(("given", "found"), [
    # no error is below the tolerance or below round-off
    ((0.0, 1e-3, 1e-7), 1e-7),
    ((0.0, 1e-3, 0.0), ROUND_OFF),
    ((0.0, 54.0, 1e-7), SERIES_ROUND_OFF),
    # the difference from a more accurate run is the error; at equal tolerances neither run is
    ((1e-8, 54.0, 1e-3), SERIES_SAFETY * 1e-8),
    ((1e-8, 1.5, 1e-3), SERIES_SAFETY * 1e-8),
    ((1e-8, 1.0, 1e-12), SAFETY * 1e-8),
    # round-off grows as the root of the number of steps
    ((0.0, 1e-3, 0.0, True, 300), 2 * ROUND_OFF),
    ((0.0, 54.0, 0.0, True, 300), 2 * SERIES_ROUND_OFF),
    ((0.0, 54.0, 0.0, True, 9900), 10 * SERIES_ROUND_OFF),
    # two runs that are far apart predict nothing
    ((0.051, 1e-3, 1e-9), 0.051),
    ((0.05, 54.0, 1e-9), SERIES_SAFETY * 0.05),
    ((math.nan, 1e-3, 1e-9), math.nan),
    ((math.inf, 1e-3, 1e-9), math.inf),
])  # fmt: skip
def test_the_error_of_a_difference(given, found):
    assert error_by_difference(*given) == pytest.approx(found, rel=1e-5, abs=0.0, nan_ok=True)


@pytest.mark.parametrize("what", ["surprises", "hazards"])
def test_where_formulas_change_the_prediction_is_the_cautious_one(monkeypatch, what):
    method, one = METHODS["dop853"], Run(prepared_model(PENDULUM), 0.0, 50.0, START, 1e-9)
    before, fine = one.trajectory(method, 1e-7), one.trajectory(method, 1e-10)
    found = [error_by_comparison(before, fine, method)]
    monkeypatch.setitem(vars(one.system.traced), what, ["abs"])
    found.append(error_by_comparison(before, fine, method))
    assert found[1] / found[0] == pytest.approx(1e-3 ** (IRREGULAR - REGULAR), rel=1e-3)


@pytest.mark.parametrize("method", ["dop853", "scipy RK45", TAYLOR])
def test_the_error_contains_what_the_clock_makes_of_a_force_in_time(method):
    """Under sin(w t) at t = 1e9: there the time is known only to 1e-7 s."""
    model = second_order("driven", {"w": 2.0}, ("x",), lambda s, p, t: (sin(p.w * t) - s.x,))
    errors = [integrate(model, (t0, t0 + 2.0), START, 1e-5, method).error for t0 in (0.0, 1e9)]
    assert errors[1] > 1e-7
    assert method != "taylor" or errors[0] < 3e-8


@pytest.mark.parametrize(
    ("near", "c", "v"), [(2.9376e-5, 3.0186, 2.8582), (8.492e-5, 3.3079, 1.9994), (1e-2, 5.0, 1.0)]
)
def test_the_error_contains_the_round_off_of_a_small_distance_from_a_large_place(near, c, v):
    """A bounce off a pole, judged by its energy: 1e-12 was reported where the error was 1e-11."""
    B = near * v * v / 2
    pole = second_order("pole", {}, ("x",), lambda s, p, t: (-B / (c - s.x) ** 2,))
    try:
        motion = integrate(pole, 1.7 * c / v, (0.0, v), rtol=1e-12)
    except AccuracyError:
        assert near < 1e-2
    else:
        energy = (motion.end["dx"] ** 2 / 2 + B / (c - motion.end["x"])) / (v * v / 2 + B / c)
        assert abs(energy - 1) / 2 < motion.error


class Still:
    """A system whose rates do not depend on time, with the given surprises and hazards."""

    autonomous = True

    def __init__(self, surprises=False, hazards=()):
        self.traced = SimpleNamespace(surprises=surprises, hazards=hazards)


def made(steps, tolerance=1e-12, difference=0.0, system=None, residuals=(0.0,), stopping=False):
    """A trajectory with the given number of steps in each segment."""
    parts = []
    for n, r in itertools.zip_longest(steps, residuals, fillvalue=0.0):
        of = {"step_times": range(n + 1), "scales": (1.0,), "residual": lambda r=r: r}
        of |= {"taken": 0, "t": 0.0, "start": (0.0, (1.0,)), "resumable": False}
        parts.append(Segment(system or Still(), SimpleNamespace(**of), 0.0, 1.0, (1.0,)))
    return SimpleNamespace(
        segments=parts, tolerance=tolerance, count=sum(steps), difference=lambda other: difference,
        stopping=stopping, known=None,
    )  # fmt: skip


def is_regular(method, coarse, fine, ratio=1e-3):
    """True if the prediction is the one for runs in the regime of small errors."""
    before, after = made(coarse, 1e-12 / ratio, 1e-4), made(fine)
    found = error_by_comparison(before, after, METHODS[method])
    given = [
        error_by_difference(1e-4, ratio, 1e-12, regular, sum(fine)) for regular in (False, True)
    ]
    return given.index(pytest.approx(found, rel=1e-9))


@pytest.mark.parametrize("method", ["yoshida4", "scipy LSODA"])
def test_few_steps_are_not_in_the_regime_of_small_errors(method):
    for steps, regular in ((MIN_STEPS - 1, False), (MIN_STEPS, True)):
        assert is_regular(method, [steps], [100]) == regular
        assert is_regular(method, [steps - 3, 3], [100]) == regular
    assert is_regular("taylor", [1], [1])  # in a series the tolerance sets the order, not the steps


@pytest.mark.parametrize(
    ("coarse", "fine", "regular"),
    [
        ([1000], [2371], True),  # 1000^(1/8)
        ([1000], [2371 / STEPS_OFF - 9], False),
        ([1000], [2371 / STEPS_OFF + 9], True),
        ([1000], [2371 * STEPS_OFF - 9], True),
        ([1000], [2371 * STEPS_OFF + 9], False),
        ([500, 500], [1371, 1000], True),
        ([0], [1], False),
        ([MIN_STEPS - 1], [17], False),
        ([MIN_STEPS], [19], True),
    ],
)
def test_steps_that_do_not_grow_by_the_order_are_not_in_the_regime(coarse, fine, regular):
    fine = [int(n) for n in fine]
    assert is_regular("dop853", coarse, fine) == regular
    if sum(coarse) >= MIN_STEPS:  # with a fixed step the number of steps follows from the tolerance
        assert is_regular("yoshida8", coarse, fine)


@pytest.mark.parametrize(("hazards", "factor"), [((), REGULAR), (["exp"], IRREGULAR)])
def test_steps_that_end_at_kinks_are_in_the_regime_however_many_they_are(hazards, factor):
    system = Still(True, hazards)
    fine = made([1000], 1e-14, system=system, stopping=True)
    found = error_by_comparison(made([1000], 1e-13, 1e-5, system), fine, METHODS["dop853"])
    assert found == pytest.approx(SAFETY * 1e-5 * 0.1**factor, rel=1e-6)


def test_where_a_series_may_not_see_all_of_the_rates_its_worst_residual_counts():
    def judged(method, hazards):
        fine = made([9, 9, 9], system=Still((), hazards), residuals=(1e-6, 3e-6, 2e-6))
        return error_by_comparison(made([9]), fine, METHODS[method])

    assert judged("taylor", ["sqrt"]) == pytest.approx(RESIDUAL_SAFETY * 3e-6)
    assert judged("taylor", []) == judged("dop853", ["sqrt"]) < 1e-11


def test_the_reported_error_has_more_safety_but_is_not_above_the_rtol():
    assert reported_error(1e-9, 1e-6) == pytest.approx(3e-9)
    assert reported_error(5e-7, 1e-6) == 1e-6
    assert reported_error(2e-6, 1e-6) == 2e-6  # refused: reported unchanged
    assert math.isnan(reported_error(math.nan, 1e-6))

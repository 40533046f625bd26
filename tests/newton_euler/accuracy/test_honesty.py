"""Honesty, measured and drawn: when a promise is kept, what is drawn where, and the command."""

import math
from itertools import pairwise
from types import SimpleNamespace

import pytest
from matplotlib.figure import Figure

from newton_euler.accuracy.charts.honesty import PROMISE, draw_honesty
from newton_euler.accuracy.measurements import honesty as measuring
from newton_euler.accuracy.measurements.honesty import (
    EPS,
    FAILED,
    REFUSED,
    MethodResult,
    honesty,
    relative_costs,
    table,
    tallies,
)
from newton_euler.motion.solution import MotionError

SCENE = "sphere on an incline"


def fake(answers):
    """A reference whose methods give (true error, estimate) or an exception, as tabulated."""

    class Fake:
        def __init__(self, scene):
            self.model = scene.motion[0]

        def run(self, method, rtol):
            found = answers[method, rtol]
            if isinstance(found, Exception):
                raise found
            return SimpleNamespace(true=found[0], error=found[1])

        def error(self, motion):
            return motion.true

    return Fake


KNOWN = {
    ("auto", 1e-3): (5e-4, 1e-3),
    ("auto", 1e-6): (3e-6, 5e-6),  # broken, and reported
    ("auto", 1e-9): (4e-4, 1e-10),  # silently wrong
    ("dop853", 1e-3): (1e-4, 3e-4),
    ("dop853", 1e-6): (1e-7, math.nan),
    ("dop853", 1e-9): MotionError("only 1e-8 can be had", reached=None),
}


@pytest.fixture
def liar(monkeypatch):
    """The answers of "auto", which lies, and of "dop853", which is honest."""
    monkeypatch.setattr(measuring, "Reference", fake(KNOWN))
    return honesty((SCENE,), (1e-3, 1e-6, 1e-9), ("auto", "dop853"))


def test_answers_have_the_true_error_and_are_counted_by_method(liar):
    assert [(a.method, a.asked) for a in liar] == [*KNOWN]
    assert [(a.error, a.estimate) for a in liar[:4]] == [*KNOWN.values()][:4]
    assert (liar[4].error, liar[4].estimate) == (1e-7, None)
    assert [a.kept for a in liar] == [True, False, False, True, True, False]
    assert [a.covered for a in liar] == [True, True, False, True, None, None]
    assert [a.silent for a in liar] == [False, False, True, False, False, False]
    assert all(a.cost > 0 for a in liar[:5])
    assert {a.problem for a in liar} == {SCENE}
    auto, dop853 = sorted(tallies(liar), key=lambda t: t.method)
    assert (auto.runs, auto.silent, auto.refused, auto.failed) == (3, 1, 0, 0)
    assert (auto.met, auto.covers) == (pytest.approx(1 / 3), pytest.approx(2 / 3))
    assert auto.ratio == pytest.approx(5 / 3)  # the median of 2, 5/3 and 2.5e-7
    assert (dop853.runs, dop853.silent, dop853.refused, dop853.failed) == (3, 0, 1, 0)
    assert (dop853.met, dop853.covers, dop853.ratio) == (1.0, 1.0, pytest.approx(3.0))


def test_a_refusal_breaks_no_promise_and_other_errors_are_not_taken_for_one(liar, monkeypatch):
    refused = liar[-1]
    assert (refused.absent, refused.words) == (REFUSED, "only 1e-8 can be had")
    assert math.isnan(refused.error)
    assert refused.effectivity is None
    monkeypatch.setattr(measuring, "Reference", fake({("auto", 1e-3): ZeroDivisionError()}))
    with pytest.raises(ZeroDivisionError):
        honesty((SCENE,), (1e-3,), ("auto",))


def test_what_a_scene_cannot_use_is_not_asked_and_a_slow_method_for_no_more_digits():
    found = honesty((SCENE,), (1e-3,), ("lie-poisson4", "exact"))
    assert [a.method for a in found] == ["exact"]
    found = honesty((SCENE,), (1e-3, 1e-4), ("dop853",), longest=0.0)
    assert [a.asked for a in found] == [1e-3]


def test_progress_is_reported_scene_by_scene_and_never_goes_back():
    output = []
    honesty((SCENE, "low"), (1e-3,), ("exact", "auto"), progress=lambda *now: output.append(now))
    asked = [f"{scene}: {m}" for scene in (SCENE, "low") for m in ("exact", "auto")]
    assert [words for _, words in output] == asked
    assert all(a < b for (a, _), (b, _) in pairwise(output))
    assert 0 <= output[0][0] < output[-1][0] < 1


def answer(method="mine", cost=1e-3, error=1e-7, estimate=2e-7, problem="a", absent=""):
    about = {"estimate": estimate, "problem": problem, "absent": absent}
    return MethodResult(method, cost, error, asked=1e-6, **about)


def test_times_and_errors_too_small_to_be_seen_spoil_nothing():
    assert answer(error=0.0, estimate=0.0).effectivity == 1.0
    assert answer(error=0.0, estimate=1e-12).effectivity == 1e-12 / EPS
    assert answer(error=0.0, estimate=0.0).covered
    quick = [answer(cost=0.0), answer(cost=0.0, problem="b"), answer("slow", problem="b")]
    assert [a.cost for a in relative_costs(quick)[1:]] == [0.0, 1.0]
    cost, promise, *_ = drawn(quick)
    assert [x for x, _ in marks(cost)] == [1.0]
    assert len(marks(promise)) == 3


@pytest.mark.parametrize(("error", "estimate", "silent"), [
    (9e-6, 1e-9, False), (2e-5, 1e-9, True), (2e-5, 3e-6, False), (2e-5, None, True),
])  # fmt: skip
def test_silently_wrong_is_over_ten_times_both_tolerance_and_estimate(error, estimate, silent):
    assert answer(error=error, estimate=estimate).silent is silent


def test_costs_are_relative_to_the_cheapest_that_kept_its_word_on_the_same_problem():
    wrong = {"problem": "b", "error": 1.0}
    answers = [answer("quick and wrong", cost=1e-4, error=1e-2), answer("cheapest", cost=2e-3)]
    answers += [answer("slow", cost=8e-3), answer("slow", cost=1.0, **wrong)]
    answers += [answer("slower", cost=3.0, **wrong)]
    refused = ((1e-9, "b"), (5.0, "c"))
    answers += [answer("slow", cost=x, absent=REFUSED, problem=of) for x, of in refused]
    found = relative_costs(answers)
    # where none kept its promise, relative to the cheapest of all; a refusal sets no standard
    assert [a.cost for a in found[:5]] == [pytest.approx(x) for x in (0.05, 1.0, 4.0, 1.0, 3.0)]
    assert math.isnan(found[-1].cost)


def test_methods_come_from_the_cheapest_to_the_dearest_and_those_without_an_answer_last():
    refused = answer("none", absent=REFUSED, cost=1e-9)
    found = tallies([refused, answer("dear", cost=1.0), answer("cheap", cost=0.1)])
    assert [t.method for t in found] == ["cheap", "dear", "none"]
    assert math.isnan(found[-1].met)


def test_the_table_has_seconds_for_one_problem_and_ratios_for_several():
    one = [answer(), answer("slow", cost=2e-2, error=5e-6)]
    several = [*one, answer(problem="b", absent=FAILED, estimate=None)]
    assert table(one).splitlines()[1].split() == ["mine", "1", "100", "100", "2", "1.0", "ms"]
    assert table(several).splitlines()[1].split() == ["mine", "2", "100", "100", "2", "1", "1", "x"]
    assert table(several).splitlines()[2].split() == ["slow", "1", "0.0", "0.0", "0.04", "20", "x"]


def drawn(answers):
    """The four axes of the rendered chart."""
    figure = Figure()
    draw_honesty(answers, figure, "title")
    figure.canvas.draw()
    return figure.axes


def marks(ax):
    """The positions of all marks of runs, as (x, number of the row)."""
    return sorted((x, round(y)) for points in ax.collections for x, y in points.get_offsets())


def texts(ax):
    return [t.get_text() for t in ax.texts]


def test_a_broken_promise_lies_beyond_the_line_in_its_row_and_a_kept_one_before(liar):
    cost, promise, estimate, _ = drawn(liar)
    rows = [t.get_text() for t in cost.get_yticklabels()]
    auto, dop853 = rows.index("auto"), rows.index("dop853")
    # the refused run of dop853 is drawn beyond the edge
    assert marks(promise) == [
        (pytest.approx(0.1), dop853),
        (pytest.approx(0.1), dop853),
        (pytest.approx(0.5), auto),
        (pytest.approx(3.0), auto),
        (PROMISE[1], auto),  # 4e5, at the edge
        (pytest.approx(7 * PROMISE[1]), dop853),
    ]
    assert [(x, row) for x, row in marks(estimate) if x < 1] == [(pytest.approx(1e-4), auto)]
    (red, *_) = (p for p in promise.patches if p.get_x() == 1.0)
    assert red.get_x() + red.get_width() > 3.0
    assert texts(promise).count("1") == 1  # the number of refusals


def test_a_silently_wrong_answer_has_a_ring_and_an_infinite_error_is_at_the_edge(liar):
    for ax in drawn(liar)[:3]:
        rings = [line for line in ax.lines if line.get_marker() == "o"]
        assert [len(line.get_xdata()) for line in rings] == [1]
    _, promise, estimate, _ = drawn([answer(error=math.inf), answer("ok", estimate=math.inf)])
    assert PROMISE[1] in [x for x, _ in marks(promise)]
    assert len(marks(estimate)) == 2


def test_counts_are_written_beside_the_rows():
    answers = [answer("good"), answer("bad", error=1.0, cost=1.0)]
    answers += [answer("mute", estimate=None, cost=2.0), answer("lost", absent=FAILED)]
    cost, promise, estimate, counts = drawn(answers)
    assert [t.get_text() for t in cost.get_yticklabels()] == ["good", "bad", "mute", "lost"]
    assert "no answer" in texts(promise)
    assert texts(estimate).count("no estimate") == 1
    assert {"1.0 ms", "1.0 s", "2.0 s", "100", "0.0"} <= set(texts(counts))
    assert cost.get_xlabel() == "time of a run"
    several = drawn([*answers, answer("good", problem="b")])
    assert several[0].get_xlabel() == "time over the cheapest that kept its word"

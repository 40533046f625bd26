"""measure.py: what is timed, what the front is, what the chart shows."""

from itertools import cycle, pairwise

import mpmath as mp
import pytest
from hypothesis import given
from hypothesis import strategies as st

from newton_euler import Frame
from newton_euler.accuracy import Measured, chart, front, relative_error, timed
from newton_euler.accuracy.measurements.measure import EQUAL_WITHIN, NEAR

positive = st.floats(1e-9, 1.0)
measured = st.builds(Measured, st.sampled_from("abc"), positive, positive | st.just(0.0))
point_lists = st.lists(measured, min_size=1, max_size=12)


class Clock:
    """A clock that advances only when it is set."""

    now = 0.0

    def __call__(self):
        return self.now


def test_a_time_is_that_of_one_call_after_the_first_whatever_else_runs():
    calls, clock = [], Clock()

    def f():
        clock.now += 1e-3 if calls else 0.05
        calls.append(1)

    assert timed(f, runs=3, shortest=3e-3, clock=clock) == pytest.approx(1e-3)
    assert len(calls) > 3 * 2
    clock, delays = Clock(), cycle((0.0, 0.3, 0.02))

    def f():
        clock.now += 1e-3 + next(delays)

    assert timed(f, runs=3, shortest=1e-3, clock=clock) == pytest.approx(1e-3)
    order = []
    calls = (lambda: order.append("a")), (lambda: order.append("b"))
    assert min(timed(*calls, runs=2, shortest=1e-5)) > 0
    changes = sum(a != b for a, b in pairwise(order))
    assert changes == 5  # a, b to find how many calls are enough, then two rounds of a, b


@given(point_lists)
def test_nothing_on_the_front_is_beaten_and_everything_else_is(points):
    best = front(points)
    costs, errors = [p.cost for p in best], [p.error for p in best]
    assert costs == sorted(costs)
    assert all(b < a / EQUAL_WITHIN for a, b in pairwise(errors))
    for p in points:
        no_worse = max(NEAR, EQUAL_WITHIN * p.error)
        assert p in best or [q for q in best if q.cost <= p.cost and q.error <= no_worse]


@pytest.mark.parametrize("error", [3e-16, 5e-17])
def test_round_off_that_differs_does_not_make_a_front(error):
    quick, slow = Measured("quick", 1e-6, 4e-16), Measured("slow", 1e-3, error)
    assert front([slow, quick]) == [quick]


def test_errors_are_measured_in_the_digits_of_the_reference():
    with mp.workdps(40):
        third = mp.mpf(1) / 3
        found = relative_error((third + mp.mpf(10) ** -30, 0, 0), (third, 0, 0))
        assert found == pytest.approx(3e-30)
    assert relative_error(Frame("ground").vector(0.0, 1.5, 0.0), (0.0, 1.0, 0.0)) == 0.5


def test_a_chart_names_every_method_once_and_draws_errors_below_the_floor_there(ax):
    points = [Measured("coarse", 1e-6, e) for e in (1e-2, 1e-4)]
    points += Measured("fine", 1e-3, 1e-9), Measured("beaten", 1e-2, 1e-9)
    assert chart(points, ax) == [points[1], points[2]]
    names = [text.get_text() for text in ax.get_legend().get_texts()]
    assert names == ["coarse", "fine", "beaten", "front"]
    assert (ax.get_xscale(), ax.get_yscale()) == ("log", "log")
    ax.figure.canvas.draw()
    chart([Measured("many digits", 1e-3, 3e-31), Measured("exact", 1e-4, 0.0)], ax)
    assert {text.get_text() for text in ax.texts} == {"3e-31", "0", "better"}
    lowest, _ = ax.get_ylim()
    assert 0 < lowest < 1e-17
    ax.figure.canvas.draw()


@pytest.mark.parametrize(
    ("repeats", "ringed"),
    [((2e-6, 4e-6, 5e-6), ["surely", "cheap"]), ((2e-6, 4e-6, 6e-5), ["surely"])],
    ids=["all repeats agree", "one repeat contradicts"],
)
def test_only_ways_that_win_in_all_repeats_are_ringed(ax, repeats, ringed):
    """Two ways with equal errors: which is cheaper must not depend on a single repeat."""
    points = [Measured("surely", 1e-9, 1e-2, repeats=(1e-9,) * 3)]
    points += [Measured("cheap", 4e-6, 1e-9, repeats=repeats)]
    points += [Measured("dear", 3e-5, 1e-9, repeats=(3e-5,) * 3)]
    assert [p.method for p in chart(points, ax)] == ringed
    (rings,) = (line for line in ax.lines if line.get_label() == "front")
    assert list(rings.get_xdata()) == [p.cost for p in points if p.method in ringed]

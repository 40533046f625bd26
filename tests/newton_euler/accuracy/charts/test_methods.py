"""charts/methods.py: what is drawn for the methods on a scene, and what the caption says."""

from dataclasses import replace

import pytest
from matplotlib.figure import Figure

from newton_euler.accuracy.charts.axes import chart, marker_style
from newton_euler.accuracy.charts.methods import draw_methods, methods_caption
from newton_euler.accuracy.measurements.measure import Measured, front, of_repeats
from newton_euler.accuracy.measurements.work_precision import (
    CLOSED,
    NAMES,
    STEPPING,
    WorkPrecision,
    work_precision,
)
from newton_euler.scenes.catalogue import Scene

FAKE = Scene("fake", "1.1", "nothing", lambda: None)


def synthetic():
    points = [Measured(m, c * 10**-n, 10 ** (-n - m_), "", 10.0**-n, int(1e6 * c), 10.0 ** (-n - 1))
              for m, c, m_ in (("taylor", 1e-5, 1), ("dop853", 1e-4, 2), ("auto", 3e-6, 1)) for n in (3, 6, 9)]  # fmt: skip
    exact = Measured("exact", 1.0, 0.0, "", 1e-3, 1, 0.0)
    return WorkPrecision(FAKE, (*points, exact), {}, {"taylor": 0.04}, {}, {})


def lines(ax, label):
    (line,) = (line for line in ax.lines if line.get_label() == label)
    return [list(x) for x in line.get_data()]


def test_the_front_is_drawn_from_the_points_without_auto():
    found, figure = synthetic(), Figure()
    best = draw_methods(found, figure)
    methods = [p for p in found.points if p.method != "auto"]
    assert [(p.method, p.cost) for p in best] == [(p.method, p.cost) for p in front(methods)]
    left, middle, right = figure.axes
    assert lines(left, "front") == [[p.cost for p in best], [max(p.error, 1e-17) for p in best]]
    assert lines(middle, "front")[0] == [p.calls for p in front(methods, "calls")]
    assert lines(right, "auto")[0] == [1e-3, 1e-6, 1e-9]
    assert any("40 ms to prepare" in text.get_text() for text in figure.legends[0].get_texts())
    figure.canvas.draw()


def test_a_scene_without_invariants_says_so_on_its_chart():
    figure = Figure()
    draw_methods(work_precision("low, friction", (1e-3, 1e-6), ("dop853", "auto")), figure)
    assert figure.axes[2].get_title() == "no invariant is known"
    figure.canvas.draw()


def test_every_method_has_its_own_look():
    assert len({tuple(marker_style(n).values()) for n in range(len(NAMES))}) == len(NAMES)
    ax = Figure().subplots()
    chart([Measured(f"way {n}", 10.0**-n, 1e-9) for n in range(12)], ax)
    drawn = {(x.get_color(), x.get_marker(), x.get_markerfacecolor()) for x in ax.lines[:12]}
    assert len(drawn) == 12


def measured(closed=(1e-6, 1e-15), prepared=0.0, **stepping):
    """Made-up measurements: (cost, error) of the stepping methods and of the closed form."""
    points = [Measured(n, *x, asked=1e-6, family=STEPPING) for n, x in stepping.items()]
    points += [Measured("exact", *closed, family=CLOSED)] if closed else []
    return WorkPrecision(FAKE, tuple(points), {}, {"taylor": prepared}, {}, {})


SLOW = {"taylor": (1e-4, 1e-8)}


@pytest.mark.parametrize(
    ("found", "words"),
    [
        ({"taylor": (1e-5, 1e-8), "dop853": (1e-4, 1e-8)},
         "taylor is the cheapest stepping method. There dop853 takes about 10 times as long as taylor."),
        ({"dop853": (1e-5, 1e-8), "taylor": (1e-4, 1e-8)},
         "dop853 is the cheapest stepping method. There taylor takes about 10 times as long as dop853."),
        ({"taylor": (1e-5, 1e-8), "dop853": (2.9e-5, 1e-8)}, "taylor and dop853 cost about the same, least."),
        (SLOW, "cheaper than every stepping method"),
        ({"closed": (5e-5, 1e-15), **SLOW}, "It costs about as much as the cheapest stepping method."),
        ({"closed": (1e-3, 1e-15), **SLOW}, "It takes about 10 times as long as taylor at its coarsest."),
        ({"closed": None, **SLOW}, "There is no closed form."),
        ({"closed": (1e-6, 0.0), **SLOW}, "is right to 2.2 × 10⁻¹⁶"),
        ({"taylor": (1e-5, 1e-8)}, "No stepping method that was measured is right to 10⁻¹⁰."),
    ],
    ids=["the cheapest", "two methods swapped", "alike below three", "a cheap closed form", "one alike", "a dear closed form",
         "no closed form", "a closed form without an error", "what no method reaches"],
)  # fmt: skip
def test_the_caption_of_methods_follows_from_what_was_measured(found, words):
    assert words in methods_caption(measured(**found))


def test_the_runs_that_earn_back_a_preparation_are_counted_by_their_size():
    found = measured(prepared=0.1, taylor=(1e-4, 1e-8), dop853=(1.1e-3, 1e-8))
    assert "taylor takes about 100 ms to prepare" in methods_caption(found)
    assert "Against dop853 that is earned back by about 100 runs" in methods_caption(found)


def test_the_caption_has_only_what_all_repeats_agree_on():
    """A pendulum on a busy or quiet machine: dop853 took 12 to 25 times as long, or 24 times."""
    busy = {"taylor": [79, 75, 62, 39, 37], "dop853": [908, 866, 843, 883, 911]}

    def caption(**times):
        point = Measured("", 0.0, 1e-8, asked=1e-6, family=STEPPING)
        points = (replace(point, method=name, **of_repeats(t)) for name, t in times.items())
        return methods_caption(WorkPrecision(FAKE, tuple(points), {}, {}, {}, {}))

    busy_caption = caption(**busy)
    quiet_caption = caption(**busy | {"taylor": [36, 36, 41, 36, 39]})
    assert "taylor is the cheapest stepping method" in busy_caption
    assert "There dop853 takes about 30 times as long as taylor" in quiet_caption
    assert "There dop853" not in busy_caption


def test_the_band_of_a_point_spans_its_repeats_and_a_bar_its_preparation():
    ax = Figure().subplots()
    point = replace(Measured("dop853", 0.0, 1e-8), **of_repeats([3e-6, 1e-6, 2e-6]))
    assert point.cost == 2e-6
    chart([point], ax)
    assert [1e-6, 3e-6] in [list(line.get_xdata()) for line in ax.lines]
    ax = Figure().subplots()
    chart([Measured("taylor", 1e-4, 1e-8, prepared=0.1), Measured("dop853", 1e-3, 1e-8)], ax)
    assert lines(ax, "first run, with preparation")[0] == [1e-4, 1e-4 + 0.1]
    wrong, right = Measured("wrong", 1e-9, 1.0), Measured("right", 1e-3, 1e-9)
    assert chart([wrong, right], Figure().subplots()) == [right]


def test_stepping_methods_have_their_own_front_beside_that_of_closed_forms():
    figure = Figure()
    ax = figure.subplots()
    found = measured(taylor=(1e-4, 1e-8), dop853=(1e-3, 1e-8))
    assert [p.method for p in chart(found.points, ax)] == ["taylor", "exact"]
    labels = {line.get_label() for line in ax.lines}
    assert {"front of the stepping methods", "front of the closed forms"} <= labels
    figure.canvas.draw()

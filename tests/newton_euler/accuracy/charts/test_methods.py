"""charts/methods.py: what is drawn of the methods on a scene, and what its caption says."""

import matplotlib
from matplotlib.figure import Figure

from newton_euler.accuracy.charts.axes import chart, marker_style
from newton_euler.accuracy.charts.methods import draw_methods, methods_caption
from newton_euler.accuracy.measurements.measure import Measured, front
from newton_euler.accuracy.measurements.work_precision import (
    CLOSED,
    NAMES,
    STEPPING,
    WorkPrecision,
    work_precision,
)
from newton_euler.scenes.catalogue import Scene

matplotlib.use("Agg")


def synthetic():
    points = [Measured(m, c * 10**-n, 10 ** (-n - m_), "", 10.0**-n, int(1e6 * c), 10.0 ** (-n - 1))
              for m, c, m_ in (("taylor", 1e-5, 1), ("dop853", 1e-4, 2), ("auto", 3e-6, 1)) for n in (3, 6, 9)]  # fmt: skip
    fake = Scene("fake", "1.1", "nothing", lambda: None)
    return WorkPrecision(
        fake, (*points, Measured("exact", 1.0, 0.0, "", 1e-3, 1, 0.0)), {}, {"taylor": 0.04}, {}, {}
    )


def test_the_front_is_drawn_from_the_points_without_auto():
    found, figure = synthetic(), Figure()
    best = draw_methods(found, figure)
    methods = [p for p in found.points if p.method != "auto"]
    assert [(p.method, p.cost) for p in best] == [(p.method, p.cost) for p in front(methods)]
    left, middle, right = figure.axes
    (rings,) = (line for line in left.lines if line.get_label() == "front")
    assert list(zip(*rings.get_data(), strict=True)) == [
        (p.cost, max(p.error, 1e-17)) for p in best
    ]
    (rings,) = (line for line in middle.lines if line.get_label() == "front")
    assert list(rings.get_xdata()) == [p.calls for p in front(methods, "calls")]
    (auto,) = (line for line in right.lines if line.get_label() == "auto")
    assert list(auto.get_data()[0]) == [1e-3, 1e-6, 1e-9]
    assert any("40 ms to prepare" in text.get_text() for text in figure.legends[0].get_texts())
    figure.canvas.draw()


def test_a_scene_without_invariants_says_so_on_its_chart():
    figure = Figure()
    draw_methods(work_precision("low, friction", (1e-3, 1e-6), ("dop853", "auto")), figure)
    assert figure.axes[2].get_title() == "no invariant is known"
    figure.canvas.draw()


def test_all_methods_have_a_look_of_their_own():
    looks = [tuple(marker_style(n).values()) for n in range(len(NAMES))]
    assert len(set(looks)) == len(NAMES)


def measured(closed=(1e-6, 1e-15), prepared=0.0, **stepping):
    """What was measured, doctored: (cost, error) of methods that step, and of the closed form."""
    points = [Measured(n, *x, asked=1e-6, family=STEPPING) for n, x in stepping.items()]
    points += [Measured("exact", *closed, family=CLOSED)] if closed else []
    preparing = {"taylor": prepared}
    return WorkPrecision(
        Scene("fake", "1.1", "nothing", lambda: None), tuple(points), {}, preparing, {}, {}
    )


def test_the_caption_names_the_cheapest_and_follows_when_two_methods_are_swapped():
    output = methods_caption(measured(taylor=(1e-5, 1e-8), dop853=(1e-4, 1e-8)))
    assert "taylor is the cheapest stepping method, at 10 µs; next comes dop853, 10 times" in output
    output = methods_caption(measured(dop853=(1e-5, 1e-8), taylor=(1e-4, 1e-8)))
    assert "dop853 is the cheapest stepping method, at 10 µs; next comes taylor, 10 times" in output


def test_methods_whose_times_differ_by_less_than_a_fifth_are_called_equal():
    output = methods_caption(measured(taylor=(1e-5, 1e-8), dop853=(1.15e-5, 1e-8)))
    assert "taylor and dop853 cost the same among the stepping methods" in output


def test_the_closed_form_is_called_cheaper_only_where_it_is():
    slow = {"taylor": (1e-4, 1e-8)}
    assert "cheaper than every stepping method" in methods_caption(measured(**slow))
    output = methods_caption(measured(closed=(1e-3, 1e-15), **slow))
    assert "10 times as long as taylor at its coarsest" in output
    assert "There is no closed form." in methods_caption(measured(closed=None, **slow))


def test_what_no_method_reaches_is_stated():
    output = methods_caption(measured(taylor=(1e-5, 1e-8)))
    assert "No stepping method that was measured is right to 10⁻¹⁰." in output


def test_the_runs_that_earn_back_a_preparation_are_counted():
    found = measured(prepared=0.1, taylor=(1e-4, 1e-8), dop853=(1.1e-3, 1e-8))
    assert "taylor takes 100 ms to prepare" in methods_caption(found)
    assert "earned back against dop853 by 100 runs" in methods_caption(found)


def test_stepping_methods_have_a_front_beside_that_of_closed_forms():
    figure, ax = (f := Figure()), f.subplots()
    found = measured(taylor=(1e-4, 1e-8), dop853=(1e-3, 1e-8))
    best = chart(found.points, ax)
    assert [p.method for p in best] == ["taylor", "exact"]
    labels = {line.get_label() for line in ax.lines}
    assert {"front of the stepping methods", "front of the closed forms"} <= labels
    figure.canvas.draw()


def test_the_preparation_is_a_bar_that_ends_at_the_time_of_the_first_run():
    ax = Figure().subplots()
    chart([Measured("taylor", 1e-4, 1e-8, prepared=0.1), Measured("dop853", 1e-3, 1e-8)], ax)
    (bar,) = (line for line in ax.lines if line.get_label() == "first run, with preparation")
    assert list(bar.get_xdata()) == [1e-4, 1e-4 + 0.1]


def test_the_corner_says_that_it_is_better_there():
    ax = Figure().subplots()
    chart([Measured("taylor", 1e-4, 1e-8)], ax)
    assert "better" in {text.get_text() for text in ax.texts}


def test_a_point_without_a_right_digit_has_no_ring():
    wrong, right = Measured("wrong", 1e-9, 1.0), Measured("right", 1e-3, 1e-9)
    assert chart([wrong, right], Figure().subplots()) == [right]


def test_a_closed_form_without_an_error_is_called_right_to_round_off():
    found = measured(closed=(1e-6, 0.0), taylor=(1e-4, 1e-8))
    assert "is right to 2.2 × 10⁻¹⁶" in methods_caption(found)

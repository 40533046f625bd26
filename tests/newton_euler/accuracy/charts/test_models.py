"""charts/models.py: what is drawn of a ladder of models, which rung is ringed, what the caption says."""

from types import SimpleNamespace

import matplotlib
from matplotlib.figure import Figure

from newton_euler.accuracy.charts.models import (
    MeasuredModel,
    choice,
    draw_models,
    measured_models,
    models_caption,
    usual_tolerance,
)
from newton_euler.scenes import ladder
from newton_euler.scenes.ladders import Ladder, Rung
from newton_euler.scenes.particles import projectile

matplotlib.use("Agg")


def shots():
    def seen(s, p, t):
        return s.x, s.y, s.z

    start = (0.0, 0.0, 0.0, 200.0, 0.0, 200.0)
    return Ladder(
        "shots",
        projectile.POSITION,
        5.0,
        (
            Rung(projectile.coriolis(9.82, 0.8), start, seen),
            Rung(projectile.full(9.82, 0.8), start, seen),
        ),
    )


def test_models_are_charted_against_the_fullest():
    rungs, figure = shots(), Figure()
    points = measured_models(rungs)
    assert [p.error for p in points] == [rungs.error(rungs.rungs[0]), 0.0]
    assert 0.01 < points[0].error < 10  # m
    assert all(p.cost > 0 for p in points)
    chosen = draw_models(points, rungs, figure)
    assert chosen in points
    (ax,) = figure.axes
    assert projectile.POSITION in ax.get_ylabel()
    entries = [text.get_text() for text in ax.get_legend().get_texts()]
    assert all(any(rung.name in entry for entry in entries) for rung in rungs.rungs)
    assert "drops the Coriolis acceleration beyond the first order" in entries[0]
    low, high = ax.get_ylim()
    assert low < points[0].error / 100 < rungs.rungs[0].bound(5.0) < high
    figure.canvas.draw()


def models(**costs_and_errors):
    """Measured models by their names, each given as (cost, error)."""
    return [MeasuredModel(n, *x, drops=(f"the {n}",)) for n, x in costs_and_errors.items()]


def ladder_of(points):
    return SimpleNamespace(name="doctored", of="place, m", t=1.0)


def rings(points, tolerance):
    """The places of the rings that are drawn."""
    figure = Figure()
    draw_models(points, ladder_of(points), figure, tolerance)
    lines = [line for line in figure.axes[0].lines if line.get_markersize() == 19]
    return [tuple(map(float, line.get_xdata())) for line in lines]


def test_the_cheapest_model_within_the_tolerance_is_ringed_and_named():
    points = models(bare=(1e-6, 1.0), rich=(5e-6, 1e-2), full=(1e-3, 0.0))
    assert rings(points, 0.1) == [(5e-6,)]
    assert "cheapest model is 2 (rich), 5 µs a run" in models_caption(
        points, ladder_of(points), 0.1
    )


def test_with_the_costs_of_two_models_swapped_ring_and_caption_follow():
    points = models(bare=(1e-6, 1.0), rich=(1e-3, 1e-2), full=(5e-6, 0.0))
    assert rings(points, 0.1) == [(5e-6,)]
    caption = models_caption(points, ladder_of(points), 0.1)
    assert "cheapest model is 3 (full), 5 µs a run" in caption
    assert "2 (rich) costs more than 3 and is less accurate." in caption


def test_the_coarsest_model_is_not_ringed_where_it_is_beyond_the_tolerance_though_it_is_cheapest():
    points = models(bare=(1e-9, 1.0), full=(1.0, 0.0))
    assert choice(points, 0.1) is points[1]
    assert choice(points, 2.0) is points[0]


def test_no_model_is_ringed_where_none_is_within_the_tolerance():
    points = models(bare=(1e-6, 1.0), rich=(5e-6, 0.5))
    assert rings(points, 0.1) == []
    assert models_caption(points, ladder_of(points), 0.1).startswith("No model stays within 0.1 m.")


def test_of_models_that_cost_the_same_the_simplest_is_chosen_and_the_others_are_named():
    points = models(bare=(1.1e-6, 0.05), full=(1e-6, 0.0))
    assert choice(points, 0.1) is points[0]
    caption = models_caption(points, ladder_of(points), 0.1)
    assert "2 (full) costs about the same" in caption
    assert "The fullest model costs no more than the cheapest." in caption


def test_the_usual_tolerance_lies_between_the_errors():
    points = models(bare=(1e-6, 100.0), odd=(1e-6, 21.0), same=(2e-6, 1e-13), full=(1e-3, 0.0))
    assert 21.0 < usual_tolerance(points) < 100.0


def test_all_ladders_of_the_book_are_drawn_also_those_with_errors_of_kilometres():
    rungs, figure = ladder("satellite", t=600.0), Figure()
    points = measured_models(rungs)
    assert max(p.error for p in points) > 1e3
    draw_models(points, rungs, figure)
    figure.canvas.draw()


def test_a_bar_goes_from_the_median_of_the_error_to_its_largest():
    rungs = shots()
    coarse, _ = measured_models(rungs)
    distances = rungs.distances(rungs.rungs[0])
    assert coarse.usual == sorted(distances)[len(distances) // 2]
    assert coarse.error == max(distances) > coarse.usual > 0

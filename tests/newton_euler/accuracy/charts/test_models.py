"""charts/models.py: what is drawn for a ladder of models, which rung is ringed, the caption."""

from types import SimpleNamespace

import pytest
from matplotlib.figure import Figure

from newton_euler import integrate, smallest
from newton_euler.accuracy.charts.models import (
    MeasuredModel,
    choice,
    draw_models,
    measured_models,
    models_caption,
    usual_tolerance,
)
from newton_euler.scenes import LADDERS, Ladder, Rung, ladder
from newton_euler.scenes.particles import projectile


@pytest.fixture(scope="module")
def shots():
    start = (0.0, 0.0, 0.0, 200.0, 0.0, 200.0)
    models = (projectile.shot(rung, 9.82, 0.8) for rung in ("Coriolis to first order", "full"))
    rungs = tuple(Rung(model, start, lambda s, p, t: (s.x, s.y, s.z)) for model in models)
    return Ladder("shots", projectile.POSITION, 5.0, rungs)


def test_models_are_charted_against_the_fullest(shots):
    points, figure = measured_models(shots), Figure()
    assert [p.error for p in points] == [shots.error(shots.rungs[0]), 0.0]
    assert 0.01 < points[0].error < 10  # m
    assert all(p.cost > 0 for p in points)
    assert draw_models(points, shots, figure) in points
    (ax,) = figure.axes
    assert projectile.POSITION in ax.get_ylabel()
    entries = [text.get_text() for text in ax.get_legend().get_texts()]
    assert all(any(rung.name in entry for entry in entries) for rung in shots.rungs)
    assert "drops the Coriolis acceleration beyond the first order" in entries[0]
    low, high = ax.get_ylim()
    assert low < points[0].error / 100 < shots.rungs[0].bound(5.0) < high
    figure.canvas.draw()


def test_a_bar_runs_from_the_median_error_to_the_largest_at_a_counted_cost(shots):
    coarse, _ = measured_models(shots)
    distances = shots.distances(shots.rungs[0])
    assert coarse.usual == sorted(distances)[len(distances) // 2]
    assert coarse.error == max(distances) > coarse.usual > 0
    first, again = measured_models(shots), measured_models(shots)
    assert [p.cost for p in first] == [p.cost for p in again]
    runs = [integrate(r.model, 5.0, r.start, 1e-9, "dop853") for r in shots.rungs]
    operations = [r.model.compiled_rhs(*r.model.parameters).operations for r in shots.rungs]
    counted = [n * run.cost.calls for n, run in zip(operations, runs, strict=True)]
    assert [p.cost for p in first] == counted


def models(**costs_and_errors):
    """Measured models by their names, each given as (cost, error)."""
    return [MeasuredModel(n, *x, drops=(f"the {n}",)) for n, x in costs_and_errors.items()]


@pytest.mark.parametrize(
    ("points", "ringed", "words"),
    [
        (models(bare=(100, 1.0), rich=(500, 1e-2), full=(9000, 0.0)), 1,
         ["smallest model is 2 (rich), 500 operations a run",
          "The fullest takes 90 times as many operations as the cheapest, bare."]),
        (models(bare=(100, 1.0), rich=(9000, 1e-2), full=(500, 0.0)), 1,
         ["smallest model is 2 (rich), 9000 operations a run", "2 (rich) costs more than 3 and is less accurate."]),
        (models(bare=(100, 1.0), rich=(500, 0.5)), None, ["No model stays within 0.1 m."]),
        (models(bare=(110, 0.05), full=(100, 0.0)), 0,
         ["2 (full) costs about the same", "The fullest model costs no more than the cheapest."]),
    ],
    ids=["the smallest within the tolerance", "two costs swapped", "none within the tolerance", "equal costs"],
)  # fmt: skip
def test_the_choice_is_ringed_and_named(points, ringed, words):
    figure, doctored = Figure(), SimpleNamespace(name="doctored", of="place, m", t=1.0)
    draw_models(points, doctored, figure, 0.1)
    lines = [line for line in figure.axes[0].lines if line.get_markersize() == 19]
    expected = [] if ringed is None else [(points[ringed].cost,)]
    assert [tuple(map(float, line.get_xdata())) for line in lines] == expected
    caption = models_caption(points, doctored, 0.1)
    assert [w for w in words if w not in caption] == []


@pytest.mark.parametrize("name", LADDERS)
def test_the_ring_is_on_the_model_that_smallest_takes_whatever_they_cost(name):
    rungs = ladder(name)
    points = measured_models(rungs)
    errors = [p.error for p in points if p.error > 0]
    for tolerance in (0.2, *(1.5 * e for e in errors), *(0.7 * e for e in errors)):
        assert choice(points, tolerance).method == smallest(rungs, tolerance).rung.name


def test_the_usual_tolerance_lies_between_the_errors():
    points = models(bare=(1e-6, 100.0), odd=(1e-6, 21.0), same=(2e-6, 1e-13), full=(1e-3, 0.0))
    assert 21.0 < usual_tolerance(points) < 100.0


def test_the_legend_names_all_that_a_model_drops():
    rungs, figure = ladder("projectile"), Figure()
    draw_models(measured_models(rungs), rungs, figure)
    entries = [text.get_text() for text in figure.axes[0].get_legend().get_texts()]
    assert all("air" in text for text in entries[:3])
    assert not any(text.endswith("more") for text in entries)

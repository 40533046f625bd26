"""Maps of parameter space: choices at known points, borders where theory has them, and what is
drawn.
"""

import math

import matplotlib
import mpmath
import numpy as np
import pytest

from newton_euler.accuracy.charts.axes import COLOURS
from newton_euler.accuracy.charts.maps import draw_choices
from newton_euler.accuracy.measurements import regime_maps as maps
from newton_euler.accuracy.measurements.regime_maps import MAPS
from newton_euler.motion.integration import integrate


def border(chart, x, below, precision=0.02):
    """The lowest y at which the choice differs from ``below``, by bisection."""
    low, high = chart.y.low, chart.y.high
    while high - low > precision * low:
        middle = math.sqrt(low * high)
        is_below = next(iter(chart.column(x, [middle]))) in below
        low, high = (middle, high) if is_below else (low, middle)
    return low


@pytest.mark.parametrize("chart", MAPS.values(), ids=MAPS)
def test_a_map_says_what_it_shows_with_units_and_has_a_colour_for_each_choice(chart):
    assert len(set(chart.choices)) == len(chart.choices) <= len(COLOURS)
    for axis in (chart.x, chart.y):
        assert any(unit in axis.label for unit in ("rad", "s", "m", "degrees", "over"))
    assert chart.words.endswith(".")
    for axis in (chart.x, chart.y):
        edges, middles = axis.edges(7), axis.centres(7)
        assert (edges[0], edges[-1]) == (pytest.approx(axis.low), pytest.approx(axis.high))
        assert np.all((edges[:-1] < middles) & (middles < edges[1:]))


def test_measuring_reports_its_progress_and_gives_a_row_for_each_y():
    output = []
    found = MAPS["steady precession"].measure((4, 3), output.append)
    assert output == [0.0, 0.25, 0.5, 0.75]
    assert found.shape == (3, 4)
    # at 30, 90 and 150 degrees
    assert [row[0] for row in found] == [maps.NONE, maps.BOTH, maps.OPPOSED]


@pytest.mark.parametrize(("compiling", "short"), [(1e3, maps.DOP853), (-1e3, maps.TAYLOR)])
def test_which_method_is_for_a_short_and_for_a_long_run(compiling, short, monkeypatch):
    """A short run is for what need not be compiled, and a long one beside the axis for the exact
    solution alone. Here compiling either takes a thousand seconds or has a negative cost.
    """
    pytest.importorskip("heyoka")
    monkeypatch.setattr(maps, "compile_time", lambda: compiling)
    near, far = (list(MAPS["free body"].column(tilt, [5.0, 1000.0])) for tilt in (1e-6, 0.5))
    assert near == [short, maps.EXACT]
    assert far[0] == short
    assert far[1] in (maps.DOP853, maps.TAYLOR)


def test_integration_fails_where_round_off_has_grown_to_the_accuracy_wanted():
    """Within a factor of five of the theory: a random walk is known only on average."""
    pytest.importorskip("heyoka")
    for tilt in (1e-7, 1e-5, 3e-3, 1e-2):
        times = np.geomspace(10.0, 2e4, 60)
        right = np.isfinite(maps._taylor_seconds(times.tolist(), maps.start_at(tilt)))
        assert 1 / 5 < times[right][-1] / maps._roundoff_time(tilt) < 5


def test_errors_of_a_run_are_those_against_30_digits():
    start = maps.start_at(0.01)
    motion = integrate(maps.BODY, 60.0, start, 1e-6, "dop853", samples=50)
    found = maps.errors_until([60.0], motion, start)[0]
    with mpmath.workdps(30):
        exact = [maps.BODY.solution(mpmath.mpf(t), start) for t in motion.times.tolist()]
    w = [*motion.states.values()]
    worst = max(abs(float(x - w[n][k])) for k, e in enumerate(exact) for n, x in enumerate(e))
    assert found == pytest.approx(worst, rel=1e-3)


def test_the_first_turnover_is_at_the_quarter_period_of_a_small_tilt():
    for tilt in (1e-6, 1e-3):
        t = maps._first_turnover(tilt)
        # rad/s: the rate is on its way from +1 to -1
        assert abs(maps.BODY.solution(t, maps.start_at(tilt))[1]) < 0.4
        assert maps.BODY.solution(t / 2, maps.start_at(tilt))[1] > 0.99


def test_without_heyoka_the_exact_solution_takes_its_place(monkeypatch):
    monkeypatch.setattr(maps, "installed", lambda: False)
    maps.compile_time.cache_clear()
    found = list(maps._free_body(0.5, [2.0]))
    maps.compile_time.cache_clear()
    assert found == [maps.DOP853]


@pytest.mark.one_in(3)
@pytest.mark.parametrize("flight", [2.0, 10.0, 40.0])
def test_a_flat_earth_at_rest_holds_until_the_centrifugal_acceleration_is_seen(flight):
    """And a uniform field until the weight is seen to be less above."""
    chart = MAPS["projectile"]
    below = {name for name in chart.choices if name != "projectile, flat"}
    assert border(chart, flight, below) == pytest.approx(chart.curves[0].y(flight), rel=0.15)
    uniform = border(chart, flight, {"projectile, full"})
    assert uniform == pytest.approx(chart.curves[1].y(flight), rel=0.1)


@pytest.mark.one_in(3)
@pytest.mark.parametrize("omega_z", [150.0, 400.0, 900.0])
def test_a_top_let_go_nods_and_below_its_nutation_only_a_model_that_nods_holds(omega_z):
    chart = MAPS["top"]
    nods = {"top, nutation and precession", chart.choices[-2], chart.choices[-1]}
    assert border(chart, omega_z, nods) == pytest.approx(chart.curves[0].y(omega_z), rel=0.1)


def test_a_top_that_is_too_slow_has_no_rung_of_steady_precession():
    assert "top, steady precession" not in maps.rung_names(maps.released_top(17.0))
    assert "top, steady precession" in maps.rung_names(maps.released_top(19.0))
    assert 17.0 < next(curve.x for curve in MAPS["top"].curves if curve.x) < 19.0


@pytest.mark.one_in(3)
@pytest.mark.parametrize("ratio", [0.8, 0.95, 0.99])
def test_a_top_below_the_critical_rate_falls_when_its_growth_rate_predicts(ratio):
    predicted = float(maps._theoretical_falling_time(np.array(ratio)))
    assert maps.falling_time(ratio) == pytest.approx(predicted, rel=0.02)


def test_near_the_critical_rate_the_criterion_decides_and_the_run_does_not():
    chart = MAPS["sleeping top"]
    assert list(chart.column(0.9999, [10.0, 99.0])) == [maps.UNDECIDED] * 2
    assert list(chart.column(1.0001, [10.0, 99.0])) == [maps.STANDS] * 2
    assert list(chart.column(0.9, [1.0, 50.0])) == [maps.UNDECIDED, maps.FALLS]


@pytest.mark.parametrize("omega_z", [5.0, 12.0, 19.0])
def test_steady_precession_ends_at_the_double_root(omega_z):
    chart = MAPS["steady precession"]
    edge = float(maps._limit_angle(np.array(omega_z)))
    assert list(chart.column(omega_z, [edge - 0.01, edge + 0.01])) == [maps.NONE, maps.BOTH]


@pytest.mark.one_in(3)
@pytest.mark.parametrize("name", ["steady precession", "projectile", "sleeping top"])
def test_a_map_is_drawn_with_a_legend_of_what_it_holds_and_the_curves_of_theory(name, ax):
    chart = MAPS[name]
    found = chart.measure((6, 6))
    draw_choices(chart, found, ax)
    output = [text.get_text() for text in ax.get_legend().get_texts()]
    shown = [choice for choice in chart.choices if (found == choice).any()]
    assert output == shown + [curve.label for curve in chart.curves]
    assert (ax.get_xlabel(), ax.get_ylabel()) == (chart.x.label, chart.y.label)
    assert ax.get_xlim() == (chart.x.low, pytest.approx(chart.x.high))
    ax.figure.canvas.draw()
    mesh = ax.collections[0]
    colours = {tuple(np.round(c[:3], 3)) for c in mesh.cmap(mesh.norm(mesh.get_array().ravel()))}
    wanted = [COLOURS[chart.choices.index(c)] for c in set(found.ravel())]
    assert colours == {tuple(np.round(matplotlib.colors.to_rgb(c), 3)) for c in wanted}


@pytest.mark.slow
@pytest.mark.parametrize("name", MAPS)
def test_every_map_is_drawn_at_its_own_resolution(name, ax):
    found = MAPS[name].measure()
    draw_choices(MAPS[name], found, ax)
    assert len(set(found.ravel())) >= 3

"""comparisons.py, baselines.py: what each comparison claims, measured; bounds on errors, none on
times.
"""

import math
from dataclasses import replace

import mpmath
import pytest
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure

from newton_euler.accuracy.charts.comparisons import draw_comparison
from newton_euler.accuracy.measurements import baselines
from newton_euler.accuracy.measurements.comparisons import COMPARISONS
from newton_euler.accuracy.measurements.measure import ROUND_OFF, Measured


@pytest.fixture(scope="module")
def measured():
    """All points of a comparison by its name, measured once."""
    known = {}

    def of(name):
        if name not in known:
            known[name] = COMPARISONS[name].measure()
        return known[name]

    return of


def errors(points, method, question=0):
    """{setting x: error} of a method."""
    asked = list(dict.fromkeys(p.question for p in points))[question]
    found = {p.x: p.error for p in points if p.method == method and p.question is asked}
    assert found
    return found


def test_errors_of_differences_fall_and_rise_and_a_complex_step_cancels_in_a_second_one(measured):
    points = measured("derivatives")
    assert 1e-12 < min(errors(points, "central difference").values()) < 1e-9
    assert 1e-9 < min(errors(points, "forward difference").values()) < 1e-7
    assert 1e-9 < min(errors(points, "central difference", 1).values()) < 1e-6
    for question in (0, 1):
        for way in ("engine, no step", "engine, traced"):
            assert max(errors(points, way, question).values()) < 4 * ROUND_OFF
    points = measured("derivatives")
    for question in (0, 1):
        forward = errors(points, "forward difference", question)
        central = errors(points, "central difference", question)
        assert forward[1e-1] / forward[1e-2] == pytest.approx(10, rel=0.2)
        assert central[1e-1] / central[1e-2] == pytest.approx(100, rel=0.05)
        assert central[1e-12] > 1e4 * min(central.values())
    points = measured("derivatives")
    first, second = errors(points, "complex step"), errors(points, "complex step", 1)
    assert max(first[h] for h in first if h < 1e-8) < 4 * ROUND_OFF
    assert min(second.values()) > 1e-9


def test_matrices_drift_and_euler_rates_fail_past_the_vertical_where_quaternions_do_not(measured):
    points = measured("rotations")
    for way in ("3 x 3 matrices", "matrices, NumPy"):
        assert errors(points, way, 1)[10000] > 1e-14 + 5 * errors(points, way, 1)[300]
    for way in ("quaternions", "Euler angles"):
        assert max(errors(points, way, 1).values()) < 1e-15
    assert errors(points, "quaternions")[10000] < errors(points, "3 x 3 matrices")[10000] / 3
    assert max(p.error for p in points if p.x >= 100) < 1e-12
    points = measured("rotations")
    angles = errors(points, "rates of Euler's angles", 2)
    quaternions = errors(points, "rate of a quaternion", 2)
    assert angles[1.0] < 1e-10
    assert all(angles[10.0**-n] > 30 * angles[10.0 ** (1 - n)] for n in (1, 2, 3))
    assert all(1e-3 < angles[10.0**-n] < 0.1 for n in (3, 4, 5, 6))
    assert max(quaternions.values()) < 1e-11


def test_points_converge_slowly_and_the_reference_by_strips_is_the_closed_form(measured):
    points = measured("inertia")
    random, grid = errors(points, "random points"), errors(points, "grid of points")
    assert 1e-5 < random[10**6] < 1e-2
    assert 1e-7 < grid[10**6] < 1e-4
    assert 10 < random[100] / random[10**6] < 1000  # as 1/sqrt(number)
    assert all(grid[n] < random[n] for n in grid)
    for way in ("engine, quadrature", "engine, composition"):
        assert max(errors(points, way).values()) < 4 * ROUND_OFF
    with mpmath.workdps(40):
        r, h, rho = (mpmath.mpf(x) for x in (baselines.RADIUS, baselines.HEIGHT, baselines.DENSITY))
        arc, triangle = rho * mpmath.pi * r * r, rho * r * h**3 / 2
        disk = arc * r * r / 8 + 4 * rho * r**3 * h / 3 + arc * h * h / 2
        across = rho * h * r**3 / 6 + arc * r * r / 8
        exact = across, triangle + disk, across + triangle + disk
        for found, known in zip(baselines.exact_inertia(), exact, strict=True):
            assert abs(found / known - 1) < mpmath.mpf(10) ** -35


def test_the_arc_cosine_and_the_printed_root_lose_digits_and_the_engine_none(measured):
    points = measured("angle")
    found = errors(points, "arc cosine of the trace")
    assert found[1.0] < 1e-15
    assert 1e-11 < found[1e-4] < 1e-7
    assert all(found[10.0**-n] == 1 for n in range(9, 13))
    assert errors(points, "arc cosine of the trace", 1)[1e-8] > 1e-10  # near pi: half the digits
    for question in (0, 1):
        for way in ("engine, atan2", "SciPy's Rotation"):
            assert max(errors(points, way, question).values()) < 3 * ROUND_OFF
    points = measured("steady precession")
    found = errors(points, "printed root")
    for a, error in found.items():
        assert error < 1e-14 * 0.01 / a
    assert found[1e-16] > 1e-3
    assert found[1e-12] > 1e-7
    assert max(errors(points, "engine").values()) < 3 * ROUND_OFF


@pytest.mark.parametrize("name", COMPARISONS)
def test_points_are_measured_with_cost_and_setting(name, measured):
    assert COMPARISONS[name].name == name
    for p in measured(name):
        assert isinstance(p, Measured)
        assert p.cost > 0
        assert 0 <= p.error < math.inf
        assert " = " in p.setting


def test_progress_is_reported_for_each_point():
    seen = []
    points = COMPARISONS["angle"].measure(lambda *now: seen.append(now))
    fractions, words = zip(*seen, strict=True)
    assert len(seen) == len(points)
    assert fractions[-1] == 1
    assert list(fractions) == sorted(fractions)
    assert "arc cosine of the trace, angle = 1" in words


@pytest.mark.parametrize("name", COMPARISONS)
def test_the_picture_has_a_row_for_each_question_and_every_way_in_it(name, measured):
    figure, comparison = Figure(), COMPARISONS[name]
    best, questions = draw_comparison(comparison, measured(name), figure), comparison.questions
    assert len(figure.axes) == 2 * len(questions)
    for q, left, right in zip(questions, figure.axes[::2], figure.axes[1::2], strict=True):
        colours = [line.get_color() for line in left.lines]
        assert len(colours) == len(q.methods)
        assert colours == [line.get_color() for line in right.lines[: len(colours)]]
        ringed = ["front"] if any(p.question is q for p in best) else []  # none if repeats disagree
        assert [t.get_text() for t in right.get_legend().get_texts()] == [*q.methods, *ringed]


@pytest.mark.parametrize("apart", [1.0, 1.2, 1.5, 2.0, 2.5, 3.0, 5.0, 30.0])
def test_no_numbers_on_the_axes_overlap_however_near_or_far_the_costs_are(apart, measured):
    question = max(COMPARISONS["rotations"].questions, key=lambda q: len(q.methods))
    points = [p for p in measured("rotations") if p.question is question]
    ways, figure = list(question.methods), Figure()
    points = [replace(p, cost=3e-6 * apart ** ways.index(p.method)) for p in points]
    draw_comparison(replace(COMPARISONS["rotations"], questions=(question,)), points, figure)
    canvas = FigureCanvasAgg(figure)
    canvas.draw()
    for axis in (a for ax in figure.axes for a in (ax.xaxis, ax.yaxis)):
        shown = (t for t in axis.get_ticklabels(which="both") if t.get_text() and t.get_visible())
        boxes = [t.get_window_extent(canvas.get_renderer()) for t in shown]
        assert len(boxes) >= 2
        assert not any(a.overlaps(b) for n, a in enumerate(boxes) for b in boxes[:n])

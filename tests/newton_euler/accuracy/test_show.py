"""show.py: one chart in a notebook, and a comparison of one's own."""

import math
from types import SimpleNamespace

import mpmath
import pytest

from newton_euler.accuracy import Measured, compare, show_chart
from newton_euler.accuracy.catalogue import QUICK_METHODS
from newton_euler.accuracy.charts import drawn
from newton_euler.accuracy.charts.comparisons import ways_caption
from newton_euler.algebra.errors import ArgumentError


@pytest.fixture
def displayed(monkeypatch):
    """What a notebook would show: alt texts and the HTML of captions."""
    seen = []
    monkeypatch.setattr(drawn, "show_figure", lambda figure, alt: seen.append(alt))
    page = SimpleNamespace(HTML=str, display=seen.append)
    monkeypatch.setitem(__import__("sys").modules, "IPython.display", page)
    return seen


def test_a_chart_is_shown_once_with_alt_text_and_caption(displayed):
    found = show_chart("models of projectile", tolerance=1.0)
    alt, caption = displayed
    assert caption == f"<figcaption>{found.caption}</figcaption>"
    assert found.caption in alt
    assert "Within 1 m the smallest model is 3 (projectile, Coriolis and effective" in found.caption
    assert len(found.points) == 6
    assert "projectile, flat" in str(found)
    assert found._ipython_display_() is None  # as the last value of a cell
    assert displayed == [alt, caption]


def test_a_quick_chart_says_what_it_leaves_out_and_names_may_have_hyphens(displayed):
    found = show_chart("sliding sphere")
    assert "scipy Radau" not in {p.method for p in found.points} < {*QUICK_METHODS}
    assert found.caption.endswith("only these methods were measured; quick=False measures all.")
    assert show_chart("steady-precession").points
    with pytest.raises(ArgumentError, match=r"no chart 'topp'; there are .*; models of projectile"):
        show_chart("topp")


def test_a_tolerance_or_a_result_that_does_not_fit_is_refused():
    for name, tolerance in (("top", 1.0), ("models of top", -1.0)):
        with pytest.raises(ArgumentError, match="tolerance is positive"):
            show_chart(name, tolerance=tolerance)
    with pytest.raises(ArgumentError, match="returns 2 numbers, exact has 3"):
        compare({"short": lambda: (1.0, 2.0)}, (1.0, 2.0, 3.0))


def test_a_users_own_ways_are_compared_with_the_reference(displayed):
    with mpmath.workdps(40):
        exact = 1 - mpmath.cos(mpmath.mpf(1e-4))
    naive, stable = (lambda: 1 - math.cos(1e-4)), (lambda: 2 * math.sin(5e-5) ** 2)
    found = compare({"naive": naive, "stable": stable}, exact, "1 - cos x")
    errors = {p.method: p.error for p in found.points}
    assert errors["stable"] < 3e-16 < 1e-10 < errors["naive"] < 1e-6
    assert found.caption.startswith("Most accurate (error 2.2 × 10⁻¹⁶ or less): stable")


def test_the_caption_of_ways_names_the_most_accurate_and_those_of_equal_cost():
    for exact in (1e-16, 9e-16):  # within round-off none is more accurate
        output = ways_caption([Measured("a", 1e-6, exact), Measured("b", 1e-5, 1e-16)])
        assert "Of these a is the cheapest. b takes about 10 times as long as a." in output
    output = ways_caption([Measured("a", 1e-6, 1e-3), Measured("b", 1e-5, 1e-16)])
    best = "Most accurate (error 2.2 × 10⁻¹⁶ or less): b."
    assert output == f"{best} a is about 10 times faster, with an error of 0.001."
    output = ways_caption([Measured("a", 1e-6, 1e-3), Measured("b", 2e-6, 1e-16)])
    assert output.endswith("b. a costs about the same, with an error of 0.001.")
    points = [Measured("a", 1e-6, 1e-16), Measured("b", 2.9e-6, 1e-16), Measured("c", 1e-5, 1e-6)]
    output = ways_caption(points)
    assert "Of these a and b cost about the same, least." in output
    assert "Dearer and less accurate than a: c." in output

"""charts/comparisons.py: the caption of a comparison follows from its points."""

from newton_euler.accuracy.charts.comparisons import comparison_caption
from newton_euler.accuracy.measurements.comparisons import Comparison, ComparisonPoint, Question


def caption(**errors):
    """The caption of methods with these (cost, errors at h = 1, 0.1, 0.01)."""
    question = Question("place", ("h", "step h, s"), (1.0, 0.1, 0.01), dict.fromkeys(errors), abs)
    points = [
        ComparisonPoint(name, cost, e, question=question, x=x)
        for name, (cost, *found) in errors.items()
        for x, e in zip(question.settings, found, strict=True)
    ]
    return comparison_caption(Comparison("fake", "A fake", (question,)), points)


def test_the_best_setting_and_the_settings_of_failure_are_named():
    output = caption(difference=(1e-6, 0.5, 1e-9, 0.2), exact=(1e-5, 1e-16, 1e-16, 1e-16))
    assert "Place: “exact” is within 2.2 × 10⁻¹⁶ at every setting, 10 µs." in output
    assert "“difference”: at best 10⁻⁹, at h = 0.1; wrong by over 1 % at h = 1 and 0.01." in output


def test_with_the_errors_of_two_methods_swapped_the_caption_follows():
    output = caption(exact=(1e-6, 0.5, 1e-9, 0.2), difference=(1e-5, 1e-16, 1e-16, 1e-16))
    assert "“difference” is within 2.2 × 10⁻¹⁶ at every setting" in output
    assert "“exact”: at best 10⁻⁹" in output


def test_the_cheapest_of_the_right_ones_is_named_and_near_ties_are_equal():
    right = (1e-16, 1e-16, 2e-16)
    assert "“a” is the cheapest of them, 1 µs" in caption(a=(1e-6, *right), b=(3e-6, *right))
    assert "“b” is the cheapest of them, 1 µs" in caption(b=(1e-6, *right), a=(3e-6, *right))
    assert "“a” and “b” at about the same cost" in caption(a=(1e-6, *right), b=(1.1e-6, *right))


def test_a_method_that_is_nowhere_wrong_by_1_percent_is_named_with_its_worst_error():
    output = caption(rough=(1e-6, 1e-3, 1e-4, 1e-5), exact=(1e-5, 1e-16, 1e-16, 1e-16))
    assert "“rough”: at best 10⁻⁵, at h = 0.01; at worst 0.001, at h = 1." in output


def test_settings_that_are_wrong_without_a_break_are_given_as_a_range():
    output = caption(difference=(1e-6, 0.5, 0.4, 1e-9), exact=(1e-5, 1e-16, 1e-16, 1e-16))
    assert "wrong by over 1 % at h = 1 to 0.1." in output

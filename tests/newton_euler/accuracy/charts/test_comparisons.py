"""charts/comparisons.py: the caption of a comparison follows from its points."""

import pytest

from newton_euler.accuracy.charts.comparisons import comparison_caption
from newton_euler.accuracy.measurements.comparisons import Comparison, ComparisonPoint, Question

EXACT = (1e-5, 1e-16, 1e-16, 1e-16)
RIGHT = (1e-16, 1e-16, 2e-16)
BEST = "“a” is the cheapest of them."


@pytest.mark.parametrize(
    ("errors", "words"),
    [
        ({"a": (1e-6, 0.5, 1e-9, 0.2), "exact": EXACT}, [
            "Place: “exact” is within 2.2 × 10⁻¹⁶ at every setting.",
            "“a”: at best 10⁻⁹, at h = 0.1; wrong by over 1 % at h = 1 and 0.01."]),
        ({"exact": (1e-6, 0.5, 1e-9, 0.2), "a": EXACT}, ["“a” is within 2.2 × 10⁻¹⁶ at every setting", "“exact”: at best 10⁻⁹"]),
        ({"a": (1e-6, *RIGHT), "b": (4e-6, *RIGHT)}, [BEST]),
        ({"b": (1e-6, *RIGHT), "a": (4e-6, *RIGHT)}, [BEST.replace("a", "b", 1)]),
        ({"a": (1e-6, *RIGHT), "b": (2.9e-6, *RIGHT)}, ["“a” and “b” cost about the same."]),
        ({"rough": (1e-6, 1e-3, 1e-4, 1e-5), "exact": EXACT}, ["“rough”: at best 10⁻⁵, at h = 0.01; at worst 0.001, at h = 1."]),
        ({"a": (1e-6, 0.5, 0.4, 1e-9), "exact": EXACT}, ["wrong by over 1 % at h = 1 to 0.1."]),
    ],
    ids=["best setting and failures", "two methods swapped", "the cheapest", "the cheapest, swapped", "alike below three",
         "nowhere wrong by 1 %", "a range of failures"],
)  # fmt: skip
def test_the_caption_of_a_comparison_follows_from_its_points(errors, words):
    """Each method has its cost, and its errors at h = 1, 0.1, 0.01."""
    question = Question("place", ("h", "step h, s"), (1.0, 0.1, 0.01), dict.fromkeys(errors), abs)
    points = [
        ComparisonPoint(name, cost, e, question=question, x=x)
        for name, (cost, *found) in errors.items()
        for x, e in zip(question.settings, found, strict=True)
    ]
    caption = comparison_caption(Comparison("fake", "A fake", (question,)), points)
    assert [w for w in words if w not in caption] == []

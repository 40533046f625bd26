"""What lies exactly at a limit: the ends of a range, half of the points at which formulas are
compared, the smallest component that counts.
"""

import math
from dataclasses import replace
from types import SimpleNamespace

import pytest

from exercises import problem
from exercises.catalogue import Given, variants

FIRST = SimpleNamespace(randint=lambda first, last: first)  # "random" choices
LAST = SimpleNamespace(randint=lambda first, last: last)


@pytest.mark.parametrize(("low", "high"), [(0.07, 0.47), (0.17, 0.57)])
def test_both_ends_of_a_range_are_drawn_whatever_their_quotient_by_the_step_rounds_to(low, high):
    given = Given("x", low, "m", "any", (low, high))
    step = variants._round_step((high - low) / 40)
    assert any(x / step != round(x / step) for x in (low, high))
    assert [variants.drawn_value(given, end) for end in (FIRST, LAST)] == [low, high]


@pytest.fixture
def objection_to(monkeypatch):
    """The objection to numbers of an example that give the first of its answers these points."""

    def objection(problem_id, right, wrong=()):
        p = problem(problem_id)
        key, name = p.answers[0].key, next(iter(p.mistakes))
        found = {key: tuple(right)}, {name: {key: tuple(wrong)}} if wrong else {}
        monkeypatch.setattr(variants, "at_points", lambda p, values: found)
        return variants.objection(replace(p, givens={}), {})

    return objection


def test_a_formula_and_a_mistake_must_show_at_half_of_the_points(objection_to):
    real, none = (1.0,) * 3, (math.nan,) * 3
    assert objection_to("4/42", [real, real, none, none]) is None
    assert "nan at most points" in objection_to("4/42", [real, none, none])
    key, off = (1.0, 0.0, 0.0), (2.0, 0.0, 0.0)
    assert objection_to("4/42", [key] * 4, [off, off, key, key]) is None
    assert "hides the mistake" in objection_to("4/42", [key] * 3, [off, key, key])


@pytest.mark.parametrize(("small", "fits"), [(0.01, True), (0.00999, False), (1e-12, True)])
def test_a_component_is_a_hundredth_of_the_whole_or_only_round_off(objection_to, small, fits):
    components = (small, math.sqrt(1 - small**2), 0.0)
    assert math.hypot(*components) == 1.0
    assert (objection_to("4/16", [components]) is None) is fits

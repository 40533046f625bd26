"""The source notebook and what nbgrader makes of it hold no key, and a failure leaves no course
behind.
"""

import re

import pytest

from tests.grader.keys import secrets_in


def test_the_released_notebook_and_the_source_hold_no_key(course):
    for path in (course.source("ch04"), course.path / "release/ch04/ch04.ipynb"):
        text = re.sub("### (BEGIN|END) SOLUTION", "", path.read_text())
        assert secrets_in(text, course, "nobody") == []


def test_a_failure_while_figures_are_drawn_leaves_no_half_made_course(tmp_path, monkeypatch):
    from grader.assignment import build as building

    monkeypatch.setattr(building, "figure_png", lambda *a: 1 / 0)
    with pytest.raises(ZeroDivisionError):
        building.build_assignment(tmp_path / "c", "ch04", None, ("4/1",))
    assert not (tmp_path / "c").exists()

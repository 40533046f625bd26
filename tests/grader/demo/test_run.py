"""The whole workflow on an example."""

import pytest

from grader.course import Course
from tests.grader.courses import grader, points, total
from tests.grader.submissions import RIGHT


def test_the_demo_on_five_problems_gives_its_six_students_the_expected_points(demo_course):
    assert demo_course["code"] == 0, demo_course["output"]
    assert {s: total(c) for s, c in points(demo_course["course"]).items()} == {**RIGHT, "dan": 0}


@pytest.mark.slow
def test_the_demo_on_the_whole_chapter_ends_well(tmp_path):
    """It compares each student's points with those expected."""
    code, output = grader("demo", "--course", tmp_path / "c", timeout=600)
    assert (code, "expected" in output) == (0, False), output
    assert set(points(Course(tmp_path / "c"))) == set(RIGHT) | {"dan"}

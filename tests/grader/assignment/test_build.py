"""The source notebook and what nbgrader makes of it hold no key, and a failure leaves no course
behind.
"""

import re

from tests.grader.keys import secrets_in


def test_the_released_notebook_and_the_source_hold_no_key(course):
    for path in (course.source("ch04"), course.path / "release/ch04/ch04.ipynb"):
        text = re.sub("### (BEGIN|END) SOLUTION", "", path.read_text())
        assert secrets_in(text, course, "nobody") == []

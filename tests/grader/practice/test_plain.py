"""What a terminal shows has no LaTeX, in any problem."""

import re

import pytest

from exercises.catalogue import problem, select
from grader.practice.build import plain_text
from grader.practice.plain import plain
from grader.practice.twins import twin

LATEX = re.compile(r"[\\${}]")


@pytest.mark.parametrize("name", [f"ch{n:02}" for n in range(2, 12)] + ["appA"])
def test_no_text_has_latex(name):
    for p in map(twin, select([name])):
        means = [x.means for x in (*p.answers, *p.givens.values())]
        texts = [plain_text(p, p.book_values), *(plain(x, p.units) for x in [p.figure, *means])]
        assert [x for x in texts if LATEX.search(x)] == [], p.id


def test_axes_are_reported_and_a_pure_number_has_no_unit():
    p = twin(problem("A/24"))
    output = plain_text(p, p.book_values)
    assert "c_1 = 6, c_2 = 4" in output
    assert output.endswith("Components: Fixed right-handed orthonormal i, j, k.")

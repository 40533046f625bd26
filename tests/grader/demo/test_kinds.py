"""The whole way on problems of every kind: words, counts, intervals, matrices, symbols beside
givens, without numbers, without a figure.
"""

import pytest

from tests.grader.courses import grader

KINDS = {
    "without numbers, a word, symbols beside givens, no figure": ("A/7", "A/9", "A/15"),
    "integrals, of which one has symbols": ("A/24", "A/25"),
    "intervals, and a word beside a number": ("2/4", "2/5", "2/18"),
    "matrices": ("3/27",),
    "counts, and a word": ("5/16", "5/20", "5/26"),
}


@pytest.mark.integration
@pytest.mark.parametrize("problems", KINDS.values(), ids=KINDS)
def test_six_students_earn_what_they_should(problems, tmp_path):
    """All right, one listed mistake, half, blank, a syntax error, hostile."""
    only = [x for p in problems for x in ("--problem", p)]
    code, said = grader("demo", "--course", tmp_path / "c", *only, timeout=600)
    assert code == 0, said

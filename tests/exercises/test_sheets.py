"""Each student has a sheet of their own: there are many sets of numbers, and what all students
share is worth little.
"""

import math
import random

import pytest

from exercises.catalogue import problem, select
from exercises.catalogue.checks import values
from exercises.catalogue.variants import drawn_value, objection, sheets

ALL = select(["all"])
FEWEST = 1000  # sheets of a problem with numbers
SHARED = 1 / 8  # of the points, for a word that is the same for everyone
STUDENTS = 12


@pytest.mark.one_in(3)
@pytest.mark.parametrize("p", [p for p in ALL if p.givens], ids=lambda p: p.id.replace("/", "_"))
def test_a_problem_with_numbers_has_many_sheets(p):
    assert sheets(p) >= FEWEST
    if sheets(p) < 20 * FEWEST:  # without the refused ones too
        rng = random.Random(p.id)
        drawn = [{n: drawn_value(g, rng) for n, g in p.givens.items()} for _ in range(40)]
        fit = sum(objection(p, numbers) is None for numbers in drawn)
        assert sheets(p) * fit / len(drawn) >= FEWEST


def test_the_number_of_sheets_is_that_of_the_numbers_that_are_drawn():
    p, rng = problem("8/5"), random.Random(1)
    drawn = [{drawn_value(g, rng) for _ in range(3000)} for g in p.givens.values()]
    assert sheets(p) == math.prod(map(len, drawn)) > 1
    assert sheets(problem("5/26")) == 1


@pytest.mark.one_in(3)
@pytest.mark.parametrize("p", [p for p in ALL if any(a.kind.has_options for a in p.answers)],
                         ids=lambda p: p.id.replace("/", "_"))  # fmt: skip
def test_a_word_that_all_students_share_is_worth_little(p):
    found = [p.solve(values(p, seed)) for seed in range(STUDENTS)]
    points = sum(a.weight for a in p.answers)
    for a in p.answers:
        if a.kind.has_options and len({answers[a.key] for answers in found}) == 1:
            assert a.weight <= SHARED * points, f"all {STUDENTS} say {found[0][a.key]}"

"""Slips in the set-up of a problem, made at random."""

import random
import shutil

from exercises.catalogue import problem
from exercises.catalogue.variants import flat
from grader.reports.setups_made import of_setups
from tests.exercises.test_slips_of_authors import GOOD, place


def test_an_answer_that_the_code_writes_as_a_list_keeps_its_entries(tmp_path):
    shutil.copytree(GOOD, tmp_path / "mine", ignore=shutil.ignore_patterns("__pycache__"))
    path = tmp_path / "mine/bead/p01.py"
    code = path.read_text()
    path.write_text(code.replace('"v_B": v.expressed_in(ground)', '"v_B": [g.v, g.omega * g.r, 0]'))
    with place(tmp_path / "mine"):
        p = problem("bead/1")
        right = {key: flat(x) for key, x in p.solve(p.book_values).items()}
        made = list(of_setups(p, p.book_values, random.Random(1), 1000))
    assert made
    assert all(len(slipped[key]) == len(right[key]) for slipped in made for key in right)

"""The cells of an assignment: numbers, statement and grading agree; the receipt asks for what the
catalogue asks for.
"""

import json

import pytest

from exercises.catalogue import problem
from grader.assignment import notebook as nb
from tests.grader.courses import nbgrader, read, submit
from tests.grader.submissions import work

STUDENTS = ("ada", "ben", "cleo", "dan", "eve", "mallory")


def test_statement_numbers_and_grading_agree_for_everyone(course):
    for student in STUDENTS:
        own = read(course.personal_path("ch04", student))
        values = course.values("ch04", student, nb.problems_of(own))
        assert nb.first_differing_problem(own, values) is None
        for cell in own["cells"]:
            ours = cell["metadata"]["newton_euler"]
            if ours.get("role") == "givens":
                space = {}
                exec("from sympy import symbols\n" + cell["source"], space)
                assert {n: space[n] for n in values[ours["problem"]]} == values[ours["problem"]]
            if ours.get("role") == "statement":
                p = problem(ours["problem"])
                for name in p.givens:
                    assert f"{nb.pretty(name)} = {nb.number(values[p.id][name])}" in cell["source"]
                assert len(cell["attachments"]["figure.png"]["image/png"]) > 1000


def test_receipt_cells_ask_for_what_the_catalogue_asks_for(course):
    for cell in course.released("ch04")["cells"]:
        ours = cell["metadata"]["newton_euler"]
        if ours.get("role") == "receipt":
            assert cell["source"] == nb.receipt_cell(problem(ours["problem"]))
            assert cell["metadata"]["nbgrader"]["points"] == 0
            assert cell["metadata"]["nbgrader"]["locked"]
    assert json.dumps(course.released("ch04"))


@pytest.mark.slow
def test_validate_tells_a_student_what_cannot_be_read(fresh):
    submit(fresh, "dan", work(fresh, "dan", p4_16="alpha_CD = a_D = None\nv_D = [1, 2]"))
    _, out = nbgrader("validate", "submitted/dan/ch04/ch04.ipynb", cwd=fresh.path)
    assert "expected a vector, three numbers" in out, out

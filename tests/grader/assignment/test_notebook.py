"""The cells of an assignment: numbers, statement and grading agree; the receipt asks for what the
catalogue asks for.
"""

import json

from exercises.catalogue import problem
from grader.assignment import notebook as nb
from grader.assignment import problems_of
from newton_euler.answers.notation import number_symbol
from tests.grader.courses import read, released_sheet

STUDENTS = ("ada", "ben", "cleo", "dan", "eve", "mallory")


def test_statement_numbers_and_grading_agree_for_everyone(course):
    for student in STUDENTS:
        own = read(course.personal_path("ch04", student))
        values = course.values("ch04", student, problems_of(own))
        for cell in own["cells"]:
            ours = cell["metadata"]["newton_euler"]
            if ours.get("role") == "givens":
                space = {}
                exec("from sympy import symbols\nfrom newton_euler.classroom import given\n", space)
                exec(cell["source"], space)
                assert {n: space[n] for n in values[ours["problem"]]} == values[ours["problem"]]
            if ours.get("role") == "statement":
                p = problem(ours["problem"])
                for name in p.givens:
                    stated = number_symbol(values[p.id][name])
                    assert f"{p.notation[name]} = {stated}" in cell["source"]
                assert len(cell["attachments"]["figure.png"]["image/png"]) > 1000


def test_receipt_cells_ask_for_what_the_catalogue_asks_for(course):
    for cell in released_sheet(course)["cells"]:
        ours = cell["metadata"]["newton_euler"]
        if ours.get("role") == "receipt":
            assert cell["source"] == nb.receipt_cell(problem(ours["problem"]))
            assert cell["metadata"]["nbgrader"]["points"] == 0
            assert cell["metadata"]["nbgrader"]["locked"]
    assert json.dumps(released_sheet(course))


def personal_statement(number, text, values):
    cell = {"source": text, "metadata": {"newton_euler": {"role": "statement", "problem": number}}}
    copy = nb.personal_notebook({"cells": [cell]}, "ada", {number: values}, {})
    return copy["cells"][0]["source"]


def test_a_statement_gets_a_students_numbers_even_where_it_was_released_before_it_was_typeset():
    """<i>β̇</i> was printed as <i>b̊</i> with a combining dot, followed by numbers."""
    values = {"omega": 1.25, "b_dot": 0.3, "beta_1": 150, "b": 9.5, "L": 21.0}
    before = (
        "at the rate <i>ω</i> = 0.6 rad/s. BC has the length <i>b</i> = 8 mm, CD <i>L</i> = 16 mm, "
        "at <i>b\u0307</i> = 0.45 rad/s. When beta = <i>β</i><sub>1</sub> = 120 deg"
    )
    assert personal_statement("4/16", before, values) == (
        "at the rate <i>ω</i> = 1.25 rad/s. BC has the length <i>b</i> = 9.5 mm, CD <i>L</i> = 21 "
        "mm, at <i>b\u0307</i> = 0.3 rad/s. When beta = <i>β</i><sub>1</sub> = 150 deg"
    )


def test_a_students_numbers_take_the_place_of_the_books_and_of_no_others():
    p = problem("4/16")
    values = {"omega": 1.25, "b_dot": 1.5e-7, "beta_1": 150, "b": 9.5, "L": -21.0}
    book, with_own = nb.statement(p, p.book_values), nb.statement(p, values)
    assert personal_statement("4/16", book, values) == with_own
    assert personal_statement("4/16", with_own, p.book_values) == book
    own = r"an instructor's $b = 8$ and $\beta_b = 8$, $\bar b = 8$, $\dot b = 8$, $Lb = 8$"
    assert personal_statement("4/16", own, values) == own.replace("$b = 8$", "$b = 9.5$")


def test_every_problem_that_varies_gets_its_numbers_into_its_statement():
    from exercises.catalogue import select
    from exercises.catalogue.checks import values as drawn

    for p in select(["all"]):
        if p.givens:
            own = {n: drawn(p, 3)[n] for n in p.givens}
            book = nb.statement(p, p.book_values)
            assert personal_statement(p.id, book, own) == nb.statement(p, own)

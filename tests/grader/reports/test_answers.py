"""Answers and results as text, JSON and tables."""

import json

import numpy as np
import pytest
import sympy

from exercises.catalogue import problems
from exercises.catalogue.variants import flat
from tests.grader.courses import command, ran, submit
from tests.grader.submissions import work


@pytest.fixture(scope="module")
def all43():
    return json.loads(ran(command("solve", "ch04", "--json")))


def test_solve_answers_all_43_problems_as_json(all43):
    assert list(all43) == [f"4/{n}" for n in range(1, 44)]
    for p in problems("ch04"):
        for a in p.answers:
            entry = all43[p.id][a.key]
            assert set(entry) == {"kind", "unit", "expr" if a.kind.is_formula else "value"}
            assert (entry["kind"], entry["unit"]) == (a.kind.name, a.unit)


@pytest.mark.parametrize("p", problems("ch04"), ids=lambda p: p.id)
def test_the_json_has_the_values_that_solve_gives_and_sympy_reads_its_formulas(p, all43):
    rng = np.random.default_rng(4)
    values = {n: float(rng.uniform(*s.vary)) for n, s in p.symbols.items()}
    right = p.solve({**p.book_values, **values})
    names = {n: sympy.Symbol(n) for n in p.symbols}
    for a in p.answers:
        entry = all43[p.id][a.key]
        got = flat(entry["expr"] if a.kind.is_formula else entry["value"])
        if a.kind.is_formula:
            got = [float(sympy.sympify(text, locals=names).subs(values)) for text in got]
        assert got == pytest.approx([float(x) for x in flat(right[a.key])], rel=1e-9, abs=1e-12)


def test_explain_prints_the_terms():
    assert "coriolis" in command("solve", "4/16", "--explain")[1]


def test_grade_prints_tables_with_whatever_students_wrote(fresh):
    submit(fresh, "dan", work(fresh, "dan", p4_1="raise ValueError('[/red] [/] [bold')"))
    out = ran(command("grade", "ch04", "--course", fresh.path, "--verbose"))
    assert "dan" in out
    assert "9/11" in out

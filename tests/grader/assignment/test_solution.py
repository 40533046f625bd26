"""The worked solution that is made of the steps of a problem."""

import pytest

from exercises.catalogue import problem, select
from exercises.catalogue.variants import draw
from grader.assignment.notebook import typeset
from grader.assignment.solution import worked_solution
from newton_euler.answers.notation import number_symbol

ALL = select(["all"])


@pytest.mark.parametrize("p", ALL, ids=lambda p: p.id)
def test_a_worked_solution_has_the_students_numbers_and_every_answer(p):
    values = {**draw(p, b"solution"), **p.sympy_symbols()}
    text = worked_solution(p, values)
    for a in p.answers:
        assert typeset(a.means, p)[1:] in text
    for name, given in p.givens.items():
        assert number_symbol(values[name]) in text, given


def test_a_worked_solution_cites_the_equation_of_its_chapter():
    p = problem("2/38")
    text = worked_solution(p, p.book_values)
    assert "*By equation (2.25) the sum of*" in text
    assert "(4.18)" not in text
    assert "{-0}" not in text
    assert "| the acceleration of the origin of the moving frame | $" in text


def test_the_terms_of_an_answer_stand_in_its_table_and_not_among_the_steps_too():
    p = problem("4/16")
    text = worked_solution(p, p.book_values)
    assert text.count("the Coriolis term") == 1
    assert r"| the Coriolis term $2\boldsymbol{\omega}\times\mathbf{v}_r$ | $" in text
    # a term that is zero is said to be so, of a frame that adds nothing nothing is said
    assert "| the term $\\boldsymbol{\\alpha} \\times \\mathbf{r}$ | $\\left[0,\\ 0,\\ 0" in text
    assert "| the turning of" not in text


def test_the_formula_of_a_term_is_not_searched_for_givens():
    p = problem("4/18")  # it has a length a
    assert r"\mathbf{a}_r$ | $" in worked_solution(p, p.book_values)


def test_round_off_is_no_component_of_an_answer():
    p = problem("4/17")  # of the velocity along X is left what cos 60 degrees is not a half
    text = worked_solution(p, p.book_values)
    assert r"$\mathbf{v}_D = \left[0,\ 6.23538" in text
    assert r"\times 10^{-1" not in text


def test_a_sentence_may_begin_with_an_axis():
    p = problem("4/12")
    assert "2. z component of" in worked_solution(p, p.book_values)


def test_the_term_of_two_coordinates_is_typeset():
    p = problem("3/26")
    coriolis = r"Coriolis term of $\theta$ and $\phi$, $-2R\dot{\theta}\dot{\phi}\sin\phi\,"
    assert coriolis in worked_solution(p, p.book_values)

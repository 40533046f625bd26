"""A student's key and wrong models: traced once for all, with the numbers of the problem's code."""

import math

import numpy as np
import pytest

from exercises.catalogue import problem, problems
from exercises.catalogue.variants import POINTS, draw, flat
from grader.assignment.sheet import with_tolerance
from grader.scoring import ScoreError, numbers, score_receipt
from grader.scoring.numbers import Numbers, numbers_of
from grader.scoring.wrong_models import wrong_models
from newton_euler import sqrt

CH04 = problems("ch04")


def rows(points):
    return np.array(points).T


def components(x, like):
    return [np.broadcast_to(np.asarray(y, float), like[0].shape) for y in flat(x)]


@pytest.mark.parametrize("p", CH04, ids=lambda p: p.id)
def test_the_traced_numbers_are_those_of_the_problems_code(p):
    values = draw(p, b"tests of numbers")
    found = Numbers(p, values)
    for key, x in p.solve(found.sample).items():
        parts = components(x, rows(found.key[key]))
        assert np.allclose(rows(found.key[key]), parts, rtol=1e-12, atol=1e-12)
    for key, cause, x in wrong_models(p, found.sample):
        same = [y for c, y in found.wrong(key) if c == cause]
        parts = components(x, rows(same[0]))
        size = np.abs(parts).max()
        assert any(np.allclose(rows(y), parts, rtol=1e-9, atol=1e-9 * size) for y in same)


@pytest.fixture
def forget():
    """Forgets all traced formulas; so it does before and after the test."""

    def clear():
        for kept in (numbers._traced_key, numbers._traced_wrong, numbers._traced_following):
            kept.cache_clear()

    clear()
    yield clear
    clear()


def test_a_problems_code_runs_once_for_a_whole_class(forget, monkeypatch):
    p = problem("4/16")
    calls, solve = [], p.code.solve
    monkeypatch.setattr(p.code, "solve", lambda g: calls.append(g) or solve(g))
    wrong = {"answers": {"alpha_CD": [1, 2, 3], "v_D": [1, 2, 3], "a_D": [1, 2, 3]}}
    score_receipt(p, draw(p, b"first"), wrong)
    first = len(calls)
    for student in range(20):
        score_receipt(p, draw(p, str(student).encode()), wrong)
    assert 0 < first == len(calls)


def test_a_problem_without_givens_has_the_same_numbers_for_all_with_the_tolerance_of_the_sheet():
    assert numbers_of(problem("4/2"), {}) is numbers_of(problem("4/2"), {})
    p = with_tolerance(problem("4/2"), 0.1)
    assert {a.rtol for a in numbers_of(p, {}).answers} == {0.1}


def test_numbers_that_the_sheet_does_not_have_are_named_and_those_of_before_left_alone():
    p, values = problem("4/16"), draw(problem("4/16"), b"any")
    with pytest.raises(ScoreError, match="no number for omega, b, which problem 4/16 gives today"):
        Numbers(p, {n: x for n, x in values.items() if n not in ("omega", "b")})
    assert Numbers(p, {**values, "gone": 1}).key == Numbers(p, values).key


def test_the_books_numbers_are_not_a_mistake_on_a_sheet_that_has_them():
    p = problem("4/16")
    assert Numbers(p, p.book_values).book == {}
    assert Numbers(p, draw(p, b"any")).book == Numbers(p, p.book_values).key


def test_a_wrong_model_without_a_value_does_not_stop_grading(forget, monkeypatch):
    """Such as one that leads to the root of a negative number."""
    p = problem("2/4")  # speeds d/T, with the time T = sqrt(2 h/g)
    fall = p.code.mistakes
    negative = lambda g: {**fall(g), "no_2": {"v_0": (sqrt(-g.h / g.g), g.d)}}
    monkeypatch.setattr(p.code, "mistakes", negative)
    parts = score_receipt(p, p.book_values, {"answers": {"v_0": [1.0, 2.0]}}).parts
    assert parts[0].verdict == "wrong"
    wrong = {c.text: x for c, x in numbers_of(p, p.book_values).wrong("v_0")}
    assert math.isnan(wrong[p.mistakes["no_2"]][0][0])
    monkeypatch.setattr(numbers, "wrong_models", lambda *_: sqrt(-1.0))
    forget()
    assert numbers_of(p, p.book_values).wrong("v_0") == []


def test_a_wrong_formula_without_symbols_has_all_points(monkeypatch):
    """Such as a zero vector: it is compared at every point. A problem with words is not traced."""
    p = problem("9/1")
    listed, name = p.code.mistakes, next(iter(p.mistakes))
    key = next(a.key for a in p.answers if a.kind.name == "vector_expression")
    nothing = lambda g: {**listed(g), name: {key: p.code.solve(g)[key].frame.vector(0, 0, 0)}}
    monkeypatch.setattr(p.code, "mistakes", nothing)
    found = Numbers(p, p.book_values).wrong(key)
    assert {len(x) for _, x in found} == {POINTS}

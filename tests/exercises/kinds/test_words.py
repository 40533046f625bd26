"""Words and counts: written as words or as functions, drawn, checked, proved, and diagnosed."""

from dataclasses import replace

import numpy as np
import pytest

from exercises.catalogue import Symbol
from exercises.catalogue.checks import check
from exercises.catalogue.following import earlier_answers
from exercises.catalogue.variants import at_points, draw, objection
from newton_euler import where
from tests.exercises.kinds import thrown
from tests.exercises.kinds.thrown import DOF, SENSE, SPEED, THROWN, ball, mistakes, sense, solve


def test_a_word_may_be_a_function_that_branches_for_each_instant_of_an_array(made):
    p = ball(made)
    assert p.solve(p.book_values) == {"sense": "rises", "v": pytest.approx(1.038)}
    assert p.solve({**p.book_values, "t": 0.5})["sense"] == "falls"
    assert p.wrong(p.book_values)["downward"]["sense"] == "falls"
    p = ball(made)
    found = p.solve({**p.book_values, "t": np.array([0.1, 0.5])})
    assert found["sense"].tolist() == ["rises", "falls"]


def test_words_are_chosen_by_where_with_numbers_alone(made):
    p = made(
        lambda g: {"sense": sense(g.a), "v": g.a * g.t},
        answers=(SENSE, replace(SPEED, kind="expression")),
        symbols={"a": Symbol("a", "m/s^2", (1, 2)), "t": Symbol("t", "s", (1, 2))},
    )
    assert p.formulas()["sense"] == "rises"
    p = made(
        lambda g: {"sense": where(g.v_0 > 0, "rises", "falls"), "dof": where(g.t > 0, 2, 1)},
        answers=(SENSE, DOF),
        givens=THROWN,
    )
    assert check(p) == []
    assert p.solve(p.book_values) == {"sense": "rises", "dof": 2}


def test_a_word_that_the_proof_denies_or_nobody_can_choose_is_caught(made):
    faults = check(ball(made, prove=lambda g: {**solve(g), "sense": "falls"}))
    assert faults == ["sense: solve says rises, prove says falls (seed 0)"]
    (fault,) = check(ball(made, solve=lambda g: {**solve(g), "sense": "up"}, prove=solve))
    assert fault.startswith("sense: solve says 'up', which is not one of rises, falls, rests")
    faults = check(made(lambda g: {"dof": 1.5}, answers=(DOF,)))
    assert faults == ["dof: solve gives 1.5, which is not a whole number (seed 0)"]


def test_a_mistake_that_gives_the_right_word_is_caught_in_the_book_and_allowed_in_draws(made):
    same = lambda g: {**mistakes(g), "no_gravity": {"sense": "rises"}}
    (fault,) = check(ball(made, wrong=same))
    assert fault.startswith("the mistake no_gravity gives nearly the right sense: (rises)")
    p = ball(made, wrong=lambda g: {"no_gravity": {"sense": "rises"}})
    assert {p.solve(draw(p, bytes([n])))["sense"] for n in range(20)} == {"rises", "falls"}


def test_numbers_next_to_those_of_another_word_are_rejected(made):
    p = made(lambda g: {"sense": sense(g.v_0 - g.g * g.t)}, answers=(SENSE,), givens=THROWN)
    message = objection(p, {**p.book_values, "v_0": 9.81, "t": 0.9999})
    assert message == "is ill-conditioned: 0.1 % of t changes sense"


def test_points_of_words_are_words_and_a_problem_of_words_holds(made):
    right, wrong = at_points(ball(made), ball(made).book_values)
    assert right["sense"] == (("rises",),)
    assert wrong["downward"]["sense"] == (("falls",),)
    assert check(ball(made), seeds=3) == []


def test_a_word_may_follow_from_a_number(made):
    """A student with a wrong speed is right to give the sense that goes with it."""
    answers = (replace(SPEED, weight=1.0), replace(SENSE, follow_through=0.5))

    ordered = lambda g: dict(reversed(solve(g).items()))
    p = made(ordered, wrong=mistakes, answers=answers, givens=THROWN, mistakes=thrown.SLIPS)
    p.code.follows = {"sense": lambda g, v: sense(v)}
    assert not [f for f in check(p, 1) if "follow" in f]
    p.code.follows = {"sense": lambda g, v: "rests"}
    earlier_answers.cache_clear()
    assert [f for f in check(p, 1) if "does not follow from v" in f]

"""Words and counts: written as words or as functions, drawn, checked, proved, and diagnosed."""

from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest

from exercises import problem
from exercises.catalogue import Answer, Given, Symbol, variants
from exercises.catalogue.checks import check
from exercises.catalogue.following import earlier_answers
from exercises.catalogue.variants import at_points, draw, objection
from grader.reports.diagnoses import diagnosis_shares
from grader.scoring import numbers, score_receipt
from newton_euler import where
from newton_euler.answers.causes import OR
from newton_euler.answers.kinds import KINDS

SENSE = Answer("sense", KINDS["choice"], "1", "whether it rises", ("rises", "falls", "rests"))
DOF = Answer("dof", KINDS["count"], "1", "degrees of freedom")
SPEED = Answer("v", KINDS["number"], "m/s", "speed upward")
BLANK = replace(
    problem("4/16"), id="2/8", givens={}, symbols={}, mistakes={}, struck={}, checked={}, figure=""
)
THROWN = {
    "v_0": Given("v_0", 3.0, "m/s", "speed upward at first", (2.0, 9.0)),
    "t": Given("t", 0.2, "s", "time", (0.1, 0.6)),
    "g": Given("g", 9.81, "m/s^2", "acceleration downward"),
}
SLIPS = {"downward": "takes downward as positive", "no_gravity": "leaves out gravity"}


@pytest.fixture
def made(monkeypatch):
    """A function that makes a problem of these data and this code."""

    def make(solve, wrong=lambda g: {}, prove=None, **data):
        p = replace(BLANK, **data)
        vars(p)["code"] = SimpleNamespace(solve=solve, prove=prove or solve, mistakes=wrong)
        monkeypatch.setattr(variants, "problem", lambda _: p)
        monkeypatch.setattr(numbers, "find_problem", lambda _: p)
        forget()
        return p

    yield make
    forget()


def forget():
    """What is kept of problems by their number."""
    for kept in (variants._compiled, numbers._without_givens, numbers._of_book,
                 numbers._traced_key, numbers._traced_wrong):  # fmt: skip
        kept.cache_clear()


def sense(v):
    """By plain comparisons, which only numbers have."""
    return lambda: "rises" if v > 0 else "falls" if v < 0 else "rests"


def solve(g):
    v = g.v_0 - g.g * g.t
    return {"sense": sense(v), "v": v}


def mistakes(g):
    v = solve(g)["v"]
    return {
        "downward": {"sense": sense(-v), "v": -v},
        "no_gravity": {"sense": lambda: "rests", "v": g.v_0},
    }


def ball(made, **changes):
    functions = {"solve": solve, "wrong": mistakes, **changes}
    return made(answers=(SENSE, SPEED), givens=THROWN, mistakes=SLIPS, **functions)


# -- what the code may return


def test_a_word_may_be_a_function_that_branches(made):
    p = ball(made)
    assert p.solve(p.book_values) == {"sense": "rises", "v": pytest.approx(1.038)}
    assert p.solve({**p.book_values, "t": 0.5})["sense"] == "falls"
    assert p.wrong(p.book_values)["downward"]["sense"] == "falls"


def test_of_an_array_of_instants_each_has_its_word(made):
    p = ball(made)
    found = p.solve({**p.book_values, "t": np.array([0.1, 0.5])})
    assert found["sense"].tolist() == ["rises", "falls"]


def test_a_word_is_chosen_where_symbols_have_no_number(made):
    p = made(
        lambda g: {"sense": sense(g.a), "v": g.a * g.t},
        answers=(SENSE, replace(SPEED, kind=KINDS["expression"])),
        symbols={"a": Symbol("a", "m/s^2", (1, 2)), "t": Symbol("t", "s", (1, 2))},
    )
    assert p.formulas()["sense"] == "rises"


def test_where_chooses_words_and_counts_too(made):
    p = made(
        lambda g: {"sense": where(g.v_0 > 0, "rises", "falls"), "dof": where(g.t > 0, 2, 1)},
        answers=(SENSE, DOF),
        givens=THROWN,
    )
    assert check(p) == []
    assert p.solve(p.book_values) == {"sense": "rises", "dof": 2}


# -- checks


def test_a_problem_of_words_holds_and_its_words_have_no_units_to_prove(made):
    assert check(ball(made), seeds=3) == []


def test_a_word_that_the_proof_denies_is_caught(made):
    faults = check(ball(made, prove=lambda g: {**solve(g), "sense": "falls"}))
    assert faults == ["sense: solve says rises, prove says falls (seed 0)"]


def test_a_word_that_is_not_among_those_to_choose_from_is_caught(made):
    (fault,) = check(ball(made, solve=lambda g: {**solve(g), "sense": "up"}, prove=solve))
    assert fault.startswith("sense: solve says 'up', which is none of rises, falls, rests")


def test_a_count_that_is_no_whole_number_is_caught(made):
    faults = check(made(lambda g: {"dof": 1.5}, answers=(DOF,)))
    assert faults == ["dof: solve gives 1.5, which is no whole number (seed 0)"]


def test_a_mistake_that_gives_the_right_word_of_the_book_is_caught(made):
    def same(g):
        return {**mistakes(g), "no_gravity": {"sense": "rises"}}

    (fault,) = check(ball(made, wrong=same))
    assert fault.startswith("the mistake no_gravity gives nearly the right sense: (rises)")


# -- drawing


def test_a_problem_of_words_is_drawn_though_a_mistake_gives_the_right_word(made):
    p = ball(made, wrong=lambda g: {"no_gravity": {"sense": "rises"}})
    assert {p.solve(draw(p, bytes([n])))["sense"] for n in range(20)} == {"rises", "falls"}


def test_numbers_next_to_those_of_another_word_are_rejected(made):
    p = made(lambda g: {"sense": sense(g.v_0 - g.g * g.t)}, answers=(SENSE,), givens=THROWN)
    told = objection(p, {**p.book_values, "v_0": 9.81, "t": 0.9999})
    assert told == "is ill-conditioned: 0.1 % of t changes sense"


# -- scoring


def scored(p, **answers):
    parts = score_receipt(p, p.book_values, {"answers": answers}).parts
    return {x.key: x for x in parts if x.key in answers}


def test_a_listed_wrong_word_is_named(made):
    part = scored(ball(made), sense="falls")["sense"]
    assert (part.verdict, part.points, part.diagnosis) == ("wrong", 0, SLIPS["downward"])
    assert part.message == "not right; it fits a solution that takes downward as positive"


def test_a_listed_wrong_count_is_named_with_all_mistakes_that_give_it(made):
    slips = {"fixed": "forgets that the hook moves", "rigid": "takes the rope for a rod"}
    p = made(
        lambda g: {"dof": lambda: 3},
        lambda g: {"fixed": {"dof": 2}, "rigid": {"dof": 2}},
        answers=(DOF,),
        mistakes=slips,
    )
    assert scored(p, dof=3)["dof"].verdict == "right"
    assert scored(p, dof=2)["dof"].diagnosis == OR.join(slips.values())
    assert scored(p, dof=7)["dof"].diagnosis is None
    assert scored(p, dof=True)["dof"].diagnosis is None


def test_every_listed_mistake_in_a_word_is_named_in_the_report(made):
    p = ball(made)
    assert diagnosis_shares([p], 1)[p.id] == {"named": 4}


def test_points_of_words_are_words(made):
    right, wrong = at_points(ball(made), ball(made).book_values)
    assert right["sense"] == (("rises",),)
    assert wrong["downward"]["sense"] == (("falls",),)


def test_a_word_may_follow_from_a_number(made):
    """Who has the speed wrong has the sense right that goes with it."""
    answers = (replace(SPEED, weight=1.0), replace(SENSE, follow_through=0.5))

    def ordered(g):
        found = solve(g)
        return {"v": found["v"], "sense": found["sense"]}

    p = made(ordered, mistakes, answers=answers, givens=THROWN, mistakes=SLIPS)
    p.code.follows = {"sense": lambda g, v: sense(v)}
    assert not [f for f in check(p, 1) if "follow" in f]
    p.code.follows = {"sense": lambda g, v: "rests"}
    earlier_answers.cache_clear()
    assert [f for f in check(p, 1) if "does not follow from v" in f]
    p.code.follows = {"sense": lambda g, v: sense(v)}
    earlier_answers.cache_clear()
    v, word = score_receipt(p, p.book_values, {"answers": {"v": -2.0, "sense": "falls"}}).parts
    assert (v.verdict, word.verdict, word.points) == ("wrong", "wrong", 0.5)
    assert "follows from your v" in word.message

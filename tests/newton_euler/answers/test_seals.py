"""Receipts that say whether an answer is right, from a salted slow hash."""

import json

import pytest

from newton_euler.answers import seals
from newton_euler.answers.kinds import KINDS
from newton_euler.answers.seals import opens, seal
from newton_euler.classroom import expect, given, receipt

VECTOR = [-7.482459, -7.38, 2e-17]


@pytest.mark.one_in(4)
@pytest.mark.parametrize(
    ("kind", "right", "tree", "is_right"),
    [
        ("number", [2.5], 2.5, True),
        ("number", [2.5], 2.51, True),
        ("number", [2.5], 2.54, False),
        ("number", [2.5], -2.5, False),
        ("number", [2.5], 2500.0, False),
        ("number", [0.0], 0.0, True),
        ("number", [1e-17], 0, True),
        ("number", [0.0], 0.1, False),
        ("number", [0.0], 1e-5, False),
        ("vector", VECTOR, [-7.48, -7.38, 0], True),
        ("vector", VECTOR, {"a": [1, 2, 3], "ground": [-7.482459, -7.38, 0]}, True),
        ("vector", VECTOR, [-7.48, 7.38, 0], False),
        ("vector", VECTOR, [-7.48, -7.38, 0.3], False),
        ("vector", VECTOR, [0, 0, 0], False),
        ("count", 3, 3, True),
        ("count", 3, 2, False),
        ("choice", "stable", "stable", True),
        ("choice", "stable", "unstable", False),
    ],
)
def test_a_seal_opens_for_the_right_answer_only(kind, right, tree, is_right):
    assert opens(json.loads(json.dumps(seal(KINDS[kind], right))), KINDS[kind], tree) is is_right


def test_a_seal_opens_up_to_the_tolerance_wherever_in_its_cell_the_answer_lies(monkeypatch):
    monkeypatch.setattr(seals, "COST", 2)
    number = KINDS["number"]
    for x in (1.0 + 0.037 * n for n in range(60)):
        sealed = seal(number, [x])
        assert opens(sealed, number, x * 1.00499)
        assert opens(sealed, number, x * 0.9952)


def test_a_formula_is_compared_at_a_point_of_its_symbols():
    at = {"r": 0.7, "w": 1.3}
    sealed = seal(KINDS["expression"], [0.7 * 1.3**2], at)
    assert opens(sealed, KINDS["expression"], ["*", "r", ["^", "w", 2]])
    assert not opens(sealed, KINDS["expression"], ["*", 1.0001, "r", ["^", "w", 2]])
    assert not opens(sealed, KINDS["expression"], ["*", "r", "w"])


def test_equal_answers_have_unlike_seals_and_the_number_is_not_in_it():
    one, other = seal(KINDS["number"], [2.5]), seal(KINDS["number"], [2.5])
    assert one["hashes"] != other["hashes"]
    assert "2.5" not in json.dumps(one)


def test_a_receipt_says_right_or_wrong_only_where_there_is_a_seal(monkeypatch):
    expect("0/8", v="number, m/s", n="count")
    given(
        "0/8", omega=2.0, sealed={"v": seal(KINDS["number"], [2.5]), "n": seal(KINDS["count"], 3)}
    )
    assert "v is right; n is not right." in repr(receipt("0/8", v=2.5, n=4))
    monkeypatch.setenv("NBGRADER_EXECUTION", "cage")  # no seals are checked in grading
    assert "right" not in repr(receipt("0/8", v=2.5, n=4))
    monkeypatch.delenv("NBGRADER_EXECUTION")
    given("0/8", omega=2.0)
    assert "Form checked only" in repr(receipt("0/8", v=2.5, n=4))

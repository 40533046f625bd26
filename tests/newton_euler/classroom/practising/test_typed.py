"""Answers typed into a field."""

import math

import pytest

from newton_euler.classroom import AnswerError
from newton_euler.classroom.practising.typed import LONGEST, typed, typed_tree


@pytest.mark.parametrize(("text", "value"), [
    ("", None), (" 2.5 ", 2.5), ("-2*b", -16.0), ("[1, -b, 2^3]", [1.0, -8.0, 8.0]),
    ("(1, 2)", [1.0, 2.0]), ("sin(radians(30))", 0.5), ("sqrt(2)*pi", math.sqrt(2) * math.pi),
    ("atan2(1, 1)", math.pi / 4), ("1e3", 1000.0), ("−2×b·3÷4", -12.0), ("1\xa0− 2", -1.0),
])  # fmt: skip
def test_numbers_lists_and_arithmetic_are_read(text, value):
    assert typed(text, {"b": 8.0}) == (value if value is None else pytest.approx(value))


def test_a_word_is_itself():
    assert typed(" 'stable' ", {}, ("stable",)) == "stable"


@pytest.mark.parametrize(
    "text",
    ["c", "__import__('os')", "b.real", "[1, 2", "lambda: 1", "1 if b else 2", "b[0]", "'a'*9",
     "1/0", "1e999", "[1, -1e999]", "<b>1</b>", "[1,2]+3", "9**9**9**9", "(" * 500, "open('x')", "True",
     "(-8)**(1/3)", "['+', 1, 2] + 1", "-" * LONGEST + "1", "[['b'], 1]", "sin([1])"],
)  # fmt: skip
def test_anything_else_is_refused_and_never_run(text):
    with pytest.raises(AnswerError):
        typed(text, {"b": 8.0})


@pytest.mark.parametrize(("text", "why"), [
    ("9" * 400, "too large"), ("1e999", "too large"), ("(-8)**(1/3)", "not a real"),
    ("[1,2]+3", "only numbers, lists"), ("sin([1])", "only numbers, lists"),
])  # fmt: skip
def test_the_student_reads_why(text, why):
    with pytest.raises(AnswerError, match=why):
        typed(text, {})


@pytest.mark.parametrize(("text", "tree"), [
    ("-2*b*pi", ["*", -2.0, "b", "pi"]), ("1 - b/2", ["+", 1.0, ["*", -1.0, ["/", "b", 2.0]]]),
    ("[b, -b^2]", ("b", ["*", -1.0, ["^", "b", 2.0]])), ("[sin(b)]", (["sin", "b"],)),
])  # fmt: skip
def test_it_is_a_formula_tree_and_lists_are_distinguished_from_operators(text, tree):
    assert typed_tree(text, {"b": 8.0}) == tree

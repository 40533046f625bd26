"""Answers that are impossible, whatever the key."""

import pytest

from newton_euler.answers.forms import Form
from newton_euler.answers.sanity import KINETIC, doubts
from newton_euler.classroom import expect, receipt

INERTIA = Form("matrix", "kg*m^2")


def of(*rows):
    return [x for row in rows for x in row]


@pytest.mark.parametrize(
    ("matrix", "words"),
    [
        (of((2, 0, 0), (0, 2, 0), (0, 0, 3)), None),
        (of((2, 0.5, 0), (0.5, 2, 0), (0, 0, 3)), None),
        (of((1, 0, 0), (0, 1, 0), (0, 0, 2)), None),  # a flat body: just possible
        (of((1, 0, 0), (0, 1, 0), (0, 0, 2.1)), "at most the sum"),
        (of((2, 0.5, 0), (0.502, 2, 0), (0, 0, 3)), None),
        (of((2, 0.5, 0), (0.505, 2, 0), (0, 0, 3)), "symmetric"),
        (of((1, 2, 0), (2, 1, 0), (0, 0, 3)), "negative"),
        (of((0, 0, 0), (0, 0, 0), (0, 0, 0)), None),
    ],
)
def test_an_inertia_matrix_is_one_that_a_body_can_have(matrix, words):
    found = doubts(INERTIA, matrix, {}, None)
    assert (words in found[0]) if words else found == []


def test_formulas_of_inertias_energies_and_magnitudes_are_sane():
    form, symbols = Form("matrix_expression", "kg*m^2"), {"m": "kg", "b": "m"}
    d, x = ["*", "m", ["^", "b", 2]], ["*", "m", "b"]
    assert doubts(form, of((d, x, 0), (x, d, 0), (0, 0, d)), symbols, None) == []
    (doubt,) = doubts(form, of((d, x, 0), (["*", -1, x], d, 0), (0, 0, d)), symbols, None)
    assert "symmetric" in doubt
    assert doubts(Form("matrix", "1"), of((1, 2, 0), (-2, 1, 0), (0, 0, 9)), {}, None) == []
    form, symbols = Form("expression", "J"), {"m": "kg", "v": "m/s"}
    right = ["*", 0.5, "m", ["^", "v", 2]]
    assert doubts(form, right, symbols, KINETIC) == []
    assert doubts(form, ["*", -1, right], symbols, KINETIC) == [
        "a kinetic energy is never negative"
    ]
    assert doubts(Form("number", "J"), -2.0, {}, KINETIC)
    symbols, x = {"u": "m/s"}, ["*", 3, "u"]
    others = {"v": (Form("vector_expression", "m/s"), ["u", ["*", 2, "u"], ["*", 2, "u"]])}
    form = Form("expression", "m/s")
    assert doubts(form, x, symbols, "magnitude of v", others) == []
    found = doubts(form, ["*", 5, "u"], symbols, "magnitude of v", others)
    assert found == ["it is not the magnitude of v"]


SPEED, VELOCITY = Form("number", "m/s"), Form("vector", "m/s")
WRONG = "it is not the magnitude of v, which is 3 m/s"


@pytest.mark.parametrize("bounds", [(), (0.1, 100.0)])
@pytest.mark.parametrize(
    ("speed", "v", "words"),
    [
        (3.0, [1.0, 2.0, 2.0], []),
        (3.0, {"body": [2.0, -2.0, 1.0]}, []),
        (3.01, [1.0, 2.0, 2.0], []),  # rounded
        (3.0, None, []),
        (3.5, [1.0, 2.0, 2.0], [WRONG]),
        (-3.0, None, ["a magnitude is never negative"]),
        (-3.0, [1.0, 2.0, 2.0], ["a magnitude is never negative", WRONG]),
    ],
)
def test_a_magnitude_is_not_negative_and_is_that_of_the_vector_beside_it(speed, v, words, bounds):
    sane = (*bounds, "magnitude of v") if bounds else "magnitude of v"
    assert doubts(SPEED, speed, {}, sane, {"v": (VELOCITY, v)}) == words
    assert doubts(SPEED, speed, {}, "magnitude") == words[: speed < 0]


@pytest.mark.parametrize(
    ("x", "fine"), [(5.0, True), (0.05, False), (200.0, False), (0.0, True), (-5.0, True)]
)
def test_a_size_lies_between_what_the_givens_allow(x, fine):
    """A wrong unit cannot make an answer zero."""
    assert (doubts(Form("number", "m"), x, {}, (0.1, 100)) == []) is fine


@pytest.mark.parametrize("tree", [None, "stable", ["log", 0], {"a": [1, 2]}, ["nonsense"]])
def test_what_cannot_be_judged_is_not_doubted(tree):
    assert doubts(Form("expression", "m"), tree, {}, KINETIC) == []


def test_the_receipt_says_so_and_keeps_the_answer():
    expect("0/9", sane={"v": (0.1, 100)}, v="vector, m/s")
    found = receipt("0/9", v=[0, 5000, 0])
    assert "look again at v: its size is 5e+03 m/s" in repr(found)
    assert "check the units" in found.markdown
    assert found.answers == {"v": [0, 5000, 0]}
    assert "look again" not in repr(receipt("0/9", v=[0, 5, 0]))

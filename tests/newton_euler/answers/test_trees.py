"""Trees are data: their value over scalars of every kind, their dimension, cases."""

import math
import re

import numpy as np
import pytest
import sympy

from newton_euler.algebra.units import Dimension
from newton_euler.answers.forms import Form
from newton_euler.answers.trees import TreeError, dimension_hints, evaluate, formula_values
from tests.newton_euler.answers.one_answer import SYMBOLS, omega, one, r, theta


@pytest.mark.parametrize(
    ("formula", "hint"),
    [
        (r * omega, None),
        (r * omega**2, "it is in .*; m/s is asked for"),
        (r + omega, "adds unlike quantities"),
        (sympy.sin(r), "adds unlike|it "),
        (0 * r, None),
        (sympy.sqrt(r**2 * omega**2), None),
        (omega * sympy.Max(r, 2 * r), None),
        (omega * sympy.Piecewise((r, theta > 1), (2 * r, omega > 0), (0, True)), None),
        (omega * sympy.Max(r, 0), None),
        (sympy.Piecewise((r, omega > 1), (omega, True)), "adds unlike quantities"),
        (omega * r * sympy.sign(omega) * sympy.exp(sympy.I * theta), None),
        (sympy.Max(r, omega), "adds unlike quantities"),
    ],
)
def test_the_dimension_of_a_formula_is_hinted_at(formula, hint):
    tree = one("expression, m/s", formula, SYMBOLS)
    hints = dimension_hints(tree, Form.read("expression, m/s"), SYMBOLS)
    assert (hints == []) == (hint is None)
    if hint:
        assert re.search(hint, hints[0])


def test_trees_are_data_for_scalars_of_every_kind():
    tree = ["+", ["*", "r", "omega"], ["^", "r", 2]]
    assert evaluate(tree, {"r": 2.0, "omega": 3.0}) == 10.0
    assert evaluate(tree, {"r": np.array([1.0, 2.0]), "omega": 3.0}).tolist() == [4.0, 10.0]
    assert evaluate(tree, {"r": r, "omega": omega}) == r * omega + r**2
    assert evaluate(["*", "r", "r"], {"r": Dimension(0, 1, 0)}) == Dimension(0, 2, 0)


@pytest.mark.parametrize("tree", [
    ["+"], [], ["exec", 1], [1, 2], {"a": 1}, None, True, ["^", 1], ["atan2", 1], ["nope"],
    "unknown", [["+"], 1], ["sin", 1, 2],
])  # fmt: skip
def test_what_is_not_a_tree_raises_a_tree_error(tree):
    with pytest.raises(TreeError):
        evaluate(tree, {"r": 1.0})


CASES = {
    "where": (["where", ["<", "r", 1.5], 1, 2], [1, 2]),
    "at most": (["<=", "r", 1.0], [1, 0]),
    "larger": (["Max", "r", 1.5, 0], [1.5, 2.0]),
    "smaller": (["Min", "r", 1.5], [1.0, 1.5]),
    "remainder": (["Mod", "r", 1.5], [1.0, 0.5]),
}


@pytest.mark.parametrize("name", CASES)
def test_cases_are_chosen_point_by_point_and_number_by_number(name):
    tree, expected = CASES[name]
    assert evaluate(tree, {"r": np.array([1.0, 2.0])}).tolist() == expected
    assert [evaluate(tree, {"r": x}) for x in (1.0, 2.0)] == expected


def values_of(tree, *x):
    return [point[0] for point in formula_values([tree], {"x": np.array(x)}, [100])]


def test_a_formula_has_a_number_where_it_is_real_with_logarithms_of_negatives_on_its_way():
    square = ["exp", ["*", 2, ["log", "x"]]]  # x^2
    assert values_of(square, -3.0, 2.0) == pytest.approx([9.0, 4.0])
    assert values_of(["^", ["^", "x", 0.5], 2], -3.0, 2.0) == pytest.approx([-3.0, 2.0])
    assert values_of(["log", "x"], -3.0, 1.0) == pytest.approx([math.nan, 0.0], nan_ok=True)
    assert values_of(["^", ["log", "x"], 2], -3.0) == pytest.approx([math.nan], nan_ok=True)

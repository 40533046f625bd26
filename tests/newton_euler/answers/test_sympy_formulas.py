"""Formulas of SymPy and SymEngine are read as trees with the same value, within limits."""

import json

import pytest
import sympy

from newton_euler.answers.forms import AnswerError, Form
from newton_euler.answers.receipts import record
from newton_euler.answers.trees import DEPTH, NODES, evaluate
from tests.newton_euler.answers.one_answer import SYMBOLS, omega, one, r, theta

FORMULAS = {
    "polynomial": r * omega**2 / 3,
    "functions": sympy.sin(theta) * sympy.cos(theta) + sympy.tan(theta) / 2,
    "root": sympy.sqrt(r**2 + 1) - sympy.Rational(1, 3),
    "pi": sympy.pi * r,
    "abs": sympy.Abs(sympy.cos(theta) - 1),
    "atan2": sympy.atan2(r, omega),
    "exp": sympy.exp(-theta),
    "E": sympy.E * r,
    "float": 2.5 * r,
    "negative power": 1 / r,
    "inverse": sympy.asin(theta / 4) + sympy.atan(theta),
    "hyperbolic": sympy.cosh(theta),
    "log": sympy.log(r),
    "secant written out": 1 / sympy.cos(theta),
    "number": sympy.Integer(3),
}


@pytest.mark.parametrize("name", FORMULAS)
def test_a_formula_is_read_as_a_tree_with_the_same_value(name):
    tree = one("expression, m", FORMULAS[name], SYMBOLS)
    sample = {"r": 1.37, "omega": 0.61, "theta": 0.83}
    expected = float(FORMULAS[name].subs({r: 1.37, omega: 0.61, theta: 0.83}))
    assert evaluate(json.loads(json.dumps(tree)), sample) == pytest.approx(expected, rel=1e-12)


@pytest.mark.parametrize("function", ["gamma", "erf", "floor", "zeta", "LambertW"])
def test_a_function_that_is_not_read_is_named(function):
    with pytest.raises(
        AnswerError, match=rf"{function}.* is not among the functions that are read: sin"
    ):
        one("expression, m", getattr(sympy, function)(theta), SYMBOLS)


def test_a_formula_of_too_many_operations_is_refused_in_words():
    with pytest.raises(AnswerError, match=f"more than {NODES} operations. Simplify it"):
        one(
            "expression, m",
            sympy.Add(*(sympy.sin(n * theta) for n in range(2000)), evaluate=False),
            SYMBOLS,
        )


def test_a_formula_nested_very_deep_is_a_fault_and_no_crash():
    x = theta
    for _ in range(3000):
        x = sympy.sin(x, evaluate=False)
    with pytest.raises(AnswerError, match="expected a formula"):
        one("expression, m", x, SYMBOLS)


def test_all_formulas_of_a_receipt_share_one_limit():
    long = sum(sympy.sin(n * theta) for n in range(2, 700))
    forms = {"a": Form.read("expression, m"), "b": Form.read("expression, m")}
    read, faults = record(forms, SYMBOLS, {"a": long, "b": long})
    assert list(read) == ["a"]
    assert "more than 5000 operations" in faults["b"]


def test_a_formula_that_is_refused_takes_nothing_from_the_others():
    endless = sum(sympy.sin(n * theta) for n in range(2, 2000))
    forms = {"a": Form.read("expression, m"), "b": Form.read("expression, m")}
    read, faults = record(forms, SYMBOLS, {"a": endless, "b": r * omega})
    assert list(faults) == ["a"]
    assert read["b"] == ["*", "omega", "r"]


def test_a_formula_that_is_too_deep_to_be_graded_is_refused_at_once():
    x = theta
    for _ in range(DEPTH + 1):
        x = sympy.sin(x, evaluate=False)
    with pytest.raises(AnswerError, match=f"nested more than {DEPTH} deep"):
        one("expression, m", x, SYMBOLS)


@pytest.mark.parametrize("function", [sympy.re, sympy.conjugate, lambda x: sympy.sqrt(x**2)])
def test_symbols_that_a_student_made_without_saying_that_they_are_real_are_read(function):
    plain = sympy.Symbol("r")
    tree = one("expression, m", function(plain) * sympy.Symbol("theta", positive=True), SYMBOLS)
    assert evaluate(tree, {"r": 1.5, "theta": 0.5}) == pytest.approx(0.75)

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
    "fraction of long numbers": r * sympy.Rational(0.1) ** 25 * 10**25,
}


@pytest.mark.parametrize("name", FORMULAS)
def test_a_formula_is_read_as_a_tree_with_the_same_value(name):
    tree = one("expression, m", FORMULAS[name], SYMBOLS)
    sample = {"r": 1.37, "omega": 0.61, "theta": 0.83}
    expected = float(FORMULAS[name].subs({r: 1.37, omega: 0.61, theta: 0.83}))
    assert evaluate(json.loads(json.dumps(tree)), sample) == pytest.approx(expected, rel=1e-12)


def nested(depth):
    x = theta
    for _ in range(depth):
        x = sympy.sin(x, evaluate=False)
    return x


LONG = sympy.Add(*[theta] * (NODES + 1), evaluate=False)
NOT_READ = {
    name: (getattr(sympy, name)(theta), f"{name}.* is not among the functions that are read: sin")
    for name in ("gamma", "erf", "floor", "zeta", "LambertW")
}


@pytest.mark.parametrize(("formula", "message"), [
    *NOT_READ.values(),
    (LONG, f"more than {NODES} operations. Simplify it"),
    (nested(3000), "expected a formula"),
    (r * sympy.Integer(10) ** 400, "got inf"),
    (nested(DEPTH + 1), f"nested more than {DEPTH} deep"),
], ids=[*NOT_READ, "too long", "too deep for Python", "too large", "too deep to be graded"])  # fmt: skip
def test_a_formula_that_cannot_be_graded_is_refused_in_words(formula, message):
    with pytest.raises(AnswerError, match=message):
        one("expression, m", formula, SYMBOLS)


@pytest.mark.parametrize(("both_long", "read", "faulty"), [(True, "a", "b"), (False, "b", "a")])
def test_formulas_share_one_limit_of_which_a_refused_one_takes_nothing(both_long, read, faulty):
    forms = dict.fromkeys("ab", Form.read("expression, m"))
    terms = (sympy.sin(n * theta) for n in range(2, 700 if both_long else 2000))
    long = sympy.Add(*terms)
    found, faults = record(forms, SYMBOLS, {"a": long, "b": long if both_long else r * omega})
    assert list(found) == [read]
    assert f"more than {NODES} operations" in faults[faulty]
    assert found.get("b", ["*", "omega", "r"]) == ["*", "omega", "r"]


@pytest.mark.parametrize("function", [sympy.re, sympy.conjugate, lambda x: sympy.sqrt(x**2)])
def test_symbols_that_a_student_made_without_saying_that_they_are_real_are_read(function):
    plain = sympy.Symbol("r")
    tree = one("expression, m", function(plain) * sympy.Symbol("theta", positive=True), SYMBOLS)
    assert evaluate(tree, {"r": 1.5, "theta": 0.5}) == pytest.approx(0.75)

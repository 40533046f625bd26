"""Receipts: what is read, in which forms, and what is said about the rest."""

import json
import math
from decimal import Decimal
from fractions import Fraction

import mpmath
import numpy as np
import pytest
import sympy

from newton_euler import Frame
from newton_euler.algebra.units import Dimension
from newton_euler.classroom.answers import expect, receipt, receipts, record
from newton_euler.classroom.forms import AnswerError, Form
from newton_euler.classroom.formula_trees import NODES, TreeError, dimension_hints, evaluate

ground = Frame("ground")
SYMBOLS = {"r": "m", "omega": "rad/s", "theta": "rad"}
r, omega, theta = sympy.symbols("r omega theta", real=True)


def one(form, value, symbols=None):
    """What is read of one answer; raises AnswerError if it cannot be."""
    read, faults = record({"x": Form.read(form)}, symbols or {}, {"x": value})
    if faults:
        raise AnswerError(faults["x"])
    return read["x"]


NUMBERS = [
    2.5,
    np.float64(2.5),
    np.float32(2.5),
    np.array(2.5),
    np.array([2.5]),
    [2.5],
    (2.5,),
    mpmath.mpf("2.5"),
    sympy.Rational(5, 2),
    sympy.Float(2.5),
    Fraction(5, 2),
    Decimal("2.5"),
    sympy.sqrt(sympy.Rational(25, 4)),
    sympy.Matrix([2.5]),
]


@pytest.mark.parametrize(
    "value", NUMBERS, ids=lambda v: f"{type(v).__module__}.{type(v).__name__} {v}"
)
def test_a_number_is_read_from_every_library(value):
    assert one("number, m", value) == 2.5
    assert type(one("number, m", value)) is float


@pytest.mark.parametrize(
    "value",
    [2, np.int64(2), np.int8(2), np.uint16(2), sympy.Integer(2), mpmath.mpf(2)],
    ids=lambda v: type(v).__name__,
)
def test_whole_numbers_are_numbers_and_counts(value):
    assert one("number, 1", value) == 2.0
    assert one("count", value) == 2
    assert type(one("count", value)) is int


VECTORS = [
    [1, -2.5, 0],
    (1, -2.5, 0),
    np.array([1, -2.5, 0]),
    np.array([[1], [-2.5], [0]]),
    sympy.Matrix([1, -2.5, 0]),
    sympy.ImmutableMatrix([[1, -2.5, 0]]),
    ground.vector(1, -2.5, 0),
    mpmath.matrix([1, -2.5, 0]),
    [np.float32(1), sympy.Rational(-5, 2), mpmath.mpf(0)],
    ground.i - 2.5 * ground.j,
    (x for x in (1, -2.5, 0)),
    sympy.Array([1, -2.5, 0]),
]


@pytest.mark.parametrize("value", VECTORS, ids=lambda v: type(v).__name__)
def test_a_vector_is_read_from_every_library(value):
    assert one("vector, m/s", value) == [1.0, -2.5, 0.0]


MATRICES = [
    np.arange(9.0).reshape(3, 3),
    np.arange(9).reshape(3, 3).tolist(),
    sympy.Matrix(3, 3, range(9)),
    mpmath.matrix(np.arange(9).reshape(3, 3).tolist()),
]


@pytest.mark.parametrize("value", MATRICES, ids=lambda v: type(v).__name__)
def test_a_matrix_is_read_row_by_row(value):
    assert one("matrix, kg*m^2", value) == list(map(float, range(9)))


def test_an_interval_a_word_and_a_blank_are_read():
    assert one("interval, rad/s", (1, 2.5)) == [1.0, 2.5]
    assert one("choice: stable | unstable", "stable") == "stable"
    assert one("vector, m", None) is None


def test_symengine_is_read_as_sympy_is():
    symengine = pytest.importorskip("symengine")
    R, W = symengine.symbols("r omega")
    assert one("number, m", symengine.Rational(5, 2)) == 2.5
    sample = {"r": 1.5, "omega": 0.7}
    assert evaluate(
        one("expression, m/s", R * W + symengine.sin(W) ** 2 / 3, SYMBOLS), sample
    ) == pytest.approx(1.5 * 0.7 + math.sin(0.7) ** 2 / 3)
    assert one("vector_expression, m/s", symengine.Matrix([R * W, 0, 1]), SYMBOLS)[1:] == [0, 1]


def test_pint_quantities_are_converted_to_the_unit_asked_for():
    pint = pytest.importorskip("pint")
    u = pint.UnitRegistry()
    assert one("number, mm", 2.5 * u.m) == pytest.approx(2500)
    assert one("vector, mm/s^2", np.array([1, 2, 3]) * u.m / u.s**2) == pytest.approx(
        [1000, 2000, 3000]
    )
    assert one("number, ft/s", 12 * u.inch / u.s) == pytest.approx(1)
    assert one("vector, mm", [1 * u.m, 2 * u.cm, 3 * u.mm]) == pytest.approx([1000, 20, 3])
    with pytest.raises(AnswerError, match=r"in mm.*cannot be converted"):
        one("number, mm", 2.5 * u.s)
    assert one("number, lb", 10 * u.pound_force) == pytest.approx(10)
    assert one("number, rev/min", math.pi * u.rad / u.s) == pytest.approx(30)


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


@pytest.mark.parametrize("function", ["sec", "csc", "cot", "sign", "Heaviside"])
def test_a_function_that_is_not_read_is_named(function):
    with pytest.raises(
        AnswerError, match=rf"{function}.* is not among the functions that are read: sin"
    ):
        one("expression, m", getattr(sympy, function)(theta), SYMBOLS)


# -- what cannot be read: expected, got, what to do

WRONG = [
    (
        "vector, mm/s",
        [1, 2],
        r"expected a vector, three numbers as in .*, in mm/s; got 2 numbers: \[1, 2\]",
    ),
    ("vector, mm/s", 3.0, "expected a vector.*got 1 number: 3.0"),
    ("vector, mm/s", "[1, 2, 3]", "got the text .*write it without quotation marks"),
    ("vector, mm/s", {"x": 1, "y": 2, "z": 3}, "got a dict, which has no order"),
    ("vector, mm/s", {1, 2, 3}, "got a set, which has no order"),
    (
        "vector, mm/s",
        [1, float("nan"), 0],
        "got nan, which comes from a division by zero or the root of a negative number",
    ),
    ("number, m", float("inf"), "got inf, which comes from a division by zero"),
    ("number, m", np.float64("nan"), "got nan"),
    ("number, m", sympy.nan, "got nan"),
    ("number, m", sympy.zoo, "cannot make a number"),
    ("number, m", True, "expected one number, in m; got True"),
    ("number, m", 1j, "expected one number, in m; got 1j"),
    ("number, m", sympy.I, "cannot make a number of I"),
    ("number, m", np.complex128(1 + 2j), "expected one number"),
    ("number, m", [1, 2, 3], "expected one number, in m; got 3 numbers"),
    ("number, m", [], "got 0 numbers"),
    ("number, m", ground.i, "expected one number, in m; got 3 numbers"),
    ("number, m", r * 2, "still contains r; put in the numbers"),
    ("number, m", print, "cannot make a number of <built-in function print>"),
    ("number, m", "2.5", "write it without quotation marks"),
    ("matrix, kg*m^2", [[1, 2], [3, 4]], "expected a 3 x 3 matrix of numbers.*got 4 numbers"),
    ("interval, m", 1.0, "expected an interval, two numbers as in"),
    ("count", 2.5, "expected a whole number; got 2.5"),
    ("count", True, "expected a whole number; got True"),
    ("count", "three", "expected a whole number"),
    ("count", float("nan"), "expected a whole number"),
    ("choice: stable | unstable", "Stable", "expected one of 'stable', 'unstable'; got 'Stable'"),
    ("choice: stable | unstable", 1, "expected one of 'stable', 'unstable'; got '1'"),
    ("choice: stable | unstable", ["stable"], "expected one of"),
    ("choice: stable | unstable", np.array([1, 2]), "expected one of"),
    (
        "expression, m",
        sympy.Symbol("q") * r,
        "it contains 'q', but the symbols of the problem are r, omega, theta",
    ),
    ("expression, m", "r*omega", "write it without quotation marks"),
    ("expression, m", r > 1, "expected a formula"),
    ("expression, m", sympy.Eq(r, 1), "expected a formula"),
    ("expression, m", sympy.Function("f")(theta), "f is not among the functions"),
    (
        "expression, m",
        sympy.Derivative(sympy.Function("f")(theta), theta),
        "not among the functions",
    ),
    ("expression, m", sympy.Piecewise((r, r > 1), (0, True)), "not among the functions"),
    ("expression, m", [r, r], "expected a formula in the problem's symbols, in m; got 2"),
    ("vector_expression, m", r, "expected a vector of three formulas"),
]


@pytest.mark.parametrize(
    ("form", "value", "said"), WRONG, ids=[f"{f} from {v!r:.30}" for f, v, _ in WRONG]
)
def test_what_cannot_be_read_is_told_with_what_was_expected_and_what_came(form, value, said):
    with pytest.raises(AnswerError, match=said):
        one(form, value, SYMBOLS)


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


class Hostile:
    """An object that fails at whatever is done with it."""

    def __getattr__(self, name):
        raise RuntimeError(f"no {name}")

    def __repr__(self):
        raise ZeroDivisionError

    __float__ = __iter__ = __len__ = __eq__ = __hash__ = __repr__


@pytest.mark.parametrize(
    "form", ["number, m", "vector, m", "count", "choice: a | b", "expression, m", "matrix, m"]
)
def test_an_object_that_fails_at_everything_is_a_fault(form):
    with pytest.raises(AnswerError, match="expected"):
        one(form, Hostile(), SYMBOLS)


def test_one_fault_leaves_the_other_answers():
    forms = {
        "v": Form.read("vector, m/s"),
        "n": Form.read("number, 1"),
        "open": Form.read("number, 1"),
    }
    read, faults = record(forms, {}, {"v": [1, 2], "n": 3})
    assert read == {"n": 3.0, "open": None}
    assert list(faults) == ["v"]


# -- receipt


@pytest.fixture
def problem():
    expect("0/7", {"r": "m", "omega": "rad/s"}, v="vector, m/s", speed="expression, m/s")
    return "0/7"


def test_a_receipt_shows_what_was_read_and_what_is_open(problem):
    said = repr(receipt(problem, v=[1, 2.5, 0], speed=None))
    assert (
        said
        == "0/7: v = [1, 2.5, 0] m/s. Form checked only; the key is not here. Still open: speed."
    )
    assert repr(receipt(problem)) == "0/7: no answer yet."


def test_a_receipt_is_a_json_record(problem):
    given = receipt(problem, v=ground.vector(1, 2, 0), speed=omega * r)
    assert json.loads(given.json) == {
        "problem": "0/7",
        "answers": {"v": [1.0, 2.0, 0.0], "speed": ["*", "omega", "r"]},
    }
    assert receipts["0/7"]["faults"] == {}


def test_a_receipt_names_every_answer_that_cannot_be_read(problem):
    with pytest.raises(
        AnswerError, match=r"0/7, v: expected a vector(.|\n)*0/7, speed: expected a formula"
    ):
        receipt(problem, v=3, speed="r")


def test_an_unknown_problem_or_answer_is_told(problem):
    with pytest.raises(
        AnswerError,
        match=r"nothing is known of problem '9/99'; run the cells of the notebook from the top",
    ):
        receipt("9/99", v=1)
    with pytest.raises(AnswerError, match="problem 0/7 does not ask for 'w'; it asks for v, speed"):
        receipt(problem, w=1)


def test_a_form_that_does_not_exist_is_told():
    with pytest.raises(
        AnswerError, match=r"no such kind of answer: 'tensor'; there are number, vector"
    ):
        expect("0/8", x="tensor, m")


def test_plain_nbgrader_cannot_give_points_for_a_receipt(problem, monkeypatch):
    monkeypatch.setenv("NBGRADER_EXECUTION", "autograde")
    with pytest.raises(AnswerError, match=r"not graded here.*python -m grader grade"):
        receipt(problem, v=[1, 2, 3])


@pytest.mark.parametrize(
    ("formula", "hint"),
    [
        (r * omega, None),
        (r * omega**2, r"it has .*, but m/s has"),
        (r + omega, "adds unlike quantities"),
        (sympy.sin(r), "adds unlike|it "),
        (0 * r, None),
        (sympy.sqrt(r**2 * omega**2), None),
    ],
)
def test_the_dimension_of_a_formula_is_hinted_at(formula, hint):
    tree = one("expression, m/s", formula, SYMBOLS)
    hints = dimension_hints(tree, Form.read("expression, m/s"), SYMBOLS)
    assert (hints == []) == (hint is None)
    if hint:
        import re

        assert re.search(hint, hints[0])


def test_a_hint_stands_in_the_receipt_and_names_the_component():
    expect("0/9", {"r": "m", "omega": "rad/s"}, v="vector_expression, m/s")
    assert "look again at v: component 2 has" in repr(receipt("0/9", v=[r * omega, r, 0]))


def test_trees_are_data_for_scalars_of_every_kind():
    tree = ["+", ["*", "r", "omega"], ["^", "r", 2]]
    assert evaluate(tree, {"r": 2.0, "omega": 3.0}) == 10.0
    assert evaluate(tree, {"r": np.array([1.0, 2.0]), "omega": 3.0}).tolist() == [4.0, 10.0]
    assert evaluate(tree, {"r": r, "omega": omega}) == r * omega + r**2
    assert evaluate(["*", "r", "r"], {"r": Dimension(0, 1, 0)}) == Dimension(0, 2, 0)


@pytest.mark.parametrize(
    "tree",
    [
        ["+"],
        [],
        ["exec", 1],
        [1, 2],
        {"a": 1},
        None,
        True,
        ["^", 1],
        ["atan2", 1],
        ["nope"],
        "unknown",
        [["+"], 1],
        ["sin", 1, 2],
    ],
)
def test_what_is_not_a_tree_raises_a_tree_error(tree):
    with pytest.raises(TreeError):
        evaluate(tree, {"r": 1.0})

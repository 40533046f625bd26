"""Numbers and vectors of every library are read; for the rest the error says what to write."""

import math
import re
from decimal import Decimal
from fractions import Fraction

import mpmath
import numpy as np
import pytest
import sympy
from sympy.physics import units
from sympy.physics.vector import ReferenceFrame

from newton_euler.answers.forms import AnswerError
from newton_euler.answers.receipts import expect, receipt
from newton_euler.answers.trees import evaluate
from tests.newton_euler.answers.one_answer import SYMBOLS, ground, one, r, theta

NUMBERS = [
    2.5, np.float64(2.5), np.float32(2.5), np.array(2.5), np.array([2.5]), [2.5], (2.5,),
    mpmath.mpf("2.5"), sympy.Rational(5, 2), sympy.Float(2.5), Fraction(5, 2), Decimal("2.5"),
    sympy.sqrt(sympy.Rational(25, 4)), sympy.Matrix([2.5]),
]  # fmt: skip


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
    [1, -2.5, 0], (1, -2.5, 0), (x for x in (1, -2.5, 0)),
    np.array([1, -2.5, 0]), np.array([[1], [-2.5], [0]]), mpmath.matrix([1, -2.5, 0]),
    sympy.Matrix([1, -2.5, 0]), sympy.ImmutableMatrix([[1, -2.5, 0]]), sympy.Array([1, -2.5, 0]),
    [np.float32(1), sympy.Rational(-5, 2), mpmath.mpf(0)],
    ground.vector(1, -2.5, 0), ground.i - 2.5 * ground.j,
]  # fmt: skip


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


def test_intervals_words_and_blanks_are_read_and_capitals_distinguished():
    assert one("interval, rad/s", (1, 2.5)) == [1.0, 2.5]
    assert one("choice: stable | unstable", "stable") == "stable"
    assert one("vector, m", None) is None
    assert [one("choice: G | g", x) for x in ("g", "G", " G")] == ["g", "G", "G"]


@pytest.mark.parametrize("text", ["Both Ends", " both ends\n", "BOTH  ends", np.str_("both ends")])
def test_a_word_is_read_with_capitals_and_blanks(text):
    assert one("choice: neither | both ends", text) == "both ends"


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


# -- what cannot be read: expected, got, what to do

WRONG = [
    ("vector, mm/s", [1, 2],
     r"expected a vector, three numbers as in .*, in mm/s; got 2 numbers: \[1, 2\]"),
    ("vector, mm/s", 3.0, "expected a vector.*got 1 number: 3.0"),
    ("vector, mm/s", "[1, 2, 3]", "got the text .*write it without quotation marks"),
    ("vector, mm/s", {"x": 1, "y": 2, "z": 3}, "got a dict, which has no order"),
    ("vector, mm/s", {1, 2, 3}, "got a set, which has no order"),
    ("vector, mm/s", [1, float("nan"), 0],
     "got nan, which comes from a division by zero or the root of a negative number"),
    ("number, m", float("inf"), "got inf, which comes from a division by zero"),
    ("number, m", sympy.zoo, "got nan, which comes from a division by zero"),
    ("number, m", True, "expected one number, in m; got True"),
    ("number, m", 1j, "expected one number, in m; got 1j"),
    ("number, m", sympy.I, "got I, a complex number"),
    ("number, m", [1, 2, 3], "expected one number, in m; got 3 numbers"),
    ("number, m", ground.i, "expected one number, in m; got 3 numbers"),
    ("number, m", r * 2, "still contains r; put in the numbers"),
    ("number, m", print, "cannot make a number of <built-in function print>"),
    ("number, m", "2.5", "write it without quotation marks"),
    ("matrix, kg*m^2", [[1, 2], [3, 4]], "expected a 3 x 3 matrix of numbers.*got 4 numbers"),
    ("interval, m", 1.0, "expected an interval, two numbers as in"),
    ("count", 2.5, "expected a whole number; got 2.5"),
    ("count", True, "expected a whole number; got True"),
    ("count", 10**5000, "expected a whole number; got an object of int"),  # too long for JSON
    ("choice: stable | unstable", "Stabel", "expected one of 'stable', 'unstable'; got 'Stabel'"),
    ("choice: stable | unstable", 1, "expected one of 'stable', 'unstable'; got '1'"),
    ("choice: stable | unstable", np.array([1, 2]), "expected one of"),
    ("expression, m", sympy.Symbol("q") * r,
     "it contains 'q', but the symbols of the problem are r, omega, theta"),
    ("expression, m", r > 1, "expected a formula"),
    ("expression, m", sympy.Eq(r, 1), "expected a formula"),
    ("expression, m", sympy.Function("f")(theta), "f is not among the functions"),
    ("expression, m", sympy.Derivative(sympy.Function("f")(theta), theta),
     "not among the functions"),
    ("expression, m", sympy.Piecewise((r, sympy.Contains(r, sympy.Integers)), (0, True)),
     "the condition .* cannot be read"),
    ("vector, m", b"abc", "got the text b'abc'; write it without quotation marks"),
    ("number, m", lambda: 1.0, "which is a function: call it"),
    ("expression, m", sympy.Eq(theta, r), "an equation; give the side that is asked for"),
    ("number, mm", 5 * units.mm,
     "it contains the unit millimeter; give the number alone, which is in mm"),
    ("vector, m", np.ma.array([1, 2, 3], mask=[0, 1, 0]), "some of its numbers are masked"),
    ("vector, m", ReferenceFrame("N").x, r"a vector of SymPy, N.x; write v.to_matrix\(N\)"),
    ("vector, m", sympy.FiniteSet(1, 2, 3), "got a FiniteSet, which has no order; write it as in"),
    ("expression, m", [r, r], "expected a formula in the problem's symbols, in m; got 2"),
    ("vector_expression, m", r, "expected a vector of three formulas"),
]  # fmt: skip


@pytest.mark.parametrize(
    ("form", "value", "message"), WRONG, ids=[f"{f} from {type(v).__name__}" for f, v, _ in WRONG]
)
def test_what_cannot_be_read_is_reported_with_what_was_expected_and_what_came(form, value, message):
    with pytest.raises(AnswerError, match=message):
        one(form, value, SYMBOLS)


class Hostile:
    """An object that raises an error whatever is done with it."""

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


# -- vectors of the engine


def test_a_vector_is_read_in_its_own_frame_and_the_ground_or_in_the_one_it_can_be():
    arm = ground.rotate("arm", "z", angle=math.pi / 2, rate=1.0)
    assert one("vector, m", 2.0 * arm.i) == {
        "arm": [2.0, 0.0, 0.0],
        "ground": pytest.approx([0.0, 2.0, 0.0]),
    }
    still = ground.rotate("still", "z", rate=1.0)  # at this instant its axes are the ground's
    assert one("vector, m", 2.0 * still.i) == [2.0, 0.0, 0.0]
    arm = ground.rotate("arm", "z", angle=sympy.Symbol("q", real=True))
    assert one("vector_expression, m", r * arm.i, SYMBOLS) == ["r", 0, 0]
    with pytest.raises(AnswerError, match="contains 'q'"):
        one("vector_expression, m", r * ground.i.expressed_in(arm), SYMBOLS) and one(
            "vector_expression, m", sympy.Symbol("q") * arm.i, SYMBOLS
        )


def test_a_vector_is_read_in_the_frames_between_too():
    arm = ground.rotate("arm", "z", angle=math.pi / 2, rate=1.0)
    rod = arm.rotate("rod", "z", angle=math.pi / 2, rate=1.0)
    read = one("vector, m", 2.0 * rod.i)
    assert list(read) == ["rod", "ground", "arm"]
    assert read["arm"] == pytest.approx([0, 2, 0])
    back = arm.rotate("back", "-z", angle=math.pi / 2)  # its axes are the ground's
    assert list(one("vector, m", 2.0 * back.i)) == ["back", "ground", "arm"]
    assert one("vector, m", 2.0 * back.k) == [0, 0, 2.0]
    deep = rod
    for n in range(9):
        deep = deep.rotate(f"frame {n}", "z", angle=0.1)
    assert len(one("vector, m", deep.i)) == 4


def test_frames_of_one_name_are_distinguished_and_a_receipt_shows_both():
    inner = ground.rotate("ground", "z", angle=math.pi / 2, rate=1.0)
    assert list(one("vector, m", 2.0 * inner.i)) == ["ground", "ground'"]
    expect("0/10", v="vector, m")
    arm = ground.rotate("arm", "z", angle=math.pi, rate=1.0)
    message = repr(receipt("0/10", v=arm.vector(1.0, 0, 2.5)))
    assert re.search(r"v = \[1, 0, 2.5\] in arm, \[-1, .*, 2.5\] in ground, in m", message)

"""Formulas of worked solutions as they are read."""

import pytest
import sympy

from exercises.catalogue import problem
from grader.assignment.derivations import derivations
from grader.assignment.formulas import numerals, written
from grader.assignment.tidy import simplest

a, b = sympy.symbols("a b", real=True)
m, g, h = sympy.symbols("m g h", positive=True)


@pytest.mark.parametrize(("formula", "text"), [
    (-a + b, "b - a"),
    (sympy.sqrt(2 * g * h), "sqrt(2*g*h)"),
    (m * sympy.sqrt(g / h), "m*sqrt(g/h)"),
    (sympy.Float(1) / 3 * a, "0.333333*a"),
])  # fmt: skip
def test_a_formula_begins_without_a_sign_and_has_one_root_and_six_digits(formula, text):
    assert written(formula, {}, latex=False) == text


@pytest.mark.parametrize(("formula", "numbers", "text"), [
    (b - a, {"a": -3.0, "b": -2.0}, "-2 + 3"),
    (-a, {"a": -3.0}, "3"),
    (a * b, {"a": -3.0, "b": 2.0}, r"\left(-3\right) \cdot 2"),
    (a**2, {"a": -3.0}, r"\left(-3\right)^{2}"),
])  # fmt: skip
def test_a_negative_number_stands_in_parentheses_and_two_signs_are_one(formula, numbers, text):
    names = numerals({n: (x, "1") for n, x in numbers.items()}, True, True)
    assert written(formula, names, latex=True, numbers=True) == text


def test_units_stand_where_they_do_not_belong_together():
    quantities = {"a": (72.0, "km/h"), "b": (100.0, "m")}
    shown = written(a / b, numerals(quantities, False, True), latex=True, numbers=True)
    assert shown == r"\frac{72\ \text{km/h}}{100\ \text{m}}"


def test_a_right_angle_beside_degrees_is_written_in_degrees():
    assert written(sympy.pi / 2 - a, {}, latex=True, degrees=True) == r"90^\circ - a"


def test_a_name_with_a_bar_stands_in_parentheses_under_a_power():
    assert written(a**3, {"a": "l/r"}, latex=True) == r"\left(l/r\right)^{3}"


def test_a_result_is_short():
    assert simplest(sympy.sin(a) ** 2 * b + sympy.cos(a) ** 2 * b) == b


def test_equations_that_are_solved_together_are_shown_once_with_their_unknowns():
    found = derivations(problem("6/5"), problem("6/5").book_values)
    shown = [d.together for d in found.values() if d.together]
    assert [len(equations) for equations in shown] == [3]
    assert found["a_A"].unknowns == {"a_A", "a_B", "T"}
    assert found["T"].solved
    assert not found["T"].together


def test_a_later_quantity_is_written_by_the_names_of_earlier_ones():
    p = problem("5/3")
    shown = [str(f) for f in derivations(p, p.book_values)["d"].formulas]
    assert shown == ["Q_x/V", "Q_y/V", "Q_z/V"]


@pytest.mark.parametrize(("angle", "has_bars"), [(30.0, False), (-30.0, True)])
def test_bars_stand_only_where_they_change_the_number(angle, has_bars):
    p = problem("3/11")
    formula = derivations(p, {**p.book_values, "angle": angle})["a_n"].formulas[0]
    assert formula.has(sympy.Abs) == has_bars

"""Formulas print as in a textbook: without factors between coherent units, with symbols that are
positive where their range is, without components that vanish.
"""

import pytest
import sympy

from exercises.catalogue import Answer, Symbol
from exercises.catalogue.checks import check
from newton_euler import Frame, cos, sin, sqrt
from newton_euler.algebra.units import SI, US, Dimension, Unit, UnitError


def symbols(**units):
    low = {"theta": 0.2, "x": -1.0}
    return {n: Symbol(n, u, (low.get(n, 0.5), 1.2)) for n, u in units.items()}


@pytest.fixture
def problem_with(made):
    """A function that makes a problem of this code, these symbols and answers."""
    return lambda solve, units, answers: made(solve, symbols=symbols(**units), answers=(*answers,))


WHEEL = {"r": "ft", "e": "ft", "theta": "rad", "g": "ft/s^2"}


def jump(g):
    """8/6: the speed at which an unbalanced wheel leaves the incline."""
    return {"v_min": sqrt(g.g * (g.r**2 + 2 * g.r * g.e * cos(g.theta)) / g.e)}


def test_formulas_in_feet_and_inches_have_the_factors_of_their_system(problem_with):
    answers = [Answer("v_min", "expression", "ft/s", "speed")]
    p = problem_with(jump, WHEEL, answers)
    s = p.sympy_symbols()
    r, e = s["r"], s["e"]
    assert p.formulas()["v_min"] == sqrt(s["g"] * (r**2 + 2 * r * e * cos(s["theta"])) / e)
    assert check(p, seeds=3) == []
    solve = lambda g: {"F": g.W * g.r / g.e, "alpha": g.W * g.r / (g.m * g.r**2)}
    answers = [Answer("F", "expression", "lb", ""), Answer("alpha", "expression", "rad/s^2", "")]
    p = problem_with(solve, {"W": "oz", "r": "in", "e": "ft", "m": "slug"}, answers)
    s = p.sympy_symbols()
    force, r = s["W"] / 16, s["r"] / 12
    assert p.formulas() == {"F": force * r / s["e"], "alpha": force / (s["m"] * r)}


def test_givens_in_numbers_are_the_same_in_either_system(problem_with):
    answers = [Answer("v_min", "expression", "ft/s", "speed")]
    p = problem_with(jump, WHEEL, answers)
    metric = problem_with(jump, {**WHEEL, "r": "m"}, answers)
    assert (p.system, metric.system) == (US, SI)
    values = {"r": 0.9, "e": 0.3, "theta": 0.4, "g": 32.2}
    assert p.base(values).r == values["r"] == p.base(values).stated("r")
    in_metres = metric.solve({**values, "r": 0.9 * 0.3048})["v_min"]
    assert p.solve(values)["v_min"] == pytest.approx(in_metres, rel=1e-14)


def test_symbols_are_positive_where_their_range_is(problem_with):
    solve = lambda g: {"d": sqrt(g.r**2) + sqrt(g.x**2)}
    p = problem_with(solve, {"r": "m", "x": "m"}, [Answer("d", "expression", "m", "")])
    r, x = sympy.Symbol("r", positive=True), sympy.Symbol("x", real=True)
    assert p.formulas()["d"] == r + abs(x)


def test_components_that_vanish_are_dropped_and_the_terms_kept(problem_with):
    def solve(g):
        ground = Frame("ground")
        nothing = sin(g.theta) ** 2 + cos(g.theta) ** 2 - 1
        return {"a": ground.vector(g.r, g.r * nothing, 0), "b": g.r * nothing}

    answers = [Answer("a", "vector_expression", "m", ""), Answer("b", "expression", "m", "")]
    p = problem_with(solve, {"r": "m", "theta": "rad"}, answers)
    found = p.formulas()
    assert list(found["a"]) == [p.sympy_symbols()["r"], 0, 0]
    assert found["b"] == 0
    ground = Frame("ground")
    r = sympy.Symbol("r")
    arm = ground.rotate("arm", "z", rate=r)
    a = arm.point("P", r, 0, 0).acceleration(ground)
    assert a.cleared().terms.keys() == a.terms.keys()


@pytest.mark.parametrize("name", ["ft", "slug", "lb", "lb*ft", "slug*ft^2", "ft/s^2", "rad", "s"])
def test_foot_slug_pound_and_second_are_coherent(name):
    assert Unit(name).to_base(3.7, US) == 3.7 == Unit(name).from_base(3.7, US)


def test_a_system_of_units_has_whole_powers():
    with pytest.raises(UnitError, match="whole powers"):
        US.factor(Dimension(0, 0.5, 0))

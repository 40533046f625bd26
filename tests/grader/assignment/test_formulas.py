"""The formulas of worked solutions as a reader sees them."""

import re

import pytest
import sympy

from exercises.catalogue import problem
from grader.assignment.derivations import derivations
from grader.assignment.formulas import formula_text, numerals
from grader.assignment.lines import lines
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
    assert formula_text(formula, {}, latex=False) == text


@pytest.mark.parametrize(("formula", "numbers", "text"), [
    (b - a, {"a": -3.0, "b": -2.0}, "-2 + 3"),
    (-a, {"a": -3.0}, "3"),
    (a * b, {"a": -3.0, "b": 2.0}, r"\left(-3\right) \cdot 2"),
    (a**2, {"a": -3.0}, r"\left(-3\right)^{2}"),
])  # fmt: skip
def test_a_negative_number_is_put_in_parentheses_and_two_signs_become_one(formula, numbers, text):
    names = numerals({n: (x, "1") for n, x in numbers.items()}, True, True)
    assert formula_text(formula, names, latex=True, numbers=True) == text


@pytest.mark.parametrize(("formula", "text"), [
    (m * a**2 / 12 + m * b**2 / 12, "m*(a**2 + b**2)/12"),
    (m * g + m * a, "a*m + g*m"),  # a weight and an inertia
    (m * g * a / b - m * g * b, "a*g*m/b - b*g*m"),
    (-m * a * g - m * a * h - m * b * g - m * b * h, "-m*(a + b)*(g + h)"),
    (a * (g + h) + b * (g + h) + m, "m + (a + b)*(g + h)"),
    (g + m * a**2 + m * b**2, "g + m*(a**2 + b**2)"),
    (0.4 * a**2 + 0.4 * b**2 - m, "0.4*(a**2 + b**2) - m"),
    (a * b * (1 + m), "a*b*(1 + m)"),
    (1 + sympy.cos(a) ** 2, "1 + cos(a)**2"),
    (a * b + g, "g + a*b"),
    (m**2 + 4, "m**2 + 4"),
    (3.5 * a**2 - 1.8 * a + 2, "3.5*a**2 - 1.8*a + 2"),
    (m * (6 * a + 3 * b), "3*m*(2*a + b)"),
    (2 * a * m + g**2, "g**2 + 2*a*m"),  # a name before a product
    (a / sympy.sqrt(2 * g * h), "a/(sqrt(2*g*h))"),
])  # fmt: skip
def test_common_factors_of_a_sum_are_taken_out(formula, text):
    assert formula_text(formula, {}, latex=False) == text


def test_a_result_is_short_and_has_no_factor_1():
    assert simplest(sympy.sin(a) ** 2 * b + sympy.cos(a) ** 2 * b) == b
    assert str(simplest(1.0 * sympy.Symbol("x") ** 2 + 0.5)) == "x**2 + 0.5"


def test_equations_that_are_solved_together_are_shown_once_with_their_unknowns():
    found = derivations(problem("6/13"), problem("6/13").book_values)
    shown = [d.together for d in found.values() if d.together]
    assert [len(equations) for equations in shown] == [2]  # and none of the unasked alpha
    assert found["a_A"].unknowns == {"a_A", "T"}
    assert found["T"].solved
    assert not found["T"].together


@pytest.mark.parametrize(("angle", "has_bars"), [(30.0, False), (-30.0, True)])
def test_bars_appear_only_where_they_change_the_number(angle, has_bars):
    p = problem("3/11")
    formula = derivations(p, {**p.book_values, "angle": angle})["a_n"].formulas[0]
    assert formula.has(sympy.Abs) == has_bars


def shown(name, key):
    p = problem(name)
    return [str(f) for f in derivations(p, p.book_values)[key].formulas]


@pytest.mark.one_in(4)
@pytest.mark.parametrize(("name", "key", "formulas"), [
    ("5/3", "d", ["Q_x/V", "Q_y/V", "Q_z/V"]),  # by the names of earlier quantities
    ("2/9", "a_n", ["g*(1 - n)"]),  # bars around what is negative for everyone turn its sign
    ("A/16", "z", ["-known_PQ/p_3"]),  # one equation in one unknown is solved
    ("6/17", "rho_C", ["v_C**2/g"]),  # even where the unknown is not one of the problem's
    ("2/32", "a_rel", ["-a_A_x + a_B_x - a_centripetal_x - a_coriolis_x",
                       "-a_A_y + a_B_y - a_euler_y", "0"]),  # not 2 a_B_x
    ("10/4", "psi_fast", ["B/A"]),  # a ratio of earlier ones, by whatever way it was computed
    ("10/12", "ratio", ["sqrt(axial - flat)/sqrt(tall)"]),  # nothing is given
    ("11/26", "v_b", ["sqrt(2)*sqrt(g)*sqrt((b - c)/(1 - ratio))"]),  # m cancels
    ("2/16", "a_P1", ["sqrt(a_n1**2 + a_t1**2)"]),  # a given that was used to find the speed
    ("8/1", "M_C", ["-W*d"]),  # and not g times the mass W/g
    ("9/6", "I_xx", ["I_1*a**2/(a**2 + b**2) + I_2*b**2/(a**2 + b**2)"]),
    ("2/30", "v_rel", ["0", "-v_A_y + v_B_y - v_rotation_y", "0"]),  # not -2 v_A, as v_B = -v_A
    ("4/4", "a_P_coriolis", ["0", "2*n*v_r_x", "0"]),  # not v_P_x, which is equal
    ("3/12", "v_theta", ["a*omega"]),  # a step that converts a given is used after it
    ("2/11", "rho_top", ["v_top**2/g"]),  # an earlier quantity within a product
    ("4/21", "omega_A_of_fork", ["0", "0", "Omega"]),  # not (e_y**2 + e_z**2)*Omega
    ("7/6", "I_xy", ["0"]),  # no round-off
    ("11/17", "T_rot", ["I_C*omega**2/2"]),  # the unknown w is not a quantity of the problem
    ("11/20", "T", ["I_a*omega_axial**2/2 + I_t*omega_t**2/2 + M*v_G**2/2"]),  # not by c and L
    ("8/19", "I_xy", ["d**2*m_1 - d**2*m_3 + 2*d**2*m_4"]),  # not I_xx of the first, which is equal
    ("6/8", "M", ["m_A + 4*m_B"]),  # the masses themselves, and not W_B/g
    ("2/25", "a_P_centripetal", ["-omega**2*r_P_x", "0", "0"]),  # not a_rel, which is another term
    ("4/17", "a_D_centripetal", ["0", "-omega**2*(-L*cos(beta_1) + b)", "0"]),  # not omega*v_D_x
    ("8/11", "H_O", ["-I_zx*omega", "-I_yz*omega", "I_zz*omega"]),  # which are equal
    ("3/27", "r_cyl", ["T_theta_xx*x + T_theta_xy*y", "T_theta_yx*x + T_theta_yy*y", "z"]),
    ("4/9", "x", ["a*sqrt((b**2 - rho**2)/(-a**2 + b**2))"]),  # the square of an earlier root
    ("6/11", "T", ["-F_x*cos(psi) + F_y*sin(psi)"]),  # without the unknown force of the slot
    ("4/28", "a_r", ["-r_x*theta_dot**2", "0", "-r_z*theta_dot**2"]),  # not d sin(theta_1), -r_x
    ("4/26", "alpha_drum_relative", ["0", "-P*e_z*theta_dot", "P*e_y*theta_dot"]),  # not omega_y
    ("2/5", "h", ["g*t_near**2/2 - t_near*v_0*cos(phi)", "g*t_far**2/2 - t_far*v_0*cos(phi)"]),
])  # fmt: skip
def test_a_formula_is_written_as_a_teacher_would_write_it(name, key, formulas):
    assert shown(name, key) == formulas


def test_bodies_that_are_partly_equal_have_names_of_their_own():
    assert shown("7/9", "I_O")[0] == "I_base_xx - I_hole_xx + I_wall_xx"
    assert shown("7/11", "I_BC")[0] == "I_G_BC_xx + d_BC_y**2*m + d_BC_z**2*m"
    assert shown("7/11", "I_AB")[8] == "I_G_AB_zz + d_AB_x**2*m + d_AB_y**2*m"  # not 5*a**2*m/4
    assert shown("7/11", "I_G_BC")[4] == "a**2*m/12"  # and not I_G_OA_yy + 0
    assert shown("7/12", "I_O")[0] == "I_full_xx - I_hole_xx"  # not I_G_hole_xx, which is equal
    used = " ".join(shown("7/9", "I_wall"))
    assert "d_wall_y" in used
    assert "d_base" not in used
    for name in ("5/3", "5/9", "5/14"):  # a part's place by its name, if it is b/2 or given, too
        assert not re.search(r"\b[a-z](_[a-z])?\b", " ".join(shown(name, "Q"))), name


def test_steps_come_after_what_they_are_found_from_and_unknowns_have_their_sign():
    for name, *order in (("A/16", "y", "known_PR", "x"), ("6/21", "phi", "t_f", "x"),
                         ("3/12", "v_axial", "speed")):  # fmt: skip
        p = problem(name)
        assert sorted(order, key=[line.step.key for line in lines(p, p.book_values)].index) == order
    p = problem("4/14")
    ((left, right),) = derivations(p, p.book_values)["omega_spin"].together
    assert {str(left), str(right)} == {"omega_spin_x*r", "-v_A_y"}


QUANTITIES = numerals({"a": (72.0, "km/h"), "b": (100.0, "m")}, False, True)
WORD = {"g": "g", "h": r"\text{height}_x", "m": "m"}


@pytest.mark.parametrize(("formula", "names", "options", "text"), [
    # units are written where they do not combine
    (a / b, QUANTITIES, {"numbers": True}, r"\frac{72\ \text{km/h}}{100\ \text{m}}"),
    (sympy.pi / 2 - a, {}, {"degrees": True}, r"90^\circ - a"),
    (sympy.cos(m) * (a - b), {}, {}, r"\left(a - b\right) \cos {m}"),
    (a**3, {"a": "l/r"}, {}, r"\left(l/r\right)^{3}"),
    (a**2, {"a": r"\sin \phi"}, {}, r"\sin^{2} \phi"),
    (sympy.sin(a * b), {"a": "2", "b": "3"}, {"numbers": True}, r"\sin{\left(2 \cdot 3 \right)}"),
    # a word is set apart from another factor
    (h * m, WORD, {}, r"\text{height}_x\, m"),
    (h**2 * m, WORD, {}, r"\text{height}_x^{2}\, m"),
    (g * h * m, WORD, {}, r"g\, \text{height}_x\, m"),
    (h + m, WORD, {}, r"\text{height}_x + m"),
])  # fmt: skip
def test_a_formula_is_typeset_as_in_a_book(formula, names, options, text):
    assert formula_text(formula, names, latex=True, **options) == text

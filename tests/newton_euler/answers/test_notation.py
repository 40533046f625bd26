r"""Names, units, numbers and formulas as they are printed: LaTeX that MathJax, MathML and matplotlib
can typeset.
"""

import io

import pytest
from latex2mathml.converter import convert
from matplotlib.figure import Figure

from newton_euler.answers.notation import formula, is_word, number_symbol, symbol, unit_symbol

NAMES = {
    "omega": r"\omega", "lam": r"\lambda", "omega_1": r"\omega_1", "beta_A": r"\beta_A",
    "F_theta": r"F_{\theta}", "l_OA": "l_{OA}", "v_Ay": "v_{Ay}", "v_rel": r"v_{\text{rel}}",
    "v0": "v_0", "xA": "x_A", "Ax": "A_x", "AB": "AB", "atA": "a_{t,A}", "b_dot": r"\dot{b}",
    "omega_2_dot": r"\dot{\omega}_2", "rddot": r"\ddot{r}", "Hdot_O": r"\dot{H}_O",
    "ddx": r"\ddot{x}", "da1": r"\dot{a}_1", "theta_rate": r"\dot{\theta}",
    "tan_gamma": r"\tan \gamma", "a_mag": "|a|", "right_handed": r"\text{right handed}",
    "alpha_CD_of_arm_x_rod": r"\alpha_{CD,\text{arm} \times \text{rod}}",
}  # fmt: skip


@pytest.mark.parametrize("name", NAMES)
def test_a_name_is_printed_as_a_book_prints_it(name):
    assert symbol(name) == NAMES[name]


def test_vectors_are_bold_and_numbers_have_six_digits():
    assert symbol("v_D", vector=True) == r"\mathbf{v}_D"
    assert symbol("omega_2_dot", vector=True) == r"\dot{\boldsymbol{\omega}}_2"
    assert [number_symbol(x) for x in (0.1 + 0.2, -7, 12, 1.5e-7, 2e20)] == [
        "0.3", "-7", "12", r"1.5 \times 10^{-7}", r"2 \times 10^{20}",
    ]  # fmt: skip


@pytest.mark.parametrize(
    ("name", "word"),
    [("lead", True), ("speed_rate", True), ("acc_mag", True), ("tilt", True), ("beta", False),
     ("b_dot", False), ("lam", False), ("AB", False)],
)  # fmt: skip
def test_words_are_distinguished_from_symbols(name, word):
    assert is_word(name) is word


UNITS = {
    "1": "",
    "mm/s^2": r"\ \text{mm/s}^2",
    "kg*m^2/s": r"\ \text{kg}\,\text{m}^2\text{/s}",
    "deg": r"^\circ",
    "deg/s^2": r"^\circ\text{/s}^2",
    "%": r"\ \text{\%}",
}


@pytest.mark.parametrize("unit", UNITS)
def test_a_unit_is_upright_with_raised_exponents(unit):
    assert unit_symbol(unit) == UNITS[unit]


FORMULAS = [
    (["*", 2, "r", ["^", "omega", 2]], r"2 r \omega^{2}"),
    (["+", ["*", 4, ["^", "pi", 2]], -3.0, ["*", -1, "x"]], r"4 \pi^{2} - 3 - x"),
    (["*", -1, "r", ["^", "T", -2]], r"-\frac{r}{T^{2}}"),
    (["*", "r", ["+", "a", ["*", -1, "b"]]], r"r \left(a - b\right)"),
    (["^", ["+", "a", "b"], 0.5], r"\sqrt{a + b}"),
    (["^", ["sin", "theta"], 2], r"\sin^{2} \theta"),
    (["cos", ["*", "n", "t"]], r"\cos\left(n t\right)"),
    (["^", ["sin", ["+", "a", "b"]], 3], r"\sin^{3}\left(a + b\right)"),
    (["^", ["sin", "x"], -1], r"\frac{1}{\sin x}"),
    (["^", ["sin", "x"], "n"], r"\left(\sin x\right)^{n}"),
    (["^", ["^", "x", 2], 3], r"\left(x^{2}\right)^{3}"),
    (["^", "x", -1], r"\frac{1}{x}"),
    (["*", -1, ["+", "a", "b"]], r"-\left(a + b\right)"),
    (["+", "a", ["*", -1, ["+", "b", "c"]]], r"a - \left(b + c\right)"),
    (["*", 2, 3.5, "x"], r"2 \cdot 3.5 x"),
    (["atan2", "y", "x"], r"\operatorname{atan2}\left(y,\ x\right)"),
    (["Abs", "x"], r"\left|x\right|"),
    ([["/", "a", "b"], 0, "c"], r"\left[\frac{a}{b},\ 0,\ c\right]"),
    ([1.0, -2.5, 0], r"\left[1,\ {-2.5},\ 0\right]"),
    ({"arm": [1, 0, 0]}, r"\left[1,\ 0,\ 0\right]\ \text{in arm}"),
]


@pytest.mark.parametrize(("tree", "latex"), FORMULAS)
def test_a_formula_has_the_parentheses_that_it_needs(tree, latex):
    assert formula(tree, {}) == latex


def test_symbols_are_printed_as_the_problem_does_and_bring_no_commands():
    assert formula(["*", "d", ["sin", "tilt"]], {"tilt": r"\gamma"}) == (r"d \sin \gamma")
    assert "href" not in formula({r"\href{javascript:x}{y}": [1, 2, 3]}, {}).replace(" href", "")
    assert formula({"$<b>": 1}, {}).count("$") == 0


@pytest.mark.parametrize(
    "latex", [*NAMES.values(), *(f"2{u}" for u in UNITS.values()), *(f for _, f in FORMULAS)]
)
def test_it_can_be_converted_to_mathml(latex):
    assert convert(latex).startswith("<math")


def test_figures_can_print_every_name():
    figure = Figure()
    for latex in NAMES.values():
        figure.text(0, 0, f"${latex}$")
    printed = io.BytesIO()
    figure.savefig(printed, format="png")  # fails on what it cannot print
    assert len(figure.texts) == len(NAMES)
    assert printed.getvalue()

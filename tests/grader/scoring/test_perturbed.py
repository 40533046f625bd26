"""Slips in a traced computation: a thing that slides down and is stopped by a spring."""

import itertools
import math
import random
import re

import pytest

from grader.scoring.slips.edits_of_equations import SLIPS, solution
from newton_euler import cos, sin, sqrt
from newton_euler.algebra.linear import Solved, solve_rates, solved_equations
from newton_euler.algebra.units import SI, unit
from newton_euler.answers.kinds import Kind
from newton_euler.answers.near import NO_SLIPS
from tests.grader.scoring.traced import named_causes, perturbed, texts

UNITS = {"m": "kg", "g": "m/s^2", "s": "mm", "d": "mm", "alpha": "deg", "v": "km/h", "b": "m"}
GIVEN = {"m": 2.3, "g": 9.81, "s": 0.71, "d": 0.26, "alpha": 0.61, "v": 3.1, "b": 1.7}


def energy(m, g, s, alpha, v, **_):
    return m * v**2 / 2 + m * g * s * sin(alpha)


def moment(m, b, d, **_):
    return m * b**2 / 12 + m * d**2


def speed(g, s, alpha, **_):
    return sqrt(2 * g * s * cos(alpha))


UNIT = {"E": "J", "I": "kg*m^2", "u": "m/s"}
FORMULAS = {"E": energy, "I": moment, "u": speed}


@pytest.fixture(scope="module")
def slips():
    stated = {n: unit(UNITS[n]).from_base(x, SI) for n, x in GIVEN.items()}
    return perturbed(UNITS, {key: (UNIT[key], f) for key, f in FORMULAS.items()}, stated)


def named(slips, key, given):
    return named_causes(slips, [given], [FORMULAS[key](**GIVEN)], key=key)


m, g, s, d, alpha, v, b = GIVEN.values()


@pytest.mark.parametrize(
    ("key", "given", "words"),
    [
        ("E", m * v / 2 + m * g * s * math.sin(alpha), "does not square v"),
        ("E", m * v**2 + m * g * s * math.sin(alpha), "leaves out the factor 1/2 of m*v^2/2"),
        ("E", m * v**2 / 2, "leaves out the term m*g*s*sin(alpha)"),
        ("E", m * v**2 / 2 - m * g * s * math.sin(alpha), "with the opposite sign"),
        ("E", m * v**2 / 2 + m * g * s * math.cos(alpha), "takes cos(alpha) for sin(alpha)"),
        ("E", m * v**2 / 2 + m * s * math.sin(alpha), "leaves out the factor g"),
        ("E", m * v**2 / 2 + m * g * d * math.sin(alpha), "takes d for s"),
        ("E", m * (3.6 * v) ** 2 / 2 + m * g * s * math.sin(alpha), "uses v in km/h without"),
        ("E", m * v**2 / 2 + m * g * s * math.sin(math.degrees(alpha)), "uses alpha in deg"),
        ("E", (v**2 / 2 + g * s * math.sin(alpha)), "has one factor m too few"),
        ("I", m * b**2 / 3 + m * d**2, "about its end"),
        ("I", m * b**2 / 12 - m * d**2, "the term m*d^2 with the opposite sign"),
        ("u", math.sqrt(g * s * math.cos(alpha)), "leaves out the factor 2"),
        ("u", 2 * g * s * math.cos(alpha), "leaves out the square root"),
        ("u", math.sqrt(2 * 32.2 * s * math.cos(alpha)), "takes 32.2 for g: that is in ft/s^2"),
        ("I", m * b**2 / 12 + m * (d / 2) ** 2, "takes half of d"),
    ],
)
def test_a_slip_is_named(slips, key, given, words):
    assert words in named(slips, key, float(f"{float(given):.6g}"))


def said(units, unit, formula, **more):
    """The words of the slips in one answer."""
    return " | ".join(texts(perturbed(units, {"x": (unit, formula)}, **more)))


def test_slips_are_those_of_what_a_student_would_write():
    """Such as the quarter turn of the axes in which the code writes an angle."""
    turned = lambda a, c: a * sin(a.trace.step("pi") / 2) + c
    found = said({"a": "m", "c": "m"}, "m", turned)
    assert "takes c for a" in found
    assert "pi" not in found
    whole = lambda rho, a, c: rho * a * a + rho * c * c * c / a
    found = said({"rho": "kg/m^2", "a": "m", "c": "m"}, "kg", whole)
    assert "leaves out rho, in one place" not in found
    assert "leaves out the term" in found
    found = said({"m": "kg", "a": "m"}, "kg*m^2", lambda m, a: m * a * (2 * a - a))
    assert "2*a" not in found
    assert "does not square a of m*a^2" in found


def test_terms_have_the_names_of_quantities_that_the_text_knows():
    root = lambda a, c, e: sqrt(a * a + c * c)  # a separate answer
    work = lambda a, c, e: (a * c + c * e + a * e) * (a + c + e)
    left = lambda a, c, e: work(a, c, e) - e * e * e * root(a, c, e)
    answers, ways = {"r": ("m", root), "x": ("m^4", left)}, {"the work of the spring": work}
    found = " | ".join(texts(perturbed(dict.fromkeys("ace", "m"), answers, ways=ways)))
    assert "leaves out the work of the spring" in found
    assert "leaves out the term e^3*r" in found


def test_a_slip_in_one_of_several_uses_is_less_simple_than_one_in_all():
    answers = {"x": ("m^2/s^2", lambda v, k: k * v + v * v)}
    slips = perturbed({"v": "km/h", "k": "m/s"}, answers)
    ranks = {cause.text: rank for rank, cause in slips.ranked("x").slips}
    everywhere = next(r for x, r in ranks.items() if x.startswith("converts v"))
    in_one = next(r for x, r in ranks.items() if "without converting" in x and "in one" in x)
    assert everywhere // 2 < in_one // 2


LENGTHS = {"a": "m", "c": "m", "k": "s"}
A, C, K = 1.3, 2.3, 3.3


def of_three(given):
    """The diagnosis of a vector, some of whose components are wrong."""
    parts = lambda a, c, k: [a / 3 + c / 2, a * c / (a + c), sqrt(a * a + c * c)]
    slips, key = perturbed(LENGTHS, {"x": ("m", parts)}), parts(A, C, K)
    points = [k if x is None else f"{x:.5g}" for x, k in zip(given, key, strict=True)]
    return named_causes(slips, points, key, "vector")


def test_a_slip_in_some_components_alone_is_named_there():
    assert "in its first and second components takes c for a" in of_three(
        [C / 3 + C / 2, C / 2, None]
    )
    assert "in some" not in of_three([C / 3 + C / 2, C / 2, math.hypot(C, C)])


def test_random_numbers_in_one_component_are_rarely_named():
    rng = random.Random(2)
    tries = [[(A / 3 + C / 2) * 3 ** rng.uniform(-1, 1), None, None] for _ in range(150)]
    assert sum("in its" in of_three([float(f"{x[0]:.4g}"), *x[1:]]) for x in tries) <= 2


@pytest.mark.parametrize(
    ("parts", "wrong", "words"),
    [
        (lambda a, c, k: k * (a / (a + c)) ** 2, K * ((A + C) / A) ** 2, "inverts the ratio of a"),
        (lambda a, c, k: k * (a / (a + c)) ** 2, K * A / (A + C), "does not square the ratio of a"),
        (lambda a, c, k: sqrt(a * a + c * k), A + math.sqrt(C * K), "the root of each term"),
        (
            lambda a, c, k: k * sqrt((2 * a) ** 2 + c * c),
            K * math.sqrt(2 * A * A + C * C),
            "does not square the numbers in 4*a^2 + c^2",
        ),
        (lambda a, c, k: a * c / (5 * k), A * C / (4 * K), "takes the factor 1/4 for 1/5"),
        (lambda a, c, k: a * c / k, A * C / K - A, "subtracts a from x"),
    ],
)
def test_ratios_roots_and_differences(parts, wrong, words):
    slips = perturbed(dict.fromkeys(LENGTHS, "m"), {"x": ("m", parts)})
    assert words in named_causes(slips, [f"{wrong:.6g}"], [parts(A, C, K)])


def test_random_numbers_are_rarely_named(slips):
    rng = random.Random(1)
    right = {key: float(f(**GIVEN)) for key, f in FORMULAS.items()}
    tries = [(key, right[key] * 3 ** rng.uniform(-1, 1)) for key in FORMULAS for _ in range(1000)]
    # in four digits; in problems, whose slips are more, a quarter of a percent
    assert sum(bool(named(slips, k, float(f"{x:.4g}"))) for k, x in tries) <= 20


def test_nothing_is_named_in_a_right_answer_in_few_digits_or_without_a_computation(slips):
    for key, f in FORMULAS.items():
        assert not named(slips, key, float(f(**GIVEN)))
    wrong = math.sqrt(g * s * math.cos(alpha))
    assert "factor 2" in named(slips, "u", round(wrong, 4))
    assert not named(slips, "u", round(wrong, 1))
    assert not named(NO_SLIPS, "E", 1.0)


def test_each_entry_of_equations_that_are_solved_together_is_turned_left_out_doubled_and_halved():
    import numpy as np

    left, right = np.array([[2.0, 1.0, 0.5], [1.0, -3.0, 2.0], [0.3, 1.0, 1.5]]), [4.0, 5.0, -1.0]
    entries = np.column_stack([left, right])
    for place, factor in itertools.product(range(12), SLIPS):
        slipped = entries.copy()
        slipped.flat[place] *= factor
        expected = np.linalg.solve(slipped[:, :3], slipped[:, 3])
        found = [solution(4, k, place, factor, *entries.flat) for k in range(3)]
        np.testing.assert_allclose(found, expected, rtol=1e-9)


def test_a_given_may_be_handed_back_and_a_vector_turned():
    lengths = dict.fromkeys(["p", "q", "x", "y"], "m") | {"s": "1"}
    assert said(lengths, "m", lambda p, q, **_: p - 2 * q).startswith("takes p alone for x")
    found = said(lengths, "m", lambda p, q, x, y, s: [p + s * x, q + s * y, p + s * y])
    assert "takes x, y and y with the opposite sign" not in found
    found = said(lengths, "m", lambda p, q, x, y, s: [p + s * x, q + s * y, 0.0])
    assert "takes p and q with the opposite sign" in found


class Roots(Kind):
    """Three numbers that are no vector."""

    name = "roots"
    shape = (3,)


@pytest.mark.parametrize(
    "formula",
    [
        lambda a, b, c, s: [a * s - b * c, b * s - c * a, c * s - a * b],
        lambda a, b, c, s: [a + s * b, b + s * c, c + s * a],
        lambda a, b, c, s: [s * a, s * b, s * c],
    ],
)
def test_three_numbers_that_are_no_vector_are_told_about_none(formula):
    """As an answer, and on the way to a number."""
    of_vectors = re.compile("component|vector|magnitude of")
    units, way = dict.fromkeys("abcs", "1"), {"the way": formula}
    on_the_way = {"x": ("1", lambda **given: sum(x * x for x in formula(**given)))}
    for answers, ways in ({"x": ("1", formula)}, {}), (on_the_way, way):
        found = texts(perturbed(units, answers, ways=ways, kind=Roots()))
        assert [x for x in found if of_vectors.search(x)] == []
        assert any(map(of_vectors.search, texts(perturbed(units, answers, ways=ways))))


def test_a_given_or_symbol_stands_for_another_of_its_kind_or_for_its_rate():
    units = {"r": "m", "e": "m", "v": "m/s", "k": "kg"}
    for symbols in (units, ()):
        # the others are needed by no answer
        slips = perturbed(units, {"x": ("m^2", lambda r, **_: r * r)}, symbols=symbols)
        found = [words.partition(":")[0] for words in texts(slips)]
        assert {"takes e for r", "takes v for r"} < {*found}
        assert "takes k for r" not in found
    assert len(slips.at("x", 0)) == len(found)


def test_rates_about_different_axes_are_added_as_numbers_and_so_are_their_own_rates():
    units = {"p": "rad/s", "q": "rad/s", "p_dot": "rad/s^2", "q_dot": "rad/s^2"}
    parts = lambda p, q, p_dot, q_dot: [p_dot, 2 * p * q, p * p + q * q]
    values = {"p": 2.0, "q": 3.0, "p_dot": 5.0, "q_dot": 7.0}
    slips = perturbed(units, {"a": ("rad/s^2", parts)}, values)
    pairs = zip(slips.at("a", 0), texts(slips), strict=True)
    added = [[*map(float, row)] for row, words in pairs if words.startswith("adds p and q")]
    assert [12.0, 0.0, 25.0] in added


def test_an_unknown_is_found_from_the_others_with_a_sign_or_taken_as_equal_to_another():
    """2*v - w = a and b*v + 2*w = c."""
    unknowns = lambda a, b, c: ((c + 2 * a) / (b + 4), (2 * c - b * a) / (b + 4))
    rows = lambda a, b, c: [((2, -1), a), ((b, 2), c)]
    systems = lambda **g: [
        Solved(rows(**g), ["v", "w"], dict(zip("vw", unknowns(**g), strict=True)))
    ]
    v_of = lambda **g: unknowns(**g)[0]
    slips = perturbed({"a": "N", "b": "1", "c": "N"}, {"v": ("N", v_of)}, systems=systems)
    a, b, c = 1.3, 2.3, 3.3  # of perturbed()
    right, w = unknowns(a, b, c)
    for given, words in (
        (c / (b + 2), "takes v and w as equal"),
        ((w - a) / 2, "has the term a reversed in finding v"),
        ((c + 2 * w) / b, "has w reversed in finding v"),
        (w / 2, "leaves out the term a in finding v"),
        ((c - 4 * w) / b, "doubles what stands beside w in finding v"),
    ):
        assert words in named_causes(slips, [float(f"{given:.6g}")], [right], key="v")


def test_an_acceleration_may_be_left_out_of_all_equations_but_one():
    """b*u = 3*c - 2*v - w, u = a*v and 2*u = w of a body that moves as it turns: as if u alone
    were.
    """
    u_of = lambda a, b, c: 3 * c / (b + 2 / a + 2)

    def systems(a, b, c):
        u = u_of(a, b, c)
        values = {"u": u, "v": u / a, "w": 2 * u}
        rows = [((b, 2, 1), 3 * c), ((-1, a, 0), 0), ((-2, 0, 1), 0)]
        return [Solved(rows, [*values], values)]

    slips = perturbed({"a": "1", "b": "1", "c": "N"}, {"u": ("N", u_of)}, systems=systems)
    a, b, c = 1.3, 2.3, 3.3  # of perturbed()
    given, right = float(f"{3 * c / b:.6g}"), u_of(a, b, c)
    assert "has u in one equation only" in named_causes(slips, [given], [right], key="u")


@pytest.mark.parametrize("name", ["v", "u_1"])
def test_of_equations_that_are_solved_the_entries_are_perturbed_and_not_the_elimination(name):
    """Nothing can be named about an unknown without a name of its own."""
    equations = lambda a, b, c: lambda v, w: [a * v + b * w - c, b * v - a * w - c]

    def systems(**given):
        with solved_equations() as found:
            solve_rates(equations(**given), 2)
        names = [name, found[0].names[1]]
        values = dict(zip(names, found[0].values.values(), strict=True))
        return [Solved(found[0].equations, names, values)]

    first = lambda **given: solve_rates(equations(**given), 2)[0]
    slips = perturbed(dict.fromkeys("abc", "1"), {"x": ("1", first)}, systems=systems)
    found = [words.partition(":")[0] for words in texts(slips)]
    assert (f"leaves out {name} in one equation" in found) == (name == "v")
    assert not [words for words in found if words.startswith("doubles the term a^2")]
    assert "takes b for a" in found

"""Slips in whole quantities, and in bodies, angles and ratios: each is found by its numbers, and
random numbers rarely are.
"""

import math
import random
import re

import pytest

from grader.scoring.slips.typed import Product, typed
from newton_euler import asin, sqrt
from newton_euler.algebra.scalars import ZERO
from tests.grader.scoring.traced import arguments, named_causes, perturbed, texts

UNITS = {
    "m": "kg", "m1": "kg", "m2": "kg", "m3": "kg", "rho": "kg/m", "L": "m", "d": "m",
    "theta": "rad", "omega": "rad/s", "n": "rev/min", "N": "rev/min", "F": "N", "g": "m/s^2",
}  # fmt: skip
GIVEN = {
    "m": 2.3, "m1": 1.7, "m2": 0.9, "m3": 3.1, "rho": 0.83, "L": 1.37, "d": 0.31, "theta": 0.61,
    "omega": 3.7, "n": 12.7, "N": 5.3, "F": 71.0,
    "g": 9.81,
}  # fmt: skip
m, m1, m2, m3, rho, L, d, theta, omega, n, N, F, g = GIVEN.values()
RPM, SIN, COS = math.pi / 30, math.sin(theta), math.cos(theta)


def abs_of(x):
    """A size, as that of a vector of one component."""
    return sqrt(x * x)


CASES = {  # the right formula, its unit, and intermediate quantities, {words: formula}
    "lever": (lambda F, L, d, **_: F * (L + d), "J", {}),
    "rods": (lambda rho, L, d, **_: (rho * L) * d * d + (rho * d) * L * L, "kg*m^2", {}),
    "masses": (lambda m1, m2, m3, L, d, **_: m1 * L + 2 * m2 * d + 3 * m3 * d, "kg*m", {}),
    "disk": (lambda m, d, **_: m * d**2 / 8, "kg*m^2", {}),
    "energy": (lambda m, L, omega, **_: m * L**2 * omega**2 / 2, "J", {}),
    "rates": (lambda n, N, L, d, **_: n * n * L + N * N * d, "m/s^2", {}),
    "spring": (
        lambda L, d, F, **_: F * (L * L / d - L),
        "J",
        {"the stretch": lambda L, d, **_: L * L / d - L, "the depth": lambda L, d, **_: L + d},
    ),
    "root": (lambda L, d, theta, **_: theta + asin(d / L), "rad", {}),
    "legs": (lambda F, L, d, **_: F * ((L + d) / (2 * L - d)), "N", {}),
    "slope": (lambda F, L, d, **_: F * (L / sqrt(L * L + d * d)), "N", {}),
    "gravity": (lambda F, L, d, **_: F * (L / (L + d)) ** 2, "N", {}),
    "hole": (lambda L, d, theta, **_: theta * d**2 * L / (theta * L**2 - theta * d**2), "m", {}),
    "weights": (
        lambda F, m, g, theta, **_: (F - m * g * theta) / (F / g + (m * g + F) / g),
        "m/s^2",
        {},
    ),
    "free": (
        lambda F, L, d, **_: F * ((abs_of(L + d) - abs_of(d)) ** 2 - (L - abs_of(d)) ** 2),
        "J",
        {},
    ),
}


def slips_of(key):
    formula, unit, ways = CASES[key]
    return perturbed(UNITS, {"x": (unit, formula)}, GIVEN, ways)


def named(key, wrong, slips=None):
    formula, *_ = CASES[key]
    given = {**GIVEN, "n": n * RPM, "N": N * RPM}
    slips = slips or slips_of(key)
    return named_causes(slips, [f"{wrong:.7g}"], [formula(**given)])


@pytest.mark.parametrize(
    ("key", "wrong", "words"),
    [
        ("lever", F * L / 2, "takes L/2 for L + d"),
        ("rods", rho * d * d + rho * L * L, "takes rho for a mass"),
        ("disk", m * d**2 / 4, "takes the factor 1 for 1/2 in a moment of inertia"),
        ("energy", m * L**2 * omega**2 / 6, "takes the factor 1/3 for 1 in a moment of inertia"),
        ("rates", (n * n * L + N * N * d) / 3600, "leaves out 2*pi in rev/min"),
        ("rates", RPM * (n * L + N * d), "does not square n and N"),
        ("spring", F * (L + d), "takes the depth for the stretch"),
        ("hole", d * L / (L - d), "does not square d and L"),
        ("weights", (F - m * g * theta) / (m * g + 2 * F), "takes the weights for masses"),
        ("free", F * ((L + d) ** 2 - L**2), "leaves out the term d"),
        ("legs", F * (2 * L - d) / (L + d), "inverts the ratio of L + d to 2*L - d"),
        ("masses", (m1 + 2 * m2 + 3 * m3) * (L + d) / 2, "takes L and d as equal"),
        ("slope", F * d / L, "takes d/L, a tangent, for L over the slant side"),
        ("slope", F * math.sqrt(L * L - d * d) / L, "takes the leg sqrt(L^2 - d^2) for L"),
        ("gravity", F * (L / (L + d)) ** 3, "takes the third power of the ratio of L to L + d"),
        ("gravity", F * L * L / (L * L + d * d), "squares each term of L + d separately"),
        ("masses", (m1 + m2) * L + 2 * m2 * d + 3 * m3 * d, "takes m1 + m2 for m1"),
    ],
)
def test_a_slip_is_named(key, wrong, words):
    assert words in named(key, wrong)


def test_random_numbers_are_rarely_named():
    found = 0
    for key, (formula, *_) in CASES.items():
        rng, slips = random.Random(key), slips_of(key)
        right = float(formula(**{**GIVEN, "n": n * RPM, "N": N * RPM}))
        tries = [float(f"{right * 3 ** rng.uniform(-1, 1):.4g}") for _ in range(200)]
        found += sum(bool(named(key, x, slips)) for x in tries)
    assert found <= 0.0075 * 200 * len(CASES)


def test_kinetic_energy_is_not_taken_for_a_moment_of_inertia_nor_an_acceleration_for_g():
    units = {"m": "kg", "v": "m/s", "a": "m/s^2"}
    energy = lambda m, v, a: m * v * v / 2 + m * a * (v * v / a)
    found = texts(perturbed(units, {"x": ("J", energy)}))
    assert not [words for words in found if "moment of inertia" in words or "10 for a" in words]


P, Q, K = 1.35172, 2.91346, 0.71238
VECTOR = {"p": "m", "q": "m", "k": "1/s"}


def of_vector(given, parts, unit="m", ways=None, kind="vector"):
    """The diagnosis of a vector of these parts."""
    values = dict(zip(VECTOR, (P, Q, K), strict=True))
    slips = perturbed(VECTOR, {"x": (unit, parts)}, values, ways)
    return named_causes(slips, given, parts(**values), kind)


def test_components_from_another_origin_are_named_and_no_given_as_the_whole_answer():
    parts = lambda p, q, **_: [p + 2 * q, q * q / p, 0 * p]
    middle = {"the middle": lambda p, q, **_: (p / 2, q / 2, 0)}
    right = [float(x) for x in parts(P, Q)]
    less = (right[0] - P / 2, right[1] - Q / 2, 0.0)
    assert "subtracts the middle from x" in of_vector(less, parts, ways=middle)
    # each length equals some component by chance
    assert "alone" not in of_vector((right[0], Q / 2, 0.0), parts)


def test_a_multiple_of_a_vector_is_met_by_chance_as_one_number_is():
    """Three components that are off together by 0.1 % are not three witnesses."""
    parts = lambda p, q, k: [p * (p + q) * k, q * (p + q) * k, p * (p + q)]
    right = parts(P, Q, K)
    turned = [float(f"{x * (P - Q) / (P + Q):.6g}") for x in right]
    assert "opposite sign" in of_vector(turned, parts, "m^2")
    assert "opposite sign" not in of_vector([1.001 * x for x in turned], parts, "m^2")


def test_a_quantity_is_turned_doubled_and_left_out_even_where_the_trace_moved_its_sign():
    rate = {"the second rate": lambda p, q, k: -(k * p / q)}
    parts = lambda p, q, k: [k * p - (k * p / q) * p, k * q - (k * p / q) * q, k * p]
    p, q, k = P, Q, K
    for factor, words in ((-1, "the opposite sign"), (2, "doubles"), (0, "leaves out")):
        given = (k * p - factor * k * p / q * p, k * q - factor * k * p / q * q, k * p)
        found = of_vector(given, parts, "m/s", rate)
        assert words in found
        assert "the second rate" in found


def test_terms_are_written_as_a_student_does_and_a_sum_squared_once():
    a, b = arguments("ab").values()
    nothing = a.trace.new("-", a, a)
    length = a.trace.new("sqrt", a.trace.new("+", a * a, nothing * nothing))
    assert typed(length * b) == "a*b"
    assert typed(abs_of(-2 * a - b) - b) == "2*a"
    assert typed(abs_of(-2 * a - b) * a) == "(2*a + b)*a"
    assert typed(abs_of(a - b)) == "(a - b)"
    area = lambda a, b, k: k * (a - b) * (a - b) + (1 - k) * a * a
    found = texts(perturbed({"a": "m", "b": "m", "k": "1"}, {"x": ("m^2", area)}))
    assert any(words.startswith("has the term b with the opposite sign:") for words in found)
    assert not [words for words in found if "b with the opposite sign, in one" in words]
    assert not [words for words in found if "for the 1 of" in words]


def test_symbols_are_taken_for_symbols_and_zeros_of_the_structure_for_numbers():
    units, formula = dict.fromkeys(("a", "b", "c", "d"), "m"), lambda a, c, **_: a * c
    found = texts(perturbed(units, {"x": ("m^2", formula)}, symbols=("a", "b")))
    pairs = [re.match(r"takes ([abcd]) for ([abcd])\b", str(text)) for text in found]
    assert {pair.groups() for pair in pairs if pair} == {("b", "a"), ("d", "c")}
    assert not Product(ZERO).is_exact

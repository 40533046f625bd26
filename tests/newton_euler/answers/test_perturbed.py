"""Slips in a traced computation: a thing that slides down and is stopped by a spring."""

import math
import random

import pytest

from newton_euler import cos, sin, sqrt
from newton_euler.algebra.trace import Trace
from newton_euler.algebra.units import SI, unit
from newton_euler.answers.diagnosis import diagnose
from newton_euler.answers.formulas import Formulas, Traced
from newton_euler.answers.kinds import KINDS
from newton_euler.answers.near import NO_SLIPS
from newton_euler.answers.perturbed import Computation, Perturbed

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
def perturbed():
    trace = Trace()
    given = {n: trace.new("argument", n) for n in UNITS}
    answers = {key: Traced([f(**given)], UNIT[key]) for key, f in FORMULAS.items()}
    stated = {n: unit(UNITS[n]).from_base(x, SI) for n, x in GIVEN.items()}
    return Perturbed(Computation(Formulas(answers, UNITS, SI)), stated)


def named(perturbed, key, given):
    right = FORMULAS[key](**GIVEN)
    causes = diagnose(
        ((given,),),
        ((float(right),),),
        [],
        KINDS["number"],
        slips=lambda fit, kind: perturbed.near(key, fit, kind),
    )
    return " | ".join(c.text for c in causes)


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
        ("I", m * b**2 / 3 + m * d**2, "a rod about its end"),
        ("I", m * b**2 / 12 - m * d**2, "the term m*d^2 with the opposite sign"),
        ("u", math.sqrt(g * s * math.cos(alpha)), "leaves out the factor 2"),
        ("u", 2 * g * s * math.cos(alpha), "leaves out the square root"),
    ],
)
def test_a_slip_is_named(perturbed, key, given, words):
    assert words in named(perturbed, key, float(f"{float(given):.6g}"))


def test_random_numbers_are_hardly_ever_named(perturbed):
    rng = random.Random(1)
    right = {key: float(f(**GIVEN)) for key, f in FORMULAS.items()}
    tries = [(key, right[key] * 3 ** rng.uniform(-1, 1)) for key in FORMULAS for _ in range(400)]
    assert sum(bool(named(perturbed, k, float(f"{x:.4g}"))) for k, x in tries) <= 6


def test_in_few_digits_a_number_meets_a_slip_by_chance_and_is_not_named(perturbed):
    wrong = math.sqrt(g * s * math.cos(alpha))
    assert "factor 2" in named(perturbed, "u", round(wrong, 4))
    assert not named(perturbed, "u", round(wrong, 1))


def test_a_right_answer_has_no_slip(perturbed):
    for key, f in FORMULAS.items():
        assert not named(perturbed, key, float(f(**GIVEN)))


def test_without_a_computation_nothing_is_named():
    assert not named(NO_SLIPS, "E", 1.0)

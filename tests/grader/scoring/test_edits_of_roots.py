"""Slips in an equation whose root is found by numbers: a weight dropped on a spring, and the angle
at which a block slides.
"""

import math

import pytest

from newton_euler import cos, root, sin
from tests.grader.scoring.traced import named_causes, perturbed

UNITS = {"m": "kg", "g": "m/s^2", "k": "N/m", "h": "m", "mu": "1"}
GIVEN = m, g, k, h, mu = 2.3, 9.81, 410.0, 0.83, 0.47


def positive(a, b, c):
    """The positive root of a x^2 - b x - c."""
    return (b + math.sqrt(b * b + 4 * a * c)) / (2 * a)


@pytest.fixture(scope="module")
def slips():
    def dropped(m, g, k, h, mu):
        return root(lambda x: k * x**2 / 2 - m * g * (h + x), 0 * h, 9 * h)

    def sliding(m, g, k, h, mu):
        return root(lambda x: m * g * sin(x) - m * g * mu * cos(x), 0 * mu, 1 + 0 * mu)

    answers = {"x": ("m", dropped), "angle": ("rad", sliding)}
    return perturbed(UNITS, answers, dict(zip(UNITS, GIVEN, strict=True)))


RIGHT = {"x": positive(k / 2, m * g, m * g * h), "angle": math.atan(mu)}


@pytest.mark.parametrize(
    ("key", "given", "words"),
    [
        ("x", math.sqrt(2 * m * g * h / k), "in the equation for x leaves out the term x"),
        ("x", positive(k / 2, -m * g, m * g * h), "has the term x with the opposite sign"),
        ("x", positive(k, m * g, m * g * h), "leaves out the factor 1/2 of k*x^2/2"),
        ("x", m * g * h / (k / 2 - m * g), "in the equation for x does not square x"),
        ("x", -positive(k / 2, -m * g, m * g * h), "takes a smaller root of the equation for x"),
        ("angle", mu, "takes the angle angle as small"),
        ("angle", math.atan(mu / 2), "in the equation for angle halves the term"),
    ],
)
def test_a_slip_in_an_equation_is_found_by_its_root(slips, key, given, words):
    assert words in named_causes(slips, [float(f"{given:.5g}")], [RIGHT[key]], key=key)


def test_an_equation_that_a_slip_leaves_without_a_root_names_nothing(slips):
    """The spring gives energy, as the weight does."""
    said = {c.what: n for n, (_, c) in enumerate(slips.ranked("x").slips)}
    place = said["in the equation for x has the term k*x^2/2 with the opposite sign"]
    assert math.isnan(slips.at("x", 0)[place, 0])

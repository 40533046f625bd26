"""Later answers from a student's own earlier ones, in the units of the text."""

import pytest

from exercises.catalogue import Answer, Given
from exercises.catalogue.following import earlier_answers, follow
from exercises.tools import acceleration_of
from newton_euler import Frame

GIVENS = {"r": Given("r", 50.0, "cm", "the radius")}
ANSWERS = (
    Answer("spin", "number", "rpm", "the rate of turning"),
    Answer("omega", "vector", "rad/s", "the angular velocity"),
    Answer("v", "vector", "mm/s", "the velocity of the rim"),
    Answer("speed", "number", "m/s", "its size"),
    Answer("sense", "choice", "1", "which way", ("left", "right")),
    Answer("turned", "number", "rad", "the angle that it has turned"),
    Answer("I_O", "matrix", "kg*m^2", "the inertia matrix"),
    Answer("H", "vector", "kg*m^2/s", "the angular momentum"),
)
FOLLOWS = {
    "omega": lambda g, spin: spin * Frame("F").k,
    "v": lambda g, omega: omega.cross(g.r * omega.frame.i),
    "speed": lambda g, v, omega: v.norm() + 0 * omega.norm(),
    "sense": lambda g, v: lambda: "left" if v.y > 0 else "right",
    "turned": lambda g, sense: {"left": 1.5, "right": -1.5}[sense],
    "H": lambda g, I_O, omega: omega.frame.vector(
        *(row[0] * omega.x + row[1] * omega.y + row[2] * omega.z for row in I_O)
    ),
}
WHEEL_I = (2.0, -1.0, 0.0, -1.0, 3.0, 0.0, 0.5, 0.0, 4.0)


@pytest.fixture
def wheel(made):
    p = made(lambda g: {}, answers=ANSWERS, givens=GIVENS)
    p.code.follows = FOLLOWS
    return p


def test_the_earlier_answers_are_those_that_the_function_takes(wheel, made):
    assert earlier_answers(wheel)["speed"] == ("v", "omega")
    assert earlier_answers(made(lambda g: {})) == {}


@pytest.mark.parametrize(
    ("key", "earlier", "later"),
    [
        ("omega", {"spin": (60.0,)}, (0, 0, 6.28318530718)),
        ("v", {"omega": (0.0, 0.0, 3.0)}, (0, 1500, 0)),
        ("speed", {"v": (300.0, 400.0, 0.0), "omega": (0.0, 0.0, 1.0)}, (0.5,)),
        ("turned", {"sense": ("right",)}, (-1.5,)),
        ("H", {"I_O": WHEEL_I, "omega": (1.0, 10.0, 100.0)}, (-8, 29, 400.5)),
    ],
)
def test_what_follows_is_in_the_units_of_the_text(wheel, key, earlier, later):
    assert follow(wheel, key, {"r": 50.0}, earlier) == pytest.approx(later)


@pytest.mark.parametrize(("y", "word"), [(2.0, "left"), (-2.0, "right")])
def test_a_word_follows(wheel, y, word):
    assert follow(wheel, "sense", {"r": 50.0}, {"v": (0.0, y, 0.0)}) == (word,)


def test_the_tip_is_accelerated_along_its_path_and_to_the_axis():
    F = Frame("F")
    assert acceleration_of(3 * F.k, 5 * F.k, 2 * F.i) == F.vector(-18, 10, 0)

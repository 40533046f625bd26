"""Quantities with name, value and unit, as a reader wants to see them."""

import mpmath
import numpy as np
import pytest
import sympy

from newton_euler import Frame
from newton_euler.algebra.errors import ArgumentError
from newton_euler.classroom import show

ground = Frame("ground")


def printed(capsys, *what, **options):
    show(*what, **options)
    return capsys.readouterr().out.rstrip("\n")


@pytest.mark.parametrize(
    ("what", "text"),
    [
        (("v", 3.0, "m/s"), "v = 3 m/s"),
        (("turns", 12), "turns = 12"),
        (("angle", 97.66041, "°"), "angle = 97.6604°"),
        (("share", 12.5, "%"), "share = 12.5%"),
        (("loss", 1.25e-8, "s"), "loss = 1.25e-08 s"),
        (("v . a", 1.38778e-17, "m²/s³"), "v . a = 0 m²/s³"),
        (("minus zero", -0.0), "minus zero = 0"),
        (("a", ground.vector(1e-16, -9.81, 0), "m/s²"), "a = [0, -9.81, 0] m/s² in ground"),
        (("R", np.array([[1.0, 1e-17], [0.0, 2 / 3]])), "R = [[1, 0], [0, 0.666667]]"),
        (("x", mpmath.mpf(1) / 3, "m"), "x = 0.333333 m"),
        (("x", np.float64(0.1) + 0.2, "m"), "x = 0.3 m"),
        (("x", sympy.Symbol("t") * 2, "m"), "x = 2*t m"),
        (("is right-handed", True), "is right-handed = True"),
        (("many", np.arange(20.0)), "many = [0, 1, 2, 3, 4, 5, …, 19]"),
        (("gap", float("inf"), "m"), "gap = inf m"),
        (("by hand", 1.0, "by the engine", 2.0), "by hand       = 1\nby the engine = 2"),
        (("v", 1.0, "m/s", "a", 2.0, "m/s²"), "v = 1 m/s\na = 2 m/s²"),
    ],
)
def test_a_quantity_is_a_line_with_name_value_and_unit(capsys, what, text):
    assert printed(capsys, *what) == text


def test_round_off_beside_a_large_value_of_the_same_unit_is_zero(capsys):
    big = ("F", 4e5, "N", "lost", 3e-9, "N")
    assert printed(capsys, *big) == "F    = 400000 N\nlost = 0 N"
    assert printed(capsys, "F", 4e5, "N", "t", 3e-9, "s").endswith("t = 3e-09 s")


def test_values_and_rows_of_tables_are_shown_in_their_digits(capsys):
    row = printed(capsys, "t", 1.0, "s", "v", 2.2222222, "m/s", row=True, digits=3)
    assert row == "t = 1 s, v = 2.22 m/s"
    assert printed(capsys, "ahead", 281.2, "ns", digits=2) == "ahead = 280 ns"
    assert printed(capsys, "radius", 6.371e6, "m") == "radius = 6371000 m"


@pytest.mark.parametrize("what", [(), ("v",), (3.0, "m"), ("v", "m/s"), ("v", 1.0, "m", "a")])
def test_what_is_not_a_name_and_value_is_refused_in_words(what):
    with pytest.raises(ArgumentError, match="show takes a name, a value and a unit"):
        show(*what)

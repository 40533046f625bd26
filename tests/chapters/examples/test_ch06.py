"""The worked examples of 6.2 and 6.5."""

import math

import mpmath as mp

from newton_euler import Frame, moving, polar
from newton_euler.chapters.examples.ch03 import screw_jack_ball, screw_jack_time
from newton_euler.chapters.examples.ch06 import guide_force, screw_jack_arm_force, screw_jack_force
from newton_euler.dynamics.newton import reaction
from tests.kinds import close, every_kind, first, number, numbers, small


@every_kind
def test_example_6_2_mass_at_the_top_of_a_guide(kind):
    m, v, radius, g = numbers(kind, 2, "4.8", "0.5", "9.81")
    R = guide_force(m, v, radius, g)
    assert close(R, m * (v * v / radius - g), small(kind, 0.1))
    if kind != "array":
        assert close(R, numbers("mpmath", "72.54"), small(kind, 0.1))  # the book prints 72.5 N


def test_example_6_2_by_the_whole_circle():
    """From Newton's law in polar coordinates about the centre of curvature."""
    ground = Frame("ground")
    P = polar(ground, "P", 0.5, moving(math.pi / 2, rate=-4.8 / 0.5))
    R = reaction(2.0, P.acceleration(ground), weight=-2.0 * 9.81 * ground.j)
    assert close(R.components(ground), (0, -72.54, 0), 1e-13)


@every_kind
def test_example_6_5_force_on_the_ball_of_the_screw_jack(kind):
    """F = (-4 pi a K m, a K m, L K m/2 pi) after one turn; the book rounds 2.526 N to 2.52."""
    m, a, K, lead = numbers(kind, "0.2", "0.1", 10, "0.5")
    ground = Frame("ground")
    F = screw_jack_force(ground, m, a, K, lead, screw_jack_time(1, K))
    pi = mp.pi if kind in ("mpmath", "sympy") else math.pi
    wanted = tuple(number(x) for x in (a * K * m, lead * K * m))
    assert close(F, (-4 * pi * wanted[0], wanted[0], wanted[1] / (2 * pi)), small(kind))
    assert [round(float(first(number(x))), 2) for x in F] == [-2.51, 0.20, 0.16]
    assert round(float(first(number(F.norm()))), 3) == 2.526
    ball = screw_jack_ball(ground, a, K, lead, screw_jack_time(1, K))
    assert close(ball.coordinates[2].value, lead, small(kind, 0.1))


def test_example_6_5_the_book_leaves_out_the_weight_that_the_arm_carries():
    ground = Frame("ground")
    t = screw_jack_time(1, 10.0)
    arm = screw_jack_arm_force(ground, 0.2, 0.1, 10.0, 0.5, t, 9.81)
    rest = arm - screw_jack_force(ground, 0.2, 0.1, 10.0, 0.5, t)
    assert close(rest, 0.2 * 9.81 * ground.k, 1e-15)
    assert round(arm.norm(), 2) == 3.29  # against 2.53 N without the weight
    assert set(arm.terms) == {"inertia", "weight"}

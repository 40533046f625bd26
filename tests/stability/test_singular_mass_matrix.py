"""Mass matrices near singular: a double pendulum whose upper mass vanishes, and a crank at its dead
centre (8.21).

The mass matrix adds the light mass to the heavy one and loses it; the equations of each particle,
with the tensions kept, do not.
"""

import math

import mpmath
import numpy as np
import pytest

from newton_euler import cos, sin, solve_linear, solve_rates
from newton_euler.algebra import FrameError, LinearError

# both rods of 1 m, at rest; the upper one at 0.5 rad from the vertical, the lower one at 0.5 rad +
# bend
G, ANGLE, HEAVY = 10.0, 0.5, 1.0


def by_mass_matrix(light, bend, number=float, sin=math.sin, cos=math.cos, solve=np.linalg.solve):
    """Both angular accelerations (rad/s^2) from M alpha = f, as Lagrange's equations give it."""
    m, b, a = map(number, (light, bend, ANGLE))
    matrix = [[m + HEAVY, HEAVY * cos(b)], [HEAVY * cos(b), HEAVY]]
    return solve(matrix, [-G * (m + HEAVY) * sin(a), -G * HEAVY * sin(a + b)])


def exact(light, bend):
    with mpmath.workdps(250):
        return tuple(
            by_mass_matrix(light, bend, mpmath.mpf, mpmath.sin, mpmath.cos, mpmath.lu_solve)
        )


def by_newton(light, bend):
    """By Newton's law for each particle along and across its rod, with the tensions S1, S2 (N)."""

    def laws(alpha1, alpha2, S1, S2):
        return {
            "upper, across": light * alpha1 + light * G * sin(ANGLE) - S2 * sin(bend),
            "upper, along": S1 - light * G * cos(ANGLE) - S2 * cos(bend),
            "lower, across": HEAVY * (alpha2 + alpha1 * cos(bend)) + HEAVY * G * sin(ANGLE + bend),
            "lower, along": HEAVY * alpha1 * sin(bend) + S2 - HEAVY * G * cos(ANGLE + bend),
        }

    return solve_linear(laws)


def off(found, light, bend):
    """The largest relative error of the two accelerations."""
    true = exact(light, bend)
    largest = max(map(abs, true))
    return float(max(abs(a - b) / largest for a, b in zip(found, true, strict=True)))


@pytest.mark.parametrize(
    ("light", "bend", "lost"), [(1e-8, 1e-3, 1e-11), (1e-8, 1e-8, 1e-9), (1e-12, 1e-8, 1e-6)]
)
def test_the_mass_matrix_loses_digits_without_a_word(light, bend, lost):
    assert off(by_mass_matrix(light, bend), light, bend) > lost


@pytest.mark.parametrize("light", [1.0, 1e-3, 1e-8, 1e-12, 1e-16, 1e-20, 1e-100])
@pytest.mark.parametrize("bend", [0.3, 1e-3, 1e-8, 1e-12, 0.0])
def test_newtons_law_for_each_particle_is_right_to_1e_minus_14_however_light_it_is(light, bend):
    found = by_newton(light, bend)
    assert off((found.alpha1, found.alpha2), light, bend) < 1e-14


def test_without_the_upper_mass_the_bent_string_is_slack_and_the_straight_one_leaves_two_open():
    bent, straight = by_newton(0.0, 0.3), by_newton(0.0, 0.0)
    assert (bent.S1, bent.S2) == (0.0, 0.0)
    # the lower mass falls freely
    assert bent.alpha1 == pytest.approx(G * math.cos(ANGLE + 0.3) / math.sin(0.3), rel=1e-15)
    assert straight.undetermined == ("alpha1", "alpha2")
    words = "Not determined: alpha1, alpha2: only alpha1 = -4.79426 - alpha2 is known"
    assert words in straight.report()
    with pytest.raises(LinearError, match="alpha1 is not determined by the equations"):
        _ = straight.alpha1


def crank_rate(angle, speed=1.0, arm=0.1, rod=0.3):
    """The rate of the crank (rad/s) at its angle from the line of the slider, from its speed."""
    tilt = -math.asin(arm / rod * math.sin(angle))

    def closing(crank, rocks):
        along = -arm * math.sin(angle) * crank - rod * math.sin(tilt) * rocks - speed
        return along, arm * math.cos(angle) * crank + rod * math.cos(tilt) * rocks

    return solve_rates(closing, 2)[0]


@pytest.mark.parametrize("angle", [0.0, math.pi])
def test_at_its_dead_centre_a_crank_has_no_rate(angle):
    """NumPy's solver gives one of 1e17 rad/s: pi is not quite pi."""
    with pytest.raises(FrameError, match=r"more are needed|do not determine the rates"):
        crank_rate(angle)


@pytest.mark.parametrize("beside", [0.5, 1e-2, 1e-4, 1e-6, 1e-9])
def test_beside_the_dead_centre_the_rate_is_right_to_a_round_off(beside):
    """x = a cos(q) + sqrt(l^2 - a^2 sin^2 q): dx/dq in closed form."""
    s, c = math.sin(beside), math.cos(beside)
    slope = -0.1 * s * (1 + 0.1 * c / math.sqrt(0.09 - 0.01 * s**2))
    assert crank_rate(beside) == pytest.approx(1 / slope, rel=1e-14)

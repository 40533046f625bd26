"""The worked examples of 11.8, 11.10 and 11.12, with (11.21)-(11.25)."""

import math

import mpmath as mp
import pytest

from newton_euler import Frame, cos, particle, radians, sqrt, work_along
from newton_euler.chapters.examples import ch11
from newton_euler.dynamics import (
    EnergyError,
    conservative_force,
    find_potential,
    gravitation,
    gravitational_potential,
)
from tests.kinds import close, every_kind, numbers, small


def ball(kind):
    length, pin, v0, g = numbers(kind, "0.9", "0.6", 2, "9.81")
    return ch11.PendulumWithPin(length, pin, radians(60 + 0 * length), v0, g)


def test_example_11_8_in_numbers():
    b = ball("float")
    assert round(b.speed_at_pin(), 3) == 2.635
    assert b.speed_at_pin() ** 2 == pytest.approx(4 + 9.81 * 0.3, rel=1e-14)
    assert b.speed_at_bottom() ** 2 == pytest.approx(4 + 9.81 * 0.9, rel=1e-14)


@every_kind
def test_examples_11_8_and_11_12_by_the_works_of_two_phases_and_by_conservation_of_energy(kind):
    b = ball(kind)
    U = b.works(exact=kind == "sympy")
    drop = b.g * b.length * (1 - cos(b.angle)), -b.g * (b.length - b.pin)
    assert list(U.terms) == ["A to the bottom", "bottom to C"]
    assert close(tuple(U.terms.values()), drop, small(kind))
    bottom, pin = (sqrt(b.v0 * b.v0 + 2 * work) for work in (drop[0], sum(drop)))
    assert close((b.speed_at_bottom(), b.speed_at_pin()), (bottom, pin), small(kind))
    start = b.energy(b.length * cos(b.angle), b.v0).value
    for depth, speed in ((b.length, bottom), (b.pin, pin)):
        assert close(b.energy(depth, speed).value, start, small(kind))


def test_example_11_8_a_ball_that_does_not_reach_the_level_of_the_pin():
    low = ch11.PendulumWithPin(length=0.9, pin=0.3, angle=radians(45.0), v0=0.0, g=9.81)
    with pytest.raises(EnergyError, match="does not get there"):
        low.speed_at_pin()
    just = ch11.PendulumWithPin(length=1.0, pin=0.5, angle=math.acos(0.5), v0=1e-3, g=9.81)
    assert just.speed_at_pin() == pytest.approx(1e-3, rel=1e-8)


@every_kind
def test_eqn_11_21_to_11_23_the_attraction_along_the_radius_is_that_of_chapter_5(kind):
    K, M, m, x, y, z = numbers(kind, 2, 9, "0.5", 1, -2, 2)
    field, space = ch11.attraction_field(K, M, m)(x, y, z), Frame("space")
    r = sqrt(x * x + y * y + z * z)
    along = -(K * M * m / r**2) * space.vector(x, y, z).direction()
    F = gravitation(particle(m, space.point("P", x, y, z)), particle(M, space.origin, "star"), K)
    for other in (along, F, [-K * M * m * c / r**3 for c in (x, y, z)]):
        assert close(field, tuple(other), small(kind))


@every_kind
def test_eqn_11_24_its_potential_found_from_the_field(kind):
    """Found by integration from the base, where it is zero; the formula is zero far away."""
    K, M, m, x, y, z = numbers(kind, 2, 9, "0.5", 1, 2, 2)
    field, r = ch11.attraction_field(K, M, m), sqrt(x * x + y * y + z * z)
    far = gravitational_potential(M, m, r, K) - gravitational_potential(M, m, 5 + 0 * x, K)
    # SymPy cannot find the integral to an arbitrary place, but it can along a radius
    if kind == "sympy":
        found = -work_along(field, lambda s: (s, 0, 0), 5, r, exact=True).value
    else:
        found = find_potential(field, (3, 4, 0), box=((1, 2), (1, 2), (1, 2)))(x, y, z)
    assert close(found, far, small(kind, 10))


@every_kind
def test_eqn_11_25_the_slope_of_the_potential_is_the_force(kind):
    K, M, m, x, y, z = numbers(kind, 2, 9, "0.5", 1, -2, 2)
    V = lambda x, y, z: gravitational_potential(M, m, sqrt(x * x + y * y + z * z), K)
    F = conservative_force(V, Frame("space").point("P", x, y, z))
    assert close(F, ch11.attraction_field(K, M, m)(x, y, z), small(kind))


@every_kind
def test_example_11_10_speed_at_a_distance_and_escape(kind):
    """From r = 2, 3 m/s, K M = 14: at r = 4 v^2 = 9 - 7; from 2 the escape speed is sqrt(14)."""
    K, M, r = numbers(kind, "0.5", 28, 2)
    if kind != "array":
        assert close(ch11.speed_at_distance(2 * r, r, 3, K, M), sqrt(0 * r + 2), small(kind))
        assert close(ch11.escape_speed(r, K, M), sqrt(0 * r + 14), small(kind))
    far = ch11.speed_at_distance(10**12 * r, r, ch11.escape_speed(r, K, M), K, M)
    assert close(far, 0 * r, 1e-5 if kind in ("float", "array") else mp.mpf("1e-5"))


def test_example_11_10_a_small_drop_does_not_cancel():
    a, b, K, M = 6.4e6, 6.4e6 + 1e-9, 6.673e-11, 6e24
    with mp.workdps(40):
        true = mp.sqrt(2 * mp.mpf(K) * mp.mpf(M) * (1 / mp.mpf(a) - 1 / mp.mpf(b)))
    assert ch11.speed_at_distance(a, b, 0.0, K, M) == pytest.approx(float(true), rel=1e-14)

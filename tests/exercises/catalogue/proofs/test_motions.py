"""Explicit motions differentiated."""

from mpmath import mp, mpf

from exercises.catalogue.proofs.motions import (
    angular_acceleration,
    angular_velocity,
    rate,
    second_rate,
    spun,
)
from exercises.catalogue.proofs.vectors import cross, plus, rot, scaled, times, transposed
from tests.exercises.catalogue.proofs.near import near


def test_rates_of_numbers_vectors_and_matrices_are_good_to_thirty_digits():
    t = mpf("0.3")
    assert near(rate(mp.sin, t), mp.cos(t))
    assert near(second_rate(mp.sin, t), -mp.sin(t), "1e-29")
    assert near(rate(lambda t: [t**2, mp.exp(t)], t), [2 * t, mp.exp(t)])
    assert near(rate(lambda t: [[t, 1], [0, t**3]], t), [[1, 0], [0, 3 * t**2]])


def test_angular_velocity_and_acceleration_of_a_precessing_body_are_those_of_eqn_4_20_and_4_25():
    """Precession at p about z and spin at s about the body's x: p k + s i', and p s (k x i')."""
    p, s, t = mpf("0.8"), mpf(3), mpf("0.25")

    def body(t):
        return times(rot("z", p * t), rot("x", s * t))

    along = [mp.cos(p * t), mp.sin(p * t), 0]
    assert near(angular_velocity(body, t), plus([0, 0, p], scaled(s, along)))
    assert near(angular_acceleration(body, t), cross([0, 0, p], scaled(s, along)), "1e-29")


def test_spun_body_turns_right_handed_about_its_axis():
    axis, across = [mpf("0.6"), 0, mpf("0.8")], [0, 1, 0]
    assert near(angular_velocity(lambda t: spun(axis, across, 2 * t)), scaled(2, axis))
    first, second, third = transposed(spun(axis, across, 0))
    assert near(first, axis)
    assert near(second, across)
    assert near(third, cross(axis, across))


def test_spun_about_a_turning_axis_also_follows_the_axis():
    def body(t):
        e = [0, mp.cos(t / 2), mp.sin(t / 2)]
        return spun(e, [1, 0, 0], 3 * t)

    assert near(angular_velocity(body), [mpf(1) / 2, 3, 0])

"""Gradients of proofs against those known in closed form, to twenty digits."""

from mpmath import mp, mpf

from exercises.catalogue.proofs import gradient
from tests.exercises.catalogue.proofs.near import near


def test_the_gradient_of_the_distance_is_the_direction_away():
    place = [mpf(2), mpf(-3), mpf(6)]
    found = gradient(lambda x, y, z: mp.sqrt(x * x + y * y + z * z), place)
    assert near(found, [x / 7 for x in place], "1e-20")


def test_a_linear_function_has_its_coefficients_everywhere():
    found = gradient(lambda x, y, z: 6 * x + 9 * y - 6 * z, [mpf("0.3"), 0, mpf(-4)])
    assert near(found, [6, 9, -6], "1e-20")

"""Gradients of proofs against those known in closed form, to twenty digits."""

from mpmath import mp, mpf

from exercises.catalogue.proofs import DIGITS, gradient


def test_the_gradient_of_the_distance_is_the_direction_away():
    with mp.workdps(DIGITS):
        place = [mpf(2), mpf(-3), mpf(6)]
        found = gradient(lambda x, y, z: mp.sqrt(x * x + y * y + z * z), place)
        assert all(abs(a - b / 7) < mpf(10) ** -20 for a, b in zip(found, place, strict=True))


def test_a_linear_function_has_its_coefficients_everywhere():
    found = gradient(lambda x, y, z: 6 * x + 9 * y - 6 * z, [mpf("0.3"), 0, mpf(-4)])
    assert all(abs(a - b) < mpf(10) ** -20 for a, b in zip(found, (6, 9, -6), strict=True))

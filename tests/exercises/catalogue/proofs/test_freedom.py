"""Degrees of freedom as the rank of a motion."""

from mpmath import mp, mpf

from exercises.catalogue.proofs import freedom

ONE, TWO, THREE = mpf(1), mpf(2), mpf(3)


def test_what_moves_on_a_sphere_has_two_ways_to_move():
    def place(theta, phi):
        c = mp.cos(phi)
        return [c * mp.cos(theta), c * mp.sin(theta), mp.sin(phi)]

    assert freedom(place, ONE, mpf("0.3")) == 2
    assert freedom(place, ONE, mp.pi / 2) == 1  # at the pole theta moves nothing


def test_coordinates_that_move_the_same_count_once():
    assert freedom(lambda a, b: [a + b, 2 * a + 2 * b], ONE, TWO) == 1
    assert freedom(lambda a, b, c: [a + b, b + c, a + c], ONE, TWO, THREE) == 3
    assert freedom(lambda a, b: [TWO, THREE], ONE, TWO) == 0

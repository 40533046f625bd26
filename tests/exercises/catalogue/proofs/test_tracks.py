"""The speed of a particle on a smooth track."""

import pytest
from mpmath import mp, mpf

from exercises.catalogue.proofs import ProofError, speed_along


def weight(place):
    return [0, 0, mpf(-20)]  # of 2 kg, with g = 10


def dip(q):
    return [q, 0, mp.cos(q)]


def test_speed_depends_on_the_drop_alone():
    v = speed_along(2, weight, dip, 0, mp.pi / 2, speed=3)
    assert abs(v - mp.sqrt(29)) < mpf("1e-28")  # 3^2 + 2*10*1


def test_force_that_turns_with_the_place():
    def round_about(place):
        return [-place[1], place[0], 0]

    v = speed_along(mpf("0.5"), round_about, lambda q: [mp.cos(q), mp.sin(q), 0], 0, 2 * mp.pi)
    assert abs(v - mp.sqrt(8 * mp.pi)) < mpf("1e-28")  # there is no potential: work 2 pi a turn


def test_comes_to_rest_on_the_way_though_it_could_be_at_the_end():
    with pytest.raises(ProofError, match="comes to rest on the way"):
        speed_along(2, weight, lambda q: [q, 0, -mp.cos(q)], 0, 2 * mp.pi, speed=6)
    assert speed_along(2, weight, lambda q: [q, 0, -mp.cos(q)], 0, 2 * mp.pi, speed=7) > 6

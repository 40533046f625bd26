"""The speed of a particle on a smooth track."""

import pytest
from mpmath import mp, mpf

from exercises.catalogue.proofs import ProofError, speed_along


def weight(place):
    return [0, 0, mpf(-20)]  # of 2 kg, with g = 10


def test_comes_to_rest_on_the_way_though_it_could_be_at_the_end():
    with pytest.raises(ProofError, match="comes to rest on the way"):
        speed_along(2, weight, lambda q: [q, 0, -mp.cos(q)], 0, 2 * mp.pi, speed=6)
    assert speed_along(2, weight, lambda q: [q, 0, -mp.cos(q)], 0, 2 * mp.pi, speed=7) > 6

"""The worked examples of 5.2 and 5.3."""

import math

import numpy as np

from newton_euler.chapters.examples.ch05 import BurstingProjectile, hammer_on_film
from tests.kinds import close


def test_example_5_3_projectile_that_bursts():
    burst = BurstingProjectile(180.0, 240.0, 5.0, 9.0, 6.0, 179.0, math.pi / 4, 4000.0, 32.2)
    time, height = burst.top()
    assert (round(time, 2), round(height)) == (7.45, 894)
    assert round(burst.v_B().norm()) == 537
    assert close(burst.v_C(), (30, -570, -149), 1.0)
    assert abs(burst.v_C().norm() - 590) < 1
    assert close(burst.v_G(), (180, 0, 0), 1e-12)  # G goes on along the old path


def test_only_the_centre_of_mass_of_the_hammer_on_film_falls_freely():
    rows = hammer_on_film()

    def falls(share):  # of the way from head to end; the accelerations by second differences
        places = np.array([row[1:] for row in rows])
        marks = (1 - share) * places[:, :2] + share * places[:, 2:]
        return np.diff(marks, 2, axis=0) * 625

    off = {share: max(math.hypot(x, z + 9.81) for x, z in falls(share)) for share in (0, 0.25, 1)}
    assert off[0.25] < 4 * 625 * 0.0005  # each place is read to half a millimetre
    assert off[0] > 10
    assert off[1] > 30

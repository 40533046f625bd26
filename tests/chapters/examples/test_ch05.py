"""The worked example of 5.3."""

import math

from newton_euler.chapters.examples.ch05 import BurstingProjectile
from tests.kinds import close


def test_example_5_3_projectile_that_bursts():
    burst = BurstingProjectile(180.0, 240.0, 5.0, 9.0, 6.0, 179.0, math.pi / 4, 4000.0, 32.2)
    time, height = burst.top()
    assert (round(time, 2), round(height)) == (7.45, 894)
    assert round(burst.v_B().norm()) == 537
    assert close(burst.v_C(), (30, -570, -149), 1.0)
    assert abs(burst.v_C().norm() - 590) < 1
    assert close(burst.v_G(), (180, 0, 0), 1e-12)  # G goes on along the old path

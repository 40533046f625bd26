"""The worked examples of 5.2 and 5.3."""

import math

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
        marks = [
            ((1 - share) * x + share * u, (1 - share) * z + share * w) for _, x, z, u, w in rows
        ]
        return [
            ((a[0] - 2 * b[0] + c[0]) * 625, (a[1] - 2 * b[1] + c[1]) * 625)
            for a, b, c in zip(marks, marks[1:], marks[2:], strict=False)
        ]

    off = {share: max(math.hypot(x, z + 9.81) for x, z in falls(share)) for share in (0, 0.25, 1)}
    assert off[0.25] < 4 * 625 * 0.0005  # each place is read to half a millimetre
    assert off[0] > 10
    assert off[1] > 30

"""Mass points have the moments of inertia of the bodies that they stand for."""

import pytest
from mpmath import mp, mpf

from exercises.catalogue.proofs import along_x, ball, box, cone, disk, mean, raised, ring, shell


@pytest.mark.parametrize(
    ("points", "x_squared", "z_squared"),
    [
        (ball(2), mpf(4) / 5, mpf(4) / 5),
        (shell(2), mpf(4) / 3, mpf(4) / 3),
        (ring(2), 2, 0),
        (disk(2), 1, 0),
        (box(0, 2, 3), 0, mpf(9) / 12),
        (raised(disk(2), 3), 1, mpf(9) / 12),
        (cone(2, 3), mpf(3) / 5, mpf(27) / 5),  # 3 R^2/20, and 3 h^2/5 from the apex
        (along_x(cone(2, 3)), mpf(27) / 5, mpf(3) / 5),
    ],
)
def test_mean_squares_of_coordinates(points, x_squared, z_squared):
    with mp.workdps(50):
        found = mean(lambda r: [r[0] ** 2, r[2] ** 2, 1], points)
        assert all(
            abs(a - b) < 1e-15 for a, b in zip(found, (x_squared, z_squared, 1), strict=True)
        )

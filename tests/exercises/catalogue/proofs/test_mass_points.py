"""Sums over mass points against closed forms."""

from fractions import Fraction
from itertools import product

import pytest
from mpmath import mp, mpf

from exercises.catalogue.proofs import ball, box, disk, mean, plus, ring, rot, shell, times

BODIES = {
    "rod": lambda: box(0, 0, 5),
    "plate": lambda: box(2, 3, 0),
    "box": lambda: box(2, 3, 5),
    "ring": lambda: ring(mpf(2)),
    "disk": lambda: disk(mpf(2)),
    "shell": lambda: shell(mpf(2)),
    "ball": lambda: ball(mpf(2)),
}
# means of x x, y y, z z
SQUARES = {
    "rod": (0, 0, Fraction(25, 12)),
    "plate": (Fraction(4, 12), Fraction(9, 12), 0),
    "box": (Fraction(4, 12), Fraction(9, 12), Fraction(25, 12)),
    "ring": (2, 2, 0),
    "disk": (1, 1, 0),
    "shell": (Fraction(4, 3),) * 3,
    "ball": (Fraction(4, 5),) * 3,
}
TINY = mpf(10) ** -45


@pytest.mark.parametrize("name", BODIES)
def test_mass_points_have_the_mass_centre_and_second_moments_of_the_body(name):
    points = BODIES[name]()
    exact = [mpf(x.numerator) / x.denominator for x in SQUARES[name]]
    assert abs(mean(lambda r: 1, points) - 1) < TINY
    assert max(map(abs, mean(lambda r: r, points))) < TINY
    found = mean(lambda r: [[x * y for y in r] for x in r], points)
    for n, m in product(range(3), repeat=2):
        assert abs(found[n][m] - (exact[n] if n == m else 0)) < TINY


@pytest.mark.parametrize("name", ["disk", "shell", "ball", "box"])
def test_polynomials_up_to_twice_the_order_are_exact(name):
    def f(r):
        x, y, z = r
        return x**7 + x**4 * y**2 + x**2 * y**2 * z**2 + (x + y + z) ** 5 * 7 + z**6

    turned = rot([1, 2, 3], mpf("0.7"))
    round_ones = {"disk": disk, "shell": shell, "ball": ball}
    finer = box(2, 3, 5, 9) if name == "box" else round_ones[name](mpf(2), 9)
    a, b = (
        mean(lambda r: f(times(turned, r) if name != "box" else r), points)
        for points in (BODIES[name](), finer)
    )
    assert abs(a - b) < mpf(10) ** -40


def test_a_ball_attracts_like_its_mass_at_the_centre():
    def pull(r):
        away = plus([0, 0, -4], r)
        return away[2] / mp.sqrt(sum(x * x for x in away)) ** 3

    assert abs(mean(pull, ball(mpf(1), 12)) + mpf(1) / 16) < mpf(10) ** -12

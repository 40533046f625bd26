"""The angular momentum of mass points that move."""

from mpmath import mp, mpf

from exercises.proofs import DIGITS, angular_momentum, cross, minus, plus, rate, rot, scaled, times

MASSES = [mpf(2), mpf(3)]
TINY = mpf(10) ** -25


def size_of_gap(a, b):
    return max(abs(x - y) for x, y in zip(a, b, strict=True))


def test_its_rate_is_the_moment_of_the_weights_of_thrown_particles():
    g, about = [0, 0, mpf(-10)], [mpf(1), mpf(2), mpf(3)]
    starts = ([1, 0, 0], [4, 1, 5]), ([0, 2, 1], [-3, 2, 7])

    def places(t):
        return [plus(r, scaled(t, v), scaled(t * t / 2, g)) for r, v in starts]

    with mp.workdps(DIGITS):
        t = mpf(1) / 3
        moments = [cross(minus(r, about), scaled(m, g)) for m, r in zip(MASSES, places(t),
                                                                       strict=True)]  # fmt: skip
        found = rate(angular_momentum(MASSES, places, about), t)
        assert size_of_gap(found, plus(*moments)) < TINY


def test_of_two_particles_on_a_turning_line_it_has_the_product_of_inertia():
    with mp.workdps(DIGITS):
        line = [[2, 1, 0], [-1, 4, 0]]
        H = angular_momentum(MASSES, lambda t: [times(rot("x", 5 * t), r) for r in line])(0)
        # omega (sum m y y, -sum m x y, 0)
        assert size_of_gap(H, [5 * (2 * 1 + 3 * 16), -5 * (2 * 2 - 3 * 4), 0]) < TINY

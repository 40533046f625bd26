"""Mass points in motion against bodies whose forces and energies are known in closed form."""

from functools import partial

from mpmath import mp, mpf

from exercises.catalogue.proofs import (
    angular_momentum,
    box,
    cross,
    disk,
    force_needed,
    kinetic_energy,
    let_go,
    moment_needed,
    plus,
    rate,
    rot,
    scaled,
    times,
)
from tests.exercises.catalogue.proofs.near import near as to_digits

near = partial(to_digits, tolerance="1e-20")


def spinning_rod(t):
    """3 m long, turning about z through its end, by t + 2 t^2."""
    return [
        (u, times(rot("z", t + 2 * t * t), plus(r, [mpf(3) / 2, 0, 0])))
        for u, r in box(3, 0, 0, order=2)
    ]


def test_a_rod_turning_about_its_end_has_the_momenta_and_energy_of_the_books():
    m = mpf(4)
    assert near(force_needed(m, spinning_rod), [-m * 3 / 2, m * 3 / 2 * 4, 0])
    assert near(moment_needed(m, spinning_rod), [0, 0, m * 9 / 3 * 4])
    assert near(moment_needed(m, spinning_rod, [mpf(3) / 2, 0, 0]), [0, 0, m * 9 / 12 * 4])
    assert near([kinetic_energy(m, spinning_rod)], [m * 9 / 3 / 2])


def test_a_disk_let_go_on_a_slope_gets_two_thirds_of_the_acceleration_of_a_block():
    slope, radius, g = mpf("0.3"), mpf(2), mpf(10)

    def energy(q, t):
        def rolled(t):
            place = [q(t) * mp.cos(slope), -q(t) * mp.sin(slope), 0]
            return [(u, plus(place, times(rot("z", -q(t) / radius), r))) for u, r in disk(radius)]

        return kinetic_energy(5, rolled, t) - 5 * g * q(t) * mp.sin(slope)

    assert near([let_go(energy)], [2 * g * mp.sin(slope) / 3])


def test_the_rate_of_the_angular_momentum_is_the_moment_of_the_weights_of_thrown_particles():
    g, about = [0, 0, mpf(-10)], [mpf(1), mpf(2), mpf(3)]
    starts = (mpf(2), [1, 0, 0], [4, 1, 5]), (mpf(3), [0, 2, 1], [-3, 2, 7])

    def thrown(t):
        return [(m, plus(r, scaled(t, v), scaled(t * t / 2, g))) for m, r, v in starts]

    t = mpf(1) / 3
    arms = [(m, [x - y for x, y in zip(r, about, strict=True)]) for m, r in thrown(t)]
    expected = plus(*(cross(arm, scaled(m, g)) for m, arm in arms))
    assert near(rate(lambda t: angular_momentum(1, thrown, about, t), t), expected)


def test_the_angular_momentum_of_particles_on_a_turning_line_has_its_product_of_inertia():
    line = [(mpf(2), [2, 1, 0]), (mpf(3), [-1, 4, 0])]

    def turning(t):
        return [(m, times(rot("x", 5 * t), r)) for m, r in line]

    # omega (sum m y y, -sum m x y, 0)
    assert near(angular_momentum(1, turning), [5 * (2 * 1 + 3 * 16), -5 * (2 * 2 - 3 * 4), 0])

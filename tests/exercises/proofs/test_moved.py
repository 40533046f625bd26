"""Mass points in motion against bodies whose forces and energies are known in closed form."""

import pytest
from mpmath import mp, mpf

from exercises.proofs import (
    DIGITS,
    box,
    disk,
    force_needed,
    kinetic_energy,
    let_go,
    moment_needed,
    plus,
    rot,
    times,
)


@pytest.fixture(autouse=True)
def fifty_digits():
    with mp.workdps(DIGITS):
        yield


def near(found, expected):
    return all(abs(a - b) < mpf(10) ** -20 for a, b in zip(found, expected, strict=True))


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

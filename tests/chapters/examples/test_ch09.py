"""Chapter 9, (9.1)-(9.6): the disks on a shaft, against the printed sums."""

import math

import pytest

from newton_euler import cos, sin
from newton_euler.chapters.examples.ch09 import bent_disk, off_centre_disk
from tests.kinds import close, every_kind, numbers, small

# -- off-centre disk (9.1)-(9.3)


def off_centre(kind):
    m, _, d, a, b, psi, omega = values = numbers(kind, 2, "0.1", "0.03", "0.2", "0.3", "0.7", 5)
    return off_centre_disk(*values), m * d * omega * omega, a, b, psi


@every_kind
def test_eqn_9_1_both_bearings_together_give_the_mass_centre_its_acceleration(kind):
    rotor, load, _, _, psi = off_centre(kind)
    found = rotor.reactions()
    total = (found.A + found.B).expressed_in(rotor.ground)
    assert close(total, (0, -load * cos(psi), -load * sin(psi)), small(kind, 0.1))
    assert close(found.axial, 0, 0)


@every_kind
def test_eqn_9_2_their_moment_about_the_disk_vanishes(kind):
    rotor, _, a, b, _ = off_centre(kind)
    found = rotor.reactions()
    A, B = (v.expressed_in(rotor.ground) for v in (found.A, found.B))
    assert close((found.moment, a * A.z - b * B.z, b * B.y - a * A.y), (0, 0, 0), small(kind, 0.1))


@every_kind
def test_eqn_9_3_reactions_of_an_off_centre_disk(kind):
    rotor, load, a, b, psi = off_centre(kind)
    found = rotor.reactions()
    length = a + b
    assert close(
        found.A.expressed_in(rotor.ground),
        (0, -load * b / length * cos(psi), -load * b / length * sin(psi)),
        small(kind, 0.1),
    )
    assert close(
        found.B.expressed_in(rotor.ground),
        (0, -load * a / length * cos(psi), -load * a / length * sin(psi)),
        small(kind, 0.1),
    )
    # constant in the shaft: it turns with it
    assert close(found.A, (0, -load * b / length, 0), small(kind, 0.1))


def test_an_off_centre_disk_with_dead_weight_needs_a_moment_at_constant_rate():
    rotor = off_centre_disk(2.0, 0.1, 0.03, 0.2, 0.3, 0.7, 5.0)
    found = rotor.reactions(gravity=-9.81 * rotor.ground.k)
    assert found.moment == pytest.approx(2.0 * 9.81 * 0.03 * math.cos(0.7), rel=1e-14)
    assert found.A.terms["weight"].components(rotor.ground) == pytest.approx(
        (0, 0, 2.0 * 9.81 * 0.3 / 0.5), abs=1e-14
    )


# -- bent disk (9.4)-(9.6)


def bent(kind):
    m, r, beta, a, b, psi, omega = values = numbers(kind, 4, "0.5", "0.6", "0.2", "0.3", "0.7", 3)
    return bent_disk(*values), m * r * r / 4 * omega * omega * sin(2 * beta), a, b, psi


@every_kind
def test_eqn_9_4_the_bearings_of_a_bent_disk_form_a_couple(kind):
    found = bent(kind)[0].reactions()
    assert close(found.A + found.B, (0, 0, 0), small(kind, 0.1))
    assert close(found.axial, 0, small(kind, 0.1))


@every_kind
def test_eqn_9_5_the_couple_turns_the_angular_momentum(kind):
    rotor, load, a, b, psi = bent(kind)
    found = rotor.reactions()
    A, B = (v.expressed_in(rotor.ground) for v in (found.A, found.B))
    expected = (0, -load / 2 * sin(psi), load / 2 * cos(psi))
    assert close((found.moment, a * A.z - b * B.z, b * B.y - a * A.y), expected, small(kind, 0.1))


@every_kind
def test_eqn_9_6_reactions_of_a_bent_disk(kind):
    rotor, load, a, b, psi = bent(kind)
    found = rotor.reactions()
    A = found.A.expressed_in(rotor.ground)
    assert close(
        A, (0, -load / (2 * (a + b)) * cos(psi), -load / (2 * (a + b)) * sin(psi)), small(kind, 0.1)
    )
    assert close(found.B.expressed_in(rotor.ground), -A, small(kind, 0.1))


@pytest.mark.parametrize("beta", [0.0, math.pi / 2])
def test_a_disk_square_or_parallel_to_the_shaft_has_no_reactions(beta):
    found = bent_disk(4.0, 0.5, beta, 0.2, 0.3, 0.7, 3.0).reactions()
    assert found.A.norm() < 1e-15 * 4.0 * 0.25 * 9 / 0.5

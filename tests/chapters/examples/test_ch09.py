"""Chapter 9, (9.1)-(9.6): the disks on a shaft, against the printed sums."""

import math

import pytest

from newton_euler import cos, sin
from newton_euler.chapters.examples.ch09 import bent_disk, off_centre_disk
from tests.kinds import close, every_kind, numbers, small


def off_centre(kind):
    m, _, d, a, b, psi, omega = values = numbers(kind, 2, "0.1", "0.03", "0.2", "0.3", "0.7", 5)
    return off_centre_disk(*values), m * d * omega * omega, a, b, psi


@every_kind
def test_eqn_9_1_to_9_3_reactions_of_an_off_centre_disk(kind):
    rotor, load, a, b, psi = off_centre(kind)
    found, tiny = rotor.reactions(), small(kind, 0.1)
    A, B = (v.expressed_in(rotor.ground) for v in (found.A, found.B))
    outward = rotor.ground.vector(0, cos(psi), sin(psi))
    assert close(A + B, -load * outward, tiny)  # 9.1
    assert close((found.axial, found.moment), (0, 0), tiny)  # 9.2
    assert close((a * A.z - b * B.z, b * B.y - a * A.y), (0, 0), tiny)
    assert close(A, -load * b / (a + b) * outward, tiny)  # 9.3
    assert close(B, -load * a / (a + b) * outward, tiny)
    assert close(found.A, (0, -load * b / (a + b), 0), tiny)  # it turns with the shaft


def test_an_off_centre_disk_with_dead_weight_needs_a_moment_at_constant_rate():
    rotor = off_centre_disk(2.0, 0.1, 0.03, 0.2, 0.3, 0.7, 5.0)
    found = rotor.reactions(gravity=-9.81 * rotor.ground.k)
    assert found.moment == pytest.approx(2.0 * 9.81 * 0.03 * math.cos(0.7), rel=1e-14)
    weight = found.A.terms["weight"].components(rotor.ground)
    assert weight == pytest.approx((0, 0, 2.0 * 9.81 * 0.3 / 0.5), abs=1e-14)


def bent(kind):
    m, r, beta, a, b, psi, omega = values = numbers(kind, 4, "0.5", "0.6", "0.2", "0.3", "0.7", 3)
    return bent_disk(*values), m * r * r / 4 * omega * omega * sin(2 * beta), a, b, psi


@every_kind
def test_eqn_9_4_to_9_6_reactions_of_a_bent_disk(kind):
    rotor, load, a, b, psi = bent(kind)
    found, tiny = rotor.reactions(), small(kind, 0.1)
    A, B = (v.expressed_in(rotor.ground) for v in (found.A, found.B))
    assert close(A + B, (0, 0, 0), tiny)  # 9.4: a couple
    assert close((found.axial, found.moment), (0, 0), tiny)
    # 9.5: it turns the angular momentum
    couple = (-load / 2 * sin(psi), load / 2 * cos(psi))
    assert close((a * A.z - b * B.z, b * B.y - a * A.y), couple, tiny)
    arm = 2 * (a + b)
    assert close(A, (0, -load / arm * cos(psi), -load / arm * sin(psi)), tiny)  # 9.6


@pytest.mark.parametrize("beta", [0.0, math.pi / 2])
def test_a_disk_square_or_parallel_to_the_shaft_has_no_reactions(beta):
    found = bent_disk(4.0, 0.5, beta, 0.2, 0.3, 0.7, 3.0).reactions()
    assert found.A.norm() < 1e-15 * 4.0 * 0.25 * 9 / 0.5

"""Directions at a place, against their angles."""

from mpmath import mp, mpf

from exercises.catalogue import proofs
from exercises.catalogue.proofs import cylindrical_axes, elevation, rot, spherical_axes
from tests.exercises.catalogue.proofs.near import near


def test_axes_at_a_place_are_those_that_are_turned_by_its_angles():
    theta, phi = mpf("2.1"), mpf("-0.4")
    r = [mp.cos(theta) * mp.cos(phi), mp.sin(theta) * mp.cos(phi), mp.sin(phi)]
    turned = proofs.transposed(rot("z", theta))
    assert near(cylindrical_axes([7 * x for x in r]), turned, "1e-45")
    up = rot(cylindrical_axes(r)[1], -phi)  # about e_theta, so that e_r goes up
    raised = [proofs.times(up, e) for e in turned]
    assert near(spherical_axes([7 * x for x in r]), raised, "1e-45")
    assert near(elevation([7 * x for x in r]), phi, "1e-45")

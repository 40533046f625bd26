"""Directions at a place, against their angles."""

from mpmath import mp, mpf

from exercises.catalogue.proofs import (
    DIGITS,
    cylindrical_axes,
    elevation,
    rot,
    spherical_axes,
    transposed,
)


def close(a, b):
    return all(
        abs(x - y) < mpf(10) ** -45
        for p, q in zip(a, b, strict=True)
        for x, y in zip(p, q, strict=True)
    )


def test_axes_at_a_place_are_those_that_are_turned_by_its_angles():
    with mp.workdps(DIGITS):
        theta, phi = mpf("2.1"), mpf("-0.4")
        r = [mp.cos(theta) * mp.cos(phi), mp.sin(theta) * mp.cos(phi), mp.sin(phi)]
        turned = transposed(rot("z", theta))
        assert close(cylindrical_axes([7 * x for x in r]), turned)
        up = rot(cylindrical_axes(r)[1], -phi)  # about e_theta, so that e_r goes up
        raised = [[sum(row[n] * e[n] for n in range(3)) for row in up] for e in turned]
        assert close(spherical_axes([7 * x for x in r]), raised)
        assert abs(elevation([7 * x for x in r]) - phi) < mpf(10) ** -45

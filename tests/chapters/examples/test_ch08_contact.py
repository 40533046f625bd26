"""A body that rolls or slips on a moving surface (8.6)."""

import numpy as np
import pytest
import sympy
from hypothesis import given, settings
from hypothesis.strategies import floats

from newton_euler.chapters.examples import ch08 as rolling_contact
from tests.kinds import every_kind, numbers, small
from tests.tumbling import close


@every_kind
def test_a_cylinder_on_an_accelerated_slab_rolls_if_the_friction_suffices(kind):
    """Problem 8/8: mu N >= m n g/3 lets it roll, with alpha = 2 n g/(3 r)."""
    m, r, g, n = numbers(kind, 2, "1/2", "9.81", 2)
    s = rolling_contact.rolling(m, r, m * r * r / 2, surface=n * g)
    known = n * g / 3, 2 * n * g / (3 * r), m * n * g / 3
    assert close((s.a, s.alpha, s.friction), known, small(kind, 100))
    low, high = numbers(kind, "1/2", "3/4")
    for mu, rolls in ((low, False), (high, True)):
        c = rolling_contact.contact(m, r, m * r * r / 2, m * g, mu, surface=n * g)
        if kind == "array":
            continue  # there the three slabs differ
        assert bool(c.rolls) is rolls
        assert close(c.alpha, 2 * n * g / (3 * r) if rolls else 2 * mu * g / r, small(kind, 100))


def test_many_contacts_at_once_choose_their_regime_one_by_one():
    mu = np.array([0.05, 0.5, 0.05])
    force = np.array([6.0, 6.0, -6.0])
    c = rolling_contact.contact(2.0, 0.5, 0.25, 19.62, mu, force=force)
    for n in range(3):
        one = rolling_contact.contact(2.0, 0.5, 0.25, 19.62, float(mu[n]), force=float(force[n]))
        assert bool(c.rolls[n]) == one.rolls
        assert close((c.a[n], c.alpha[n], c.friction[n]), (one.a, one.alpha, one.friction), 1e-13)
    assert c.rolls.tolist() == [False, True, False]
    assert np.all(c.friction * force < 0)


@settings(max_examples=60)
@given(floats(-20, 20), floats(-5, 5), floats(-3, 3), floats(0.01, 1.5), floats(0.5, 1.0))
def test_friction_obeys_coulomb_and_newtons_laws_in_both_regimes(force, moment, surface, mu, ratio):
    m, r, I, N = 2.0, 0.5, 0.25, 19.62
    c = rolling_contact.contact(m, r, I, N, mu, mu * ratio, force, moment, surface)
    assert abs(m * c.a - force - c.friction) < 1e-12
    assert abs(I * c.alpha - moment - r * c.friction) < 1e-12
    starts = c.a + r * c.alpha - surface
    if c.rolls:
        assert abs(starts) < 1e-11
        assert abs(c.friction) <= mu * N
    else:
        assert abs(c.friction) == pytest.approx(mu * ratio * N)
        assert starts * c.friction <= 0  # the friction opposes the slip that begins


def test_a_body_that_slips_goes_on_slipping():
    for slip, sign in ((2.0, -1), (-2.0, 1)):
        c = rolling_contact.contact(2.0, 0.5, 0.25, 19.62, mu=0.5, mu_kinetic=0.4, slip=slip)
        assert not c.rolls
        assert c.friction == pytest.approx(sign * 0.4 * 19.62)


def test_a_contact_says_what_it_cannot_decide():
    words = "the surface would have to pull, so the body has left it"
    with pytest.raises(rolling_contact.ContactError, match=words):
        rolling_contact.contact(2.0, 0.5, 0.25, -1.0, 0.5)
    mu = sympy.Symbol("mu")
    with pytest.raises(rolling_contact.ContactError, match="which regime holds depends on values"):
        rolling_contact.contact(2.0, 0.5, 0.25, 19.62, mu)

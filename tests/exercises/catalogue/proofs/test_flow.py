"""Motions that forces cause: to 20 digits, at any step, up to the first event, in floats too."""

import pytest
from mpmath import mp, mpf

from exercises.catalogue.proofs import ProofError, after, flow, until


def swing(s):
    """A pendulum with g = l = 1."""
    return [s[1], -mp.sin(s[0])]


def round_centre(s):
    """An orbit, with the constant of attraction 1."""
    x, y, u, v = s
    r3 = (x * x + y * y) ** 1.5 if isinstance(x, float) else mp.hypot(x, y) ** 3
    return [u, v, -x / r3, -y / r3]


@pytest.mark.parametrize("step", ["0.01", "1", "7"])
def test_a_quarter_of_a_large_swing_takes_the_elliptic_integral(step):
    t, (angle, speed) = until(swing, [mpf(2), mpf(0)], lambda s: s[0], mpf(step) / 2)
    assert abs(t - mp.ellipk(mp.sin(1) ** 2)) < mpf(10) ** -22
    assert abs(angle) < mpf(10) ** -30
    assert abs(speed + mp.sqrt(2 * (1 - mp.cos(2)))) < mpf(10) ** -22


def test_floats_are_fast_and_have_ten_digits():
    start = [1.0, 0.0, 0.0, 1.5**0.5]
    t, (x, *_) = until(round_centre, start, lambda s: s[0] * s[2] + s[1] * s[3], 0.25)
    assert isinstance(x, float)
    assert t == pytest.approx(float(mp.pi * mp.sqrt(8)), rel=1e-10)
    assert x == pytest.approx(-3, rel=1e-10)


@pytest.mark.parametrize("time", ["-3", "0.1", "6"])
def test_after_a_time_forward_or_back(time):
    q, u = after(lambda s: [s[1], -s[0]], [mpf(1), mpf(0)], mpf(time))
    assert abs(q - mp.cos(mpf(time))) < mpf(10) ** -22
    assert abs(u + mp.sin(mpf(time))) < mpf(10) ** -22


def test_without_an_event_it_ends():
    with pytest.raises(ProofError, match="no event"):
        until(lambda s: [mpf(1)], [mpf(1)], lambda s: s[0], mpf(1))


def test_what_runs_into_a_centre_of_attraction_ends(monkeypatch):
    monkeypatch.setattr(flow, "STEPS", 20)
    with pytest.raises(ProofError):
        until(lambda s: [s[1], -1 / s[0] ** 2], [mpf(1), mpf(0)], lambda s: s[0] + 9, mpf(1) / 4)

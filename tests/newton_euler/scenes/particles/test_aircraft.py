"""Aircraft in a vertical plane and in space (6.3, 6.12)."""

import math

import pytest

from newton_euler import Frame, cos, moving, sin
from newton_euler.chapters.examples.ch06 import flight_forces
from newton_euler.scenes.particles.aircraft import flight, vertical_flight
from tests.explicit import by_scipy
from tests.kinds import close, every_kind, numbers, small

STATE = ("50", "0.4", "0.3", "1", "2", "300")
FORCES = ("1200", "9.81", "3000", "1000", "14000", "0.35")


@every_kind
def test_section_6_3_flight_in_a_vertical_plane(kind):
    """The book's four equations, and, for zero bank, those of 6.12."""
    m, g, T, D, L, _ = numbers(kind, *FORCES)
    v, chi, gamma, x, _, h = numbers(kind, *STATE)
    rates, W = vertical_flight(m, g, T, D, L).derivative((v, gamma, x, h)), m * g
    along, across = (T - D - W * sin(gamma)) / m, (L - W * cos(gamma)) / (m * v)
    assert close(rates, (along, across, v * cos(gamma), v * sin(gamma)), small(kind, 10))
    in_space = flight(m, g, T, D, L).derivative((v, 0 * chi, gamma, 0 * x, x, h))
    assert close([in_space[n] for n in (0, 2, 4, 5)], rates, small(kind, 0.1))
    assert close(in_space[1], 0, 0)


@every_kind
def test_section_6_12_forces_from_the_motion(kind):
    """The motion from the printed equations gives the forces back, by way of five frames."""
    m, g, T, D, L, bank = numbers(kind, *FORCES)
    state = numbers(kind, *STATE)
    rates = flight(m, g, T, D, L, bank).derivative(state)
    v, chi, gamma = (moving(q, rate) for q, rate in zip(state[:3], rates[:3], strict=True))
    assert close(flight_forces(m, g, v, gamma, chi), (T - D, L, bank), small(kind, 10000))
    north = Frame("north")
    path = north.rotate("3", "-z", chi).rotate("4", "-y", gamma)
    a = path.vector(v, 0, 0).rate(north)
    printed = v.rate, -v.value * chi.rate * cos(gamma.value), v.value * gamma.rate
    assert close(a, printed, small(kind, 10))


def test_a_force_may_be_a_law_of_speed_and_time():
    """Drag k v^2 and no thrust: in level flight, held up by lift, 1/v grows by k t/m."""
    k, m, g, v0 = 0.5, 1000.0, 9.81, 60.0
    model = vertical_flight(m, g, drag=lambda s, p, t: k * s.v**2, lift=lambda s, p, t: p.m * p.g)
    run = by_scipy(model, (v0, 0.0, 0.0, 100.0), 30)
    assert 1 / run.y[0, -1] == pytest.approx(1 / v0 + k / m * 30, rel=1e-10)
    flown = m / k * math.log(1 + k * v0 * 30 / m)
    assert run.y[1:, -1] == pytest.approx([0, flown, 100], rel=1e-9, abs=1e-9)
    assert not model.invariants


def test_a_level_turn_by_integration_is_a_circle():
    m, g, v, bank = 1000.0, 9.81, 60.0, 0.5
    model = flight(m, g, lift=m * g / math.cos(bank), bank=bank)
    period = 2 * math.pi * v / (g * math.tan(bank))
    run = by_scipy(model, (v, 0.2, 0.0, 10.0, 20.0, 500.0), period)
    assert run.y[:, -1] == pytest.approx([v, 0.2 + 2 * math.pi, 0, 10, 20, 500], abs=1e-6)

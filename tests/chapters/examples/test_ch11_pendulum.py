"""The physical pendulum (11.17)."""

import math

import numpy as np
import pytest

from newton_euler import Body, Frame, at, cos, kinetic_energy, moving
from newton_euler.chapters.examples.ch11 import pendulum_energy, swing_rate
from newton_euler.dynamics import EnergyError, kinetic_energy_about
from newton_euler.scenes.planar.pendulum import physical_pendulum
from tests.explicit import integrated
from tests.kinds import close, every_kind, numbers, small


@every_kind
def test_example_11_17_about_the_mass_centre_and_about_the_pivot(kind):
    m, I, l, g, theta, omega = numbers(kind, 2, "0.5", "0.75", "9.81", "0.6", 3)
    E = pendulum_energy(m, I, l, g, theta, omega)
    assert close(E.value, (I + m * l * l) * omega * omega / 2 - m * g * l * cos(theta), small(kind))
    ground = Frame("ground")  # x down, z along the axis
    frame = ground.rotate("body", "z", moving(theta, omega))
    body = Body("body", m, frame.point("G", l, 0, 0), (I, I, I))
    translation, rotation, weight = (E.terms[n] for n in ("translation", "rotation", "weight"))
    about = kinetic_energy_about(body, ground.origin, ground).value
    assert close(about, translation + rotation, small(kind))
    assert close(kinetic_energy(body, ground).terms["translation"], translation, small(kind))
    assert close(-m * g * body.centre.position(ground).x, weight, small(kind))


@every_kind
def test_example_11_17_its_equation_of_motion_follows_from_the_energy(kind):
    """dE/dt = 0 with theta' = omega, omega' from the Model."""
    m, I, l, g, theta, omega = numbers(kind, 2, "0.5", "0.75", "9.81", "0.6", 3)
    model = physical_pendulum(m, I, l, g)
    rates = model.derivative((theta, omega))
    along = lambda t: pendulum_energy(m, I, l, g, theta + omega * t, omega + rates[1] * t).value
    assert close(at(along, 0 * m).rate, 0, small(kind, 10))


def test_example_11_17_along_the_motion_and_how_far_it_swings():
    model = physical_pendulum(2.0, 0.5, 0.75, 9.81)
    states = integrated(model, (1.2, 0.0), 2.0)
    E = [model.invariant("energy", states(t)) for t in np.linspace(0, 2, 9)]
    assert np.ptp(E) < 1e-9 * abs(E[0])
    for t in (0.3, 0.9, 1.4):
        s = states(t)
        rate = swing_rate(2.0, 0.5, 0.75, 9.81, s["theta"], 1.2)
        assert rate == pytest.approx(abs(s["omega"]), rel=1e-8)
    with pytest.raises(EnergyError, match="does not get there"):
        swing_rate(2.0, 0.5, 0.75, 9.81, 1.3, 1.2)


def test_example_11_17_near_the_turning_point_nothing_cancels():
    near, step = swing_rate(1.0, 0.0, 1.0, 9.81, 1.0 - 1e-12, 1.0), 1.0 - (1.0 - 1e-12)
    assert near == pytest.approx(math.sqrt(2 * 9.81 * step * math.sin(1.0)), rel=1e-11)

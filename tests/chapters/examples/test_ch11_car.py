"""A car of given power over hills (11.19)."""

import math

import pytest
from scipy.integrate import solve_ivp

from newton_euler import Dimension, at, sin
from newton_euler.chapters.examples.ch11 import Car
from newton_euler.dynamics.energy import audit, plane_kinetic_energy
from newton_euler.motion.model import ModelError
from tests.explicit import integrated
from tests.kinds import close, every_kind, numbers, small


def car(kind):
    m, wheel, k, r, g = numbers(kind, 1200, 20, "0.25", "0.3", "9.81")
    return Car(m, wheel, k, r, lambda v: v * v / 2, g)


@every_kind
def test_example_11_19_power_of_the_engine(kind):
    c = car(kind)
    v, a, theta = numbers(kind, 20, "0.8", "0.1")
    P = c.powers(v, a, theta)
    wheels = 4 * c.wheel_mass * (c.gyration / c.radius) ** 2
    expected = (c.m + wheels) * v * a + c.m * c.g * v * sin(theta) + v**3 / 2
    assert close(P.value, expected, small(kind, 10000))
    assert list(P.terms) == ["accelerate", "wheels", "climb", "air"]
    assert close(c.acceleration(P.value, v, theta), a, 10 * small(kind))


@every_kind
def test_example_11_19_it_is_the_rate_of_the_energy(kind):
    """v = 3 + 2 t up a slope: d(T + V)/dt of the car and four rolling wheels, and the drag."""
    c = car(kind)
    t, theta = numbers(kind, 4, "0.1")
    v = lambda t: 3 + 2 * t
    height = lambda t: (3 * t + t * t) * sin(theta)
    rate = at(lambda t: c.kinetic_energy(v(t)).value + c.m * c.g * height(t), t).rate
    assert close(c.power(v(t), 2 + 0 * t, theta), rate + v(t) ** 3 / 2, small(kind, 10000))
    I, omega = c.wheel_mass * c.gyration**2, v(t) / c.radius
    wheel = plane_kinetic_energy(c.wheel_mass, v(t), I, omega).value
    whole = (c.m - 4 * c.wheel_mass) * v(t) ** 2 / 2 + 4 * wheel
    assert close(c.kinetic_energy(v(t)).value, whole, small(kind, 10000))


def test_example_11_19_the_books_of_a_drive_uphill_close():
    c = car("float")
    model = c.model(power=4e4, slope=lambda s, p, t: 0.05 + 0.02 * sin(s.s / 50))
    states = integrated(model, (0.0, 10.0), 5.0)
    climb = lambda x, y: [math.sin(0.05 + 0.02 * math.sin(x / 50))]
    height = lambda s: solve_ivp(climb, (0, s), [0.0], rtol=1e-12, atol=1e-12).y[0, -1]
    powers = {"engine": lambda t: 4e4, "air": lambda t: -(states(t)["v"] ** 3) / 2}
    weight = {"weight": lambda t: c.m * c.g * height(states(t)["s"])}
    energy = lambda t: c.kinetic_energy(states(t)["v"])
    books = audit(energy, 0.0, 5.0, weight, powers, rtol=1e-8)
    assert books.balances(rtol=1e-8)
    assert books.works["engine"] == pytest.approx(2e5)
    assert books.heat("air") > 0
    no_wheels = audit(lambda t: energy(t).without("wheels"), 0.0, 5.0, weight, powers, rtol=1e-8)
    assert not no_wheels.balances(rtol=1e-3)


def test_example_11_19_units_and_a_car_at_rest():
    MASS, LENGTH, TIME = Dimension(1, 0, 0), Dimension(0, 1, 0), Dimension(0, 0, 1)
    c = Car(MASS, MASS, LENGTH, LENGTH, lambda v: MASS * v * v / LENGTH, LENGTH / TIME**2)
    assert c.power(LENGTH / TIME, LENGTH / TIME**2, Dimension()) == MASS * LENGTH**2 / TIME**3
    with pytest.raises((ModelError, ZeroDivisionError)):
        car("float").model(1000.0, 0.0).derivative((0.0, 0))

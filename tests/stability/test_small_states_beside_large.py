"""A small state beside one of 6.4e6 (a place on the Earth) or 1.5e11 (an orbit): the error of each
is relative to its own size.
"""

import math

import numpy as np
import pytest

from newton_euler import Model, sin, sqrt
from newton_euler.motion import integrate, prepare

EARTH = 3.986004418e14


def spring_at(place):
    """A vibration of 1e-3 m whose model also has a place, and travels at 30 km/s."""
    return Model(
        "vibration in a vehicle",
        {"k": 9.0},
        ("z", "x", "u"),
        lambda s, p, t: (3e4 + 0.0 * s.z, s.u, -p.k * s.x),
    ), (place, 1e-3, 0.0)


METHODS = ("auto", "taylor", "dop853", "scipy DOP853", "scipy RK45")


@pytest.mark.parametrize("rtol", [1e-3, 1e-6, 1e-9])
@pytest.mark.parametrize("place", [6.4e6, 1.5e11])
@pytest.mark.parametrize("method", METHODS)
def test_a_vibration_far_away_is_as_accurate_as_asked(method, place, rtol):
    model, start = spring_at(place)
    motion = integrate(model, 20.0, start, rtol, method)
    error = abs(motion.end["x"] / 1e-3 - math.cos(60.0))
    assert error <= motion.error <= rtol


@pytest.mark.parametrize("method", ["auto", "taylor", "dop853"])
def test_so_are_prepared_runs_and_batches(method):
    model, start = spring_at(6.4e6)
    assert abs(prepare(model, 1e-9, method)(20.0, start)[1] / 1e-3 - math.cos(60.0)) <= 1e-9
    motions = integrate(model, 20.0, (start[0], np.full(70, 1e-3), 0.0), 1e-9, method)
    assert abs(motions.states["x"][:, -1] / 1e-3 - math.cos(60.0)).max() <= 1e-9
    assert (motions.error <= 1e-9).all()


@pytest.mark.parametrize("method", ["auto", "taylor", "dop853"])
def test_the_attitude_of_a_satellite_beside_its_orbit(method):
    """Circular orbit and small libration: the frequency is sqrt(3 q) of the orbit's."""
    r, q, a0 = 7e6, 0.4, 1e-9
    n = math.sqrt(EARTH / r**3)

    def rates(s, p, t):
        r3 = (s.x * s.x + s.y * s.y) * sqrt(s.x * s.x + s.y * s.y)
        return s.u, s.v, -EARTH * s.x / r3, -EARTH * s.y / r3, s.w, -3 * q * n * n * sin(s.a)

    model = Model("satellite", {}, ("x", "y", "u", "v", "a", "w"), rates)
    t = 2.3 * 2 * math.pi / n
    motion = integrate(model, t, (r, 0.0, 0.0, n * r, a0, 0.0), 1e-9, method)
    assert abs(motion.end["a"] / a0 - math.cos(math.sqrt(3 * q) * n * t)) <= 1e-9
    assert abs(motion.end["x"] / r - math.cos(n * t)) <= 1e-8  # the start is rounded too


@pytest.mark.parametrize("unit", [1e-12, 1.0, 1e12])
@pytest.mark.parametrize("method", ["taylor", "dop853"])
def test_the_error_does_not_depend_on_the_unit(method, unit):
    model = Model("oscillator", {"k": 1.0}, ("x", "v"), lambda s, p, t: (s.v, -p.k * s.x))
    for rtol in (1e-5, 1e-9):
        motion = integrate(model, 30.0, (unit, 0.0), rtol, method)
        assert abs(motion.end["x"] / unit - math.cos(30.0)) <= motion.error <= rtol


@pytest.mark.parametrize("method", ["auto", "dop853", "taylor"])
def test_a_state_that_is_zero_by_cancellation_costs_nothing_and_is_not_refused(method):
    """Steady precession in Euler angles: the rate of nutation is a rounded zero."""
    from newton_euler.scenes.spatial.top import euler

    I0, I, mgr, theta, psi_rate = 1.0, 0.4, 2.0, 0.7, 0.9
    spin = (mgr + (I0 - I) * math.cos(theta) * psi_rate**2) / (I * psi_rate)
    model = euler(I0, I, mgr, spin)
    names = model.states
    values = {"psi": 0.0, "theta": theta, "psi_rate": psi_rate, "theta_rate": 0.0}
    start = tuple(values.get(n, 0.0) for n in names)
    motion = integrate(model, 10.0, start, 1e-9, method)
    assert motion.cost.calls < 50_000
    assert motion.error <= 1e-9


@pytest.mark.parametrize("left", [1e-2, 1e-5, 3e-6])
@pytest.mark.parametrize("rtol", [1e-3, 1e-6, 1e-9])
def test_the_speed_of_a_rocket_is_judged_by_its_size_though_hardly_any_mass_is_left(left, rtol):
    """v' = u q/m: next to m = 0 what the mass does to the speed is as large as one likes."""
    u, q, m0 = 3000.0, 250.0, 1e4
    model = Model(
        "rocket", {"u": u, "q": q}, ("v", "m"), lambda s, p, t: (p.u * p.q / s.m, -p.q + 0 * s.v)
    )
    motion = integrate(model, m0 / q * (1 - left), (0.0, m0), rtol, "dop853")
    speed = u * math.log(m0 / motion.end["m"])
    assert abs(motion.end["v"] / speed - 1) <= motion.error <= rtol

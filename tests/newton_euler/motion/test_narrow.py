"""Brakes a millimetre wide, blows a millisecond long: the speed they take is known exactly."""

import math
from contextlib import suppress

import numpy as np
import pytest

from newton_euler import Model, cos, exp, sin, sqrt, tanh, where
from newton_euler.motion import AccuracyError, integrate, prepare, second_order
from newton_euler.motion.methods.table import METHODS
from newton_euler.motion.prepared import prepared_model
from newton_euler.motion.run import Run
from newton_euler.motion.trajectory import Trajectory
from tests.models import needs_heyoka

size = lambda x: sqrt(4 * x * x) / 2
# the speed that each takes, over its strength and its width
BRAKES = {
    "gauss": (lambda z: exp(-z * z), math.sqrt(math.pi)),
    "quotient": (lambda z: 1 / (1 + z * z) ** 4, 5 * math.pi / 16),
    "slope of tanh": (lambda z: 1 - tanh(z) * tanh(z), 2.0),
    "edges": (lambda z: where(z < 0, 0.0, where(z > 1, 0.0, 1.0)), 1.0),
    "tent": (lambda z: (abs(z + 1) + abs(z - 1) - 2 * abs(z)) / 2, 1.0),
    "tent by roots": (lambda z: (size(z + 1) + size(z - 1)) / 2 - size(z), 1.0),
}


def brake(kind, w, speed=1.0, taken=0.2):
    """A path of 10 m with a brake at 5.3 m, and the speed after the brake."""
    shape, area = BRAKES[kind]
    parameters = {"A": taken / (w * area), "w": w, "c": 5.3}
    drag = lambda s, p, t: (-p.A * shape((s.x - p.c) / p.w) * s.dx,)
    return second_order(f"brake, {kind}", parameters, ("x",), drag), speed - taken


def error_at(kind, width, method, rtol, speed=1.0):
    """The error of the speed after a brake, over the speed, and its estimate."""
    model, after = brake(kind, width, speed)
    motion = integrate(model, 11.0, (0.0, speed), rtol, method)
    return abs(motion.end["dx"] - after) / speed, motion.error


@pytest.mark.one_in(2)
@pytest.mark.parametrize("width", [1e-6, 1e-3, 0.05])
@pytest.mark.parametrize("rtol", [1e-3, 1e-6])
@pytest.mark.parametrize("kind", BRAKES)
def test_a_brake_is_seen_however_narrow_it_is(kind, rtol, width):
    error, estimate = error_at(kind, width, "auto", rtol)
    assert error <= estimate <= rtol


@pytest.mark.parametrize("method", ["dop853", "scipy RK45", "scipy DOP853"])
@pytest.mark.parametrize("kind", ["gauss", "tent"])
def test_every_runge_kutta_method_sees_it(kind, method):
    error, estimate = error_at(kind, 1e-3, method, 1e-4)
    assert error <= estimate <= 1e-4


@pytest.mark.one_in(3)
@pytest.mark.parametrize("kind", ["gauss", "quotient", "edges"])
def test_it_is_seen_wherever_in_a_step_it_lies(kind):
    speeds = np.linspace(1.0, 1.1, 20).tolist()
    errors = [error_at(kind, 1e-3, "dop853", 1e-4, speed)[0] for speed in speeds]
    assert max(errors) < 2e-4  # 0.2 if the brake is not seen
    assert sum(error > 1e-4 for error in errors) <= 1


SPOTS = {  # and what each gives, passed at a distance whose square, over its width, is d
    "gauss": (lambda q: exp(-q), lambda d: math.sqrt(math.pi) * math.exp(-d)),
    "quotient": (lambda q: 1 / (1 + q) ** 2, lambda d: math.pi / 2 / (1 + d) ** 1.5),
    "disk": (lambda q: where(q < 1, 1.0, 0.0), lambda d: 2 * math.sqrt(1 - d)),
}


@pytest.mark.one_in(8)
@pytest.mark.parametrize("beside", [0.0, 0.5])
@pytest.mark.parametrize("width", [1e-7, 1e-5, 1e-3])
@pytest.mark.parametrize("kind", SPOTS)
def test_a_spot_narrower_than_the_error_of_the_way_is_seen_or_refused(kind, width, beside):
    """Two oscillations lead through the spot, or past its centre at half of its width."""
    shape, area = SPOTS[kind]

    def rates(s, p, t):
        q = ((s.x - p.a) ** 2 + (s.y - p.b) ** 2) / width**2
        return s.u, -s.x, s.v, -1.69 * s.y, p.A * shape(q)

    found = 0
    for met in (3.1, 4.7, 5.3):
        u, v = -math.sin(met), 1.3 * math.cos(1.3 * met)
        speed = math.hypot(u, v)
        a = math.cos(met) - beside * width * v / speed
        b = math.sin(1.3 * met) + beside * width * u / speed
        parameters = {"A": speed / width, "a": a, "b": b}
        model = Model("spot", parameters, ("x", "u", "y", "v", "q"), rates)
        with suppress(AccuracyError):
            dose = integrate(model, 6.0, (1.0, 0.0, 0.0, 1.3, 0.0), 1e-3).end["q"]
            assert dose == pytest.approx(area(beside**2), rel=2e-3 + width)
            found += 1
    assert found or (kind == "disk" and width < 1e-6)


@pytest.mark.one_in(3)
@needs_heyoka
@pytest.mark.parametrize("kind", ["gauss", "quotient", "slope of tanh"])
def test_a_series_sees_it_or_is_refused(kind):
    model, after = brake(kind, 1e-3)
    with suppress(AccuracyError):
        assert abs(integrate(model, 11.0, (0.0, 1.0), 1e-6, "taylor").end["dx"] - after) < 1e-6
    assert abs(prepare(model, 1e-6)(11.0, (0.0, 1.0))[1] - after) < 1e-6
    many = integrate(model, 11.0, (0.0, np.linspace(1.0, 1.1, 70)), 1e-6)
    assert abs(many.states["dx"][:, -1] - many.states["dx"][:, 0] + 0.2).max() < 1e-6


def test_each_of_many_passages_is_seen():
    """A wheel is braked at one angle in each of a dozen turns."""
    w, lost = 1e-3, 0.01
    model = second_order(
        "wheel",
        {"w": w, "A": lost / (w * math.sqrt(2 * math.pi))},
        ("theta",),
        lambda s, p, t: (-p.A * exp((cos(s.theta - 2.0) - 1) / (p.w * p.w)) * s.dtheta,),
    )
    motion = integrate(model, 2 * math.pi * 13, (0.0, 1.0), 1e-6)
    turns = (motion.end["theta"] - 2.0) // (2 * math.pi) + 1
    assert turns > 10
    assert motion.end["dtheta"] == pytest.approx(1 - lost * turns, rel=2e-4)


@pytest.mark.parametrize("known", [True, False])
@pytest.mark.parametrize("n", [40, 20_000])
def test_a_high_power_is_seen_where_it_is_large(n, known):
    """A cam that lifts at one angle in each of three half turns."""
    rates = lambda s, p, t: (p.u, cos(s.theta - 1.0) ** (n if known else p.n))
    model = Model("cam", {"u": 2.0, "n": float(n)}, ("theta", "q"), rates)
    t, start = 1.5 * math.pi, (1.0 - math.pi / 2, 0.0)
    lift = 1.5 * math.sqrt(math.pi) * math.exp(math.lgamma((n + 1) / 2) - math.lgamma(n / 2 + 1))
    found = integrate(model, t, start, 1e-6).end["q"], prepare(model, 1e-6)(t, start)[1]
    assert found == pytest.approx((lift, lift), rel=1e-6)


def test_a_blow_beside_a_sine_and_a_clock_that_is_a_state():
    blow = lambda c, p: sin(c) + 0.5 / p.w * exp(-(((c - p.tp) / p.w) ** 2))
    rates = lambda s, p, t: (blow(s.c, p), 1 + 0.0 * s.v)
    model = Model("blow", {"w": 1e-4, "tp": 7.0}, ("v", "c"), rates)
    found = integrate(model, 20.0, (0.0, 0.0), 1e-9).end["v"]
    assert found == pytest.approx(1 - math.cos(20.0) + 0.5 * math.sqrt(math.pi), rel=1e-8)


@needs_heyoka
@pytest.mark.parametrize("kind", ["gauss", "quotient", "slope of tanh"])
def test_what_is_met_in_the_middle_of_the_motion_is_seen_by_a_series(kind):
    """A loss around one energy, to which the energy decays in half of the time."""
    shape, c, w = BRAKES[kind][0], 0.04, 1e-5
    parameters = {"c": c, "A": 0.2, "w": w}

    def rates(s, p, t):
        loss = p.c + p.A * shape(((s.v * s.v + s.x * s.x) / 2 - 0.25) / p.w)
        return s.v - loss * s.x, -s.x - loss * s.v

    model = Model("loss at an energy", parameters, ("x", "v"), rates)
    with pytest.raises(AccuracyError, match=r"1e-0[45]|0\.00"):
        integrate(model, math.log(2) / c, (1.0, 0.0), 1e-9, "taylor")


def test_a_patch_in_the_plane_and_a_resistance_at_an_energy_are_seen():
    def patch(s, p, t):
        r2 = (s.x - 3.0) * (s.x - 3.0) + (s.y - 6.0) * (s.y - 6.0)
        return -p.A * exp(-r2 / (p.w * p.w)) * s.dx, -p.A * exp(-r2 / (p.w * p.w)) * s.dy

    w = 1e-3
    parameters = {"w": w, "A": 0.3 / (w * math.sqrt(math.pi))}
    model = second_order("patch", parameters, ("x", "y"), patch)
    end = integrate(model, 10.0, (0.0, 0.0, 1.0, 2.0), 1e-6).end
    assert math.hypot(end["dx"], end["dy"]) == pytest.approx(math.sqrt(5) - 0.3, rel=1e-6)


@pytest.mark.parametrize("rates", [
    lambda s: -sin(s.x), lambda s: -s.x**3, lambda s: -s.x / sqrt(s.x * s.x + s.dx * s.dx),
])  # fmt: skip
def test_nothing_is_looked_for_in_rates_without_scales_of_their_own(rates):
    model = second_order("smooth", {}, ("x",), lambda s, p, t: (rates(s),))
    assert prepared_model(model).traced.narrow is None


@pytest.mark.parametrize("rates", [
    lambda s: -s.x - 0.1 * tanh(s.dx / 0.1), lambda s: -2 * (1 - exp(-s.x)) * exp(-s.x),
    lambda s: -s.x / (1 + s.x * s.x) ** 2, lambda s: -s.x - 0.1 * where(s.dx > 0, 1.0, -1.0),
])  # fmt: skip
def test_no_step_is_repeated_where_the_steps_see_everything(rates):
    system = prepared_model(second_order("seen", {}, ("x",), lambda s, p, t: (rates(s),)))
    run = Run(system, 0.0, 20.0, (1.0, 0.0), 1e-9)
    assert system.traced.narrow
    assert not Trajectory(run, METHODS["dop853"], 1e-9, watched=True).repeated

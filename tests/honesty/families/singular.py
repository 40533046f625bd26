"""Motions that end at a singular point, or pass close to one.

Unstable equilibria and separatrices.
"""

import math

from newton_euler import Model, cos, sin, tan
from newton_euler.motion import second_order
from tests.honesty import models
from tests.honesty.cases import Case, Log, by_accelerations, by_rates, family


def _power(rng):
    a, x = rng.values(Log(1e-2, 1e2), Log(1e-2, 1e2))
    model = Model("x' = a x^2", {"a": a}, ("x",), lambda s, p, t: (p.a * s.x * s.x,))
    return model, x, 1 / (a * x)


@family("singular", "no answer")
def blow_up_on_the_way(rng):
    """x' = a x^2 grows beyond all bounds before the end."""
    model, x, end = _power(rng)
    return Case(model, end * rng.choice((1.001, 1.3, 2.0, 10.0)), (x,), singular_at=end)


@family("near-singular")
def blow_up_later(rng):
    """x' = a x^2, until shortly before it grows beyond all bounds."""
    model, x, end = _power(rng)
    exact = lambda mp, s, p, t: (s.x / (1 - p.a * s.x * t),)
    return Case(model, end * (1 - rng.decades(1e-6, 0.3)), (x,), exact=exact)


@family("near-singular")
def tangent(rng):
    """x' = 1 + x^2, to one side of its pole."""
    w, x = rng.values(Log(1e-2, 1e2), (-3.0, 1.0))
    end = (math.pi / 2 - math.atan(x)) / w
    exact = lambda mp, s, p, t: (mp.tan(mp.atan(s.x) + p.w * t),)
    T = end * (1 - rng.decades(1e-5, 0.3))
    return by_rates(lambda s, p, t: (p.w * (1 + s.x * s.x),), {"w": w}, "x", T, (x,), exact=exact)


def _fall(rng, name):
    """From rest straight into a centre of attraction, and the time that this takes."""
    r = rng.decades(1e-2, 1e2)
    a = lambda s, p, t: (-p.GM / (s.r * s.r),)
    return second_order(name, {"GM": 1.0}, ("r",), a), r, math.pi / 2 * math.sqrt(r**3 / 2)


@family("singular", "no answer")
def fall_into_the_centre(rng):
    """A fall straight into a centre of attraction, and beyond."""
    model, r, end = _fall(rng, "fall into the centre")
    return Case(model, end * rng.choice((1.0001, 1.2, 3.0)), (r, 0.0), singular_at=end)


@family("near-singular")
def fall_towards_the_centre(rng):
    """A fall straight towards a centre of attraction, until shortly before it is reached."""
    model, r, end = _fall(rng, "fall towards the centre")
    return Case(model, end * (1 - rng.decades(1e-4, 0.3)), (r, 0.0))


@family("near-singular")
def past_the_pole(rng):
    """A spherical pendulum close to its lowest point, where the azimuth changes fast."""
    near = rng.decades(1e-3, 0.3)

    def rates(s, p, t):
        k, c = sin(s.theta), cos(s.theta)
        return s.w, p.h / (k * k), p.h * p.h * c / (k * k * k) - p.g * k

    parameters = {"h": near * rng.uniform(0.5, 1.5), "g": rng.uniform(1.0, 10.0)}
    T, theta = rng.values((1.0, 5.0), (0.7, 1.5))
    return by_rates(rates, parameters, "theta phi w", T, (theta, 0.0, 0.0))


@family("near-singular")
def close_approach(rng):
    """A comet on an ellipse of eccentricity 0.9 to 0.9999, past its sun."""
    e = 1 - rng.decades(1e-4, 0.1)
    gm, a, T = rng.values(Log(0.1, 10.0), Log(0.1, 10.0), (0.3, 2.4))
    start = a * (1 + e), 0.0, 0.0, math.sqrt(gm / a * (1 - e) / (1 + e))
    T *= 2 * math.pi * math.sqrt(a**3 / gm)
    return Case(models.orbit("comet", gm), T, start, exact=models.exact_orbit)


@family("near-singular", "separatrix")
def upright_top(rng):
    """A top next to upright, spinning a little too slowly to sleep, or just fast enough."""
    parameters = {"w": 2.0 * rng.choice((0.9, 0.99, 1.01, 1.1)), "g": 1.0, "one": 1.0}

    # equal angular momenta about the vertical and the axis: theta = 0 is not singular
    def rates(s, p, t):
        k = tan(s.theta / 2)
        return s.rate, p.g * sin(s.theta) - p.w * p.w / 4 * k * (p.one + k * k)

    T, theta = rng.values((5.0, 30.0), Log(1e-6, 1e-2))
    return by_rates(rates, parameters, "theta rate", T, (theta, 0.0))


@family("near-singular", "separatrix")
def pendulum_beside_the_upright(rng):
    """A pendulum starts next to its highest point, or gets there with barely any speed left."""
    near = rng.decades(1e-7, 1e-2)
    start = math.pi - near, 0.0
    if rng.random() >= 0.5:
        start = 0.0, 2.0 * (1 + rng.either(near * near))
    T = rng.uniform(0.5, 4.0) * math.log(8 / near)
    return Case(models.pendulum(1.0), T, start, exact=models.exact_pendulum)


@family("near-singular", "separatrix")
def double_well(rng):
    """A potential with two valleys, with nearly the energy of the pass between them."""
    a = lambda s, p, t: (p.a * s.x - s.x * s.x * s.x,)
    near = rng.either(rng.decades(1e-8, 1e-2))
    T = rng.uniform(5.0, 30.0)
    return by_accelerations(a, {"a": 1.0}, "x", T, (1.0, math.sqrt(0.5 + near)))


@family("near-singular", "equilibrium")
def steady_precession(rng):
    """A top in Euler angles that precesses steadily: its rate of nutation is zero all the time."""
    theta, I0, Iz, precession, spin = rng.values(
        (0.3, 1.2), 1.0, (0.5, 1.8), Log(0.1, 10.0), (2.0, 30.0)
    )
    along = precession * math.cos(theta)
    mgr = precession * (Iz * (spin + along) - I0 * along)

    def rates(s, p, t):
        k, c = sin(s.theta), cos(s.theta)
        along = p.I * (s.spin + s.psi_rate * c)
        nutation = (p.mgr + s.psi_rate * (p.I0 * s.psi_rate * c - along)) * k / p.I0
        turning = s.theta_rate * (along - 2 * p.I0 * s.psi_rate * c) / (p.I0 * k)
        spin = -turning * c + s.psi_rate * s.theta_rate * k
        return s.theta_rate, s.psi_rate, nutation, turning, spin

    parameters, states = {"I0": I0, "I": Iz, "mgr": mgr}, "theta psi theta_rate psi_rate spin"
    start = theta, 0.0, 0.0, precession, spin
    return by_rates(rates, parameters, states, rng.uniform(1.0, 10.0), start)


@family("near-singular", "separatrix")
def intermediate_axis(rng):
    """A free body that spins nearly about its middle axis, and turns over again and again."""
    model = models.free_body(1.0, rng.uniform(1.3, 1.7), 2.0)
    tilt, T, ratio = rng.values(Log(1e-6, 1e-1), (10.0, 60.0), (0.2, 3.0))
    return Case(model, T, (tilt, 1.0, tilt * ratio), exact=models.exact_free_body)

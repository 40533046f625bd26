"""Ordinary motions in units that make the numbers very large or very small."""

import math

from newton_euler import exp, sin, sqrt
from tests.honesty import models
from tests.honesty.cases import Case, Log, by_accelerations, by_rates, family


@family("units")
def pendulum_in_any_unit_of_time(rng):
    """A pendulum in seconds, nanoseconds or years."""
    unit, T, theta, omega = rng.values(Log(1e-9, 1e9), (5.0, 40.0), (0.3, 2.5), (-0.5, 0.5))
    start = theta, omega / unit
    return Case(models.pendulum(1 / unit**2), T * unit, start, exact=models.exact_pendulum)


@family("units")
def planet_in_any_units(rng):
    """An ellipse in units of length from 1e-9 to 1e9 and of time from 1e-6 to 1e6."""
    length, time, e, T = rng.values(Log(1e-9, 1e9), Log(1e-6, 1e6), (0.0, 0.7), (3.0, 40.0))
    start = length * (1 + e), 0.0, 0.0, length / time * math.sqrt((1 - e) / (1 + e))
    model = models.orbit("planet", length**3 / time**2)
    return Case(model, time * T, start, exact=models.exact_orbit)


@family("units")
def satellite_in_metres(rng):
    """A satellite about an oblate Earth, in three dimensions, in SI units."""
    parameters = {"GM": 3.986004418e14, "J": 1.75553e25}  # J2 GM R^2

    def accelerations(s, p, t):
        r2 = s.x * s.x + s.y * s.y + s.z * s.z
        r3 = r2 * sqrt(r2)
        k, q = p.GM / r3, p.J / (r3 * r2)
        u = 5 * s.z * s.z / r2
        return tuple(x * (-k + 1.5 * q * (u - n)) for x, n in ((s.x, 1), (s.y, 1), (s.z, 3)))

    r, i = rng.values(Log(6.7e6, 4.2e7), (0.1, 1.5))
    v = math.sqrt(parameters["GM"] / r) * rng.uniform(0.95, 1.15)
    T = rng.uniform(0.5, 6.0) * 2 * math.pi * r / v
    start = r, 0.0, 0.0, 0.0, v * math.cos(i), v * math.sin(i)
    return by_accelerations(accelerations, parameters, "x y z", T, start)


@family("units")
def molecule_in_metres(rng):
    """Two atoms in Morse's potential, in SI units: 1e-10 m, 1e-14 s."""
    parameters = rng.parameters(D=7.4e-19, a=(1.5e10, 2.5e10), r=7.4e-11, m=Log(8e-28, 2e-26))

    def accelerations(s, p, t):
        e = exp(-p.a * (s.x - p.r))
        return (-2 * p.a * p.D * (1 - e) * e / p.m,)

    w = parameters["a"] * math.sqrt(2 * parameters["D"] / parameters["m"])
    T, x = rng.values((5.0, 60.0), (0.85, 1.3))
    return by_accelerations(accelerations, parameters, "x", T / w, (7.4e-11 * x, 0.0))


@family("units")
def trap_for_an_ion(rng):
    """A Penning trap: micrometres, megahertz, and metres a second."""
    wc, wz = rng.values(Log(1e7, 1e9), Log(1e5, 1e6))
    a = lambda s, p, t: (p.k * s.x / 2 + p.c * s.dy, p.k * s.y / 2 - p.c * s.dx, -p.k * s.z)
    T, *start = rng.values((50.0, 400.0), *[(-1e-5, 1e-5)] * 3, *[(-1e3, 1e3)] * 3)
    return by_accelerations(a, {"c": wc, "k": wz * wz}, "x y z", T / wc, start)


@family("units")
def star_in_parsecs(rng):
    """A star in the potential of a galaxy, in metres and seconds: 1e20 m, 1e15 s."""
    V = 2.2e5 * rng.uniform(0.8, 1.2)
    parameters = {"V": V, **rng.parameters(core=Log(1e19, 3e20), q=(0.7, 1.0))}

    def accelerations(s, p, t):
        d = s.x * s.x + s.y * s.y / (p.q * p.q) + p.core * p.core
        return -p.V * p.V * s.x / d, -p.V * p.V * s.y / (p.q * p.q * d)

    T, x, u, v = rng.values(Log(1e15, 3e16), (0.3, 1.5), (-1.0, 1.0), (0.3, 1.0))
    start = 2.5e20 * x, 0.0, 2e4 * u, 2e5 * v
    return by_accelerations(accelerations, parameters, "x y", T, start)


@family("units")
def pendulum_in_arc_seconds(rng):
    """A pendulum whose angle is in arc seconds."""
    parameters = rng.parameters(k=(0.5, 10.0), u=206264.80624709636)
    rates = lambda s, p, t: (s.omega, -p.k * p.u * sin(s.theta / p.u))
    T, theta = rng.values((5.0, 30.0), (0.5, 2.5))
    return by_rates(rates, parameters, "theta omega", T, (2e5 * theta, 0.0))

"""Ordinary motions in units that make the numbers very large or very small."""

import math

from newton_euler import Model, exp, sin, sqrt
from newton_euler.motion import second_order
from tests.honesty import closed_forms
from tests.honesty.cases import Case, decades, family


@family("units")
def pendulum_in_any_time(rng):
    """Seconds, nanoseconds or years."""
    unit = decades(rng, 1e-9, 1e9)
    model = Model(
        "pendulum",
        {"k": 1 / unit**2},
        ("theta", "omega"),
        lambda s, p, t: (s.omega, -p.k * sin(s.theta)),
    )

    def exact(mp, s, p, t):
        return closed_forms.pendulum(mp, p.k, s.theta, s.omega, t)

    return Case(
        model,
        rng.uniform(5.0, 40.0) * unit,
        (rng.uniform(0.3, 2.5), rng.uniform(-0.5, 0.5) / unit),
        exact=exact,
    )


@family("units")
def planet_in_any_units(rng):
    """An ellipse in units of length and time between 1e-9 and 1e9."""
    length, time, e = decades(rng, 1e-9, 1e9), decades(rng, 1e-6, 1e6), rng.uniform(0.0, 0.7)

    def accelerations(s, p, t):
        r2 = s.x * s.x + s.y * s.y
        return -p.GM * s.x / (r2 * sqrt(r2)), -p.GM * s.y / (r2 * sqrt(r2))

    def exact(mp, s, p, t):
        return closed_forms.kepler(mp, p.GM, (s.x, s.y), (s.dx, s.dy), t)

    model = second_order("planet", {"GM": length**3 / time**2}, ("x", "y"), accelerations)
    start = length * (1 + e), 0.0, 0.0, length / time * math.sqrt((1 - e) / (1 + e))
    return Case(model, time * rng.uniform(3.0, 40.0), start, exact=exact)


@family("units")
def satellite_in_metres(rng):
    """Round an oblate Earth, in space, in SI units."""
    parameters = {"GM": 3.986004418e14, "J": 1.75553e25}  # J2 GM R^2

    def accelerations(s, p, t):
        r2 = s.x * s.x + s.y * s.y + s.z * s.z
        r3 = r2 * sqrt(r2)
        k, q = p.GM / r3, p.J / (r3 * r2)
        u = 5 * s.z * s.z / r2
        return tuple(x * (-k + 1.5 * q * (u - n)) for x, n in ((s.x, 1), (s.y, 1), (s.z, 3)))

    r, i = decades(rng, 6.7e6, 4.2e7), rng.uniform(0.1, 1.5)
    v = math.sqrt(parameters["GM"] / r) * rng.uniform(0.95, 1.15)
    T = rng.uniform(0.5, 6.0) * 2 * math.pi * r / v
    return Case(
        second_order("satellite", parameters, ("x", "y", "z"), accelerations),
        T,
        (r, 0.0, 0.0, 0.0, v * math.cos(i), v * math.sin(i)),
    )


@family("units")
def molecule_in_metres(rng):
    """Two atoms in Morse's potential, in SI units: 1e-10 m, 1e-14 s."""
    parameters = {
        "D": 7.4e-19,
        "a": rng.uniform(1.5e10, 2.5e10),
        "r": 7.4e-11,
        "m": decades(rng, 8e-28, 2e-26),
    }

    def accelerations(s, p, t):
        e = exp(-p.a * (s.x - p.r))
        return (-2 * p.a * p.D * (1 - e) * e / p.m,)

    w = parameters["a"] * math.sqrt(2 * parameters["D"] / parameters["m"])
    return Case(
        second_order("molecule", parameters, ("x",), accelerations),
        rng.uniform(5.0, 60.0) / w,
        (7.4e-11 * rng.uniform(0.85, 1.3), 0.0),
    )


@family("units")
def trap_for_an_ion(rng):
    """A Penning trap: micrometres, megahertz, and metres a second."""
    wc, wz = decades(rng, 1e7, 1e9), decades(rng, 1e5, 1e6)
    parameters = {"c": wc, "k": wz * wz}
    model = second_order(
        "Penning trap",
        parameters,
        ("x", "y", "z"),
        lambda s, p, t: (p.k * s.x / 2 + p.c * s.dy, p.k * s.y / 2 - p.c * s.dx, -p.k * s.z),
    )
    return Case(
        model,
        rng.uniform(50.0, 400.0) / wc,
        tuple(rng.uniform(-1e-5, 1e-5) for _ in range(3))
        + tuple(rng.uniform(-1e3, 1e3) for _ in range(3)),
    )


@family("units")
def star_in_parsecs(rng):
    """A star in the potential of a galaxy, in metres and seconds: 1e20 m, 1e15 s."""
    parameters = {
        "V": 2.2e5 * rng.uniform(0.8, 1.2),
        "core": decades(rng, 1e19, 3e20),
        "q": rng.uniform(0.7, 1.0),
    }

    def accelerations(s, p, t):
        d = s.x * s.x + s.y * s.y / (p.q * p.q) + p.core * p.core
        return -p.V * p.V * s.x / d, -p.V * p.V * s.y / (p.q * p.q * d)

    model = second_order("star in a galaxy", parameters, ("x", "y"), accelerations)
    return Case(
        model,
        decades(rng, 1e15, 3e16),
        (
            2.5e20 * rng.uniform(0.3, 1.5),
            0.0,
            2e4 * rng.uniform(-1.0, 1.0),
            2e5 * rng.uniform(0.3, 1.0),
        ),
    )


@family("units")
def pendulum_in_arc_seconds(rng):
    """A pendulum whose angle somebody counts in arc seconds."""
    parameters = {"k": rng.uniform(0.5, 10.0), "u": 206264.80624709636}
    model = Model(
        "pendulum in arc seconds",
        parameters,
        ("theta", "omega"),
        lambda s, p, t: (s.omega, -p.k * p.u * sin(s.theta / p.u)),
    )
    return Case(model, rng.uniform(5.0, 30.0), (2e5 * rng.uniform(0.5, 2.5), 0.0))

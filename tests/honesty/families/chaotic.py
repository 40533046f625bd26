"""Chaotic models, for times after which an error at the start is magnified by not more than about
ten million.
"""

import math

from newton_euler import Model, cos, sin, sqrt
from newton_euler.motion import second_order
from tests.honesty.cases import Case, family


@family("chaotic")
def lorenz(rng):
    """Lorenz' equations: errors grow by 2.5 in a unit of time."""
    parameters = {"sigma": 10.0, "rho": rng.uniform(25.0, 40.0), "beta": rng.uniform(2.0, 3.0)}
    model = Model(
        "Lorenz",
        parameters,
        ("x", "y", "z"),
        lambda s, p, t: (
            p.sigma * (s.y - s.x),
            s.x * (p.rho - s.z) - s.y,
            s.x * s.y - p.beta * s.z,
        ),
    )
    return Case(
        model,
        rng.uniform(2.0, 12.0),
        (rng.uniform(-10.0, 10.0), rng.uniform(-10.0, 10.0), rng.uniform(15.0, 30.0)),
    )


@family("chaotic")
def double_pendulum(rng):
    """Two equal links, thrown up far enough to turn over."""
    parameters = {"g": 9.81, "m": rng.uniform(0.3, 3.0), "L": rng.uniform(0.5, 2.0)}

    def accelerations(s, p, t):
        c, k = cos(s.a - s.b), sin(s.a - s.b)
        M, L = 1 + p.m, p.L  # the upper link is 1 m long and carries 1 kg
        f = -p.m * L * s.db * s.db * k - M * p.g * sin(s.a)
        h = s.da * s.da * k - p.g * sin(s.b)
        d = 1 + p.m * k * k
        return (f - p.m * c * h) / d, (M * h - c * f) / (L * d)

    model = second_order("double pendulum", parameters, ("a", "b"), accelerations)
    return Case(
        model, rng.uniform(1.5, 6.0), (rng.uniform(1.0, 3.0), rng.uniform(-3.0, 3.0), 0.0, 0.0)
    )


@family("chaotic")
def henon_heiles(rng):
    """A star in a galaxy, below the energy at which it escapes."""
    model = second_order(
        "Henon-Heiles",
        {"a": 1.0},
        ("x", "y"),
        lambda s, p, t: (-s.x - 2 * p.a * s.x * s.y, -s.y - p.a * (s.x * s.x - s.y * s.y)),
    )
    energy, y = rng.uniform(0.08, 1 / 6.2), rng.uniform(-0.2, 0.3)
    v = rng.uniform(-0.2, 0.2)
    u = math.sqrt(2 * energy - y * y - v * v + 2 * y**3 / 3)
    return Case(model, rng.uniform(10.0, 80.0), (0.0, y, u, v))


@family("chaotic")
def roessler(rng):
    """Roessler's spiral, with its sudden leaps."""
    parameters = {"a": 0.2, "b": 0.2, "c": rng.uniform(4.5, 8.0)}
    model = Model(
        "Roessler",
        parameters,
        ("x", "y", "z"),
        lambda s, p, t: (-s.y - s.z, s.x + p.a * s.y, p.b + s.z * (s.x - p.c)),
    )
    return Case(
        model,
        rng.uniform(10.0, 60.0),
        (rng.uniform(-5.0, 5.0), rng.uniform(-5.0, 5.0), rng.uniform(0.0, 1.0)),
    )


@family("chaotic", "forced")
def driven_pendulum(rng):
    """Damped, and driven hard enough to turn over now and then."""
    parameters = {"c": rng.uniform(0.2, 0.5), "F": rng.uniform(1.0, 1.6), "w": 0.6667}
    model = Model(
        "driven pendulum",
        parameters,
        ("theta", "omega"),
        lambda s, p, t: (s.omega, -sin(s.theta) - p.c * s.omega + p.F * cos(p.w * t)),
    )
    return Case(model, rng.uniform(10.0, 50.0), (rng.uniform(-1.0, 1.0), rng.uniform(-1.0, 1.0)))


@family("chaotic", "near-singular")
def three_bodies(rng):
    """A light body about two heavy ones that circle each other, in their turning frame.

    It may pass close to one.
    """

    def accelerations(s, p, t):
        a, b = s.x + p.mu, s.x - 1 + p.mu
        p2, q2 = a * a + s.y * s.y, b * b + s.y * s.y
        first, second = (1 - p.mu) / (p2 * sqrt(p2)), p.mu / (q2 * sqrt(q2))
        return 2 * s.dy + s.x - first * a - second * b, s.y - 2 * s.dx - (first + second) * s.y

    model = second_order("three bodies", {"mu": rng.uniform(0.01, 0.5)}, ("x", "y"), accelerations)
    angle, r = rng.uniform(0.0, 2 * math.pi), rng.uniform(0.5, 0.9)
    return Case(
        model,
        rng.uniform(1.0, 6.0),
        (
            0.3 + r * math.cos(angle),
            r * math.sin(angle),
            rng.uniform(-0.5, 0.5),
            rng.uniform(-0.5, 0.5),
        ),
    )

"""Chaotic models, for times in which an initial error grows at most some ten million times."""

import math

from newton_euler import cos, sin, sqrt
from tests.honesty.cases import by_accelerations, by_rates, family


@family("chaotic")
def lorenz(rng):
    """Lorenz' equations: errors grow 2.5 times in a unit of time."""
    parameters = rng.parameters(sigma=10.0, rho=(25.0, 40.0), beta=(2.0, 3.0))

    def rates(s, p, t):
        return p.sigma * (s.y - s.x), s.x * (p.rho - s.z) - s.y, s.x * s.y - p.beta * s.z

    T, *start = rng.values((2.0, 12.0), (-10.0, 10.0), (-10.0, 10.0), (15.0, 30.0))
    return by_rates(rates, parameters, "x y z", T, start)


@family("chaotic")
def double_pendulum(rng):
    """Two equal links, thrown up far enough to turn over."""
    parameters = rng.parameters(g=9.81, m=(0.3, 3.0), L=(0.5, 2.0))

    def accelerations(s, p, t):
        c, k = cos(s.a - s.b), sin(s.a - s.b)
        M, L = 1 + p.m, p.L  # the upper link is 1 m long and carries 1 kg
        f = -p.m * L * s.db * s.db * k - M * p.g * sin(s.a)
        h = s.da * s.da * k - p.g * sin(s.b)
        d = 1 + p.m * k * k
        return (f - p.m * c * h) / d, (M * h - c * f) / (L * d)

    T, *start = rng.values((1.5, 6.0), (1.0, 3.0), (-3.0, 3.0), 0.0, 0.0)
    return by_accelerations(accelerations, parameters, "a b", T, start)


@family("chaotic")
def henon_heiles(rng):
    """A star in a galaxy, below the energy at which it escapes."""
    a = lambda s, p, t: (-s.x - 2 * p.a * s.x * s.y, -s.y - p.a * (s.x * s.x - s.y * s.y))
    energy, y, v = rng.values((0.08, 1 / 6.2), (-0.2, 0.3), (-0.2, 0.2))
    u = math.sqrt(2 * energy - y * y - v * v + 2 * y**3 / 3)
    return by_accelerations(a, {"a": 1.0}, "x y", rng.uniform(10.0, 80.0), (0.0, y, u, v))


@family("chaotic")
def roessler(rng):
    """Roessler's spiral, with its sudden leaps."""
    parameters = rng.parameters(a=0.2, b=0.2, c=(4.5, 8.0))
    rates = lambda s, p, t: (-s.y - s.z, s.x + p.a * s.y, p.b + s.z * (s.x - p.c))
    T, *start = rng.values((10.0, 60.0), (-5.0, 5.0), (-5.0, 5.0), (0.0, 1.0))
    return by_rates(rates, parameters, "x y z", T, start)


@family("chaotic", "forced")
def driven_pendulum(rng):
    """A damped pendulum, driven hard enough to turn over now and then."""
    parameters = rng.parameters(c=(0.2, 0.5), F=(1.0, 1.6), w=0.6667)
    rates = lambda s, p, t: (s.omega, -sin(s.theta) - p.c * s.omega + p.F * cos(p.w * t))
    T, *start = rng.values((10.0, 50.0), (-1.0, 1.0), (-1.0, 1.0))
    return by_rates(rates, parameters, "theta omega", T, start)


@family("chaotic", "near-singular")
def three_bodies(rng):
    """A light body about two heavy ones, in their rotating frame; it may pass close to one."""

    def accelerations(s, p, t):
        a, b = s.x + p.mu, s.x - 1 + p.mu
        p2, q2 = a * a + s.y * s.y, b * b + s.y * s.y
        first, second = (1 - p.mu) / (p2 * sqrt(p2)), p.mu / (q2 * sqrt(q2))
        return 2 * s.dy + s.x - first * a - second * b, s.y - 2 * s.dx - (first + second) * s.y

    parameters = {"mu": rng.uniform(0.01, 0.5)}
    angle, r, T, u, v = rng.values((0.0, 2 * math.pi), (0.5, 0.9), (1.0, 6.0), *[(-0.5, 0.5)] * 2)
    start = 0.3 + r * math.cos(angle), r * math.sin(angle), u, v
    return by_accelerations(accelerations, parameters, "x y", T, start)

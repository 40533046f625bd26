"""Positions, speeds, angles and times at which the rates change over a small part of the path."""

import math

from newton_euler import cos, exp, sin, tanh, where
from tests.honesty.cases import Log, around, by_accelerations, by_rates, family

# humps of height about 1 and width about 1, each with its area
HUMPS = (
    (lambda z: exp(-z * z), math.sqrt(math.pi)),
    (lambda z: 1 / (1 + z * z) ** 4, 5 * math.pi / 16),
    (lambda z: 1 - tanh(z) * tanh(z), 2.0),
    (lambda z: (tanh(z + 2) - tanh(z - 2)) / 2, 4.0),
)


def _slowed(rng, v):
    """A brake of width w somewhere on 10 m, strong enough for a speed v: a hump, its
    parameters, and the time at which it is met.
    """
    hump, area = rng.choice(HUMPS)
    w, c = rng.values(Log(1e-4, 1e-1), (3.0, 7.0))
    return hump, {"A": v * rng.uniform(0.1, 0.7) / (w * area), "w": w, "c": c}, c / v


@family("narrow")
def brake(rng):
    """A smooth brake a tenth of a millimetre to a decimetre wide, on a path of 10 m."""
    v = rng.uniform(0.5, 3.0)
    hump, parameters, met = _slowed(rng, v)
    a = lambda s, p, t: (-p.A * hump((s.x - p.c) / p.w) * s.dx,)
    knots = around(met, parameters["w"] / v / 2, 22)
    return by_accelerations(a, parameters, "x", 10.0 / v, (0.0, v), knots=knots)


@family("narrow", "kinked")
def hard_brake(rng):
    """A narrow brake with sharp edges, by where."""
    v, w, c = rng.values((0.5, 3.0), Log(1e-4, 2e-1), (3.0, 7.0))
    parameters = {"A": v * rng.uniform(0.1, 0.7) / w, "c": c, "w": w}

    def rates(s, p, t):
        return s.v, -p.A * where(s.x < p.c, 0.0, where(s.x > p.c + p.w, 0.0, s.v))

    met = c / v
    knots = around(met + w / v / 2, w / v / 8, 20)
    return by_rates(rates, parameters, "x v", 10.0 / v, (0.0, v), knots=knots)


@family("narrow")
def resistance_at_a_speed(rng):
    """A resistance that has a peak at one speed, passed while falling."""
    g, w, vc = rng.values((5.0, 15.0), Log(1e-3, 3e-1), (10.0, 40.0))
    hump, _ = rng.choice(HUMPS)
    parameters = {"g": g, "w": w, "vc": vc, "A": g * rng.uniform(0.5, 0.99)}
    a = lambda s, p, t: (p.g - p.A * hump((s.dx - p.vc) / p.w),)
    T = 2 * vc / g
    return by_accelerations(a, parameters, "x", T, (0.0, 0.0), knots=around(vc / g, w / g / 2, 22))


@family("narrow")
def brake_of_a_wheel(rng):
    """A wheel that is braked at one angle in each turn."""
    n, c, w = rng.values((2.0, 10.0), (1.0, 5.0), Log(1e-3, 1e-1))
    parameters = {"A": n * rng.uniform(0.1, 0.3) / (w * math.sqrt(2 * math.pi)), "c": c, "w": w}
    a = lambda s, p, t: (-p.A * exp((cos(s.theta - p.c) - 1) / (p.w * p.w)) * s.dtheta,)
    after = n - parameters["A"] * w * math.sqrt(2 * math.pi)
    second = c / n + 2 * math.pi / after
    knots = around(c / n, w / n / 2, 25) + around(second, w / after / 2, 25)
    return by_accelerations(a, parameters, "theta", second + 2.0 / after, (0.0, n), knots=knots)


@family("narrow")
def well(rng):
    """A potential well, or a low wall: it shifts the position and not the final speed."""
    v, w, c = rng.values((0.5, 3.0), Log(1e-3, 1e-1), (3.0, 7.0))
    parameters = {"D": v * v * rng.choice((rng.uniform(-0.4, -0.1), rng.uniform(0.5, 20.0)))}
    parameters |= {"c": c, "w": w}

    def accelerations(s, p, t):
        z = (s.x - p.c) / p.w
        return (-2 * p.D / p.w * z * exp(-z * z),)

    knots = around(c / v, w / v / 2, 22)
    return by_accelerations(accelerations, parameters, "x", 10.0 / v, (0.0, v), knots=knots)


@family("narrow", "forced")
def blow_beside_a_sine(rng):
    """A blow and a sine in one bracket, on a spring."""
    T, hump = rng.uniform(5.0, 30.0), rng.choice(HUMPS)[0]
    parameters = rng.parameters(k=(0.5, 4.0), F=(0.2, 2.0), q=(0.5, 5.0), B=(0.5, 2.0))
    parameters |= {"w": T * rng.decades(1e-5, 1e-2), "tp": T * rng.uniform(0.2, 0.8)}
    a = lambda s, p, t: (p.F * (sin(p.q * t) + p.B / p.w * hump((t - p.tp) / p.w)) - p.k * s.x,)
    knots = around(parameters["tp"], parameters["w"] / 2, 22)
    return by_accelerations(a, parameters, "x", T, (0.3, 0.0), knots=knots)


@family("narrow", "forced")
def clock_as_a_state(rng):
    """A blow beside a cosine on a spring, by a clock that is a state."""
    T, hump = rng.uniform(5.0, 30.0), rng.choice(HUMPS)[0]
    parameters = rng.parameters(k=(0.5, 4.0), F=(0.2, 2.0), q=(0.5, 5.0), one=1.0)
    parameters |= {"w": T * rng.decades(1e-5, 1e-2), "tp": T * rng.uniform(0.2, 0.8)}

    def rates(s, p, t):
        push = p.F * (cos(p.q * s.c) + hump((s.c - p.tp) / p.w) / p.w)
        return s.v, push - p.k * s.x, p.one + 0.0 * s.c

    knots = around(parameters["tp"], parameters["w"] / 2, 22)
    return by_rates(rates, parameters, "x v c", T, (0.3, 0.0, 0.0), knots=knots)

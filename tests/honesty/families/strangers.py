"""Machines and experiments in which something narrow, or a kink, is met: written by someone who has
not read the engine, as are the other files named after strangers.
"""

import math

from newton_euler import cos, exp, sin, sqrt, where
from tests.honesty.cases import Log, around, by_accelerations, by_rates, family

# -- narrow in position


def _inside(s, p):
    """1 on the length L behind c, else 0."""
    return where(s.x > p.c, where(s.x < p.c + p.L, 1.0, 0.0), 0.0)


@family("narrow", "strangers", "kinked")
def car_over_a_speed_bump(rng):
    """A quarter of a car, with spring and damper, over a bump of a raised cosine."""
    v, r, n, zeta, L, c = rng.values(
        (5.0, 15.0), (1e-3, 0.02), (6.0, 12.0), (0.1, 0.5), Log(1e-2, 1.0), (20.0, 60.0)
    )
    parameters = {"k": n * n, "d": 2 * zeta * n, "H": rng.uniform(0.02, 0.1), "L": L, "c": c}
    parameters["r"] = r

    def accelerations(s, p, t):
        q, inside = 2 * math.pi / p.L, _inside(s, p)
        height = inside * p.H / 2 * (1 - cos(q * (s.x - p.c)))
        slope = inside * p.H / 2 * q * sin(q * (s.x - p.c))
        return -p.r * s.dx, -p.k * (s.z - height) - p.d * (s.dz - slope * s.dx)

    met = -math.log1p(-c * r / v) / r
    knots = around(met + L / v / 7, L / v / 3, 10)
    T = met + rng.uniform(0.5, 3.0)
    return by_accelerations(accelerations, parameters, "x z", T, (0.0, 0.0, v, 0.0), knots=knots)


@family("narrow", "strangers", "kinked")
def rumble_strip(rng):
    """A wheel on its spring over some ribs across the road, which brake it as well."""
    v, n, L, c = rng.values((5.0, 20.0), (20.0, 60.0), Log(0.05, 1.0), (10.0, 80.0))
    ribs = rng.randint(2, 6)
    parameters = {"k": n * n, "d": 0.2 * n, "H": rng.uniform(0.005, 0.02), "L": L, "c": c}
    parameters |= {"q": math.pi * ribs / L, "mu": rng.uniform(0.5, 4.0)}

    def accelerations(s, p, t):
        inside = _inside(s, p)
        height = inside * p.H * sin(p.q * (s.x - p.c)) ** 2
        return -inside * p.mu, -p.k * (s.z - height) - p.d * s.dz

    knots = around((c + L / 7) / v, L / v / 5, 15)
    T = c / v + rng.uniform(0.2, 1.0)
    return by_accelerations(accelerations, parameters, "x z", T, (0.0, 0.0, v, 0.0), knots=knots)


@family("narrow", "strangers")
def cart_past_a_magnet(rng):
    """An iron cart on a track of 3 m, with a magnet close beside it."""
    v, d, c, r = rng.values((0.3, 2.0), Log(1e-3, 0.1), (1.0, 2.0), (0.0, 0.05))
    parameters = {"M": d**6 * v * v * rng.uniform(0.1, 2.0), "d": d, "c": c, "r": r}

    def accelerations(s, p, t):
        z = s.x - p.c
        return (-6 * p.M * z / (z**2 + p.d**2) ** 4 - p.r * s.dx,)

    met = -math.log1p(-c * r / v) / r
    knots = around(met, d / v / 3, 40)
    return by_accelerations(accelerations, parameters, "x", 3.0 / v, (0.0, v), knots=knots)


@family("narrow", "strangers")
def door_with_a_latch(rng):
    """A door is pressed shut against a damper and clicks over the ball of its latch."""
    a, c, w, theta = rng.values((1.0, 3.0), (0.5, 2.0), Log(1e-4, 3e-2), (0.8, 1.5))
    opened, place = theta * rng.uniform(1.2, 2.0), lambda t: a / c * (t + math.expm1(-c * t) / c)
    low, high = 0.0, 100.0
    while high - low > 1e-9:
        met = (low + high) / 2
        low, high = (met, high) if place(met) < opened - theta / 4 else (low, met)
    u = -a / c * math.expm1(-c * met)
    parameters = {"a": a, "c": c, "w": w, "at": theta / 4, "E": u * u * rng.uniform(0.05, 0.4)}

    def accelerations(s, p, t):
        z = (s.theta - p.at) / p.w
        return (-p.a - p.c * s.dtheta + 2 * p.E / p.w * z * exp(-(z**2)),)

    T, knots = met * 1.2, around(met, w / u / 3, 30)
    return by_accelerations(accelerations, parameters, "theta", T, (opened, 0.0), knots=knots)


@family("narrow", "strangers", "kinked")
def valve_at_a_level(rng):
    """A tank is filled until a float opens a valve over a small rise; there the level stays."""
    q, w, H, h = rng.values((0.1, 1.0), Log(1e-3, 1e-1), (0.8, 2.0), (0.0, 0.5))
    parameters = {"q": q, "K": q * rng.uniform(1.5, 4.0), "H": H, "w": w}

    def rates(s, p, t):
        z = (s.h - p.H) / p.w
        return (p.q - p.K * where(z < 0, 0.0, where(z > 1, 1.0, z)),)

    def exact(mp, s, p, t):
        above = t - (p.H - s.h) / p.q
        if above < 0:
            return (s.h + p.q * t,)
        return (p.H - p.q * p.w / p.K * mp.expm1(-p.K / p.w * above),)

    filled = (H - h) / q
    return by_rates(rates, parameters, "h", filled * rng.uniform(1.05, 2.0), (h,), exact=exact)


@family("narrow", "strangers", "kinked")
def hair_trigger(rng):
    """A slider sets off a thruster as it touches a hair; the thrust depends on the touch alone."""
    v, L, c = rng.values((0.5, 3.0), Log(1e-4, 1e-1), (3.0, 7.0))
    parameters = {"R": v / L * rng.uniform(0.1, 1.0), "F": v * v * rng.uniform(-0.02, 0.1)}
    rates = lambda s, p, t: (s.v, p.F * s.q, p.R * _inside(s, p))
    knots = around((c + L / 7) / v, L / v / 2, 5)
    T = 10.0 / v
    return by_rates(rates, parameters | {"c": c, "L": L}, "x v q", T, (0.0, v, 0.0), knots=knots)


@family("narrow", "strangers", "kinked")
def pendulum_through_a_light_beam(rng):
    """The light that a diode gets through a slit in a pendulum's bob as it swings by."""
    n, X, w = rng.values((0.5, 4.0), (0.5, 1.0), Log(1e-4, 1e-1))
    at = X * rng.uniform(-0.7, 0.7)
    parameters = {"n": n, "c": at, "w": w, "I": n * X / w * rng.uniform(0.2, 2.0)}

    def rates(s, p, t):
        light = where(abs(s.x - p.c) < p.w, p.I, 0.0)
        return s.v, -p.n * p.n * s.x, light

    def exact(mp, s, p, t):
        angle, X = p.n * t, s.x
        first, last = mp.acos((p.c + p.w) / X), mp.acos((p.c - p.w) / X)
        turns = mp.floor(angle / (2 * mp.pi))
        rest = angle - 2 * mp.pi * turns
        lit = 2 * (last - first) * turns
        for a, b in ((first, last), (2 * mp.pi - last, 2 * mp.pi - first)):
            lit += max(min(rest, b) - a, 0)
        return X * mp.cos(angle), -p.n * X * mp.sin(angle), s.q + p.I / p.n * lit

    T = rng.uniform(3.5, 20.0) / n
    return by_rates(rates, parameters, "x v q", T, (X, 0.0, 0.0), exact=exact)


def _soft_ground(rng, outside, start, R, T):
    """A body in the plane that is braked where ``outside`` is negative, by ``R`` at the origin."""
    speed = math.hypot(*start[2:])
    parameters = {"A": speed / R * rng.uniform(0.1, 0.6), "R": R}

    def accelerations(s, p, t):
        inside = where(outside(s, p) < 0, 1.0, 0.0)
        return -p.A * inside * s.dx, -p.A * inside * s.dy

    knots = around(T, R / speed / 7, 40)
    return by_accelerations(accelerations, parameters, "x y", 2 * T, start, knots=knots)


@family("narrow", "strangers", "kinked")
def puck_through_a_round_puddle(rng):
    """A puck that crosses a round puddle, given by its radius."""
    u, v, R, T = rng.values((0.5, 3.0), (-2.0, 2.0), Log(3e-3, 0.3), (2.0, 5.0))
    outside = lambda s, p: s.x**2 + s.y**2 - p.R**2
    start = -u * T, R * rng.uniform(-0.7, 0.7) - v * T, u, v
    return _soft_ground(rng, outside, start, R, T)


@family("narrow", "strangers", "kinked")
def lorry_in_a_bed_of_gravel(rng):
    """A lorry on gravel between two marks, given by the sign of a product."""
    u, L, T = rng.values((5.0, 20.0), Log(3e-3, 0.3), (2.0, 5.0))
    outside = lambda s, p: s.x * (s.x - p.R)
    return _soft_ground(rng, outside, (-u * T, 0.0, u, 0.0), L * u, T)


@family("narrow", "strangers", "kinked")
def pendulum_against_a_stop(rng):
    """A pendulum that strikes a hard stop with damping, felt only while they touch."""
    K = rng.decades(1e2, 1e6)
    parameters = rng.parameters(k=(1.0, 20.0), a=(0.1, 0.6), K=K, c=(0.01, 0.2))
    parameters["c"] *= math.sqrt(K)

    def rates(s, p, t):
        stop = p.K * (s.theta - p.a) + p.c * s.omega
        return s.omega, -p.k * sin(s.theta) - where(s.theta > p.a, stop, 0.0)

    T, theta = rng.values((2.0, 8.0), (-1.5, -0.8))
    start = theta, 0.0
    return by_rates(rates, parameters, "theta omega", T / math.sqrt(parameters["k"]) * 2, start)


# -- kinks


@family("kinked", "strangers", "mechanics")
def backlash_of_a_gear(rng):
    """A motor and its load, joined by a gear with play; the motor's torque goes to and fro."""
    parameters = rng.parameters(K=Log(30.0, 3e3), b=(0.01, 0.1), r=(0.2, 2.0), c=(0.05, 0.5))
    parameters |= rng.parameters(F=(0.5, 3.0), w=(0.5, 3.0))

    def accelerations(s, p, t):
        d = s.motor - s.load
        torque = p.K * where(d > p.b, d - p.b, where(d < -p.b, d + p.b, 0.0))
        return -torque + p.F * cos(p.w * t), p.r * torque - p.c * s.dload

    T, angle = rng.values((3.0, 12.0), (-0.005, 0.005))
    return by_accelerations(accelerations, parameters, "motor load", T, (angle, 0.0, 0.0, 0.0))


@family("kinked", "strangers", "near-singular")
def puck_that_turns_on_an_incline(rng):
    """A puck on an incline with dry friction; where it is slow its direction turns round."""
    parameters = rng.parameters(g=(3.0, 8.0), mu=(0.3, 2.0))

    def accelerations(s, p, t):
        speed = sqrt(s.dx**2 + s.dy**2)
        return -p.mu * s.dx / speed, -p.g - p.mu * s.dy / speed

    up, aside = rng.values((2.0, 8.0), Log(3e-3, 1.0))
    turned = up / (parameters["g"] + parameters["mu"])
    knots = around(turned, aside / parameters["g"] / 3, 40)
    T = turned * rng.uniform(1.5, 3.0)
    return by_accelerations(accelerations, parameters, "x y", T, (0.0, 0.0, aside, up), knots=knots)


@family("kinked", "strangers")
def actuator_that_saturates(rng):
    """A controller whose integral winds up while the actuator is at its limit."""
    parameters = rng.parameters(F=(0.3, 1.5), kp=(3.0, 10.0), kd=(1.0, 4.0), ki=(0.2, 2.0))
    parameters["R"] = rng.uniform(1.0, 5.0)

    def rates(s, p, t):
        u = p.kp * (p.R - s.x) - p.kd * s.v + p.ki * s.i
        return s.v, where(u > p.F, p.F, where(u < -p.F, -p.F, u)), p.R - s.x

    start = rng.uniform(-1.0, 0.5), rng.uniform(-0.5, 0.5), 0.0
    return by_rates(rates, parameters, "x v i", rng.uniform(3.0, 15.0), start)

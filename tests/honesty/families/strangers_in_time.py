"""Doses, gates, kicks, positions and clocks far from zero, and what sticks, lasts or is stiff."""

import math

from newton_euler import cos, exp, sin, where
from tests.honesty import closed_forms
from tests.honesty.cases import Log, around, by_accelerations, by_rates, family

# -- narrow in time


@family("narrow", "strangers", "forced")
def kick_in_a_product(rng):
    """A pendulum in a stream that is strong for a moment: its drag is a product of three."""
    T = rng.uniform(5.0, 30.0)
    parameters = rng.parameters(k=(0.5, 4.0), c=(0.02, 0.2), A=(0.3, 3.0), q=(0.5, 3.0))
    parameters |= {"w": T * rng.decades(1e-5, 1e-2), "tp": T * rng.uniform(0.2, 0.8)}

    def accelerations(s, p, t):
        stream = 1 + p.A / p.w * exp(-(((t - p.tp) / p.w) ** 2)) * (2 + sin(p.q * t))
        return (-p.k * sin(s.x) - p.c * stream * cos(s.x) * s.dx,)

    knots = around(parameters["tp"], parameters["w"] / 2, 22)
    return by_accelerations(accelerations, parameters, "x", T, (1.0, 0.5), knots=knots)


@family("narrow", "strangers", "kinked")
def dose_by_a_clock(rng):
    """A pump gives a dose at a set time of its clock, a state; the blood clears the dose."""
    T, tau, dose = rng.values((2.0, 24.0), (0.0, 12.0), (0.5, 5.0))
    w = T * rng.decades(1e-5, 3e-2)
    parameters = {"k": rng.uniform(0.05, 0.6), "D": dose / w, "w": w}
    parameters["a"] = tau + T * rng.uniform(0.2, 0.9)

    def rates(s, p, t):
        given = where(s.tau > p.a, where(s.tau < p.a + p.w, p.D, 0.0), 0.0)
        return given - p.k * s.c, 1.0

    def exact(mp, s, p, t):
        begun = max(t - (p.a - s.tau), mp.mpf(0))
        ended, passed = max(begun - p.w, mp.mpf(0)), min(begun, p.w)
        given = -p.D / p.k * mp.expm1(-p.k * passed) * mp.exp(-p.k * ended)
        return s.c * mp.exp(-p.k * t) + given, s.tau + t

    return by_rates(rates, parameters, "c tau", T, (rng.uniform(0.5, 2.0), tau), exact=exact)


@family("narrow", "strangers", "kinked", "forced")
def gate_that_opens_twice(rng):
    """A cam opens a gate for a short part of each of two turns."""
    n, d, c = rng.values((0.5, 5.0), Log(1e-4, 0.1), (0.05, 0.5))
    half = math.acos(1 - d) / n
    parameters = {"n": n, "edge": 1 - d, "c": c, "A": rng.uniform(0.3, 2.0) / half}
    parameters["phase"] = rng.uniform(0.5, 2.5)
    rates = lambda s, p, t: (where(cos(p.n * t + p.phase) > p.edge, p.A, 0.0) - p.c * s.m,)

    def exact(mp, s, p, t):
        m, half = s.m * mp.exp(-p.c * t), mp.acos(p.edge) / p.n
        for k in (1, 2):
            middle = (2 * mp.pi * k - p.phase) / p.n
            a, b = min(middle - half, t), min(middle + half, t)
            m += p.A / p.c * (mp.exp(-p.c * (t - b)) - mp.exp(-p.c * (t - a)))
        return (m,)

    T = (2 * math.pi * 2.5 - parameters["phase"]) / n
    return by_rates(rates, parameters, "m", T, (rng.uniform(0.0, 1.0),), exact=exact)


# -- far from zero


@family("far", "strangers", "mechanics")
def satellite_in_polar_coordinates(rng):
    """A nearly circular orbit: its radius is large and varies by kilometres or metres."""
    GM, r, e = 3.986004418e14, rng.uniform(6.6e6, 4.2e7), rng.decades(1e-7, 1e-2)
    n = math.sqrt(GM / r**3)
    rates = lambda s, p, t: (s.u, s.w, s.r * s.w**2 - p.GM / s.r**2, -2 * s.u * s.w / s.r)
    T = rng.uniform(2.0, 40.0) / n
    return by_rates(rates, {"GM": GM}, "r phi u w", T, (r, 0.0, 0.0, n * (1 + e / 2)))


def _turning(mp, b, a, u, du, t):
    """u and u' of u'' = b u' + a u, complex."""
    root = mp.sqrt(mp.mpc(b) ** 2 / 4 + a)
    one, two = b / 2 + root, b / 2 - root
    c = (du - two * u) / (one - two)
    e, f = c * mp.exp(one * t), (u - c) * mp.exp(two * t)
    return e + f, one * e + two * f


@family("far", "strangers")
def foucault_in_map_coordinates(rng):
    """Foucault's pendulum, in metres of the map's grid."""
    parameters = rng.parameters(k=(0.1, 2.0), Om=Log(1e-5, 1e-1), E=(3e5, 7e5), N=(5e6, 6e6))

    def accelerations(s, p, t):
        return (-p.k * (s.x - p.E) + 2 * p.Om * s.dy, -p.k * (s.y - p.N) - 2 * p.Om * s.dx)

    def exact(mp, s, p, t):
        u, du = mp.mpc(s.x - p.E, s.y - p.N), mp.mpc(s.dx, s.dy)
        u, du = _turning(mp, mp.mpc(0, -2 * p.Om), -p.k, u, du, t)
        return p.E + u.real, p.N + u.imag, du.real, du.imag

    start = parameters["E"] + rng.uniform(0.1, 2.0), parameters["N"] + rng.uniform(-0.5, 0.5), 0, 0
    T = rng.uniform(10.0, 100.0) / math.sqrt(parameters["k"])
    return by_accelerations(accelerations, parameters, "x y", T, map(float, start), exact=exact)


@family("far", "strangers", "forced")
def tide_by_julian_days(rng):
    """A harbour as an oscillator, moved by a tide whose clock shows Julian days."""
    begin = rng.randint(2_440_000, 2_470_000) + 0.5
    days, x, v = rng.values((0.5, 8.0), (-1.0, 1.0), (-1.0, 1.0))
    parameters = rng.parameters(k=(20.0, 300.0), c=(0.1, 2.0), F=(5.0, 50.0), q=(6.0, 13.0))
    parameters["epoch"] = 2451545.0
    a = lambda s, p, t: (-p.k * s.x - 2 * p.c * s.dx + p.F * cos(p.q * (t - p.epoch)),)

    def exact(mp, s, p, t):
        Z = p.F / mp.mpc(p.k - p.q**2, 2 * p.c * p.q)
        turn = lambda t: Z * mp.expjpi(p.q * (t - p.epoch) / mp.pi)
        first, last = turn(mp.mpf(begin)), turn(t)
        rate = lambda z: -p.q * z.imag
        x, v = closed_forms.damped(
            mp, mp.sqrt(p.k), p.c, s.x - first.real, s.dx - rate(first), t - mp.mpf(begin)
        )
        return x + last.real, v + rate(last)

    return by_accelerations(a, parameters, "x", begin + days, (x, v), t0=begin, exact=exact)


@family("far", "strangers", "stiff")
def oven_in_kelvin(rng):
    """An oven at 300 to 1200 K under integral control, disturbed by 1 mK to 1 K."""
    parameters = rng.parameters(c=(0.05, 1.0), P=(0.5, 5.0), ki=(0.1, 1.0), w=(0.2, 3.0))
    parameters |= rng.parameters(T0=(300.0, 1200.0), A=Log(1e-3, 1.0), leak=Log(1e-4, 1e-2))

    def rates(s, p, t):
        off = s.T - p.T0
        lost = p.leak * ((s.T / p.T0) ** 4 - 1) + p.c * (s.T - s.wall)
        return -lost - p.P * off - p.ki * s.i + p.A * sin(p.w * t), p.c * (s.T - s.wall), off

    start = parameters["T0"] + parameters["A"] * rng.uniform(-1.0, 1.0), parameters["T0"], 0.0
    return by_rates(rates, parameters, "T wall i", rng.uniform(3.0, 40.0), start)


# -- sticking


@family("sticking", "strangers", "kinked")
def thermostat_without_hysteresis(rng):
    """A relay heats a room until it is warm enough; from then on it chatters."""
    k, outside, P = rng.values((0.05, 0.5), (-10.0, 10.0), (4.0, 20.0))
    parameters = {"k": k, "Ta": outside, "P": P, "Ts": outside + P / k * rng.uniform(0.3, 0.8)}
    rates = lambda s, p, t: (where(p.Ts > s.T, p.P, 0.0) - p.k * (s.T - p.Ta),)

    def exact(mp, s, p, t):
        end = p.Ta + p.P / p.k
        return (min(end + (s.T - end) * mp.exp(-p.k * t), p.Ts),)

    warm = math.log((P / k) / (P / k - (parameters["Ts"] - outside))) / k
    T = warm * rng.choice((0.7, 1.3, 3.0))
    return by_rates(rates, parameters, "T", T, (outside,), exact=exact)


@family("sticking", "strangers", "kinked")
def block_on_a_belt(rng):
    """A belt drags a block on a spring along, until it has the speed of the belt and sticks."""
    k, V = rng.values((0.5, 20.0), (0.1, 2.0))
    mu = V * math.sqrt(k) * rng.uniform(1.2, 5.0)
    parameters = {"k": k, "V": V, "mu": mu}
    a = lambda s, p, t: (where(s.dx < p.V, p.mu, -p.mu) - p.k * s.x,)

    def exact(mp, s, p, t):
        w = mp.sqrt(p.k)
        first = mp.asin(p.V * w / p.mu) / w
        slip = min(t, first)
        x, v = p.mu / p.k * (1 - mp.cos(w * slip)), p.mu / w * mp.sin(w * slip)
        return x + p.V * (t - slip), v

    first = math.asin(V * math.sqrt(k) / mu) / math.sqrt(k)
    T = first * rng.choice((0.8, rng.uniform(1.05, 1.4)))  # its spring pulls it loose later
    return by_accelerations(a, parameters, "x", T, (0.0, 0.0), exact=exact)


# -- long or stiff, smooth


@family("long", "strangers")
def ion_in_a_penning_trap(rng):
    """An ion in fast circles, hundreds to thousands of them, whose centre goes round slowly."""
    wc = rng.uniform(5.0, 50.0)
    parameters = {"wc": wc, "a": wc * wc * rng.decades(1e-4, 0.1)}
    accelerations = lambda s, p, t: (p.wc * s.dy + p.a * s.x, p.a * s.y - p.wc * s.dx)

    def exact(mp, s, p, t):
        u, du = mp.mpc(s.x, s.y), mp.mpc(s.dx, s.dy)
        u, du = _turning(mp, mp.mpc(0, -p.wc), p.a, u, du, t)
        return u.real, u.imag, du.real, du.imag

    start = rng.uniform(0.1, 1.0), 0.0, rng.uniform(-1.0, 1.0), rng.uniform(-1.0, 1.0)
    T = rng.decades(2e2, 5e3) * 2 * math.pi / wc
    return by_accelerations(accelerations, parameters, "x y", T, start, exact=exact)


@family("stiff", "strangers")
def motor_with_an_inductance(rng):
    """A DC motor on a battery: its current settles in milliseconds, its speed in seconds."""
    parameters = rng.parameters(L=Log(3e-4, 1e-2), R=(0.5, 2.0), K=(0.02, 0.1), J=(1e-3, 5e-3))
    parameters |= rng.parameters(c=(1e-4, 1e-3), V=(6.0, 24.0))

    def rates(s, p, t):
        return (p.V - p.R * s.i - p.K * s.w) / p.L, (p.K * s.i - p.c * s.w) / p.J

    def exact(mp, s, p, t):
        M = mp.matrix([[-p.R / p.L, -p.K / p.L], [p.K / p.J, -p.c / p.J]])
        i = p.V * p.c / (p.R * p.c + p.K**2)
        steady = mp.matrix([i, p.K * i / p.c])
        half, det = (M[0, 0] + M[1, 1]) / 2, M[0, 0] * M[1, 1] - M[0, 1] * M[1, 0]
        one, two = half + mp.sqrt(half**2 - det), half - mp.sqrt(half**2 - det)
        grown = [
            (M - other * mp.eye(2)) * mp.exp(own * t) for own, other in ((one, two), (two, one))
        ]
        return tuple(
            steady + (grown[0] - grown[1]) * (mp.matrix([s.i, s.w]) - steady) / (one - two)
        )

    return by_rates(rates, parameters, "i w", rng.uniform(0.3, 5.0), (0.0, 0.0), exact=exact)

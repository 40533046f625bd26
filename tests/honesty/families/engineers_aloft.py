"""Rockets, satellites and tops as an engineer writes them, in SI units. Written by someone who did
not write the methods, before any of them was run.
"""

import math

from newton_euler import Event, exp, sqrt, where
from tests.honesty.cases import Log, by_accelerations, by_rates, family

GM, EARTH = 3.986004418e14, 6.371e6


@family("engineers", "units", "multi-scale")
def perigee_in_thin_air(rng):
    """A satellite whose perigee dips into air of scale height 7 km, for a few orbits."""
    low, high = rng.values((1e5, 1.6e5), (1e6, 3e7))
    a, rp = EARTH + (low + high) / 2, EARTH + low
    parameters = {"gm": GM, "R": EARTH + 1e5, "h": 7e3, "D": rng.decades(1e-11, 3e-9)}

    def accelerations(s, p, t):
        r, v = sqrt(s.x**2 + s.y**2), sqrt(s.dx**2 + s.dy**2)
        k, drag = p.gm / r**3, p.D * exp(-(r - p.R) / p.h) * v
        return -k * s.x - drag * s.dx, -k * s.y - drag * s.dy

    period, ra = 2 * math.pi * math.sqrt(a**3 / GM), 2 * a - rp
    start = ra, 0.0, 0.0, math.sqrt(GM * (2 / ra - 1 / a))
    return by_accelerations(accelerations, parameters, "x y", period * rng.uniform(1.2, 4.5), start)


@family("engineers", "kinked", "units")
def rocket_of_two_stages(rng):
    """A rocket in air, its thrust in phases of time; the mass drops as a stage is cast off."""
    t1, gap, t2 = rng.values((20.0, 60.0), (0.5, 10.0), (20.0, 60.0))
    parameters = {"T1": t1, "T2": t1 + gap, "T3": t1 + gap + t2, "g": 9.81, "c": 2500.0}
    parameters |= {"m1": 1.0 / t1 * rng.uniform(0.4, 0.5), "m2": rng.uniform(0.25, 0.4) / t2}
    parameters |= {"D": rng.decades(1e-6, 1e-4), "h": 8e3}

    def rates(s, p, t):
        flow = where(t < p.T1, p.m1, where(t < p.T2, 0.0, where(t < p.T3, p.m2, 0.0)))
        drag = p.D * exp(-s.z / p.h) * s.v * abs(s.v)
        return s.v, (flow * p.c - drag) / (1 - s.burnt) - p.g, flow

    T = t1 + gap + t2 + rng.uniform(1.0, 30.0)
    return by_rates(rates, parameters, "z v burnt", T, (0.0, 10.0, 0.0))


@family("engineers", "near-singular")
def top_barely_asleep(rng):
    """Lagrange's top, the vertical in body axes: spin just enough, or not, to stay upright."""
    A, C, mgl = rng.values((0.5, 2.0), (0.3, 1.0), (1.0, 10.0))
    spin = 2 * math.sqrt(A * mgl) / C * (1 + rng.either(rng.decades(1e-4, 1e-1)))
    tilt = rng.decades(1e-7, 1e-2)

    def rates(s, p, t):
        # mgl e3 x gamma, from the point of support
        return (
            ((p.A - p.C) * s.q * s.r + p.mgl * s.gy) / p.A,
            ((p.C - p.A) * s.p * s.r - p.mgl * s.gx) / p.A,
            0 * s.r,
            s.r * s.gy - s.q * s.gz,
            s.p * s.gz - s.r * s.gx,
            s.q * s.gx - s.p * s.gy,
        )

    start = 0.0, 0.0, spin, math.sin(tilt), 0.0, math.cos(tilt)
    T = rng.uniform(5.0, 20.0) * A / C / spin * 10
    return by_rates(rates, {"A": A, "C": C, "mgl": mgl}, "p q r gx gy gz", T, start)


@family("engineers", "long", "closed form")
def moon_that_recedes(rng):
    """The distance of a moon that tides drive away over billions of years, in SI units."""
    a0 = rng.uniform(1e8, 4e8)
    T = rng.uniform(0.2, 4.0) * 1e9 * 3.15e7
    grown = rng.uniform(0.1, 3.0)
    k = 2 / 13 * a0**6.5 * ((1 + grown) ** 6.5 - 1) / T
    grown_by = lambda mp, s, p, t: mp.mpf(s.a) ** 6.5 + mp.mpf(13) / 2 * p.k * t
    exact = lambda mp, s, p, t: (grown_by(mp, s, p, t) ** (mp.mpf(2) / 13),)
    return by_rates(lambda s, p, t: (p.k / s.a**5.5,), {"k": k}, "a", T, (a0,), exact=exact)


@family("engineers", "events", "units", "multi-scale")
def two_satellites_that_meet(rng):
    """Two satellites, seen from the Earth's centre; the events are when they are 1 km apart."""
    r = rng.uniform(6.8e6, 8e6)
    v, ahead = math.sqrt(GM / r), rng.uniform(2e3, 1e4) / r
    parameters = {"gm": GM, "d": 1e3}

    def accelerations(s, p, t):
        k, m = p.gm / sqrt(s.x**2 + s.y**2) ** 3, p.gm / sqrt(s.u**2 + s.w**2) ** 3
        return -k * s.x, -k * s.y, -m * s.u, -m * s.w

    near = Event(lambda s, p, t: (s.x - s.u) ** 2 + (s.y - s.w) ** 2 - p.d**2)
    slow = v * (1 - rng.uniform(1e-4, 6e-4))
    start = (r, 0.0, r * math.cos(ahead), r * math.sin(ahead),
             0.0, slow, -v * math.sin(ahead), v * math.cos(ahead))  # fmt: skip
    T = 2 * math.pi * r / v * rng.uniform(0.6, 3.0)
    return by_accelerations(accelerations, parameters, "x y u w", T, start, events=(near,))


@family("engineers", "kinked")
def parachute_that_opens_by_height(rng):
    """A jumper whose drag grows linearly below the opening height, until the parachute is open."""
    z, top = rng.values((1500.0, 4000.0), (800.0, 1200.0))
    parameters = rng.parameters(g=9.81, D=0.003, P=(0.1, 0.4), top=top, L=Log(1.0, 200.0), h=8e3)

    def rates(s, p, t):
        part = (p.top - s.z) / p.L
        share = where(part < 0, 0.0, where(part > 1, 1.0, part))
        return s.v, (p.D + share * p.P) * exp(-s.z / p.h) * s.v**2 - p.g

    T = (z - top) / 55 + rng.uniform(5.0, 40.0)
    return by_rates(rates, parameters, "z v", T, (z, 0.0))


@family("engineers", "smooth")
def truss_that_snaps_through(rng):
    """Two bars pressed down slowly until they snap through."""
    parameters = rng.parameters(k=(10.0, 100.0), h=(0.1, 0.5), c=(0.05, 0.5), F=(0.01, 0.1))

    def accelerations(s, p, t):
        long, now = sqrt(1 + p.h**2), sqrt(1 + (p.h - s.x) ** 2)
        return (p.F * t - 2 * p.k * (1 - long / now) * (s.x - p.h) - p.c * s.dx,)

    return by_accelerations(accelerations, parameters, "x", rng.uniform(20.0, 100.0), (0.0, 0.0))

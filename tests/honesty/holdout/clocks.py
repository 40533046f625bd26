"""Late starts, long times, and closed forms that lose digits."""

import math

from newton_euler import cos, sin, sqrt
from tests.honesty import models
from tests.honesty.cases import Log, by_accelerations, by_rates, held_out


@held_out("forced", "late")
def tide_by_the_clock_of_unix(rng):
    """A basin driven by three tides, from some instant of this century, in Unix seconds."""
    begin = float(rng.randrange(1_600_000_000, 1_800_000_000))
    parameters = {"k": rng.decades(1e-9, 1e-7), "c": 1e-5, "M2": 1.405189e-4, "S2": 1.454441e-4}
    parameters |= {"O1": 6.759774e-5, "F": 1e-8}

    def accelerations(s, p, t):
        pull = p.F * (cos(p.M2 * t) + 0.5 * cos(p.S2 * t) + 0.25 * cos(p.O1 * t))
        return (pull - p.k * s.h - p.c * s.dh,)

    T, h = rng.values(Log(1e4, 5e5), (-1.0, 1.0))
    return by_accelerations(accelerations, parameters, "h", begin + round(T), (h, 0.0), t0=begin)


@held_out("forced", "late")
def seasons_by_julian_dates(rng):
    """The temperature of soil, by a clock of Julian dates in seconds."""
    begin = 86400.0 * (2451545 + rng.randrange(0, 9000))
    parameters = rng.parameters(tau=Log(1e5, 1e7), n=1.99e-7, day=7.27e-5, A=10.0)

    def rates(s, p, t):
        air = 283.0 + p.A * cos(p.n * t) + 5.0 * cos(p.day * t)
        return (air - s.T) / p.tau, (s.T - s.deep) / (8 * p.tau)

    t_end, start = begin + 86400.0 * rng.randint(1, 30), (rng.uniform(270.0, 295.0), 283.0)
    return by_rates(rates, parameters, "T deep", t_end, start, t0=begin)


@held_out("closed form", "near-singular")
def nearly_critical_damping(rng):
    """Nearly critical damping, by a closed form that divides by the small root of a difference."""
    w = rng.decades(0.1, 10.0)
    parameters = {"w": w, "c": w * (1 - rng.decades(1e-14, 1e-1))}

    def solution(m, s, p, t):
        d = m.sqrt(p.w * p.w - p.c * p.c)
        e, k, c = m.exp(-p.c * t), m.sin(d * t) / d, m.cos(d * t)
        x = e * (s.x * c + (s.dx + p.c * s.x) * k)
        return x, e * (s.dx * c - (p.c * s.dx + p.w * p.w * s.x) * k)

    a = lambda s, p, t: (-2 * p.c * s.dx - p.w * p.w * s.x,)
    T, v = rng.values((0.5, 8.0), (-1.0, 1.0))
    return by_accelerations(a, parameters, "x", T / w, (1.0, v), exact=solution, brings=True)


@held_out("closed form", "tiny")
def shot_with_hardly_any_drag(rng):
    """A shot with a drag of 1e-12 to 1, by (1 - exp(-c t))/c as it stands in the book."""

    def solution(m, s, p, t):
        e = m.exp(-p.c * t)
        q, fall = (1 - e) / p.c, p.g / p.c
        return s.x + s.u * q, s.y + (s.v + fall) * q - fall * t, s.u * e, (s.v + fall) * e - fall

    rates = lambda s, p, t: (s.u, s.v, -p.c * s.u, -p.g - p.c * s.v)
    parameters = rng.parameters(g=9.81, c=Log(1e-12, 1.0))
    T, *start = rng.values((0.5, 10.0), 0.0, 0.0, (5.0, 50.0), (5.0, 50.0))
    return by_rates(rates, parameters, "x y u v", T, start, exact=solution, brings=True)


@held_out("closed form", "forced")
def beat_by_a_difference(rng):
    """A spring driven next to its own frequency, by (cos q t - cos w t)/(w^2 - q^2)."""
    w = rng.decades(0.3, 10.0)
    parameters = {"w": w, "q": w * (1 + rng.either(rng.decades(1e-11, 1e-2))), "F": 1.0}

    def solution(m, s, p, t):
        b = p.F / (p.w * p.w - p.q * p.q)
        c, k = m.cos(p.w * t), m.sin(p.w * t)
        x = s.x * c + s.dx / p.w * k + b * (m.cos(p.q * t) - c)
        return x, s.dx * c - p.w * s.x * k + b * (p.w * k - p.q * m.sin(p.q * t))

    a = lambda s, p, t: (p.F * cos(p.q * t) - p.w * p.w * s.x,)
    T = rng.decades(3.0, 300.0) / w
    return by_accelerations(a, parameters, "x", T, (0.0, 0.0), exact=solution, brings=True)


@held_out("long", "closed form")
def foucault(rng):
    """Foucault's pendulum for minutes to weeks, with the closed form that turns with the Earth."""
    lat = rng.uniform(0.2, 1.4)
    parameters = {"w2": 9.81 / rng.uniform(5.0, 70.0), "n": 7.292115e-5 * math.sin(lat)}

    def solution(m, s, p, t):
        # the rates hold exactly for a frequency a little higher
        w = m.sqrt(p.w2 + p.n * p.n)
        c, k = m.cos(w * t), m.sin(w * t) / w
        u, v = s.dx - p.n * s.y, s.dy + p.n * s.x
        x, y = s.x * c + u * k, s.y * c + v * k
        dx, dy = u * c - w * w * s.x * k, v * c - w * w * s.y * k
        C, S = m.cos(p.n * t), m.sin(p.n * t)
        X, Y = x * C + y * S, y * C - x * S
        return X, Y, dx * C + dy * S + p.n * Y, dy * C - dx * S - p.n * X

    a = lambda s, p, t: (-p.w2 * s.x + 2 * p.n * s.dy, -p.w2 * s.y - 2 * p.n * s.dx)
    T, *start = rng.values(Log(1e2, 1e6), (0.5, 3.0), 0.0, 0.0, 0.0)
    return by_accelerations(a, parameters, "x y", T, start, exact=solution, brings=True)


@held_out("closed form", "units")
def relativistic_rocket(rng):
    """Constant force on a ship, c^2/a (sqrt(1 + (a t/c)^2) - 1), from seconds to years."""
    parameters = rng.parameters(a=Log(0.01, 100.0), c=299792458.0)

    def solution(m, s, p, t):
        # q is momentum over mass, with which the ship starts
        q = s.q + p.a * t
        g, g0 = m.sqrt(1 + (q / p.c) ** 2), m.sqrt(1 + (s.q / p.c) ** 2)
        return s.x + p.c * p.c / p.a * (g - g0), q

    rates = lambda s, p, t: (s.q / sqrt(1 + (s.q / p.c) ** 2), p.a + 0 * s.q)
    T = rng.decades(1.0, 1e8)
    return by_rates(rates, parameters, "x q", T, (0.0, 0.0), exact=solution, brings=True)


@held_out("long", "closed form", "units")
def drift_in_crossed_fields(rng):
    """An electron in crossed fields for ten to a million turns, in metres, with its closed form."""
    parameters = rng.parameters(wc=Log(1e7, 1e11), drift=Log(1e2, 1e6))

    def solution(m, s, p, t):
        c, k = m.cos(p.wc * t), m.sin(p.wc * t)
        u = s.u - p.drift
        x = s.x + p.drift * t + (u * k + s.v * (1 - c)) / p.wc
        y = s.y + (s.v * k - u * (1 - c)) / p.wc
        return x, y, p.drift + u * c + s.v * k, s.v * c - u * k

    rates = lambda s, p, t: (s.u, s.v, p.wc * s.v, -p.wc * (s.u - p.drift))
    T = 2 * math.pi / parameters["wc"] * rng.decades(10.0, 1e6)
    start = 0.0, 0.0, rng.choice((0.0, 1e5)), rng.choice((0.0, 1e6))
    return by_rates(rates, parameters, "x y u v", T, start, exact=solution, brings=True)


@held_out("long", "closed form")
def symmetric_body_for_long(rng):
    """A spinning plate that wobbles, for ten to a million turns: its rates, and the wobble rate."""
    parameters = rng.parameters(A=1.0, C=(1.01, 1.99))

    def solution(m, s, p, t):
        n = (p.C - p.A) / p.A * s.z
        c, k = m.cos(n * t), m.sin(n * t)
        return s.x * c - s.y * k, s.y * c + s.x * k, s.z, s.phi + s.z * t

    def rates(s, p, t):
        n = (p.C - p.A) / p.A * s.z
        return -n * s.y, n * s.x, 0 * s.z, s.z

    spin, T, wobble = rng.values(Log(0.1, 100.0), Log(10.0, 1e6), Log(1e-6, 1.0))
    T, start = 2 * math.pi / spin * T, (spin * wobble, 0.0, spin, 0.0)
    return by_rates(rates, parameters, "x y z phi", T, start, exact=solution, brings=True)


@held_out("long")
def planet_beyond_newton(rng):
    """An orbit whose perihelion moves, by a term 1/r^3 in the attraction: 5 to 15 turns."""

    def accelerations(s, p, t):
        r2 = s.x * s.x + s.y * s.y
        f = -(p.GM + p.b / r2) / r2**1.5
        return f * s.x, f * s.y

    parameters = rng.parameters(GM=1.0, b=Log(1e-8, 1e-2))
    e, T = rng.values((0.0, 0.6), (5.0, 15.0))
    start = 1 + e, 0.0, 0.0, math.sqrt((1 - e) / (1 + e))
    return by_accelerations(accelerations, parameters, "x y", 2 * math.pi * T, start)


@held_out("long", "forced")
def ponderomotive_trap(rng):
    """An ion in Paul's trap, in SI units, for some tens of field periods: Mathieu's equation."""
    f = rng.decades(1e5, 1e7)
    parameters = {"W": 2 * math.pi * f, **rng.parameters(q=(0.05, 0.7), a=(-0.02, 0.05))}
    a = lambda s, p, t: (-p.W * p.W / 4 * (p.a - 2 * p.q * cos(p.W * t)) * s.x,)
    T, x = rng.values((10.0, 50.0), (1e-6, 1e-4))
    return by_accelerations(a, parameters, "x", T / f, (x, 0.0))


@held_out("forced", "multi-scale")
def carrier_with_a_message(rng):
    """A slow resonator that listens to a fast carrier with a slow message on it."""
    w = rng.decades(20.0, 120.0)
    parameters = {"w": w, "k": w * w, "c": rng.uniform(0.5, 5.0), "m": 1.0, "one": 1.0}

    def rates(s, p, t):
        sent = (p.one + 0.5 * sin(p.m * t)) * sin(p.w * t)
        return s.v, p.k * (sent - s.x) - p.c * s.v, (s.x * s.x - s.out) * p.m * 4

    return by_rates(rates, parameters, "x v out", rng.uniform(1.0, 4.0), (0.0, 0.0, 0.0))


@held_out("long", "chaotic")
def ellipse_by_its_closed_form_at_99(rng):
    """An orbit of eccentricity 0.98 to 0.995, up to five revolutions, from its far end."""
    e, T = rng.values((0.98, 0.995), (0.6, 5.0))

    def accelerations(s, p, t):
        r = (s.x**2 + s.y**2) ** 0.5
        return -p.GM * s.x / r**3, -p.GM * s.y / r**3

    start = 1 + e, 0.0, 0.0, math.sqrt((1 - e) / (1 + e))
    exact = models.exact_orbit
    return by_accelerations(accelerations, {"GM": 1.0}, "x y", 2 * math.pi * T, start, exact=exact)

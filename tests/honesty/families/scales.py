"""Small states beside large ones, fast ones beside slow ones."""

import math

from newton_euler import cos, exp, sin, sqrt
from tests.honesty import closed_forms
from tests.honesty.cases import Log, by_accelerations, by_rates, family

EARTH, SUN = 3.986004418e14, 1.32712440018e20  # G M, m^3/s^2


@family("multi-scale")
def beside_a_constant(rng):
    """A pendulum whose model also has a constant state: a position on the Earth or in an orbit."""
    k = rng.decades(0.3, 30.0)
    rates = lambda s, p, t: (0.0 * s.omega, s.omega, -p.k * sin(s.theta))

    def exact(mp, s, p, t):
        return s.R, *closed_forms.pendulum(mp, p.k, s.theta, s.omega, t)

    start = rng.choice((6.4e6, 1.5e11)), rng.uniform(-1.5, 1.5) * rng.decades(1e-3, 1.0), 0.0
    T = rng.uniform(5.0, 30.0) / k**0.5
    return by_rates(rates, {"k": k}, "R theta omega", T, start, exact=exact)


@family("multi-scale")
def beside_a_traveller(rng):
    """A vibration in a vehicle that is far away and moves steadily."""
    w = rng.decades(0.5, 20.0)
    rates = lambda s, p, t: (s.v, 0.0 * s.u, s.u, -p.k * s.x)

    def exact(mp, s, p, t):
        return s.z + s.v * t, s.v, *closed_forms.oscillator(mp, mp.sqrt(p.k), s.x, s.u, t)

    start = rng.either(rng.decades(1e5, 1e11)), *rng.values((10.0, 8e3), Log(1e-4, 1e-1), 0.0)
    return by_rates(rates, {"k": w * w}, "z v x u", rng.uniform(10.0, 60.0) / w, start, exact=exact)


@family("multi-scale")
def satellite_with_attitude(rng):
    """An orbit in metres, and the libration of the satellite by the gravity gradient."""
    parameters = rng.parameters(GM=EARTH, q=(0.2, 0.9))
    r = rng.decades(6.7e6, 4.2e7)
    v = math.sqrt(EARTH / r) * rng.uniform(0.95, 1.1)

    def rates(s, p, t):
        r2 = s.x * s.x + s.y * s.y
        pull = p.GM / (r2 * sqrt(r2))
        # of the axis; the torque goes with the sine and cosine of its angle to the vertical
        c, k = cos(s.a), sin(s.a)
        across, along = s.x * k - s.y * c, s.x * c + s.y * k
        return s.u, s.v, -pull * s.x, -pull * s.y, s.w, -3.0 * p.q * pull * across * along / r2

    start = r, 0.0, 0.0, v, rng.uniform(-0.3, 0.3), v / r * rng.uniform(0.9, 1.1)
    T = rng.uniform(0.3, 3.0) * 2 * math.pi * r / v
    return by_rates(rates, parameters, "x y u v a w", T, start)


@family("multi-scale")
def charged_particle(rng):
    """A charged particle that gyrates quickly in crossed fields and drifts far away."""
    parameters = rng.parameters(W=Log(1.0, 1e3), E=Log(1.0, 1e3))
    a = lambda s, p, t: (p.W * s.dy, p.E - p.W * s.dx)

    def exact(mp, s, p, t):
        drift = p.E / p.W
        u, v, c, k = s.dx - drift, s.dy, mp.cos(p.W * t), mp.sin(p.W * t)
        x, y = (u * k + v * (1 - c)) / p.W, (v * k - u * (1 - c)) / p.W
        return s.x + drift * t + x, s.y + y, drift + u * c + v * k, v * c - u * k

    T, *start = rng.values((10.0, 150.0), 0.0, 0.0, (-1.0, 1.0), (-1.0, 1.0))
    return by_accelerations(a, parameters, "x y", T / parameters["W"], start, exact=exact)


@family("multi-scale")
def probe_near_a_planet(rng):
    """A planet on its orbit about the Sun, and a probe about the planet in metres from it."""

    def rates(s, p, t):
        def pull(gm, x, y):
            r2 = x * x + y * y
            k = gm / (r2 * sqrt(r2))
            return -k * x, -k * y

        planet, probe = pull(p.S, s.X, s.Y), pull(p.S, s.X + s.x, s.Y + s.y)
        own = pull(p.E, s.x, s.y)
        relative = (own[i] + probe[i] - planet[i] for i in range(2))
        return s.U, s.V, *planet, s.u, s.v, *relative

    r = rng.decades(7e6, 1e8)
    v = math.sqrt(EARTH / r) * rng.uniform(0.9, 1.2)
    T, start = rng.uniform(0.3, 3.0), (1.496e11, 0.0, 0.0, 29780.0, 0.0, r, -v, 0.0)
    T = T * 2 * math.pi * r / v
    return by_rates(rates, {"S": SUN, "E": EARTH}, "X Y U V x y u v", T, start)


@family("multi-scale")
def fast_and_slow(rng):
    """Two uncoupled oscillators: a slow large one and a fast small one."""
    ratio, size = rng.values(Log(10.0, 300.0), Log(1e-9, 1e-2))
    a = lambda s, p, t: (-p.k * s.x, -p.K * s.y)

    def exact(mp, s, p, t):
        x, u = closed_forms.oscillator(mp, mp.sqrt(p.k), s.x, s.dx, t)
        y, v = closed_forms.oscillator(mp, mp.sqrt(p.K), s.y, s.dy, t)
        return x, y, u, v

    T, *start = rng.values((1.0, 20.0), Log(1.0, 1e6), size, 0.0, 0.0)
    return by_accelerations(a, {"k": 1.0, "K": ratio * ratio}, "x y", T, start, exact=exact)


@family("multi-scale")
def fall_through_air(rng):
    """A fall through air that thins exponentially, measured from the centre of the Earth."""
    parameters = rng.parameters(GM=EARTH, R=6.371e6, H=(6e3, 9e3), c=Log(1e-5, 1e-3))

    def rates(s, p, t):
        g = p.GM / (s.r * s.r)
        drag = p.c * exp((p.R - s.r) / p.H) * s.v * s.v
        return s.v, -g + drag, s.w, -sin(s.a) * p.GM / (s.r * s.r)

    T, h, v, a = rng.values((10.0, 80.0), (3e4, 8e4), (10.0, 100.0), (-0.01, 0.01))
    return by_rates(rates, parameters, "r v a w", T, (6.371e6 + h, -v, a, 0.0))

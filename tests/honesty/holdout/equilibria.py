"""Equilibria, stable and not, exact and nearly so; constants; growth from next to nothing."""

import math

from newton_euler import cos, exp, sin, sqrt
from tests.honesty.cases import Log, by_accelerations, by_rates, held_out


@held_out("near-singular", "equilibrium")
def upright_by_pi(rng):
    """A pendulum put upright at math.pi, which is not quite upright."""
    parameters = {"k": rng.uniform(1.0, 20.0), "c": rng.choice((0.0, 0.2))}
    a = lambda s, p, t: (-p.k * sin(s.th) - p.c * s.dth,)
    T = rng.uniform(3.0, 16.0) / parameters["k"] ** 0.5
    return by_accelerations(a, parameters, "th", T, (math.pi, 0.0))


@held_out("tiny", "equilibrium")
def lorenz_on_its_axis(rng):
    """Two states that are exactly zero, unstable, and stay so while the third decays."""
    parameters = rng.parameters(s=10.0, r=(10.0, 30.0), b=8 / 3)
    rates = lambda s, p, t: (p.s * (s.y - s.x), s.x * (p.r - s.z) - s.y, s.x * s.y - p.b * s.z)
    exact = lambda mp, s, p, t: (mp.mpf(0), mp.mpf(0), s.z * mp.exp(-p.b * t))
    T, *start = rng.values((1.0, 12.0), 0.0, 0.0, (1.0, 40.0))
    return by_rates(rates, parameters, "x y z", T, start, exact=exact)


@held_out("multi-scale", "equilibrium")
def constants_as_states(rng):
    """GM of the Earth, its radius and an astronomical unit as states, beside a small pendulum."""

    def rates(s, p, t):
        g = s.GM / (s.R * s.R)
        return s.w, -g / p.L * sin(s.th) - p.c * s.w, 0.0 * s.GM, 0.0 * s.R, 0.0 * s.au

    parameters = rng.parameters(L=Log(0.1, 10.0), c=(0.0, 0.2))
    T, th = rng.values((3.0, 20.0), Log(1e-4, 2.0))
    start = th, 0.0, 3.986004418e14, 6.371e6, 1.495978707e11
    return by_rates(rates, parameters, "th w GM R au", T, start)


@held_out("multi-scale", "units")
def bond_beside_an_orbit(rng):
    """A molecule in a comet: a bond of 1e-10 m and 1e-14 s with an orbit of 1e11 m."""
    parameters = {"GM": 1.32712440018e20, "D": 7.4e-19}
    parameters |= rng.parameters(a=(1.5e10, 2.5e10), r=7.4e-11, m=Log(8e-28, 2e-26))

    def rates(s, p, t):
        R = sqrt(s.X * s.X + s.Y * s.Y)
        e = exp(-p.a * (s.d - p.r))
        pull = -2 * p.a * p.D * (1 - e) * e / p.m
        return s.U, s.V, -p.GM * s.X / R**3, -p.GM * s.Y / R**3, s.w, pull

    n = parameters["a"] * math.sqrt(2 * parameters["D"] / parameters["m"])
    T, Y, d = rng.values((5.0, 40.0), (-1e11, 1e11), (0.9, 1.2))
    start = 1.5e11, Y, 0.0, 3e4, 7.4e-11 * d, 0.0
    return by_rates(rates, parameters, "X Y U V d w", T / n, start)


@held_out("multi-scale", "tiny")
def ripple_on_a_train(rng):
    """A swing of 1 nm or more in a train up to 1000 km away: two coordinates, and their sum."""
    rates = lambda s, p, t: (0 * s.V, s.V, s.w, -p.k * s.u, s.V + s.w)
    k, a, x, T, V = rng.values((1.0, 30.0), Log(1e-9, 1e-4), (1e5, 1e6), (5.0, 30.0), (10.0, 80.0))
    return by_rates(rates, {"k": k}, "V X u w sum", T, (V, x, a, 0.0, x + a))


@held_out("forced", "closed form")
def exact_resonance(rng):
    """A spring driven at exactly its own frequency; the model brings its growing solution."""

    def solution(m, s, p, t):
        c, k = m.cos(p.w * t), m.sin(p.w * t)
        x = s.x * c + s.dx / p.w * k + p.F * t * k / (2 * p.w)
        return x, s.dx * c - p.w * s.x * k + p.F * (k / p.w + t * c) / 2

    parameters = rng.parameters(w=Log(0.1, 10.0), F=Log(1e-6, 10.0))
    a = lambda s, p, t: (p.F * cos(p.w * t) - p.w * p.w * s.x,)
    brings, T = rng.choice((False, True)), 2 * math.pi / parameters["w"] * rng.decades(3.0, 200.0)
    return by_accelerations(a, parameters, "x", T, (0.0, 0.0), brings, exact=solution)


@held_out("equilibrium")
def trojan(rng):
    """A body at Lagrange's fourth point of Earth and Moon, or where that point is unstable."""
    mu = rng.choice((0.012150585, 0.1, 0.3))

    def accelerations(s, p, t):
        nu = p.one - p.mu
        a, b = s.x + p.mu, s.x - nu
        d1, d2 = sqrt(a * a + s.y * s.y) ** 3, sqrt(b * b + s.y * s.y) ** 3
        x = 2 * s.dy + s.x - nu * a / d1 - p.mu * b / d2
        return x, -2 * s.dx + s.y - nu * s.y / d1 - p.mu * s.y / d2

    off = rng.choice((0.0, rng.decades(1e-9, 1e-2)))
    T, start = rng.uniform(5.0, 25.0), (0.5 - mu + off, math.sqrt(3) / 2, 0.0, 0.0)
    return by_accelerations(accelerations, {"mu": mu, "one": 1.0}, "x y", T, start)


@held_out("long", "equilibrium")
def circle_in_polar_coordinates(rng):
    """A circular orbit in polar coordinates: the radius and its rate stay, the angle increases."""
    h = 2.0 ** rng.randint(-3, 3)
    exact = lambda mp, s, p, t: (s.r, s.phi + p.h / (s.r * s.r) * t, s.dr)
    rates = lambda s, p, t: (s.dr, p.h / (s.r * s.r), p.h * p.h / s.r**3 - p.GM / (s.r * s.r))
    T = h**3 * rng.decades(3.0, 1e3)
    return by_rates(rates, {"h": h, "GM": 1.0}, "r phi dr", T, (h * h, 0.0, 0.0), exact=exact)


@held_out("tiny", "closed form")
def onset_of_an_oscillation(rng):
    """Hopf's normal form from 1e-8 up to its circle; the model brings its solution."""
    parameters = rng.parameters(a=Log(0.1, 5.0), w=Log(0.3, 30.0))

    def rates(s, p, t):
        r2 = s.x * s.x + s.y * s.y
        return (p.a * (1 - r2) * s.x - p.w * s.y, p.a * (1 - r2) * s.y + p.w * s.x)

    def solution(m, s, p, t):
        r2 = s.x * s.x + s.y * s.y
        grow = 1 / m.sqrt(r2 + (1 - r2) * m.exp(-2 * p.a * t))
        c, k = m.cos(p.w * t), m.sin(p.w * t)
        return grow * (s.x * c - s.y * k), grow * (s.x * k + s.y * c)

    brings, (T, x) = rng.choice((False, True)), rng.values((3.0, 30.0), Log(1e-8, 1e-2))
    T /= parameters["a"]
    return by_rates(rates, parameters, "x y", T, (x, 0.0), brings, exact=solution)


@held_out("tiny")
def buckling(rng):
    """A strut above its buckling load leaves the straight line from 1e-10 to 1e-4."""
    parameters = rng.parameters(P=(0.5, 3.0), c=(0.1, 1.0))
    a = lambda s, p, t: (p.P * s.x - s.x * s.x * s.x - p.c * s.dx,)
    T, x = rng.values((10.0, 40.0), Log(1e-10, 1e-4))
    return by_accelerations(a, parameters, "x", T, (rng.either(x), 0.0))


@held_out("equilibrium", "kinked")
def terminal_speed_from_the_start(rng):
    """A fall whose drag balances the weight exactly: nothing changes but the height."""
    g, c = 2.0 ** rng.randint(1, 4), 2.0 ** -rng.randint(1, 6)
    v = math.sqrt(g / c)
    if v != round(v):
        g, v = g * 2, math.sqrt(g * 2 / c)
    rates = lambda s, p, t: (s.v, -p.g - p.c * s.v * abs(s.v))
    exact = lambda mp, s, p, t: (s.h + s.v * t, s.v)
    T, h = rng.values((1.0, 1000.0), (0.0, 1e4))
    return by_rates(rates, {"g": g, "c": c}, "h v", T, (h, -v), exact=exact)


@held_out("tiny", "multi-scale")
def slow_growth_beside_a_fast_swing(rng):
    """A growth from 1e-12 or more beside a swing, which it damps in the end."""
    rates = lambda s, p, t: (s.v, -p.w * p.w * s.x - p.q * s.y * s.v, p.s * s.y * (1 - s.y))
    parameters = rng.parameters(w=(3.0, 10.0), s=(0.3, 1.0), q=0.1)
    T, y = rng.values((10.0, 45.0), Log(1e-12, 1e-6))
    return by_rates(rates, parameters, "x v y", T, (1.0, 0.0, y))


@held_out("tiny", "forced")
def push_of_a_nanonewton(rng):
    """A mass of 1 µg or more at rest, pushed by a bump exp(-u^2) of up to 1 nN, in SI units."""
    T = rng.uniform(10.0, 60.0)
    parameters = rng.parameters(m=Log(1e-9, 1e-6), k=Log(1e-9, 1e-6), F=Log(1e-12, 1e-9))
    parameters |= {"a": T * rng.uniform(0.3, 0.6), "w": T * rng.uniform(0.03, 0.1)}
    parameters["k"] = parameters["m"] * rng.uniform(0.1, 4.0)

    def accelerations(s, p, t):
        u = (t - p.a) / p.w
        return ((p.F * exp(-u * u) - p.k * s.x) / p.m,)

    knots = (parameters["a"] + parameters["w"] * k / 2 for k in range(-22, 23))
    return by_accelerations(accelerations, parameters, "x", T, (0.0, 0.0), knots=knots)

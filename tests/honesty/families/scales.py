"""Small states beside large ones, fast ones beside slow ones."""

import math

from newton_euler import Model, cos, exp, sin, sqrt
from newton_euler.motion import second_order
from tests.honesty import closed_forms
from tests.honesty.cases import Case, decades, either, family

EARTH, SUN = 3.986004418e14, 1.32712440018e20  # G M, m^3/s^2


@family("multi-scale")
def beside_a_constant(rng):
    """A pendulum whose model also has a place on the Earth or in an orbit, a constant."""
    k = decades(rng, 0.3, 30.0)
    model = Model(
        "pendulum at a place",
        {"k": k},
        ("R", "theta", "omega"),
        lambda s, p, t: (0.0 * s.omega, s.omega, -p.k * sin(s.theta)),
    )

    def exact(mp, s, p, t):
        return s.R, *closed_forms.pendulum(mp, p.k, s.theta, s.omega, t)

    start = rng.choice((6.4e6, 1.5e11)), rng.uniform(-1.5, 1.5) * decades(rng, 1e-3, 1.0), 0.0
    return Case(model, rng.uniform(5.0, 30.0) / k**0.5, start, exact=exact)


@family("multi-scale")
def beside_a_traveller(rng):
    """A vibration in a vehicle that is far away and moves steadily."""
    w = decades(rng, 0.5, 20.0)
    model = Model(
        "vibration in a vehicle",
        {"k": w * w},
        ("z", "v", "x", "u"),
        lambda s, p, t: (s.v, 0.0 * s.u, s.u, -p.k * s.x),
    )

    def exact(mp, s, p, t):
        return s.z + s.v * t, s.v, *closed_forms.oscillator(mp, mp.sqrt(p.k), s.x, s.u, t)

    start = (
        either(rng, decades(rng, 1e5, 1e11)),
        rng.uniform(10.0, 8e3),
        decades(rng, 1e-4, 1e-1),
        0.0,
    )
    return Case(model, rng.uniform(10.0, 60.0) / w, start, exact=exact)


@family("multi-scale")
def satellite_with_attitude(rng):
    """An orbit in metres, and the libration of the satellite in the gravity gradient."""
    parameters = {"GM": EARTH, "q": rng.uniform(0.2, 0.9)}
    r = decades(rng, 6.7e6, 4.2e7)
    v = math.sqrt(EARTH / r) * rng.uniform(0.95, 1.1)

    def rates(s, p, t):
        r2 = s.x * s.x + s.y * s.y
        pull = p.GM / (r2 * sqrt(r2))
        # of the axis; the torque goes with the sine and cosine of its angle to the vertical
        c, k = cos(s.a), sin(s.a)
        across, along = s.x * k - s.y * c, s.x * c + s.y * k
        return s.u, s.v, -pull * s.x, -pull * s.y, s.w, -3.0 * p.q * pull * across * along / r2

    model = Model("satellite with attitude", parameters, ("x", "y", "u", "v", "a", "w"), rates)
    start = r, 0.0, 0.0, v, rng.uniform(-0.3, 0.3), v / r * rng.uniform(0.9, 1.1)
    return Case(model, rng.uniform(0.3, 3.0) * 2 * math.pi * r / v, start)


@family("multi-scale")
def charged_particle(rng):
    """It gyrates quickly in crossed fields and drifts far away."""
    parameters = {"W": decades(rng, 1.0, 1e3), "E": decades(rng, 1.0, 1e3)}
    model = second_order(
        "charged particle", parameters, ("x", "y"), lambda s, p, t: (p.W * s.dy, p.E - p.W * s.dx)
    )

    def exact(mp, s, p, t):
        drift = p.E / p.W
        u, v, c, k = s.dx - drift, s.dy, mp.cos(p.W * t), mp.sin(p.W * t)
        return (
            s.x + drift * t + (u * k + v * (1 - c)) / p.W,
            s.y + (v * k - u * (1 - c)) / p.W,
            drift + u * c + v * k,
            v * c - u * k,
        )

    return Case(
        model,
        rng.uniform(10.0, 150.0) / parameters["W"],
        (0.0, 0.0, rng.uniform(-1.0, 1.0), rng.uniform(-1.0, 1.0)),
        exact=exact,
    )


@family("multi-scale")
def probe_near_a_planet(rng):
    """A planet on its orbit about the sun, and a probe about the planet in metres from it."""
    parameters = {"S": SUN, "E": EARTH}

    def rates(s, p, t):
        def pull(gm, x, y):
            r2 = x * x + y * y
            k = gm / (r2 * sqrt(r2))
            return -k * x, -k * y

        planet, probe, moon = (
            pull(p.S, s.X, s.Y),
            pull(p.S, s.X + s.x, s.Y + s.y),
            pull(p.E, s.x, s.y),
        )
        return (
            s.U,
            s.V,
            *planet,
            s.u,
            s.v,
            moon[0] + probe[0] - planet[0],
            moon[1] + probe[1] - planet[1],
        )

    model = Model(
        "probe near a planet", parameters, ("X", "Y", "U", "V", "x", "y", "u", "v"), rates
    )
    r = decades(rng, 7e6, 1e8)
    v = math.sqrt(EARTH / r) * rng.uniform(0.9, 1.2)
    return Case(
        model,
        rng.uniform(0.3, 3.0) * 2 * math.pi * r / v,
        (1.496e11, 0.0, 0.0, 29780.0, 0.0, r, -v, 0.0),
    )


@family("multi-scale")
def fast_and_slow(rng):
    """Two oscillators that know nothing of each other: a slow large one and a fast small one."""
    ratio, size = decades(rng, 10.0, 300.0), decades(rng, 1e-9, 1e-2)
    model = second_order(
        "fast and slow",
        {"k": 1.0, "K": ratio * ratio},
        ("x", "y"),
        lambda s, p, t: (-p.k * s.x, -p.K * s.y),
    )

    def exact(mp, s, p, t):
        (x, u), (y, v) = (
            closed_forms.oscillator(mp, mp.sqrt(p.k), s.x, s.dx, t),
            closed_forms.oscillator(mp, mp.sqrt(p.K), s.y, s.dy, t),
        )
        return x, y, u, v

    return Case(
        model, rng.uniform(1.0, 20.0), (decades(rng, 1.0, 1e6), size, 0.0, 0.0), exact=exact
    )


@family("multi-scale")
def fall_through_air(rng):
    """A particle that falls from a great height through air that thins exponentially.

    Its height is counted from the centre of the Earth.
    """
    parameters = {
        "GM": EARTH,
        "R": 6.371e6,
        "H": rng.uniform(6e3, 9e3),
        "c": decades(rng, 1e-5, 1e-3),
    }

    def rates(s, p, t):
        return (
            s.v,
            -p.GM / (s.r * s.r) + p.c * exp((p.R - s.r) / p.H) * s.v * s.v,
            s.w,
            -sin(s.a) * p.GM / (s.r * s.r),
        )

    model = Model("fall through air", parameters, ("r", "v", "a", "w"), rates)
    return Case(
        model,
        rng.uniform(10.0, 80.0),
        (6.371e6 + rng.uniform(3e4, 8e4), -rng.uniform(10.0, 100.0), rng.uniform(-0.01, 0.01), 0.0),
    )

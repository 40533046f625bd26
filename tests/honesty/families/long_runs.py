"""Many periods: from ten to a million."""

import math

from newton_euler import Model, sin, sqrt
from newton_euler.motion import second_order
from tests.honesty import closed_forms
from tests.honesty.cases import Case, decades, family


@family("long")
def spring_for_long(rng):
    """A hundred to ten thousand swings, and the model has no closed form."""
    w = decades(rng, 1e-2, 1e2)
    model = second_order("spring", {"k": w * w}, ("x",), lambda s, p, t: (-p.k * s.x,))

    def exact(mp, s, p, t):
        return closed_forms.oscillator(mp, mp.sqrt(p.k), s.x, s.dx, t)

    return Case(model, 2 * math.pi / w * decades(rng, 1e2, 1e4), (1.0, 0.0), exact=exact)


@family("long")
def pendulum_for_long(rng):
    """Ten to a few thousand swings of any amplitude."""
    k = decades(rng, 0.1, 100.0)
    model = Model(
        "pendulum", {"k": k}, ("theta", "omega"), lambda s, p, t: (s.omega, -p.k * sin(s.theta))
    )

    def exact(mp, s, p, t):
        return closed_forms.pendulum(mp, p.k, s.theta, s.omega, t)

    return Case(
        model, 6.3 / k**0.5 * decades(rng, 10.0, 3e3), (rng.uniform(0.1, 2.5), 0.0), exact=exact
    )


@family("long")
def planet_for_long(rng):
    """Ten to a thousand orbits of moderate eccentricity."""

    def accelerations(s, p, t):
        r2 = s.x * s.x + s.y * s.y
        return -p.GM * s.x / (r2 * sqrt(r2)), -p.GM * s.y / (r2 * sqrt(r2))

    def exact(mp, s, p, t):
        return closed_forms.kepler(mp, p.GM, (s.x, s.y), (s.dx, s.dy), t)

    e, gm = rng.uniform(0.0, 0.6), decades(rng, 0.1, 10.0)
    model = second_order("planet", {"GM": gm}, ("x", "y"), accelerations)
    return Case(
        model,
        2 * math.pi / gm**0.5 * decades(rng, 10.0, 1e3),
        (1 + e, 0.0, 0.0, math.sqrt(gm * (1 - e) / (1 + e))),
        exact=exact,
    )


@family("long")
def free_body_for_long(rng):
    """A body that nobody touches, for ten to two thousand turns."""

    def rates(s, p, t):
        return (
            (p.B - p.C) / p.A * s.y * s.z,
            (p.C - p.A) / p.B * s.z * s.x,
            (p.A - p.B) / p.C * s.x * s.y,
        )

    def exact(mp, s, p, t):
        return closed_forms.free_body(mp, (p.A, p.B, p.C), (s.x, s.y, s.z), t)

    model = Model(
        "free body",
        {"A": 1.0, "B": rng.uniform(1.2, 1.8), "C": rng.uniform(2.0, 2.5)},
        ("x", "y", "z"),
        rates,
    )
    return Case(
        model,
        2 * math.pi * decades(rng, 10.0, 2e3),
        (rng.uniform(0.2, 1.0), rng.uniform(-0.5, 0.5), rng.uniform(0.6, 2.0)),
        exact=exact,
    )


@family("long", "stiff")
def damped_for_long(rng):
    """It comes to rest long before the end: its last state is a tiny part of the first."""
    w = decades(rng, 0.1, 10.0)
    model = second_order(
        "damped",
        {"k": w * w, "c": w * rng.uniform(0.02, 0.2)},
        ("x",),
        lambda s, p, t: (-p.k * s.x - 2 * p.c * s.dx,),
    )

    def exact(mp, s, p, t):
        return closed_forms.damped(mp, mp.sqrt(p.k), p.c, s.x, s.dx, t)

    return Case(model, decades(rng, 100.0, 3e3) / w, (1.0, 0.0), exact=exact)


@family("long")
def slow_beat(rng):
    """Two pendulums that hand their swing to each other through a weak spring, for many beats."""
    model = second_order(
        "two pendulums", {"k": 1.0, "q": decades(rng, 1e-3, 0.1)}, ("x", "y"),
        lambda s, p, t: (-p.k * s.x - p.q * (s.x - s.y), -p.k * s.y - p.q * (s.y - s.x)),
    )  # fmt: skip

    def exact(mp, s, p, t):
        half = mp.mpf(1) / 2
        a = closed_forms.oscillator(mp, mp.sqrt(p.k), (s.x + s.y) * half, (s.dx + s.dy) * half, t)
        b = closed_forms.oscillator(
            mp, mp.sqrt(p.k + 2 * p.q), (s.x - s.y) * half, (s.dx - s.dy) * half, t
        )
        return a[0] + b[0], a[0] - b[0], a[1] + b[1], a[1] - b[1]

    return Case(model, 2 * math.pi * decades(rng, 100.0, 5e3), (1.0, 0.0, 0.0, 0.0), exact=exact)

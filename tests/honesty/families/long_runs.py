"""Many periods: from ten to a million."""

import math

from tests.honesty import models
from tests.honesty.cases import Case, by_accelerations, family


@family("long")
def spring_for_many_swings(rng):
    """A spring for a hundred to ten thousand swings, in a model without a closed form."""
    w = rng.decades(1e-2, 1e2)
    T = 2 * math.pi / w * rng.decades(1e2, 1e4)
    return Case(models.spring(k=w * w), T, (1.0, 0.0), exact=models.exact_spring)


@family("long")
def pendulum_for_many_swings(rng):
    """A pendulum for ten to a few thousand swings of any amplitude."""
    k = rng.decades(0.1, 100.0)
    T, start = 6.3 / k**0.5 * rng.decades(10.0, 3e3), (rng.uniform(0.1, 2.5), 0.0)
    return Case(models.pendulum(k), T, start, exact=models.exact_pendulum)


@family("long")
def planet_for_many_orbits(rng):
    """A planet for ten to a thousand orbits of moderate eccentricity."""
    e, gm = rng.uniform(0.0, 0.6), rng.decades(0.1, 10.0)
    T = 2 * math.pi / gm**0.5 * rng.decades(10.0, 1e3)
    start = 1 + e, 0.0, 0.0, math.sqrt(gm * (1 - e) / (1 + e))
    return Case(models.orbit("planet", gm), T, start, exact=models.exact_orbit)


@family("long")
def free_body_for_many_turns(rng):
    """A body on which no moments act, for ten to two thousand turns."""
    model = models.free_body(1.0, *rng.values((1.2, 1.8), (2.0, 2.5)))
    T = 2 * math.pi * rng.decades(10.0, 2e3)
    start = rng.values((0.2, 1.0), (-0.5, 0.5), (0.6, 2.0))
    return Case(model, T, start, exact=models.exact_free_body)


@family("long", "stiff")
def oscillator_damped_long_ago(rng):
    """An oscillator that comes to rest long before the end: its last state is tiny."""
    w = rng.decades(0.1, 10.0)
    parameters = {"k": w * w, "c": w * rng.uniform(0.02, 0.2)}
    a = lambda s, p, t: (-p.k * s.x - 2 * p.c * s.dx,)
    T = rng.decades(100.0, 3e3) / w
    return by_accelerations(a, parameters, "x", T, (1.0, 0.0), exact=models.exact_damped)


@family("long")
def slow_beat(rng):
    """Two pendulums that exchange their swing through a weak spring, for many beats."""
    parameters = {"k": 1.0, "q": rng.decades(1e-3, 0.1)}
    T, start = 2 * math.pi * rng.decades(100.0, 5e3), (1.0, 0.0, 0.0, 0.0)
    return by_accelerations(models.joined, parameters, "x y", T, start, exact=models.exact_joined)

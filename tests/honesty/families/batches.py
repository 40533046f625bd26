"""Many motions at once: arrays among the parameters or the initial states, over decades."""

import numpy as np

from tests.honesty import models
from tests.honesty.cases import Case, Log, by_rates, family

COUNTS = (3, 64, 70)  # the engine works in one way up to 63, in another from 64 on


@family("batch")
def many_pendulums(rng):
    """Pendulums of lengths over three decades, each from its own angle."""
    n = rng.choice(COUNTS)
    model = models.pendulum(rng.array(n, Log(0.1, 100.0)), "pendulums")
    start = rng.array(n, (-2.5, 2.5)), np.zeros(n)
    return Case(model, rng.uniform(3.0, 12.0), start, exact=models.exact_pendulum)


@family("batch", "tiny")
def amplitudes_over_decades(rng):
    """One spring, many amplitudes from 1e-9 to 1e3."""
    n = rng.choice(COUNTS)
    model, T = models.spring(k=rng.uniform(0.5, 5.0)), rng.uniform(5.0, 40.0)
    return Case(model, T, (rng.array(n, Log(1e-9, 1e3)), np.zeros(n)), exact=models.exact_spring)


@family("batch", "multi-scale")
def many_planets(rng):
    """Ellipses of all sizes about one sun."""
    n = rng.choice(COUNTS)
    e, a = [rng.uniform(0.0, 0.8) for _ in range(n)], [rng.decades(0.3, 1e3) for _ in range(n)]
    far = np.array([b * (1 + f) for f, b in zip(e, a, strict=True)])
    slow = np.array([((1 - f) / (b * (1 + f))) ** 0.5 for f, b in zip(e, a, strict=True)])
    start = far, np.zeros(n), np.zeros(n), slow
    return Case(
        models.orbit("planets", 1.0), rng.uniform(3.0, 20.0), start, exact=models.exact_orbit
    )


@family("batch", "stiff")
def many_relaxations(rng):
    """Van der Pol's oscillator for parameters from 0.1 to 50."""
    n = rng.choice(COUNTS)
    mu = rng.array(n, Log(0.1, 50.0))
    rates = lambda s, p, t: (s.y, p.mu * (1 - s.x * s.x) * s.y - s.x)
    T = rng.uniform(2.0, 15.0)
    return by_rates(rates, {"mu": mu}, "x y", T, (np.array([2.0] * n), rng.array(n, (-1.0, 1.0))))


@family("batch", "kinked")
def many_falls(rng):
    """Light and heavy bodies thrown upwards with drag v |v|."""
    n = rng.choice(COUNTS)
    parameters = {"g": 9.81, "c": rng.array(n, Log(1e-3, 0.5))}
    rates = lambda s, p, t: (s.v, -p.g - p.c * abs(s.v) * s.v)
    T = rng.uniform(2.0, 6.0)
    start = np.zeros(n), rng.array(n, (5.0, 30.0))
    return by_rates(rates, parameters, "h v", T, start)

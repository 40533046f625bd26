"""Many motions at once, of very different character."""

import math

import numpy as np

from newton_euler import cos, exp, sin, where
from tests.honesty import closed_forms, models
from tests.honesty.cases import Case, Log, by_accelerations, by_rates, held_out

COUNTS = (3, 64, 80)


@held_out("batch", "stiff")
def many_dampers(rng):
    """Springs from soft to stiff, barely damped to almost critically."""
    n = rng.choice(COUNTS)
    w = rng.array(n, Log(0.1, 1e2))
    c = w * rng.array(n, Log(1e-4, 0.99))
    a = lambda s, p, t: (-2 * p.c * s.dx - p.w * p.w * s.x,)

    def exact(mp, s, p, t):
        return closed_forms.damped(mp, p.w, p.c, s.x, s.dx, t)

    start = rng.array(n, (-1.0, 1.0)), np.zeros(n)
    return by_accelerations(a, {"w": w, "c": c}, "x", rng.uniform(1.0, 5.0), start, exact=exact)


@held_out("batch", "kinked", "sticking")
def many_tanks(rng):
    """Tanks of which some run empty soon, some never."""
    n = rng.choice(COUNTS)
    c = rng.array(n, Log(1e-2, 3.0))

    def exact(mp, s, p, t):
        return (max(mp.sqrt(s.h) - p.c * t / 2, mp.mpf(0)) ** 2,)

    rates = lambda s, p, t: (where(s.h > 0, -p.c * where(s.h > 0, s.h, 0.0) ** 0.5, 0.0),)
    T = rng.uniform(0.5, 2.0)
    return by_rates(rates, {"c": c}, "h", T, (rng.array(n, (0.2, 2.0)),), exact=exact)


@held_out("batch", "separatrix")
def pendulums_of_all_kinds(rng):
    """Pendulums at rest, swinging a little, next to upright and turning, in one batch."""
    n = rng.choice(COUNTS)
    kinds = [rng.randrange(4) for _ in range(n)]
    kinds[:2] = 0, 2
    angle = lambda: (0.0, rng.uniform(-0.1, 0.1), math.pi - rng.decades(1e-6, 1e-2), 0.0)
    angles = np.array([angle()[k] for k in kinds])
    speeds = np.array([(1e-9, 0.0, 0.0, rng.uniform(2.2, 20.0))[k] for k in kinds])
    model = models.pendulum(1.0, "all kinds")
    return Case(model, rng.uniform(2.0, 15.0), (angles, speeds), exact=models.exact_pendulum)


@held_out("batch", "kinked")
def many_springs_with_a_stop(rng):
    """Masses with a stop each, soft or hard, some never reached, some all the time."""
    n = rng.choice(COUNTS)
    parameters = {"gap": rng.array(n, Log(0.05, 5.0)), "k": rng.array(n, Log(1.0, 1e4))}
    a = lambda s, p, t: (cos(t) - s.x - p.k * where(s.x > p.gap, s.x - p.gap, 0.0),)
    T = rng.uniform(3.0, 12.0)
    start = np.zeros(n), rng.array(n, (-1.0, 1.0))
    return by_accelerations(a, parameters, "x", T, start)


@held_out("batch", "near-singular", "units")
def many_comets(rng):
    """Ellipses about the Sun in metres, of eccentricity 0 to 0.99, for one time."""
    n, gm, au = rng.choice(COUNTS), 1.32712440018e20, 1.495978707e11
    e = [rng.choice((0.0, rng.uniform(0.0, 0.99))) for _ in range(n)]
    a = [au * rng.decades(0.5, 30.0) for _ in range(n)]

    far = np.array([b * (1 + f) for f, b in zip(e, a, strict=True)])
    slow = np.array([math.sqrt(gm / b * (1 - f) / (1 + f)) for f, b in zip(e, a, strict=True)])
    start = far, np.zeros(n), np.zeros(n), slow
    T = rng.decades(1e7, 1e8)
    return by_accelerations(models.by_power, {"GM": gm}, "x y", T, start, exact=models.exact_orbit)


@held_out("batch", "tiny")
def many_growths(rng):
    """Logistic growth from 1e-12 to beyond the limit, slow and fast."""
    n = rng.choice(COUNTS)
    r, x = rng.array(n, Log(0.01, 10.0)), rng.array(n, Log(1e-12, 3.0))
    x[0] = rng.choice((0.0, 1.0, x[0]))

    def exact(mp, s, p, t):
        return (s.x / (s.x + (1 - s.x) * mp.exp(-p.r * t)) if s.x else mp.mpf(0),)

    T = rng.uniform(1.0, 20.0)
    return by_rates(lambda s, p, t: (p.r * s.x * (1 - s.x),), {"r": r}, "x", T, (x,), exact=exact)


@held_out("batch", "forced")
def many_pulses(rng):
    """Masses at rest that are pushed at different times, early or late, or not at all."""
    n, T = rng.choice(COUNTS), rng.uniform(10.0, 30.0)
    at = [T * rng.uniform(0.1, 0.95) for _ in range(n)]
    F = np.array([rng.choice((0.0, 1.0, -1.0)) for _ in range(n)])
    width = T * rng.decades(0.01, 0.05)

    def accelerations(s, p, t):
        u = (t - p.at) / p.w
        return (p.F * exp(-u * u) - s.x,)

    parameters = {"at": np.array(at), "w": width, "F": F}
    judged = {at[i] for i in {0, 1, n // 2, n - 1}}
    knots = sorted(a + width * k / 2 for a in judged for k in range(-22, 23))
    start = np.zeros(n), np.zeros(n)
    return by_accelerations(accelerations, parameters, "x", T, start, knots=knots)


@held_out("batch", "chaotic")
def many_double_pendulums(rng):
    """Double pendulums from hanging still to thrown over."""
    n = rng.choice((3, 64))

    def accelerations(s, p, t):
        d = s.a - s.b
        c, k = cos(d), sin(d)
        den = 2 - c * c
        A = -(p.g * (2 * sin(s.a) - sin(s.b) * c) + k * (s.db * s.db + s.da * s.da * c)) / den
        return A, (2 * p.g * (sin(s.a) * c - sin(s.b)) + k * (2 * s.da * s.da + s.db**2 * c)) / den

    a = rng.array(n, Log(1e-4, 2.5))
    a[0] = 0.0
    b = np.array([x * rng.uniform(-1, 1) for x in a])
    T = rng.uniform(0.5, 1.5)
    return by_accelerations(accelerations, {"g": 9.81}, "a b", T, (a, b, np.zeros(n), np.zeros(n)))

"""Models with one fast rate that has died out, or that never does."""

import math

from newton_euler import cos, sin, sqrt
from tests.honesty.cases import Log, by_accelerations, by_rates, family


@family("stiff")
def van_der_pol(rng):
    """Van der Pol's relaxation oscillations, over part of a period or a little more."""
    mu, T, v = rng.values(Log(5.0, 300.0), (0.3, 2.0), (-0.5, 0.5))
    rates = lambda s, p, t: (s.y, p.mu * (1 - s.x * s.x) * s.y - s.x)
    return by_rates(rates, {"mu": mu}, "x y", mu * T, (2.0, v))


@family("stiff")
def robertson(rng):
    """Three substances whose rates lie nine decades apart; the fast one is slowed in some draws."""
    parameters = {"a": 0.04, "b": 1e4, "c": 3e7 / rng.decades(1.0, 1e3)}

    def rates(s, p, t):
        slow, back, fast = p.a * s.x, p.b * s.y * s.z, p.c * s.y * s.y
        return back - slow, slow - back - fast, fast

    return by_rates(rates, parameters, "x y z", rng.decades(0.1, 3.0), (1.0, 0.0, 0.0))


@family("stiff", "forced")
def fast_relaxation(rng):
    """A relaxation towards cos(w t), at a rate of 1e2 to 1e5 (Prothero and Robinson)."""
    parameters = rng.parameters(L=Log(1e2, 1e5), w=(0.5, 3.0))
    rates = lambda s, p, t: (-p.L * (s.x - cos(p.w * t)) - p.w * sin(p.w * t),)
    exact = lambda mp, s, p, t: (mp.cos(p.w * t) + (s.x - 1) * mp.exp(-p.L * t),)
    T, x = rng.values((1.0, 10.0), (-1.0, 2.0))
    return by_rates(rates, parameters, "x", min(T, 2e5 / parameters["L"]), (x,), exact=exact)


@family("stiff")
def chain_of_decays(rng):
    """One nucleus after the other, with half-lives from short to long."""
    parameters = rng.parameters(a=Log(10.0, 1e4), b=Log(0.1, 10.0), c=Log(1e-3, 0.1))
    rates = lambda s, p, t: (-p.a * s.x, p.a * s.x - p.b * s.y, p.b * s.y - p.c * s.z)

    def exact(mp, s, p, t):
        a, b, c = (mp.exp(-k * t) for k in (p.a, p.b, p.c))
        y = p.a / (p.b - p.a) * (a - b)
        z = a / ((p.b - p.a) * (p.c - p.a)) + b / ((p.a - p.b) * (p.c - p.b))
        z = p.a * p.b * (z + c / ((p.a - p.c) * (p.b - p.c)))
        return s.x * a, s.x * y, s.x * z

    T, x = rng.values((1.0, 10.0), Log(1e-3, 1e3))
    start = x, 0.0, 0.0
    return by_rates(rates, parameters, "x y z", min(T, 2e4 / parameters["a"]), start, exact=exact)


@family("stiff", "multi-scale")
def elastic_pendulum(rng):
    """A pendulum on a stiff spring, which vibrates while it swings."""
    parameters = rng.parameters(k=Log(1e2, 1e5), g=9.81, L=1.0)

    def accelerations(s, p, t):
        r = sqrt(s.x * s.x + s.y * s.y)
        pull = p.k * (r - p.L) / r
        return -pull * s.x, -pull * s.y - p.g

    a, stretch, T = rng.values((0.2, 1.2), (-0.01, 0.02), (0.5, 4.0))
    start = (1 + stretch) * math.sin(a), -(1 + stretch) * math.cos(a), 0.0, 0.0
    return by_accelerations(accelerations, parameters, "x y", T, start)


@family("stiff")
def damped_hard(rng):
    """A door with a closer: over-damped some thirty to seven thousand times."""
    parameters = rng.parameters(k=(0.5, 3.0), c=Log(1e2, 1e4))
    a = lambda s, p, t: (-p.k * s.x - p.c * s.dx,)

    def exact(mp, s, p, t):
        root = mp.sqrt(p.c * p.c / 4 - p.k)
        fast, slow = -p.c / 2 - root, -p.k / (p.c / 2 + root)
        a = (s.dx - slow * s.x) / (fast - slow)
        a, b = a * mp.exp(fast * t), (s.x - a) * mp.exp(slow * t)
        return a + b, a * fast + b * slow

    T, v = rng.values((1.0, 20.0), (-2.0, 2.0))
    T = min(T, 3e4 / parameters["c"])
    return by_accelerations(a, parameters, "x", T, (1.0, v), exact=exact)

"""Tiny states, and states that begin at zero or stay there."""

from newton_euler import cos, sin
from tests.honesty import models
from tests.honesty.cases import Case, Log, by_accelerations, by_rates, family


@family("tiny")
def tiny_spring(rng):
    """A spring that swings by 1e-14 to 1e-6."""
    w, a, T, v = rng.values(Log(0.1, 10.0), Log(1e-14, 1e-6), (5.0, 60.0), (-1.0, 1.0))
    model = models.spring("tiny spring", k=w * w)
    return Case(model, T / w, (a, a * w * v), exact=models.exact_spring)


@family("tiny", "multi-scale")
def tiny_beside_ordinary(rng):
    """A seismograph: an ordinary pendulum shakes a mass by a billionth of its swing."""
    parameters = rng.parameters(k=(1.0, 10.0), K=(2.0, 30.0), q=Log(1e-12, 1e-6), c=0.1)
    a = lambda s, p, t: (-p.k * sin(s.x), -p.K * s.y - p.c * s.dy + p.q * s.x)
    T, x = rng.values((5.0, 30.0), (0.3, 2.0))
    return by_accelerations(a, parameters, "x y", T, (x, 0.0, 0.0, 0.0))


@family("tiny", "forced")
def all_zero_at_first(rng):
    """An oscillator whose states are all zero until a force sets it going."""
    parameters = rng.parameters(k=(1.0, 10.0), c=(0.0, 0.3), F=Log(1e-9, 1e3), w=(0.5, 3.0))
    a = lambda s, p, t: (p.F * sin(p.w * t) - p.k * s.x - p.c * s.dx,)
    return by_accelerations(a, parameters, "x", rng.uniform(3.0, 30.0), (0.0, 0.0))


@family("tiny", "equilibrium")
def one_state_stays_zero(rng):
    """A spherical pendulum in a plane: the other coordinate and its rate stay zero."""
    stiffness = lambda s, p: p.k + p.b * (s.x * s.x + s.y * s.y)
    a = lambda s, p, t: (-s.x * stiffness(s, p), -s.y * stiffness(s, p))
    parameters = rng.parameters(k=(0.5, 10.0), b=(-0.2, 0.2))
    T, x = rng.values((5.0, 40.0), (0.2, 1.0))
    return by_accelerations(a, parameters, "x y", T, (x, 0.0, 0.0, 0.0))


@family("tiny")
def growth_from_almost_nothing(rng):
    """Logistic growth that starts from 1e-12 to 1e-4 of its limit."""
    r, K, T, x = rng.values(Log(0.1, 10.0), Log(1e-3, 1e3), (5.0, 40.0), Log(1e-12, 1e-4))
    rates = lambda s, p, t: (p.r * s.x * (p.K - s.x) / p.K,)
    return by_rates(rates, {"r": r, "K": K}, "x", T / r, (K * x,), exact=models.exact_growth)


@family("tiny", "equilibrium")
def weak_drive_at_rest(rng):
    """A pendulum hangs at rest, and a force of 1e-10 to 1e-3 sets it swinging."""
    parameters = rng.parameters(k=(1.0, 10.0), F=Log(1e-10, 1e-3), w=(0.5, 2.0))
    rates = lambda s, p, t: (s.omega, -p.k * sin(s.theta) + p.F * cos(p.w * t))
    return by_rates(rates, parameters, "theta omega", rng.uniform(5.0, 30.0), (0.0, 0.0))


@family("tiny", "multi-scale")
def three_sizes(rng):
    """Three oscillators, decades apart in size, coupled from the large to the small."""
    parameters = rng.parameters(k=(0.5, 4.0), a=Log(1e-8, 1e-2), b=Log(1e-8, 1e-2))
    a = lambda s, p, t: (-p.k * s.x, -2 * p.k * s.y + p.a * s.x, -3 * p.k * s.z + p.b * s.y)
    T, x = rng.values((5.0, 30.0), Log(1e-3, 1e3))
    return by_accelerations(a, parameters, "x y z", T, (rng.either(x), 0.0, 0.0, 0.0, 0.0, 0.0))

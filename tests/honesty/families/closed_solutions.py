"""Models that bring their exact solution, over up to a billion periods, and events on
them.
"""

import math

from newton_euler.scenes.particles.orbit import orbit
from newton_euler.scenes.planar.pendulum import physical_pendulum
from newton_euler.scenes.spatial.free_body import free_body
from tests.honesty import closed_forms, models
from tests.honesty.cases import Case, Log, family
from tests.honesty.families.events import LOWEST_PLACE, crossings


def _spring(rng):
    w = rng.decades(1e-2, 1e2)
    line = rng.uniform(-0.8, 0.8)
    return models.spring("spring with its solution", closed=True, k=w * w, line=line), w


def _pendulum(rng):
    k = rng.decades(0.1, 100.0)
    return physical_pendulum(2.0, 0.5, 0.5, k), math.sqrt(k)  # whose stiffness is k


def _stiffness(p):
    return p.m * p.g * p.l / (p.I + p.m * p.l * p.l)


def _exact_pendulum(mp, s, p, t):
    return closed_forms.pendulum(mp, _stiffness(p), s.theta, s.omega, t)


@family("long", "closed form")
def spring_by_its_closed_form(rng):
    """A spring for ten to a billion swings, by its closed form."""
    model, w = _spring(rng)
    T = 2 * math.pi / w * rng.decades(10.0, 1e9)
    return Case(
        model, T, (rng.uniform(-1.0, 1.0), rng.uniform(-1.0, 1.0) * w), exact=models.exact_spring
    )


@family("long", "closed form")
def pendulum_by_its_closed_form(rng):
    """A pendulum for ten to a hundred million swings or turns, by elliptic functions."""
    model, w = _pendulum(rng)
    T, theta = rng.values(Log(10.0, 1e8), (-2.8, 2.8))
    start = theta, rng.choice((0.0, rng.uniform(-3.0, 3.0) * w))
    return Case(model, 6.3 / w * T, start, exact=_exact_pendulum)


@family("long", "closed form")
def free_body_by_its_closed_form(rng):
    """A free body for ten to a million turns, by elliptic functions, some near the separatrix."""

    def exact(mp, s, p, t):
        return closed_forms.free_body(mp, (p.I_x, p.I_y, p.I_z), (s.w_x, s.w_y, s.w_z), t)

    model = free_body(1.0, *rng.values((1.2, 1.8), (2.0, 2.5)))
    tilt, T, spin = rng.values(Log(1e-6, 1.0), Log(10.0, 1e6), (0.5, 1.5))
    start = tilt, rng.either(spin), tilt * rng.uniform(0.3, 3.0)
    return Case(model, 2 * math.pi * T, start, exact=exact)


@family("long", "closed form")
def orbit_by_its_closed_form(rng):
    """One to a million orbits, by Kepler's equation, of eccentricity up to 0.95."""

    def exact(mp, s, p, t):
        return closed_forms.kepler(mp, p.mu, (s.x, s.y), (s.v_x, s.v_y), t)

    e, mu, T = rng.values((0.0, 0.95), Log(0.1, 10.0), Log(1.0, 1e6))
    start = 1 + e, 0.0, 0.0, math.sqrt(mu * (1 - e) / (1 + e))
    return Case(orbit(mu), 2 * math.pi / mu**0.5 * T, start, exact=exact)


@family("events", "closed form")
def zeros_of_a_spring_by_its_closed_form(rng):
    """Tens to thousands of passages through a line, by a motion that takes no steps."""
    model, w = _spring(rng)
    return crossings(model, 2 * math.pi / w * rng.decades(5.0, 2e3))


@family("events", "closed form")
def zeros_of_a_pendulum_by_its_closed_form(rng):
    """A pendulum to T = 30 to 3000; every passage of the lowest point must be found."""
    model, _ = _pendulum(rng)
    T, theta = rng.values(Log(30.0, 3000.0), (0.2, 2.8))

    def times(mp, s, p):
        return closed_forms.pendulum_zeros(mp, _stiffness(p), s.theta, s.omega, mp.mpf(T))

    known = {"exact": _exact_pendulum, "event_times": times}
    return Case(model, T, (theta, 0.0), events=(LOWEST_PLACE,), **known)

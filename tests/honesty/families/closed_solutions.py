"""Models that bring their exact solution, over up to a thousand million periods, and events on
them.
"""

import math

from newton_euler import Event, cos, sin, sqrt
from newton_euler.motion import second_order
from tests.honesty import closed_forms, engine
from tests.honesty.cases import Case, decades, either, family


def _spring(rng):
    w = decades(rng, 1e-2, 1e2)

    def solution(s, p, t):
        n = sqrt(p.k)
        return s.x * cos(n * t) + s.dx / n * sin(n * t), s.dx * cos(n * t) - n * s.x * sin(n * t)

    def exact(mp, s, p, t):
        return closed_forms.oscillator(mp, mp.sqrt(p.k), s.x, s.dx, t)

    parameters = {"k": w * w, "line": rng.uniform(-0.8, 0.8)}
    return (
        second_order(
            "spring with its solution",
            parameters,
            ("x",),
            lambda s, p, t: (-p.k * s.x,),
            exact=solution,
        ),
        exact,
        w,
    )


def _pendulum(rng):
    k = decades(rng, 0.1, 100.0)

    def exact(mp, s, p, t):
        return closed_forms.pendulum(
            mp, p.m * p.g * p.l / (p.I + p.m * p.l * p.l), s.theta, s.omega, t
        )

    return engine.physical_pendulum(2.0, 0.5, 0.5, k), exact, math.sqrt(k)  # whose stiffness is k


@family("long", "closed form")
def spring_by_its_closed_form(rng):
    """Ten to a thousand million swings."""
    model, exact, w = _spring(rng)
    return Case(
        model,
        2 * math.pi / w * decades(rng, 10.0, 1e9),
        (rng.uniform(-1.0, 1.0), rng.uniform(-1.0, 1.0) * w),
        exact=exact,
    )


@family("long", "closed form")
def pendulum_by_its_closed_form(rng):
    """Ten to a hundred million swings or turns, by elliptic functions."""
    model, exact, w = _pendulum(rng)
    return Case(
        model,
        6.3 / w * decades(rng, 10.0, 1e8),
        (rng.uniform(-2.8, 2.8), rng.choice((0.0, rng.uniform(-3.0, 3.0) * w))),
        exact=exact,
    )


@family("long", "closed form")
def free_body_by_its_closed_form(rng):
    """Ten to a million turns, by elliptic functions, now and then beside the separatrix."""

    def exact(mp, s, p, t):
        return closed_forms.free_body(mp, (p.I_x, p.I_y, p.I_z), (s.w_x, s.w_y, s.w_z), t)

    model = engine.free_body(1.0, rng.uniform(1.2, 1.8), rng.uniform(2.0, 2.5))
    tilt = decades(rng, 1e-6, 1.0)
    return Case(
        model,
        2 * math.pi * decades(rng, 10.0, 1e6),
        (tilt, either(rng, rng.uniform(0.5, 1.5)), tilt * rng.uniform(0.3, 3.0)),
        exact=exact,
    )


@family("long", "closed form")
def orbit_by_its_closed_form(rng):
    """One to a million orbits, by Kepler's equation, of eccentricity up to 0.95."""

    def exact(mp, s, p, t):
        return closed_forms.kepler(mp, p.mu, (s.x, s.y), (s.v_x, s.v_y), t)

    e, mu = rng.uniform(0.0, 0.95), decades(rng, 0.1, 10.0)
    return Case(
        engine.orbit(mu),
        2 * math.pi / mu**0.5 * decades(rng, 1.0, 1e6),
        (1 + e, 0.0, 0.0, math.sqrt(mu * (1 - e) / (1 + e))),
        exact=exact,
    )


@family("events", "closed form")
def zeros_of_a_spring_by_its_closed_form(rng):
    """Tens to thousands of passages through a line, of a motion that takes no steps."""
    model, exact, w = _spring(rng)
    T = 2 * math.pi / w * decades(rng, 5.0, 2e3)

    return Case(
        model,
        T,
        (1.0, 0.0),
        exact=exact,
        events=(Event(lambda s, p, t: s.x - p.line),),
        event_times=closed_forms.crossings_of_a_spring(T),
    )


@family("events", "closed form")
def zeros_of_a_pendulum_by_its_closed_form(rng):
    """A pendulum to T = 30 to 3000; every passage of the lowest place is to be found."""
    model, exact, _ = _pendulum(rng)
    T = decades(rng, 30.0, 3000.0)

    def times(mp, s, p):
        return closed_forms.pendulum_zeros(
            mp, p.m * p.g * p.l / (p.I + p.m * p.l * p.l), s.theta, s.omega, mp.mpf(T)
        )

    event = Event(lambda s, p, t: s.theta, name="lowest place")
    return Case(
        model, T, (rng.uniform(0.2, 2.8), 0.0), exact=exact, events=(event,), event_times=times
    )

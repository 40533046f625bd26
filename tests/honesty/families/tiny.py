"""Tiny states, and states that begin at zero or stay there."""

from newton_euler import Model, cos, sin
from newton_euler.motion import second_order
from tests.honesty import closed_forms
from tests.honesty.cases import Case, decades, either, family


@family("tiny")
def tiny_spring(rng):
    """An oscillation of 1e-14 to 1e-6."""
    w, a = decades(rng, 0.1, 10.0), decades(rng, 1e-14, 1e-6)
    model = second_order("tiny spring", {"k": w * w}, ("x",), lambda s, p, t: (-p.k * s.x,))

    def exact(mp, s, p, t):
        return closed_forms.oscillator(mp, mp.sqrt(p.k), s.x, s.dx, t)

    return Case(model, rng.uniform(5.0, 60.0) / w, (a, a * w * rng.uniform(-1.0, 1.0)), exact=exact)


@family("tiny", "multi-scale")
def tiny_beside_ordinary(rng):
    """A seismograph: an ordinary pendulum shakes a mass by a billionth of its swing."""
    parameters = {
        "k": rng.uniform(1.0, 10.0),
        "K": rng.uniform(2.0, 30.0),
        "q": decades(rng, 1e-12, 1e-6),
        "c": 0.1,
    }
    model = second_order(
        "seismograph",
        parameters,
        ("x", "y"),
        lambda s, p, t: (-p.k * sin(s.x), -p.K * s.y - p.c * s.dy + p.q * s.x),
    )
    return Case(model, rng.uniform(5.0, 30.0), (rng.uniform(0.3, 2.0), 0.0, 0.0, 0.0))


@family("tiny", "forced")
def all_zero_at_first(rng):
    """Everything is zero until a force sets it going."""
    parameters = {
        "k": rng.uniform(1.0, 10.0),
        "c": rng.uniform(0.0, 0.3),
        "F": decades(rng, 1e-9, 1e3),
        "w": rng.uniform(0.5, 3.0),
    }
    model = second_order(
        "from rest",
        parameters,
        ("x",),
        lambda s, p, t: (p.F * sin(p.w * t) - p.k * s.x - p.c * s.dx,),
    )
    return Case(model, rng.uniform(3.0, 30.0), (0.0, 0.0))


@family("tiny", "equilibrium")
def one_state_stays_zero(rng):
    """A spherical pendulum that swings in a plane.

    The other coordinate and its rate are zero for ever.
    """
    model = second_order(
        "plane swing",
        {"k": rng.uniform(0.5, 10.0), "b": rng.uniform(-0.2, 0.2)},
        ("x", "y"),
        lambda s, p, t: (
            -s.x * (p.k + p.b * (s.x * s.x + s.y * s.y)),
            -s.y * (p.k + p.b * (s.x * s.x + s.y * s.y)),
        ),
    )
    return Case(model, rng.uniform(5.0, 40.0), (rng.uniform(0.2, 1.0), 0.0, 0.0, 0.0))


@family("tiny")
def growth_from_almost_nothing(rng):
    """From 1e-12 to 1e-4 of its limit up to it."""
    r, K = decades(rng, 0.1, 10.0), decades(rng, 1e-3, 1e3)
    model = Model(
        "growth", {"r": r, "K": K}, ("x",), lambda s, p, t: (p.r * s.x * (p.K - s.x) / p.K,)
    )

    def exact(mp, s, p, t):
        e = mp.exp(-p.r * t)
        return (p.K * s.x / (s.x + (p.K - s.x) * e),)

    return Case(model, rng.uniform(5.0, 40.0) / r, (K * decades(rng, 1e-12, 1e-4),), exact=exact)


@family("tiny", "equilibrium")
def weak_drive_at_rest(rng):
    """A pendulum hangs at rest, and a force of 1e-10 to 1e-3 sets it swinging."""
    parameters = {
        "k": rng.uniform(1.0, 10.0),
        "F": decades(rng, 1e-10, 1e-3),
        "w": rng.uniform(0.5, 2.0),
    }
    model = Model(
        "weak drive",
        parameters,
        ("theta", "omega"),
        lambda s, p, t: (s.omega, -p.k * sin(s.theta) + p.F * cos(p.w * t)),
    )
    return Case(model, rng.uniform(5.0, 30.0), (0.0, 0.0))


@family("tiny", "multi-scale")
def three_sizes(rng):
    """Three oscillators of one frequency whose sizes lie decades apart, coupled from the large to
    the small.
    """
    parameters = {
        "k": rng.uniform(0.5, 4.0),
        "a": decades(rng, 1e-8, 1e-2),
        "b": decades(rng, 1e-8, 1e-2),
    }
    model = second_order(
        "three sizes",
        parameters,
        ("x", "y", "z"),
        lambda s, p, t: (-p.k * s.x, -2 * p.k * s.y + p.a * s.x, -3 * p.k * s.z + p.b * s.y),
    )
    return Case(
        model,
        rng.uniform(5.0, 30.0),
        (either(rng, decades(rng, 1e-3, 1e3)), 0.0, 0.0, 0.0, 0.0, 0.0),
    )

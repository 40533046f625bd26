"""Models with one fast rate that has died out, or that never does."""

import math

from newton_euler import Model, cos, sin, sqrt
from newton_euler.motion import second_order
from tests.honesty.cases import Case, decades, family


@family("stiff")
def van_der_pol(rng):
    """Relaxation oscillations, over part of a period or a little more."""
    mu = decades(rng, 5.0, 300.0)
    model = Model(
        "van der Pol",
        {"mu": mu},
        ("x", "y"),
        lambda s, p, t: (s.y, p.mu * (1 - s.x * s.x) * s.y - s.x),
    )
    return Case(model, mu * rng.uniform(0.3, 2.0), (2.0, rng.uniform(-0.5, 0.5)))


@family("stiff")
def robertson(rng):
    """Three substances whose rates lie nine decades apart, its fast one eased here and there."""
    parameters = {"a": 0.04, "b": 1e4, "c": 3e7 / decades(rng, 1.0, 1e3)}

    def rates(s, p, t):
        slow, back, fast = p.a * s.x, p.b * s.y * s.z, p.c * s.y * s.y
        return back - slow, slow - back - fast, fast

    return Case(
        Model("Robertson", parameters, ("x", "y", "z"), rates),
        decades(rng, 0.1, 3.0),
        (1.0, 0.0, 0.0),
    )


@family("stiff", "forced")
def fast_relaxation(rng):
    """Drawn towards cos(w t) at a rate a thousand to a million times as fast as that changes
    (Prothero and Robinson).
    """
    parameters = {"L": decades(rng, 1e2, 1e5), "w": rng.uniform(0.5, 3.0)}
    model = Model(
        "fast relaxation",
        parameters,
        ("x",),
        lambda s, p, t: (-p.L * (s.x - cos(p.w * t)) - p.w * sin(p.w * t),),
    )

    def exact(mp, s, p, t):
        return (mp.cos(p.w * t) + (s.x - 1) * mp.exp(-p.L * t),)

    return Case(
        model,
        min(rng.uniform(1.0, 10.0), 2e5 / parameters["L"]),
        (rng.uniform(-1.0, 2.0),),
        exact=exact,
    )


@family("stiff")
def chain_of_decays(rng):
    """One nucleus after the other, with half-lives from short to long."""
    parameters = {
        "a": decades(rng, 10.0, 1e4),
        "b": decades(rng, 0.1, 10.0),
        "c": decades(rng, 1e-3, 0.1),
    }
    model = Model(
        "decays",
        parameters,
        ("x", "y", "z"),
        lambda s, p, t: (-p.a * s.x, p.a * s.x - p.b * s.y, p.b * s.y - p.c * s.z),
    )

    def exact(mp, s, p, t):
        a, b, c = (mp.exp(-k * t) for k in (p.a, p.b, p.c))
        y = p.a / (p.b - p.a) * (a - b)
        z = (
            p.a
            * p.b
            * (
                a / ((p.b - p.a) * (p.c - p.a))
                + b / ((p.a - p.b) * (p.c - p.b))
                + c / ((p.a - p.c) * (p.b - p.c))
            )
        )
        return s.x * a, s.x * y, s.x * z

    return Case(
        model,
        min(rng.uniform(1.0, 10.0), 2e4 / parameters["a"]),
        (decades(rng, 1e-3, 1e3), 0.0, 0.0),
        exact=exact,
    )


@family("stiff", "multi-scale")
def elastic_pendulum(rng):
    """A pendulum on a stiff spring, which sings while it swings."""
    parameters = {"k": decades(rng, 1e2, 1e5), "g": 9.81, "L": 1.0}

    def accelerations(s, p, t):
        r = sqrt(s.x * s.x + s.y * s.y)
        pull = p.k * (r - p.L) / r
        return -pull * s.x, -pull * s.y - p.g

    model = second_order("elastic pendulum", parameters, ("x", "y"), accelerations)
    a, stretch = rng.uniform(0.2, 1.2), 1 + rng.uniform(-0.01, 0.02)
    return Case(
        model, rng.uniform(0.5, 4.0), (stretch * math.sin(a), -stretch * math.cos(a), 0.0, 0.0)
    )


@family("stiff")
def damped_hard(rng):
    """A door with a closer: over-damped a hundred to ten thousand times."""
    parameters = {"k": rng.uniform(0.5, 3.0), "c": decades(rng, 1e2, 1e4)}
    model = second_order("door", parameters, ("x",), lambda s, p, t: (-p.k * s.x - p.c * s.dx,))

    def exact(mp, s, p, t):
        root = mp.sqrt(p.c * p.c / 4 - p.k)
        fast, slow = -p.c / 2 - root, -p.k / (p.c / 2 + root)
        a = (s.dx - slow * s.x) / (fast - slow)
        b = s.x - a
        return a * mp.exp(fast * t) + b * mp.exp(slow * t), a * fast * mp.exp(
            fast * t
        ) + b * slow * mp.exp(slow * t)

    return Case(
        model,
        min(rng.uniform(1.0, 20.0), 3e4 / parameters["c"]),
        (1.0, rng.uniform(-2.0, 2.0)),
        exact=exact,
    )

"""Many motions at once: arrays among the parameters or in the start, over decades."""

from newton_euler import Model, sin, sqrt
from newton_euler.motion import second_order
from tests.honesty import closed_forms
from tests.honesty.cases import Branches, Case, decades, family

COUNTS = (3, 64, 70)  # up to 63 and from 64 on the engine takes two ways


def _array(values):
    import numpy as np

    return np.array(values)


@family("batch")
def many_pendulums(rng):
    """Pendulums of lengths over three decades, each from its own angle."""
    n = rng.choice(COUNTS)
    k = _array([decades(rng, 0.1, 100.0) for _ in range(n)])
    model = Model(
        "pendulums", {"k": k}, ("theta", "omega"), lambda s, p, t: (s.omega, -p.k * sin(s.theta))
    )

    def exact(mp, s, p, t):
        return closed_forms.pendulum(mp, p.k, s.theta, s.omega, t)

    start = _array([rng.uniform(-2.5, 2.5) for _ in range(n)]), _array([0.0] * n)
    return Case(model, rng.uniform(3.0, 12.0), start, exact=exact)


@family("batch", "tiny")
def amplitudes_over_decades(rng):
    """One spring, many amplitudes from 1e-9 to 1e3."""
    n = rng.choice(COUNTS)
    model = second_order(
        "spring", {"k": rng.uniform(0.5, 5.0)}, ("x",), lambda s, p, t: (-p.k * s.x,)
    )

    def exact(mp, s, p, t):
        return closed_forms.oscillator(mp, mp.sqrt(p.k), s.x, s.dx, t)

    return Case(
        model,
        rng.uniform(5.0, 40.0),
        (_array([decades(rng, 1e-9, 1e3) for _ in range(n)]), _array([0.0] * n)),
        exact=exact,
    )


@family("batch", "multi-scale")
def many_planets(rng):
    """Ellipses of all sizes round one sun."""
    n = rng.choice(COUNTS)
    e, a = [rng.uniform(0.0, 0.8) for _ in range(n)], [decades(rng, 0.3, 1e3) for _ in range(n)]

    def accelerations(s, p, t):
        r2 = s.x * s.x + s.y * s.y
        return -p.GM * s.x / (r2 * sqrt(r2)), -p.GM * s.y / (r2 * sqrt(r2))

    def exact(mp, s, p, t):
        return closed_forms.kepler(mp, p.GM, (s.x, s.y), (s.dx, s.dy), t)

    model = second_order("planets", {"GM": 1.0}, ("x", "y"), accelerations)
    far = _array([b * (1 + f) for f, b in zip(e, a, strict=True)])
    slow = _array([((1 - f) / (b * (1 + f))) ** 0.5 for f, b in zip(e, a, strict=True)])
    start = far, _array([0.0] * n), _array([0.0] * n), slow
    return Case(model, rng.uniform(3.0, 20.0), start, exact=exact)


@family("batch", "stiff")
def many_relaxations(rng):
    """Van der Pol's oscillator for parameters from 0.1 to 50."""
    n = rng.choice(COUNTS)
    mu = _array([decades(rng, 0.1, 50.0) for _ in range(n)])
    model = Model(
        "van der Pol, many",
        {"mu": mu},
        ("x", "y"),
        lambda s, p, t: (s.y, p.mu * (1 - s.x * s.x) * s.y - s.x),
    )
    return Case(
        model,
        rng.uniform(2.0, 15.0),
        (_array([2.0] * n), _array([rng.uniform(-1.0, 1.0) for _ in range(n)])),
    )


@family("batch", "kinked")
def many_falls(rng):
    """Bodies thrown upwards with drag v |v|, light and heavy ones."""
    n = rng.choice(COUNTS)
    c = _array([decades(rng, 1e-3, 0.5) for _ in range(n)])
    branches = Branches(
        (lambda s, p, t: s.v,), lambda s, p, t, b: (s.v, -p.g - p.c * b[0] * s.v * s.v)
    )
    model = Model(
        "throws",
        {"g": 9.81, "c": c},
        ("h", "v"),
        lambda s, p, t: (s.v, -p.g - p.c * abs(s.v) * s.v),
    )
    return Case(
        model,
        rng.uniform(2.0, 6.0),
        (_array([0.0] * n), _array([rng.uniform(5.0, 30.0) for _ in range(n)])),
        branches=branches,
    )

"""A sphere, or another round body, thrown along a level surface with friction: it slides, then it
rolls (8.6).

x and v of the centre, omega counterclockwise when x points to the right: the lowest point moves at
the slip v + omega r. While it slides, friction mu m g acts against the slip; when the slip is gone,
rolling needs none. Each regime is a model with an exact solution, and the switch between them is
known in closed form, where an integrator of one right-hand side with sign(slip) chatters. The mass
drops out.
"""

from dataclasses import dataclass

from ...algebra.scalars import plain, scalar, where, whole
from ...motion.model import Model
from ..catalogue import scene


@dataclass(frozen=True)
class RollingBegins:
    """The instant at which sliding turns into rolling: time ``t`` from the start, place ``x``,
    speed ``v``, angular velocity ``omega``.
    """

    t: object
    x: object
    v: object
    omega: object


@scene(
    "8.6",
    "sliding sphere",
    "a sphere thrown without spin, until it begins to roll",
    1.0,
    (0.0, 7.0, 0.0),
    mu=0.2,
    g=10.0,
    radius=0.5,
)
def sliding(mu, g, radius, k=None, sense=1):
    """The model of the sphere while it slides: states x, v, omega.

    k : moment of inertia over m r^2; default: 2/5 of a sphere; 1/2 for a cylinder
    sense : the sign of the slip v + omega r: 1 for a sphere thrown to the right without spin
    The angular momentum about a point of the surface is an invariant, since friction passes through
    it.

    >>> sliding(0.5, 10.0, 0.5).derivative((0.0, 3.0, 0.0))
    (3.0, -5.0, -25.0)
    """
    parameters = {"mu": mu, "g": g, "r": radius, "k": _ratio(mu, k), "sense": sense}
    return Model(
        "sliding sphere", parameters, ("x", "v", "omega"), _sliding_rates, _INVARIANTS, _slid
    )


@scene(
    "8.6",
    "rolling sphere",
    "a sphere that rolls on the level: nothing changes but its place",
    2.0,
    (6.0, 5.0, -10.0),
    radius=0.5,
)
def rolling(radius, k=None):
    """The model of the sphere while it rolls on the level: only x changes. States as in
    :func:`sliding`.
    """
    parameters = {"r": radius, "k": _ratio(radius, k)}
    return Model(
        "rolling sphere",
        parameters,
        ("x", "v", "omega"),
        lambda s, p, t: (s.v, 0, 0),
        {**_INVARIANTS, "slip": _slip},
        _rolled,
    )


def rolling_begins(v0, mu, g, radius, omega0=0, k=None, sense=1):
    """When and how the sphere begins to roll: :class:`RollingBegins`. Without spin t = 2 v0/(7 mu
    g), v = 5 v0/7, omega = -5 v0/(7 r).

    sense : the sign of v0 + omega0 r, as in :func:`sliding`; with the wrong sign the time is
        negative

    >>> b = rolling_begins(7.0, 0.2, 10.0, 0.5)
    >>> round(b.t, 12), b.v, b.omega
    (1.0, 5.0, -10.0)
    """
    k = _ratio(mu, k)
    slip = v0 + scalar(omega0) * radius
    t = sense * slip * k / ((1 + k) * (mu * g))
    v = (v0 - k * (scalar(omega0) * radius)) / (1 + k)
    return RollingBegins(t, plain(t * (v0 + v) / 2), v, -v / radius)


def sphere_at(t, v0, mu, g, radius, omega0=0, k=None, sense=1):
    """(x, v, omega) at the time ``t``, through both regimes; for numbers and arrays of times."""
    b = rolling_begins(v0, mu, g, radius, omega0, k, sense)
    slid = sliding(mu, g, radius, k, sense).solution(t, (0 * v0, v0, omega0))
    rolled = rolling(radius, k).solution(t - b.t, (b.x, b.v, b.omega))
    return tuple(where(t < b.t, early, late) for early, late in zip(slid, rolled, strict=True))


def _ratio(like, k):
    return whole(2, like) / 5 if k is None else k


def _sliding_rates(s, p, t):
    return s.v, -p.sense * (p.mu * p.g), -p.sense * (p.mu * p.g) / (p.k * p.r)


def _slid(s, p, t):
    a, alpha = -p.sense * (p.mu * p.g), -p.sense * (p.mu * p.g) / (p.k * p.r)
    return s.x + s.v * t + a * (t * t) / 2, s.v + a * t, s.omega + alpha * t


def _rolled(s, p, t):
    return s.x + s.v * t, s.v, s.omega


def _slip(s, p, t):
    return s.v + s.omega * p.r


_INVARIANTS = {
    "angular momentum about the surface over mass": lambda s, p, t: (
        p.k * (p.r * p.r) * s.omega - p.r * s.v
    )
}

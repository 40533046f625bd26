"""A sphere, or another round body, thrown along a level surface with friction: it slides, then it
rolls (8.6).

x and v of the centre, omega counterclockwise when x points to the right: the lowest point moves at
the slip v + omega r. While it slides, friction mu m g acts against the slip; rolling needs none.
Each regime is a model with an exact solution, and the time of the transition has a closed form,
:func:`newton_euler.chapters.examples.ch08.rolling_begins`; an integrator of one right-hand side
with sign(slip) would chatter.
"""

from ...algebra.scalars import Scalar
from ...motion.model import Model
from ..catalogue import scene
from ..closed_forms.harmonic import uniform_acceleration
from .rolling_sphere import inertia_ratio

STATES = ("x", "v", "omega")


@scene(
    "8.6", "sliding sphere", "a sphere thrown without spin, until it begins to roll",
    1.0, (0.0, 7.0, 0.0), mu=0.2, g=10.0, radius=0.5,
)  # fmt: skip
def sliding(
    mu: Scalar, g: Scalar, radius: Scalar, k: Scalar | None = None, sense: Scalar = 1
) -> Model:
    """The Model of the sphere while it slides: states x, v, omega. The angular momentum about a
    point of the surface is an invariant, since friction passes through it.

    k : moment of inertia over m r^2, as in :mod:`.rolling_sphere`
    sense : the sign of the slip v + omega r: 1 for a sphere thrown to the right without spin

    >>> sliding(0.5, 10.0, 0.5).derivative((0.0, 3.0, 0.0))
    (3.0, -5.0, -25.0)
    """
    parameters = {"mu": mu, "g": g, "r": radius, "k": inertia_ratio(mu, k), "sense": sense}
    return Model("sliding sphere", parameters, STATES, _sliding, _INVARIANTS, _slid)


@scene(
    "8.6", "rolling sphere", "a sphere that rolls on the level",
    2.0, (6.0, 5.0, -10.0), radius=0.5,
)  # fmt: skip
def rolling(radius: Scalar, k: Scalar | None = None) -> Model:
    """The Model of the sphere while it rolls on the level; states as for :func:`sliding`.

    >>> rolling(0.5).derivative((0.0, 3.0, -6.0))
    (3.0, 0, 0)
    """
    parameters = {"r": radius, "k": inertia_ratio(radius, k)}
    return Model("rolling sphere", parameters, STATES, _rolling, _ROLLING_INVARIANTS, _rolled)


def _sliding(s, p, t):
    a = -p.sense * (p.mu * p.g)
    return s.v, a, a / (p.k * p.r)


def _slid(s, p, t):
    v, a, alpha = _sliding(s, p, t)
    return *uniform_acceleration(s.x, v, a, t), s.omega + alpha * t


def _rolling(s, p, t):
    return s.v, 0, 0


def _rolled(s, p, t):
    return s.x + s.v * t, s.v, s.omega


_INVARIANTS = {
    "angular momentum about the surface over mass": lambda s, p, t: (
        p.k * (p.r * p.r) * s.omega - p.r * s.v
    )
}
_ROLLING_INVARIANTS = {**_INVARIANTS, "slip": lambda s, p, t: s.v + s.omega * p.r}

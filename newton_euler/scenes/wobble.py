"""How a body without moment wobbles about its axis of spin, as a ladder: symmetric, nearly steady, or as it is (8.14 with M = 0).

The body spins about z, more or less. In both approximations the rate about z is constant, w_x and w_y go around an ellipse (a circle for the
symmetric body), or run away where z is the axis of the intermediate moment.
"""

from ..harmonic import circular_or_hyperbolic
from ..ladders import Ladder, Rung
from ..models import Model, Neglected
from ..scalars import cos, sin
from .free_body import free_body

RATES = "angular velocity, rad/s"


def symmetric(I_x, I_y, I_z, spin):
    """With the mean of I_x and I_y for both (10.36): states w_x, w_y; ``spin`` is the constant rate about z.

    >>> symmetric(1.0, 3.0, 3.0, 10.0).derivative((0.5, 0.1))
    (-0.5, 2.5)
    """
    return Model("wobble of a symmetric body", _named(I_x, I_y, I_z, spin), ("w_x", "w_y"), _symmetric, exact=_circle, neglects=(ASYMMETRY,))


def small(I_x, I_y, I_z, spin):
    """To first order in w_x and w_y: these are the states; ``spin`` is the constant rate about z.

    >>> small(1.0, 2.0, 3.0, 10.0).derivative((0.5, 0.1))
    (-1.0, 5.0)
    """
    return Model("small wobble", _named(I_x, I_y, I_z, spin), ("w_x", "w_y"), _small, exact=_ellipse, neglects=(PRODUCT,))


def ladder(I_x=1.0, I_y=1.02, I_z=1.5, start=(0.1, 0.0, 5.0), t=10.0):
    """Symmetric body, small wobble, free body: a :class:`~newton_euler.ladders.Ladder` for the body rates w_x, w_y, w_z, which are the start.

    >>> from newton_euler.ladders import smallest
    >>> [smallest(ladder(), rate).model.name for rate in (0.01, 1e-4, 1e-5)]
    ['wobble of a symmetric body', 'small wobble', 'free body']
    """
    *across, spin = start
    rungs = [Rung(make(I_x, I_y, I_z, spin), tuple(across), _with_spin) for make in (symmetric, small)]
    return Ladder("free body", RATES, t, (*rungs, Rung(free_body(I_x, I_y, I_z), start, _all)))


def _named(I_x, I_y, I_z, spin):
    return {"I_x": I_x, "I_y": I_y, "I_z": I_z, "spin": spin}


def _with_spin(s, p, t):
    return s.w_x, s.w_y, p.spin


def _all(s, p, t):
    return s.w_x, s.w_y, s.w_z


def _turning(p):
    I0 = (p.I_x + p.I_y) / 2
    return (p.I_z - I0) / I0 * p.spin


def _symmetric(s, p, t):
    rate = _turning(p)
    return -rate * s.w_y, rate * s.w_x


def _circle(s, p, t):
    c, S = cos(_turning(p) * t), sin(_turning(p) * t)
    return s.w_x * c - s.w_y * S, s.w_y * c + s.w_x * S


def _factors(p):
    """w_x' = -a w_y, w_y' = b w_x."""
    return (p.I_z - p.I_y) / p.I_x * p.spin, (p.I_z - p.I_x) / p.I_y * p.spin


def _small(s, p, t):
    a, b = _factors(p)
    return -a * s.w_y, b * s.w_x


def _ellipse(s, p, t):
    a, b = _factors(p)
    c, S = circular_or_hyperbolic(a * b, t)
    return s.w_x * c - a * s.w_y * S, s.w_y * c + b * s.w_x * S


ASYMMETRY = Neglected("the difference of I_x and I_y", None, RATES)
PRODUCT = Neglected("the change of the rate about z", None, RATES)

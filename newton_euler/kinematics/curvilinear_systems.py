"""Components in any orthogonal coordinates from their position function alone (3.4), and gradients
(A.22). The unit vector of a coordinate is e_i = (dr/dq_i)/h_i, with the *scale factor* h_i =
abs(dr/dq_i).
"""

from collections.abc import Callable, Sequence
from functools import partial
from itertools import chain, combinations_with_replacement

from ..algebra.errors import checked
from ..algebra.jets import Moving, as_moving, at, moving
from ..algebra.scalars import (
    ZERO,
    Rows,
    Scalar,
    SingularError,
    Triple,
    hypot,
    integer_like,
    is_numeric,
    scalar,
    to_plain,
)
from ..algebra.vectors import Vector, cross3, dot3, scale3
from .coordinates import CoordinatePoint
from .frames import Frame, Point
from .triads import Triad, below_roundoff, roundoff_sensitivity, turning_of


@checked
def curvilinear(
    ground: Frame,
    name: str,
    position: Callable[..., Triple],
    q1: Scalar,
    q2: Scalar,
    q3: Scalar,
    names: Sequence[str] = ("u", "v", "w"),
) -> CoordinatePoint:
    """The point with the coordinates q1, q2, q3 in the system of ``position``.

    position : function of three scalars that returns (x, y, z) in ``ground``
    q1, q2, q3 : numbers or moving; in the order that makes e_1, e_2, e_3 right-handed
    names : of the coordinates, for the names of terms
    Velocity and acceleration in ``ground`` are along e_1, e_2, e_3 (``P.local``), with one term for
    each rate: ``u'``, …; and ``u''``, ``u'^2``, ``u' v'``, …, unless zero by form.

    Raises :class:`SingularError` where a scale factor is below round-off (a pole, an axis), and for
    coordinates that are not orthogonal or not right-handed there.

    >>> ground = Frame("ground")
    >>> parabolic = lambda u, v, w: ((u**2 - v**2)/2, u*v, w)
    >>> P = curvilinear(ground, "P", parabolic, moving(3.0, rate=2.0), 4.0, 0.0)
    >>> P.velocity(ground).x, P.scale_factors, print(P.acceleration(ground))
    [2.4, -3.2, 0] in e_1, e_2, e_3 of P
    (10.0, (5.0, 5.0, 1.0), None)
    """
    q = tuple(moving(x) for x in (q1, q2, q3))
    values = tuple(x.value for x in q)
    columns = tangents(position, values)
    factors = tuple(hypot(*c) for c in columns)
    _check(position, values, columns, factors)
    axes = [tuple(x / h for x in c) for c, h in zip(columns, factors, strict=True)]
    turning = partial(_turning, position, q)
    local = Triad(f"e_1, e_2, e_3 of {name}", ground, axes, turning)
    local.hats = (r"\hat{e}_1", r"\hat{e}_2", r"\hat{e}_3")
    terms = {
        "velocity": lambda P: _velocity_terms(P, columns, names),
        "acceleration": lambda P: _acceleration_terms(P, position, columns, names),
    }
    x, factors = position(*q), tuple(map(to_plain, factors))
    return CoordinatePoint(name, ground, x, ground, local, q, factors, "curvilinear", terms)


def tangents(position: Callable[..., Triple], q: Sequence[Scalar]) -> Rows:
    """dr/dq_1, dr/dq_2, dr/dq_3, triples, of the position at ``q``; moving if ``q`` is."""
    places = [position(*_seeded(q, n)) for n in range(3)]
    return tuple(tuple(map(_rate, place)) for place in places)


def _seeded(q, n):
    """The coordinates as moving numbers; the n-th has the rate 1."""
    # a 1 of the kind of the coordinate, so that 1/3 is as exact
    one = integer_like(1, q[n].value if isinstance(q[n], Moving) else q[n])
    return tuple(Moving(x, one if m == n else ZERO) for m, x in enumerate(q))


def _rate(x):
    return x.rate if isinstance(x, Moving) else ZERO


def _check(position, q, columns, factors):
    if not all(map(is_numeric, (*q, *chain(*columns)))):
        return
    noises = roundoff_sensitivity(lambda *p: tangents(position, p), q)
    for n, (h, noise) in enumerate(zip(factors, noises, strict=True), 1):
        if below_roundoff(h, noise):
            raise SingularError(
                f"coordinate {n} is singular here: the point does not move when it grows "
                "(scale factor zero within rounding), so its unit vector does not exist; use other "
                "coordinates near this place"
            )
    axes = [tuple(x / h for x in c) for c, h in zip(columns, factors, strict=True)]
    for n, m in ((0, 1), (1, 2), (2, 0)):
        cosine = scalar(dot3(axes[n], axes[m]))
        if below_roundoff(1e-8, abs(cosine)):  # 1e-8: the root of the round-off of doubles
            raise SingularError(
                f"the coordinates are not orthogonal here: e_{n + 1} . e_{m + 1} = "
                f"{cosine}, expected 0; this method needs orthogonal ones"
            )
    if below_roundoff(dot3(axes[0], cross3(axes[1], axes[2])), ZERO):
        raise SingularError("the coordinates are left-handed: e_1 x e_2 = -e_3; exchange two")


def _turning(position, q):
    columns = [[as_moving(x) for x in c] for c in tangents(position, q)]
    return turning_of([[as_moving(x / hypot(*c)) for x in c] for c in columns])


def _velocity_terms(P, columns, names):
    rows = zip(names, P.coordinates, columns, strict=True)
    return _vectors([(f"{name}'", scale3(x.rate, c)) for name, x, c in rows], P.ground)


def _acceleration_terms(P, position, columns, names):
    """The terms of sum q_i'' r_i + sum q_i'^2 r_ii + sum 2 q_i' q_j' r_ij (partials of r)."""
    q = P.coordinates
    values = tuple(x.value for x in q)
    rows = zip(names, q, columns, strict=True)
    parts = [(f"{name}''", scale3(x.acceleration, c)) for name, x, c in rows]
    for n, m in combinations_with_replacement(range(3), 2):
        jets = position(*_seeded(_seeded(values, m), n))
        name = f"{names[n]}'^2" if n == m else f"{names[n]}' {names[m]}'"
        factor = (1 if n == m else 2) * (q[n].rate * q[m].rate)
        parts.append((name, scale3(factor, tuple(_rate(_rate(x)) for x in jets))))
    return _vectors(parts, P.ground)


def _vectors(parts, ground):
    return [(name, Vector(c, ground)) for name, c in parts if any(x is not ZERO for x in c)]


@checked
def gradient(f: Callable[..., Scalar], P: Point) -> Vector:
    """The gradient (A.22) of the scalar field ``f`` at the Point ``P``, the sum of (df/dq_i)/h_i
    e_i, by exact derivatives, along P's local axes or those of its frame.

    f : function of the coordinates by which P is given: x, y, z, or those of a
        :class:`~newton_euler.kinematics.coordinates.CoordinatePoint`

    >>> ground = Frame("ground")
    >>> gradient(lambda x, y, z: x**2*y, ground.point("P", 3.0, 2.0, 5.0))
    Vector(12.0, 9.0, 0 in ground)
    """
    q = tuple(x.value for x in getattr(P, "coordinates", P.x))
    factors = getattr(P, "scale_factors", (1, 1, 1))
    slopes = [at(lambda s, n=n: f(*q[:n], s, *q[n + 1 :]), q[n]).rate for n in range(len(q))]
    c = [slope / h for slope, h in zip(slopes, factors, strict=True)]
    return Vector(tuple(map(scalar, (*c, ZERO)[:3])), getattr(P, "local", P.frame))

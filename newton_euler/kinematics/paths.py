"""Intrinsic components: velocity and acceleration along the path and across it (2.3, 3.2).

The unit vectors belong to the path: e_t along the velocity, e_n towards the centre of curvature,
e_b = e_t x e_n; in the plane e_b is k where the path turns counterclockwise, else -k. *Flexure* f
is the reciprocal of the radius of curvature rho, both positive. *Torsion* tau has the book's sign
(3.9), de_b/ds = tau e_n: it is **minus** the torsion of most other books, and negative for a
right-handed helix. A *path* is a function of one parameter that returns three coordinates.
"""

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import TypeAlias

from ..algebra.errors import checked
from ..algebra.jets import Moving, as_moving, moving
from ..algebra.ledger import Ledger
from ..algebra.scalars import (
    ZERO,
    Rows,
    Scalar,
    SingularError,
    Triple,
    epsilon,
    hypot,
    integer_like,
    is_numeric,
    is_zero,
    largest_abs,
    scalar,
    to_plain,
)
from ..algebra.vectors import FrameError, Vector, add3, cross3, dot3, scale3, sum3, three
from .frames import Frame
from .triads import Triad, below_roundoff, roundoff_sensitivity

Path: TypeAlias = Callable[[Scalar], Triple]


@checked
def along(path: Path, q: Scalar) -> Triple:
    """The three moving coordinates of the point at ``q`` on the path, for ``ground.point("P",
    *along(path, q))`` (3.1)-(3.3); q is a moving parameter, or a time, with the rate 1.

    >>> ground = Frame("ground")
    >>> ground.point("P", *along(lambda t: (t**2, 3.0*t, 1.0), 2.0)).velocity(ground)
    Vector(4.0, 3.0, 0 in ground)
    """
    return tuple(map(moving, _place(path, _running(q))))


def _place(path, q):
    return three(path(q), "a place on a path (z is 0 in the plane)", FrameError)


def derivatives(path: Path, q: Scalar) -> Rows:
    """The position at ``q``, a plain number, and its three derivatives by it, triples."""
    one = integer_like(1, q)  # a plain 1 divided by 3 would have 16 digits, however many q has
    orders = []
    # a jet of jets: the rate of the second rate is the third derivative
    for x in map(as_moving, _place(path, Moving(Moving(scalar(q), one), one))):
        value, rate = as_moving(x.value), as_moving(x.rate)
        orders.append((value.value, value.rate, value.acceleration, rate.acceleration))
    return tuple(zip(*orders, strict=True))


@checked
def at_speed(path: Path, q: Scalar, speed: Scalar, speed_rate: Scalar = 0) -> Moving:
    """The parameter ``q`` with its rates, for a point that passes there with this speed (and its
    rate of change) in the direction of increasing q: with r_q = dr/dq, q' = nu/abs(r_q), and q''
    from nu' = q'' abs(r_q) + q'^2 (r_q . r_qq)/abs(r_q). :class:`SingularError` where r_q = 0.

    >>> at_speed(lambda q: (q, q**2, 0), 0.0, speed=2.0)
    moving(0.0, rate=2.0, acceleration=-0.0)
    """
    _, first, second, _ = derivatives(path, q)
    stretch = hypot(*first)
    if is_numeric(stretch) and below_roundoff(stretch, _noise(path, q)[0]):
        raise SingularError(
            f"dr/dq is zero at q = {q!r}: the path stands still; use another parameter"
        )
    rate = scalar(speed) / stretch
    second_rate = (scalar(speed_rate) - rate * rate * (dot3(first, second) / stretch)) / stretch
    return Moving(scalar(q), rate, second_rate)


def _noise(path, q):
    """The round-off of the first and of the second derivative, as lengths."""
    return roundoff_sensitivity(lambda p: derivatives(path, p)[1:3], (q,))


def _running(q):
    q = moving(q)
    return Moving(q.value, integer_like(1, q.value)) if q.rests() else q


@dataclass(frozen=True)
class Frenet:
    """A motion in intrinsic components, from :func:`frenet` or :func:`frenet_along`.

    frame : the frame of e_t, e_n, e_b, in which ``velocity`` and ``acceleration`` are given
    speed, speed_rate : nu and its rate of change, the tangential component of acceleration
    flexure : f = 1/rho, in 1/length
    """

    frame: Triad
    speed: Scalar
    speed_rate: Scalar
    flexure: Scalar
    _torsion: Scalar = field(default=None, repr=False)

    e_t = property(lambda self: self.frame.i, doc="unit tangent, along the velocity (2.4), (3.4)")
    e_n = property(lambda self: self.frame.j, doc="normal, towards the centre of curvature (3.5)")
    e_b = property(lambda self: self.frame.k, doc="binormal e_t x e_n (3.7)")
    radius = property(lambda self: 1 / self.flexure, doc="radius of curvature rho (2.12)")
    to_center = property(
        lambda self: self.e_n * self.radius,
        doc="the vector from the point to the centre of curvature, rho e_n",
    )

    @property
    def torsion(self) -> Scalar:
        """tau in 1/length, with the book's sign (3.9), (3.10)."""
        if self._torsion is None:
            raise SingularError(
                "the torsion needs the rate of the acceleration: pass jerk=, or use frenet_along"
            )
        return to_plain(self._torsion)

    @property
    def velocity(self) -> Vector:
        """v = nu e_t (2.4), (3.12); its rate in the ground is the acceleration."""
        v = self.frame.vector(self.speed, 0, 0)
        return self._sum("velocity", lambda: self.frame.vector(self.speed_rate, 0, 0), tangential=v)

    @property
    def acceleration(self) -> Vector:
        """a = nu' e_t + nu^2 f e_n (2.14), (3.13); terms ``tangential`` and ``normal``."""
        t = self.frame.vector(self.speed_rate, 0, 0)
        n = self.frame.vector(0, self.speed * (self.speed * self.flexure), 0)
        return self._sum("acceleration", None, tangential=t, normal=n)

    def _sum(self, what, own_rate, **terms):
        subject = f"in {self.frame.parent.name}"
        ledger = Ledger(f"intrinsic {what}", subject, lambda: terms)
        return Vector(sum3(v.c for v in terms.values()), self.frame, own_rate, ledger)


@checked
def speed_rate(v: Vector, a: Vector) -> Scalar:
    """nu' = v . a / nu, the tangential component of acceleration; it exists on a straight path too.

    >>> ground = Frame("ground")
    >>> speed_rate(ground.vector(3.0, 4.0, 0), ground.vector(1.0, 1.0, 0))
    1.4
    """
    _check_speed(v.c, v.norm(), _round_off(v))
    return v.direction().dot(a)


@checked
def flexure(v: Vector, a: Vector) -> Scalar:
    """f = abs(v x a)/nu^3 (3.6), 1/(radius of curvature); zero (or round-off) on a straight path.

    >>> ground = Frame("ground")
    >>> flexure(ground.vector(2.0, 0, 0), ground.vector(0.5, 3.0, 0))
    0.75
    """
    _check_speed(v.c, v.norm(), _round_off(v))
    speed = v.norm()
    return to_plain(hypot(*_turn(v.c, speed, a.expressed_in(v.frame).c)) / speed / speed)


@checked
def frenet(v: Vector, a: Vector, jerk: Vector | None = None, name: str = "path") -> Frenet:
    """The intrinsic triad and components of a motion by velocity and acceleration (2.14), (3.13).

    v, a, jerk : Vectors, all seen from one observer; the frame of ``v`` is the parent of the triad
    jerk : da/dt; only needed for the torsion
    Raises :class:`SingularError` at rest, and where v x a is below round-off (a straight path, an
    inflection), which is larger where terms of ``v`` and ``a`` cancel.

    >>> ground = Frame("ground")
    >>> P = frenet(ground.vector(0, 5.0, 0), ground.vector(-2.0, 1.5, 0))
    >>> P.speed, P.speed_rate, P.radius, P.acceleration
    (5.0, 1.5, 12.5, Vector(1.5, 2.0, 0 in e_t, e_n, e_b of path))
    """
    ground = v.frame
    third = None if jerk is None else jerk.expressed_in(ground).c
    return _frenet(ground, v.c, a.expressed_in(ground).c, third, name, _round_off(v), _round_off(a))


@checked
def frenet_along(path: Path, q: Scalar, ground: Frame, name: str = "path") -> Frenet:
    """The intrinsic triad, flexure, torsion and components of a point moving along a path
    (3.4)-(3.13), by exact derivatives.

    path : function of the parameter, returning (x, y, z) along the axes of ``ground``
    q : a moving parameter (see :func:`at_speed`); a plain number is a time, with the rate 1
    Raises :class:`SingularError` as :func:`frenet` does, here where a direction changes by its own
    size while q changes by its round-off.

    >>> from newton_euler import cos, sin
    >>> helix = frenet_along(lambda s: (3.0*cos(s), 3.0*sin(s), 4.0*s), 0.0, Frame("ground"))
    >>> helix.speed, helix.flexure, helix.torsion  # right-handed, so negative here
    (5.0, 0.12, -0.16)
    """
    q = _running(q)
    _, first, second, third = derivatives(path, q.value)
    v = scale3(q.rate, first)
    a = add3(scale3(q.rate * q.rate, second), scale3(q.acceleration, first))
    noises = [ZERO, ZERO]
    if all(map(is_numeric, (*v, *a, q.value))):
        noises = [noise * abs(q.rate) ** n for n, noise in enumerate(_noise(path, q.value), 1)]
    # the other parts of the jerk lie in the plane of v and a
    return _frenet(ground, v, a, scale3(q.rate**3, third), name, *noises)


def _frenet(ground, v, a, jerk, name, v_noise, a_noise):
    speed = hypot(*v)
    _check_speed(v, speed, v_noise)
    e_t, turn = tuple(x / speed for x in v), _turn(v, speed, a)
    across, size = hypot(*turn), hypot(*a)
    # the rounding of the cross product itself, with a margin of 8, and that of v and of a
    rounding = 8 * epsilon(speed) * size + a_noise + size * (v_noise / speed)
    if is_zero(across) or (all(map(is_numeric, (*v, *a))) and below_roundoff(across, rounding)):
        raise SingularError(
            "the path is straight here, on a line or at an inflection: v x a is zero (within "
            "rounding), so e_n, e_b and the torsion do not exist and the radius of curvature is "
            "infinite; the tangential component is speed_rate(v, a), the flexure 0"
        )
    e_b, f = tuple(x / across for x in turn), across / speed / speed
    tau = None if jerk is None else -dot3(turn, jerk) / across / (across * speed)
    turning = None if tau is None else (lambda: ((-tau * speed, ZERO, f * speed), None))
    triad = Triad(f"e_t, e_n, e_b of {name}", ground, (e_t, cross3(e_b, e_t), e_b), turning)
    triad.hats = (r"\hat{e}_t", r"\hat{e}_n", r"\hat{e}_b")
    return Frenet(triad, speed, to_plain(dot3(e_t, a)), to_plain(f), tau)


def _turn(v, speed, a):
    """e_t x a; by v x a, which is 0 of parallel vectors, where no product leaves the floats."""
    several = any(not is_numeric(x) or getattr(x, "shape", ()) for x in (*v, *a))
    if not several and 1e-280 < largest_abs(v) * largest_abs(a) < 1e300:
        return tuple(x / speed for x in cross3(v, a))
    return cross3(tuple(x / speed for x in v), a)


def _check_speed(v, speed, noise):
    if all(map(is_numeric, v)) and below_roundoff(scalar(speed), noise):
        raise SingularError(
            "the point is at rest (within rounding): a velocity of zero has no direction, so there "
            "is no e_t; if the path is known, take the triad from the path with a parameter that "
            "moves, frenet_along(path, q, ground)"
        )


def _round_off(v):
    """The round-off to expect in a vector, as a length, from its components and its terms."""
    return 4 * epsilon(hypot(*v.c)) * _gathered(v) if all(map(is_numeric, v.c)) else ZERO


def _gathered(v):
    return sum((_gathered(term) for term in v.terms.values()), hypot(*v.c))

"""Polar, cylindrical and spherical components of velocity and acceleration (2.6, 3.5-3.8).

Each system is a frame of local unit vectors, turned from the ground by the coordinate angles, and a
point in it, so that (4.18) gives all accelerations, with the terms of the book:

polar, cylindrical : (e_r, e_theta, k), turned about z by the azimuth theta, from x towards y; the
    point is at (r, 0, z)
spherical : (e_R, e_theta, e_phi), turned about z by theta, then up by the **elevation** phi above
    the x, y plane (not the polar angle from z); the point is at (R, 0, 0)
"""

from collections.abc import Callable, Mapping, Sequence
from functools import partial

from ..algebra.errors import checked
from ..algebra.jets import Moving, moving
from ..algebra.ledger import Terms
from ..algebra.otherwise import built
from ..algebra.pickles import Computed
from ..algebra.scalars import (
    ZERO,
    Rows,
    Scalar,
    SingularError,
    Triple,
    atan2,
    cos,
    epsilon,
    hypot,
    is_numeric,
    max_abs,
    min_abs,
    scalar,
    sin,
    to_plain,
)
from ..algebra.vectors import Vector
from .frames import Frame, Point
from .rotations import product
from .triads import below_roundoff

# -- frames of local unit vectors


@checked
def cylindrical_frame(ground: Frame, theta: Scalar, name: str = "e_r, e_theta, k") -> Frame:
    """The frame of e_r, e_theta, k at the azimuth ``theta`` (3.19), also polar (2.6).

    >>> ground = Frame("ground")
    >>> cylindrical_frame(ground, moving(0.5, rate=2.0)).i.rate(ground)
    Vector(0, 2.0, 0 in e_r, e_theta, k)
    """
    axes = ground.rotate(name, "z", theta)
    axes.hats = (r"\hat{e}_r", r"\hat{e}_\theta", r"\hat{k}")
    return axes


@checked
def spherical_frame(
    ground: Frame, theta: Scalar, phi: Scalar, name: str = "e_R, e_theta, e_phi"
) -> Frame:
    """The frame with the axes e_R, e_theta, e_phi at the azimuth ``theta`` and the elevation
    ``phi`` (3.25), numbers or moving. Its angular velocity is theta' k - phi' e_theta.

    >>> ground = Frame("ground")
    >>> axes = spherical_frame(ground, moving(0.0, rate=2.0), moving(0.0, rate=3.0))
    >>> axes.i.rate(ground).components()  # along e_R, e_theta, e_phi
    (0, 2.0, 3.0)
    """
    axes = ground.rotate(f"azimuth of {name}", "z", theta).rotate(name, "-y", phi)
    axes.hats = (r"\hat{e}_R", r"\hat{e}_\theta", r"\hat{e}_\phi")
    return axes


# -- points by their coordinates


class CoordinatePoint(Point):
    """A point given by curvilinear coordinates. ``P.velocity(ground)`` and
    ``P.acceleration(ground)`` are in its local axes, with the terms of the book; for another
    observer, or with ``via=``, they are those of any :class:`Point`.

    local : the frame of the local unit vectors
    coordinates : the three (polar: two) coordinates, as moving numbers
    scale_factors : the length of path per unit of each coordinate
    """

    __slots__ = ("_system", "_terms", "coordinates", "ground", "local", "scale_factors")

    def __init__(
        self,
        name: str,
        frame: Frame,
        x: Sequence[Scalar],
        ground: Frame,
        local: Frame,
        coordinates: Triple,
        scale_factors: Triple,
        system: str,
        terms: Mapping[str, Callable] | None = None,
    ):
        super().__init__(name, frame, tuple(map(moving, x)))
        self.ground, self.local, self.coordinates = ground, local, coordinates
        self.scale_factors, self._system = scale_factors, system
        self._terms = terms or _TERMS[system]

    def __getstate__(self):
        values = {n: getattr(self, n) for n in (*Point.__slots__, *CoordinatePoint.__slots__)}
        # the functions are closures, which cannot be pickled: their results are
        values["_terms"] = {what: Computed(partial(f, self)) for what, f in self._terms.items()}
        return None, values

    def velocity(self, observer: Frame | None = None, via: Frame | None = None) -> Vector:
        """v seen from ``observer``, as for :class:`Point`; from ``ground`` in the local axes."""
        return self._local("velocity", super().velocity(observer, via), observer, via)

    def acceleration(self, observer: Frame | None = None, via: Frame | None = None) -> Vector:
        """a seen from ``observer``, as for :class:`Point`; from ``ground`` in the local axes."""
        return self._local("acceleration", super().acceleration(observer, via), observer, via)

    def _local(self, what, vector, observer, via):
        if observer is not self.ground or via is not None:
            return vector
        here = vector.expressed_in(self.local)

        def terms():
            return Terms(self._terms[what](self)).mapped(lambda v: v.expressed_in(self.local))

        subject = f"of {self.name} in {observer.name}"
        return here.as_sum(f"{self._system} {what}", subject, terms)


@checked
def polar(ground: Frame, name: str, r: Scalar, theta: Scalar) -> CoordinatePoint:
    """The point of the x, y plane with the polar coordinates ``r`` and ``theta`` (2.17), (2.18),
    numbers or moving. Velocity and acceleration in ``ground`` are along e_r, e_theta; terms
    ``radial, transverse`` and ``radial, centripetal, euler, coriolis``.

    >>> ground = Frame("ground")
    >>> B = polar(ground, "B", moving(20.0, rate=0.5), moving(0.5, rate=-0.075))
    >>> print(B.velocity(ground), B.acceleration(ground).terms["coriolis"])
    [0.5, -1.5, 0] in polar axes of B [0, -0.075, 0] in polar axes of B
    """
    local = cylindrical_frame(ground, theta, f"polar axes of {name}")
    (r,) = built("coordinate", (moving(r),))
    x, q, factors = (r, ZERO, ZERO), (r, local.angle), (1, to_plain(r.value))
    return CoordinatePoint(name, local, x, ground, local, q, factors, "polar")


@checked
def cylindrical(ground: Frame, name: str, r: Scalar, theta: Scalar, z: Scalar) -> CoordinatePoint:
    """The point with the cylindrical coordinates ``r``, ``theta`` and ``z`` (3.18), numbers or
    moving. Velocity (3.22) and acceleration (3.23) in ``ground`` are along e_r, e_theta, k; terms
    as for :func:`polar`, and ``axial``.

    >>> ground = Frame("ground")
    >>> P = cylindrical(ground, "P", 2.0, moving(0.0, rate=3.0), moving(1.0, rate=4.0))
    >>> P.velocity(ground).components(), P.acceleration(ground).components()
    ((0, 6.0, 4.0), (-18.0, 0, 0))
    """
    local = cylindrical_frame(ground, theta, f"cylindrical axes of {name}")
    (r,), z = built("coordinate", (moving(r),)), moving(z)
    x, q, factors = (r, ZERO, z), (r, local.angle, z), (1, to_plain(r.value), 1)
    return CoordinatePoint(name, local, x, ground, local, q, factors, "cylindrical")


@checked
def spherical(ground: Frame, name: str, R: Scalar, theta: Scalar, phi: Scalar) -> CoordinatePoint:
    """The point with the spherical coordinates ``R``, ``theta`` (azimuth) and ``phi``
    (elevation) (3.24), numbers or moving.

    Velocity (3.26) and acceleration (3.27) in ``ground`` are along e_R, e_theta, e_phi; terms
    ``radial, theta, phi``, and ``radial`` with the ``centripetal``, ``euler`` and ``coriolis``
    terms of either angle: ``centripetal_theta``, … ``coriolis_theta_phi``. Near a pole cos phi is
    only as accurate as phi: at 1e-8 rad from it the terms of theta have half of their digits.

    >>> ground = Frame("ground")
    >>> P = spherical(ground, "P", 2.0, moving(0.0, rate=3.0), moving(0.0, rate=4.0))
    >>> P.velocity(ground).components(), P.acceleration(ground).terms["centripetal_phi"].x
    ((0, 6.0, 8.0), -32.0)
    """
    local = spherical_frame(ground, theta, phi, f"spherical axes of {name}")
    turned = local.parent  # turned by theta
    assert turned is not None
    (R,), theta, phi = built("coordinate", (moving(R),)), turned.angle, moving(phi)
    factors = 1, to_plain(R.value * cos(phi.value)), to_plain(R.value)
    x, q = (R, ZERO, ZERO), (R, theta, phi)
    return CoordinatePoint(name, local, x, ground, local, q, factors, "spherical")


def _plane_velocity(P):
    terms = Point.velocity(P, P.ground, P.local).terms
    return {"radial": _part(terms["relative"], 0), "transverse": terms["rotation"]}


def _plane_acceleration(P):
    terms = Point.acceleration(P, P.ground, P.local).terms
    others = {name: terms[name] for name in ("centripetal", "euler", "coriolis")}
    return {"radial": _part(terms["relative"], 0), **others}


def _sphere_velocity(P):
    azimuth = P.local.parent
    in_azimuth = Point.velocity(P, azimuth).terms
    return {
        "radial": in_azimuth["relative"],
        "theta": Point.velocity(P, P.ground, azimuth).terms["rotation"],
        "phi": in_azimuth["rotation"],
    }


def _sphere_acceleration(P):
    """The terms of phi are those seen in the azimuth frame; those of theta are due to its turn."""
    azimuth = P.local.parent
    by_phi = Point.acceleration(P, azimuth).terms
    by_theta = Point.acceleration(P, P.ground, azimuth).terms
    seen, twice = Point.velocity(P, azimuth).terms, 2 * azimuth.angular_velocity(P.ground)
    return {
        "radial": by_phi["relative"],
        "centripetal_theta": by_theta["centripetal"],
        "centripetal_phi": by_phi["centripetal"],
        "euler_theta": by_theta["euler"],
        "euler_phi": by_phi["euler"],
        "coriolis_theta": twice.cross(seen["relative"]),
        "coriolis_phi": by_phi["coriolis"],
        "coriolis_theta_phi": twice.cross(seen["rotation"]),
    }


def _part(v, n):
    return Vector(tuple(x if m == n else ZERO for m, x in enumerate(v.c)), v.frame)


_TERMS: dict[str, dict[str, Callable]] = {
    "polar": {"velocity": _plane_velocity, "acceleration": _plane_acceleration},
    "cylindrical": {
        "velocity": lambda P: _plane_velocity(P) | {"axial": _part(Point.velocity(P, P.local), 2)},
        "acceleration": lambda P: (
            _plane_acceleration(P) | {"axial": _part(Point.acceleration(P, P.local), 2)}
        ),
    },
    "spherical": {"velocity": _sphere_velocity, "acceleration": _sphere_acceleration},
}


# -- coordinates and their rates from position, velocity and acceleration


@checked
def polar_coordinates(
    r: Vector, v: Vector | None = None, a: Vector | None = None
) -> tuple[Scalar, ...]:
    """(r, theta) of a point at the position ``r`` in the x, y plane, with their rates if its
    velocity ``v`` and acceleration ``a`` are given.

    r, v, a : Vectors; components are taken along the frame of ``r``, in which v and a are seen
    Without ``v`` the results are plain numbers; with it moving ones (without ``a`` the second rates
    are None). theta is in (-pi, pi]. Raises :class:`SingularError` at the origin, where theta and
    its rates do not exist, and for vectors out of the plane.

    >>> G = Frame("ground")
    >>> polar_coordinates(G.vector(2.0, 0, 0), v=G.vector(0, 6.0, 0), a=G.vector(0, 0, 0))
    (moving(2.0, rate=0.0, acceleration=18.0), moving(0.0, rate=3.0, acceleration=-0.0))
    """
    for vector in (r, v, a):
        c = (0,) * 3 if vector is None else vector.components(r.frame)
        if all(map(is_numeric, c)) and max_abs(c[2]) > 0:
            raise SingularError(
                f"polar components are for the x, y plane: use cylindrical_coordinates for {vector}"
            )
    return cylindrical_coordinates(r, v, a)[:2]


@checked
def cylindrical_coordinates(r: Vector, v: Vector | None = None, a: Vector | None = None) -> Triple:
    """(r, theta, z) and their rates as by :func:`polar_coordinates`: (3.18), (3.22), (3.23) solved
    for them. Raises :class:`SingularError` on the z axis.

    >>> ground = Frame("ground")
    >>> v = ground.vector(5.0, 6.0, 7.0)
    >>> [x.rate for x in cylindrical_coordinates(ground.vector(2.0, 0, 1.0), v)]
    [5.0, 3.0, 7.0]
    """
    x, y, z = r.c
    level = _off_the_axis(r, "on the z axis, where theta and its rates do not exist")
    return _with_rates(cylindrical, (level, atan2(y, x), z), r.frame, v, a)


@checked
def spherical_coordinates(r: Vector, v: Vector | None = None, a: Vector | None = None) -> Triple:
    """(R, theta, phi) and their rates as by :func:`polar_coordinates`, phi the elevation in (-pi/2,
    pi/2): (3.24), (3.26), (3.27) solved. Raises :class:`SingularError` at poles and origin.

    >>> ground = Frame("ground")
    >>> v = ground.vector(5.0, 6.0, 7.0)
    >>> [x.rate for x in spherical_coordinates(ground.vector(2.0, 0, 0), v)]
    [5.0, 3.0, 3.5]
    """
    x, y, z = r.c
    level = _off_the_axis(r, "at a pole (on the z axis), where theta and its rates do not exist")
    R = hypot(*r.c)

    def here(frame, name, *q):
        P = spherical(frame, name, *q)
        # cos and sin from the position: near a pole the round-off of phi exceeds cos phi
        P.local._c, P.local._s, P.scale_factors = level / R, -z / R, (1, level, R)
        return P

    return _with_rates(here, (R, atan2(y, x), atan2(z, level)), r.frame, v, a)


def _off_the_axis(r, where):
    """The distance from the z axis; an error if it is below round-off."""
    level = hypot(*r.c[:2])
    noise = 4 * epsilon(level) * hypot(*r.c)
    if all(map(is_numeric, r.c)) and below_roundoff(scalar(level), noise):
        raise SingularError(
            f"the point is {where} (distance {min_abs(level):.3g}); describe it in "
            "rectangular components, or turn the axes so that it is elsewhere"
        )
    return level


def _with_rates(make, q, frame, v, a):
    """The coordinates ``q``, q_i' = v_i/h_i, q_i'' from ``a`` less the acceleration for q'' = 0."""
    scratch = Frame("axes")
    v, a = (None if u is None else Vector(u.expressed_in(frame).c, scratch) for u in (v, a))
    if v is None:
        return tuple(map(to_plain, q))
    here = make(scratch, "P", *map(Moving, q))
    rates = [d / h for d, h in zip(v.expressed_in(here.local).c, here.scale_factors, strict=True)]
    if a is None:
        return tuple(Moving(x, rate, None) for x, rate in zip(q, rates, strict=True))
    moved = make(scratch, "P", *map(Moving, q, rates))
    left = a.expressed_in(moved.local) - moved.acceleration(scratch)
    second = (x / h for x, h in zip(left.c, moved.scale_factors, strict=True))
    return tuple(map(Moving, q, rates, second))


# -- transformation of components (3.8)


@checked
def T_theta(theta: Scalar) -> Rows:
    """[T_theta] (3.34): from rectangular to cylindrical components; three rows.

    >>> T_theta(0.0)
    ((1.0, 0.0, 0), (-0.0, 1.0, 0), (0, 0, 1))
    """
    return ((cos(theta), sin(theta), 0), (-sin(theta), cos(theta), 0), (0, 0, 1))


@checked
def T_phi(phi: Scalar) -> Rows:
    """[T_phi] (3.37): from cylindrical to spherical components; phi is the elevation.

    >>> T_phi(0.0)
    ((1.0, 0, 0.0), (0, 1, 0), (-0.0, 0, 1.0))
    """
    return ((cos(phi), 0, sin(phi)), (0, 1, 0), (-sin(phi), 0, cos(phi)))


@checked
def T_theta_phi(theta: Scalar, phi: Scalar) -> Rows:
    """[T_theta_phi] = [T_phi][T_theta] (3.36): from rectangular to spherical components.

    >>> T_theta_phi(0.0, 0.0)
    ((1.0, 0.0, 0.0), (0.0, 1.0, 0), (0.0, 0.0, 1.0))
    """
    return product(T_phi(phi), T_theta(theta))

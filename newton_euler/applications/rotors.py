"""Rotation about a fixed axis (chapter 9): bearing forces, imbalance, balancing.

A rotor turns about the line AB of two bearings, Points at rest. The unit vector e points from A to
B, rates and moments are right-handed about it. O is a point of the axis, the bearings lie at -a and
b from it, l = a + b. With F the rate of momentum less the weight, and N that of angular momentum
about O less the moment of the weight, the forces ON the shaft are

    A = e x (N - b e x F)/l,   B = -e x (N + a e x F)/l,   A_e + B_e = e . F,   M = e . N

which are (9.3), (9.6), (9.9), (9.10) for any direction.
"""

from collections.abc import Sequence
from dataclasses import dataclass

from ..algebra.errors import NewtonEulerError, Tolerance, checked
from ..algebra.scalars import (
    Scalar,
    anywhere,
    is_numeric,
    is_positive,
    is_zero,
    largest_abs,
    max_abs,
    scalar,
    sqrt,
    to_plain,
    where,
)
from ..algebra.vectors import Vector, add3, named_sum, scale3, sum3
from ..bodies.body import Body
from ..kinematics.frames import Frame, Point


class RotorError(NewtonEulerError, ValueError):
    """Bearings, planes or weights that are not admissible, or an axis that is not at rest."""


@dataclass(frozen=True)
class Reactions:
    """The bearing forces ``A`` and ``B``, by :func:`reactions`: the transverse forces on the shaft
    (N), in the frame of the body, with the terms of (9.9).

    axial : A_e + B_e (N), the force of both along the axis; how they share it is undetermined
    moment : M (N m), the moment about the axis that drives the shaft (9.10)
    axis : the unit vector e from A to B
    """

    A: Vector
    B: Vector
    axial: Scalar
    moment: Scalar
    axis: Vector


@checked
def reactions(
    body: Body,
    A: Point,
    B: Point,
    ground: Frame,
    gravity: Vector | None = None,
    about: Point | None = None,
) -> Reactions:
    """The forces of the two bearings on a rotor, and the moment that drives it (9.1)-(9.10).

    body : its rate, acceleration and angle are those of its frame in ``ground``
    A, B : the bearings, Points of the axis, fixed in the body or in a frame of the shaft
    gravity : the acceleration of gravity, a Vector (m/s^2); None: no dead weight, as in (9.3)
    about : the point O of the axis for the terms; default: the foot of the centre of mass.
    The terms of A and B, in the order of (9.9): ``weight``; ``static``, from omega^2 and the
        distance of G; ``dynamic``, from omega^2 and the products of inertia about O;
        ``static_euler`` and ``dynamic_euler``, the same from the angular acceleration
    Raises :class:`RotorError` if the bearings coincide, if ``about`` is off the axis, or if body
    and bearings move otherwise than about AB.

    >>> from newton_euler import Frame, particle
    >>> ground = Frame("ground")
    >>> shaft = ground.rotate("shaft", "z", rate=2.0, acceleration=3.0)
    >>> A, B = shaft.point("A", 0, 0, -1.0), shaft.point("B", 0, 0, 1.0)
    >>> found = reactions(particle(1.0, shaft.point("P", 0.5, 0, 0)), A, B, ground)
    >>> found.A, found.A.terms["static_euler"].y, found.moment
    (Vector(-1.0, 0.75, 0 in shaft), 0.75, 0.75)
    """
    e, length = shaft_axis(A, B, body.frame)
    O = _on_axis(body, A, e, length, about)
    _check_motion(body, A, e, length, ground)
    pairs = _wrench(body, O, ground, gravity)
    a, b = (O - A).dot(e), (B - O).dot(e)
    at_A = {name: e.cross(N - e.cross(F) * b) / length for name, (F, N) in pairs.items()}
    at_B = {name: -e.cross(N + e.cross(F) * a) / length for name, (F, N) in pairs.items()}
    F, N = (Vector(sum3(v.c for v in v_s), e.frame) for v_s in zip(*pairs.values(), strict=True))
    of = f"on {body.name}"
    force_A = named_sum("bearing force A", of, at_A, e.frame)
    force_B = named_sum("bearing force B", of, at_B, e.frame)
    return Reactions(force_A, force_B, F.dot(e), N.dot(e), e)


def _wrench(body, O, ground, gravity):
    """For each term of (9.9) the force of the supports, and their moment about O."""
    f, m = body.frame, body.mass
    zero = f.vector(0, 0, 0)
    I, d = body.about(O), (body.centre - O).expressed_in(f)
    w, alpha = f.angular_velocity(ground), f.angular_acceleration(ground)
    W = zero if gravity is None else gravity.expressed_in(f) * m
    return {
        "weight": (-W, -d.cross(W)),
        "static": (w.cross(w.cross(d)) * m, zero),
        "dynamic": (zero, w.cross(I.times(w))),
        "static_euler": (alpha.cross(d) * m, zero),
        "dynamic_euler": (zero, I.times(alpha)),
    }


@checked
def shaft_axis(A: Point, B: Point, frame: Frame | None = None) -> tuple[Vector, Scalar]:
    """The unit vector e from bearing A to bearing B, in ``frame`` (default: that of A), and their
    distance l (m); :class:`RotorError` if they coincide.

    >>> from newton_euler import Frame
    >>> shaft = Frame("shaft")
    >>> shaft_axis(shaft.origin, shaft.point("B", 0, 0, 2.0))
    (Vector(0, 0, 1.0 in shaft), 2.0)
    """
    AB = (B - A).expressed_in(frame or A.frame)
    length = AB.norm()
    # 1e-13 of the coordinates: their difference is round-off
    if _small(length, 1e-13 * max(_extent(A), _extent(B))):
        raise RotorError(f"the bearings {A.name} and {B.name} coincide; one point is not an axis")
    return Vector(tuple(x / length for x in AB.c), AB.frame), length


def _extent(P):
    return largest_abs(P.position(P.frame).c)


def _small(x, limit=0.0):
    """True if a number (any one of an array) is not larger than ``limit``; expressions pass."""
    return is_numeric(x) and anywhere(abs(to_plain(x)) <= limit)


def _on_axis(body, A, e, length, about):
    """The point O: the foot of G on the axis, or the one given, if it lies there."""
    if about is None:
        foot = add3(A.position(body.frame).c, scale3((body.centre - A).dot(e), e.c))
        return body.frame.point("O", *foot)
    off = e.cross(about - A).norm()
    if is_numeric(off) and is_numeric(length) and max_abs(off) > 1e-9 * max_abs(length):
        raise RotorError(
            f"{about.name} is {max_abs(off):.3g} off the axis: take a point on it, or no about="
        )
    return about


def _check_motion(body, A, e, length, ground):
    """Raises :class:`RotorError` unless A rests and the body turns about the axis."""
    w, alpha = body.frame.angular_velocity(ground), body.frame.angular_acceleration(ground)
    for name, vector, scale in (
        ("its angular velocity", w.cross(e), w.norm()),
        ("its angular acceleration", alpha.cross(e), alpha.norm()),
        (f"the velocity of {A.name}", A.velocity(ground), length * w.norm()),
    ):
        # 1e-9 of the whole vector: round-off of Points and rates given in decimals
        off = max_abs(vector.norm()) if all(map(is_numeric, (*vector.c, scalar(scale)))) else 0
        if off and off > 1e-9 * max_abs(scale):
            raise RotorError(
                f"{body.name} does not turn about its bearings as a fixed axis: {name} has "
                f"{off:.3g} across it; turn its frame in {ground.name} about the line AB"
            )


@dataclass(frozen=True)
class Imbalance:
    """The static and the dynamic imbalance (9.4) about O, across the axis, along the body's axes.

    static : m d (kg m), d from the axis to G
    dynamic : the products of inertia with the axis (kg m^2), the integral of z r dm, z along the
        axis from O, r from the axis
    """

    static: Vector
    dynamic: Vector
    about: Point


@checked
def imbalance(body: Body, A: Point, B: Point, about: Point | None = None) -> Imbalance:
    """The static and dynamic imbalance for the axis AB; ``about`` as for :func:`reactions`.

    >>> from newton_euler import Frame, particle
    >>> shaft = Frame("shaft")
    >>> A, B = shaft.origin, shaft.point("B", 0, 0, 1.0)
    >>> found = imbalance(particle(2.0, shaft.point("P", 0.1, 0, 0.4)), A, B, about=A)
    >>> found.static, found.dynamic
    (Vector(0.2, 0, 0 in shaft), Vector(0.08000000000000002, 0, 0 in shaft))
    """
    e, length = shaft_axis(A, B, body.frame)
    O = _on_axis(body, A, e, length, about)
    off = (body.centre - O).expressed_in(body.frame) * body.mass
    return Imbalance(_across(off, e), -_across(body.about(O).times(e), e), O)


def _across(v, e):
    return -e.cross(e.cross(v))


@dataclass(frozen=True)
class Balance:
    """Whether a rotor is balanced, by :func:`balance`; ``str()`` gives it in words with numbers.

    eccentricity, product : distance of G from the axis, m; size of the products of inertia with the
        axis about O, kg m^2
    offset, tilt : the same over k, the radius of gyration about O, and m k^2, at most ``tolerance``
    """

    static: bool
    dynamic: bool
    eccentricity: float
    product: float
    offset: float
    tilt: float
    tolerance: float

    @property
    def state(self) -> str:
        """One of "both", "static", "dynamic", "neither"."""
        if self.static == self.dynamic:
            return "both" if self.static else "neither"
        return "static" if self.static else "dynamic"

    def __str__(self):
        static, dynamic = ("" if ok else "not " for ok in (self.static, self.dynamic))
        return (
            f"statically {static}balanced: G is {self.eccentricity:.3g} off the axis, "
            f"{self.offset:.3g} of the radius of gyration; dynamically {dynamic}balanced: the "
            f"products of inertia with the axis are {self.product:.3g}, {self.tilt:.3g} of the "
            f"moment of inertia (tolerance {self.tolerance:.3g})"
        )


@checked
def balance(
    body: Body, A: Point, B: Point, about: Point | None = None, tolerance: Tolerance = 1e-9
) -> Balance:
    """Whether a rotor is balanced (9.4): statically, G on the axis; dynamically, a principal axis.

    about : the point O; default: the foot of G, so that the two are independent. About another
        point a body that is not balanced statically changes its products of inertia: give its O.
    tolerance : relative, of the radius of gyration k about O (the root mean square distance of the
        mass from it; at least a thousandth of AB), and of m k^2
    An array is balanced if every instant is. Raises :class:`RotorError` for expressions.

    >>> from newton_euler import Frame
    >>> from newton_euler.bodies.solids import disk
    >>> shaft = Frame("shaft")
    >>> A, B = shaft.point("A", -1.0, 0, 0), shaft.point("B", 1.0, 0, 0)
    >>> balance(disk(0.5, shaft.point("G", 0, 0.1, 0), "x", mass=3.0), A, B).state
    'dynamic'
    """
    found = imbalance(body, A, B, about)
    e, product = scalar(found.static.norm()), scalar(found.dynamic.norm())
    total = sum(body.about(found.about).moments) / 2  # m k^2
    # a particle on the axis has none: at least that of the mass at a thousandth of AB
    floor = body.mass * (shaft_axis(A, B)[1] / 1000) ** 2
    if not all(map(is_numeric, (e, product, total, floor))):
        raise RotorError(
            f"the balance of {body.name} depends on expressions; put numbers in, or see imbalance"
        )
    total = where(to_plain(total) < to_plain(floor), floor, total)
    eccentricity = e / body.mass
    offset, tilt = max_abs(eccentricity / sqrt(total / body.mass)), max_abs(product / total)
    sizes = max_abs(eccentricity), max_abs(product), offset, tilt, tolerance
    return Balance(offset <= tolerance, tilt <= tolerance, *sizes)


@checked
def corrections(body: Body, A: Point, B: Point, planes: Sequence[Scalar]) -> tuple[Vector, Vector]:
    """The corrections in two planes across the axis that balance a body: two Vectors, mass times
    radius from the axis (kg m).

    planes : the distances (m) of the planes from A along the axis, positive towards B;
        :class:`RotorError` if they coincide
    With U and P the static imbalance and the products of inertia about A, at z1 and z2: U1 = (P -
    z2 U)/(z2 - z1), U2 = (z1 U - P)/(z2 - z1).

    >>> from newton_euler import Frame, particle
    >>> shaft = Frame("shaft")
    >>> A, B = shaft.origin, shaft.point("B", 0, 0, 4.0)
    >>> [U.x for U in corrections(particle(2.0, shaft.point("P", 0.5, 0, 1.0)), A, B, (2.0, 3.0))]
    [-2.0, 1.0]
    """
    z1, z2 = (scalar(z) for z in planes)
    apart = z2 - z1
    if _small(apart, 1e-13 * max(max_abs(z) if is_numeric(z) else 0.0 for z in (z1, z2))):
        raise RotorError(f"two different planes are needed; got {z1!r} and {z2!r}")
    found = imbalance(body, A, B, about=A)
    U, P = found.static, found.dynamic
    return (P - U * z2) / apart, (U * z1 - P) / apart


@checked
def balancing_masses(
    body: Body, A: Point, B: Point, planes: Sequence[Scalar], radius: Scalar | Sequence
) -> tuple[Body, Body]:
    """Two small weights, one in each of the ``planes`` of :func:`corrections`, that balance a body:
    the Bodies ``weight 1`` and ``weight 2``.

    radius : their distance from the axis (m), one number or a pair; the mass is zero where no
        weight is needed. :class:`RotorError` for a radius that is not positive
    A hole of the same mass on the opposite side is equivalent.

    >>> from newton_euler import Frame, particle
    >>> shaft = Frame("shaft")
    >>> A, B = shaft.origin, shaft.point("B", 0, 0, 4.0)
    >>> rotor = particle(2.0, shaft.point("P", 0.5, 0, 1.0))
    >>> weights = balancing_masses(rotor, A, B, (2.0, 3.0), radius=0.5)
    >>> [(w.mass, w.centre.position(shaft).components()) for w in weights]
    [(4.0, (-0.5, 0, 2.0)), (2.0, (0.5, 0, 3.0))]
    """
    pair = radius if isinstance(radius, (tuple, list)) else (radius, radius)
    for r in map(scalar, pair):
        if not is_positive(r):
            raise RotorError(
                f"the radius of the balancing weights must be positive, got {r!r}: on the axis a "
                "weight balances nothing"
            )
    e, _ = shaft_axis(A, B, body.frame)
    needed = zip((1, 2), corrections(body, A, B, planes), planes, pair, strict=True)
    return tuple(_weight(f"weight {n}", U, A, e, z, r) for n, U, z, r in needed)


def _weight(name, U, A, e, z, radius):
    """The weight of ``U`` (kg m) in the plane at ``z`` from A."""
    length = scalar(U.norm())
    # 0/1 in place of 0/0, also at instants of an array that need no weight
    size = where(to_plain(length) == 0, 1, length) if is_numeric(length) else length
    step = U * 0 if is_zero(length) else U * (radius / size)
    place = add3(A.position(e.frame).c, add3(scale3(scalar(z), e.c), step.c))
    return Body(name, length / radius, e.frame.point(name, *place))

"""Rotation about a fixed axis (chapter 9): what the two bearings of a rotor carry, and how it is
balanced.

A rotor is a :class:`~newton_euler.bodies.body.Body` that turns about the line AB of two bearings,
Points that it does not move. The unit vector e points from A to B, and every rate and moment about
the shaft is positive in the right-hand sense about e. O is a point of the axis, the bearings lie at
-a and b from it, l = a + b. With F the rate of momentum less the weight, and N the rate of angular
momentum about O less the moment of the weight, both bearings follow at once:

    A = e x (N - b e x F)/l,   B = -e x (N + a e x F)/l,   A_e + B_e = e . F,   M = e . N

which are (9.3), (9.6) and (9.9), (9.10) for a shaft in any direction. Forces act ON the shaft.

>>> from newton_euler import Frame
>>> from newton_euler.bodies.solids import disk
>>> ground = Frame("ground")
>>> shaft = ground.rotate("shaft", "x", rate=10.0)
>>> A, B = shaft.point("A", -0.2, 0, 0), shaft.point("B", 0.3, 0, 0)
>>> wheel = disk(0.1, shaft.point("G", 0, 0.01, 0), "x", mass=2.0)  # off its centre (9.2)
>>> print(reactions(wheel, A, B, ground).A)  # -m d omega^2 b/l
[0, -1.2, 0] in shaft
"""

from dataclasses import dataclass

from ..algebra.errors import NewtonEulerError
from ..algebra.ledger import equations
from ..algebra.scalars import anywhere, is_numeric, is_zero, plain, scalar, size, sqrt, where
from ..algebra.vectors import Vector, add3, dot3, named_sum, scale3, sum3
from ..bodies.body import Body
from ..kinematics.frames import Point


class RotorError(NewtonEulerError, ValueError):
    """Bearings, planes or weights that determine nothing, or an axis that does not stay at rest."""


@dataclass(frozen=True)
class Reactions:
    """What :func:`reactions` finds: ``A`` and ``B``, the transverse forces of the bearings on the
    shaft (N), Vectors in the frame of the body.

    axial : A_e + B_e (N), the force of both along the axis, from A to B; how they share it no rigid
        body tells
    moment : M (N m), the moment about the axis that drives the shaft (9.10)
    axis : the unit vector e from A to B

    The terms of A and B are those of (9.9), see :func:`reactions`; for other axes ask
    ``A.expressed_in(ground)``.
    """

    A: Vector
    B: Vector
    axial: object
    moment: object
    axis: Vector


EQUATIONS = equations({
    "bearing force": ("9.9", r"\mathbf{A}", {
        "weight": ("dead weight", r"\mathbf{A}_{mg}"),
        "static": ("m omega^2 d", r"\mathbf{A}_{m\omega^2 d}"),
        "dynamic": ("omega^2 I_xz", r"\mathbf{A}_{\omega^2 I}"),
        "static_euler": ("m omega' d", r"\mathbf{A}_{m\dot\omega d}"),
        "dynamic_euler": ("omega' I_xz", r"\mathbf{A}_{\dot\omega I}"),
    }),
})  # fmt: skip


def reactions(body, A, B, ground, gravity=None, about=None):
    """The forces of two bearings on a turning body, and the moment that drives it: a
    :class:`Reactions` (9.1)-(9.10).

    body : a Body whose frame turns in ``ground``; its rate, acceleration and angle are those of the
        frame
    A, B : the bearings, Points of the axis, fixed in the body or in a frame of the shaft
    gravity : the acceleration of gravity, a Vector (m/s^2); None: the dead weight is left out, as
        in (9.3)
    about : the point O of the axis for the terms; default: the foot of the centre of mass. It does
        not matter for the sums.
    terms of A and B, in the order of (9.9): ``weight``; ``static``, from omega^2 and the distance
        of G; ``dynamic``, from omega^2 and the products of inertia about O; ``static_euler`` and
        ``dynamic_euler``, the same from the angular acceleration
    Raises :class:`RotorError` if the bearings coincide, if ``about`` is off the axis, or if body
    and bearings move otherwise than about AB.

    >>> from newton_euler import Frame
    >>> from newton_euler.bodies.body import particle
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
    F, N = (
        Vector(sum3(v.c for v in part), body.frame) for part in zip(*pairs.values(), strict=True)
    )
    at_A, at_B = (
        named_sum(EQUATIONS["bearing force"], f"of {name} on {body.name}", at, body.frame)
        for name, at in (("A", at_A), ("B", at_B))
    )
    return Reactions(at_A, at_B, F.dot(e), N.dot(e), e)


def _wrench(body, O, ground, gravity):
    """For each term of (9.9), the force and the moment about O that the supports must give for it,
    together.
    """
    zero, f = body.frame.vector(0, 0, 0), body.frame
    I, d, m = body.about(O), (body.centre - O).expressed_in(f), body.mass
    w, turning = f.angular_velocity(ground), f.angular_acceleration(ground)
    W = zero if gravity is None else gravity.expressed_in(f) * m
    return {
        "weight": (-W, -d.cross(W)),
        "static": (w.cross(w.cross(d)) * m, zero),
        "dynamic": (zero, w.cross(I.times(w))),
        "static_euler": (turning.cross(d) * m, zero),
        "dynamic_euler": (zero, I.times(turning)),
    }


def shaft_axis(A, B, frame=None):
    """The unit vector e from bearing A to bearing B, in ``frame`` (default: that of A), and their
    distance l (m), in that order.

    Raises :class:`RotorError` if they coincide.

    >>> from newton_euler import Frame
    >>> shaft = Frame("shaft")
    >>> shaft_axis(shaft.origin, shaft.point("B", 0, 0, 2.0))
    (Vector(0, 0, 1.0 in shaft), 2.0)
    """
    for P in (A, B):
        if not isinstance(P, Point):
            raise RotorError(
                f"a bearing is a Point of the shaft, as in shaft.point('A', 0, 0, -0.2); got {P!r}"
            )
    AB = (B - A).expressed_in(frame or A.frame)
    length = AB.norm()
    if _small(length, 1e-13 * max(_extent(A), _extent(B))):
        raise RotorError(
            f"the bearings {A.name} and {B.name} coincide, and one point is no axis; put them "
            "at two places of the shaft"
        )
    return Vector(tuple(x / length for x in AB.c), AB.frame), length


def _extent(P):
    c = P.position(P.frame).c
    return size(sqrt(dot3(c, c))) if all(map(is_numeric, c)) else 0.0


def _small(x, limit=0.0):
    """True if a number (any one of an array) is not larger than ``limit``; an expression is not
    looked at.
    """
    return is_numeric(x) and anywhere(abs(plain(x)) <= limit)


def _on_axis(body, A, e, length, about):
    """The point O: the foot of G on the axis, or the one given, if it lies there."""
    if about is None:
        foot = add3(A.position(body.frame).c, scale3((body.centre - A).dot(e), e.c))
        return body.frame.point("O", *foot)
    off = e.cross(about - A).norm()
    if is_numeric(off) and is_numeric(length) and size(off) > 1e-9 * size(length):
        raise RotorError(
            f"{about.name} lies {size(off):.3g} off the axis of the bearings; take a point of "
            "the axis, or leave about= out"
        )
    return about


def _check_motion(body, A, e, length, ground):
    """Points of the axis must rest, and the body turn about it; seen at numbers only."""
    w, turning, v = (
        body.frame.angular_velocity(ground),
        body.frame.angular_acceleration(ground),
        A.velocity(ground),
    )
    for name, vector, scale in (
        ("its angular velocity", w.cross(e), w.norm()),
        ("its angular acceleration", turning.cross(e), turning.norm()),
        (f"the velocity of {A.name}", v, length * w.norm()),
    ):
        parts = [*vector.c, scalar(scale)]
        if all(map(is_numeric, parts)) and size(vector.norm()) > 1e-9 * size(scale):
            raise RotorError(
                f"{body.name} does not turn about its bearings as a fixed axis: {name} has "
                f"{size(vector.norm()):.3g} across it; "
                f"turn the frame of the body in {ground.name} about the line AB, as in "
                "ground.rotate('shaft', 'z', rate=...)"
            )


# -- balance


@dataclass(frozen=True)
class Imbalance:
    """The two things that balancing removes (9.4), Vectors at right angles to the axis, in the
    frame of the body.

    static : m d (kg m), d from the axis to G
    dynamic : the products of inertia with the axis (kg m^2), the integral of z r dm, z along the
        axis from O, r from the axis
    about : the point O
    """

    static: Vector
    dynamic: Vector
    about: Point


def imbalance(body, A, B, about=None):
    """Static and dynamic imbalance of a body for the axis AB: an :class:`Imbalance`. For scalars of
    every kind.

    about : the point O of the axis for the products of inertia; default: the foot of G, where they
        are those about G

    >>> from newton_euler import Frame
    >>> from newton_euler.bodies.body import particle
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
    """The verdict of :func:`balance`: ``static`` and ``dynamic`` are True or False; ``str()`` gives
    it in words with its evidence.

    eccentricity : distance of G from the axis, m; product : size of the products of inertia with
        the axis about O, kg m^2
    offset, tilt : the same as pure numbers, as parts of the radius of gyration k about O and of m
        k^2; they are compared with ``tolerance``
    """

    static: bool
    dynamic: bool
    eccentricity: float
    product: float
    offset: float
    tilt: float
    tolerance: float

    @property
    def state(self):
        """One of "both", "static", "dynamic", "neither"."""
        return {
            (True, True): "both",
            (True, False): "static",
            (False, True): "dynamic",
            (False, False): "neither",
        }[self.static, self.dynamic]

    def __str__(self):
        words = {True: "balanced", False: "not balanced"}
        return (
            f"statically {words[self.static]}: G is {self.eccentricity:.3g} off the axis, "
            f"{self.offset:.3g} of the radius of gyration; "
            f"dynamically {words[self.dynamic]}: the products of inertia with the axis are "
            f"{self.product:.3g}, {self.tilt:.3g} of the moment of "
            f"inertia (tolerance {self.tolerance:.3g})"
        )


def balance(body, A, B, about=None, tolerance=1e-9):
    """Is the rotor balanced (9.4)? A :class:`Balance`: statically, G on the axis; dynamically, the
    axis a principal one at O.

    about : the point O; default: the foot of G, so that the two are independent of each other.
        About another point a body that is not balanced statically changes its products of inertia:
        give the O of the exercise.
    tolerance : relative, of the radius of gyration k about O (the root mean square distance of the
        mass from it; at least a thousandth of AB), and of m k^2
    Of an array every instant must be balanced. Raises :class:`RotorError` for expressions, which
    have no size: look at :func:`imbalance` there.

    >>> from newton_euler import Frame
    >>> from newton_euler.bodies.solids import disk
    >>> shaft = Frame("shaft")
    >>> A, B = shaft.point("A", -1.0, 0, 0), shaft.point("B", 1.0, 0, 0)
    >>> balance(disk(0.5, shaft.point("G", 0, 0.1, 0), "x", mass=3.0), A, B).state
    'dynamic'
    """
    found = imbalance(body, A, B, about)
    I, e, product = (
        body.about(found.about),
        scalar(found.static.norm()),
        scalar(found.dynamic.norm()),
    )
    total = _at_least(sum(I.moments) / 2, body.mass * (shaft_axis(A, B)[1] / 1000) ** 2)  # m k^2
    if not all(map(is_numeric, (e, product, total, body.mass))):
        raise RotorError(
            f"whether {body.name} is balanced depends on the values of its expressions; put in "
            "numbers, or look at imbalance(...)"
        )
    eccentricity = e / body.mass
    offset, tilt = size(eccentricity / sqrt(total / body.mass)), size(product / total)
    return Balance(
        offset <= tolerance,
        tilt <= tolerance,
        size(eccentricity),
        size(product),
        offset,
        tilt,
        tolerance,
    )


def _at_least(x, floor):
    return where(plain(x) < plain(floor), floor, x) if is_numeric(x) and is_numeric(floor) else x


# -- balancing


def corrections(body, A, B, planes):
    """What must be added in two planes across the axis to balance a body: two Vectors, mass times
    radius from the axis (kg m).

    planes : the distances (m) of the two planes from A along the axis, positive towards B; outside
        of the bearings too
    With U and P the static imbalance and the products of inertia about A, at z1 and z2: U1 = (P -
    z2 U)/(z2 - z1), U2 = (z1 U - P)/(z2 - z1). Raises :class:`RotorError` if the planes coincide.

    >>> from newton_euler import Frame
    >>> from newton_euler.bodies.body import particle
    >>> shaft = Frame("shaft")
    >>> A, B = shaft.origin, shaft.point("B", 0, 0, 4.0)
    >>> [U.x for U in corrections(particle(2.0, shaft.point("P", 0.5, 0, 1.0)), A, B, (2.0, 3.0))]
    [-2.0, 1.0]
    """
    z1, z2 = (scalar(z) for z in planes)
    apart = z2 - z1
    if _small(apart, 1e-13 * max(size(z) if is_numeric(z) else 0.0 for z in (z1, z2))):
        raise RotorError(
            f"the two planes coincide, at {plain(z1)!r} and {plain(z2)!r} from {A.name}; a "
            "couple needs two different planes"
        )
    found = imbalance(body, A, B, about=A)
    U, P = found.static, found.dynamic
    return (P - U * z2) / apart, (U * z1 - P) / apart


def balancing_masses(body, A, B, planes, radius=None, mass=None):
    """Two small weights that balance a body statically and dynamically, one in each plane: two
    Bodies, ``weight 1`` and ``weight 2``.

    planes : as for :func:`corrections`
    radius : at which distance from the axis they go (m), one number or a pair; their masses follow
    mass : how heavy they are (kg), one number or a pair; their distances follow. Give one of the
        two.
    ``composite("balanced", [body, *weights])`` has no dynamic reactions. Where no weight is needed
    it has mass (or radius) zero. A hole of the same mass on the opposite side does the same. Raises
    :class:`RotorError` for a radius or mass that is not positive.

    >>> from newton_euler import Frame
    >>> from newton_euler.bodies.body import particle
    >>> shaft = Frame("shaft")
    >>> A, B = shaft.origin, shaft.point("B", 0, 0, 4.0)
    >>> weights = balancing_masses(particle(2.0, shaft.point("P", 0.5, 0, 1.0)), A, B, (2.0, 3.0), radius=0.5)
    >>> [(w.mass, w.centre.position(shaft).components()) for w in weights]
    [(4.0, (-0.5, 0, 2.0)), (2.0, (0.5, 0, 3.0))]
    """
    if (radius is None) == (mass is None):
        raise RotorError(
            "give either the radius at which the weights go, or their mass: radius=0.1 or "
            "mass=(0.02, 0.03)"
        )
    what, given = ("radius", radius) if mass is None else ("mass", mass)
    given = given if isinstance(given, (tuple, list)) else (given, given)
    for x in given:
        _check_positive(what, scalar(x))
    e, _ = shaft_axis(A, B, body.frame)
    needed = corrections(body, A, B, planes)
    return tuple(
        _weight(n, U, A, e, z, x, mass is None)
        for n, (U, z, x) in enumerate(zip(needed, planes, given, strict=True), start=1)
    )


def _weight(number, U, A, e, z, given, at_radius):
    """The weight that is ``U`` (kg m), in the plane at ``z`` from A, at a given radius or of a
    given mass.
    """
    length = scalar(U.norm())
    none = is_zero(length)
    step = U * 0 if none else U * (given / _nonzero(length)) if at_radius else U / given
    mass = length / given if at_radius else given
    place = add3(A.position(e.frame).c, add3(scale3(scalar(z), e.c), step.c))
    return Body(f"weight {number}", mass, e.frame.point(f"weight {number}", *place))


def _nonzero(x):
    return where(plain(x) == 0, 1, x) if is_numeric(x) else x


def _check_positive(what, x):
    if is_numeric(x) and (_small(x) or size(x - abs(x)) > 0):
        told = (
            "on the axis a weight balances nothing"
            if what == "radius"
            else "a weight without mass balances nothing"
        )
        raise RotorError(
            f"the {what} of the balancing weights must be positive, got {plain(x)!r}: {told}"
        )

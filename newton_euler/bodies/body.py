"""Rigid bodies: mass, centre of mass, inertia, momentum and angular momentum (chapters 5 and 7), in
any consistent units; for the sign of the products see :class:`newton_euler.bodies.inertia.Inertia`.
"""

from collections.abc import Iterable, Sequence

from ..algebra.errors import Tolerance, checked, checked_but
from ..algebra.ledger import Terms
from ..algebra.otherwise import built
from ..algebra.scalars import Scalar, clipped, is_numeric, max_abs, real_scalar, short_repr
from ..algebra.vectors import Vector, sum3
from ..kinematics.frames import Frame, Point, PointLike, as_point, axes_at
from .admissibility import MassError, not_negative, positive, round_off, triangle_inequality
from .inertia import Inertia, together

# fraction of the largest moment by which moments given in rounded numbers may violate the triangle
# inequality; Body.check() is stricter
ROUNDED = 1e-2


@checked
class Body:
    """A rigid body: mass, centre of mass, inertia matrix; or several, see :func:`composite`.

    centre : the centre of mass G, a Point of the body, or a Frame whose origin is G
    inertia : three principal moments about G along the axes of the frame, or any :class:`Inertia`
    frame : the frame fixed in the body; default: that of ``inertia``, or the one in which G is
        given (``rotor.origin`` is a point of the *parent* of rotor: give ``rotor`` itself for G)

    >>> from newton_euler import Frame
    >>> body = Frame("wheel")
    >>> wheel = Body("wheel", 2.0, body, (0.1, 0.05, 0.05))
    >>> wheel.about(body.point("rim", 0, 0.5, 0)).moments
    (0.6, 0.05, 0.55)
    """

    def __init__(
        self,
        name: str,
        mass: Scalar,
        centre: PointLike,
        inertia: Inertia | Sequence[Scalar] = (0, 0, 0),
        frame: Frame | None = None,
        parts: Sequence["Body"] = (),
    ):
        self.name, self.parts, mass = name, tuple(parts), real_scalar(mass)
        self.centre = G = as_point(centre, f"the centre of mass of {name}")
        if not isinstance(inertia, Inertia):
            inertia = Inertia(G, inertia, frame=frame or axes_at(G), tolerance=None)
            not_negative(mass, f"the mass of {name}")
            triangle_inequality(inertia.moments, ROUNDED)
        self.frame = frame or inertia.frame
        own = built("body", (mass, *inertia.products, *inertia.moments))
        self.mass, products, moments = own[0], own[1:4], own[4:]
        self._inertia = inertia._like(moments, products, mass=self.mass, centre=G)

    def __repr__(self):
        return f"Body({self.name}, mass {short_repr(self.mass)}, centre {self.centre!r})"

    @property
    def inertia(self) -> Inertia:
        """The :class:`Inertia` about the centre of mass, along the axes of the body's frame."""
        return self.about(self.centre)

    def about(self, point: PointLike, frame: Frame | None = None) -> Inertia:
        """The :class:`Inertia` about ``point`` (7.26), of a composite that of all parts (7.14),
        along the axes of ``frame`` (default: that of the body); terms ``own`` and ``transfer``, or
        the parts by name.
        """
        frame, point = self.frame if frame is None else frame, as_point(point, "the inertia matrix")
        if not self.parts:
            I = self._inertia
            return I.expressed_in(frame).about(point) if I.frame is not frame else I.about(point)
        terms = Terms((part.name, part.about(point, frame)) for part in self.parts)
        moments = sum3(I.moments for I in terms.values())
        products = sum3(I.products for I in terms.values())
        total = Inertia(point, moments, products, self.mass, self.centre, frame, None)
        total._terms = terms
        return total

    def __neg__(self) -> "Body":
        """The body with negative mass, as a hole."""
        parts = [-part for part in self.parts]
        return Body(self.name, -self.mass, self.centre, -self._inertia, self.frame, parts)

    @checked
    def check(self, tolerance: Tolerance = 1e-9) -> "Body":
        """The body itself; :class:`MassError` if it is impossible, see :meth:`Inertia.check`."""
        self.inertia.check(tolerance)
        return self

    @checked
    def momentum(self, observer: Frame) -> Vector:
        """L = m v_G seen from ``observer`` (5.2), (5.8), (7.5)."""
        return self.centre.velocity(observer) * self.mass

    @checked
    def angular_momentum(self, observer: Frame, about: Point | None = None) -> Vector:
        """H about G, or H_B = d x m Dd/Dt + H_G about any point B, d the vector from B to G (7.23),
        terms ``orbital``, ``own``: the *relative* angular momentum (7.6), equal to the absolute one
        if B is fixed in ``observer``.
        """
        own = self.inertia.times(self.frame.angular_velocity(observer))
        if about is None or about is self.centre:
            return own
        v = self.centre.velocity(observer).expressed_in(self.frame) - about.velocity(observer)
        orbital = (self.centre - about).expressed_in(self.frame).cross(v * self.mass)
        total = orbital + own
        subject = f"of {self.name} about {about.name}, seen from {observer.name}"
        return total.as_sum("angular momentum", subject, lambda: {"orbital": orbital, "own": own})


@checked
def particle(mass: Scalar, point: PointLike, name: str = "particle") -> Body:
    """A particle of this mass at a point: a :class:`Body` without moments of its own.

    >>> from newton_euler import Frame
    >>> ground = Frame("ground")
    >>> particle(2.0, ground.point("P", 3.0, 0, 0)).about(ground.origin).moments
    (0, 18.0, 18.0)
    """
    positive(mass, f"the mass of {name}")
    centre = as_point(point, name)
    return Body(name, mass, centre, frame=centre.frame)


@checked_but("parts")
def centre_of_mass(
    parts: Iterable[Body | tuple[Scalar, Point]], frame: Frame | None = None, name: str = "G"
) -> Point:
    """The centre of mass of particles and bodies together, a Point of ``frame`` (default: that of
    the first part) (5.4), (5.9), (5.11). Raises :class:`MassError` unless its mass is positive.

    parts : bodies, or pairs (mass, Point); a removed part has negative mass, as in ``-hole``

    >>> from newton_euler import Frame
    >>> ground = Frame("ground")
    >>> centre_of_mass([(1.0, ground.origin), (3.0, ground.point("P", 2.0, 0, 0))]).position(ground)
    Vector(1.5, 0, 0 in ground)
    """
    bodies = [p if isinstance(p, Body) else _pair(p) for p in parts]
    if not bodies:
        raise MassError("the centre of mass of nothing: give a body or a pair (mass, Point)")
    return together(bodies, frame or bodies[0].frame, name)[1]


def _pair(p):
    try:
        mass, point = p
        # no check of the mass: a removed part has a negative one
        return Body(point.name, mass, point, Inertia(point, (0, 0, 0), tolerance=None), point.frame)
    except (TypeError, ValueError, AttributeError):
        raise MassError(f"a part is a Body or a pair (mass, Point), got {p!r}") from None


@checked
def composite(
    name: str, parts: Iterable[Body], removed: Iterable[Body] = (), frame: Frame | None = None
) -> Body:
    """A rigid body made of parts, with holes as parts of negative mass (5.11), (7.14).

    parts, removed : bodies, all fixed in one rigid body; they are the terms of ``body.about(P)``
    frame : the frame of the whole; default: that of the first part
    Raises :class:`MassError` without mass, or for moments that no body has (a hole outside).

    >>> from newton_euler import Frame
    >>> from newton_euler.bodies.solids import disk
    >>> sheet = Frame("sheet")
    >>> hole = disk(0.1, sheet.point("C", 0.2, 0, 0), "z", density=10.0, name="hole")
    >>> part = composite("washer", [disk(0.5, sheet, "z", density=10.0)], removed=[hole])
    >>> round(part.centre.position(sheet).x, 6)
    -0.008333
    """
    parts, removed = list(parts), list(removed)
    for part in parts + removed:
        if not isinstance(part, Body):
            raise MassError(f"the parts of {name} are bodies; got {clipped(part)}")
    parts += [-hole for hole in removed]
    if not parts:
        raise MassError(f"{name} has no parts")
    frame = frame or parts[0].frame
    mass, centre = together(parts, frame, f"G of {name}")
    body = Body(name, mass, centre, frame=frame, parts=parts)
    if not removed:
        return body
    # round-off of the difference of large moments
    slack = sum(round_off(part.mass, (part.centre, centre), frame) for part in parts)
    slack += 1e-14 * sum(max_abs(x) for p in parts for x in p.inertia.moments if is_numeric(x))
    try:
        body.inertia.check(slack=slack)
        return body
    except MassError as problem:
        raise MassError(
            f"{name}: do the removed parts lie inside of it, and only once? {problem}"
        ) from None

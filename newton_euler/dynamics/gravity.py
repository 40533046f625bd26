"""Gravitation and weight (chapter 5). The constant of gravitation K, as in the book, and g are
arguments everywhere, for other units and other planets.
"""

from ..algebra.errors import checked
from ..algebra.scalars import Scalar, integer_like, scalar, sqrt, to_plain
from ..algebra.vectors import Vector
from ..bodies.admissibility import not_negative, positive
from ..bodies.body import Body
from ..kinematics.frames import Frame, Point, as_point

K = 6.673e-11  # m^3/(kg s^2), as in the book; CODATA 2018 has 6.67430e-11
G_STANDARD = 9.81  # m/s^2, the book's flat earth


@checked
def attraction(m1: Scalar, m2: Scalar, distance: Scalar, K: Scalar = K) -> Scalar:
    """The magnitude F = K m1 m2/r^2 of the attraction of two particles, or of radially symmetric
    bodies outside of each other (5.21).

    >>> round(attraction(5.97e24, 1.0, 6.371e6), 2)
    9.81
    """
    positive(scalar(distance), "the distance of the two bodies")
    for m in (m1, m2):
        not_negative(m, "the mass of a body")
    # each mass by the distance, since their product and its square overflow first
    return to_plain(K * (m1 / distance) * (m2 / distance))


@checked
def gravitation(on: Body, by: Body, K: Scalar = K, frame: Frame | None = None) -> Vector:
    """The force on one body by the attraction of another, toward the other (5.20), (5.22).

    on, by : bodies, taken as particles in their centres of mass: exact if they are radially
        symmetric
    frame : in whose components; default: that of the first body

    >>> from newton_euler import Frame, particle
    >>> space = Frame("space")
    >>> ball, star = particle(2.0, space.origin), particle(3.0, space.point("P", 0, 2.0, 0))
    >>> gravitation(ball, star, K=1.0)
    Vector(0, 1.5, 0 in space)
    """
    r = (by.centre - on.centre).expressed_in(frame or on.frame)
    distance = scalar(r.norm())
    positive(distance, f"the distance of {on.name} and {by.name}")
    return r / distance * (K * (on.mass / distance) * (by.mass / distance))


@checked
def gravity_at_surface(mass: Scalar, radius: Scalar, K: Scalar = K) -> Scalar:
    """The acceleration of gravity g = K M/R^2 at the surface of a planet without rotation (5.24).

    >>> round(gravity_at_surface(5.972e24, 6.371e6), 3)
    9.818
    """
    return attraction(mass, 1, radius, K)


@checked
def gravity_at_height(height: Scalar, radius: Scalar, g: Scalar = G_STANDARD) -> Scalar:
    """The acceleration g (R/(R + h))^2 at a height, from g at the surface (5.22), (5.23).

    >>> gravity_at_height(6.4e6, 6.4e6, g=8.0)
    2.0
    """
    positive(scalar(radius), "the radius of the planet")
    ratio = radius / (radius + height)
    return to_plain(g * (ratio * ratio))


@checked
def weight(body: Body | Scalar, up: Vector, g: Scalar = G_STANDARD) -> Vector:
    """The weight W = -m g k over a flat earth (5.25)-(5.27).

    body : a body, or its mass; up : the upward vertical, a Vector of any length, as ``ground.k``
    g : m/s^2; in English units give the mass in slug and ``g=32.2``

    >>> from newton_euler import Frame
    >>> weight(2.0, Frame("ground").k)
    Vector(0, 0, -19.62 in ground)
    """
    m = scalar(body.mass if isinstance(body, Body) else body)
    if not isinstance(body, Body):  # a hole has a negative mass
        not_negative(m, "the mass")
    force = m * g
    square = scalar(up.dot(up))
    positive(square, "the length of the upward direction")
    # the root of a whole number is as exact as the force is
    return up * -force / sqrt(integer_like(square, force))


@checked
def mass_from_weight(weight: Scalar, g: Scalar = G_STANDARD) -> Scalar:
    """The mass m = W/g (5.26); in slug from a weight in lb with ``g=32.2``.

    >>> mass_from_weight(64.4, g=32.2)
    2.0
    """
    positive(scalar(g), "the acceleration of gravity")
    return to_plain(scalar(weight) / g)


@checked
def gravitational_field(
    position: Point | Frame, mass: Scalar, centre: Point | Frame, K: Scalar = K
) -> Vector:
    """The acceleration of gravity at a place, toward the ``centre`` of a radially symmetric body of
    this mass: g = -K M/r^2 e_r (5.22), (5.23), in the frame of ``position``.

    >>> from newton_euler import Frame
    >>> space = Frame("space")
    >>> gravitational_field(space.point("P", 2.0, 0, 0), 8.0, space, K=1.0)
    Vector(-2.0, 0, 0 in space)
    """
    not_negative(mass, "the mass of the body")
    position = as_point(position, "the field point")
    r = position - as_point(centre, "the centre of attraction")
    distance = scalar(r.norm())
    positive(distance, f"the distance of {position.name} from the centre of attraction")
    return r / distance * -(K * (mass / distance) / distance)

"""Homogeneous rods, wires, plates, shells and solids as bodies: the table of Appendix B and more.

Place: the last point given is its centre, its apex or the centre of its circle. The frame of that
point is the frame of the body; a Frame stands for its own origin.

Direction: ``axis`` is the axis of that frame along which the axis or normal of the body lies: "x"
as in the book's table, "y", "z", or with a minus sign where the body has a sense. For any other
direction give the body a frame of its own, ``ground.rotate(...)``.

Mass: either ``mass=`` or ``density=`` is given, the mass per length, area or volume. ``name=``
names the body; default: the name of the shape. :class:`MassError` for what is not positive.

>>> from newton_euler import Frame
>>> part = Frame("part")
>>> cylinder(0.1, 0.6, part, "x", mass=2.0).inertia.moments  # (m a^2/2, m (3 a^2 + L^2)/12 twice)
(0.010000000000000002, 0.065, 0.065)
"""

from typing import TypedDict, Unpack

from ..algebra.errors import checked
from ..algebra.scalars import ZERO, Scalar, clipped, pi, real_scalar, scalar, sin, sqrt
from ..algebra.vectors import add3, cross3, dot3, scale3, sub3, sum3
from ..kinematics.frames import Point, PointLike, as_point, axes_at
from .admissibility import AXES, MassError, positive
from .body import Body
from .inertia import SECOND_MOMENTS, Inertia, axis_index, from_second_moments


class Matter(TypedDict, total=False):
    """The keyword arguments of every solid: ``mass`` or ``density``, and ``name``."""

    mass: Scalar
    density: Scalar
    name: str


# -- along lines


@checked
def rod(length: Scalar, centre: PointLike, axis: str = "x", **matter: Unpack[Matter]) -> Body:
    """A thin straight rod about its middle: 0, m L^2/12 twice (App. B). See :func:`simplex`."""
    name, m = _mass("rod", matter, length, length=length)
    return _of_revolution(name, centre, axis, m, ZERO, m * length**2 / 12)


@checked
def ring(radius: Scalar, centre: PointLike, axis: str = "x", **matter: Unpack[Matter]) -> Body:
    """A thin wire bent to a circle: m r^2 about its axis, m r^2/2 about a diameter."""
    name, m = _mass("ring", matter, 2 * pi(radius) * radius, radius=radius)
    return _of_revolution(name, centre, axis, m, m * radius**2, m * radius**2 / 2)


@checked
def arc(
    radius: Scalar,
    half_angle: Scalar,
    middle: PointLike,
    axis: str = "x",
    toward: str | None = None,
    **matter: Unpack[Matter],
) -> Body:
    """A thin wire along a circular arc of twice ``half_angle`` (rad, up to pi).

    middle : the centre of the circle; G lies r sin(a)/a from it
    axis, toward : normal to the plane of the arc; from ``middle`` to the middle of the arc, by
        default along the next axis in the order x, y, z, x
    For small angles a the moments about G lose as many digits as 1/a^2 has.
    """
    name, m = _mass("arc", matter, 2 * half_angle * radius, radius=radius, half_angle=half_angle)
    distance, flatness = _sine_ratios(half_angle)
    return _fan(name, middle, axis, toward, m, radius * distance, m * radius**2, flatness)


@checked
def half_ring(
    radius: Scalar,
    middle: PointLike,
    axis: str = "x",
    toward: str | None = None,
    **matter: Unpack[Matter],
) -> Body:
    """A thin wire along half a circle; G lies 2 r/pi from ``middle``. Otherwise as :func:`arc`."""
    matter.setdefault("name", "half ring")
    return arc(radius, pi(radius) / 2, middle, axis, toward, **matter)


# -- flat


@checked
def plate(
    b: Scalar, c: Scalar, centre: PointLike, axis: str = "x", **matter: Unpack[Matter]
) -> Body:
    """A thin rectangular plate with normal ``axis`` (App. B), b and c along the next two axes."""
    name, m = _mass("plate", matter, b * c, b=b, c=c)
    bb, cc = m * b**2 / 12, m * c**2 / 12
    return _placed(name, centre, axis, m, (bb + cc, cc, bb))


@checked
def disk(radius: Scalar, centre: PointLike, axis: str = "x", **matter: Unpack[Matter]) -> Body:
    """A thin round disk: m r^2/2 about its axis, m r^2/4 about a diameter (App. B)."""
    name, m = _mass("disk", matter, pi(radius) * radius**2, radius=radius)
    return _of_revolution(name, centre, axis, m, m * radius**2 / 2, m * radius**2 / 4)


@checked
def annulus(
    inner: Scalar, outer: Scalar, centre: PointLike, axis: str = "x", **matter: Unpack[Matter]
) -> Body:
    """A flat ring: m (r1^2 + r2^2)/2 about its axis, half of it about a diameter."""
    wall = outer - inner
    area = pi(outer) * (wall * (outer + inner))
    name, m = _mass("annulus", matter, area, inner=inner, outer=outer, wall=wall)
    polar = m * (inner**2 + outer**2) / 2
    return _of_revolution(name, centre, axis, m, polar, polar / 2)


@checked
def sector(
    radius: Scalar,
    half_angle: Scalar,
    middle: PointLike,
    axis: str = "x",
    toward: str | None = None,
    **matter: Unpack[Matter],
) -> Body:
    """A thin sector of a disk, of twice ``half_angle`` (rad), with its tip at ``middle``; G lies 2
    r sin(a)/(3 a) from the tip. Directions and small angles as for :func:`arc`.
    """
    area = half_angle * radius**2
    name, m = _mass("sector", matter, area, radius=radius, half_angle=half_angle)
    distance, flatness = _sine_ratios(half_angle)
    distance = 2 * radius * distance / 3
    return _fan(name, middle, axis, toward, m, distance, m * radius**2 / 2, flatness)


@checked
def half_disk(
    radius: Scalar,
    middle: PointLike,
    axis: str = "x",
    toward: str | None = None,
    **matter: Unpack[Matter],
) -> Body:
    """A thin half disk, ``middle`` that of its straight edge; G lies 4 r/(3 pi) from there.
    Directions as for :func:`arc`.
    """
    matter.setdefault("name", "half disk")
    return sector(radius, pi(radius) / 2, middle, axis, toward, **matter)


# -- solid


@checked
def box(
    a: Scalar, b: Scalar, c: Scalar, centre: PointLike, axis: str = "x", **matter: Unpack[Matter]
) -> Body:
    """A rectangular prism (App. B): edge a along ``axis``, b and c along the two that follow it."""
    name, m = _mass("box", matter, a * b * c, a=a, b=b, c=c)
    return _placed(name, centre, axis, m, _sums_of_squares(m, a, b, c, 12))


@checked
def cylinder(
    radius: Scalar, length: Scalar, centre: PointLike, axis: str = "x", **matter: Unpack[Matter]
) -> Body:
    """A circular cylinder: m a^2/2, m (3 a^2 + L^2)/12 twice (App. B)."""
    volume = pi(radius) * radius**2 * length
    name, m = _mass("cylinder", matter, volume, radius=radius, length=length)
    across = m * (3 * radius**2 + length**2) / 12
    return _of_revolution(name, centre, axis, m, m * radius**2 / 2, across)


@checked
def tube(
    inner: Scalar,
    outer: Scalar,
    length: Scalar,
    centre: PointLike,
    axis: str = "x",
    **matter: Unpack[Matter],
) -> Body:
    """A hollow cylinder, open at its ends: m s/2, m (3 s + L^2)/12 twice, with s = r1^2 + r2^2."""
    wall, squares = outer - inner, inner**2 + outer**2
    volume = pi(outer) * (wall * (outer + inner)) * length
    name, m = _mass("tube", matter, volume, inner=inner, outer=outer, wall=wall, length=length)
    across = m * (3 * squares + length**2) / 12
    return _of_revolution(name, centre, axis, m, m * squares / 2, across)


@checked
def wedge(
    radius: Scalar,
    half_angle: Scalar,
    length: Scalar,
    middle: PointLike,
    axis: str = "x",
    toward: str | None = None,
    **matter: Unpack[Matter],
) -> Body:
    """A sector of a solid cylinder, ``middle`` of its edge; directions as for :func:`arc`."""
    volume = half_angle * radius**2 * length
    name, m = _mass("wedge", matter, volume, radius=radius, half_angle=half_angle, length=length)
    flat = sector(radius, half_angle, middle, axis, toward, mass=m, name=name)
    added = [m * length**2 / 12] * 3
    added[axis_index(axis)[0]] = ZERO
    return Body(name, m, flat.centre, add3(flat.inertia.moments, tuple(added)))


@checked
def cone(
    radius: Scalar, height: Scalar, apex: PointLike, axis: str = "x", **matter: Unpack[Matter]
) -> Body:
    """A circular cone, ``axis`` pointing from its apex to its base (App. B); G lies 3 h/4 from the
    apex. Moments about G: 3 m a^2/10, 3 m (4 a^2 + h^2)/80 twice; the book's:
    ``cone(...).about(apex)``.
    """
    volume = pi(radius) * radius**2 * height / 3
    name, m = _mass("cone", matter, volume, radius=radius, height=height)
    across = 3 * m * (4 * radius**2 + height**2) / 80
    return _of_revolution(name, apex, axis, m, 3 * m * radius**2 / 10, across, 3 * height / 4)


@checked
def sphere(radius: Scalar, centre: PointLike, **matter: Unpack[Matter]) -> Body:
    """A solid sphere: 2 m a^2/5 (App. B)."""
    name, m = _mass("sphere", matter, 4 * pi(radius) * radius**3 / 3, radius=radius)
    return _placed(name, centre, "x", m, (2 * m * radius**2 / 5,) * 3)


@checked
def hemisphere(
    radius: Scalar, middle: PointLike, axis: str = "x", **matter: Unpack[Matter]
) -> Body:
    """A solid half sphere: 2 m r^2/5, 83 m r^2/320 twice. ``axis`` points from ``middle``, the
    centre of its flat face, into the solid, and G lies 3 r/8 from there.
    """
    name, m = _mass("hemisphere", matter, 2 * pi(radius) * radius**3 / 3, radius=radius)
    moments = 2 * m * radius**2 / 5, 83 * m * radius**2 / 320
    return _of_revolution(name, middle, axis, m, *moments, 3 * radius / 8)


@checked
def ellipsoid(
    a: Scalar, b: Scalar, c: Scalar, centre: PointLike, axis: str = "x", **matter: Unpack[Matter]
) -> Body:
    """A solid ellipsoid: m (b^2 + c^2)/5 …; half axis a along ``axis``, b and c along the next."""
    name, m = _mass("ellipsoid", matter, 4 * pi(a) * (a * b * c) / 3, a=a, b=b, c=c)
    return _placed(name, centre, axis, m, _sums_of_squares(m, a, b, c, 5))


# -- shells


@checked
def cylindrical_shell(
    radius: Scalar, length: Scalar, centre: PointLike, axis: str = "x", **matter: Unpack[Matter]
) -> Body:
    """A thin tube, open at its ends: m r^2, m (6 r^2 + L^2)/12 twice."""
    area = 2 * pi(radius) * radius * length
    name, m = _mass("cylindrical shell", matter, area, radius=radius, length=length)
    across = m * (6 * radius**2 + length**2) / 12
    return _of_revolution(name, centre, axis, m, m * radius**2, across)


@checked
def spherical_shell(radius: Scalar, centre: PointLike, **matter: Unpack[Matter]) -> Body:
    """A thin hollow sphere: 2 m r^2/3."""
    name, m = _mass("spherical shell", matter, 4 * pi(radius) * radius**2, radius=radius)
    return _placed(name, centre, "x", m, (2 * m * radius**2 / 3,) * 3)


# -- between points


@checked
def simplex(*corners: Point, **matter: Unpack[Matter]) -> Body:
    """The body between two, three or four Points: a thin rod, a thin triangular plate, a solid
    tetrahedron, in the frame of the first point. About G the integral of x_i x_j is m/((n+1)(n+2))
    times the sum of x_i x_j over the corners, with n = 1, 2, 3 for rod, plate and tetrahedron.

    >>> from newton_euler import Frame
    >>> ground = Frame("ground")
    >>> simplex(ground.origin, ground.point("B", 2.0, 0, 0), mass=3.0).about(ground.origin).moments
    (0, 4.0, 4.0)
    """
    n = len(corners) - 1
    if n not in (1, 2, 3) or not all(isinstance(P, Point) for P in corners):
        raise MassError(f"a simplex has two to four corners, all Points; got {corners!r}")
    frame = corners[0].frame
    first, *others = (P.position(frame).c for P in corners)
    edges = [sub3(c, first) for c in others]
    name, m = _mass(("rod", "triangle", "tetrahedron")[n - 1], matter, _content(edges))
    # not times 1/(n + 1), which would round before an mpf or a fraction comes in
    middle = tuple(x / (n + 1) for x in sum3(edges))
    arms = [scale3(-1, middle), *(sub3(e, middle) for e in edges)]
    sums = (sum((arm[a] * arm[b] for arm in arms), ZERO) for a, b in SECOND_MOMENTS)
    second = [x * m / ((n + 1) * (n + 2)) for x in sums]
    G = frame.point(f"G of {name}", *add3(first, middle))
    return Body(name, m, G, Inertia(G, *from_second_moments(second), m, G, frame, None))


def _content(edges):
    """Length, area or volume of the simplex with these edges from one corner."""
    if len(edges) == 3:
        return abs(dot3(edges[0], cross3(edges[1], edges[2]))) / 6
    spanned = edges[0] if len(edges) == 1 else cross3(*edges)
    return sqrt(dot3(spanned, spanned)) / len(edges)


# -- used by all bodies of the table


def _mass(shape, matter, content, **lengths):
    """Name and mass of a body of this length, area or volume, after a check of its lengths."""
    name, mass, density = _named(shape, **matter)
    for what, x in lengths.items():
        positive(scalar(x), f"the {what.replace('_', ' ')} of {name}")
    if (mass is None) == (density is None):
        got = ", and got none" if mass is None else ", not both"
        raise MassError(f"{name} needs either mass= or density= (per length, area or volume){got}")
    m = scalar(density) * content if mass is None else real_scalar(mass)
    positive(m, f"the mass of {name}")
    return name, m


def _named(shape, mass=None, density=None, name=None):
    if name is not None and not isinstance(name, str):
        raise MassError(f"the name of a body is a text, as name='hole'; got {clipped(name)}")
    return name or shape, mass, density


def _sums_of_squares(m, a, b, c, divisor):
    """The three moments m (b^2 + c^2)/divisor and so on."""
    aa, bb, cc = (m * e**2 / divisor for e in (a, b, c))
    return bb + cc, cc + aa, aa + bb


def _sine_ratios(half_angle):
    """sin(a)/a and sin(2 a)/(2 a)."""
    return sin(half_angle) / half_angle, sin(2 * half_angle) / (2 * half_angle)


def _of_revolution(name, point, axis, m, axial, across, along=ZERO):
    """The body with moments about G along ``axis`` and across; G lies ``along`` from ``point``."""
    return _placed(name, point, axis, m, (axial, across, across), along)


def _placed(name, point, axis, m, moments, along=ZERO):
    """The body with moments about G along ``axis`` and the next two; G ``along`` from ``point``."""
    n, sign = axis_index(axis)
    turned = tuple(moments[(k - n) % 3] for k in range(3))
    return Body(name, m, _shifted(name, as_point(point, name), n, sign * along), turned)


def _fan(name, middle, axis, toward, m, distance, polar, flatness=ZERO):
    """A flat body symmetric about ``toward``; ``polar``: its moment about ``axis`` through
    ``middle``; ``flatness``: (second moment along ``toward`` - that across it)/polar.
    """
    n, _ = axis_index(axis)
    t, sign = axis_index(toward or AXES[(n + 1) % 3])
    if t == n:
        raise MassError(
            f"{name}, normal to {axis!r}, cannot point toward {toward!r}: give another toward="
        )
    transfer = m * distance**2
    moments = [polar * (1 + flatness) / 2 - transfer] * 3
    moments[n], moments[t] = polar - transfer, polar * (1 - flatness) / 2
    return Body(name, m, _shifted(name, as_point(middle, name), t, sign * distance), tuple(moments))


def _shifted(name, point, n, distance):
    axes_at(point)
    if distance is ZERO:
        return point
    c = list(point.position(point.frame).c)
    c[n] = c[n] + distance
    return point.frame.point(f"G of {name}", *c)

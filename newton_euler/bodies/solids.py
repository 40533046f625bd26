"""The table of Appendix B and its relatives: homogeneous rods, wires, plates, shells and solids as
bodies.

Each function returns a :class:`newton_euler.bodies.body.Body`. The last point given places it: its
centre, apex, or circle's centre; the frame of that point is the frame of the body, and a Frame may
stand for its origin. ``axis`` says along which axis of that frame its own axis or normal
lies: "x" as in the book's table, "y", "z", or with a minus sign where it has a sense. A slanting
    body gets a frame of its own,
``ground.rotate(...)``. Either ``mass=`` is given, or ``density=``: mass per length of a rod or
wire, per area of a sheet or shell, per volume of a solid.

>>> from newton_euler import Frame
>>> part = Frame("part")
>>> cylinder(0.1, 0.6, part, "x", mass=2.0).inertia.moments  # (m a^2/2, m (3 a^2 + L^2)/12 twice)
(0.010000000000000002, 0.065, 0.065)
"""

from ..algebra.scalars import ZERO, pi, scalar, sin, sqrt
from ..algebra.vectors import add3, cross3, dot3, scale3, sub3, sum3
from ..kinematics.frames import Point, axes_at, place
from .admissibility import AXES, MassError, positive
from .body import Body
from .inertia import SECOND_MOMENTS, Inertia, axis_index, from_second_moments

# -- along lines


def rod(length, centre, axis="x", *, mass=None, density=None, name="rod"):
    """A thin straight rod about its middle: 0, m L^2/12 twice (App. B). For one from a point to a
    point see :func:`simplex`.
    """
    _lengths(name, length=length)
    m = _mass(name, mass, density, length)
    return _of_revolution(name, centre, axis, m, ZERO, m * (length * length) / 12)


def ring(radius, centre, axis="x", *, mass=None, density=None, name="ring"):
    """A thin wire bent to a circle: m r^2 about its axis, m r^2/2 about a diameter."""
    _lengths(name, radius=radius)
    m = _mass(name, mass, density, 2 * pi(radius) * radius)
    return _of_revolution(name, centre, axis, m, m * (radius * radius), m * (radius * radius) / 2)


def arc(radius, half_angle, middle, axis="x", toward=None, *, mass=None, density=None, name="arc"):
    """A thin wire along a circular arc of twice ``half_angle`` (rad, up to pi); ``middle`` is the
    centre of the circle.

    axis : normal to its plane; toward : from ``middle`` to the middle of the arc; default: the axis
        that follows ``axis`` in x, y, z, x
    G lies r sin(a)/a from ``middle``. For small angles the moments about G lose as many digits as
    1/a^2 has.
    """
    _lengths(name, radius=radius, half_angle=half_angle)
    m = _mass(name, mass, density, 2 * half_angle * radius)
    flatness = sin(2 * half_angle) / (2 * half_angle)
    return _fan(
        name,
        middle,
        axis,
        toward,
        m,
        radius * (sin(half_angle) / half_angle),
        m * (radius * radius),
        flatness,
    )


def half_ring(radius, middle, axis="x", toward=None, *, mass=None, density=None, name="half ring"):
    """A thin wire along half a circle about ``middle``, see :func:`arc`; G lies 2 r/pi from
    ``middle``.
    """
    _lengths(name, radius=radius)
    m = _mass(name, mass, density, pi(radius) * radius)
    return _fan(name, middle, axis, toward, m, 2 * radius / pi(radius), m * (radius * radius))


# -- flat


def plate(b, c, centre, axis="x", *, mass=None, density=None, name="plate"):
    """A thin rectangular plate with normal ``axis``, sides b and c along the two axes that follow
    it: normal x, b along y, c along z (App. B).
    """
    _lengths(name, b=b, c=c)
    m = _mass(name, mass, density, b * c)
    bb, cc = m * (b * b) / 12, m * (c * c) / 12
    return _placed(name, centre, axis, m, (bb + cc, cc, bb))


def disk(radius, centre, axis="x", *, mass=None, density=None, name="disk"):
    """A thin round disk: m r^2/2 about its axis, m r^2/4 about a diameter (App. B)."""
    _lengths(name, radius=radius)
    m = _mass(name, mass, density, pi(radius) * (radius * radius))
    return _of_revolution(
        name, centre, axis, m, m * (radius * radius) / 2, m * (radius * radius) / 4
    )


def annulus(inner, outer, centre, axis="x", *, mass=None, density=None, name="annulus"):
    """A flat ring: m (r1^2 + r2^2)/2 about its axis, half of it about a diameter."""
    _lengths(name, inner=inner, outer=outer, wall=outer - inner)
    m = _mass(name, mass, density, pi(outer) * ((outer - inner) * (outer + inner)))
    return _of_revolution(
        name,
        centre,
        axis,
        m,
        m * (inner * inner + outer * outer) / 2,
        m * (inner * inner + outer * outer) / 4,
    )


def sector(
    radius, half_angle, middle, axis="x", toward=None, *, mass=None, density=None, name="sector"
):
    """A thin sector of a disk of twice ``half_angle`` (rad); ``middle`` is its tip. Directions and
    small angles as for :func:`arc`.

    G lies 2 r sin(a)/(3 a) from the tip.
    """
    _lengths(name, radius=radius, half_angle=half_angle)
    m = _mass(name, mass, density, half_angle * (radius * radius))
    flatness = sin(2 * half_angle) / (2 * half_angle)
    distance = 2 * radius * (sin(half_angle) / half_angle) / 3
    return _fan(name, middle, axis, toward, m, distance, m * (radius * radius) / 2, flatness)


def half_disk(radius, middle, axis="x", toward=None, *, mass=None, density=None, name="half disk"):
    """A thin half disk; ``middle`` is the middle of its straight edge. G lies 4 r/(3 pi) from
    there. Directions as for :func:`arc`.
    """
    _lengths(name, radius=radius)
    m = _mass(name, mass, density, pi(radius) * (radius * radius) / 2)
    return _fan(
        name, middle, axis, toward, m, 4 * radius / (3 * pi(radius)), m * (radius * radius) / 2
    )


# -- solid


def box(a, b, c, centre, axis="x", *, mass=None, density=None, name="box"):
    """A rectangular prism: edge a along ``axis``, b and c along the two axes that follow it (App.
    B).
    """
    _lengths(name, a=a, b=b, c=c)
    m = _mass(name, mass, density, a * b * c)
    aa, bb, cc = (m * (e * e) / 12 for e in (a, b, c))
    return _placed(name, centre, axis, m, (bb + cc, cc + aa, aa + bb))


def cylinder(radius, length, centre, axis="x", *, mass=None, density=None, name="cylinder"):
    """A circular cylinder: m a^2/2, m (3 a^2 + L^2)/12 twice (App. B)."""
    _lengths(name, radius=radius, length=length)
    m = _mass(name, mass, density, pi(radius) * (radius * radius) * length)
    return _of_revolution(
        name,
        centre,
        axis,
        m,
        m * (radius * radius) / 2,
        m * (3 * (radius * radius) + length * length) / 12,
    )


def tube(inner, outer, length, centre, axis="x", *, mass=None, density=None, name="tube"):
    """A hollow cylinder, open at its ends: m (r1^2 + r2^2)/2, m (3 r1^2 + 3 r2^2 + L^2)/12 twice."""
    _lengths(name, inner=inner, outer=outer, wall=outer - inner, length=length)
    m = _mass(name, mass, density, pi(outer) * ((outer - inner) * (outer + inner)) * length)
    squares = inner * inner + outer * outer
    return _of_revolution(
        name, centre, axis, m, m * squares / 2, m * (3 * squares + length * length) / 12
    )


def wedge(
    radius,
    half_angle,
    length,
    middle,
    axis="x",
    toward=None,
    *,
    mass=None,
    density=None,
    name="wedge",
):
    """A sector of a solid cylinder, of the given length along ``axis``; ``middle`` is the middle of
    its edge. Directions as for :func:`arc`.
    """
    flat = sector(
        radius,
        half_angle,
        middle,
        axis,
        toward,
        mass=mass,
        density=None if density is None else density * length,
        name=name,
    )
    _lengths(name, length=length)
    thick = flat.mass * (length * length) / 12
    added = tuple(ZERO if n == axis_index(axis)[0] else thick for n in range(3))
    return Body(
        name,
        flat.mass,
        flat.centre,
        tuple(m + x for m, x in zip(flat.inertia.moments, added, strict=True)),
    )


def cone(radius, height, apex, axis="x", *, mass=None, density=None, name="cone"):
    """A circular cone, ``axis`` pointing from its apex to its base. G lies 3 h/4 from the apex
    (App. B).

    About G: 3 m a^2/10, 3 m (4 a^2 + h^2)/80 twice; for the book's moments at the apex ask
    ``cone(...).about(apex)``.
    """
    _lengths(name, radius=radius, height=height)
    m = _mass(name, mass, density, pi(radius) * (radius * radius) * height / 3)
    return _of_revolution(
        name,
        apex,
        axis,
        m,
        3 * m * (radius * radius) / 10,
        3 * m * (4 * (radius * radius) + height * height) / 80,
        3 * height / 4,
    )


def sphere(radius, centre, *, mass=None, density=None, name="sphere"):
    """A solid sphere: 2 m a^2/5 (App. B)."""
    _lengths(name, radius=radius)
    m = _mass(name, mass, density, 4 * pi(radius) * radius**3 / 3)
    return _placed(name, centre, "x", m, (2 * m * (radius * radius) / 5,) * 3)


def hollow_sphere(inner, outer, centre, *, mass=None, density=None, name="hollow sphere"):
    """A sphere with a concentric spherical cavity: 2 m (r2^5 - r1^5)/(5 (r2^3 - r1^3)), formed
    without subtracting.
    """
    _lengths(name, inner=inner, outer=outer, wall=outer - inner)
    p, q = inner * inner, outer * outer
    # each divided by r2 - r1
    cubes, fifths = p + inner * outer + q, p * p + q * q + inner * outer * (p + inner * outer + q)
    m = _mass(name, mass, density, 4 * pi(outer) * (outer - inner) * cubes / 3)
    return _placed(name, centre, "x", m, (2 * m * fifths / (5 * cubes),) * 3)


def hemisphere(radius, middle, axis="x", *, mass=None, density=None, name="hemisphere"):
    """A solid half sphere; ``middle`` is the centre of its flat face and ``axis`` points into it. G
    lies 3 r/8 from there.
    """
    _lengths(name, radius=radius)
    m = _mass(name, mass, density, 2 * pi(radius) * radius**3 / 3)
    return _of_revolution(
        name,
        middle,
        axis,
        m,
        2 * m * (radius * radius) / 5,
        83 * m * (radius * radius) / 320,
        3 * radius / 8,
    )


def ellipsoid(a, b, c, centre, axis="x", *, mass=None, density=None, name="ellipsoid"):
    """A solid ellipsoid: half axis a along ``axis``, b and c along the two that follow; m (b^2 +
    c^2)/5 and so on.
    """
    _lengths(name, a=a, b=b, c=c)
    m = _mass(name, mass, density, 4 * pi(a) * (a * b * c) / 3)
    aa, bb, cc = (m * (e * e) / 5 for e in (a, b, c))
    return _placed(name, centre, axis, m, (bb + cc, cc + aa, aa + bb))


# -- shells


def cylindrical_shell(
    radius, length, centre, axis="x", *, mass=None, density=None, name="cylindrical shell"
):
    """A thin tube, open at its ends: m r^2, m (6 r^2 + L^2)/12 twice."""
    _lengths(name, radius=radius, length=length)
    m = _mass(name, mass, density, 2 * pi(radius) * radius * length)
    return _of_revolution(
        name,
        centre,
        axis,
        m,
        m * (radius * radius),
        m * (6 * (radius * radius) + length * length) / 12,
    )


def conical_shell(radius, height, apex, axis="x", *, mass=None, density=None, name="conical shell"):
    """A thin cone without its base, ``axis`` pointing from its apex to the open end. G lies 2 h/3
    from the apex.
    """
    _lengths(name, radius=radius, height=height)
    m = _mass(name, mass, density, pi(radius) * radius * sqrt(radius * radius + height * height))
    return _of_revolution(
        name,
        apex,
        axis,
        m,
        m * (radius * radius) / 2,
        m * (9 * (radius * radius) + 2 * (height * height)) / 36,
        2 * height / 3,
    )


def spherical_shell(radius, centre, *, mass=None, density=None, name="spherical shell"):
    """A thin hollow sphere: 2 m r^2/3."""
    _lengths(name, radius=radius)
    m = _mass(name, mass, density, 4 * pi(radius) * (radius * radius))
    return _placed(name, centre, "x", m, (2 * m * (radius * radius) / 3,) * 3)


def hemispherical_shell(
    radius, middle, axis="x", *, mass=None, density=None, name="hemispherical shell"
):
    """A thin half sphere without its flat face; ``middle`` is the centre of its rim and ``axis``
    points to its top. G lies r/2 from there.
    """
    _lengths(name, radius=radius)
    m = _mass(name, mass, density, 2 * pi(radius) * (radius * radius))
    return _of_revolution(
        name,
        middle,
        axis,
        m,
        2 * m * (radius * radius) / 3,
        5 * m * (radius * radius) / 12,
        radius / 2,
    )


# -- between points


def simplex(*corners, mass=None, density=None, name=None):
    """The body between two, three or four Points: a thin rod from end to end, a thin triangular
    plate, a solid tetrahedron.

    The frame is that of the first point; the products of inertia come with it. About G the integral
    of x_i x_j is m/((n+1)(n+2)) times the sum over the corners of x_i x_j, with n = 1, 2, 3 for
    rod, plate and tetrahedron.

    >>> from newton_euler import Frame
    >>> ground = Frame("ground")
    >>> simplex(ground.origin, ground.point("B", 2.0, 0, 0), mass=3.0).about(ground.origin).moments
    (0, 4.0, 4.0)
    """
    n = len(corners) - 1
    if n not in (1, 2, 3) or not all(isinstance(P, Point) for P in corners):
        raise MassError(
            f"a simplex has two, three or four corners, all Points; got {len(corners)}: {corners!r}"
        )
    name = name or ("rod", "triangle", "tetrahedron")[n - 1]
    frame = corners[0].frame
    first, *others = (P.position(frame).c for P in corners)
    edges = [sub3(c, first) for c in others]
    m = _mass(name, mass, density, _content(edges))
    middle = _mean(edges, n + 1)
    arms = [scale3(-1, middle), *(sub3(e, middle) for e in edges)]
    second = [
        sum((arm[a] * arm[b] for arm in arms), ZERO) * m / ((n + 1) * (n + 2))
        for a, b in SECOND_MOMENTS
    ]
    centre = frame.point(f"G of {name}", *add3(first, middle))
    return Body(
        name, m, centre, Inertia(centre, *from_second_moments(second), m, centre, frame, None)
    )


def _mean(vectors, count):
    """The sum of the triples divided by a whole number: not times 1/count, which would round before
    an mpf or a fraction comes in.
    """
    return tuple(x / count for x in sum3(vectors))


def _content(edges):
    """Length, area or volume of the simplex with these edges from one corner."""
    if len(edges) == 3:
        return abs(dot3(edges[0], cross3(edges[1], edges[2]))) / 6
    spanned = edges[0] if len(edges) == 1 else cross3(*edges)
    return sqrt(dot3(spanned, spanned)) / len(edges)


# -- how a body of the table is made


def _mass(name, mass, density, content):
    if (mass is None) == (density is None):
        raise MassError(
            f"{name} needs either mass=... or density=... (per length, area or volume), "
            f"{'and got none' if mass is None else 'not both'}"
        )
    m = scalar(density) * content if mass is None else scalar(mass)
    positive(m, f"the mass of {name}")
    return m


def _lengths(name, **values):
    for what, x in values.items():
        positive(scalar(x), f"the {what.replace('_', ' ')} of {name}")


def _of_revolution(name, point, axis, m, axial, across, along=ZERO):
    """The body with these moments about G, along ``axis`` and at right angles to it; G lies
    ``along`` from ``point``.
    """
    return _placed(name, point, axis, m, (axial, across, across), along)


def _placed(name, point, axis, m, moments, along=ZERO):
    """The body with (first, second, third) moments about G along ``axis`` and the two that follow
    it; G lies ``along`` from ``point``.
    """
    point = place(point, name)
    n, sign = axis_index(axis)
    turned = tuple(moments[(k - n) % 3] for k in range(3))
    return Body(name, m, _shifted(name, point, n, sign * along), turned)


def _fan(name, middle, axis, toward, m, distance, polar, flatness=ZERO):
    """A flat body symmetric about ``toward``: polar moment about ``middle``, and how far the mass
    keeps to the axis of symmetry.
    """
    middle = place(middle, name)
    n, _ = axis_index(axis)
    t, sign = axis_index(toward or AXES[(n + 1) % 3])
    if t == n:
        raise MassError(
            f"{name} lies in the plane normal to {axis!r} and cannot be directed toward "
            f"{toward!r}; give another axis as toward="
        )
    transfer = m * (distance * distance)
    moments = [None] * 3
    moments[n], moments[t], moments[3 - n - t] = (
        polar - transfer,
        polar * (1 - flatness) / 2,
        polar * (1 + flatness) / 2 - transfer,
    )
    return Body(name, m, _shifted(name, middle, t, sign * distance), tuple(moments))


def _shifted(name, point, n, distance):
    axes_at(point)
    if distance is ZERO:
        return point
    c = list(point.position(point.frame).c)
    c[n] = c[n] + distance
    return point.frame.point(f"G of {name}", *c)

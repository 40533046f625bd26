"""Finite rotations (chapters 4 and 10): direction cosines, Euler's theorem, quaternions, Euler
angles 3-1-3; in radians.

A *rotation matrix* R, three rows of three, takes components in the turned axes to components in the
fixed ones: its columns are the turned axes, and ``frame.rotation(ground)`` is one. The book's A
(4.1), which only :func:`direction_cosines` returns, is its transpose.

A *quaternion* is (q0, q1, q2, q3), scalar part first: cos(angle/2), then sin(angle/2) times the
axis. It too takes body components to ground components; q and -q are the same rotation. *Euler
angles* are (psi, theta, phi): precession about Z, nutation about the line of nodes, spin about the
body's z axis (10.2).

Those that read a rotation (``axis_angle``, ``quaternion_from_matrix``, ``euler_angles``) compare
values: they take numbers of all kinds and arrays of shape (N,) as entries, and raise
:class:`ScalarError` for expressions.
"""

import math
from collections.abc import Sequence

from ..algebra.errors import NewtonEulerError, Tolerance, checked, checked_but
from ..algebra.scalars import (
    ZERO,
    Rows,
    Scalar,
    ScalarError,
    Triple,
    atan2,
    cos,
    epsilon,
    hypot,
    is_finite,
    is_numeric,
    max_abs,
    min_abs,
    real_scalar,
    sin,
    sqrt,
    to_plain,
    vanishes,
    where,
    without_rates,
)
from ..algebra.vectors import Vector, cross3, dot3, scale3, three
from .frames import Frame, Point, divided_by_length

Matrix = Sequence[Sequence[Scalar]]  # three rows of three
Components = Sequence[Scalar] | Vector  # along any axes


class RotationError(NewtonEulerError, ValueError):
    """A matrix that is not a rotation, a zero quaternion or axis, or singular Euler rates."""


# -- matrices of three rows


def _rows(R):
    return tuple(tuple(to_plain(x) for x in row) for row in R)


@checked
def transpose(R: Matrix) -> Rows:
    """The matrix with rows and columns exchanged; of a rotation the inverse (4.2).

    >>> transpose(((1, 2, 3), (4, 5, 6), (7, 8, 9)))
    ((1, 4, 7), (2, 5, 8), (3, 6, 9))
    """
    return tuple(zip(*R, strict=True))


@checked
def product(*matrices: Matrix) -> Rows:
    """The matrix product of any number of 3 x 3 matrices, left to right as written.

    >>> product(((0, -1, 0), (1, 0, 0), (0, 0, 1)), ((2, 0, 0), (0, 3, 0), (0, 0, 4)))
    ((0, -3, 0), (2, 0, 0), (0, 0, 4))
    """
    first, *others = matrices
    for other in others:
        columns = transpose(other)
        first = tuple(tuple(dot3(row, column) for column in columns) for row in first)
    return _rows(first)


@checked
def apply(R: Matrix, v: Components) -> Triple:
    """The components R v, v a triple or a Vector: of the turned one, or the same in the fixed axes.

    >>> apply(((0, -1, 0), (1, 0, 0), (0, 0, 1)), (1.0, 2.0, 3.0))
    (-2.0, 1.0, 3.0)
    """
    v = three(v, "a vector", RotationError)
    return tuple(to_plain(dot3(row, v)) for row in R)


@checked
def determinant(R: Matrix) -> Scalar:
    """The determinant: 1 for a rotation (4.4), -1 for a reflection.

    >>> determinant(((0, -1, 0), (1, 0, 0), (0, 0, 1)))
    1
    """
    return to_plain(dot3(R[0], cross3(R[1], R[2])))


@checked
def in_sequence(*rotations: Matrix) -> Rows:
    """The one rotation that equals these, carried out in the order given, the axis of each in the
    fixed frame (4.2, 4.3): their product in the reverse order. With each axis in the frame turned
    by the earlier ones it is :func:`product` itself.

    >>> X, Y = (rotation_matrix(axis, math.pi/2) for axis in ((1, 0, 0), (0, 1, 0)))
    >>> [[round(x) for x in row] for row in in_sequence(X, Y)]  # columns: i = -K, j = I, k = -J
    [[0, 1, 0], [0, 0, -1], [-1, 0, 0]]
    """
    return product(*reversed(rotations))


@checked
def direction_cosines(frame: Frame, ground: Frame) -> Rows:
    """The book's A (4.1), which takes components in ``ground`` to components in ``frame`` (4.7):
    the cosines of the angles between the axes of ``frame`` (rows) and of ``ground`` (columns).

    >>> ground = Frame("ground")
    >>> direction_cosines(ground.rotate("turned", "z", 0.0), ground)[0]  # i.I, i.J, i.K
    (1.0, 0.0, 0)
    """
    return transpose(frame.rotation(ground))


# -- axis and angle


@checked_but("axis")
def rotation_matrix(axis: Components, angle: Scalar) -> Rows:
    """The matrix, three rows, of the turn by ``angle`` (rad) about ``axis``, right-handed (4.2).

    axis : three components of any length but zero (:class:`RotationError`), or a Vector; the same
        in the turned and in the fixed axes

    >>> [[round(x, 3) for x in row] for row in rotation_matrix((0, 0, 2), 1.0)]
    [[0.54, -0.841, 0], [0.841, 0.54, 0], [0, 0, 1]]
    """
    e = _unit(axis, angle)
    c, s = cos(angle), sin(angle)
    x, y, z = e
    xy, yz, zx = ((1 - c) * (a * b) for a, b in ((x, y), (y, z), (z, x)))
    sx, sy, sz = scale3(s, e)
    return _rows((
        (1 - (1 - c) * (y * y + z * z), xy - sz, zx + sy),
        (xy + sz, 1 - (1 - c) * (z * z + x * x), yz - sx),
        (zx - sy, yz + sx, 1 - (1 - c) * (x * x + y * y)),
    ))  # fmt: skip


@checked_but("R")
def axis_angle(R: Matrix, tolerance: Tolerance = 1e-9) -> tuple[tuple, Scalar]:
    """The axis, a unit triple, and the angle in [0, pi] of any rotation (Euler's theorem, 4.2),
    right-handed. At pi (within 8 round-offs) the first component that is not zero is positive; at
    angle 0 no axis is determined and (0, 0, 1) is returned.

    tolerance : how far R^T R may be from 1; :class:`RotationError` beyond, and for reflections
    Accuracy: the round-off of the entries, also near 0 and pi, where the arc cosine of (R11 + R22 +
    R33 - 1)/2 loses half of the digits.

    >>> axis, angle = axis_angle(((0, 0, 1), (1, 0, 0), (0, 1, 0)))
    >>> [round(x, 6) for x in axis], round(angle, 6)
    ([0.57735, 0.57735, 0.57735], 2.094395)
    """
    q0, *v = quaternion_from_matrix(R, tolerance)
    length, axis = _length_and_direction(v)
    return axis, 2 * atan2(length, abs(q0))


def _unit(axis, angle):
    axis = three(axis, "an axis", RotationError)
    angle = without_rates(angle)
    if not is_finite(angle):
        raise RotationError(f"an angle is finite; got {angle!r}")
    # a length of the kind of the angle: exact if that is
    return divided_by_length(axis, hypot(*(x + 0 * angle for x in axis)), RotationError)


def _length_and_direction(v):
    """Length and unit triple of three numbers; the direction is (0, 0, 1) where all are zero."""
    # divided by the largest first: the squares of tiny numbers would underflow
    largest = abs(v[0])
    for x in v[1:]:
        largest = where(abs(x) > largest, abs(x), largest)
    none = largest == 0
    v = [where(none, int(n == 2), x / where(none, 1, largest)) for n, x in enumerate(v)]
    length = sqrt(dot3(v, v))
    return largest * length, tuple(x / length for x in v)


# -- checks


def checked_rotation(R: Matrix, tolerance: Tolerance = 1e-9) -> Rows:
    """``R`` as three rows, if it is a rotation: R^T R = 1 within ``tolerance`` and determinant +1
    (4.2)-(4.4); :class:`RotationError` otherwise, :class:`ScalarError` for entries without values.
    """
    try:
        lengths = [len(row) for row in R]
        got = f"rows of lengths {lengths}"
    except TypeError:
        lengths, got = [], repr(R)
    if lengths != [3, 3, 3]:
        raise RotationError(
            "a rotation matrix is three rows of three entries; for many instants the entries are "
            "arrays, so that NumPy shows the shape (3, 3, N); got "
            + (f"shape {R.shape}" if hasattr(R, "shape") else got)
        )
    rows = tuple(tuple(without_rates(x) for x in row) for row in R)
    gram = product(transpose(rows), rows)
    try:
        errors = [max_abs(gram[n][m] - int(n == m)) for n in range(3) for m in range(3)]
        mirrored = max_abs(determinant(rows) - 1)
    except (TypeError, ValueError, RuntimeError) as problem:
        raise ScalarError(
            "to read axis, quaternion or angles from a matrix its entries must have values "
            f"(floats, mpf, arrays); this one has expressions, as {rows[0][0]!r}. Put in numbers "
            "first, or keep the angles that it was built from"
        ) from problem
    if not all(error <= tolerance for error in errors):
        worst = max(errors, key=lambda error: error if error == error else math.inf)  # nan, too
        raise RotationError(
            f"not a rotation: R^T R differs from the unit matrix by {worst:.3g}, and "
            f"{tolerance:.3g} is allowed; its columns must be unit vectors at right angles. If the "
            "entries are rounded, say how far with tolerance="
        )
    if not mirrored < 1:
        raise RotationError("not a rotation but a reflection, determinant -1: exchange two axes")
    return rows


# -- quaternions


@checked_but("axis")
def quaternion(axis: Components, angle: Scalar) -> tuple[Scalar, ...]:
    """The unit quaternion (cos(angle/2), sin(angle/2) e) of a turn, as for :func:`rotation_matrix`.

    >>> quaternion((0, 0, 1), 0.0)
    (1.0, 0, 0, 0.0)
    """
    half = angle / 2
    return (cos(half), *(to_plain(sin(half) * x) for x in _unit(axis, angle)))


@checked
def quaternion_product(p: Sequence[Scalar], q: Sequence[Scalar]) -> tuple[Scalar, ...]:
    """The quaternion p q: the turn q, then p about fixed axes, as the product of their matrices.

    >>> quaternion_product((0.6, 0.8, 0, 0), (0.6, -0.8, 0, 0))
    (1.0, 0.0, 0, 0)
    """
    p0, p1, p2, p3 = _four(p)
    q0, q1, q2, q3 = _four(q)
    return (
        p0 * q0 - p1 * q1 - p2 * q2 - p3 * q3,
        p0 * q1 + p1 * q0 + p2 * q3 - p3 * q2,
        p0 * q2 - p1 * q3 + p2 * q0 + p3 * q1,
        p0 * q3 + p1 * q2 - p2 * q1 + p3 * q0,
    )


@checked
def normalised(q: Sequence[Scalar]) -> tuple[Scalar, ...]:
    """The quaternion divided by its length, which drifts; :class:`RotationError` for length zero.

    >>> normalised((3.0, 0.0, 4.0, 0.0))
    (0.6, 0.0, 0.8, 0.0)
    """
    q = _four(q)
    length = _checked_size(q, hypot(*q))
    return tuple(to_plain(x / length) for x in q)


@checked
def matrix_from_quaternion(q: Sequence[Scalar]) -> Rows:
    """The rotation matrix of a quaternion of any length but zero.

    >>> matrix_from_quaternion((1.0, 0, 0, 1.0))
    ((0.0, -1.0, 0), (1.0, 0.0, 0), (0, 0, 1))
    """
    w, x, y, z = q = _four(q)
    length = hypot(*q)
    if is_numeric(length) and not 1e-140 < min_abs(length) <= max_abs(length) < 1e140:
        w, x, y, z = q = normalised(q)  # whose squares neither over- nor underflow
    s = 2 / (dot3(q, q) + z * z)  # not 2: the matrix is a rotation even if the length has drifted
    return _rows((
        (1 - s * (y * y + z * z), s * (x * y - w * z), s * (x * z + w * y)),
        (s * (x * y + w * z), 1 - s * (z * z + x * x), s * (y * z - w * x)),
        (s * (x * z - w * y), s * (y * z + w * x), 1 - s * (x * x + y * y)),
    ))  # fmt: skip


@checked_but("R")
def quaternion_from_matrix(R: Matrix, tolerance: Tolerance = 1e-9) -> tuple[Scalar, ...]:
    """The unit quaternion of a rotation matrix, its scalar part not negative; at an angle of pi,
    the sign of :func:`axis_angle`.

    By that of four formulas which has the largest divisor (S. W. Shepperd, J. Guidance and Control
    1, 223, 1978). Errors as for :func:`checked_rotation`.

    >>> quaternion_from_matrix(((1, 0, 0), (0, -1, 0), (0, 0, -1)))
    (0, 1.0, 0, 0)
    """
    (a, b, c), (d, e, f), (g, h, i) = checked_rotation(R, tolerance)
    rows = (  # row n is 4 q_n times the quaternion
        (1 + a + e + i, h - f, c - g, d - b),
        (h - f, 1 + a - e - i, b + d, c + g),
        (c - g, b + d, 1 - a + e - i, f + h),
        (d - b, c + g, f + h, 1 - a - e + i),
    )
    q, largest = rows[0], rows[0][0]
    for n in (1, 2, 3):
        better = rows[n][n] > largest
        q = tuple(where(better, new, old) for new, old in zip(rows[n], q, strict=True))
        largest = where(better, rows[n][n], largest)
    q = normalised(q)
    # the sign is that of the first component beyond round-off: at pi, q0 = cos(pi/2) is noise
    round_off, sense = epsilon(q[0]), q[3]
    for x, noise in ((q[2], 64), (q[1], 64), (q[0], 4)):
        sense = where(abs(x) > noise * round_off, x, sense)
    return tuple(where(sense < 0, 0 - x, x) for x in q)


@checked
def quaternion_rate(q: Sequence[Scalar], omega: Components) -> tuple[Scalar, ...]:
    """The rate q' = q (0, omega)/2 for the angular velocity ``omega`` in rad/s.

    omega : *body* components, a triple or a Vector of the body's frame

    >>> quaternion_rate((0.8, 0, 0, 0.6), (0, 0, 1.0))
    (-0.3, 0, 0, 0.4)
    """
    rate = quaternion_product(q, (ZERO, *three(omega, "an angular velocity", RotationError)))
    return tuple(to_plain(x / 2) for x in rate)


def _four(q):
    q = tuple(real_scalar(x) for x in q)
    if len(q) != 4:
        raise RotationError(f"a quaternion has four components, the scalar part first; got {q!r}")
    return q


def _checked_size(q, size):
    if vanishes(size) or not is_finite(size):
        raise RotationError(f"{q} is not a rotation: its length must be finite and not zero")
    return size


# -- Euler angles 3-1-3


@checked
def euler_matrix(psi: Scalar, theta: Scalar, phi: Scalar) -> Rows:
    """The rotation matrix, body to ground, of Euler angles: T_phi T_theta T_psi transposed (10.10).

    >>> euler_matrix(0.0, 0.0, 0.0)[2]
    (0.0, 0.0, 1.0)
    """
    c, s = cos(theta), sin(theta)
    nutation = (1, ZERO, ZERO), (ZERO, c, -s), (ZERO, s, c)
    return product(_about_z(psi), nutation, _about_z(phi))


def _about_z(angle):
    c, s = cos(angle), sin(angle)
    return (c, -s, ZERO), (s, c, ZERO), (ZERO, ZERO, 1)


@checked_but("R")
def euler_angles(R: Matrix, tolerance: Tolerance = 1e-09) -> Triple:
    """The angles (psi, theta, phi) in rad of a rotation matrix, body to ground: psi and phi in
    (-pi, pi], theta in [0, pi] (10.5)-(10.10).

    Singular at theta = 0, where only psi + phi is determined, and at theta = pi, where only psi -
    phi is: there, within round-off, phi is set to 0. Near these angles an error of R enters psi and
    phi divided by sin(theta), but not their sum (their difference). Errors as for
    :func:`checked_rotation`.

    >>> [round(x, 12) for x in euler_angles(euler_matrix(0.3, 0.2, 0.1))]
    [0.3, 0.2, 0.1]
    >>> [round(x, 12) for x in euler_angles(euler_matrix(0.3, 0.0, 0.1))]
    [0.4, 0.0, 0.0]
    """
    return euler_from_quaternion(quaternion_from_matrix(R, tolerance))


@checked
def quaternion_from_euler(psi: Scalar, theta: Scalar, phi: Scalar) -> tuple[Scalar, ...]:
    """The unit quaternion of the Euler angles (rad), body to ground.

    >>> quaternion_from_euler(0.0, 0.0, 0.0)
    (1.0, 0.0, 0.0, 0.0)
    """
    c, s, a, b = cos(theta / 2), sin(theta / 2), (psi + phi) / 2, (psi - phi) / 2
    return c * cos(a), s * cos(b), s * sin(b), c * sin(a)


@checked
def euler_from_quaternion(q: Sequence[Scalar]) -> Triple:
    """The Euler angles of a quaternion of any length, as by :func:`euler_angles`.

    >>> [round(x, 12) for x in euler_from_quaternion(quaternion_from_euler(0.3, 0.2, 0.1))]
    [0.3, 0.2, 0.1]
    """
    w, x, y, z = (without_rates(c) for c in normalised(q))
    # cos and sin of theta/2; (w, z) has the angle (psi + phi)/2, (x, y) (psi - phi)/2
    upright, tilted = sqrt(w * w + z * z), sqrt(x * x + y * y)
    theta = 2 * atan2(tilted, upright)
    small = 4 * epsilon(upright)  # below it the angle of a pair is noise: the other's is taken
    x, y = (where(tilted <= small, a, b) for a, b in ((w, x), (z, y)))
    w, z = (where(upright <= small, a, b) for a, b in ((x, w), (y, z)))
    # + 0 turns -0.0 into 0.0, whose angle is pi and not -pi
    psi = atan2(z * x + w * y + 0, w * x - z * y)
    phi = atan2(z * x - w * y + 0, w * x + z * y)
    return psi, theta, phi


@checked
def euler_body_rates(psi: Scalar, theta: Scalar, phi: Scalar, rates: Sequence[Scalar]) -> Triple:
    """The angular velocity in body components (10.12) from ``rates`` = (psi', theta', phi').

    >>> euler_body_rates(0.0, 0.0, 0.0, (2.0, 0.5, 3.0))
    (0.5, 0.0, 5.0)
    """
    dpsi, dtheta, dphi = three(rates, "(psi', theta', phi')", RotationError)
    across = dpsi * sin(theta)
    return (
        to_plain(dtheta * cos(phi) + across * sin(phi)),
        to_plain(across * cos(phi) - dtheta * sin(phi)),
        to_plain(dphi + dpsi * cos(theta)),
    )


@checked
def euler_rates(psi: Scalar, theta: Scalar, phi: Scalar, omega: Components) -> Triple:
    """The rates (psi', theta', phi') in rad/s from the angles and the angular velocity ``omega`` in
    body components: (10.12) solved; :class:`RotationError` where sin(theta) is zero.

    >>> omega = euler_body_rates(0.3, 0.2, 0.1, (2.0, 0.5, 3.0))
    >>> [round(x, 12) for x in euler_rates(0.3, 0.2, 0.1, omega)]
    [2.0, 0.5, 3.0]
    """
    x, y, z = three(omega, "an angular velocity", RotationError)
    s = sin(theta)
    if vanishes(s, 4 * epsilon(without_rates(s))):
        raise RotationError(
            f"theta = {theta!r} rad: at theta = 0 and pi the axes of precession and "
            "spin coincide and the rates of Euler's angles are not determined; use "
            "quaternion_rate, which is never singular, and compute the angles afterwards"
        )
    dpsi = (x * sin(phi) + y * cos(phi)) / s
    return to_plain(dpsi), to_plain(x * cos(phi) - y * sin(phi)), to_plain(z - dpsi * cos(theta))


@checked
def euler_frame(
    parent: Frame, name: str, psi: Scalar, theta: Scalar, phi: Scalar, origin: Point | None = None
) -> Frame:
    """The frame ``name``, placed in ``parent`` by three successive turns (10.2): psi about z, theta
    about the new x, phi about the new z; numbers or :func:`moving`. ``origin`` is a Point of
    ``parent``. The ``.parent`` of the result is the book's {i, j, k}, which does not spin.

    >>> from newton_euler import moving
    >>> ground = Frame("ground")
    >>> body = euler_frame(ground, "top", moving(0.0, rate=2.0), 0.0, moving(0.0, rate=3.0))
    >>> body, body.angular_velocity(ground).components()
    (Frame(top < top nutated < top precessed < ground), (0.0, 0.0, 5.0))
    """
    precessed = parent.rotate(f"{name} precessed", "z", psi, origin=origin)
    return precessed.rotate(f"{name} nutated", "x", theta).rotate(name, "z", phi)

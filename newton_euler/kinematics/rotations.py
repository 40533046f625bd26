"""Finite rotations (chapters 4 and 10): direction cosines, Euler's theorem, quaternions, Euler
angles 3-1-3.

A *rotation matrix* R is three rows of three scalars. It takes components in the turned axes to
components in the fixed ones, and with them it turns vectors: its columns are the turned axes, and
``frame.rotation(ground)`` is one. The book's matrix A of direction cosines (4.1) is its transpose.
All functions here speak of R, except :func:`direction_cosines`, which returns A.

A *quaternion* is (q0, q1, q2, q3), scalar part first: cos(angle/2), then sin(angle/2) times the
axis. It too takes body components to ground components; q and -q are the same rotation. *Euler
angles* are (psi, theta, phi), in the order of turning: precession about Z, nutation about the line
of nodes, spin about the body's z axis (10.2). Angles are in radians.

What builds a rotation works over scalars of every kind. What reads one (``axis_angle``,
``quaternion_from_matrix``, ``euler_angles``) has to compare
values: it takes floats, mpf, arrays (each entry of shape (N,), one for each instant) and SymPy
    numbers, and refuses expressions in
words; of moving numbers it reads the values.
"""

from ..algebra.errors import NewtonEulerError
from ..algebra.scalars import (
    ZERO,
    ScalarError,
    atan2,
    cos,
    epsilon,
    is_finite,
    is_numeric,
    least,
    plain,
    scalar,
    sin,
    size,
    sqrt,
    where,
    without_rates,
)
from ..algebra.vectors import cross3, dot3, scale3


class RotationError(NewtonEulerError, ValueError):
    """A matrix that is no rotation, a quaternion or axis of length zero, or Euler rates where they
    do not exist.
    """


# -- matrices of three rows


def _rows(R):
    return tuple(tuple(plain(x) for x in row) for row in R)


def transpose(R):
    """The matrix with rows and columns exchanged; of a rotation the inverse (4.2)."""
    return tuple(tuple(R[m][n] for m in range(3)) for n in range(3))


def product(*matrices):
    """The matrix product, of any number of 3 x 3 matrices, left to right as written."""
    first, *others = matrices
    for other in others:
        columns = transpose(other)
        first = tuple(tuple(dot3(row, column) for column in columns) for row in first)
    return _rows(first)


def apply(R, v):
    """The components R v: of the turned vector, or of the same one in the fixed axes. ``v`` is a
    triple or a Vector.

    >>> apply(((0, -1, 0), (1, 0, 0), (0, 0, 1)), (1.0, 2.0, 3.0))
    (-2.0, 1.0, 3.0)
    """
    v = _three(v, "a vector")
    return tuple(plain(dot3(row, v)) for row in R)


def determinant(R):
    """The determinant: 1 for a rotation (4.4), -1 for a reflection."""
    return plain(dot3(R[0], cross3(R[1], R[2])))


def in_sequence(*rotations, axes="fixed"):
    """The one rotation that equals these, carried out in the order given (4.2, 4.3).

    axes : "fixed" if the axis of each is given in the fixed frame, "moving" if in the frame that
        the earlier ones have turned. The order matters, and reversing it exchanges the two
        meanings.

    >>> import math
    >>> quarter_x, quarter_y = rotation_matrix((1, 0, 0), math.pi/2), rotation_matrix((0, 1, 0), math.pi/2)
    >>> [[round(x) for x in row] for row in in_sequence(quarter_x, quarter_y)]  # columns: i = -K, j = I, k = -J
    [[0, 1, 0], [0, 0, -1], [-1, 0, 0]]
    """
    if axes not in ("fixed", "moving"):
        raise ValueError(
            "axes are 'fixed' (given in the ground) or 'moving' (turned by the earlier "
            f"rotations), got {axes!r}"
        )
    return product(*(reversed(rotations) if axes == "fixed" else rotations))


def direction_cosines(frame, ground):
    """The book's A (4.1): its rows are the axes of ``frame``, its columns those of ``ground``, its
    entries cosines of the angles between them.

    A takes components in ``ground`` to components in ``frame`` (4.7); it is the transpose of
    ``frame.rotation(ground)``, which turns the vectors.

    >>> from newton_euler import Frame
    >>> ground = Frame("ground")
    >>> direction_cosines(ground.rotate("turned", "z", 0.0), ground)[0]  # i.I, i.J, i.K
    (1.0, 0.0, 0)
    """
    return transpose(frame.rotation(ground))


# -- axis and angle


def rotation_matrix(axis, angle):
    """The matrix of the turn by ``angle`` (rad) about ``axis``, right-handed (4.2; the formula is
    Rodrigues').

    axis : three components of any length, or a Vector; the same in the turned and in the fixed axes
    Returns three rows. Works over scalars of every kind; a moving angle gives moving entries.
    Raises :class:`RotationError` for an axis of length zero.

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


def axis_angle(R, tolerance=1e-9):
    """Euler's theorem (4.2): the axis, three components of a unit vector, and the angle in [0, pi]
    of any rotation.

    Right-handed; the axis has the same components in the turned and the fixed axes. At pi (within 8
    round-offs), where both senses are the same rotation, its first component that is not zero is
    positive. At angle 0 there is no axis: (0, 0, 1) stands for it.
    tolerance : how far R^T R may be from 1; :class:`RotationError` beyond, and for reflections
    Accuracy: by way of the largest component of the quaternion and atan2, so at both ends the
        round-off of the entries and no more, where the arc
    cosine of (R11 + R22 + R33 - 1)/2 loses half of the digits.

    >>> axis, angle = axis_angle(((0, 0, 1), (1, 0, 0), (0, 1, 0)))
    >>> [round(x, 6) for x in axis], round(angle, 6)
    ([0.57735, 0.57735, 0.57735], 2.094395)
    """
    q0, *v = quaternion_from_matrix(R, tolerance)
    length, axis = _length_and_direction(v)
    return axis, 2 * atan2(length, abs(q0))


def _unit(axis, angle):
    axis = _three(axis, "an axis")
    # a length of the kind of the angle: exact if that is
    length = sqrt(dot3(axis, axis) + 0 * without_rates(angle))
    if _vanishes(length) or not is_finite(length):
        raise RotationError(
            f"the axis {tuple(map(plain, axis))} has no direction: its length is "
            f"{plain(length)}; give a vector that is not zero"
        )
    return tuple(x / length for x in axis)


def _three(v, what):
    try:
        given = tuple(scalar(x) for x in v)
    except TypeError:
        given = ()
    if len(given) != 3:
        raise RotationError(f"{what} has three components, as in (0, 0.6, 0.8); got {v!r}")
    return given


def _vanishes(x, small=0):
    """True if a number, at any instant, is not larger than ``small`` in size; an expression is
    taken not to vanish.
    """
    return is_numeric(x) and least(without_rates(x)) <= small


def _length_and_direction(v):
    """Of three numbers, tiny ones too, whose squares would vanish; the direction (0, 0, 1) where
    they are all zero.
    """
    largest = abs(v[0])
    for x in v[1:]:
        largest = where(abs(x) > largest, abs(x), largest)
    none = largest == 0
    v = [where(none, int(n == 2), x / where(none, 1, largest)) for n, x in enumerate(v)]
    length = sqrt(dot3(v, v))
    return largest * length, tuple(x / length for x in v)


# -- what is no rotation


def checked_rotation(R, tolerance=1e-9):
    """``R`` as three rows, if it is a rotation: R^T R = 1 within ``tolerance`` and determinant +1
    (4.2)-(4.4).

    Raises :class:`RotationError` saying what is wrong, :class:`ScalarError` where entries are
    expressions that have no value to look at.
    """
    try:
        shape = [len(row) for row in R]
    except TypeError:
        shape = None
    if shape != [3, 3, 3]:
        raise RotationError(
            "a rotation matrix is three rows of three entries; for many instants the "
            "entries are arrays, so that NumPy shows the shape (3, 3, N); "
            f"got {_shape_in_words(R, shape)}"
        )
    R = tuple(tuple(without_rates(x) for x in row) for row in R)
    gram = product(transpose(R), R)
    try:
        errors = [size(gram[n][m] - int(n == m)) for n in range(3) for m in range(3)]
        mirrored = size(determinant(R) - 1)
    except (TypeError, ValueError, RuntimeError) as problem:
        raise ScalarError(
            "to read axis, quaternion or angles from a matrix its entries must have values "
            "(floats, mpf, arrays); "
            f"this one has expressions, as {R[0][0]!r}. Put in numbers first, or keep the "
            "angles that it was built from"
        ) from problem
    if not all(error <= tolerance for error in errors):
        raise RotationError(
            f"not a rotation: R^T R differs from the unit matrix by {max(errors):.3g}, and "
            f"{tolerance:.3g} is allowed; its columns must be "
            "unit vectors at right angles. If the entries are rounded, say how far with tolerance="
        )
    if not mirrored < 1:
        raise RotationError(
            "not a rotation but a reflection: determinant -1, columns left-handed; reverse one "
            "axis, or mind their order"
        )
    return R


def _shape_in_words(R, shape):
    return (
        f"shape {R.shape}"
        if hasattr(R, "shape")
        else repr(R)
        if shape is None
        else f"rows of lengths {shape}"
    )


# -- quaternions


def quaternion(axis, angle):
    """The unit quaternion (cos(angle/2), sin(angle/2) e) of the turn by ``angle`` (rad) about
    ``axis`` (any length), right-handed.

    >>> quaternion((0, 0, 1), 0.0)
    (1.0, 0, 0, 0.0)
    """
    half = angle / 2
    return (cos(half), *(plain(sin(half) * x) for x in _unit(axis, angle)))


def quaternion_product(p, q):
    """The quaternion p q: the turn q, then p about fixed axes; its matrix is the product of the two
    matrices in the same order.
    """
    p0, p1, p2, p3 = _four(p)
    q0, q1, q2, q3 = _four(q)
    return (
        p0 * q0 - p1 * q1 - p2 * q2 - p3 * q3,
        p0 * q1 + p1 * q0 + p2 * q3 - p3 * q2,
        p0 * q2 - p1 * q3 + p2 * q0 + p3 * q1,
        p0 * q3 + p1 * q2 - p2 * q1 + p3 * q0,
    )


def normalised(q):
    """The quaternion with length 1 in the same direction; integration makes it drift.
    :class:`RotationError` for length zero.

    >>> normalised((3.0, 0.0, 4.0, 0.0))
    (0.6, 0.0, 0.8, 0.0)
    """
    q = _four(q)
    length = sqrt(_norm2(q))
    return tuple(plain(x / length) for x in q)


def matrix_from_quaternion(q):
    """The rotation matrix of a quaternion. One of any length will do and gives a true rotation: the
    formula divides by its square.

    >>> matrix_from_quaternion((1.0, 0, 0, 1.0))
    ((0.0, -1.0, 0), (1.0, 0.0, 0), (0, 0, 1))
    """
    q = _four(q)
    s = 2 / _norm2(q)
    w, x, y, z = q
    return _rows((
        (1 - s * (y * y + z * z), s * (x * y - w * z), s * (x * z + w * y)),
        (s * (x * y + w * z), 1 - s * (z * z + x * x), s * (y * z - w * x)),
        (s * (x * z - w * y), s * (y * z + w * x), 1 - s * (x * x + y * y)),
    ))  # fmt: skip


def quaternion_from_matrix(R, tolerance=1e-9):
    """The unit quaternion of a rotation matrix, its scalar part not negative; at an angle of pi,
    the sign of :func:`axis_angle`.

    Of the four ways to it (each divides by another component) the one with the largest divisor is
    taken, for each instant (S. W. Shepperd, Quaternion from rotation matrix, J. Guidance and
    Control 1, 223, 1978). Errors as for :func:`checked_rotation`.

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
    round_off = epsilon(q[0])
    sense = where(abs(q[0]) > 4 * round_off, q[0], _leading(q[1:], 64 * round_off))
    return tuple(where(sense < 0, 0 - x, x) for x in q)


def _leading(values, small):
    """The first of the values that is larger than ``small`` in size, or the last one."""
    *others, chosen = values
    for x in reversed(others):
        chosen = where(abs(x) > small, x, chosen)
    return chosen


def quaternion_rate(q, omega):
    """The rate q' = q (0, omega)/2, for the angular velocity ``omega`` (rad/s) in *body*
    components, a triple or a Vector of the body's frame.

    >>> quaternion_rate((0.8, 0, 0, 0.6), (0, 0, 1.0))
    (-0.3, 0, 0, 0.4)
    """
    rate = quaternion_product(q, (ZERO, *_three(omega, "an angular velocity")))
    return tuple(plain(x / 2) for x in rate)


def _four(q):
    q = tuple(scalar(x) for x in q)
    if len(q) != 4:
        raise RotationError(
            f"a quaternion has four components, the scalar part first; got {len(q)}: {q!r}"
        )
    return q


def _norm2(q):
    total = dot3(q, q) + q[3] * q[3]
    if _vanishes(total) or not is_finite(total):
        raise RotationError(
            f"{tuple(map(plain, q))} is the quaternion of no rotation: its length must be "
            "finite and not zero, at every instant"
        )
    return total


# -- Euler angles 3-1-3


def _about_x(angle):
    c, s = cos(angle), sin(angle)
    return (1, ZERO, ZERO), (ZERO, c, s), (ZERO, -s, c)


def _about_z(angle):
    c, s = cos(angle), sin(angle)
    return (c, s, ZERO), (-s, c, ZERO), (ZERO, ZERO, 1)


def euler_matrix(psi, theta, phi):
    """The rotation matrix, body to ground, of precession psi, nutation theta, spin phi (rad): the
    transpose of T_phi T_theta T_psi (10.10).

    >>> euler_matrix(0.0, 0.0, 0.0)[2]
    (0.0, 0.0, 1.0)
    """
    return transpose(product(_about_z(phi), _about_x(theta), _about_z(psi)))


def euler_angles(R, tolerance=1e-9):
    """The angles (psi, theta, phi) in rad of a rotation matrix, body to ground: psi and phi in
    (-pi, pi], theta in [0, pi] (10.5)-(10.10).

    At theta = 0 only psi + phi is determined and at theta = pi only psi - phi: there, within
    round-off, phi is 0 and psi has it all. Near these places an error of R enters psi and phi
    divided by sin(theta), but not their sum (their difference). Errors as for
    :func:`checked_rotation`.

    >>> [round(x, 12) for x in euler_angles(euler_matrix(0.3, 0.2, 0.1))]
    [0.3, 0.2, 0.1]
    >>> [round(x, 12) for x in euler_angles(euler_matrix(0.3, 0.0, 0.1))]
    [0.4, 0.0, 0.0]
    """
    return euler_from_quaternion(quaternion_from_matrix(R, tolerance))


def quaternion_from_euler(psi, theta, phi):
    """The unit quaternion of the Euler angles (rad), body to ground.

    >>> quaternion_from_euler(0.0, 0.0, 0.0)
    (1.0, 0.0, 0.0, 0.0)
    """
    c, s, add, subtract = cos(theta / 2), sin(theta / 2), (psi + phi) / 2, (psi - phi) / 2
    return c * cos(add), s * cos(subtract), s * sin(subtract), c * sin(add)


def euler_from_quaternion(q):
    """The Euler angles (psi, theta, phi) of a quaternion of any length; ranges, and the choice at
    theta = 0 and pi, as for :func:`euler_angles`.
    """
    w, x, y, z = (without_rates(c) for c in normalised(q))
    # cos and sin of theta/2; (w, z) has the angle (psi + phi)/2, (x, y) (psi - phi)/2
    upright, tilted = sqrt(w * w + z * z), sqrt(x * x + y * y)
    theta = 2 * atan2(tilted, upright)
    small = 4 * epsilon(upright)
    x, y = (where(tilted <= small, a, b) for a, b in ((w, x), (z, y)))
    w, z = (where(upright <= small, a, b) for a, b in ((x, w), (y, z)))
    # + 0 turns -0.0 into 0.0, whose angle is pi and not -pi
    psi = atan2(z * x + w * y + 0, w * x - z * y)
    phi = atan2(z * x - w * y + 0, w * x + z * y)
    return psi, theta, phi


def euler_body_rates(psi, theta, phi, rates):
    """The angular velocity in body components (10.12), rad/s, from the angles and ``rates`` =
    (psi', theta', phi').

    psi has no influence; it is there so that angles travel together.

    >>> euler_body_rates(0.0, 0.0, 0.0, (2.0, 0.5, 3.0))
    (0.5, 0.0, 5.0)
    """
    dpsi, dtheta, dphi = _three(rates, "(psi', theta', phi')")
    across = dpsi * sin(theta)
    return (
        plain(dtheta * cos(phi) + across * sin(phi)),
        plain(across * cos(phi) - dtheta * sin(phi)),
        plain(dphi + dpsi * cos(theta)),
    )


def euler_rates(psi, theta, phi, omega):
    """The rates (psi', theta', phi') in rad/s from the angles and the angular velocity ``omega`` in
    body components: (10.12) solved for them.

    Raises :class:`RotationError` where sin(theta) is zero within round-off: no rates of these
    angles give every angular velocity there.

    >>> [round(x, 12) for x in euler_rates(0.3, 0.2, 0.1, euler_body_rates(0.3, 0.2, 0.1, (2.0, 0.5, 3.0)))]
    [2.0, 0.5, 3.0]
    """
    x, y, z = _three(omega, "an angular velocity")
    s = sin(theta)
    if _vanishes(s, 4 * epsilon(without_rates(s))):
        raise RotationError(
            f"theta = {plain(theta)!r} rad: at theta = 0 and pi the axes of precession and "
            "spin coincide and the rates of Euler's angles are not "
            "determined; use quaternion_rate, which has no such place, and read angles off "
            "afterwards"
        )
    dpsi = (x * sin(phi) + y * cos(phi)) / s
    return plain(dpsi), plain(x * cos(phi) - y * sin(phi)), plain(z - dpsi * cos(theta))


def unwound(angles, rates, times):
    """Angles that were read off modulo a turn, made continuous by their rates at the same instants,
    where steps may be of many turns.

    angles (rad), rates (rad/s), times (s) : of shape (N,). Between two instants the mean of the two
        rates says about how far it went; the whole turns
    that fit best are added. Raises :class:`RotationError` where more than a quarter of a turn is
    left over: then the samples do not tell.

    >>> [round(float(x), 6) for x in unwound([0.0, 1.0, 2.0], [7.0, 7.4, 7.2], [0.0, 1.0, 2.0])]
    [0.0, 7.283185, 14.566371]
    """
    import numpy as np

    angles, rates, times = (np.asarray(x, dtype=float) for x in (angles, rates, times))
    missing = np.diff(times) * (rates[1:] + rates[:-1]) / 2 - np.diff(angles)
    turns = np.round(missing / (2 * np.pi))
    left = np.abs(missing - 2 * np.pi * turns)
    if not (left <= np.pi / 2).all():
        n = int(np.argmax(left))
        raise RotationError(
            f"between t = {times[n]:.6g} and {times[n + 1]:.6g} s the rates {rates[n]:.6g} "
            f"and {rates[n + 1]:.6g} rad/s leave {left[n]:.3g} rad: "
            "how many turns there were is not known; give more instants, or take the angle "
            "itself as a state of the motion"
        )
    return angles + 2 * np.pi * np.concatenate(([0.0], np.cumsum(turns)))


def euler_frame(parent, name, psi, theta, phi, origin=None):
    """The frame ``name``, placed in ``parent`` by three successive turns (10.2): psi about z, theta
    about the new x, phi about the new z.

    The angles are numbers, or :func:`moving` with their rates. The frames in between are its
    ``.parent``, the book's {i, j, k} that precesses and nutates without spinning, and its
    ``.parent.parent``. ``origin`` is a Point of ``parent``.

    >>> from newton_euler import Frame, moving
    >>> body = euler_frame(Frame("ground"), "top", moving(0.0, rate=2.0), 0.0, moving(0.0, rate=3.0))
    >>> body, body.angular_velocity(body.parent.parent.parent).components()
    (Frame(top < top nutated < top precessed < ground), (0.0, 0.0, 5.0))
    """
    precessed = parent.rotate(f"{name} precessed", "z", psi, origin=origin)
    return precessed.rotate(f"{name} nutated", "x", theta).rotate(name, "z", phi)

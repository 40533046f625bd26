"""Explicit motions in time: rotation matrices multiplied out, and derivatives by differences."""

from mpmath import mp, mpf

from .digits import DIGITS, weighted

# five-point rules at 50 digits: truncation 1e-36 times the fifth derivative, rounding 1e-32
STEP = "1e-9"


def rot(axis, angle):
    """The matrix that turns vectors by ``angle`` about ``axis`` ("x", "y", "z" or three
    components), right-handed: Rodrigues' formula.
    """
    e = (
        {"x": (1, 0, 0), "y": (0, 1, 0), "z": (0, 0, 1)}.get(axis, axis)
        if isinstance(axis, str)
        else axis
    )
    length = mp.sqrt(sum(mpf(x) ** 2 for x in e))
    e = [mpf(x) / length for x in e]
    c, s = mp.cos(angle), mp.sin(angle)
    skew = [[0, -e[2], e[1]], [e[2], 0, -e[0]], [-e[1], e[0], 0]]
    return [
        [c * (n == m) + s * skew[n][m] + (1 - c) * e[n] * e[m] for m in range(3)] for n in range(3)
    ]


def times(*factors):
    """The product of matrices, or of matrices with a final vector."""
    *rest, out = factors
    for a in reversed(rest):
        if isinstance(out[0], (list, tuple)):
            out = [[sum(a[n][k] * out[k][m] for k in range(3)) for m in range(3)] for n in range(3)]
        else:
            out = [sum(a[n][k] * out[k] for k in range(3)) for n in range(3)]
    return out


def transposed(a):
    """The transpose; for a rotation, its inverse: ``times(transposed(R), v)`` are the components of
    v in the turned axes.
    """
    return [list(row) for row in zip(*a, strict=True)]


def plus(*vectors):
    """The sum of vectors."""
    return [sum(x) for x in zip(*vectors, strict=True)]


def minus(a, b):
    """The difference of two vectors."""
    return [x - y for x, y in zip(a, b, strict=True)]


def scaled(s, a):
    """The vector s a."""
    return [s * x for x in a]


def size(a):
    """The magnitude of a vector."""
    return mp.sqrt(sum(x * x for x in a))


def cross(a, b):
    """The vector product."""
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def spun(axis, across, angle):
    """The orientation of a body that has turned on its ``axis`` by ``angle``, right-handed,
    starting from the direction ``across``.

    Both are unit vectors, square to each other. The columns are the axis and two directions that
    turn about it with the body: for :func:`angular_velocity` it does not matter which.
    """
    turned = plus(scaled(mp.cos(angle), across), scaled(mp.sin(angle), cross(axis, across)))
    return transposed([axis, turned, cross(axis, turned)])


def rate(f, t=0):
    """df/dt of a number, vector or matrix as a function of time, by a five-point central
    difference.
    """
    with mp.workdps(DIGITS):
        h, t = mpf(STEP), mpf(t)
        values = [f(t - 2 * h), f(t - h), f(t + h), f(t + 2 * h)]
        return weighted([w / (12 * h) for w in (1, -8, 8, -1)], values)


def second_rate(f, t=0):
    """d2f/dt2, by a five-point central difference."""
    with mp.workdps(DIGITS):
        h, t = mpf(STEP), mpf(t)
        values = [f(t + n * h) for n in (-2, -1, 0, 1, 2)]
        return weighted([w / (12 * h * h) for w in (-1, 16, -30, 16, -1)], values)


def angular_velocity(R, t=0):
    """omega of a body whose orientation matrix is R(t) (body components to ground components): the
    vector of the skew matrix R' R^T.
    """
    with mp.workdps(DIGITS):
        W = times(rate(R, t), transposed(R(mpf(t))))
        return [(W[2][1] - W[1][2]) / 2, (W[0][2] - W[2][0]) / 2, (W[1][0] - W[0][1]) / 2]


def angular_acceleration(R, t=0):
    """alpha of the same body: the skew part of R'' R^T (its symmetric part, -|omega|^2 and so on,
    drops out).
    """
    with mp.workdps(DIGITS):
        W = times(second_rate(R, t), transposed(R(mpf(t))))
        return [(W[2][1] - W[1][2]) / 2, (W[0][2] - W[2][0]) / 2, (W[1][0] - W[0][1]) / 2]

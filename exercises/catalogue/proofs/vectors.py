"""Vectors as lists of three, matrices as lists of rows, rotation matrices multiplied out."""

from collections.abc import Sequence

from mpmath import mp, mpf

from .digits import Matrix, Number, Triple, Value


def rot(axis: str | Sequence[Number], angle: Number) -> Matrix:
    """The rotation matrix about ``axis`` ("x" or three components), right-handed: Rodrigues."""
    named = {"x": (1, 0, 0), "y": (0, 1, 0), "z": (0, 0, 1)}
    e = named[axis] if isinstance(axis, str) else axis
    length = mp.sqrt(sum(mpf(x) ** 2 for x in e))
    e = [mpf(x) / length for x in e]
    c, s = mp.cos(angle), mp.sin(angle)
    skew = [[0, -e[2], e[1]], [e[2], 0, -e[0]], [-e[1], e[0], 0]]
    return [
        [c * (n == m) + s * skew[n][m] + (1 - c) * e[n] * e[m] for m in range(3)] for n in range(3)
    ]


def times(*factors: Value) -> Value:
    """The product of matrices, or of matrices with a final vector."""
    *rest, out = factors
    for a in reversed(rest):
        if isinstance(out[0], (list, tuple)):
            out = [[sum(a[n][k] * out[k][m] for k in range(3)) for m in range(3)] for n in range(3)]
        else:
            out = [sum(a[n][k] * out[k] for k in range(3)) for n in range(3)]
    return out


def transposed(a: Sequence[Sequence[Number]]) -> Matrix:
    """The transpose; of a rotation R, with ``times``, components in the turned axes."""
    return [list(row) for row in zip(*a, strict=True)]


def at_angle(r: Number, angle: Number, z: Number = 0) -> Triple:
    """The place at the distance r from the z axis, at this angle from x, at the height z."""
    return [r * mp.cos(angle), r * mp.sin(angle), z]


def plus(*vectors: Sequence[Number]) -> Triple:
    """The sum of vectors."""
    return [sum(x) for x in zip(*vectors, strict=True)]


def minus(a: Sequence[Number], b: Sequence[Number]) -> Triple:
    """The difference of two vectors."""
    return [x - y for x, y in zip(a, b, strict=True)]


def scaled(s: Number, a: Sequence[Number]) -> Triple:
    """The vector s a."""
    return [s * x for x in a]


def size(a: Sequence[Number]) -> Number:
    """The magnitude of a vector."""
    return mp.sqrt(sum(x * x for x in a))


def cross(a: Sequence[Number], b: Sequence[Number]) -> Triple:
    """The vector product."""
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]

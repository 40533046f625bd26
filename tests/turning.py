"""An oracle of relative motion: rotation matrices multiplied out, and differentiated by differences
in 50 digits. It knows no Coriolis term and no law of composition.

Vectors are columns of mpmath, orientations functions of time that take components in the body to
components in the ground.
"""

from mpmath import matrix, mp, mpf

DIGITS = 50
STEP = mpf(10) ** -9  # the five-point rules truncate at 1e-36 and round at 1e-32


def rot(axis, angle):
    """The matrix that turns by ``angle`` about "x", "y", "z" or three components: Rodrigues."""
    e = matrix([int(axis == name) for name in "xyz"] if isinstance(axis, str) else axis)
    e /= mp.norm(e)
    skew = matrix([[0, -e[2], e[1]], [e[2], 0, -e[0]], [-e[1], e[0], 0]])
    return mp.eye(3) + mp.sin(angle) * skew + (1 - mp.cos(angle)) * skew * skew


def rate(f, t=0):
    """df/dt by a five-point central difference."""
    with mp.workdps(DIGITS):
        weighted = (w * f(t + n * STEP) for n, w in ((-2, 1), (-1, -8), (1, 8), (2, -1)))
        return sum(weighted, 0 * f(t)) / (12 * STEP)


def second_rate(f, t=0):
    """d2f/dt2 by a five-point central difference."""
    with mp.workdps(DIGITS):
        weights = ((-2, -1), (-1, 16), (0, -30), (1, 16), (2, -1))
        return sum((w * f(t + n * STEP) for n, w in weights), 0 * f(t)) / (12 * STEP**2)


def angular_velocity(R):
    """omega of a body with the orientation R(t): the vector of the skew matrix R' R^T."""
    with mp.workdps(DIGITS):
        return axial(rate(R) * R(mpf(0)).T)


def angular_acceleration(R):
    """alpha of a body: the symmetric part of R'' R^T drops out."""
    with mp.workdps(DIGITS):
        return axial(second_rate(R) * R(mpf(0)).T)


def axial(W):
    """The vector of the skew part of a matrix."""
    return matrix([W[2, 1] - W[1, 2], W[0, 2] - W[2, 0], W[1, 0] - W[0, 1]]) / 2


def cross(a, b):
    """The vector product of two columns."""
    return matrix([a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]])

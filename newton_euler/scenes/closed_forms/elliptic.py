"""Jacobi's elliptic functions of the complementary parameter m1 = 1 - k^2, and three quantities
whose rates are products of the two others: over floats, arrays and mpf, and traced.

Next to a separatrix a float does not hold k^2, which SciPy takes, but m1 to the last digit.
"""

from collections.abc import Sequence

from ...algebra import scalars
from ...algebra.scalars import Scalar, Triple, atan2, cos, epsilon, max_abs, sin, sqrt, tanh, where

FEW, WIDE = 6, 1e-4  # levels that are enough for doubles m1 from 1e-4 to 1
MANY = 12  # levels for any double; a traced formula cannot know how many it needs
FAR = 350.0  # a hyperbolic function of more has a square that a double does not tell from 0


def jacobi(u: Scalar, m1: Scalar) -> tuple[Scalar, ...]:
    """sn, cn and dn of ``u`` for the complementary parameter ``m1`` in [0, 1], to a few round-offs
    of u, and the mean phase pi u/(2K), which is 0 where m1 is; the amplitude is within pi/2 of it.
    By descending Landen transformations (R. Bulirsch, Numerische Mathematik 7, 78, 1965).

    >>> [round(x, 12) for x in jacobi(0.5, 0.0)]  # tanh, 1/cosh, 1/cosh
    [0.46211715726, 0.88681888397, 0.88681888397, 0.0]
    """
    u, m1 = scalars.promote(u, m1)
    wide, bound = m1 > WIDE, m1 > 0
    k1 = sqrt(where(bound, m1, 1))
    # hyperbolic functions where m1 is 0
    u0 = where(bound, 0, u)
    e = scalars.exp(-where(abs(u0) < FAR, abs(u0), FAR))
    sech = 2 * e / (1 + e * e)
    end = tanh(u0), sech, sech, 0 * u0
    if scalars.is_numeric(k1):
        return tuple(where(bound, x, y) for x, y in zip(_landen(u, k1, None), end, strict=True))
    few, many = _landen(u, k1, FEW), _landen(u, k1, MANY)
    return tuple(where(wide, x, where(bound, y, z)) for x, y, z in zip(few, many, end, strict=True))


def _landen(u, k1, count):
    """The functions by ``count`` levels of means, or by as many as the value needs."""
    a, b, levels = 1, k1, []
    while True:
        levels.append((a, b))
        mean = (a + b) / 2
        close = count is None and max_abs((a - b) / a) <= sqrt(float(epsilon(a))) / 16
        if close or len(levels) == count:
            break
        a, b = mean, sqrt(a * b)
    phase = u * mean
    s, dn = sin(phase) + 1e-150, 1  # not 0
    cot = cos(phase) / s
    c = mean * cot
    for a, b in reversed(levels):
        product = cot * c
        c = c * dn
        dn = (b + product) / (a + product)
        cot = c / a
    sn = where(s < 0, -1, 1) / sqrt(c * c + 1)
    return sn, c * sn, dn, phase


def coupled(k: Triple, start: Triple, gap: Scalar, t: Scalar) -> tuple[Scalar, ...]:
    """Three quantities with x' = k_x y z, y' = k_y z x and z' = k_z x y at the time ``t`` after
    ``start``, and the mean phase of their motion.

    k : three coefficients, the second of a sign other than that of the two others; any may be zero
    gap : k_y (k_x z^2 - k_z x^2), whose sign tells whether z or x changes sign; next to the
        separatrix the caller knows it better than by subtraction

    By the addition theorem of Jacobi's functions (Landau and Lifshitz, Mechanics, 37): only those
    of the time are needed, and the denominator is a sum of squares.

    >>> # turns about x: y = cos(2 t), z = sin(2 t)
    >>> [round(x, 12) for x in coupled((0.0, -1.0, 1.0), (2.0, 1.0, 0.0), 4.0, 0.25)]
    [2.0, 0.87758256189, 0.479425538604, 0.5]
    """
    (kx, ky, kz), (x, y, z) = k, start
    p, r = -ky * kz * (x * x), -kx * ky * (z * z)
    about_x = gap > 0
    largest = where(about_x, p, r)
    square = largest + kz * kx * (y * y)
    moves = square > 0
    safe, rate = where(moves, square, 1), sqrt(square)
    s, c, d, phase = jacobi(rate * t, where(moves, abs(gap) / safe, 1))
    of_x, of_z = where(about_x, d, c), where(about_x, c, d)
    whole = c * c + s * s * (largest / safe)
    part = s / (where(moves, rate, 1) * whole)
    return (
        x * (of_x / whole) + kx * (y * z) * (part * of_z),
        y * (c * d / whole) + ky * (z * x) * part,
        z * (of_z / whole) + kz * (x * y) * (part * of_x),
        phase,
    )


def unwrapped(
    angle: Scalar, start: Sequence[Scalar], now: Sequence[Scalar], phase: Scalar
) -> Scalar:
    """The ``angle`` (rad) after the point at its cosine and sine ``start`` has moved to ``now``,
    through as many turns as bring it within pi of ``angle + phase``.

    >>> start = 0.877582561890, 0.479425538604
    >>> round(unwrapped(0.5, start, start, 12.0), 6)  # two turns: 0.5 + 4 pi
    13.066371
    """
    (c, s), (c1, s1) = start, now
    along, across, turn, swing = c1 * c + s1 * s, s1 * c - c1 * s, cos(phase), sin(phase)
    return angle + (phase + atan2(across * turn - along * swing, along * turn + across * swing))

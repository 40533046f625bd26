"""Jacobi's elliptic functions and the elliptic integral of the first kind, from the *complementary* parameter m1 = 1 - k^2.

Next to a separatrix k^2 is so near 1 that a float does not hold it (SciPy's functions take k^2, and there give nonsense); m1 it holds to the
last digit. Over floats, arrays and mpf. Accuracy: a few round-offs of the argument, for every m1 from 1 (circular functions) to 0 (hyperbolic ones).
"""

from .scalars import cos, epsilon, exp, plain, sin, size, sqrt, tanh, where


def jacobi(u, m1):
    """sn, cn and dn of ``u`` for the complementary parameter ``m1`` in [0, 1] (R. Bulirsch, Numerische Mathematik 7, 78, 1965).

    >>> [round(x, 12) for x in jacobi(0.5, 0.0)]  # tanh, 1/cosh, 1/cosh
    [0.46211715726, 0.88681888397, 0.88681888397]
    """
    u, m1 = (plain(x) + 0 * (plain(u) + plain(m1)) for x in (u, m1))
    limit = m1 == 0
    a, b, levels = 1 + 0 * m1, sqrt(where(limit, 1, m1)), []
    while True:
        levels.append((a, b))
        mean = (a + b) / 2
        if size((a - b) / a) <= sqrt(float(epsilon(a))) / 16:
            break
        a, b = mean, sqrt(a * b)
    phase = u * mean
    s, c, dn = sin(phase), cos(phase), 1 + 0 * phase
    s = where(s == 0, 1e-100 + 0 * s, s)
    cot = c / s
    c = mean * cot
    for a, b in reversed(levels):
        product = cot * c
        c = c * dn
        dn = (b + product) / (a + product)
        cot = c / a
    sn = where(s < 0, -1, 1) / sqrt(c * c + 1)
    e = exp(-abs(where(limit, u, 0 * u)))
    sech = 2 * e / (1 + e * e)
    return where(limit, tanh(u), sn), where(limit, sech, c * sn), where(limit, sech, dn)


def first_kind(s, c, m1):
    """The elliptic integral F of an amplitude in [-pi/2, pi/2], given by its sine and cosine: the ``u`` whose sn and cn these are.

    >>> round(first_kind(1.0, 0.0, 1.0), 12)  # pi/2
    1.570796326795
    """
    return s * symmetric_integral(c * c, c * c + m1 * (s * s), c * c + s * s)


def symmetric_integral(x, y, z):
    """Carlson's R_F(x, y, z), half the integral of 1/sqrt((t + x)(t + y)(t + z)) from 0 on; numbers >= 0, at most one of them zero."""
    x, y, z = (plain(v) + 0 * (plain(x) + plain(y) + plain(z)) for v in (x, y, z))
    while True:
        mean = (x + y + z) / 3
        X, Y, Z = (1 - v / mean for v in (x, y, z))
        if max(map(size, (X, Y, Z))) <= (float(epsilon(mean)) / 8) ** (1 / 6):
            break
        step = sqrt(x) * sqrt(y) + sqrt(y) * sqrt(z) + sqrt(z) * sqrt(x)
        x, y, z = ((v + step) / 4 for v in (x, y, z))
    E2, E3 = X * Y - Z * Z, X * Y * Z
    return (1 - E2 / 10 + E3 / 14 + E2 * E2 / 24 - 3 * E2 * E3 / 44) / sqrt(mean)

"""Numbers, vectors and matrices of many digits compared."""

from mpmath import mpf


def near(a, b, tolerance="1e-30"):
    if isinstance(a, (list, tuple)):
        return len(a) == len(b) and all(near(x, y, tolerance) for x, y in zip(a, b, strict=True))
    return abs(a - b) <= mpf(tolerance)

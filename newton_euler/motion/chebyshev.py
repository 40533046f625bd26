"""Sums of Chebyshev polynomials on (-1, 1), many at once; and the zero in a bracket."""

from collections.abc import Callable, Sequence
from functools import cache

from ..algebra.late import np

DEGREE = 12
EPS = 2.0**-52


def values_at(fits: "np.ndarray", x: "np.ndarray") -> "np.ndarray":
    """The values of polynomials at one place each."""
    k = np.arange(fits.shape[1])
    return (fits * np.cos(np.arccos(x)[:, None] * k)).sum(axis=1)


@cache
def _differentiation():
    """The matrix that turns the coefficients of a polynomial into those of its derivative."""
    return np.polynomial.chebyshev.chebder(np.eye(DEGREE + 1)).T


def derivatives_at(fits: "np.ndarray", x: "np.ndarray") -> "np.ndarray":
    """The slopes of polynomials at one place each."""
    return values_at(fits[:, : DEGREE + 1] @ _differentiation(), x)


def extrema(fits: "np.ndarray") -> "tuple[np.ndarray, np.ndarray]":
    """All extrema of polynomials in (-1, 1): their indices, and the places in order."""
    with np.errstate(all="ignore"):  # values of a function near its pole
        c = fits @ _differentiation()
    sizes = np.abs(c)
    largest = sizes.max(axis=1, keepdims=True)
    # the others are monotonic, or constant
    rows = np.flatnonzero((sizes[:, 0] <= sizes[:, 1:].sum(axis=1)) & (largest[:, 0] > 0))
    degree = int(np.flatnonzero((sizes > 1e-9 * largest).any(axis=0)).max(initial=0))
    if not rows.size or not degree:
        return np.array([], dtype=int), np.array([])
    c, largest = c[rows, : degree + 1], largest[rows, 0]
    # a leading coefficient near zero would spoil the matrix; it only adds zeros far away
    c[:, -1] = np.where(np.abs(c[:, -1]) < 1e-9 * largest, 1e-9 * largest, c[:, -1])
    z = np.linalg.eigvals(_companions(c))
    # a double one may come out as a complex pair; a place without an extremum does no harm
    inside = (np.abs(z.imag) < 1e-3) & (np.abs(z.real) < 1)
    x = np.where(inside, z.real, 2.0)
    x.sort(axis=1)
    number, place = np.nonzero(x < 2)
    return rows[number], x[number, place]


def _companions(c):
    """Matrices with the zeros of polynomials as eigenvalues: NumPy's ``chebcompanion`` for many."""
    n = c.shape[1] - 1
    scale = np.sqrt([1.0] + [0.5] * (n - 1))
    last = c[:, :-1] / c[:, -1:] * (scale / scale[-1])
    matrix = np.repeat(np.polynomial.chebyshev.chebcompanion([0.0] * n + [1.0])[None], len(c), 0)
    matrix[:, :, -1] -= last if n == 1 else last / 2
    # rotated, the errors are smaller, as in chebroots
    return matrix[:, ::-1, ::-1]


def value_at(c: Sequence[float], x: float) -> float:
    """The value of one polynomial, by Clenshaw's rule."""
    a = b = 0.0
    for value in c[:0:-1]:
        a, b = value + 2 * x * a - b, a
    return c[0] + x * a - b


def root(f: Callable[[float], float], a: float, b: float, accuracy: float = 0.0) -> float:
    """The zero of ``f`` between a and b, where its signs differ, to round-off or to this accuracy:
    Illinois rule (M. Dowell, P. Jarratt, BIT 11 (1971) 168), every fourth time a bisection.
    """
    fa, fb, side = f(a), f(b), 0
    if fb == 0:
        return b
    for n in range(200):
        if fa == 0:
            return a
        if abs(b - a) <= max(accuracy, EPS * max(abs(a), abs(b))):
            break
        t = (a + b) / 2 if n % 4 == 3 or fa * fb >= 0 else (a * fb - b * fa) / (fb - fa)
        if not min(a, b) < t < max(a, b):
            t = (a + b) / 2
        value = f(t)
        if value == 0:
            return t
        if (value > 0) == (fb > 0):
            b, fb, fa, side = t, value, fa / 2 if side == 1 else fa, 1
        else:
            a, fa, fb, side = t, value, fb / 2 if side == -1 else fb, -1
    return (a + b) / 2

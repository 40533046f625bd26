"""Integrals over the unit cube of several dimensions, for the kinds of number that SciPy's adaptive
cubature does not take: the product of Gauss rules, with more places until it settles.
"""

from functools import cache
from itertools import product

from .scalars import ZERO, SingularError, _Own, epsilon, is_numeric, max_abs, scalar

ORDERS = 8, 16, 32, 48, 64, 96  # places along each dimension
MOST = 300_000  # places in all
NEAR_MIDDLE = 0.4375  # a place for a trial; the middle may be one of symmetry, without a direction


def over_cube(f, n):
    """The integrals of the scalars in the tuple ``f(t_1, …, t_n)`` over the unit cube.

    f : written with functions of this package, smooth, also at the faces. It is called with arrays
        of places, or, where it returns numbers of mpmath, with one place at a time
    Raises :class:`SingularError` if the integrals do not settle.
    """
    sample = tuple(map(scalar, f(*(NEAR_MIDDLE,) * n)))
    present = [x for x in sample if x is not ZERO]
    own = [x for x in present if isinstance(x, _Own)]
    if own:
        return max(own, key=lambda x: x.rank)._over_cube(f, n)
    if not all(map(is_numeric, present)):
        raise SingularError(f"an integral over a cube takes numbers, got {sample!r}")
    small = min(map(epsilon, present), default=epsilon())
    rule = _by_arrays if small >= 2.0**-53 else _one_by_one
    before, last = None, 1
    for order in (m for m in ORDERS if m**n <= MOST):
        found, sizes = rule(f, n, order, sample)
        # the error falls geometrically: these have all digits if the last ones had a part of them
        # that is as large as the last order is of this one
        allowed = [1e-2 * small ** (last / order) * max_abs(size) for size in sizes]
        if before is not None and all(
            max_abs(x - y) <= a for x, y, a in zip(found, before, allowed, strict=True)
        ):
            return found
        before, last = found, order
    raise SingularError(
        "an integral over a body does not settle: its formula and density must be smooth within "
        "the limits. Divide it where they are not"
    )


def _by_arrays(f, n, order, sample):
    """The sums over all places at once; along an axis next to those of arrays that f returns."""
    import numpy as np

    depth = max(len(getattr(x, "shape", ())) for x in sample)
    nodes, weights = np.polynomial.legendre.leggauss(order)
    places = np.array(list(product((nodes + 1) / 2, repeat=n))).T
    shares = np.array(list(product(weights / 2, repeat=n))).prod(axis=1)
    column = (-1, *(1,) * depth)
    values = f(*(p.reshape(column) for p in places))
    shares = shares.reshape(column)

    def total(y):
        if y is ZERO:
            return ZERO
        y = np.broadcast_to(y, np.broadcast_shapes(np.shape(y), shares.shape))
        y = (shares * y).sum(axis=0)
        return y if depth else float(y)

    return tuple(map(total, values)), [total(abs(y)) for y in values]


def _one_by_one(f, n, order, sample):
    """The sums place by place, with all the digits of mpmath."""
    found, sizes = [ZERO] * len(sample), [ZERO] * len(sample)
    for pairs in product(_gauss(order, epsilon(sum(sample))), repeat=n):
        share = 1
        for _, weight in pairs:
            share = share * weight
        for k, y in enumerate(f(*(place for place, _ in pairs))):
            found[k] = found[k] + share * y
            sizes[k] = sizes[k] + share * abs(y)
    return tuple(found), sizes


@cache
def _gauss(order, _small):
    """Places and weights on (0, 1), to the working precision of mpmath: the roots of the Legendre
    polynomial by Newton's method.
    """
    from mpmath import mp

    pairs = []
    for k in range(order):
        x = mp.cos(mp.pi * (k + mp.mpf(3) / 4) / (order + mp.mpf(1) / 2))
        for _ in range(10):
            before, value = mp.mpf(1), x
            for m in range(2, order + 1):
                before, value = value, ((2 * m - 1) * x * value - (m - 1) * before) / m
            slope = order * (before - x * value) / (1 - x * x)
            x = x - value / slope
        pairs.append(((1 + x) / 2, 1 / ((1 - x * x) * slope**2)))
    return pairs

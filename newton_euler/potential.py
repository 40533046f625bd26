"""Potential energy (11.15)-(11.25), (11.34), (11.35): of given forces, and of a force field, if it has one.

A force that depends on the place alone has a potential V, with F = -grad V, if its work round every closed path is zero. Where its curl is zero this
holds in a region without holes; round a hole the circulation must be zero too, which the book does not say.
"""

from dataclasses import dataclass
from itertools import pairwise, product

from .scalars import ZERO, Moving, is_numeric, plain, scalar, size
from .work import WorkError, integral, work_along


class NoPotential(WorkError):
    """A force field without a potential: where its curl is not zero (``place``, ``curl``), or round which loop it does work (``circulation``)."""

    def __init__(self, message, place=None, curl=None, circulation=None):
        super().__init__(message)
        self.place, self.curl, self.circulation = place, curl, circulation


# -- potentials of known forces


def weight_potential(m, g, height):
    """V = m g z (11.34), height upward from any level. It is F = -m g k.

    >>> weight_potential(2.0, 9.81, 3.0)
    58.86
    """
    return plain(scalar(m) * g * height)


def spring_potential(stiffness, stretch):
    """V = K x^2/2 (11.35), x from the unloaded length, whether stretched or pressed.

    >>> spring_potential(200.0, -0.1)
    1.0
    """
    return plain(scalar(stiffness) * stretch * stretch / 2)


def gravitational_potential(K, M, m, r):
    """V = -K M m / r (11.24), zero far away; r from the centre of M.

    >>> gravitational_potential(1.0, 6.0, 2.0, 3.0)
    -4.0
    """
    return plain(-(scalar(K) * M * m) / r)


# -- of a force field


def jacobian(force, place):
    """dF_i/dx_j of a force field at (x, y, z), exactly: three rows of three."""
    columns = []
    for m in range(3):
        moved = [Moving(scalar(x), 1 if n == m else ZERO) for n, x in enumerate(place)]
        columns.append([plain(f.rate) if isinstance(f, Moving) else 0 for f in map(scalar, force(*moved))])
    return tuple(tuple(columns[m][n] for m in range(3)) for n in range(3))


def curl(force, place):
    """The curl of a force field at (x, y, z): (dF_z/dy - dF_y/dz, dF_x/dz - dF_z/dx, dF_y/dx - dF_x/dy).

    force : function of x, y, z that returns three components, written with functions of this package

    >>> curl(lambda x, y, z: (-y, x, 0), (1.0, 2.0, 3.0))
    (0, 0, 2)
    """
    J = jacobian(force, place)
    return tuple(plain(scalar(J[n][m]) - J[m][n]) for n, m in ((2, 1), (0, 2), (1, 0)))


@dataclass(frozen=True)
class Potential:
    """The potential of ``force``, zero at ``base``: call it with x, y, z. By integration along the straight line from the base."""

    force: object
    base: tuple
    rtol: float = 1e-10

    def __call__(self, x, y, z):
        target = (x, y, z)
        line = tuple(scalar(b) - a for a, b in zip(self.base, target, strict=True))

        def along(s):
            F = self.force(*(a + s * d for a, d in zip(self.base, line, strict=True)))
            total = ZERO
            for f, d in zip(F, line, strict=True):
                total = total + scalar(f) * d
            return total

        exact = not all(map(is_numeric, target))
        first, last = (0, 1) if exact else (0 * plain(scalar(x)), 0 * plain(scalar(x)) + 1)
        return -integral(along, first, last, self.rtol, exact).value


def find_potential(force, base=(0, 0, 0), box=((-1, 1),) * 3, loops=(), tolerance=1e-9):
    """The :class:`Potential` of a force field, or the reason why there is none, as a :class:`NoPotential` (11.16)-(11.18).

    force : function of x, y, z, returning (F_x, F_y, F_z), written with functions of this package
    base : where V is zero; straight lines from it must stay where the force exists
    box : the region in which the field is used, three pairs (low, high): the curl is tested on a grid in it, relative to the derivatives of F
    loops : closed paths, functions of a parameter from 0 to 1, one round each hole of the region: where the force does not exist, as on an axis,
        a zero curl is not enough

    >>> V = find_potential(lambda x, y, z: (-2.0*x, -2.0*y, 0.0))
    >>> round(V(3.0, 4.0, 0.0), 9)
    25.0
    """
    for place in product(*([low + (high - low) * (n + 0.37) / 3 for n in range(3)] for low, high in box)):
        _check_curl(force, place, tolerance)
    for n, loop in enumerate(loops, 1):
        U = work_along(force, loop, 0.0, 1.0)
        if abs(U.value) > max(tolerance * _round_trip(force, loop), 10 * U.error):
            raise NoPotential(
                f"there is no potential: round loop {n} the force does the work {U.value:.6g}, though its curl is zero; the loop goes round a place "
                "where the force does not exist, and V would grow by this much with every turn",
                circulation=U.value,
            )
    return Potential(force, base)


def _check_curl(force, place, tolerance):
    J = jacobian(force, place)
    largest = max(size(scalar(x)) for row in J for x in row)
    c = curl(force, place)
    if max(size(scalar(x)) for x in c) > tolerance * largest:
        told = ", ".join(f"{float(x):.4g}" for x in c)
        where = ", ".join(f"{x:.4g}" for x in place)
        raise NoPotential(f"there is no potential: at ({where}) the curl of the force is ({told}), not zero; its work depends on the path", place, c)


def _round_trip(force, loop):
    """The size of F times the length of the loop, roughly: what its work is compared with."""
    places = [tuple(float(plain(scalar(x))) for x in loop(n / 24)) for n in range(25)]
    length = sum(sum((b - a) ** 2 for a, b in zip(p, q, strict=True)) ** 0.5 for p, q in pairwise(places))
    return length * max(sum(size(scalar(f)) ** 2 for f in force(*p)) ** 0.5 for p in places)

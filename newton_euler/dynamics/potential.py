"""Potential energy (11.15)-(11.25), (11.34), (11.35): of given forces, and of a force field, if it
has one.

A force that depends on the place alone has a potential V, with F = -grad V, if its work round every
closed path is zero. Where its curl is zero this holds in a region without holes; round a hole, as
round an axis on which the force does not exist, the circulation must be zero too, which the book
does not say. Units: any consistent ones; in SI J.
"""

from dataclasses import dataclass
from itertools import pairwise, product

from ..algebra.jets import Moving
from ..algebra.quadrature import WorkError, quadrature
from ..algebra.scalars import (
    ZERO,
    ScalarError,
    is_finite,
    is_numeric,
    plain,
    probe,
    scalar,
    short,
    size,
)
from ..bodies.admissibility import positive
from ..kinematics.curvilinear_systems import gradient, tangents
from ..kinematics.frames import Point
from ..kinematics.triads import norm3
from .gravity import G_STANDARD, K
from .work import work_along


class NoPotential(WorkError):
    """A force field without a potential: where its curl is not zero (``place``, ``curl``), or round
    which loop it does work (``circulation``).
    """

    def __init__(self, message, place=None, curl=None, circulation=None):
        super().__init__(message)
        self.place, self.curl, self.circulation = place, curl, circulation


# -- potentials of known forces


def weight_potential(m, height, g=G_STANDARD):
    """V = m g z (11.34), the height z of the centre of mass counted upward from any level.

    >>> weight_potential(2.0, 3.0)
    58.86
    """
    return plain(scalar(m) * g * height)


def spring_potential(stiffness, stretch):
    """V = K x^2/2 (11.35), x from the unloaded length, whether stretched or pressed; of a torsion
    spring with the angle for x.

    >>> spring_potential(200.0, -0.1)
    1.0
    """
    return plain(scalar(stiffness) * stretch * stretch / 2)


def spring_between(stiffness, free_length, first, second):
    """V of a straight spring between two places (11.35): its stretch is their distance less the
    free length.

    first, second : two Points, and V is that of the instant, without rates; or two triples of
        coordinates along the same axes, and V can be differentiated, as by
        :func:`conservative_force`

    >>> from newton_euler import Frame
    >>> ground = Frame("ground")
    >>> spring_between(100.0, 4.0, ground.origin, ground.point("P", 3.0, 4.0, 0))
    50.0
    """
    if isinstance(first, Point):
        return spring_potential(stiffness, scalar((second - first).norm()) - free_length)
    return spring_potential(
        stiffness,
        norm3(tuple(scalar(b) - a for a, b in zip(first, second, strict=True))) - free_length,
    )


def gravitational_potential(m1, m2, distance, K=K):
    """V = -K m1 m2/r of the attraction of two particles, or radially symmetric bodies outside of
    each other (11.24); zero far away.

    >>> gravitational_potential(6.0, 2.0, 3.0, K=1.0)
    -4.0
    """
    positive(
        distance.value if isinstance(distance, Moving) else scalar(distance),
        "the distance of the two bodies",
    )
    return plain(-(scalar(K) * m1 * m2) / distance)


def conservative_force(V, P):
    """The force F = -grad V (11.16)-(11.18) of the potential ``V`` at the Point ``P``, a Vector.

    V : function of the coordinates by which P is given, rectangular or others, as for
        :func:`newton_euler.kinematics.curvilinear_systems.gradient`; a formula of these, since what goes by
        way of Points forgets their rates and would have no slope

    >>> from newton_euler import Frame
    >>> conservative_force(lambda x, y, z: 9.81*z, Frame("ground").point("P", 1.0, 2.0, 3.0)).components()
    (0, 0, -9.81)
    """
    return -gradient(V, P)


# -- of a force field


def jacobian(force, place):
    """dF_i/dx_j of a force field at (x, y, z), exact and without a step size: three rows of three.

    force : function of x, y, z that returns three components, written with functions of this
        package
    """
    return tuple(
        zip(
            *(
                tuple(map(plain, column))
                for column in tangents(_checked(force), tuple(map(scalar, place)))
            ),
            strict=True,
        )
    )


def curl(force, place):
    """The curl of a force field at (x, y, z): (dF_z/dy - dF_y/dz, dF_x/dz - dF_z/dx, dF_y/dx -
    dF_x/dy).

    >>> curl(lambda x, y, z: (-y, x, 0), (1.0, 2.0, 3.0))
    (0, 0, 2)
    """
    return _antisymmetric(jacobian(force, place))


def _antisymmetric(J):
    return tuple(plain(scalar(J[n][m]) - J[m][n]) for n, m in ((2, 1), (0, 2), (1, 0)))


def _checked(force):
    """The same force field, with three components, or words where it does not exist."""

    def at(*place):
        where = tuple(plain(x.value) if isinstance(x, Moving) else plain(x) for x in place)
        try:
            F = tuple(scalar(f) for f in force(*place))
        except (ArithmeticError, ValueError, ScalarError) as problem:
            raise WorkError(
                f"the force has no value at {where}: {problem}; keep base, box and loops where "
                "it exists"
            ) from problem
        if len(F) != 3:
            raise WorkError(
                "a force field returns (F_x, F_y, F_z), with 0 for what is missing; got "
                f"{len(F)} components at {where}"
            )
        if not all(map(is_finite, F)):
            raise WorkError(
                f"the force is {F} at {where}, not finite; keep base, box and loops where it exists"
            )
        return F

    return at


@dataclass(frozen=True)
class Potential:
    """The potential of ``force``, zero at ``base``: call it with x, y, z. It integrates along the
    straight line from the base (11.20).

    Of numbers by quadrature (a SymPy number is one: to keep it exact, ask with symbols and put it
    in); of SymPy expressions by formulas, which may take SymPy long, or for ever; of moving
    coordinates with the rate of V, which is -F.v (11.19), so that ``gradient(V, P)`` and
    ``at(lambda t: V(*place(t)), t)`` work.
    """

    force: object
    base: tuple
    rtol: float = 1e-10

    def __call__(self, x, y, z):
        target = tuple(scalar(c) for c in (x, y, z))
        values = tuple(c.value if isinstance(c, Moving) else c for c in target)
        V = self._from_base(values)
        if not any(isinstance(c, Moving) for c in target):
            return V
        lost = -_along(
            self.force(*target),
            tuple(
                Moving(c.rate, c.acceleration) if isinstance(c, Moving) else ZERO for c in target
            ),
        )
        return Moving(V, lost.value, lost.rate) if isinstance(lost, Moving) else Moving(V, lost)

    def _from_base(self, target):
        line = tuple(x - a for a, x in zip(map(scalar, self.base), target, strict=True))
        exact = not all(map(is_numeric, (*target, *map(scalar, self.base))))

        def along(s):
            return _along(
                _checked(self.force)(*(a + s * d for a, d in zip(self.base, line, strict=True))),
                line,
            )

        # zero in the kind of the coordinates: an mpf keeps its digits
        start = plain(0 * sum(map(plain, target)))
        return -quadrature(
            along, 0 if exact else start, 1 if exact else start + 1, self.rtol, exact
        )[0]


def _along(F, line):
    return sum((scalar(f) * d for f, d in zip(F, line, strict=True)), ZERO)


def find_potential(force, base=(0, 0, 0), box=((-1, 1),) * 3, loops=(), tolerance=1e-9):
    """The :class:`Potential` of a force field, or the reason why there is none, as a
    :class:`NoPotential` (11.16)-(11.18).

    force : function of x, y, z that returns (F_x, F_y, F_z), written with functions of this
        package; symbols in it count as numbers of their own
    base : where V is zero; straight lines from it must stay where the force exists
    box : the region in which the field is used, three pairs (low, high)
    loops : closed paths, functions of a parameter from 0 to 1, one round each hole of the region,
        as round an axis on which the force does not exist; a hole is not found without its loop
    tolerance : of the curl, on a grid of 27 places of the box, relative to the derivatives of F;
        and of the work round a loop, relative to size of F times length. A spot check: a curl that
        is zero at these places alone passes.

    >>> V = find_potential(lambda x, y, z: (-2.0*x, -2.0*y, 0.0))
    >>> round(V(3.0, 4.0, 0.0), 9)
    25.0
    """
    for place in product(
        *([low + (high - low) * (n + 0.37) / 3 for n in range(3)] for low, high in box)
    ):
        _check_curl(force, place, tolerance)
    for n, loop in enumerate(loops, 1):
        _check_loop(_checked(force), loop, n, tolerance)
    return Potential(force, tuple(base))


def _check_curl(force, place, tolerance):
    J = jacobian(force, place)
    largest = max(_measure(x) for row in J for x in row)
    c = _antisymmetric(J)
    if max(map(_measure, c)) > tolerance * largest:
        told = ", ".join(map(short, c))
        where = ", ".join(map(short, place))
        raise NoPotential(
            f"there is no potential: at ({where}) the curl of the force is ({told}), not zero; "
            "its work depends on the path",
            place,
            c,
        )


def _measure(x):
    """The size of a derivative; of an expression, that at some values of its symbols."""
    value = probe(scalar(x))
    if value is None:
        raise WorkError(
            f"the derivative {plain(x)!r} of the force cannot be compared with zero; put "
            "numbers or SymPy symbols in"
        )
    return size(value)


def _check_loop(force, loop, n, tolerance):
    places = [tuple(plain(scalar(x)) for x in loop(k / 24)) for k in range(25)]
    if max(size(scalar(a) - b) for a, b in zip(places[0], places[-1], strict=True)) > 1e-9 * max(
        size(scalar(x)) for p in places for x in p
    ):
        raise WorkError(f"loop {n} is not closed: it leads from {places[0]} to {places[-1]}")
    strength = max(_measure(f) for p in places for f in force(*p))
    length = sum(
        norm3(tuple(b - a for a, b in zip(p, q, strict=True))) for p, q in pairwise(places)
    )
    U = work_along(lambda *place: tuple(probe(f) for f in force(*place)), loop, 0.0, 1.0)
    if size(scalar(U.value)) > max(tolerance * length * strength, 10 * U.error):
        raise NoPotential(
            f"there is no potential: round loop {n} the force does the work "
            f"{short(U.value)}, though its curl is zero; the loop goes round a place "
            "where the force does not exist, and V would grow by this much with every turn",
            circulation=U.value,
        )

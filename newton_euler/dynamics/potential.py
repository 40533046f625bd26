"""Potential energy (11.15)-(11.25), (11.34), (11.35): of given forces, and of a force field.

F(x, y, z) = -grad V if its work around every closed path is zero: its curl must be zero, and, which
the book does not say, the circulation around each hole of the region, such as an axis on which F
does not exist. Units: any consistent ones; in SI J.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from itertools import pairwise, product

from ..algebra import WorkError
from ..algebra.errors import Accuracy, Tolerance, checked
from ..algebra.jets import Moving
from ..algebra.names import guided
from ..algebra.places import at_a_place
from ..algebra.quadrature import NO_VALUE, quadrature
from ..algebra.scalars import (
    ZERO,
    Rows,
    Scalar,
    ScalarError,
    Triple,
    hypot,
    is_finite,
    is_numeric,
    max_abs,
    probe,
    real_scalar,
    scalar,
    short,
    to_plain,
)
from ..algebra.vectors import FrameError, Vector
from ..bodies.admissibility import not_negative, positive
from ..kinematics.curvilinear_systems import gradient, tangents
from ..kinematics.frames import Point
from ..kinematics.paths import Path
from .gravity import G_STANDARD, K
from .work import Field, magnitude, work_along


class NoPotential(WorkError):
    """A field without potential: ``curl`` at ``place``, or ``circulation`` round a loop, not 0."""

    def __init__(
        self,
        message: str,
        place: Point | None = None,
        curl: Vector | None = None,
        circulation: Scalar | None = None,
    ):
        super().__init__(message)
        self.place, self.curl, self.circulation = place, curl, circulation


@checked
def weight_potential(m: Scalar, height: Scalar, g: Scalar = G_STANDARD) -> Scalar:
    """The potential V = m g z of a weight (11.34), z the height of the centre of mass.

    >>> weight_potential(2.0, 3.0)
    58.86
    """
    not_negative(m, "the mass")
    return to_plain(scalar(m) * g * height)


@checked
def spring_potential(stiffness: Scalar, stretch: Scalar) -> Scalar:
    """The potential V = K x^2/2 of a spring (11.35), x the stretch, or an angle.

    >>> spring_potential(200.0, -0.1)
    1.0
    """
    return to_plain(scalar(stiffness) * stretch * stretch / 2)


@checked
def spring_between(
    stiffness: Scalar,
    free_length: Scalar,
    first: Point | Sequence[Scalar],
    second: Point | Sequence[Scalar],
) -> Scalar:
    """The potential of a spring between two places (11.35): stretch, distance less free length.

    first, second : two Points, and V is that of the instant, without rates; or two triples of
        coordinates along the same axes, which can be differentiated, as by
        :func:`conservative_force`

    >>> from newton_euler import Frame
    >>> ground = Frame("ground")
    >>> spring_between(100.0, 4.0, ground.origin, ground.point("P", 3.0, 4.0, 0))
    50.0
    """
    if isinstance(first, Point) or isinstance(second, Point):
        if not (isinstance(first, Point) and isinstance(second, Point)):
            raise FrameError("a spring is between two Points, or between two triples")
        distance = (second - first).norm()
    else:
        distance = hypot(*(scalar(b) - a for a, b in zip(first, second, strict=True)))
    return spring_potential(stiffness, scalar(distance) - free_length)


@checked
def gravitational_potential(m1: Scalar, m2: Scalar, distance: Scalar, K: Scalar = K) -> Scalar:
    """The potential V = -K m1 m2/r of the attraction of two radially symmetric bodies (11.24).

    >>> gravitational_potential(6.0, 2.0, 3.0, K=1.0)
    -4.0
    """
    r = distance.value if isinstance(distance, Moving) else scalar(distance)
    positive(r, "the distance of the two bodies")
    for m in (m1, m2):
        not_negative(m, "the mass of a body")
    return to_plain(-(scalar(K) * m1 * m2) / distance)


@checked
def conservative_force(V: Callable[..., Scalar], P: Point) -> Vector:
    """The force F = -grad V (11.16)-(11.18) of the potential ``V`` at the Point ``P``.

    V : formula of the coordinates by which P is given, rectangular or others, as for
        :func:`newton_euler.kinematics.curvilinear_systems.gradient`

    >>> from newton_euler import Frame
    >>> P = Frame("ground").point("P", 1.0, 2.0, 3.0)
    >>> conservative_force(lambda x, y, z: 9.81*z, P).components()
    (0, 0, -9.81)
    """
    return -gradient(V, P)


@checked
def jacobian(force: Field, place: Sequence[Scalar]) -> Rows:
    """The derivatives dF_i/dx_j of a force field ``force(x, y, z)``, exact, three rows of three.

    >>> jacobian(lambda x, y, z: (x*y, 0, 2*z), (1.0, 3.0, 2.0))
    ((3.0, 1.0, 0), (0, 0, 0), (0, 0, 2))
    """
    columns = tangents(_checked(force), tuple(map(real_scalar, place)))
    return tuple(tuple(map(to_plain, row)) for row in zip(*columns, strict=True))


@checked
def curl(force: Field, place: Sequence[Scalar]) -> Triple:
    """The curl of a force field: (dF_z/dy - dF_y/dz, dF_x/dz - dF_z/dx, dF_y/dx - dF_x/dy).

    >>> curl(lambda x, y, z: (-y, x, 0), (1.0, 2.0, 3.0))
    (0, 0, 2)
    """
    return _antisymmetric(jacobian(force, place))


def _antisymmetric(J):
    return tuple(to_plain(scalar(J[n][m]) - J[m][n]) for n, m in ((2, 1), (0, 2), (1, 0)))


def _checked(force):
    """The same force field; raises :class:`WorkError` where it does not exist."""

    def at(*place):
        where = tuple(to_plain(x.value if isinstance(x, Moving) else x) for x in place)
        try:
            F = tuple(real_scalar(f) for f in force(*place))
        except (*NO_VALUE, ScalarError) as problem:
            advice = "; keep base, box and loops away"
            at_a_place(problem, WorkError, f"the force has no value at {where}", advice)
            raise
        if len(F) != 3:
            raise WorkError(f"a force field returns (F_x, F_y, F_z); got {len(F)} components")
        if not all(map(is_finite, F)):
            raise WorkError(
                f"the force is {F} at {where}, not finite; keep base, box and loops away"
            )
        return F

    return at


@checked
@dataclass(frozen=True)
class Potential:
    """The potential of ``force``, zero at ``base``: a function of x, y, z, the integral along the
    straight line from the base (11.20).

    Of numbers by quadrature; of SymPy expressions by formulas, which may not terminate; of moving
    coordinates with the rate of V, -F.v (11.19).
    """

    force: Field
    base: Sequence[Scalar]
    rtol: Accuracy = 1e-10

    @guided
    def __call__(self, x: Scalar, y: Scalar, z: Scalar) -> Scalar:
        target = tuple(real_scalar(c) for c in (x, y, z))
        V = self._from_base(tuple(c.value if isinstance(c, Moving) else c for c in target))
        if not any(isinstance(c, Moving) for c in target):
            return V
        v = (Moving(c.rate, c.acceleration) if isinstance(c, Moving) else ZERO for c in target)
        rate = -_dot(self.force(*target), v)
        return Moving(V, rate.value, rate.rate) if isinstance(rate, Moving) else Moving(V, rate)

    def _from_base(self, target):
        base = tuple(map(real_scalar, self.base))
        line = tuple(x - a for a, x in zip(base, target, strict=True))
        exact = not all(map(is_numeric, (*target, *base)))
        force = _checked(self.force)

        def along(s):
            return _dot(force(*(a + s * d for a, d in zip(self.base, line, strict=True))), line)

        # zero in the kind of the coordinates: an mpf keeps its digits
        start = 0 if exact else to_plain(0 * sum(map(to_plain, target)))
        return -quadrature(along, start, start + 1, self.rtol, exact)[0]


def _dot(F, line):
    return sum((scalar(f) * d for f, d in zip(F, line, strict=True)), ZERO)


@checked
def find_potential(
    force: Field,
    base: Sequence[Scalar] = (0, 0, 0),
    box: Sequence[Sequence[Scalar]] = ((-1, 1),) * 3,
    loops: Sequence[Path] = (),
    tolerance: Tolerance = 1e-09,
) -> Potential:
    """The potential of a force field (11.16)-(11.18); :class:`NoPotential` if it has none.

    force : function of x, y, z that returns (F_x, F_y, F_z); symbols in it count as numbers
    base : where V is zero; straight lines from it must stay where the force exists
    box : the region in which the field is used, three pairs (low, high)
    loops : closed paths, functions of a parameter from 0 to 1, one around each hole of the region
    tolerance : of the curl, on a grid of 27 places of the box, relative to the derivatives of F;
        and of the work round a loop, relative to the size of F times the length. A spot
        check: a curl that is zero at these places alone passes.

    >>> V = find_potential(lambda x, y, z: (-2.0*x, -2.0*y, 0.0))
    >>> round(V(3.0, 4.0, 0.0), 9)
    25.0
    """
    # n + 0.37 of thirds: no place lies on a plane of symmetry, where a curl may vanish by chance
    grid = ([low + (high - low) * (n + 0.37) / 3 for n in range(3)] for low, high in box)
    for place in product(*grid):
        _check_curl(force, place, tolerance)
    for n, loop in enumerate(loops, 1):
        _check_loop(_checked(force), loop, n, tolerance)
    return Potential(force, tuple(base))


def _check_curl(force, place, tolerance):
    J = jacobian(force, place)
    c = _antisymmetric(J)
    if max(map(magnitude, c)) > tolerance * max(magnitude(x) for row in J for x in row):
        where, curl = (", ".join(map(short, triple)) for triple in (place, c))
        raise NoPotential(
            f"there is no potential: at ({where}) the curl of the force is ({curl}), not zero; its "
            "work depends on the path",
            place,
            c,
        )


def _check_loop(force, loop, n, tolerance):
    places = [tuple(to_plain(scalar(x)) for x in loop(k / 24)) for k in range(25)]
    first, last = places[0], places[-1]
    # 24 chords, for the scale of the length and of the force; the work itself is by quadrature
    gap = max(max_abs(scalar(a) - b) for a, b in zip(first, last, strict=True))
    if gap > 1e-9 * max(max_abs(scalar(x)) for p in places for x in p):
        raise WorkError(f"loop {n} is not closed: it leads from {first} to {last}")
    strength = max([magnitude(f) for p in places for f in force(*p)])
    steps = (zip(p, q, strict=True) for p, q in pairwise(places))
    length = sum(hypot(*(b - a for a, b in step)) for step in steps)
    U = work_along(lambda *place: tuple(map(probe, force(*place))), loop, 0.0, 1.0)
    if max_abs(scalar(U.value)) > max(tolerance * length * strength, 10 * U.error):
        raise NoPotential(
            f"there is no potential: round loop {n} the force does the work {short(U.value)}, "
            "though its curl is zero; V would grow by this with every turn",
            circulation=U.value,
        )

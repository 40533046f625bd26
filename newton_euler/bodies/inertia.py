"""The inertia matrix (chapter 7): moments and products of inertia about any point, along any axes.

**The sign convention** of the book: the *products of inertia* are the plain integrals (7.9), (7.10)

    I_xy = integral of x y dm,   I_yz = integral of y z dm,   I_zx = integral of z x dm

and carry their minus sign in the *inertia matrix* (7.13) only:

          [  I_xx  -I_xy  -I_zx ]
    [I] = [ -I_xy   I_yy  -I_yz ]   so that   {H} = [I] {omega}   (7.12)
          [ -I_zx  -I_yz   I_zz ]
"""

from collections.abc import Iterable, Iterator, Sequence
from typing import Any

from ..algebra.errors import Tolerance, checked
from ..algebra.jets import Moving
from ..algebra.late import np
from ..algebra.ledger import NamedTerms, Terms, latex_number
from ..algebra.names import guided
from ..algebra.otherwise import built
from ..algebra.scalars import (
    ZERO,
    Rows,
    Scalar,
    Scaled,
    Triple,
    clipped,
    is_numeric,
    is_positive,
    is_zero,
    max_abs,
    min_abs,
    real_scalar,
    scalar,
    short,
    sqrt,
    to_plain,
)
from ..algebra.vectors import ZERO3, FrameError, Vector, add3, dot3, scale3, sum3, three
from ..kinematics.frames import Frame, Point, PointLike, as_point, axes_at
from .admissibility import AXES, MassError, check
from .principal_axes import principal, symmetry


@guided
class Inertia(Scaled, NamedTerms):
    """The inertia matrix of a body about ``point``, along the axes of ``frame`` (7.9)-(7.13). ``A +
    B`` is that of two bodies together, about the point and in the frame of A; ``-A`` of a hole.

    point : the Point B that it is about, or a Frame: about its origin, along its axes
    moments : (I_xx, I_yy, I_zz); products : (I_xy, I_yz, I_zx), the plain integrals
    mass, centre : of the body, the centre a Point; only needed to transfer to another point
    frame : the axes; default: those of the frame in which ``point`` is given
    tolerance : of the check that some body can have this inertia, see :meth:`check`;
        :class:`MassError` otherwise; None: no check

    >>> from newton_euler import Frame
    >>> body = Frame("body")
    >>> I = Inertia(body, (2.0, 3.0, 4.0), (0.5, 0, 0))
    >>> I.matrix
    ((2.0, -0.5, 0), (-0.5, 3.0, 0), (0, 0, 4.0))
    >>> I.times(body.vector(1.0, 0, 0))  # the angular momentum H = I omega (7.12)
    Vector(2.0, -0.5, 0 in body)
    """

    centre: Point | None  # None if unknown

    __slots__ = ("_terms", "centre", "frame", "mass", "moments", "point", "products")

    def __init__(
        self,
        point: PointLike,
        moments: Sequence[Scalar],
        products: Sequence[Scalar] = (0, 0, 0),
        mass: Scalar = None,
        centre: Point | None = None,
        frame: Frame | None = None,
        tolerance: Tolerance | None = 1e-9,
    ):
        self.point = as_point(point, "an inertia matrix")
        self.frame = axes_at(self.point) if frame is None else frame
        self.moments = three(moments, "moments (I_xx, I_yy, I_zz)", MassError)
        self.products = three(products, "products (I_xy, I_yz, I_zx)", MassError)
        self.mass, self.centre = None if mass is None else real_scalar(mass), centre
        if centre is not None and not isinstance(centre, Point):
            raise MassError(f"the centre of mass is a Point; got {clipped(centre)}")
        if not isinstance(self.frame, Frame):
            raise FrameError(f"the axes are those of a Frame; got {clipped(frame)}")
        self._terms: Terms[Inertia] = Terms()
        if tolerance is not None:
            self.check(tolerance)

    def _like(self, moments, products, **changed):
        """An inertia with the same point, frame, mass and centre unless ``changed``."""
        same = {name: getattr(self, name) for name in ("point", "frame", "mass", "centre")}
        return Inertia(moments=moments, products=products, tolerance=None, **{**same, **changed})

    # -- entries

    def _rows(self):
        (xx, yy, zz), (xy, yz, zx) = self.moments, self.products
        return (xx, -xy, -zx), (-xy, yy, -yz), (-zx, -yz, zz)

    @property
    def matrix(self) -> Rows:
        """The inertia matrix (7.13): three rows of three, minus the products off the diagonal."""
        entries = tuple(to_plain(x) for row in self._rows() for x in row)
        entries = built("matrix", entries, self._at_centre)
        return entries[:3], entries[3:6], entries[6:]

    def _at_centre(self):
        """The entries about the centre of mass; () where they are known to be these, or unknown."""
        if self.mass is None or self.centre is None or self.centre is self.point:
            return ()
        return tuple(to_plain(x) for row in self.about(self.centre)._rows() for x in row)

    def __iter__(self) -> Iterator:
        return iter(self.matrix)

    def to_array(self) -> Any:
        """The matrix as a NumPy array of shape (3, 3); (3, 3, N) if its entries are arrays of N."""

        numbers = (np.asarray(x, dtype=float) for row in self.matrix for x in row)
        entries = np.broadcast_arrays(*numbers)
        return np.stack(entries).reshape(3, 3, *entries[0].shape)

    def __repr__(self):
        return f"Inertia({self.matrix} about {self.point.name} in {self.frame.name})"

    def _repr_latex_(self):
        rows = r" \\ ".join(" & ".join(latex_number(x, 5) for x in row) for row in self.matrix)
        return rf"$\begin{{bmatrix}}{rows}\end{{bmatrix}}$"

    # -- angular momentum, moments about axes

    @checked
    def times(self, omega: Vector) -> Vector:
        """The angular momentum H = I omega (7.11), (7.12), a Vector in the frame of the matrix:
        that of the whole motion about G or a point fixed in body and ground (else see
        :meth:`Body.angular_momentum`).

        H has a rate if omega has one, I alpha + omega_frame x H: the entries are taken as constant
        in the frame of the matrix, even where that precesses without spinning.
        """
        rate = (lambda: self.times(omega.rate(self.frame))) if omega.has_rate else None
        return Vector(self.times3(omega.expressed_in(self.frame).c), self.frame, rate)

    @checked
    def times3(self, c: tuple) -> Triple:
        """The matrix times a triple of components along its axes."""
        if c is ZERO3:
            return ZERO3
        c, rows = tuple(map(real_scalar, c)), self._rows()
        entries = tuple(to_plain(x) for row in rows for x in row)
        if (other := built("matrix", entries, self._at_centre)) is not entries:
            rows = other[:3], other[3:6], other[6:]
        return tuple(dot3(row, c) for row in rows)

    @checked
    def moment(self, axis: str | Vector) -> Scalar:
        """The moment n . I n about an ``axis`` through ``point``: "x", "y", "z", or a Vector.

        >>> from newton_euler import Frame
        >>> Inertia(Frame("body"), (2.0, 3.0, 4.0)).moment("z")
        4.0
        """
        if isinstance(axis, str):
            return to_plain(self.moments[axis_index(axis)[0]])
        square = scalar(axis.dot(axis))
        of_floats = type(square) is float or bool(getattr(square, "shape", ()))
        # n . I n has the size of the moment times the square
        of_any_size = of_floats and not 1e-8 < min_abs(square) <= max_abs(square) < 1e8
        if of_any_size and min_abs(axis.norm()):
            return self.moment(axis.direction())
        if is_zero(square):
            raise MassError("the axis is a zero vector; give one with a direction")
        return to_plain(scalar(axis.dot(self.times(axis))) / square)

    @checked
    def radius_of_gyration(self, axis: str | Vector) -> Scalar:
        """k = sqrt(moment/mass) about an axis through ``point`` (7.27).

        >>> from newton_euler import Frame
        >>> G = Frame("rod").origin
        >>> Inertia(G, (0, 3.0, 3.0), mass=12.0, centre=G).radius_of_gyration("y")
        0.5
        """
        self._needs("mass", "the radius of gyration")
        return to_plain(sqrt(self.moment(axis) / self.mass))

    # -- other points, other axes

    def about(self, point: PointLike) -> "Inertia":
        """The inertia matrix about another point, along the same axes: the parallel axis theorem
        (7.25), (7.26) between any two points. With d1, d2 the vectors from them to G, I_xx changes
        by m (d2y^2 - d1y^2 + d2z^2 - d1z^2) and I_xy by m (d2x d2y - d1x d1y).

        terms : ``own``, the matrix about the first point, and ``transfer``, the change

        >>> from newton_euler import Frame
        >>> body = Frame("body")
        >>> G = body.point("G", 1.0, 0, 0)
        >>> Inertia(G, (0, 3.0, 3.0), mass=12.0, centre=G).about(body.origin).moments
        (0, 15.0, 15.0)
        """
        point = as_point(point, "an inertia matrix")
        if point is self.point:
            return self
        for what in ("mass", "centre"):
            self._needs(what, f"going from {self.point.name} to {point.name}")
        step = (self.point - point).expressed_in(self.frame).c
        assert self.centre is not None
        at_G = self.centre is self.point
        to_G = ZERO3 if at_G else (self.centre - self.point).expressed_in(self.frame).c
        (factor,) = built("transfer", (1,), (self.mass, *step, *self.moments))
        moments, products = _transfer(factor * self.mass, step, to_G)
        added = self._like(moments, products, point=point, mass=ZERO)
        out = self._like(add3(self.moments, moments), add3(self.products, products), point=point)
        out._terms = Terms({"own": self, "transfer": added})
        return out

    def expressed_in(self, frame: Frame) -> "Inertia":
        """The same inertia along the axes of ``frame`` at this instant, R I R^T."""
        if frame is self.frame:
            return self
        # a moment that occurs twice, times the unit matrix, stays as it is; the rest is rotated
        xx, yy, zz = self.moments
        common = xx if _equal(xx, yy) or _equal(xx, zz) else yy if _equal(yy, zz) else ZERO
        rows = [list(row) for row in self._rows()]
        for n in range(3):
            rows[n][n] = ZERO if _equal(rows[n][n], common) else rows[n][n] - common
        half = [self.frame.transform(tuple(row), frame) for row in rows]
        turned = [self.frame.transform(column, frame) for column in zip(*half, strict=True)]
        moments = tuple(common + turned[n][n] for n in range(3))
        return self._like(moments, (-turned[1][0], -turned[2][1], -turned[2][0]), frame=frame)

    principal = checked(principal)
    symmetry = checked(symmetry)

    # -- sums

    def __add__(self, other: "Inertia") -> "Inertia":
        if not isinstance(other, Inertia):
            raise MassError(f"an inertia matrix can only be added to one, got {other!r}")
        other = other.about(self.point).expressed_in(self.frame)
        known = all(x is not None for x in (self.mass, other.mass, self.centre, other.centre))
        mass, centre = together([self, other], self.frame) if known else (None, None)
        entries = add3(self.moments, other.moments), add3(self.products, other.products)
        return self._like(*entries, mass=mass, centre=centre)

    def __radd__(self, other: Scalar) -> "Inertia":
        return self if type(other) is int and other == 0 else self + other  # where sum() begins

    def __neg__(self) -> "Inertia":
        return -1 * self

    def __sub__(self, other: "Inertia") -> "Inertia":
        return self + (-other if isinstance(other, Inertia) else other)

    def __mul__(self, s: Scalar) -> "Inertia":
        s = real_scalar(s)
        mass = None if self.mass is None else s * self.mass
        return self._like(scale3(s, self.moments), scale3(s, self.products), mass=mass)

    __rmul__ = __mul__

    @property
    def terms(self) -> "Terms[Inertia]":  # type: ignore[override]
        """The terms of a sum by name: ``own`` and ``transfer``, or the parts of a composite."""
        return self._terms

    @checked
    def reweighted(self, /, **factors: Scalar) -> "Inertia":
        """The sum of its terms times their ``factors`` (default: 1), as by a wrong model."""
        weighted = self.terms.weighted(factors)
        if not weighted:  # not a sum
            return self
        moments = sum3(scale3(factor, term.moments) for factor, term in weighted)
        return self._like(moments, sum3(scale3(factor, term.products) for factor, term in weighted))

    # -- admissibility

    @checked
    def check(self, tolerance: Tolerance = 1e-9, slack: float = 0.0) -> "Inertia":
        """The inertia itself, if some body can have it; :class:`MassError` otherwise. Mass and the
        integrals of x^2, y^2, z^2 are positive, hence the triangle inequality of the moments;
        Schwarz's inequality bounds the products; all also about G. Expressions are not checked.

        tolerance : relative to the largest moment; rounded data of a thin plate may need more
        slack : added to that, the round-off of earlier subtractions
        """
        check(self, tolerance, slack)
        return self

    def _needs(self, what, purpose):
        if getattr(self, what) is None:
            missing = {"mass": "the mass of the body", "centre": "the place of its centre of mass"}
            raise MassError(
                f"{purpose} needs {missing[what]}; make it Inertia({self.point.name}, moments, "
                "products, mass=..., centre=G)"
            )


def axis_index(name: str) -> tuple[int, int]:
    """Index and sign of an axis written as "x" or "-x"."""
    bare = name.removeprefix("-")
    if len(bare) != 1 or bare not in AXES:
        raise MassError(f"an axis is 'x', 'y', 'z' or one of them with a minus sign, got {name!r}")
    return AXES.index(bare), 1 if name == bare else -1


# the pairs of coordinates, in the order that from_second_moments takes
SECOND_MOMENTS = ((0, 0), (1, 1), (2, 2), (0, 1), (1, 2), (2, 0))


def from_second_moments(second: Sequence[Scalar]) -> tuple[tuple, tuple]:
    """Moments (7.9) and products (7.10) from the integrals of x x, y y, z z, x y, y z, z x."""
    xx, yy, zz, *products = second
    return (yy + zz, zz + xx, xx + yy), tuple(products)


def _transfer(mass, s, to_G):
    """Moments and products to add when the point moves by -s; ``to_G`` leads from it to G."""
    p = add3(s, scale3(2, to_G))
    moments = [mass * (s[n] * p[n]) for n in range(3)]
    products = (mass * (s[n] * p[m] + s[m] * p[n]) / 2 for n, m in SECOND_MOMENTS[3:])
    return from_second_moments([*moments, *products])


def _equal(a, b):
    return a is b or is_zero(a - b)


def together(parts: Iterable, frame: Frame, name: str = "G") -> tuple[Scalar, Point]:
    """Total mass and centre of parts; the centre moves in ``frame`` as they do."""
    mass, first = ZERO, ZERO3
    for part in parts:
        mass = mass + part.mass
        if part.mass is not ZERO:
            first = add3(first, scale3(part.mass, _coordinates(part.centre, frame)))
    if is_numeric(mass) and not is_positive(mass):
        raise MassError(
            f"the total mass {short(mass)} must be positive: the removed parts weigh too much"
        )
    return mass, frame.point(name, *(x / mass for x in first))


def _coordinates(point, frame):
    """The coordinates of a point in a frame, with their rates there."""
    if point.frame is frame:
        return point.x
    motion = point.position(frame), point.velocity(frame), point.acceleration(frame)
    return tuple(map(Moving, *(v.expressed_in(frame).c for v in motion)))

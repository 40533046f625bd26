"""Principal moments and axes of inertia (7.4-7.6), how well they are determined, and the symmetries
a matrix shows.

Order and sign are always the same, so that two runs and two machines agree: moments ascending; the
component of largest size of the first and of the second axis is positive (of several equally large
ones the first); the third axis makes them right-handed. Where moments are equal within round-off,
any axes in their plane will do, and the ones nearest to the axes of the frame are taken.

Expressions have no size to be ordered by, unless they are numbers times one common factor. If the
matrix is diagonal they stay where they are; if one product is left, its two axes (u, v) turn by
half of atan2(-2 I_uv, I_uu - I_vv), the larger moment along the turned u; a full matrix gives real
formulas with an arc cosine, ascending.
"""

from dataclasses import dataclass

from ..algebra.scalars import (
    ZERO,
    acos,
    atan2,
    cos,
    epsilon,
    is_numeric,
    is_zero,
    library_of,
    pi,
    plain,
    scalar,
    short,
    sin,
    size,
    sqrt,
)
from ..algebra.vectors import Vector, cross3, dot3, scale3
from ..kinematics.rotations import axis_angle
from .admissibility import AXES, PRODUCTS, MassError

PAIRS = ((0, 1), (1, 2), (2, 0))  # the axes u, v of the products xy, yz, zx
ROUND_OFF = 256  # moments nearer than so many round-offs of the largest are equal


@dataclass(frozen=True)
class Principal:
    """Principal moments, their axes (unit Vectors, right-handed), and how far they are determined.

    noise : relative error of the entries of the matrix that the report is for; default: round-off
    gaps : for each axis, the distance of its moment from the nearest other one
    turns : for each axis, the angle in rad that noise times the largest moment typically turns it
        by, atan2(noise, gap); a few times it may happen
    All three are empty for expressions; for arrays each entry has shape (N,). ``print(p)`` reports
    in words.
    """

    inertia: object
    moments: tuple
    axes: tuple
    noise: float = 0.0
    gaps: tuple = ()
    turns: tuple = ()

    @property
    def rotation(self):
        """The matrix whose columns are the principal axes: it takes principal components to
        components in the frame of the inertia.
        """
        return tuple(zip(*(axis.components() for axis in self.axes), strict=True))

    @property
    def determined(self):
        """For each axis: True if its gap is at least 4 times the noise, so that the data fix it
        within about 0.25 rad.
        """
        return tuple(size(turn) < 0.245 for turn in self.turns)

    def frame(self, name="principal"):
        """A new frame along the principal axes, fixed in the frame of the inertia. For numbers, not
        expressions.
        """
        axis, angle = axis_angle(self.rotation)
        return self.inertia.frame.rotate(name, axis, angle)

    def __str__(self):
        lines = [
            f"principal moments about {self.inertia.point.name}: "
            f"{', '.join(map(short, self.moments))}"
        ]
        lines += [f"  axis {n + 1}: {axis}" for n, axis in enumerate(self.axes)]
        return "\n".join(lines + self._doubts())

    def _doubts(self):
        open_axes = [n + 1 for n, fixed in enumerate(self.determined) if not fixed]
        if not self.turns:
            return []
        if not open_axes:
            return [
                f"  all axes are determined, to {max(size(t) for t in self.turns):.2g} rad, "
                f"for data with a relative error of {self.noise:.2g}"
            ]
        names = " and ".join(map(str, open_axes))
        rest = (
            "any axis is a principal axis"
            if len(open_axes) == 3
            else "only their plane is: any two axes in it will do"
        )
        return [
            f"  axes {names} are not determined by data with a relative error of "
            f"{self.noise:.2g}: their moments are equal within it; {rest}"
        ]


def principal(inertia, noise=None):
    """Principal moments and axes of an :class:`Inertia` (7.18)-(7.20).

    noise : relative error of its entries, as 5e-4 for three digits; sets the report, not the axes
    Returns a :class:`Principal`. Floats and arrays go through numpy.linalg.eigh, mpf through
    mpmath; exact numbers keep exact roots where the characteristic polynomial has them; expressions
    get explicit formulas. Errors of the moments: a few round-offs of the largest moment; of the
    axes: those divided by the relative gap.

    >>> from newton_euler import Frame
    >>> from newton_euler import Inertia
    >>> p = Inertia(Frame("body").origin, (8.0, 11.0, 11.0), (3.0, 0.0, -3.0)).principal()
    >>> [round(float(x), 12) for x in p.moments]
    [5.0, 11.0, 14.0]
    >>> print(p.axes[1])
    [0, 0.707107, 0.707107] in body
    """
    rows = inertia.matrix
    if not all(is_numeric(x) for row in rows for x in row):
        moments, axes = _of_expressions([list(map(scalar, row)) for row in rows])
        return Principal(
            inertia, tuple(map(plain, moments)), tuple(Vector(a, inertia.frame) for a in axes)
        )
    if any(getattr(x, "shape", ()) for row in rows for x in row):
        return _of_arrays(inertia, noise)
    return _with_report(inertia, noise, *_of_numbers(rows))


def _of_numbers(rows):
    library = library_of([x for row in rows for x in row]).__name__
    if library in ("sympy", "symengine"):
        moments, axes = _by_sympy(rows) or _of_full_matrix(rows)
        return moments, _canonical(moments, axes)
    if library == "mpmath":
        return _by_mpmath(rows)
    return _by_numpy([rows])[0]


def _with_report(inertia, noise, moments, axes):
    moments = tuple(moments)
    noise = noise if noise is not None else ROUND_OFF * float(epsilon(moments[0]))
    largest = max(abs(m) for m in moments)
    gaps = tuple(
        min(abs(m - other) for k, other in enumerate(moments) if k != n)
        for n, m in enumerate(moments)
    )
    turns = tuple(atan2(float(noise * largest), float(gap)) if largest else 0.0 for gap in gaps)
    return Principal(
        inertia, moments, tuple(Vector(a, inertia.frame) for a in axes), noise, gaps, turns
    )


# -- numbers


def _of_arrays(inertia, noise):
    import numpy as np

    found = [
        _with_report(inertia, noise, *p) for p in _by_numpy(np.moveaxis(inertia.to_array(), -1, 0))
    ]

    def stacked(what):
        return tuple(np.array([getattr(p, what)[n] for p in found]) for n in range(3))

    axes = tuple(
        Vector(tuple(np.array([p.axes[n].c[k] for p in found]) for k in range(3)), inertia.frame)
        for n in range(3)
    )
    return Principal(
        inertia, stacked("moments"), axes, found[0].noise, stacked("gaps"), stacked("turns")
    )


def _by_numpy(matrices):
    """Moments and axes of each of the matrices."""
    import numpy as np

    values, columns = np.linalg.eigh(np.asarray(matrices, dtype=float))
    return [
        (v, _canonical(v, c))
        for v, c in zip(values.tolist(), columns.swapaxes(-1, -2).tolist(), strict=True)
    ]


def _by_mpmath(matrix):
    import mpmath

    values, columns = mpmath.mp.eigsy(
        mpmath.matrix([[mpmath.mpf(x) for x in row] for row in matrix])
    )
    values = [values[n] for n in range(3)]
    return values, _canonical(values, [[columns[k, n] for k in range(3)] for n in range(3)])


def _canonical(values, axes):
    """The axes of ascending values, with the signs and the choices told at the top; of the values,
    equal ones are told by round-off.
    """
    small = ROUND_OFF * epsilon(values[0]) * max(abs(v) for v in values)
    low, high = values[1] - values[0] <= small, values[2] - values[1] <= small
    if low and high:
        return (1, ZERO, ZERO), (ZERO, 1, ZERO), (ZERO, ZERO, 1)
    if low or high:
        n = _signed(axes[2 if low else 0])
        e = _nearest_in_plane(n)
        return (e, cross3(n, e), n) if low else (n, e, cross3(n, e))
    first, second = _signed(axes[0]), _signed(axes[1])
    return first, second, cross3(first, second)


def _signed(axis):
    values = [float(x) for x in axis]
    bound = max(map(abs, values)) * (1 - 1e-6)
    leading = next(x for x in values if abs(x) >= bound)
    return tuple(axis) if leading > 0 else tuple(-x for x in axis)


def _nearest_in_plane(n):
    """The unit vector normal to ``n`` that is nearest to an axis of the frame."""
    m = min(range(3), key=lambda k: (round(float(abs(n[k])), 6), k))
    e = [int(k == m) - n[m] * n[k] for k in range(3)]
    length = sqrt(dot3(e, e))
    return tuple(x / length for x in e)


def _by_sympy(rows):
    """Exact moments and axes; None where the characteristic polynomial (7.20) has other roots than
    fractions and square roots of them.
    """
    import sympy

    M = sympy.Matrix([[sympy.nsimplify(x, rational=True) for x in row] for row in rows])
    if len(sympy.roots(M.charpoly(), cubics=False, multiple=True)) < 3:
        return None
    pairs = sorted(
        ((m, list(axis.normalized())) for m, _, space in M.eigenvects() for axis in space),
        key=lambda pair: float(pair[0]),
    )
    return zip(*pairs, strict=True)


# -- expressions


def _of_expressions(rows):
    coupled = [(u, v) for u, v in PAIRS if not is_zero(rows[u][v])]
    if not coupled:
        return tuple(rows[n][n] for n in range(3)), (
            (1, ZERO, ZERO),
            (ZERO, 1, ZERO),
            (ZERO, ZERO, 1),
        )
    unit = next(rows[n][n] for n in range(3) if not is_zero(rows[n][n]))
    ratios = [[plain(x / unit) for x in row] for row in rows]
    # numbers times one expression, as m L^2, which is positive as a moment
    if all(is_numeric(x) for row in ratios for x in row):
        moments, axes = _of_numbers(ratios)
        return scale3(unit, moments), axes
    return _block(rows, *coupled[0]) if len(coupled) == 1 else _of_full_matrix(rows)


def _block(rows, u, v):
    """One product I_uv is left: the larger moment along u turned by half of atan2(-2 I_uv, I_uu -
    I_vv).
    """
    mean, half, entry = (rows[u][u] + rows[v][v]) / 2, (rows[u][u] - rows[v][v]) / 2, rows[u][v]
    radius, angle = sqrt(half * half + entry * entry), atan2(entry, half) / 2
    out, axes = (
        [rows[n][n] for n in range(3)],
        [tuple(1 if n == m else ZERO for n in range(3)) for m in range(3)],
    )
    out[u], out[v] = mean + radius, mean - radius
    c, s = cos(angle), sin(angle)
    axes[u] = tuple({u: c, v: s}.get(n, ZERO) for n in range(3))
    axes[v] = tuple({u: -s, v: c}.get(n, ZERO) for n in range(3))
    return out, axes


def _of_full_matrix(rows):
    """The real roots of the characteristic equation (7.20), ascending, I = q + 2 p cos(phi), and
    axes normal to two rows of [I] - I[1] (7.18).

    For moments that all differ, in a matrix whose first two rows stay independent when a moment is
    subtracted.
    """
    q = (rows[0][0] + rows[1][1] + rows[2][2]) / 3
    d = _less(rows, q)
    p = sqrt((dot3(d[0], d[0]) + dot3(d[1], d[1]) + dot3(d[2], d[2])) / 6)
    phi = acos(dot3(d[0], cross3(d[1], d[2])) / (2 * p**3)) / 3
    third = 2 * pi(q) / 3
    # phi in [0, pi/3]: k = 1 the least, 0 the largest
    moments = tuple(q + 2 * p * cos(phi + k * third) for k in (1, 2, 0))
    first, second = (cross3(*_less(rows, moment)[:2]) for moment in moments[:2])
    first, second = (scale3(1 / sqrt(dot3(axis, axis)), axis) for axis in (first, second))
    return moments, (first, second, cross3(first, second))


def _less(rows, x):
    """The matrix less x on its diagonal."""
    return [[y - x if n == m else y for m, y in enumerate(row)] for n, row in enumerate(rows)]


# -- symmetry


@dataclass(frozen=True)
class Symmetry:
    """What an inertia matrix shows of the symmetry of its body: necessary for it, not sufficient (a
    cube's matrix is that of a sphere).

    axes : the axes of the frame, as "z", that are principal at the point; a plane or axis of
        symmetry of the body makes its axis such
    planes : the planes of the frame, as "xy", that may be planes of symmetry through the point:
        both products with their normal vanish
    kind : "sphere" (three equal moments), "top" (two: the body moves as one with rotational
        symmetry (7.21)), or "none"
    axis : of a top, the unit Vector of the distinct axis; else None
    """

    axes: tuple
    planes: tuple
    kind: str
    axis: object = None

    def __str__(self):
        kinds = {
            "sphere": "a sphere: every axis is principal",
            "top": f"a body of revolution about {self.axis}",
            "none": "one without symmetry",
        }
        axes, planes = (", ".join(names) or "none" for names in (self.axes, self.planes))
        return (
            f"moves like {kinds[self.kind]}; axes of the frame that are principal: {axes}; "
            f"possible planes of symmetry: {planes}"
        )


def symmetry(inertia, tolerance=1e-9):
    """The :class:`Symmetry` that a matrix shows; products and differences below ``tolerance`` times
    the largest moment count as zero.

    Of expressions, only what is zero or equal by their form is seen.

    >>> from newton_euler import Frame
    >>> from newton_euler import Inertia
    >>> s = Inertia(Frame("body").origin, (2.0, 2.0, 3.0)).symmetry()
    >>> s.kind, s.axes, s.planes
    ('top', ('x', 'y', 'z'), ('yz', 'zx', 'xy'))
    """
    numeric = [x for x in (*inertia.moments, *inertia.products) if is_numeric(x)]
    small = tolerance * max((size(x) for x in numeric), default=0.0)

    def vanishes(x):
        return is_zero(x) or (is_numeric(x) and size(x) <= small)

    zero = {name: vanishes(x) for name, x in zip(PRODUCTS, inertia.products, strict=True)}
    free = [n for n in range(3) if all(zero[name] for name in PRODUCTS if AXES[n] in name)]
    kind, axis = _equal_moments(inertia, vanishes)
    return Symmetry(
        tuple(AXES[n] for n in free),
        tuple(AXES[(n + 1) % 3] + AXES[(n + 2) % 3] for n in free),
        kind,
        axis,
    )


def _equal_moments(inertia, vanishes):
    p = principal(inertia)
    if any(getattr(m, "shape", ()) for m in p.moments):
        raise MassError(
            "the symmetry of a whole array of matrices is not one symmetry; ask for each instant"
        )
    same = [p.moments[n] is p.moments[m] or vanishes(p.moments[n] - p.moments[m]) for n, m in PAIRS]
    if sum(same) >= 2:
        return "sphere", None
    return ("top", p.axes[(same.index(True) + 2) % 3]) if any(same) else ("none", None)

"""Principal moments and axes of inertia (7.4-7.6), their accuracy, and the symmetries of a matrix.

Order and sign are always the same: moments ascending; the largest component of the first and of the
second axis (of several equally large ones the first) is positive; the third axis makes them
right-handed. Where moments are equal within round-off, the axes are nearest to those of the frame.

Expressions have no order, unless they are numbers times one common factor. If the matrix is
diagonal the axes are those of the frame; if it has one product, its two axes (u, v) turn by half of
atan2(-2 I_uv, I_uu - I_vv), the larger moment along the turned u; a full matrix gives real formulas
with an arc cosine, ascending. Compiled, it is turned by Jacobi's rotations: moments may be equal.
"""

from dataclasses import dataclass
from typing import Any

from ..algebra.errors import Tolerance, checked
from ..algebra.late import is_here, np, sympy
from ..algebra.scalars import (
    ZERO,
    Rows,
    acos,
    atan2,
    cos,
    epsilon,
    is_numeric,
    is_zero,
    library_of,
    max_abs,
    pi,
    scalar,
    short,
    sin,
    sqrt,
    to_plain,
    where,
)
from ..algebra.vectors import Vector, cross3, dot3, scale3
from ..kinematics.frames import Frame
from ..kinematics.rotations import axis_angle
from .admissibility import AXES, PRODUCTS, MassError

PAIRS = ((0, 1), (1, 2), (2, 0))  # the axes u, v of the products xy, yz, zx
ROUND_OFF = 256  # round-offs of the largest moment within which moments count as equal
SWEEPS = 8  # sweeps over all pairs of axes: the products fall quadratically
UNIT_AXES = ((1, ZERO, ZERO), (ZERO, 1, ZERO), (ZERO, ZERO, 1))


@dataclass(frozen=True)
class Principal:
    """Principal moments, their axes (unit Vectors, right-handed), and how well they are determined.

    noise : relative error of the entries of the matrix; default: round-off
    gaps : for each axis, the distance of its moment from the nearest other one
    turns : for each axis, the angle in rad by which an error of noise times the largest moment
        typically turns it, atan2(noise, gap); it can be a few times that
    All three are empty for expressions; for arrays each entry has shape (N,).
    """

    inertia: Any
    moments: tuple
    axes: tuple
    noise: float = 0.0
    gaps: tuple = ()
    turns: tuple = ()

    @property
    def rotation(self) -> Rows:
        """The matrix whose columns are the principal axes, in the frame of the inertia."""
        return tuple(zip(*(axis.components() for axis in self.axes), strict=True))

    @property
    def determined(self) -> tuple[bool, ...]:
        """By axis, True if its gap is 4 times the noise: it is known within about 0.25 rad."""
        return tuple(max_abs(turn) < 0.245 for turn in self.turns)  # atan(1/4) = 0.24498

    @checked
    def frame(self, name: str = "principal") -> Frame:
        """A new frame along the principal axes, fixed in that of the inertia; numbers only."""
        axis, angle = axis_angle(self.rotation)
        return self.inertia.frame.rotate(name, axis, angle)

    def __str__(self):
        moments = ", ".join(map(short, self.moments))
        lines = [f"principal moments about {self.inertia.point.name}: {moments}"]
        lines += [f"  axis {n}: {axis}" for n, axis in enumerate(self.axes, 1)]
        if self.turns:
            lines.append(f"  {self._report()}")
        return "\n".join(lines)

    def _report(self):
        data = f"data with a relative error of {self.noise:.2g}"
        names = [str(n) for n, fixed in enumerate(self.determined, 1) if not fixed]
        if not names:
            worst = max(map(max_abs, self.turns))
            return f"all axes are determined, to {worst:.2g} rad, for {data}"
        of_plane = "only their plane is: any two axes in it are principal"
        rest = "any axis is a principal axis" if len(names) == 3 else of_plane
        return (
            f"axes {' and '.join(names)} are not determined by {data}: their moments are equal "
            f"within it; {rest}"
        )


def principal(inertia: Any, noise: float | None = None) -> Principal:
    """Principal moments and axes of an :class:`Inertia` (7.18)-(7.20), exact for exact numbers
    where the characteristic polynomial has exact roots; for expressions formulas. Errors of the
    moments: a few round-offs of the largest; of the axes: those divided by the relative gap.

    noise : relative error of its entries, as 5e-4 for three digits; for the report only

    >>> from newton_euler import Frame, Inertia
    >>> p = Inertia(Frame("body").origin, (8.0, 11.0, 11.0), (3.0, 0.0, -3.0)).principal()
    >>> [round(float(x), 12) for x in p.moments]
    [5.0, 11.0, 14.0]
    >>> print(p.axes[1])
    [0, 0.707107, 0.707107] in body
    """
    rows = inertia.matrix
    entries = [x for row in rows for x in row]
    if not all(map(is_numeric, entries)):
        moments, axes = _of_expressions([list(map(scalar, row)) for row in rows])
        return Principal(inertia, tuple(map(to_plain, moments)), _vectors(axes, inertia))
    if any(getattr(x, "shape", ()) for x in entries):
        return _of_arrays(inertia, noise)
    return _with_report(inertia, noise, *_of_numbers(rows))


def _vectors(axes, inertia):
    return tuple(Vector(tuple(axis), inertia.frame) for axis in axes)


def _of_numbers(rows):
    library = library_of([x for row in rows for x in row]).__name__
    if library in ("sympy", "symengine"):
        moments, axes = _by_sympy(rows) or _of_full_matrix(rows)
        return moments, _canonical(moments, axes)
    if library != "mpmath" and is_here("numpy"):
        return _by_numpy([rows])[0]
    moments, axes = zip(*sorted(zip(*_rotated(rows), strict=True)), strict=True)
    return list(moments), _canonical(moments, axes)


def _with_report(inertia, noise, moments, axes):
    """The :class:`Principal` of ascending moments, numbers or arrays."""
    first, second, third = moments = tuple(moments)
    noise = ROUND_OFF * float(epsilon(first)) if noise is None else noise
    largest = where(-first > third, -first, third)  # round-off can make the first negative
    low, high = second - first, third - second
    gaps = low, where(low < high, low, high), high
    numbers = noise * largest, *gaps
    most, *floats = (x.astype(float) if getattr(x, "shape", ()) else float(x) for x in numbers)
    turns = tuple(atan2(most, gap) for gap in floats)
    return Principal(inertia, moments, _vectors(axes, inertia), noise, gaps, turns)


def _of_arrays(inertia, noise):
    values, axes = zip(*_by_numpy(np.moveaxis(inertia.to_array(), -1, 0)), strict=True)
    axes = np.moveaxis(np.array(axes, dtype=float), 0, -1)
    return _with_report(inertia, noise, np.array(values).T, axes)


def _by_numpy(matrices):
    """Moments and axes of each of the matrices."""
    values, columns = np.linalg.eigh(np.asarray(matrices, dtype=float))
    pairs = zip(values.tolist(), columns.swapaxes(-1, -2).tolist(), strict=True)
    return [(v, _canonical(v, c)) for v, c in pairs]


def _rotated(rows):
    """Moments and axes by Jacobi's rotations, each of which makes a product of two axes vanish; a
    formula of real numbers even where moments are equal.
    """
    zero = 0 * sum(x for row in rows for x in row)
    axes = [tuple(int(n == m) + zero for m in range(3)) for n in range(3)]

    def entry(u, v):
        return dot3(axes[u], [dot3(row, axes[v]) for row in rows])

    for u, v in PAIRS * SWEEPS:
        product, gap = entry(u, v), entry(u, u) - entry(v, v)
        angle = atan2(where(gap < 0, -2, 2) * product, abs(gap)) / 2
        c, s = cos(angle), sin(angle)
        pairs = [*zip(axes[u], axes[v], strict=True)]
        axes[u] = tuple(c * x + s * y for x, y in pairs)
        axes[v] = tuple(c * y - s * x for x, y in pairs)
    return [entry(n, n) for n in range(3)], axes


def _canonical(values, axes):
    """The axes of ascending values, with signs and choices as at the top of this module."""
    small = ROUND_OFF * epsilon(values[0]) * max(abs(v) for v in values)
    low, high = values[1] - values[0] <= small, values[2] - values[1] <= small
    if low and high:
        return UNIT_AXES
    if low or high:
        n = _signed(axes[2 if low else 0])
        # the unit vector normal to n that is nearest to an axis of the frame; rounded, so that of
        # axes equally near but for round-off the first is taken
        m = min(range(3), key=lambda k: (round(float(abs(n[k])), 6), k))
        e = _unit([int(k == m) - n[m] * n[k] for k in range(3)])
        return (e, cross3(n, e), n) if low else (n, e, cross3(n, e))
    first, second = _signed(axes[0]), _signed(axes[1])
    return first, second, cross3(first, second)


def _signed(axis):
    values = [float(x) for x in axis]
    # components equal but for round-off count as equally large, so that noise decides no sign
    bound = max(map(abs, values)) * (1 - 1e-6)
    leading = next(x for x in values if abs(x) >= bound)
    return tuple(axis) if leading > 0 else tuple(-x for x in axis)


def _unit(v):
    length = sqrt(dot3(v, v))
    return tuple(x / length for x in v)


def _by_sympy(rows):
    """Exact moments and axes; None unless the roots of (7.20) are fractions or their roots."""
    M = sympy.Matrix([[sympy.nsimplify(x, rational=True) for x in row] for row in rows])
    if len(sympy.roots(M.charpoly(), cubics=False, multiple=True)) < 3:
        return None
    pairs = ((m, list(axis.normalized())) for m, _, space in M.eigenvects() for axis in space)
    return zip(*sorted(pairs, key=lambda pair: float(pair[0])), strict=True)


def _of_expressions(rows):
    coupled = [(u, v) for u, v in PAIRS if not is_zero(rows[u][v])]
    diagonal = [rows[n][n] for n in range(3)]
    if not coupled:
        return diagonal, UNIT_AXES
    unit = next(x for x in diagonal if not is_zero(x))
    ratios = [[to_plain(x / unit) for x in row] for row in rows]
    # numbers times one expression, as m L^2, which is positive as a moment
    if all(is_numeric(x) for row in ratios for x in row):
        moments, axes = _of_numbers(ratios)
        return scale3(unit, moments), axes
    if len(coupled) == 1:
        return _block(rows, *coupled[0])
    if library_of([x for row in rows for x in row]).__name__ in ("sympy", "symengine"):
        return _of_full_matrix(rows)
    return _ascending(*_rotated(rows))


def _ascending(moments, axes):
    """A formula of moments in order, of which traced ones have none; the axes right-handed."""
    pairs = [(moment, *axis) for moment, axis in zip(moments, axes, strict=True)]
    for n, m in ((0, 1), (1, 2), (0, 1)):
        low, high = pairs[n], pairs[m]
        right = low[0] <= high[0]
        pairs[n] = tuple(where(right, a, b) for a, b in zip(low, high, strict=True))
        pairs[m] = tuple(where(right, b, a) for a, b in zip(low, high, strict=True))
    first, second = pairs[0][1:], pairs[1][1:]
    return [moment for moment, *_ in pairs], (first, second, cross3(first, second))


def _block(rows, u, v):
    """One product I_uv is left: the larger moment at atan2(-2 I_uv, I_uu - I_vv)/2 from u."""
    mean, half, entry = (rows[u][u] + rows[v][v]) / 2, (rows[u][u] - rows[v][v]) / 2, rows[u][v]
    radius, angle = sqrt(half * half + entry * entry), atan2(entry, half) / 2
    out, axes = [rows[n][n] for n in range(3)], list(UNIT_AXES)
    out[u], out[v] = mean + radius, mean - radius
    c, s = cos(angle), sin(angle)
    axes[u] = tuple({u: c, v: s}.get(n, ZERO) for n in range(3))
    axes[v] = tuple({u: -s, v: c}.get(n, ZERO) for n in range(3))
    return out, axes


def _of_full_matrix(rows):
    """The roots I = q + 2 p cos(phi) of (7.20), ascending, and axes normal to two rows of [I] -
    I[1] (7.18), for moments that all differ and rows that stay independent.
    """
    q = (rows[0][0] + rows[1][1] + rows[2][2]) / 3
    d = _less(rows, q)
    p = sqrt((dot3(d[0], d[0]) + dot3(d[1], d[1]) + dot3(d[2], d[2])) / 6)
    phi = acos(dot3(d[0], cross3(d[1], d[2])) / (2 * p**3)) / 3
    third = 2 * pi(q) / 3
    # phi in [0, pi/3]: k = 1 the least, 0 the largest
    moments = tuple(q + 2 * p * cos(phi + k * third) for k in (1, 2, 0))
    first, second = (_unit(cross3(*_less(rows, moment)[:2])) for moment in moments[:2])
    return moments, (first, second, cross3(first, second))


def _less(rows, x):
    """The matrix less x on its diagonal."""
    return [[y - x if n == m else y for m, y in enumerate(row)] for n, row in enumerate(rows)]


@dataclass(frozen=True)
class Symmetry:
    """The symmetries that an inertia matrix shows; those of the body may be fewer (as of a cube).

    axes : the axes of the frame, as "z", that are principal at the point
    planes : the planes of the frame, as "xy", that may be planes of symmetry through the point:
        both products with their normal vanish
    kind : "sphere" (three equal moments), "top" (two: as a body of revolution (7.21)), or "none"
    axis : of a top, the unit Vector of the distinct axis; else None
    """

    axes: tuple[str, ...]
    planes: tuple[str, ...]
    kind: str
    axis: Vector | None = None

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


def symmetry(inertia: Any, tolerance: Tolerance = 1e-9) -> Symmetry:
    """The :class:`Symmetry` of an inertia matrix. Products and differences below ``tolerance``
    times the largest moment count as zero; expressions only where their form shows it.

    >>> from newton_euler import Frame, Inertia
    >>> s = Inertia(Frame("body").origin, (2.0, 2.0, 3.0)).symmetry()
    >>> s.kind, s.axes, s.planes
    ('top', ('x', 'y', 'z'), ('yz', 'zx', 'xy'))
    """
    numeric = filter(is_numeric, (*inertia.moments, *inertia.products))
    small = tolerance * max(map(max_abs, numeric), default=0.0)

    def vanishes(x):
        return is_zero(x) or (is_numeric(x) and max_abs(x) <= small)

    left = "".join(n for n, x in zip(PRODUCTS, inertia.products, strict=True) if not vanishes(x))
    axes = tuple(axis for axis in AXES if axis not in left)
    planes = {"x": "yz", "y": "zx", "z": "xy"}
    kind, axis = _equal_moments(inertia, vanishes)
    return Symmetry(axes, tuple(planes[n] for n in axes), kind, axis)


def _equal_moments(inertia, vanishes):
    p = principal(inertia)
    if getattr(p.moments[0], "shape", ()):
        raise MassError("an array of matrices has a symmetry at each instant: ask for one")
    same = [p.moments[n] is p.moments[m] or vanishes(p.moments[n] - p.moments[m]) for n, m in PAIRS]
    if sum(same) >= 2:
        return "sphere", None
    return ("top", p.axes[(same.index(True) + 2) % 3]) if any(same) else ("none", None)

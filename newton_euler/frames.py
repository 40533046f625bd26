"""Frames and points in relative motion (chapters 2 and 4).

A frame is placed in its parent by a turn about one axis and by its origin. From these steps everything follows: orientation,
angular velocity and acceleration (4.20), (4.25), velocity (4.17), (4.28) and acceleration (4.18), (4.29) of any point seen from any frame.
Rates are passed up the chain in the frame at hand and never differentiated out, which is what keeps it fast and its formulas short.
"""

from .scalars import ZERO, Moving, ScalarError, cos, is_finite, is_numeric, is_zero, moving, plain, scalar, sin, size, sqrt
from .vectors import ZERO3, FrameError, Ledger, Vector, add3, cross3, dot3, scale3, sub3

_AXES = {"x": 0, "y": 1, "z": 2}


class Frame:
    """A frame of reference. ``Frame("ground")`` starts a tree; :meth:`rotate` and :meth:`translate` grow it.

    >>> ground = Frame("ground")
    >>> shaft = ground.rotate("shaft", "z", rate=0.6)
    >>> rod = shaft.rotate("rod", "x", angle=1.0, rate=0.5, origin=shaft.point("C", 0, 2.0, 0))
    >>> rod.angular_acceleration(ground).components(shaft)
    (0.0, 0.3, 0.0)
    """

    def __init__(self, name, parent=None, axis=None, angle=None, origin=None):
        self.name, self.parent, self.axis = name, parent, axis
        self.angle = angle if angle is not None else Moving(ZERO)
        self._origin = origin
        self._chain = (self, *parent._chain) if parent else (self,)
        self._memo = {}
        if axis is not None:
            self._c, self._s = cos(self.angle.value), sin(self.angle.value)
            self._unit = tuple(1 if n == axis else ZERO for n in range(3)) if isinstance(axis, int) else axis

    def __repr__(self):
        return f"Frame({' < '.join(f.name for f in self._chain)})"

    # -- making frames, points and vectors

    def rotate(self, name, axis, angle=0, rate=None, acceleration=None, origin=None):
        """A new frame turned from this one about ``axis``, right-handed.

        axis : "x", "y", "z" or "-x", "-y", "-z", or three components of any length along this frame's axes, constant
        angle, rate, acceleration : rad, rad/s, rad/s^2; ``angle`` may be moving (see :func:`moving`, :func:`at`), or a SymPy expression in
            the symbol ``t``, and then has its rates already
        origin : the Point of this frame (or of one above it) where the new frame's origin is; default: this frame's own origin
        """
        angle = moving(angle, rate, acceleration)
        if isinstance(axis, str) and axis.lstrip("-") in _AXES and axis.count("-") <= 1:
            return Frame(name, self, _AXES[axis[-1]], -angle if axis[0] == "-" else angle, self._place(origin))
        return Frame(name, self, self._unit_axis(axis), angle, self._place(origin))

    def translate(self, name, origin):
        """A new frame with axes that stay parallel to this one's and its origin at the Point ``origin``."""
        return Frame(name, self, origin=self._place(origin))

    def point(self, name, x, y, z):
        """The point with coordinates (x, y, z) from this frame's origin; fixed in the frame unless they are :func:`moving`."""
        return Point(name, self, tuple(moving(v) for v in _checked((x, y, z), f"the coordinates of {name}")))

    def vector(self, x, y, z):
        """The vector with these components along this frame's axes; fixed in the frame unless they are :func:`moving`."""
        c = tuple(moving(v) for v in _checked((x, y, z), "the components"))
        return _moving_vector(c, self)

    i = property(lambda self: self.vector(1, 0, 0), doc="unit vector of the first axis")
    j = property(lambda self: self.vector(0, 1, 0), doc="unit vector of the second axis")
    k = property(lambda self: self.vector(0, 0, 1), doc="unit vector of the third axis")

    @property
    def origin(self):
        """The origin as a Point: of the parent, in which it may move, or of this frame itself if it has no parent."""
        if self._origin is not None:
            return self._origin
        return Point(f"origin of {self.name}", self.parent or self, (Moving(ZERO),) * 3)

    def _unit_axis(self, axis):
        if isinstance(axis, Vector):
            if axis.frame is not self:
                axis = axis.expressed_in(self)
            axis = axis.c
        try:
            axis = tuple(scalar(v) for v in axis)
        except (TypeError, ScalarError):
            axis = ()
        if len(axis) != 3 or any(isinstance(v, Moving) for v in axis):
            raise FrameError(
                "an axis is 'x', 'y', 'z', '-x', '-y', '-z', a Vector, or three constant components, as in (0, 0.6, 0.8); "
                "turn about a moving axis by one more frame in between"
            )
        length = sqrt(dot3(axis, axis))
        if is_zero(length) or not is_finite(length):
            raise FrameError(f"the axis {tuple(map(plain, axis))} has no direction: its length is {plain(length)}; give a vector that is not zero")
        return tuple(v / length for v in axis)

    def _place(self, origin):
        if origin is None:
            return None
        if not isinstance(origin, Point):
            raise FrameError(f"an origin is a Point, as in {self.name}.point('C', 0, 1, 0); got {origin!r}")
        if origin.frame is not self:
            raise FrameError(
                f"the origin {origin.name} is a point of {origin.frame.name}; give it as a point of {self.name}, the frame that is turned from"
            )
        return origin

    # -- orientation

    def common(self, other):
        """The nearest frame from which both this one and ``other`` descend; :class:`FrameError` if there is none."""
        for f in self._chain:
            if f in other._chain:
                return f
        raise FrameError(
            f"{self.name} and {other.name} share no frame: {self!r}, {other!r}. Build both from one ground, as in ground.rotate(...)"
        )

    def transform(self, c, frame):
        """Components ``c`` along this frame's axes, turned into components along the axes of ``frame``."""
        top = self.common(frame)
        for f in self._chain[: self._chain.index(top)]:
            c = f._turn(c, 1)
        for f in reversed(frame._chain[: frame._chain.index(top)]):
            c = f._turn(c, -1)
        return c

    def _turn(self, c, sense):
        """Between this frame and its parent: sense 1 from here up to the parent, -1 down."""
        if self.axis is None or self.angle.value is ZERO:
            return c
        cosine, sine = self._c, self._s if sense > 0 else -self._s
        if isinstance(self.axis, int):
            n, m = (self.axis + 1) % 3, (self.axis + 2) % 3
            out = list(c)
            out[n], out[m] = cosine * c[n] - sine * c[m], sine * c[n] + cosine * c[m]
            return tuple(out)
        e = self.axis
        along = scale3((1 - cosine) * dot3(e, c), e)
        return add3(add3(scale3(cosine, c), scale3(sine, cross3(e, c))), along)

    def rotation(self, observer):
        """The matrix R that takes components here to components in ``observer``: three rows; its columns are this frame's axes there.

        The book's A (4.1) of direction cosines is its transpose.
        """
        columns = [self.transform(tuple(1 if n == m else ZERO for n in range(3)), observer) for m in range(3)]
        return tuple(tuple(plain(columns[m][n]) for m in range(3)) for n in range(3))

    # -- angular velocity and acceleration

    def angular_velocity(self, observer):
        """omega of this frame seen from ``observer``, rad/s, in components of this frame (4.20), (4.22).

        terms: one for each frame in between, named after it: its turning in its parent.
        """
        ledger = Ledger("angular velocity", f"of {self.name} in {observer.name}", lambda: self._omega_terms(observer))
        return Vector(self._omega(observer), self, lambda: self.angular_acceleration(observer), ledger)

    def angular_acceleration(self, observer):
        """alpha of this frame seen from ``observer``, rad/s^2, in components of this frame (4.25), (4.26) for any number of frames.

        terms: one for each frame in between, and ``"arm x rod"`` for each cross product omega_arm x omega_rod of two of them.
        """
        ledger = Ledger("angular acceleration", f"of {self.name} in {observer.name}", lambda: self._alpha_terms(observer))
        return Vector(self._alpha(observer), self, None, ledger)

    def _omega(self, observer):
        return self._remembered("omega", observer, self._new_omega)

    def _alpha(self, observer):
        return self._remembered("alpha", observer, self._new_alpha)

    def _remembered(self, what, observer, compute):
        found = self._memo.get((what, observer))
        if found is None:
            found = self._memo[what, observer] = compute(observer)
        return found

    def _spin(self):
        return scale3(self.angle.rate, self._unit) if self.axis is not None else ZERO3

    def _new_omega(self, observer):
        if observer is self:
            return ZERO3
        if observer in self._chain:
            return add3(self._turn(self.parent._omega(observer), -1), self._spin())
        top = self.common(observer)
        return sub3(self._omega(top), observer.transform(observer._omega(top), self))

    def _new_alpha(self, observer):
        if observer is self:
            return ZERO3
        if observer in self._chain:
            before, spin = self._turn(self.parent._omega(observer), -1), self._spin()
            own = scale3(self.angle.acceleration, self._unit) if self.axis is not None else ZERO3
            return add3(add3(self._turn(self.parent._alpha(observer), -1), own), cross3(before, spin))
        top = self.common(observer)
        carried = observer.transform(observer._omega(top), self)
        without = sub3(self._alpha(top), observer.transform(observer._alpha(top), self))
        return sub3(without, cross3(carried, self._omega(observer)))

    def _steps(self, observer):
        """The turns that lead from ``observer`` to here: (name, frame, sense)."""
        top = self.common(observer)
        down = [(f, -1) for f in observer._chain[: observer._chain.index(top)]]
        up = [(f, 1) for f in reversed(self._chain[: self._chain.index(top)])]
        return [(f, s) for f, s in down + up if f.axis is not None]

    def _omega_terms(self, observer):
        return {f.name: s * Vector(f._spin(), f).expressed_in(self) for f, s in self._steps(observer)}

    def _alpha_terms(self, observer):
        spins = self._omega_terms(observer)
        terms = {f.name: s * Vector(scale3(f.angle.acceleration, f._unit), f).expressed_in(self) for f, s in self._steps(observer)}
        names = list(spins)
        for n, first in enumerate(names):
            for second in names[n + 1 :]:
                terms[f"{first} x {second}"] = spins[first].cross(spins[second])
        return terms


class Point:
    """A point given by its coordinates in a frame; fixed there, or moving if they are. Make one with ``frame.point(...)``."""

    __slots__ = ("name", "frame", "x")

    def __init__(self, name, frame, x):
        self.name, self.frame, self.x = name, frame, x

    def __repr__(self):
        return f"Point({self.name} at ({', '.join(repr(plain(v)) for v in self.x)}) in {self.frame.name})"

    def position(self, frame):
        """The vector from the origin of ``frame`` to the point (4.16), expressed in ``frame``."""
        top = self.frame.common(frame)
        here, there = self._above(top), ZERO3
        if frame is not top:
            there = Point("", frame, (Moving(ZERO),) * 3)._above(top)
        c = top.transform(sub3(here, there), frame)
        return Vector(c, frame, lambda: self.velocity(frame).expressed_in(frame))

    def __sub__(self, other):
        """The vector from ``other`` to this point, expressed in this point's frame."""
        if not isinstance(other, Point):
            raise FrameError(f"only a point can be subtracted from a point, got {other!r}")
        top = self.frame.common(other.frame)
        c = top.transform(sub3(self._above(top), other._above(top)), self.frame)
        f = self.frame
        return Vector(c, f, lambda: self.velocity(f) - other.velocity(f))

    def _above(self, top):
        """Position from the origin of ``top``, a frame above the point's, in components of ``top``."""
        c, f = tuple(v.value for v in self.x), self.frame
        while f is not top:
            c, f = add3(tuple(v.value for v in f.origin.x), f._turn(c, 1)), f.parent
        return c

    def velocity(self, observer=None, via=None):
        """v of the point seen from ``observer`` (4.17), (4.28), in components of the frame ``via``.

        via : the moving frame of the formula; default: the frame in which the point is given
        terms: ``origin`` (velocity of the origin of ``via``), ``relative`` (seen in ``via``), ``rotation`` (omega x r)
        """
        via = self._checked(observer, via, "velocity")
        if observer is self.frame and via is observer:
            c = tuple(Moving(v.rate, v.acceleration, None) for v in self.x)
            return _moving_vector(c, observer)
        if via is observer:
            return self.velocity(observer).expressed_in(observer)
        r = self.position(via).c
        relative = self.velocity(via).expressed_in(via)
        origin = _origin_velocity(via, observer).expressed_in(via)
        rotation = cross3(via._omega(observer), r)
        total = add3(add3(origin.c, relative.c), rotation)

        def own_rate():
            turned = cross3(via._omega(observer), total)
            return Vector(sub3(self.acceleration(observer, via).c, turned), via)

        names = {"origin": origin, "relative": relative, "rotation": Vector(rotation, via)}
        return Vector(total, via, own_rate, Ledger("velocity", self._subject(observer, via), lambda: names))

    def acceleration(self, observer=None, via=None):
        """a of the point seen from ``observer`` (4.18), (4.29), in components of the frame ``via``.

        via : the moving frame of the formula; default: the frame in which the point is given
        terms: ``origin`` (acceleration of the origin of ``via``), ``relative`` (seen in ``via``), ``coriolis`` 2 omega x v_r,
        ``euler`` alpha x r, ``centripetal`` omega x (omega x r)

        >>> ground = Frame("ground"); arm = ground.rotate("arm", "z", rate=2.0)
        >>> P = arm.point("P", moving(1.0, rate=3.0), 0, 0)
        >>> P.acceleration(ground).terms["coriolis"]
        Vector(0, 12.0, 0 in arm)
        """
        via = self._checked(observer, via, "acceleration")
        if observer is self.frame and via is observer:
            return Vector(tuple(v.acceleration for v in self.x), observer)
        if via is observer:
            return self.acceleration(observer).expressed_in(observer)
        r = self.position(via).c
        v_r = self.velocity(via).expressed_in(via).c
        omega = via._omega(observer)
        parts = {
            "origin": _origin_acceleration(via, observer).expressed_in(via),
            "relative": self.acceleration(via).expressed_in(via),
            "coriolis": Vector(scale3(2, cross3(omega, v_r)), via),
            "euler": Vector(cross3(via._alpha(observer), r), via),
            "centripetal": Vector(cross3(omega, cross3(omega, r)), via),
        }
        total = ZERO3
        for part in parts.values():
            total = add3(total, part.c)
        return Vector(total, via, None, Ledger("acceleration", self._subject(observer, via), lambda: parts))

    def _subject(self, observer, via):
        return f"of {self.name} in {observer.name}, by way of {via.name}"

    def _checked(self, observer, via, what):
        if not isinstance(observer, Frame):
            raise FrameError(f"a point has no {what} as such, only one seen from a frame: say which, as in {self.name}.{what}(ground)")
        via = via or self.frame
        self.frame.common(observer)
        via.common(observer)
        return via


def _origin_velocity(via, observer):
    """Velocity of the origin of ``via`` seen from ``observer``."""
    if via not in observer._chain:
        return via.origin.velocity(observer)
    own = Point(observer.origin.name, observer, (Moving(ZERO),) * 3)
    rho, carried = own.position(via).c, observer.transform(observer._omega(via), via)
    return Vector(sub3(cross3(carried, rho), observer.origin.velocity(via).expressed_in(via).c), via)


def _origin_acceleration(via, observer):
    """Acceleration of the origin of ``via`` seen from ``observer``; where observer descends from via, (4.18) solved for a_r."""
    if via not in observer._chain:
        return via.origin.acceleration(observer)
    own = Point(observer.origin.name, observer, (Moving(ZERO),) * 3)
    rho = own.position(via).c
    carried, turning = (observer.transform(w, via) for w in (observer._omega(via), observer._alpha(via)))
    v = _origin_velocity(via, observer).c
    c = sub3(scale3(-1, observer.origin.acceleration(via).expressed_in(via).c), scale3(2, cross3(carried, v)))
    return Vector(add3(c, add3(cross3(turning, rho), cross3(carried, cross3(carried, rho)))), via)


def _moving_vector(c, frame):
    """The vector with moving components; it knows its rate in its own frame as far as they know theirs."""

    def own_rate():
        if any(v.rate is None for v in c):
            raise FrameError("the third time derivative of a moving quantity is not known; give coordinates with two rates only")
        return _moving_vector(tuple(Moving(v.rate, v.acceleration, None) for v in c), frame)

    return Vector(tuple(v.value for v in c), frame, own_rate)


def _checked(values, what):
    """Three scalars; arrays among them must fit one shape."""
    values = tuple(v if isinstance(v, Moving) else scalar(v) for v in values)
    shapes = {v.shape for v in (plain(v) for v in values) if getattr(v, "shape", ())}
    if len(shapes) > 1:
        raise FrameError(f"{what} have the shapes {sorted(shapes)}; all arrays must have one shape (N,), one entry for each instant")
    return values


def solve_rates(conditions, count):
    """The unknown rates that make ``conditions`` vanish: rolling without slip, meshing gears, joints (4.4, 4.9).

    conditions : a function of ``count`` rates that returns what must be zero (scalars, Vectors, or a tuple of them), linear in the
        rates, as every velocity is
    Returns a tuple of ``count`` scalars, of the kind of the conditions. There may be more conditions than rates if they agree. Raises
    :class:`FrameError` if the conditions leave a rate open or contradict each other.

    >>> ground = Frame("ground")
    >>> def slip(spin):  # a wheel of radius 0.5 whose centre moves at 2 along x
    ...     wheel = ground.rotate("wheel", "y", rate=spin, origin=ground.point("C", moving(0.0, rate=2.0), 0, 0.5))
    ...     return wheel.point("contact", 0, 0, -0.5).velocity(ground)
    >>> solve_rates(slip, 1)
    (4.0,)
    """
    def residual(*rates):
        out = conditions(*rates)
        out = out if isinstance(out, (tuple, list)) else (out,)
        return [scalar(x) for part in out for x in (part.c if isinstance(part, Vector) else (part,))]

    at_rest = residual(*[0] * count)
    columns = [[u - c for u, c in zip(residual(*[int(n == m) for n in range(count)]), at_rest, strict=True)] for m in range(count)]
    rows = [([column[n] for column in columns], -c) for n, c in enumerate(at_rest)]
    used = [row for row in rows if any(x is not ZERO for x in row[0])]
    if len(used) < count:
        raise FrameError(f"{len(used)} conditions contain the rates, but {count} rates are unknown: {count - len(used)} more are needed")
    if len(used) > count:  # agreeing surplus conditions: the normal equations, which any kind of scalar can solve
        used = [
            ([_sum(m[a] * m[b] for m, _ in used) for b in range(count)], _sum(m[a] * c for m, c in used)) for a in range(count)
        ]
    rates = _solve([m for m, _ in used], [c for _, c in used])
    _check_solution(rows, rates)
    return tuple(plain(r) for r in rates)


def _sum(values):
    total = ZERO
    for v in values:
        total = total + v
    return total


def _solve(matrix, right):
    """Linear equations over scalars of any kind: Cramer's rule, which needs neither a pivot nor a comparison."""
    whole = _determinant(matrix)
    scale = 1
    for row in matrix:
        scale *= max((size(x) for x in row if is_numeric(x)), default=1)
    if whole is ZERO or is_numeric(whole) and size(whole) <= 1e-13 * scale:
        raise FrameError("the conditions do not determine the rates: some of them say the same, or a rate does not occur in them")
    swapped = ([[right[n] if m == k else row[m] for m in range(len(row))] for n, row in enumerate(matrix)] for k in range(len(right)))
    return [_determinant(m) / whole for m in swapped]


def _determinant(m):
    if len(m) == 1:
        return m[0][0]
    return _sum(
        (-1) ** k * (m[0][k] * _determinant([row[:k] + row[k + 1 :] for row in m[1:]])) for k in range(len(m)) if m[0][k] is not ZERO
    )


def _check_solution(rows, rates):
    for coefficients, right in rows:
        left = _sum(c * r for c, r in zip(coefficients, rates, strict=True))
        difference, terms = left - right, [*(c * r for c, r in zip(coefficients, rates, strict=True)), right]
        if is_numeric(difference) and size(difference) > 1e-9 * max(size(t) for t in terms):
            raise FrameError(
                f"the conditions contradict each other: with the rates that fit best, one of them is {size(difference):.3g} instead of 0"
            )

"""Frames and points in relative motion (chapters 2 and 4).

A frame is placed in its parent by a turn about one axis and by its origin. From these steps
everything follows: orientation, angular velocity and acceleration (4.20), (4.25), velocity (4.17),
(4.28) and acceleration (4.18), (4.29) of any point seen from any frame. Rates are passed up the
chain in the frame at hand and never differentiated out, which is what keeps it fast and its
formulas short.
"""

from typing import TypeAlias
from weakref import ref

from ..algebra.jets import Moving, moving
from ..algebra.ledger import Ledger, equations
from ..algebra.scalars import (
    ZERO,
    ScalarError,
    cos,
    is_finite,
    is_zero,
    plain,
    scalar,
    sin,
    sqrt,
    whole,
)
from ..algebra.vectors import (
    NO_THIRD_RATE,
    ZERO3,
    FrameError,
    Vector,
    add3,
    cross3,
    dot3,
    scale3,
    sub3,
)

EQUATIONS = equations({
    "velocity": ("4.17", r"\mathbf{v}", {
        "origin": ("v_B", r"\mathbf{v}_B"),
        "relative": ("v_r", r"\mathbf{v}_r"),
        "rotation": ("omega x r", r"\boldsymbol{\omega}\times\mathbf{r}"),
    }),
    "acceleration": ("4.18", r"\mathbf{a}", {
        "origin": ("a_B", r"\mathbf{a}_B"),
        "relative": ("a_r", r"\mathbf{a}_r"),
        "coriolis": ("2 omega x v_r", r"2\boldsymbol{\omega}\times\mathbf{v}_r"),
        "euler": ("omega' x r", r"\dot{\boldsymbol{\omega}}\times\mathbf{r}"),
        "centripetal": ("omega x (omega x r)", r"\boldsymbol{\omega}\times(\boldsymbol{\omega}\times\mathbf{r})"),
    }),
    "angular velocity": ("4.22", r"\boldsymbol{\omega}", {}),
    "angular acceleration": ("4.25", r"\boldsymbol{\alpha}", {}),
})  # fmt: skip
_AXES = {"x": 0, "y": 1, "z": 2}
_STILL = Moving(ZERO)


class Frame:
    """A frame of reference. ``Frame("ground")`` starts a tree; :meth:`rotate` and :meth:`translate`
    grow it.

    >>> ground = Frame("ground")
    >>> shaft = ground.rotate("shaft", "z", rate=0.6)
    >>> rod = shaft.rotate("rod", "x", angle=1.0, rate=0.5, origin=shaft.point("C", 0, 2.0, 0))
    >>> rod.angular_acceleration(ground).components(shaft)
    (0, 0.3, 0.0)
    """

    def __init__(self, name, parent=None, axis=None, angle=None, origin=None):
        self.name, self.parent, self.axis = name, parent, axis
        self.angle = angle if angle is not None else _STILL
        self._origin = origin
        # without itself, or it would not be freed as soon as nothing refers to it
        self._above = (parent, *parent._above) if parent else ()
        # weak references: a frame keeps those above it alive, not those below
        self._relatives = parent._relatives if parent else {}
        self._relatives[ref(self, self._relatives.pop)] = None
        self._same_origin = parent._seat if parent and origin is None else None
        if origin is not None:
            origin.origin_of = origin.origin_of or name
        self._memo = {}
        if self.angle.value is not ZERO:
            self._c, self._s = cos(self.angle.value), sin(self.angle.value)

    def __repr__(self):
        return f"Frame({' < '.join(f.name for f in (self, *self._above))})"

    @property
    def tree(self):
        """All frames that descend from the same ground and are still in use, in the order in which
        they were made: a list, the ground first.
        """
        return [f for f in (r() for r in list(self._relatives)) if f is not None]

    # -- making frames, points and vectors

    def rotate(self, name, axis, angle=0, rate=None, acceleration=None, origin=None):
        """A new frame turned from this one about ``axis``, right-handed.

        axis : "x", "y", "z" or "-x", "-y", "-z", or three components of any length along this
            frame's axes, constant
        angle, rate, acceleration : rad, rad/s, rad/s^2; ``angle`` may be moving (see
            :func:`moving`, :func:`at`), or a SymPy expression in the symbol ``t``, and then has its
            rates already
        origin : the Point of this frame (or of one above it) where the new frame's origin is;
            default: this frame's own origin
        """
        angle = moving(angle, rate, acceleration)
        _fitting((angle,), f"the angle of {name} and its rates")
        if isinstance(axis, str) and axis.lstrip("-") in _AXES and axis.count("-") <= 1:
            return Frame(
                name,
                self,
                _AXES[axis[-1]],
                -angle if axis[0] == "-" else angle,
                self._place(origin),
            )
        return Frame(name, self, self._unit_axis(axis, angle), angle, self._place(origin))

    def translate(self, name, origin):
        """A new frame with axes that stay parallel to this one's and its origin at the Point
        ``origin``.
        """
        return Frame(name, self, origin=self._place(origin))

    def point(self, name, x, y, z):
        """The point with coordinates (x, y, z) from this frame's origin; fixed in the frame unless
        they are :func:`moving`.
        """
        return Point(
            name, self, _fitting((moving(x), moving(y), moving(z)), f"the coordinates of {name}")
        )

    def vector(self, x, y, z):
        """The vector with these components along this frame's axes; fixed in the frame unless they
        are :func:`moving`.
        """
        return _moving_vector(_fitting((moving(x), moving(y), moving(z)), "the components"), self)

    i = property(lambda self: self.vector(1, 0, 0), doc="unit vector of the first axis")
    j = property(lambda self: self.vector(0, 1, 0), doc="unit vector of the second axis")
    k = property(lambda self: self.vector(0, 0, 1), doc="unit vector of the third axis")

    @property
    def origin(self):
        """The origin as a Point: of the parent, in which it may move, or of this frame itself if it
        has no parent.
        """
        if self._origin is not None:
            return self._origin
        return Point(f"origin of {self.name}", self.parent or self, (_STILL,) * 3)

    def _unit_axis(self, axis, angle):
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
                "an axis is 'x', 'y', 'z', '-x', '-y', '-z', a Vector, or three constant "
                "components, as in (0, 0.6, 0.8); "
                "turn about a moving axis by one more frame in between"
            )
        exact = next(
            (v for v in (angle.value, angle.rate, angle.acceleration) if v is not ZERO), ZERO
        )
        # else the root of a whole number has 16 digits, however many the angle has
        axis = tuple(whole(v, exact) for v in axis)
        length = sqrt(dot3(axis, axis))
        if is_zero(length) or not is_finite(length):
            raise FrameError(
                f"the axis {tuple(map(plain, axis))} has no direction: its length is "
                f"{plain(length)}; give a vector that is not zero"
            )
        return tuple(v / length for v in axis)

    def _place(self, origin):
        if origin is None:
            return None
        if not isinstance(origin, Point):
            raise FrameError(
                f"an origin is a Point, as in {self.name}.point('C', 0, 1, 0); got {origin!r}"
            )
        if origin.frame is not self:
            raise FrameError(
                f"the origin {origin.name} is a point of {origin.frame.name}; give it as a "
                f"point of {self.name}, the frame that is turned from"
            )
        return origin

    # -- orientation

    def common(self, other):
        """The nearest frame from which both this one and ``other`` descend; :class:`FrameError` if
        there is none.
        """
        if not isinstance(other, Frame):
            raise FrameError(
                f"expected a frame, as in {self.name}.rotate('arm', 'z'), got {other!r}"
            )
        if other is self or other in self._above:
            return other
        for f in (self, *self._above):
            if f in other._above:
                return f
        raise FrameError(
            f"{self.name} and {other.name} share no frame: {self!r}, {other!r}. Build both "
            "from one ground, as in ground.rotate(...)"
        )

    def transform(self, c, frame):
        """Components ``c`` along this frame's axes, turned into components along the axes of
        ``frame``.
        """
        top = self.common(frame)
        if c is ZERO3:
            return c
        for f in self._below(top):
            c = f._turn(c, 1)
        for f in reversed(frame._below(top)):
            c = f._turn(c, -1)
        return c

    def _below(self, top):
        """The frames from this one up to that below ``top``."""
        return () if top is self else (self, *self._above[: self._above.index(top)])

    @property
    def _seat(self):
        """The highest frame with the same origin."""
        return self._same_origin or self

    def _turn(self, c, sense):
        """Between this frame and its parent: sense 1 from here up to the parent, -1 down."""
        if c is ZERO3 or self.angle.value is ZERO:
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
        """The matrix R that takes components here to components in ``observer``: three rows; its
        columns are this frame's axes there.

        The book's A (4.1) of direction cosines is its transpose.
        """
        columns = [
            self.transform(tuple(1 if n == m else ZERO for n in range(3)), observer)
            for m in range(3)
        ]
        return tuple(tuple(plain(columns[m][n]) for m in range(3)) for n in range(3))

    # -- angular velocity and acceleration

    def angular_velocity(self, observer):
        """omega of this frame seen from ``observer``, rad/s, in components of this frame (4.20),
        (4.22).

        terms: one for each frame in between, named after it: its turning in its parent.
        """
        self.common(observer)
        ledger = Ledger(
            EQUATIONS["angular velocity"],
            f"of {self.name} in {observer.name}",
            lambda: self._omega_terms(observer),
        )
        return Vector(
            self._omega(observer), self, lambda: self.angular_acceleration(observer), ledger
        )

    def angular_acceleration(self, observer):
        """alpha of this frame seen from ``observer``, rad/s^2, in components of this frame (4.25),
        (4.26) for any number of frames.

        terms: one for each frame in between, and ``"arm x rod"`` for each cross product omega_arm x
            omega_rod of two of them.
        """
        self.common(observer)
        ledger = Ledger(
            EQUATIONS["angular acceleration"],
            f"of {self.name} in {observer.name}",
            lambda: self._alpha_terms(observer),
        )
        return Vector(self._alpha(observer), self, None, ledger)

    def _omega(self, observer):
        return ZERO3 if observer is self else self._remembered("omega", observer, self._new_omega)

    def _alpha(self, observer):
        return ZERO3 if observer is self else self._remembered("alpha", observer, self._new_alpha)

    def _remembered(self, what, observer, compute):
        memo, key = self._memo, (what, observer)
        found = memo.get(key)
        if found is None and observer not in self._above:  # else this frame would keep it alive
            memo, key = memo.get(ref(observer)), what
            if memo is None:
                memo = self._memo[ref(observer, self._memo.pop)] = {}
            found = memo.get(what)
        if found is None:
            found = memo[key] = compute(observer)
        return found

    def _along_axis(self, s):
        """The triple s e, e the unit vector of the axis about which the frame turns in its parent."""
        if self.axis is None or s is ZERO:
            return ZERO3
        return (
            tuple(s if n == self.axis else ZERO for n in range(3))
            if isinstance(self.axis, int)
            else scale3(s, self.axis)
        )

    def _carried(self, observer):
        """omega of the parent, in components of this frame: what this frame would have if it were
        fixed in its parent.
        """
        return self._turn(self.parent._omega(observer), -1)

    def _new_omega(self, observer):
        if observer in self._above:
            return add3(
                self._remembered("carried", observer, self._carried),
                self._along_axis(self.angle.rate),
            )
        top = self.common(observer)
        return sub3(self._omega(top), observer.transform(observer._omega(top), self))

    def _new_alpha(self, observer):
        if observer in self._above:
            crossed = cross3(
                self._remembered("carried", observer, self._carried),
                self._along_axis(self.angle.rate),
            )
            own = add3(self._along_axis(self.angle.acceleration), crossed)
            return add3(self._turn(self.parent._alpha(observer), -1), own)
        top = self.common(observer)
        carried = observer.transform(observer._omega(top), self)
        without = sub3(self._alpha(top), observer.transform(observer._alpha(top), self))
        return sub3(without, cross3(carried, self._omega(observer)))

    def _steps(self, observer):
        """The turns that lead from ``observer`` to here: (name, frame, sense)."""
        top = self.common(observer)
        down = [(f, -1) for f in observer._below(top)]
        up = [(f, 1) for f in reversed(self._below(top))]
        return [(f, s) for f, s in down + up if f.axis is not None]

    def _omega_terms(self, observer):
        return {
            f.name: s * Vector(f._along_axis(f.angle.rate), f).expressed_in(self)
            for f, s in self._steps(observer)
        }

    def _alpha_terms(self, observer):
        spins = self._omega_terms(observer)
        terms = {
            f.name: s * Vector(f._along_axis(f.angle.acceleration), f).expressed_in(self)
            for f, s in self._steps(observer)
        }
        names = list(spins)
        for n, first in enumerate(names):
            for second in names[n + 1 :]:
                terms[f"{first} x {second}"] = spins[first].cross(spins[second])
        return terms


class Point:
    """A point given by its coordinates in a frame; fixed there, or moving if they are. Make one
    with ``frame.point(...)``.

    ``origin_of`` is the name of the first frame that was given the point for its origin, or None.
    """

    __slots__ = ("_c", "frame", "name", "origin_of", "x")

    def __init__(self, name, frame, x):
        self.name, self.frame, self.x, self.origin_of = name, frame, x, None
        self._c = _triple(v.value for v in x)

    def __repr__(self):
        return (
            f"Point({self.name} at ({', '.join(repr(plain(v)) for v in self.x)}) in "
            f"{self.frame.name})"
        )

    def position(self, frame):
        """The vector from the origin of ``frame`` to the point (4.16), expressed in ``frame``."""
        return Vector(self._from(frame), frame, lambda: self.velocity(frame).expressed_in(frame))

    def _from(self, frame):
        """Position from the origin of ``frame``, in its components."""
        if frame is self.frame:
            return self._c
        top = self.frame.common(frame)
        here = self._above(top)
        return (
            here if frame is top else top.transform(sub3(here, _origin(frame)._above(top)), frame)
        )

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
        c, f = self._c, self.frame
        while f is not top:
            c, f = add3(f._origin._c if f._origin else ZERO3, f._turn(c, 1)), f.parent
        return c

    def velocity(self, observer=None, via=None):
        """v of the point seen from ``observer`` (4.17), (4.28), in components of the frame ``via``.

        via : the moving frame of the formula; default: the frame in which the point is given
        terms: ``origin`` (velocity of the origin of ``via``), ``relative`` (seen in ``via``),
            ``rotation`` (omega x r)
        """
        via = self._checked(observer, via, "velocity")
        if observer is self.frame and via is observer:
            return _moving_vector(self.x, observer, 1)
        if via is observer:
            return self.velocity(observer).expressed_in(observer)
        r = self._from(via)
        relative = self.velocity(via).expressed_in(via)
        origin = _origin_velocity(via, observer).expressed_in(via)
        rotation = cross3(via._omega(observer), r)
        total = add3(add3(origin.c, relative.c), rotation)

        def own_rate():
            turned = cross3(via._omega(observer), total)
            return Vector(sub3(self.acceleration(observer, via).c, turned), via)

        def terms():
            return {"origin": origin, "relative": relative, "rotation": Vector(rotation, via)}

        return Vector(
            total, via, own_rate, Ledger(EQUATIONS["velocity"], self._subject(observer, via), terms)
        )

    def acceleration(self, observer=None, via=None):
        """a of the point seen from ``observer`` (4.18), (4.29), in components of the frame ``via``.

        via : the moving frame of the formula; default: the frame in which the point is given
        terms: ``origin`` (acceleration of the origin of ``via``), ``relative`` (seen in ``via``),
            ``coriolis`` 2 omega x v_r,
        ``euler`` alpha x r, ``centripetal`` omega x (omega x r)

        >>> ground = Frame("ground"); arm = ground.rotate("arm", "z", rate=2.0)
        >>> P = arm.point("P", moving(1.0, rate=3.0), 0, 0)
        >>> P.acceleration(ground).terms["coriolis"]
        Vector(0, 12.0, 0 in arm)
        """
        via = self._checked(observer, via, "acceleration")
        if observer is self.frame and via is observer:
            return _moving_vector(self.x, observer, 2)
        if via is observer:
            return self.acceleration(observer).expressed_in(observer)
        omega, r = via._omega(observer), self._from(via)
        origin, relative = (
            _origin_acceleration(via, observer).expressed_in(via),
            self.acceleration(via).expressed_in(via),
        )
        coriolis = cross3(omega, scale3(2, self.velocity(via).expressed_in(via).c))
        euler, centripetal = cross3(via._alpha(observer), r), cross3(omega, cross3(omega, r))
        total = add3(add3(add3(add3(origin.c, relative.c), coriolis), euler), centripetal)

        def terms():
            computed = {"coriolis": coriolis, "euler": euler, "centripetal": centripetal}
            return {
                "origin": origin,
                "relative": relative,
                **{name: Vector(c, via) for name, c in computed.items()},
            }

        return Vector(
            total, via, None, Ledger(EQUATIONS["acceleration"], self._subject(observer, via), terms)
        )

    def _subject(self, observer, via):
        return f"of {self.name} in {observer.name}, by way of {via.name}"

    def _checked(self, observer, via, what):
        if not isinstance(observer, Frame):
            raise FrameError(
                f"a point has no {what} as such, only one seen from a frame: say which, as in "
                f"{self.name}.{what}(ground)"
            )
        via = via or self.frame
        self.frame.common(observer)
        via.common(observer)
        return via


PointLike: TypeAlias = Point | Frame  # a Frame stands for its own origin


def _origin(frame):
    """The origin of a frame as a point of that frame."""
    return Point(f"origin of {frame.name}", frame, (_STILL,) * 3)


def _origin_velocity(via, observer):
    """Velocity of the origin of ``via`` seen from ``observer``."""
    seat, observers = via._seat, observer._seat
    if seat is observers:
        return Vector(ZERO3, via)
    if seat is not observer and seat not in observer._above:
        return seat.origin.velocity(observer)
    rho, carried = _origin(observer)._from(seat), observer.transform(observer._omega(seat), seat)
    return Vector(
        sub3(cross3(carried, rho), observers.origin.velocity(seat).expressed_in(seat).c), seat
    )


def _origin_acceleration(via, observer):
    """Acceleration of the origin of ``via`` seen from ``observer``; where observer descends from
    via, (4.18) solved for a_r.
    """
    seat, observers = via._seat, observer._seat
    if seat is observers:
        return Vector(ZERO3, via)
    if seat is not observer and seat not in observer._above:
        return seat.origin.acceleration(observer)
    rho = _origin(observer)._from(seat)
    carried, turning = (
        observer.transform(w, seat) for w in (observer._omega(seat), observer._alpha(seat))
    )
    v = _origin_velocity(seat, observer).c
    c = sub3(
        scale3(-1, observers.origin.acceleration(seat).expressed_in(seat).c),
        scale3(2, cross3(carried, v)),
    )
    return Vector(add3(c, add3(cross3(turning, rho), cross3(carried, cross3(carried, rho)))), seat)


def _moving_vector(x, frame, order=0):
    """The vector whose components are the coordinates ``x``, or their rates of an order; it knows
    its own rate as far as they do.
    """

    def own_rate():
        if all(v.rests() for v in x):
            return _moving_vector((_STILL,) * 3, frame)
        if order == 2:
            raise FrameError(NO_THIRD_RATE)
        return _moving_vector(x, frame, order + 1)

    name = ("value", "rate", "acceleration")[order]
    return Vector(_triple(getattr(v, name) for v in x), frame, own_rate)


def _triple(values):
    x, y, z = values
    return ZERO3 if x is ZERO and y is ZERO and z is ZERO else (x, y, z)


def _fitting(numbers, what):
    """The moving numbers, if the arrays among them and their rates fit one shape."""
    parts = [
        part
        for v in numbers
        for part in (v.value, v.rate, v.acceleration)
        if type(part) is not float
    ]
    shapes = {part.shape for part in parts if getattr(part, "shape", ())}
    if len(shapes) > 1:
        raise FrameError(
            f"{what} have the shapes {sorted(shapes)}; all arrays must have one shape (N,), "
            "one entry for each instant"
        )
    return numbers


def place(where, what):
    """A place as a Point; a Frame stands for its own origin, as a point fixed in it."""
    if isinstance(where, Frame):
        return where.point(f"origin of {where.name}", 0, 0, 0)
    if not isinstance(where, Point):
        raise FrameError(
            f"the place of {what} is a Point or a Frame, as in body.point('C', 0, 0, 0.2); got "
            f"{where!r}"
        )
    return where


def axes_at(point):
    """The frame that a point is fixed in; :class:`FrameError` if it is also the origin of another,
    whose axes may be the ones meant.
    """
    other = point.origin_of
    if (
        not other
        and point.name.startswith("origin of ")
        and point.name != f"origin of {point.frame.name}"
    ):
        other = point.name[len("origin of ") :]
    if other:
        raise FrameError(
            f"{point.name} is a point of {point.frame.name}, and the origin of {other}: "
            f"along whose axes? For {other}, which the body turns "
            f"with, give the frame in place of the point; for {point.frame.name} say "
            "frame=..., or make another point there"
        )
    return point.frame

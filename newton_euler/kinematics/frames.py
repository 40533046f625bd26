"""Frames and points in relative motion (chapters 2 and 4).

A frame is placed in its parent by a turn about one axis and by its origin. From these steps follow
orientation, angular velocity and acceleration (4.20), (4.25), velocity (4.17), (4.28) and
acceleration (4.18), (4.29) of any point seen from any frame, without differentiating expressions.
"""

import math
import os
import warnings
from collections.abc import Sequence
from itertools import combinations
from threading import Lock
from typing import Any, TypeAlias
from weakref import WeakValueDictionary, ref

from ..algebra.jets import DERIVED, Moving, moving
from ..algebra.ledger import Crossed, Ledger
from ..algebra.names import guided
from ..algebra.otherwise import built
from ..algebra.scalars import (
    ZERO,
    Rows,
    Scalar,
    Triple,
    clipped,
    cos,
    hypot,
    integer_like,
    is_finite,
    sin,
    to_plain,
    vanishes,
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
    three,
    triple,
)

_AXES = {"x": 0, "y": 1, "z": 2}
_AN_AXIS = "an axis is 'x', 'y', 'z', '-x', '-y', '-z', a Vector, or three constant components"
_TURN = 2 * math.pi
_REST = Moving(ZERO)
# pickled frames by their tokens: a frame that comes back from another process is recognised, so
# that vectors computed there can be added to those computed here
_SENT: WeakValueDictionary = WeakValueDictionary()
_SENDING = Lock()
# attributes that belong to this process and are not pickled
_LOCAL = {"parent", "_above", "_relatives", "_memo", "_token"}


class AngleWarning(UserWarning):
    """An angle looks like degrees where radians are expected."""


def _ask_radians(name, angle):
    """Warn of an angle that is typed as a whole number beyond a turn, as 30 or 90.0."""
    usual = 1 if isinstance(angle, int) else 5  # a float may come from a rate and a time
    if isinstance(angle, (int, float)) and _TURN < abs(angle) < 1e300 and angle % usual == 0:
        warnings.warn(
            f"the angle of {name} is {angle:g} rad, {abs(angle) / _TURN:.1f} turns. Did you mean "
            f"degrees? Write radians({angle:g}), from newton_euler import radians",
            AngleWarning,
            stacklevel=4,
        )


@guided
class Frame:
    """A frame of reference. ``Frame("ground")`` is the root of a tree; :meth:`rotate` and
    :meth:`translate` add frames to it.

    >>> ground = Frame("ground")
    >>> shaft = ground.rotate("shaft", "z", rate=0.6)
    >>> rod = shaft.rotate("rod", "x", angle=1.0, rate=0.5, origin=shaft.point("C", 0, 2.0, 0))
    >>> rod.angular_acceleration(ground).components(shaft)
    (0, 0.3, 0.0)
    """

    parent: "Frame | None"  # None for the root
    number: int  # how many frames were made in its parent before it
    _made: int  # how many were made in it
    hats: tuple[str, str, str] = (r"\hat{\imath}", r"\hat{\jmath}", r"\hat{k}")  # unit vectors

    def __init__(
        self,
        name: str,
        parent: "Frame | None" = None,
        axis: Any = None,
        angle: Any = None,
        origin: "Point | None" = None,
    ):
        if not isinstance(name, str):
            raise FrameError(f"a frame has a name, as Frame('ground'); got {clipped(name)}")
        if parent is not None and not isinstance(parent, Frame):
            raise FrameError(f"the parent of {name} is a Frame or None; got {clipped(parent)}")
        if origin is not None and not isinstance(origin, Point):
            raise FrameError(f"the origin of {name} is a Point; got {clipped(origin)}")
        if angle is not None and not isinstance(angle, Moving):
            raise FrameError(
                f"ground.rotate(…) takes the angle of {name}, a moving number; got {clipped(angle)}"
            )
        self.name, self.parent, self.axis, self._origin = name, parent, axis, origin
        self.angle: Any = _REST if angle is None else angle
        self._descend(parent)
        self._same_origin = parent._origin_frame if parent and origin is None else None
        if origin is not None and origin.origin_of is None:
            origin.origin_of = name
        if self.angle.value is not ZERO:
            self._c, self._s = cos(self.angle.value), sin(self.angle.value)

    def _descend(self, parent: "Frame | None") -> None:
        # excludes the frame itself: a cycle would delay its being freed
        self._above: tuple[Frame, ...] = (parent, *parent._above) if parent else ()
        # weak references: a frame keeps those above it alive, not those below
        self._relatives: dict = parent._relatives if parent else {}
        self._relatives[ref(self, self._relatives.pop)] = None
        self.number, self._made = parent._made if parent else 0, 0
        if parent:
            parent._made += 1
        self._memo: dict = {}

    def __reduce__(self):
        # one token for all pickles of the frame; setdefault is atomic between threads
        token = vars(self).setdefault("_token", os.urandom(16))
        _SENT[token] = self
        state = {n: x for n, x in vars(self).items() if n not in _LOCAL}
        return _sent_frame, (type(self), token, self.parent), state

    def __setstate__(self, state: dict[str, Any]) -> None:
        if "name" not in vars(self):  # a frame of this process keeps its own state
            vars(self).update(state)

    def __repr__(self):
        return f"Frame({' < '.join(f.name for f in (self, *self._above))})"

    @property
    def tree(self) -> "list[Frame]":
        """All frames in use that descend from the same ground, oldest first."""
        return [f for f in (r() for r in list(self._relatives)) if f is not None]

    # -- making frames, points and vectors

    @guided
    def rotate(
        self,
        name: str,
        axis: str | Vector | Sequence[Scalar],
        angle: Scalar = 0,
        rate: Scalar = DERIVED,
        acceleration: Scalar = DERIVED,
        origin: "Point | None" = None,
    ) -> "Frame":
        """A new frame turned from this one about ``axis``, right-handed.

        axis : "x", "y", "z", "-x", "-y", "-z", or three constant components in this frame
        angle, rate, acceleration : rad, rad/s, rad/s^2; ``angle`` may be moving (see
            :func:`moving`, :func:`at`), or a SymPy expression in the symbol ``t``, with its rates
        origin : a Point of this frame, the origin of the new one; default: the origin of this frame

        Warns (:class:`AngleWarning`) of a whole number beyond a turn: it may be meant in degrees.
        """
        _ask_radians(name, angle)
        angle = moving(angle, rate, acceleration)
        _same_shape((angle,), f"the angle of {name} and its rates")
        axis, angle = built("turn", (axis, angle))
        unit: Any
        if isinstance(axis, str) and axis.removeprefix("-") in _AXES:
            unit, angle = _AXES[axis[-1]], -angle if axis[0] == "-" else angle
        else:
            unit = self._unit_axis(axis, angle)
        return Frame(name, self, unit, angle, self._place(origin))

    @guided
    def translate(self, name: str, origin: "Point") -> "Frame":
        """A new frame with its origin at a Point of this one, and axes that stay parallel.

        >>> ground = Frame("ground")
        >>> cart = ground.translate("cart", ground.point("A", moving(0.0, rate=3.0), 0, 0))
        >>> cart.origin.velocity(ground)
        Vector(3.0, 0, 0 in ground)
        """
        return Frame(name, self, origin=self._place(origin))

    @guided
    def point(self, name: str, x: Scalar, y: Scalar, z: Scalar) -> "Point":
        """The point at (x, y, z) from the origin; fixed in the frame unless they are moving."""
        if not isinstance(name, str):
            raise FrameError(f"a point has a name, as point('P', 1.0, 0, 0); got {clipped(name)}")
        x, y, z = built("point", (x, y, z))
        return Point(name, self, _same_shape(map(moving, (x, y, z)), f"the coordinates of {name}"))

    @guided
    def vector(self, x: Scalar, y: Scalar, z: Scalar) -> Vector:
        """The vector with these components; fixed in the frame unless they are :func:`moving`."""
        x, y, z = built("vector", (x, y, z))
        return _moving_vector(_same_shape(map(moving, (x, y, z)), "the components"), self)

    i = property(lambda self: self.vector(1, 0, 0), doc="unit vector of the first axis")
    j = property(lambda self: self.vector(0, 1, 0), doc="unit vector of the second axis")
    k = property(lambda self: self.vector(0, 0, 1), doc="unit vector of the third axis")

    @property
    def origin(self) -> "Point":
        """The origin: a Point of the parent, or of this frame if it has none."""
        if self._origin is None and self.parent:
            here = Point(f"origin of {self.name}", self.parent, (_REST,) * 3)
            here.origin_of = self.name
            return here
        return self._origin or _origin(self)

    def _unit_axis(self, axis, angle):
        c = axis.expressed_in(self).c if isinstance(axis, Vector) else axis
        c = three(c, _AN_AXIS, FrameError)
        if any(isinstance(v, Moving) for v in c):
            raise FrameError(
                f"{_AN_AXIS}; got {clipped(axis)}. Turn about a moving axis by one more frame in "
                "between"
            )
        # otherwise the root of a whole number has 16 digits, even where the angle has more
        parts = (angle.value, angle.rate, angle.acceleration)
        exact = next((v for v in parts if v is not ZERO), ZERO)
        c = tuple(integer_like(v, exact) for v in c)
        return divided_by_length(c, hypot(*c), FrameError)

    def _place(self, origin):
        if origin is None:
            return None
        if not isinstance(origin, Point):
            raise FrameError(
                f"an origin is a Point, as {self.name}.point('C', 0, 1, 0); got {origin!r}"
            )
        if origin.frame is not self:
            raise FrameError(
                f"the origin {origin.name} is a point of {origin.frame.name}; give it as a "
                f"point of {self.name}, the frame that is turned from"
                + (f". {_alike(self.name)}" if origin.frame.name == self.name else "")
            )
        return origin

    # -- orientation

    def common(self, other: "Frame") -> "Frame":
        """The nearest common ancestor, or one of the two; :class:`FrameError` without one."""
        if not isinstance(other, Frame):
            raise FrameError(f"expected a frame, as {self.name}.rotate('arm', 'z'), got {other!r}")
        if other is self or other in self._above:
            return other
        for f in (self, *self._above):
            if f in other._above:
                return f
        raise FrameError(
            f"{self.name} and {other.name} share no frame: {self!r}, {other!r}. "
            + _how_to_join(self, other)
        )

    def transform(self, c: Triple, frame: "Frame") -> Triple:
        """The components in ``frame`` of the vector that has the components ``c`` in this one."""
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
    def _origin_frame(self):
        """The highest frame with the same origin."""
        return self._same_origin or self

    def _turn(self, c, sense):
        """Components in the parent from those here (sense 1), or back (sense -1)."""
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

    def rotation(self, observer: "Frame") -> Rows:
        """The matrix R, three rows, that takes components here to components in ``observer``; its
        columns are the axes of this frame there. The book's A (4.1) is its transpose.
        """
        axes = (1, ZERO, ZERO), (ZERO, 1, ZERO), (ZERO, ZERO, 1)
        columns = [map(to_plain, self.transform(axis, observer)) for axis in axes]
        return tuple(zip(*columns, strict=True))

    # -- angular velocity and acceleration

    def angular_velocity(self, observer: "Frame") -> Vector:
        """omega of this frame seen from ``observer``, rad/s, in components of this frame (4.20),
        (4.22); a term for each frame between: its rate of turn in its parent.
        """
        ledger = self._ledger("angular velocity", observer, self._omega_terms)
        omega = self._omega(observer)
        return Vector(omega, self, lambda: self.angular_acceleration(observer), ledger)

    def angular_acceleration(self, observer: "Frame") -> Vector:
        """alpha of this frame seen from ``observer``, rad/s^2, in components of this frame (4.25),
        (4.26); terms: one for each frame between, and ``"arm x rod"`` for two of them.
        """
        ledger = self._ledger("angular acceleration", observer, self._alpha_terms)
        alpha = self._alpha(observer)
        c = built("rate", alpha, lambda: self._omega(observer))
        return Vector(c, self, None, ledger if c is alpha else None)

    def _ledger(self, what, observer, terms):
        self.common(observer)
        subject = f"of {self.name} in {observer.name}"
        return Ledger(what, subject, lambda: terms(observer))

    def _omega(self, observer):
        return ZERO3 if observer is self else self._cached("omega", observer, self._new_omega)

    def _alpha(self, observer):
        return ZERO3 if observer is self else self._cached("alpha", observer, self._new_alpha)

    def _cached(self, what, observer, compute):
        memo, key = self._memo, (what, observer)
        found = memo.get(key)
        # a strong reference to a frame that is not above would keep it alive
        if found is None and observer not in self._above:
            memo, key = memo.get(ref(observer)), what
            if memo is None:
                memo = self._memo[ref(observer, self._memo.pop)] = {}
            found = memo.get(what)
        if found is None:
            found = memo[key] = compute(observer)
        return found

    def _along_axis(self, s):
        """The triple s e, with e the unit vector of the axis of turn in the parent."""
        if self.axis is None or s is ZERO:
            return ZERO3
        if isinstance(self.axis, int):
            return tuple(s if n == self.axis else ZERO for n in range(3))
        return scale3(s, self.axis)

    def _carried(self, observer):
        """omega of the parent, in components of this frame."""
        return self._cached("carried", observer, lambda o: self._turn(self.parent._omega(o), -1))

    def _new_omega(self, observer):
        if observer in self._above:
            return add3(self._carried(observer), self._along_axis(self.angle.rate))
        top = self.common(observer)
        return sub3(self._omega(top), observer.transform(observer._omega(top), self))

    def _new_alpha(self, observer):
        if observer in self._above:
            crossed = cross3(self._carried(observer), self._along_axis(self.angle.rate))
            own = add3(self._along_axis(self.angle.acceleration), crossed)
            return add3(self._turn(self.parent._alpha(observer), -1), own)
        top = self.common(observer)
        carried = observer.transform(observer._omega(top), self)
        without = sub3(self._alpha(top), observer.transform(observer._alpha(top), self))
        return sub3(without, cross3(carried, self._omega(observer)))

    def _steps(self, observer):
        """The turns that lead from ``observer`` to here: (frame, sense)."""
        top = self.common(observer)
        down = [(f, -1) for f in observer._below(top)]
        up = [(f, 1) for f in reversed(self._below(top))]
        return [(f, s) for f, s in down + up if f.axis is not None]

    def _omega_terms(self, observer, rate="rate"):
        return [
            (f.name, s * Vector(f._along_axis(getattr(f.angle, rate)), f).expressed_in(self))
            for f, s in self._steps(observer)
        ]

    def _alpha_terms(self, observer):
        pairs = combinations(self._omega_terms(observer), 2)
        crossed = [(Crossed(n, m), u.cross(v)) for (n, u), (m, v) in pairs]
        return self._omega_terms(observer, "acceleration") + crossed


def _how_to_join(one, other):
    """Advice for two frames without a common ancestor, often by a function called twice."""
    first, second = ((f, *f._above) for f in (one, other))
    alike = next((f.name for f in first if f.name in {s.name for s in second}), None)
    if alike is None:
        return "Build both from one ground, as in ground.rotate(...)"
    return _alike(alike)


def _alike(name):
    return (
        f"These are two trees with the same names, each with its own {name}; a function that "
        f"builds its frames at every call makes such: build once and pass the frame {name}"
    )


def _sent_frame(kind, token, parent):
    """The frame with this token, if it is in this process; else a new one, without its state."""
    with _SENDING:
        frame = _SENT.get(token)
        if frame is None:
            frame = _SENT[token] = kind.__new__(kind)
            frame._token, frame.parent = token, parent
            frame._descend(parent)
    return frame


class Point:
    """A point, made by ``frame.point(...)``, fixed in the frame unless its coordinates are moving;
    ``origin_of`` is the name of the first frame whose origin it is, or None.
    """

    __slots__ = ("_c", "frame", "name", "origin_of", "x")

    def __init__(self, name: str, frame: Frame, x: tuple):
        self.name, self.frame, self.x = name, frame, x
        self.origin_of: str | None = None
        self._c = triple(v.value for v in x)

    def __repr__(self):
        x = ", ".join(repr(to_plain(v.value if v.rests() else v)) for v in self.x)
        return f"Point({self.name} at ({x}) in {self.frame.name})"

    def position(self, frame: Frame) -> Vector:
        """The vector from the origin of ``frame`` to the point (4.16), expressed in ``frame``."""
        return Vector(self._from(frame), frame, lambda: self.velocity(frame).expressed_in(frame))

    def _from(self, frame):
        """Position from the origin of ``frame``, in its components."""
        if frame is self.frame:
            return self._c
        top = self.frame.common(frame)
        c = self._above(top)
        return c if frame is top else top.transform(sub3(c, _origin(frame)._above(top)), frame)

    def __sub__(self, other: "Point") -> Vector:
        """The vector from ``other`` to this point, expressed in this point's frame."""
        if not isinstance(other, Point):
            raise FrameError(f"only a point can be subtracted from a point, got {other!r}")
        f = self.frame
        top = f.common(other.frame)
        c = top.transform(sub3(self._above(top), other._above(top)), f)
        return Vector(c, f, lambda: self.velocity(f) - other.velocity(f))

    def _above(self, top):
        """Position from the origin of ``top``, a frame above, in components of ``top``."""
        c, f = self._c, self.frame
        while f is not top:
            c, f = add3(f._origin._c if f._origin else ZERO3, f._turn(c, 1)), f.parent
        return c

    def velocity(self, observer: Frame | None = None, via: Frame | None = None) -> Vector:
        """v of the point seen from ``observer`` (4.17), (4.28), in components of the frame ``via``.

        via : the moving frame of the formula; default: the frame in which the point is given
        terms : ``origin`` (velocity of the origin of ``via``), ``relative`` (seen in ``via``),
            ``rotation`` (omega x r)

        >>> ground = Frame("ground")
        >>> arm = ground.rotate("arm", "z", rate=2.0)
        >>> arm.point("P", 0.5, 0, 0).velocity(ground)
        Vector(0, 1.0, 0 in arm)
        """
        via = self._checked(observer, via, "velocity")
        if observer is self.frame and via is observer:
            v = _moving_vector(self.x, observer, 1, _VELOCITY)
            c = v.c if v.c is ZERO3 else built("rate", v.c, lambda: self._c)
            return v if c is v.c else Vector(c, observer, lambda: v)
        if via is observer:
            return self.velocity(observer).expressed_in(observer)
        r = self._from(via)
        relative = self.velocity(via).expressed_in(via)
        origin = _origin_motion(via, observer, 1).expressed_in(via)
        rotation = cross3(via._omega(observer), r)
        total = add3(add3(origin.c, relative.c), rotation)

        def own_rate():
            turned = cross3(via._omega(observer), total)
            return Vector(sub3(self.acceleration(observer, via).c, turned), via)

        def terms():
            return {"origin": origin, "relative": relative, "rotation": Vector(rotation, via)}

        return Vector(total, via, own_rate, self._ledger("velocity", observer, via, terms))

    def acceleration(self, observer: Frame | None = None, via: Frame | None = None) -> Vector:
        """a of the point seen from ``observer`` (4.18), (4.29), in components of the frame ``via``.

        via : the moving frame of the formula; default: the frame in which the point is given
        terms : ``origin`` (acceleration of the origin of ``via``), ``relative`` (seen in ``via``),
            ``coriolis`` 2 omega x v_r, ``euler`` alpha x r, ``centripetal`` omega x (omega x r)

        >>> ground = Frame("ground"); arm = ground.rotate("arm", "z", rate=2.0)
        >>> P = arm.point("P", moving(1.0, rate=3.0), 0, 0)
        >>> P.acceleration(ground).terms["coriolis"]
        Vector(0, 12.0, 0 in arm)
        """
        via = self._checked(observer, via, "acceleration")
        if observer is self.frame and via is observer:
            return _moving_vector(self.x, observer, 2, _ACCELERATION)
        if via is observer:
            return self.acceleration(observer).expressed_in(observer)
        omega, r = via._omega(observer), self._from(via)
        origin = _origin_motion(via, observer, 2).expressed_in(via)
        relative = self.acceleration(via).expressed_in(via)
        v_r = self.velocity(via).expressed_in(via).c
        coriolis = cross3(omega, scale3(2, v_r))
        euler, centripetal = cross3(via._alpha(observer), r), cross3(omega, cross3(omega, r))
        total = add3(add3(add3(add3(origin.c, relative.c), coriolis), euler), centripetal)

        def terms():
            turned = {"coriolis": coriolis, "euler": euler, "centripetal": centripetal}
            others = {name: Vector(c, via) for name, c in turned.items()}
            return {"origin": origin, "relative": relative, **others}

        ledger = self._ledger("acceleration", observer, via, terms)

        def of():
            own = self.frame
            turning = Vector(own._omega(observer), own).expressed_in(via).c
            within = Vector(self._from(own), own).expressed_in(via).c
            return *self.velocity(observer, via).c, *v_r, *omega, *turning, *within

        c = built("motion", total, of)
        return Vector(c, via, None, ledger if c is total else None)

    def _ledger(self, what, observer, via, terms):
        subject = f"of {self.name} in {observer.name}, by way of {via.name}"
        return Ledger(what, subject, terms)

    def _checked(self, observer, via, what):
        if not isinstance(observer, Frame):
            raise FrameError(
                f"{what} as seen from which frame? Say it, as in {self.name}.{what}(ground)"
                + ("" if observer is None else f"; got {clipped(observer)}, which is not a Frame")
            )
        if via is None:
            via = self.frame
        elif not isinstance(via, Frame):
            raise FrameError(f"via is the moving Frame of the formula; got {clipped(via)}")
        self.frame.common(observer)
        via.common(observer)
        return via


PointLike: TypeAlias = Point | Frame  # a Frame stands for its own origin


def _origin(frame):
    """The origin of a frame as a point of that frame."""
    return Point(f"origin of {frame.name}", frame, (_REST,) * 3)


def _origin_motion(via, observer, order):
    """Velocity (order 1) or acceleration (2) of the origin of ``via`` seen from ``observer``, where
    need be by (4.17) or (4.18) for the relative one.
    """
    what = ("velocity", "acceleration")[order - 1]
    seat, observers = via._origin_frame, observer._origin_frame
    if seat is observers:
        return Vector(ZERO3, via)
    if seat is not observer and seat not in observer._above:
        return getattr(seat.origin, what)(observer)
    rho, omega = _origin(observer)._from(seat), observer.transform(observer._omega(seat), seat)
    turned = cross3(omega, rho)
    if order == 2:
        alpha = observer.transform(observer._alpha(seat), seat)
        coriolis = scale3(2, cross3(omega, _origin_motion(seat, observer, 1).c))
        turned = sub3(add3(cross3(alpha, rho), cross3(omega, turned)), coriolis)
    origin = getattr(observers.origin, what)(seat).expressed_in(seat).c
    return Vector(sub3(turned, origin), seat)


# what is seen from a point's own frame, which is not a sum
_VELOCITY, _ACCELERATION = Ledger("velocity", "", None), Ledger("acceleration", "", None)


def _moving_vector(x, frame, order=0, kind=None):
    """The vector whose components are the coordinates ``x``, or their rates of an order."""

    def own_rate():
        if all(v.rests() for v in x):
            return _moving_vector((_REST,) * 3, frame)
        if order == 2:
            raise FrameError(NO_THIRD_RATE)
        return _moving_vector(x, frame, order + 1)

    name = ("value", "rate", "acceleration")[order]
    return Vector(triple(getattr(v, name) for v in x), frame, own_rate, kind)


def _same_shape(numbers, what):
    """The moving numbers, if the arrays among them and their rates have one shape."""
    numbers = tuple(numbers)
    parts = (part for v in numbers for part in (v.value, v.rate, v.acceleration))
    shapes = {x.shape for x in parts if type(x) is not float and getattr(x, "shape", ())}
    if len(shapes) > 1:
        raise FrameError(
            f"{what} have the shapes {sorted(shapes)}; all arrays must have one shape (N,)"
        )
    return numbers


def as_point(where: PointLike, what: str) -> Point:
    """The Point itself, or of a Frame its origin, fixed in it; errors name it ``what``."""
    if isinstance(where, Frame):
        return where.point(f"origin of {where.name}", 0, 0, 0)
    if not isinstance(where, Point):
        raise FrameError(
            f"the place of {what} is a Point or a Frame, as body.point('C', 0, 1, 0); got {where!r}"
        )
    return where


def axes_at(point: Point) -> Frame:
    """The frame that a point is fixed in; :class:`FrameError` if it is the origin of another."""
    if (other := point.origin_of) is not None:
        raise FrameError(
            f"{point.name} is a point of {point.frame.name}, and the origin of {other}: along "
            f"whose axes? For {other}, which the body turns with, give the frame in place of the "
            f"point; for {point.frame.name} say frame=..., or make another point there"
        )
    return point.frame


def divided_by_length(axis: tuple, length: Scalar, error: type[Exception]) -> tuple:
    """The unit vector of an axis of known length; an error if that is zero at any instant."""
    if vanishes(length) or not is_finite(length):
        raise error(f"the axis {axis} has no direction: its length is {length}; give another")
    return tuple(x / length for x in axis)

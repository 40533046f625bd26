"""Vectors: three components in a frame (Appendix A of the book).

A :class:`Vector` belongs to a frame but to no origin; the result of an operation is expressed in
the frame of the left one. A vector that theory writes as a sum keeps its terms by name
(``a.terms``, ``a.explain()``); one made from moving quantities has a time derivative
(``a.rate(observer)``).
"""

import math
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import nullcontext, suppress
from functools import reduce
from typing import Any, NoReturn, Protocol, Self

from .jets import Moving, moving
from .late import np
from .ledger import (
    NOISE,
    Equation,
    Explanation,
    Ledger,
    NamedTerms,
    Terms,
    latex_number,
    latex_text,
    unlike,
)
from .names import guided
from .otherwise import built
from .pickles import Computed
from .scalars import (
    ZERO,
    NewtonEulerError,
    RangeError,
    Scalar,
    ScalarError,
    Scaled,
    Triple,
    allowed,
    atan2,
    clipped,
    hypot,
    in_range,
    is_expression,
    is_numeric,
    is_zero,
    largest_abs,
    max_abs,
    min_abs,
    probe,
    real,
    real_scalar,
    scalar,
    short,
    short_repr,
    to_plain,
    where,
)


class Frame(Protocol):
    """What a vector asks of a :class:`~newton_euler.kinematics.frames.Frame`, in a room above."""

    name: str
    hats: tuple[str, str, str]

    def common(self, other: Self) -> object:
        """The nearest frame that both descend from; an error without one."""

    def transform(self, c: Triple, frame: Self) -> Triple:
        """The components in ``frame`` of what has these components here."""

    def angular_velocity(self, observer: Self) -> "Vector":
        """That of this frame seen from ``observer``."""


NO_THIRD_RATE = (
    "the third time derivative of a moving quantity is not known; give coordinates with two "
    "rates only"
)


class FrameError(NewtonEulerError, ValueError):
    """Frames or vectors do not belong together, or the frame of the observer is missing."""


# -- triples: the arithmetic behind vectors, on bare components of one frame

# the zero vector known from the structure of a formula; sums and products look for this one
ZERO3 = (ZERO, ZERO, ZERO)


def cross3(a: Sequence[Scalar], b: Sequence[Scalar]) -> Triple:
    """a x b."""
    if a is ZERO3 or b is ZERO3:
        return ZERO3
    (ax, ay, az), (bx, by, bz) = a, b
    return (ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx)


def dot3(a: Sequence[Scalar], b: Sequence[Scalar]) -> Scalar:
    """a . b."""
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def add3(a: Triple, b: Triple) -> Triple:
    """a + b."""
    if a is ZERO3:
        return b
    return a if b is ZERO3 else (a[0] + b[0], a[1] + b[1], a[2] + b[2])


def sum3(triples: Iterable[Triple]) -> Triple:
    """The sum of any number of them."""
    return reduce(add3, triples, ZERO3)


def sub3(a: Triple, b: Triple) -> Triple:
    """a - b."""
    return a if b is ZERO3 else (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def triple(values: Iterable[Scalar]) -> Triple:
    """The triple of these three components; ZERO3 where all are zero by structure."""
    x, y, z = values
    return ZERO3 if x is ZERO and y is ZERO and z is ZERO else (x, y, z)


def three(values: Any, what: str, error: type[Exception]) -> Triple:
    """The triple of three numbers; anything else is the ``error`` in place of ``what``."""
    with suppress(TypeError):
        if len(values) == 3:
            return tuple(map(real_scalar, values))
    raise error(f"{what}: three numbers are expected, as (0, 0.6, 0.8); got {clipped(values)}")


def scale3(s: Scalar, a: Triple) -> Triple:
    """s a."""
    return ZERO3 if a is ZERO3 else (s * a[0], s * a[1], s * a[2])


class Vector(Scaled, NamedTerms):
    """A vector with components (x, y, z), of every kind, along the axes of ``frame``; made by
    ``frame.vector(x, y, z)``. ``a + b, a - b, 2*a, a/2, -a``, ``dot`` (A.11), ``cross`` (A.13).

    >>> from newton_euler import Frame
    >>> ground = Frame("ground")
    >>> a = ground.vector(1.0, 2.0, 2.0)
    >>> a.norm(), a.dot(ground.i), a.cross(ground.k)
    (3.0, 1.0, Vector(2.0, -1.0, 0 in ground))
    """

    __slots__ = ("_ledger", "_own_rate", "c", "frame")

    frame: Any  # has all that a Frame of the room above has, and not only what is asked here

    def __init__(
        self,
        c: Triple,
        frame: Frame,
        own_rate: "Callable[[], Vector] | None" = None,
        ledger: Ledger | None = None,
    ):
        self.frame, self.c, self._own_rate, self._ledger = frame, c, own_rate, ledger

    def __reduce__(self):
        """With its rate and its terms computed: the functions that do it cannot be pickled."""
        rate = self._own_rate
        if self.c is ZERO3 and _rests(self):
            rate = Resting(self.frame)
        elif rate is not None and not isinstance(rate, (Computed, Resting)):
            rate = Computed(rate)
        return _vector, (self.c, self.frame, rate, self._ledger)

    # -- components

    x = property(lambda self: to_plain(self.c[0]), doc="the component along its first axis (A.7)")
    y = property(lambda self: to_plain(self.c[1]), doc="the component along its second axis (A.7)")
    z = property(lambda self: to_plain(self.c[2]), doc="the component along its third axis (A.7)")

    def __iter__(self) -> Iterator[Scalar]:
        return iter(self.components())

    def __len__(self) -> int:
        return 3

    def __getitem__(self, n: int) -> Scalar:
        try:
            return self.components()[n]
        except (IndexError, TypeError) as error:
            raise type(error)(
                f"the components of a vector are v[0], v[1], v[2]; got v[{clipped(n)}]"
            ) from None

    # no __hash__: vectors that are equal up to round-off would need one hash for all
    def __eq__(self, other: object) -> bool:
        """True if equal up to round-off (:func:`same`), in any frame; False if unknown."""
        if not isinstance(other, Vector):
            return NotImplemented
        if len({x.shape for x in (*self.c, *other.c) if getattr(x, "shape", ())}) > 1:
            return False
        try:
            if other.frame is self.frame:
                equal = [a == b for a, b in zip(self.c, other.c, strict=True)]
                if all(e.all() if getattr(e, "shape", ()) else bool(e) for e in equal):
                    return True
            return same(self, other)
        except (FrameError, ScalarError):
            return False

    def __abs__(self) -> Scalar:
        return self.norm()

    def components(self, frame: Frame | None = None) -> Triple:
        """The three components along the axes of ``frame`` (default: that it is expressed in)."""
        return tuple(map(to_plain, self.c if frame is None else self.expressed_in(frame).c))

    def expressed_in(self, frame: Frame) -> "Vector":
        """The same vector, with its terms and its rate, along the axes of ``frame``."""
        if frame is self.frame:
            return self
        c = self.frame.transform(self.c, frame)
        own_rate = self._own_rate and (lambda: self.rate(frame))
        ledger = self._ledger
        if ledger is not None:
            ledger = ledger.mapped(lambda v: v.expressed_in(frame))
        return Vector(c, frame, own_rate, ledger)

    def rounded(self, noise: float) -> "Vector":
        """The vector with components of at most ``noise`` set to 0."""
        noise = real(noise, "the noise")
        c = tuple(ZERO if is_numeric(x) and max_abs(x) <= noise else x for x in self.c)
        return Vector(c, self.frame)

    def _without_noise(self):
        """The vector as it is printed: components below round-off of the largest are 0."""
        return self.rounded(NOISE * largest_abs(self.c))

    def cleared(self) -> "Vector":
        """The vector without components that vanish whatever their symbols are; its terms stay."""
        c = tuple(ZERO if is_expression(x) and probe(x) == 0 else x for x in self.c)
        return Vector(c, self.frame, self._own_rate, self._ledger)

    def to_array(self) -> "np.ndarray":
        """The components as a NumPy array of shape (3,), or (3, N) where they are arrays.

        >>> from newton_euler import Frame
        >>> Frame("ground").vector(1.0, 2.0, 0).to_array()
        array([1., 2., 0.])
        """
        return np.stack(np.broadcast_arrays(*(np.asarray(x, dtype=float) for x in self)))

    def __repr__(self):
        return f"Vector({', '.join(map(short_repr, self))} in {self.frame.name})"

    def __str__(self):
        return f"[{', '.join(map(short, self._without_noise()))}] in {self.frame.name}"

    def _repr_latex_(self):
        return f"${self.latex()}$"

    def latex(self) -> str:
        """The vector as a LaTeX formula, in the unit vectors of its frame."""
        text = ""
        for x, hat in zip(self._without_noise(), self.frame.hats, strict=True):
            if not is_zero(x):
                number = latex_number(x, 5)
                sign = "+" if text and not number.startswith("-") else ""
                text += rf"{sign}{number}\,{hat}"
        name = latex_text(self.frame.name)
        return rf"\left({text}\right)_{{{name}}}" if text else r"\mathbf{0}"

    # -- algebra

    def _other(self, other, doing):
        if not isinstance(other, Vector):
            raise FrameError(
                f"cannot {doing} the vector {self} and {other!r}: both must be vectors"
            )
        return other.c if other.frame is self.frame else other.expressed_in(self.frame).c

    def __add__(self, other: "Vector") -> "Vector":
        f, c = self.frame, add3(self.c, self._other(other, "add"))
        if self._ledger is not None and other._ledger is not None:
            _of_one_kind(self._ledger, other._ledger)
        return Vector(c, f, lambda: self.rate(f) + other.rate(f))

    def __radd__(self, other: Scalar) -> "Vector":
        if type(other) is int and other == 0:  # where sum() begins
            return self
        return self._other(other, "add")

    def __sub__(self, other: "Vector") -> "Vector":
        f, c = self.frame, sub3(self.c, self._other(other, "subtract"))
        if self._ledger is not None and other._ledger is not None:
            _of_one_kind(self._ledger, other._ledger)
        return Vector(c, f, lambda: self.rate(f) - other.rate(f))

    def __neg__(self) -> "Vector":
        turned = -1 * self
        if self._ledger and turned._ledger:  # its unit is the same
            turned._ledger.scaled = self._ledger.scaled
        elif self._ledger is not None:
            turned._ledger = self._ledger
        return turned

    def __mul__(self, s: Scalar) -> "Vector":
        if isinstance(s, Vector):
            raise FrameError("two vectors have two products: write a.dot(b) or a.cross(b)")
        s = real_scalar(s)
        if isinstance(s, Moving):
            rate = self._own_rate and (lambda: self._product_rate(s))
            return Vector(scale3(s.value, self.c), self.frame, rate)
        return self._each(lambda x: s * x, lambda v: v * s, lambda: self._product_rate(moving(s)))

    __rmul__ = __mul__

    def __truediv__(self, s: Scalar) -> "Vector":
        if isinstance(s, Vector):
            raise FrameError("a vector cannot be divided by a vector")
        s = real_scalar(s)
        rate = self._own_rate and (lambda: self._quotient_rate(moving(s)))
        if isinstance(s, Moving):
            c = ZERO3 if self.c is ZERO3 else tuple(x / s.value for x in self.c)
            return Vector(c, self.frame, rate)
        # not times 1/s: that rounds before an mpf or a fraction comes in
        return self._each(lambda x: x / s, lambda v: v / s, rate)

    def _each(self, change, whole, rate):
        """The vector with every component changed by a factor, and its terms with it."""
        c = ZERO3 if self.c is ZERO3 else tuple(map(change, self.c))
        ledger = None if self._ledger is None else self._ledger.mapped(whole, True)
        return Vector(c, self.frame, self._own_rate and rate, ledger)

    def _product_rate(self, s):
        """The rate of s times this vector in its own frame; ``s`` is moving."""
        changed = self.rate(self.frame) * s
        return changed if s.rests() else self * _rate_of(s) + changed

    def _quotient_rate(self, s):
        """The rate of this vector divided by s, in its own frame; ``s`` is moving."""
        changed = self.rate(self.frame)
        return changed / s.value if s.rests() else (changed - self / s * _rate_of(s)) / s

    def __rtruediv__(self, other: object) -> NoReturn:
        raise FrameError(f"nothing can be divided by a vector: {other!r} / {self}")

    def dot(self, other: "Vector") -> Scalar:
        """The scalar product (A.2), (A.11)."""
        c = self._other(other, "take the dot product of")
        (found,) = built("dot", (to_plain(dot3(self.c, c)),), (*self.c, *c))
        return found

    def cross(self, other: "Vector") -> "Vector":
        """The vector product (A.4), (A.13), in the frame of the left vector; right-handed."""
        f = self.frame
        c = cross3(self.c, self._other(other, "take the cross product of"))
        return Vector(c, f, lambda: self.rate(f).cross(other) + self.cross(other.rate(f)))

    def norm(self) -> Scalar:
        """The magnitude (A.12); in compiled formulas from 1e-154 to 1e154: squares are floats."""
        return to_plain(hypot(*self.c))

    def direction(self) -> "Vector":
        """The unit vector along it (A.1). Raises :class:`FrameError` for a zero vector."""
        length = scalar(self.norm())
        if is_zero(length):
            raise FrameError("a zero vector has no direction; test its norm() first")
        if isinstance(length, float) and not 1e-300 < length < math.inf:
            self = self * (2.0**600 if length < 1 else 2.0**-600)
            length = scalar(self.norm())
        return self / length

    def angle_to(self, other: "Vector") -> Scalar:
        """The angle between two vectors in rad, in [0, pi]; :class:`FrameError` for zero vectors.

        >>> from newton_euler import Frame
        >>> ground = Frame("ground")
        >>> round(ground.i.angle_to(ground.i + ground.j), 6)
        0.785398
        """
        # an arc cosine of the dot product loses half of the digits near 0 and pi
        # (W. Kahan, How Futile are Mindless Assessments of Roundoff, 2006, section 12)
        arrays = any(getattr(x, "shape", ()) for x in (*self.c, *other.c))
        try:
            with np.errstate(over="ignore", invalid="ignore") if arrays else nullcontext():
                across, along = scalar(self.cross(other).norm()), scalar(self.dot(other))
        except (OverflowError, RangeError):  # a product of whole numbers that no float has
            return self.direction().angle_to(other.direction())
        if is_numeric(across) and is_numeric(along):
            size = abs(across) + abs(along)
            lost = not 1e-280 < min_abs(size) <= max_abs(size) < math.inf  # digits of the squares
            if lost and min_abs(self.norm()) > 0 and min_abs(other.norm()) > 0:
                return self.direction().angle_to(other.direction())
            if min_abs(size) == 0:
                raise FrameError(f"a zero vector makes no angle: one of {self} and {other} is zero")
        return atan2(across, along)

    # -- change in time

    @property
    def has_rate(self) -> bool:
        """True if it was made from moving quantities, so that :meth:`rate` can be asked for."""
        return self._own_rate is not None

    def rate(self, observer: Frame | None = None) -> "Vector":
        """Its time derivative seen from the frame ``observer``: the basic kinematic equation
        (4.15), (4.27); terms ``relative``, the rate seen in its own frame, and ``rotation``, omega
        x Q. :class:`FrameError` without an observer, or if the vector is known at the instant only.

        >>> from newton_euler import Frame
        >>> ground = Frame("ground"); arm = ground.rotate("arm", "z", rate=2.0)
        >>> arm.i.rate(ground)
        Vector(0, 2.0, 0 in arm)
        """
        if observer is None:
            raise FrameError(
                "a rate of a vector is seen from a frame: say which, as in Q.rate(ground)"
            )
        self.frame.common(observer)
        if self._own_rate is None:
            raise FrameError(f"the rate of {self} is not known; build it from moving(x, rate=...)")
        seen = self._own_rate().expressed_in(self.frame)
        if observer is self.frame:
            c = built("rate", seen.c, self.c)
            return seen if c is seen.c else Vector(c, self.frame, self._own_rate)
        f = self.frame
        turned = f.angular_velocity(observer).expressed_in(f).cross(self)
        terms = {"relative": seen, "rotation": turned}
        ledger = Ledger("rate", f"{f.name}/{observer.name}", lambda: terms)
        total = add3(seen.c, turned.c)
        c = built("rate", total, self.c)
        own = ledger if c is total else None
        return Vector(c, f, lambda: seen.rate(f) + turned.rate(f), own)

    # -- the term ledger

    @property
    def equation(self) -> Equation | None:
        """The :class:`~newton_euler.algebra.ledger.Equation` of its named terms; None without."""
        return self._ledger.equation if self._ledger else None

    @property
    def terms(self) -> "Terms[Vector]":  # type: ignore[override]
        """The vectors whose sum it is, by name; empty for a vector that is not known as a sum."""
        return self._ledger.terms if self._ledger else Terms()

    def as_sum(
        self, kind: str, subject: str | None = None, terms: Callable | None = None
    ) -> "Vector":
        """The same vector, with its rate, as the sum of these terms by this equation.

        kind : of the equation, a table of ``equations.toml``
        subject : what the sum is about, as "of P in ground"; default: that of the sum it is
        terms : a function that returns them, a dict or pairs (name, Vector); default: those it has
        """
        if subject is None:
            assert self._ledger is not None
            subject = self._ledger.subject
        ledger = Ledger(kind, subject, (lambda: self.terms) if terms is None else terms)
        return Vector(self.c, self.frame, self._own_rate, ledger)

    @guided
    def explain(self, unit: str = "") -> Explanation:
        """The equation of its terms with the number in the book, and the value of each, in this
        ``unit``: an :class:`Explanation`, which prints as text and shows as a formula in Jupyter.
        """
        if not self._ledger:
            raise FrameError(f"{self} was not computed as a named sum, as velocities are")
        return Explanation(self, self._ledger, unit)

    @in_range
    def reweighted(self, /, **factors: Scalar) -> "Vector":
        """The sum of its terms, each times the factor named for it (others once).

        >>> from newton_euler import Frame, moving
        >>> ground = Frame("ground"); arm = ground.rotate("arm", "z", rate=2.0)
        >>> a = arm.point("P", moving(1.0, rate=3.0), 0, 0).acceleration(ground)
        >>> a, a.reweighted(coriolis=0)
        (Vector(-4.0, 12.0, 0 in arm), Vector(-4.0, 0, 0 in arm))
        """
        f = self.frame
        terms = self.terms.weighted(factors)
        if not terms:  # not a sum
            return self
        return Vector(sum3(scale3(s, v.expressed_in(f).c) for s, v in terms), f)


def _of_one_kind(a, b):
    """Raise an error where two ledgers say that what is added has different dimensions."""
    if a.kind != b.kind and not a.scaled and not b.scaled and unlike(a.kind, b.kind):
        from .units import DimensionError

        this, other = (f"{x.kind} {x.subject}".rstrip() for x in (a, b))
        raise DimensionError(
            f"cannot add the {other}, in {b.unit}, to the {this}, in {a.unit}: multiply one of "
            "them by what makes both the same quantity"
        )


class Resting:
    """The rate of a vector that is zero and stays so, in its own frame."""

    def __init__(self, frame: Frame):
        self.frame = frame

    def __call__(self) -> Vector:
        return Vector(ZERO3, self.frame, self)


def _rests(vector):
    """True for a zero vector if its two rates, all that a motion gives, are zero by structure."""
    for _ in range(2):
        if vector._own_rate is None:
            return False
        try:
            vector = vector._own_rate()
        except FrameError:
            return False
        if vector.c is not ZERO3:
            return False
    return True


def _vector(c, frame, own_rate, ledger):
    """The :class:`Vector` that was pickled."""
    return Vector(triple(c), frame, own_rate, ledger)


def _rate_of(s):
    """The rate of the moving number ``s``, as a moving number."""
    if s.rate is None:
        raise FrameError(NO_THIRD_RATE)
    return Moving(s.rate, s.acceleration, None)


def dot(a: Vector, b: Vector) -> Scalar:
    """The scalar product of two vectors (A.11).

    >>> from newton_euler import Frame
    >>> ground = Frame("ground")
    >>> dot(ground.vector(1.0, 2.0, 0), ground.j)
    2.0
    """
    return _checked(a).dot(b)


def cross(a: Vector, b: Vector) -> Vector:
    """The vector product of two vectors (A.13).

    >>> from newton_euler import Frame
    >>> ground = Frame("ground")
    >>> cross(ground.i, ground.j) == ground.k
    True
    """
    return _checked(a).cross(b)


def _checked(a):
    if not isinstance(a, Vector):
        raise FrameError(f"expected a Vector, as ground.vector(1.0, 0, 0); got {clipped(a)}")
    return a


def named_sum(
    kind: str,
    subject: str,
    terms: Mapping[str, Vector] | Iterable[tuple[str, Vector]],
    frame: Frame,
) -> Vector:
    """The Vector in ``frame`` that is the sum of these terms, which it keeps by name."""
    parts = Terms(terms)
    ledger = Ledger(kind, subject, lambda: parts.mapped(lambda v: v.expressed_in(frame)))
    return Vector(sum3(v.expressed_in(frame).c for v in parts.values()), frame, None, ledger)


def same(a: Vector, b: Vector, tolerance: float = 1e-12) -> bool:
    """True if two vectors differ by at most ``tolerance`` times the larger of them, at every
    instant, in the sum of the sizes of components; of symbols, at one set of numbers for them.

    >>> from newton_euler import Frame
    >>> ground = Frame("ground"); turned = ground.rotate("turned", "z", angle=0.3)
    >>> same(ground.i, ground.i.expressed_in(turned)), same(ground.i, 1.001*ground.i)
    (True, False)
    """
    d, *lengths = (_size(v) for v in (_checked(a) - _checked(b), a, b))
    if any(x is None for x in (d, *lengths)):
        raise ScalarError(f"{a} and {b} have components without values, which cannot be compared")
    # instant by instant; written so that nan and infinity are not the same as anything
    largest = where(lengths[0] > lengths[1], *lengths)
    return max_abs(where(d <= allowed(tolerance) * largest, d - d, 1)) == 0


def _size(v):
    """The sum of the sizes of the components, which neither over- nor underflows; or None."""
    values = [probe(scalar(x)) for x in v.c]
    return None if any(x is None for x in values) else sum(abs(x) for x in values)

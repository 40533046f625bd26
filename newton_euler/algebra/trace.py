"""Traced scalars: each operation on them is recorded as a step; equal steps are one. A formula that
is traced cannot branch on a value; it chooses by :func:`newton_euler.algebra.scalars.where`.
"""

import sys
import threading
from collections.abc import Hashable, Iterator, Sequence
from dataclasses import dataclass
from inspect import unwrap
from types import FrameType
from typing import Any

from .scalars import ZERO, Scalar, ScalarError, Scaled, _Own, function, outranks, scalar, to_plain

COMPARISONS = {"lt": "<", "le": "<=", "gt": ">", "ge": ">="}
NO_VALUE = (
    "a formula is traced without values: it must not branch on them (if, and, max, ==) or round "
    "them (int, round, %, //), but chooses by where(x < y, a, b), and takes sin, cos, sqrt ... "
    "from newton_euler, not from math or numpy; in place of numpy.interp and scipy.interpolate it "
    "takes table(ts, values), and in place of numpy.linalg solve_linear and sqrt(x*x + y*y)"
)


class NoNumberError(ScalarError):
    """A traced value was asked for its number."""

    def __init__(self):
        super().__init__(NO_VALUE)


class _Text(str):
    """The text of a traced value, which has no number either."""

    __slots__ = ()

    def __float__(self) -> float:
        raise NoNumberError

    __int__ = __float__


_asked = threading.local()  # .place: code and instruction that last asked for what no step has


def _note(frame):
    _asked.place = frame.f_code, frame.f_lasti


def asked_by(frame: FrameType, instruction: int) -> bool:
    """True if a traced value was last asked for what it does not have by this instruction."""
    return getattr(_asked, "place", None) == (frame.f_code, instruction)


class _NoUfunc:
    """``__array_ufunc__`` of traced values, None: NumPy refuses, and does not say which."""

    def __get__(self, step, kind):
        _note(sys._getframe(1))


def _comparison(name):
    return lambda self, other: self.trace.step(name, self, to_plain(other))


class Step(_Own):
    """A traced scalar, the ``number``-th: ``op`` on ``args``, earlier steps or numbers."""

    __slots__ = ("args", "number", "op", "trace")
    rank = 3

    def __init__(self, trace: "Trace", op: str, args: tuple, number: int):
        self.trace, self.op, self.args, self.number = trace, op, args, number

    def __repr__(self):
        return _Text(f"<traced {self.args[0] if self.op == 'argument' else self.op}>")

    # A minus sign moves outward until it becomes a subtraction or cancels; rounding is symmetric,
    # so none of these moves changes a bit.

    def __add__(self, other: Scalar) -> Scalar:
        if _is(other, 0):
            return self
        if self.op == "neg":
            return other - self.args[0]
        return self - other.args[0] if _negated(other) else self.trace.step("+", self, other)

    def __radd__(self, other: Scalar) -> Scalar:
        if _is(other, 0):
            return self
        return other - self.args[0] if self.op == "neg" else self.trace.step("+", other, self)

    def __sub__(self, other: Scalar) -> Scalar:
        if _is(other, 0):
            return self
        return self + other.args[0] if _negated(other) else self.trace.step("-", self, other)

    def __rsub__(self, other: Scalar) -> Scalar:
        if _is(other, 0):
            return -self
        return other + self.args[0] if self.op == "neg" else self.trace.step("-", other, self)

    def __mul__(self, other: Scalar) -> Scalar:
        if other is ZERO:
            return ZERO
        if _is(other, 1) or _is(other, -1):
            return self if other == 1 else -self
        if self.op == "neg":
            return -(self.args[0] * other)
        return -(self * other.args[0]) if _negated(other) else self.trace.step("*", self, other)

    __rmul__ = __mul__

    def __truediv__(self, other: Scalar) -> Scalar:
        if other is ZERO:
            return NotImplemented  # ZERO raises the error
        if self.op == "neg":
            return -(self.args[0] / other)
        if _negated(other):
            return -(self / other.args[0])
        return self if _is(other, 1) else self.trace.step("/", self, other)

    def __rtruediv__(self, other: Scalar) -> Scalar:
        return -(other / self.args[0]) if self.op == "neg" else self.trace.step("/", other, self)

    def __pow__(self, power: Scalar) -> Scalar:
        if power is ZERO:
            return 1
        if _is(power, 2):
            return self * self
        return self if _is(power, 1) else self.trace.step("**", self, power)

    def __rpow__(self, base: Scalar) -> "Step":
        return self.trace.step("pow", base, self)

    def __neg__(self) -> Scalar:
        return self.args[0] if self.op == "neg" else self.trace.step("neg", self)

    def function(self, name: str, *args: Scalar) -> Scalar:
        """The step of this function, of this step or of the arguments."""
        if self.op == "neg":
            if name in ("cos", "cosh"):
                return function(name, self.args[0])
            if name in ("sin", "tan", "asin", "atan", "sinh", "tanh"):
                return -function(name, self.args[0])
        return self.trace.step(name, *(args or (self,)))

    def pi(self) -> "Step":
        """The step that is pi in the kind of number on which the text will run."""
        return self.trace.step("pi")

    def __abs__(self) -> Scalar:
        return abs(self.args[0]) if self.op == "neg" else self.trace.step("abs", self)

    # A comparison is a step too, by which `where` chooses; it has no value for an `if`.

    __lt__, __le__, __gt__, __ge__ = map(_comparison, COMPARISONS)

    def where(self, a: Scalar, b: Scalar) -> Scalar:
        """The step of :func:`newton_euler.algebra.scalars.where` with this comparison."""
        return a if a is b else self.trace.step("where", self, to_plain(a), to_plain(b))

    # What is integrated, or whose root is taken, is traced as a formula inside this one.

    def _integrals(self, f, start, end):
        """The steps of :func:`newton_euler.algebra.integrals.integral` of a tuple of scalars."""
        return _inner("integral", f, (start, end), f((start + end) / 2))

    def _over_cube(self, f, n):
        """The steps of integrals over the unit cube of ``n`` dimensions."""
        return _inner("over_cube", f, (n,), f(*(0.5,) * n), [f"x{k}" for k in range(n)])

    def _root(self, f, low, high):
        """The step of :func:`newton_euler.algebra.roots.root`."""
        return _inner("root", lambda x: (f(x),), (low, high), (f((low + high) / 2),))[0]

    def _of_table(self, table):
        """The step of the value of a :class:`~newton_euler.algebra.tables.Table` here."""
        return self.trace.step("table", self, table)

    def _no_value(self, *_):
        _note(sys._getframe(1))  # NumPy raises an error of its own for this one
        raise NoNumberError

    __bool__ = __float__ = __complex__ = __int__ = __index__ = __round__ = _no_value
    __trunc__ = __floor__ = __ceil__ = __divmod__ = __rdivmod__ = __invert__ = _no_value
    __mod__ = __rmod__ = __floordiv__ = __rfloordiv__ = _no_value
    __matmul__ = __rmatmul__ = __getitem__ = _no_value
    __and__ = __rand__ = __or__ = __ror__ = __xor__ = __rxor__ = _no_value

    def __format__(self, spec: str) -> str:
        return self._no_value() if spec else repr(self)

    def __eq__(self, other: object) -> bool:
        return self is other or self._no_value()

    __hash__ = object.__hash__


Step.__array_ufunc__ = _NoUfunc()  # type: ignore[attr-defined]


def _negated(x):
    return isinstance(x, Step) and x.op == "neg"


def _is(x, number):
    return (x is ZERO and number == 0) or (type(x) in (int, float) and x == number)


class Trace:
    """The steps of one formula, in order; ``known`` finds equal ones. Of a formula that is
    integrated, ``outer`` is the trace of that around it, and ``captured`` the outer steps it reads.
    ``called`` and ``meant``: of some steps, by their numbers, a name and what they are in words.
    """

    def __init__(self, outer: "Trace | None" = None):
        self.outer = outer
        self.steps: list[Step] = []
        self.known: dict[Hashable, Step] = {}
        self.captured: dict[int, Step] = {}
        self.called: dict[int, str] = {}
        self.meant: dict[int, str] = {}

    def around(self) -> "Iterator[Trace]":
        """The traces around this one, from within."""
        trace = self.outer
        while trace is not None:
            yield trace
            trace = trace.outer

    def inward(self, a: Scalar) -> Scalar:
        """The argument ``a`` as a step of this trace, if it is one of a trace around it."""
        if not isinstance(a, Step) or a.trace is self or a.trace not in self.around():
            return a
        assert self.outer is not None
        a = self.outer.inward(a)
        if a.number not in self.captured:
            self.captured[a.number] = self.new("argument", f"outer{len(self.captured)}")
        return self.captured[a.number]

    def step(self, op: str, *args: Scalar) -> Any:
        """The step of this operation, made if it does not exist yet."""
        if any(isinstance(a, Scaled) or outranks(a, Step) for a in args):
            # the moving number or vector takes over and calls back with its parts
            return NotImplemented
        for a in args:
            if isinstance(a, Step) and a.trace is not self and self in a.trace.around():
                return a.trace.step(op, *args)  # it is part of the inner formula
        # NumPy's zero-dimensional arrays cannot be keys
        inner = [a[()] if getattr(a, "shape", None) == () else self.inward(a) for a in args]
        keys = [self.key(a) for a in inner]
        key = op, *(sorted(keys, key=repr) if op in "+*" else keys)  # sums and products commute
        if key not in self.known:
            self.known[key] = self.new(op, *inner)
        return self.known[key]

    def new(self, op: str, *args: Scalar) -> "Step":
        """A new step."""
        self.steps.append(Step(self, op, args, len(self.steps)))
        return self.steps[-1]

    def key(self, a: Scalar) -> Hashable:
        """A key that is equal for equal arguments; those of 0.0, -0.0 and 0 differ."""
        if isinstance(a, Step):
            if a.trace is not self:
                raise ScalarError("a value of another formula is used here; pass it as an argument")
            return "#", a.number
        if hasattr(a, "key"):  # a formula inside this one, or a table
            return a.key()
        if isinstance(a, complex):
            raise ScalarError(f"a formula that is compiled takes real numbers, got {a}")
        if getattr(scalar(a), "shape", ()):
            raise ScalarError(
                f"an array {a.shape} meets a traced value: write [c*x for c in array], or pass "
                "it as an argument"
            )
        return type(a), repr(a) if isinstance(a, float) else a


@dataclass(eq=False, repr=False)
class Inner:
    """The formula that is integrated, or whose root is taken, as a constant of the formula around
    it. Outer steps that it reads are computed once and passed as arguments. ``variable`` is the
    name of the variable in its code, "" if that is unknown.
    """

    parameters: Sequence[str]
    trace: Trace
    leaves: Sequence[Scalar]
    variable: str = ""

    def key(self) -> Hashable:
        """Equal for equal formulas, for a dictionary."""
        return "inner", keys_of(self.trace), tuple(map(self.trace.key, self.leaves))

    def __reduce__(self):
        return _unpacked_inner, (self.parameters, *packed(self.trace, self.leaves))


_open = threading.local()  # .traces: the inner formulas being traced, from outside to inside


def _inner(op, f, limits, sample, names=("x",)):
    """The steps of ``op`` ("integral", "over_cube", "root") of ``f``, one for each scalar."""
    traces = [x.trace for x in (*limits, *sample) if isinstance(x, Step)]
    # f may use a value of the formula that is being traced, though what it returns does not
    inside = vars(_open).setdefault("traces", [])
    traces += [t for t in inside if traces[0] in t.around()]
    outer = max(traces, key=lambda trace: len(list(trace.around())))
    trace = Trace(outer)
    inside.append(trace)
    try:
        leaves = [trace.inward(leaf) for leaf in f(*(trace.new("argument", x) for x in names))]
    finally:
        inside.pop()
    names = [*names, *(step.args[0] for step in trace.captured.values())]
    trace.outer = None  # the formula is complete, and is kept without the outer one
    outside = [outer.steps[number] for number in trace.captured]
    code = getattr(unwrap(f), "__code__", None)
    inner = Inner(names, trace, leaves, next(iter(code.co_varnames), "") if code else "")
    whole = outer.step(op, inner, *limits, *outside)
    return tuple(outer.step("item", whole, n) for n in range(len(leaves)))


def keys_of(trace: Trace) -> tuple[Hashable, ...]:
    """The steps of a trace for a dictionary, equal for equal formulas."""
    return tuple(
        (s.op, *s.args) if s.op == "argument" else (s.op, *map(trace.key, s.args))
        for s in trace.steps
    )


def packed(trace: Trace, leaves: Sequence[Scalar]) -> tuple[list[tuple], list]:
    """The steps and leaves of a formula for a pickle, steps by their numbers."""

    def by_number(x):
        return (x.number,) if isinstance(x, Step) else x

    return [(s.op, *map(by_number, s.args)) for s in trace.steps], list(map(by_number, leaves))


def unpacked(steps: Sequence[tuple], leaves: Sequence[Scalar]) -> tuple[Trace, list[Scalar]]:
    """The trace and the leaves that were :func:`packed`."""
    trace = Trace()

    def step(x):
        return trace.steps[x[0]] if isinstance(x, tuple) else x

    for op, *args in steps:
        trace.new(op, *map(step, args))
    return trace, list(map(step, leaves))


def _unpacked_inner(parameters, steps, leaves):
    return Inner(parameters, *unpacked(steps, leaves))

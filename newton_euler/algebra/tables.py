"""Data as functions: a table of values, between which it is linear, cubic or constant."""

from bisect import bisect_right
from collections.abc import Sequence
from itertools import pairwise
from typing import Literal

from . import scalars
from .errors import checked
from .late import np, sympy
from .scalars import Scalar, clipped, is_expression, is_finite, is_numeric, scalar, to_plain

# the round-off of a time, as a fraction of the largest, by which it may lie outside of a table
SLACK = 1e-14


class TableError(scalars.NewtonEulerError, ValueError):
    """The data make no table."""


@checked
def table(
    ts: Sequence,
    values: Sequence,
    kind: Literal["linear", "cubic", "natural", "previous"] = "linear",
    outside: Literal["refuse", "hold"] = "refuse",
) -> "Table":
    """The function of one number that passes through data: ``values`` at the places ``ts``, as a
    force measured at some times or a torque at some speeds.

    ts, values : arrays or sequences of one length, the places strictly increasing
    kind : between them "linear"; "cubic", a spline with two continuous derivatives, not-a-knot at
        the ends as in SciPy; "natural", one whose second derivative vanishes at the ends; or
        "previous", the value at the place before (zero-order hold)
    outside : the value at a place outside of the data: "refuse", none, or "hold", that of the
        nearest end

    The function takes numbers of every kind, and keeps all digits of data such as mpf. A model may
    be written with it, of its time and of its states: the methods of integration stop where the
    pieces of a table of time join. Raises :class:`TableError` for data that make no table; the
    function raises :class:`SingularError` outside of them.
    C. de Boor, A Practical Guide to Splines (1978), chapter IV.

    >>> thrust = table([0.0, 0.5, 2.0], [0.0, 12.0, 6.0])
    >>> thrust(1.0), thrust.derivative()(1.0)
    (10.0, -4.0)
    >>> table([0, 1, 2, 3], [0, 1, 4, 9], "cubic")(1.5)
    2.25
    """
    xs, ys = _numbers("places", ts), _numbers("values", values)
    if len(xs) != len(ys) or len(xs) < 2:
        raise TableError(
            f"a table has a value for each of two places or more; got {len(xs)} places and "
            f"{len(ys)} values"
        )
    if all(map(is_numeric, xs)):
        for a, b in pairwise(xs):
            if not a < b:
                raise TableError(f"the places of a table increase; got {b!r} after {a!r}")
    elif any(map(is_expression, xs)):
        raise TableError(f"the places of a table are numbers; got {clipped(ts)}")
    return Table(xs, ys, kind, outside == "hold")


def _numbers(what, sequence):
    """The numbers of a sequence or array, a tuple; those of NumPy as Python's."""
    if getattr(sequence, "ndim", 1) != 1:
        raise TableError(f"the {what} of a table are one number per place; make one of each row")
    entries = sequence.tolist() if hasattr(sequence, "tolist") else sequence
    found = tuple(to_plain(scalar(x)) for x in (entries if hasattr(entries, "__iter__") else ()))
    bad = [x for x in found if getattr(x, "shape", ()) or not is_finite(x) or type(x) is complex]
    if bad:
        raise TableError(f"the {what} of a table are finite real numbers; got {clipped(bad[0])}")
    return found


class Table:
    """The function that :func:`table` returns.

    places, values : the data, as tuples of numbers
    kind, hold : as in :func:`table`; ``hold`` is True to hold the ends outside
    order : of the derivative of the data that the function is
    """

    __slots__ = ("_hash", "_kept", "hold", "kind", "order", "places", "values")

    def __init__(self, places: tuple, values: tuple, kind: str, hold: bool, order: int = 0):
        self.places, self.values, self.kind = places, values, kind
        self.hold, self.order = hold, order
        self._kept: dict = {}
        self._hash: int | None = None

    def __repr__(self):
        of = f"{'derivative of ' * self.order}{self.kind}"
        ends = f"{clipped(self.places[0])} to {clipped(self.places[-1])}"
        return f"<table: {of}, {len(self.places)} places from {ends}>"

    def __reduce__(self):
        return Table, self._content()

    def _content(self):
        return self.places, self.values, self.kind, self.hold, self.order

    def __eq__(self, other: object) -> bool:
        return self is other or (isinstance(other, Table) and self._content() == other._content())

    def __hash__(self):
        if self._hash is None:
            self._hash = hash(self._content())
        return self._hash

    def key(self) -> "Table":
        """Equal for equal tables, for a dictionary."""
        return self

    def derivative(self) -> "Table":
        """The derivative of the function, a table too; where it jumps, that of the next piece."""
        return Table(self.places, self.values, self.kind, self.hold, self.order + 1)

    def __call__(self, x: Scalar) -> Scalar:
        """The value at ``x``, a number of any kind."""
        if type(x) is not float:
            if getattr(x, "size", 1):  # an empty array has an empty array of values
                x = to_plain(scalar(x) if getattr(x, "shape", ()) else scalars.real_scalar(x))
            if isinstance(x, scalars._Own):
                return x._of_table(self) if hasattr(x, "_of_table") else self._dimension(x)
            if is_expression(x):
                return self._formula(x)
            if getattr(x, "shape", ()):
                return self._of_array(x)
        places, pieces = self._of_kind(x)
        if not places[0] <= x <= places[-1]:
            self._refuse_outside(x, x)
        base, coefficients = pieces[bisect_right(places, x)]
        return _polynomial(coefficients, x - base)

    def _of_kind(self, x):
        """The places, and the pieces between them, before the first and from the last on, in the
        kind of number of ``x``: each is the place from which it counts and its coefficients, the
        highest power first.
        """
        key = type(x) is float or (type(x), scalars.epsilon(x))
        if key not in self._kept:
            steps = self.kind == "previous"
            try:
                xs, ys = [[_like(v, x) for v in data] for data in (self.places, self.values)]
                inner = [(y,) for y in ys[:-1]] if steps else _cubics(self.kind, xs, ys)
            except OverflowError as error:
                raise scalars.RangeError(f"{self} has no value in floats: {error}") from error
            pieces = [(xs[0], inner[0]), *zip(xs, inner, strict=False), (xs[-2], inner[-1])]
            if self.hold:
                pieces[0] = xs[0], (ys[0],)
            if self.hold or steps:
                pieces[-1] = xs[-1], (ys[-1],)
            for _ in range(self.order):
                pieces = [(base, _derived(c)) for base, c in pieces]
            self._kept[key] = xs, pieces
        return self._kept[key]

    def _refuse_outside(self, low, high):
        """Raise SingularError unless ``low`` to ``high`` lie in the table, but for round-off."""
        first, last = self.places[0], self.places[-1]
        slack = SLACK * max(abs(first), abs(last))
        if low != low or not (self.hold or (first - low <= slack and high - last <= slack)):
            hold = "; outside='hold' continues it with the values at its ends" if low == low else ""
            raise scalars.SingularError(
                f"a table from {clipped(first)} to {clipped(last)} has no value at "
                f"{clipped(low if low != low or first > low else high)}{hold}"
            )

    def _of_array(self, x):
        if x.dtype.kind == "O":
            return np.array([self(entry) for entry in x.flat]).reshape(x.shape)
        if x.size:
            self._refuse_outside(x.min(), x.max())
        places, pieces = self._of_kind(0.0)
        index = np.searchsorted(places, x, side="right")
        longest = max(len(c) for _, c in pieces)
        rows = np.array([(base, *(0.0,) * (longest - len(c)), *c) for base, c in pieces])
        base, *coefficients = np.moveaxis(rows[index], -1, 0)
        return _polynomial(coefficients, x - base)

    def _dimension(self, x):
        """The dimension of the values at a place of the dimension ``x``."""
        if not hasattr(x, "powers"):
            raise scalars.ScalarError(f"a table has no value at {clipped(x)}")
        places, pieces = self._of_kind(x)
        return _polynomial(pieces[1][1], x - places[0])  # an error for unlike dimensions

    def _formula(self, x):
        """The formula of SymPy with the expression ``x`` as place; it has no value outside."""
        if scalars.library_of((x,)).__name__ == "heyoka":
            raise scalars.ScalarError("heyoka has no tables: take another method")
        x = sympy.sympify(x)
        places, pieces = self._of_kind(x)
        formulas = [_polynomial(c, x - base) for base, c in pieces]
        below, last = [x < place for place in places], self.hold or x <= places[-1]
        if not self.hold:
            formulas[0] = sympy.nan
        return sympy.Piecewise(*zip(formulas, [*below, last], strict=True))


def _like(v, x):
    """The number ``v`` in the kind of ``x``."""
    return float(v) if isinstance(x, float) and is_numeric(v) else v + 0 * x


def _polynomial(coefficients, u):
    """The value of a polynomial, the coefficient of the highest power first."""
    value = coefficients[0]
    for c in coefficients[1:]:
        value = value * u + c
    return value


def _derived(coefficients):
    """The coefficients of the derivative."""
    n = len(coefficients) - 1
    return tuple([(n - k) * c for k, c in enumerate(coefficients[:-1])]) or (0 * coefficients[0],)


def _cubics(kind, xs, ys):
    """The coefficients of the pieces of a table that is linear or a spline."""
    steps = [b - a for a, b in pairwise(xs)]
    means = [(b - a) / h for (a, b), h in zip(pairwise(ys), steps, strict=True)]
    if kind == "linear" or len(xs) == 2:
        return list(zip(means, ys, strict=False))
    slopes = _solved(*_equations(kind, steps, means))
    return [
        ((s + r - 2 * m) / (h * h), (3 * m - 2 * s - r) / h, s, y)
        for (s, r), m, h, y in zip(pairwise(slopes), means, steps, ys, strict=False)
    ]


def _equations(kind, h, m):
    """The equations for the slopes at the places: the coefficients of the slope before, of this one
    and of the next in each, and the right-hand sides.

    h, m : the distances of the places, and the mean slopes between them
    """
    rows = [(b, 2 * (a + b), a) for a, b in pairwise(h)]
    right = [3 * (b * p + a * q) for (a, b), (p, q) in zip(pairwise(h), pairwise(m), strict=True)]
    if kind == "natural":
        return [(0, 2, 1), *rows, (1, 2, 0)], [3 * m[0], *right, 3 * m[-1]]
    if len(h) == 2:  # the parabola through three places
        return [(0, 1, 1), *rows, (1, 1, 0)], [2 * m[0], *right, 2 * m[1]]

    def end(a, b, p, q):  # the third derivative is continuous at the place next to the end
        return ((3 * a + 2 * b) * b * p + a * a * q) / (a + b)

    first, last = (0, h[1], h[0] + h[1]), (h[-1] + h[-2], h[-2], 0)
    ends = end(h[0], h[1], m[0], m[1]), end(h[-1], h[-2], m[-1], m[-2])
    return [first, *rows, last], [ends[0], *right, ends[1]]


def _solved(rows, right):
    """The solution of equations in each of which three neighbours occur, by elimination."""
    (_, diagonal, above), value = rows[0], right[0]
    done = []
    for (below, middle, after), r in zip(rows[1:], right[1:], strict=True):
        done.append((diagonal, above, value))
        factor = below / diagonal
        diagonal, above, value = middle - factor * above, after, r - factor * value
    found = [value / diagonal]
    for diagonal, above, value in reversed(done):
        found.append((value - above * found[-1]) / diagonal)
    return found[::-1]

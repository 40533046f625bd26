"""The kinds of answers, a class each, by name in :data:`KINDS`: how an answer is read, compared
with the key, worded, typeset, drawn with other numbers and hinted at. A new kind is a class here.
"""

import contextlib
import math
from collections.abc import Mapping, Sequence
from itertools import chain
from typing import Any, ClassVar
from unicodedata import normalize

from ..algebra.errors import NewtonEulerError
from ..algebra.language import Words, _, plural
from ..algebra.scalars import clipped, sqrt
from ..algebra.units import unit as unit_of
from ..algebra.vectors import Vector
from . import causes, slips, tolerance
from .causes import Cause
from .fit import Fit, most_digits
from .messages import StatedForm
from .notation import list_symbol, matrix_symbol
from .sympy_formulas import read_formula
from .tolerance import RTOL, Point, Points, distance, formula_is_near, is_near
from .trees import Budget, TreeError, are_one_vector, formula_values, numbers
from .values import components, read_number

MOST = 10**15  # the largest count; JSON has no place for thousands of digits
FRAMES = 4  # the most frames in which a vector is read: its own, the ground, and two between


class Kind:
    """A kind of answer; this base class holds for answers that are numbers. An answer to be
    compared is a tuple of points (one for each place at which formulas are compared), each a tuple
    of components.
    """

    name: ClassVar[str]
    title: ClassVar[str]  # name for a reader
    words: ClassVar[str]  # what to write, for a reader
    shape: ClassVar[tuple[int, ...]] = ()  # shape of its components; (3, 3) has rows of three
    rtol: ClassVar[float] = RTOL
    is_word: ClassVar[bool] = False  # True: no unit, no size, no components
    is_formula: ClassVar[bool] = False  # True: written in the symbols of the problem
    is_vector: ClassVar[bool] = False  # True: three components, along axes
    is_matrix: ClassVar[bool] = False  # True: 3 x 3 in rows, each along two axes
    has_size: ClassVar[bool] = True  # True: the givens of the problem determine it
    has_options: ClassVar[bool] = False  # True: its form lists the words to choose from
    is_met_by_chance: ClassVar[bool] = False  # True: wrong models often give it
    many: ClassVar[str] = ""  # why several sets of numbers are right, if so
    with_numbers: ClassVar[str] = ""  # name of the kind with numbers in place of symbols

    def __str__(self) -> str:
        return self.name

    def __repr__(self) -> str:
        return f"KINDS[{self.name!r}]"

    def __reduce__(self) -> tuple[Any, ...]:
        return _kind, (self.name,)

    @property
    def length(self) -> int:
        """The number of its components."""
        return math.prod(self.shape)

    @property
    def is_along_axes(self) -> bool:
        """True if its components are those of a vector or a matrix."""
        return self.is_vector or self.is_matrix

    @property
    def numeric(self) -> "Kind":
        """The kind that is asked for where numbers stand for the symbols."""
        return KINDS[self.with_numbers or self.name]

    # -- reading

    def read(self, value: Any, form: StatedForm, symbols: Mapping[str, str], budget: Budget) -> Any:
        """The JSON of an answer that a student computed by any library: a number, a formula tree,
        or a list of them. Raises :class:`~.messages.AnswerError`. ``symbols``: {name: unit} of
        formulas; ``budget``: the operations that may still be read.
        """
        return self._read(components(value, form), value, form, symbols, budget)

    def _read(self, parts, value, form, symbols, budget):
        if len(parts) != self.length:
            given, n = clipped(value), len(parts)
            got = plural("got {n} number: {value}", "got {n} numbers: {value}", n, value=given)
            raise form.error(got)
        found = [self._component(x, form, symbols, budget) for x in parts]
        return found[0] if self.length == 1 else found

    def _component(self, x, form, symbols, budget):
        return read_number(x, form)

    def parts(self, tree: Any) -> Any:
        """The components of an answer in JSON."""
        return tree if self.length > 1 else [tree]

    def readings(
        self, tree: Any, form: StatedForm, symbols: Mapping[str, Any], budget: Budget
    ) -> list[Points]:
        """The readings of an answer in JSON: for a vector that is given in several frames, its
        components in each, of which :func:`~.verdicts.counted` finds those that count; [] for
        anything not of this kind. Raises :class:`~.trees.TreeError`.

        symbols : {name: array of the points at which formulas are compared}
        """
        trees = self.parts(tree)
        if not isinstance(trees, list) or len(trees) != self.length:
            raise TreeError("expected {words}", words=form.words)
        return [self._points(trees, form, symbols, budget)]

    def _points(self, trees, form, symbols, budget):
        if not all(type(t) in (int, float) for t in trees):
            raise TreeError("expected {words}", words=form.words)
        return numbers(trees)

    # -- comparing

    def is_right(self, given: Points, key: Points, atol: float, rtol: float = RTOL) -> bool:
        """True if an answer is near enough to the key; ``atol`` is the absolute tolerance for a key
        that is zero, ``rtol`` the relative one of numbers: formulas and words are exact.
        """
        return is_near(given[0], key[0], atol, rtol)

    def is_zero(self, points: Points, atol: float) -> bool:
        """True if an answer is zero up to its absolute tolerance."""
        return max(math.hypot(*point) for point in points) <= atol

    def like(self, points: Points, others: Points) -> Points:
        """The points nearest to ``others`` of all that mean the same answer."""
        return points

    def sealed(self, point: Point) -> list[Point]:
        """All points by which a seal may be opened; the first is the one that is sealed."""
        return [point]

    # -- hints

    def factors(self, unit: str) -> Mapping[str, float]:
        """{words: factor} of the units that the answer may be in by mistake."""
        return slips.factors(unit)

    def slips(self, fit: Fit) -> slips.Models:
        """The key with components turned, exchanged or left out: [(cause, points)]."""
        return iter(())

    def observed(self, given: Points, key: Points) -> Cause | None:
        """A remark on a wrong answer that no mistake explains, as a :class:`~.causes.Cause` of the
        group "seen", or None. Both are points in the unit of the key.

        >>> KINDS["number"].observed(((1.02,),), ((1.0,),)).name
        'near'
        """
        size, gap = math.hypot(*key[0]), math.dist(given[0], key[0])
        if slips.is_rounded(given, key) and gap <= tolerance.TWO_DIGITS * size:
            return causes.FIRST_DIGITS
        if not size or gap > tolerance.NEARLY * size:
            return None
        few = most_digits(given[0]) < tolerance.DIGITS
        return causes.NEAR_IN_FEW_DIGITS if few else causes.NEAR

    def _in_part(self, given, key):
        """The remark that some components are right, if one of these is not zero."""
        near = [self.rtol * math.hypot(*k) for k in key]
        triples = [*zip(given, key, near, strict=True)]
        places = range(self.length)
        off = [n for n in places if any(not abs(x[n] - k[n]) <= e for x, k, e in triples)]
        right = any(abs(k[n]) > e for _, k, e in triples for n in {*places} - {*off})
        named = right and off and self.is_along_axes
        return causes.right_but(off, key[0], self.is_matrix) if named else None

    def in_part(self, cause: Cause, places: Sequence[int], key: Point) -> Cause:
        """The same cause in some components alone, where the others are right."""
        if not self.is_along_axes:
            return cause
        return causes.in_components(cause, places, key, self.is_matrix)

    # -- other numbers

    def unfit(self, points: Points) -> str | None:
        """Why a key is a bad one, as the end of a sentence, or None: it is not finite, or has a
        component that could be left out.
        """
        for x in points:
            if not all(map(math.isfinite, x)):
                return f"= {x}"
            whole = math.hypot(*x)
            for share in (abs(part) / whole for part in x if whole):
                if tolerance.NOISE < share < tolerance.COMPONENT:
                    return f"with a component of {share:.1e} of the whole"
        return None

    def change(self, moved: Points, points: Points) -> float:
        """How much a key changes, relative to its size, with a change of the givens."""
        return max(map(distance, self.like(moved, points), points))

    # -- writing

    def nested(self, parts: Sequence[Any]) -> Any:
        """Components as one value: a number, a list, a list of rows."""
        if len(self.shape) < 2:
            return list(parts) if self.shape else parts[0]
        columns = self.shape[1]
        return [list(parts[n : n + columns]) for n in range(0, self.length, columns)]

    def in_rows(self, tree: Any) -> Any:
        """An answer in JSON as it is written: the entries of a matrix in rows."""
        is_whole = len(self.shape) == 2 and type(tree) is list and len(tree) == self.length
        return self.nested(tree) if is_whole else tree

    def typeset(self, parts: Sequence[str]) -> str:
        """Components in LaTeX as one formula."""
        if len(self.shape) == 2:
            return matrix_symbol(self.nested(parts))
        return rf"\left[{list_symbol(parts)}\right]" if self.shape else parts[0]

    def names(self, key: str) -> list[str]:
        """The names in formulas of the components of ``key``: v_x, v_y and v_z of a vector v."""
        return [f"{key}_{n}" for n in range(1, self.length + 1)] if self.shape else [key]

    def places(self) -> list[str]:
        """The names of its components for a reader, "" of the only one."""
        if not self.shape:
            return [""]
        if len(self.shape) == 1:
            return [_("number {n} of {all}", n=n + 1, all=self.length) for n in range(self.length)]
        rows = (divmod(n, self.shape[1]) for n in range(self.length))
        return [_("row {row}, column {column}", row=n + 1, column=m + 1) for n, m in rows]


class Number(Kind):
    """One number with a unit."""

    name = "number"
    title = Words("number")
    words = Words("one number")
    is_met_by_chance = True


class VectorKind(Kind):
    """Three components in the axes that the problem names."""

    name = "vector"
    title = Words("vector")
    words = Words("a vector, three numbers as in [1.0, 0, -2.5]")
    shape = (3,)
    is_vector = True

    def names(self, key: str) -> list[str]:
        return [f"{key}_{axis}" for axis in "xyz"]

    def places(self) -> list[str]:
        return [_("first component"), _("second component"), _("third component")]

    def read(self, value: Any, form: StatedForm, symbols: Mapping[str, str], budget: Budget) -> Any:
        """As for a kind; a vector that lies in a frame is read in several, {frame: tree}."""
        if isinstance(value, Vector) and value.frame.parent is not None:
            return self._in_frames(value, form, symbols, budget)
        return super().read(value, form, symbols, budget)

    def _in_frames(self, vector, form, symbols, budget):
        """The components of a vector in its own frame, in the ground, and in frames between these,
        {name of the frame: tree}: which axes the problem means is not known here.
        """
        found, faults = {}, []
        for frame in _chain(vector.frame):
            left = budget[0]
            try:
                tree = self._read(list(vector.components(frame)), vector, form, symbols, budget)
            except (NewtonEulerError, ArithmeticError) as error:
                faults.append(error)
                budget[0] = left  # a frame that is not read uses no budget
                continue
            if tree not in found.values() or frame.parent is None:
                name = frame.name
                while name in found:  # of another frame with the same name
                    name += "'"
                found[name] = tree
        if not found:
            raise faults[0]
        first, *others = found.values()
        return found if any(tree != first for tree in others) else first

    def readings(
        self, tree: Any, form: StatedForm, symbols: Mapping[str, Any], budget: Budget
    ) -> list[Points]:
        """As for a kind: of {frame: tree} the components in each, if they are one vector."""
        if not isinstance(tree, dict) or not 0 < len(tree) <= FRAMES:
            return super().readings(tree, form, symbols, budget)
        own = (super(VectorKind, self).readings(x, form, symbols, budget) for x in tree.values())
        found = [*chain(*own)]
        if not are_one_vector(*found):
            raise TreeError("its components in two frames are those of two vectors")
        return found

    def slips(self, fit: Fit) -> slips.Models:
        return slips.of_vector(fit)

    def observed(self, given: Points, key: Points) -> Cause | None:
        """As for a kind; or the remark that only the size, or some components, are right."""
        if seen := super().observed(given, key):
            return seen
        fit, size = Fit(given, key, self.rtol), math.hypot(*key[0])
        off = abs(math.hypot(*given[0]) - size)
        is_turned = size and off <= max(tolerance.SAME_SIZE * size, fit.rounding)
        return causes.DIRECTION if is_turned else self._in_part(given, key)


def _chain(frame):
    """A frame, its ground, and some of those between."""
    frames = [frame]
    while frames[-1].parent is not None:
        frames.append(frames[-1].parent)
    return [frames[0], frames[-1], *frames[1:-1]][:FRAMES]


class Direction(VectorKind):
    """A line through space, as a principal axis: a vector along it, of any length but zero and of
    either sense, compared by the angle.
    """

    name = "direction"
    title = Words("direction")
    words = Words("a direction, three numbers of any length and either sense, as in [1, 0, -2.5]")
    has_size = False
    many = "a direction of any length, which has no right numbers"

    def _read(self, parts, value, form, symbols, budget):
        found = super()._read(parts, value, form, symbols, budget)
        if not any(found):
            raise form.error("got a vector of length zero, which has no direction")
        return found

    def _points(self, trees, form, symbols, budget):
        points = super()._points(trees, form, symbols, budget)
        if not any(points[0]):
            raise TreeError("a vector of length zero has no direction")
        if not 1e-99 < (longest := max(map(abs, points[0]))) < 1e99:  # a square beyond floats
            points = (tuple(x / longest for x in points[0]),)
        return points

    def is_right(self, given: Points, key: Points, atol: float, rtol: float = RTOL) -> bool:
        """True up to the length and the sense."""
        return is_near(self.like(given, key)[0], key[0], 0.0, rtol)

    def like(self, points: Points, others: Points) -> Points:
        """The same line, with the length and on the side of the other."""
        return tuple(map(_along, points, others))

    def sealed(self, point: Point) -> list[Point]:
        """The unit vector along it, and its opposite."""
        unit = _along(point, (1.0, 0.0, 0.0))
        return [unit, tuple(-x for x in unit)]

    def factors(self, unit: str) -> Mapping[str, float]:
        return {}  # its length means nothing

    def slips(self, fit: Fit) -> slips.Models:
        yield from slips.of_vector(fit)
        other_sense = tuple(tuple(-x for x in point) for point in fit.key)
        yield from slips.exchanged(Fit(fit.given, other_sense, fit.rtol))

    def observed(self, given: Points, key: Points) -> Cause | None:
        return Kind.observed(self, given, key)


def _along(point, other):
    """A point on the same line as ``point``, as far from zero as ``other`` and on its side."""
    length, wanted = (sqrt(sum(x * x for x in p)) for p in (point, other))
    if not length:
        return point
    side = 1 if sum(x * y for x, y in zip(point, other, strict=True)) >= 0 else -1
    return tuple(side * wanted / length * x for x in point)


class Matrix(Kind):
    """Three rows of three numbers; its components are given row by row."""

    name = "matrix"
    title = Words("matrix")
    words = Words("a 3 x 3 matrix of numbers, as in [[1, 0, 0], [0, 1, 0], [0, 0, 1]]")
    shape = (3, 3)
    is_matrix = True

    def names(self, key: str) -> list[str]:
        return [f"{key}_{row}{column}" for row in "xyz" for column in "xyz"]

    def slips(self, fit: Fit) -> slips.Models:
        return slips.of_matrix(fit)

    def observed(self, given: Points, key: Points) -> Cause | None:
        return super().observed(given, key) or self._in_part(given, key)


class Interval(Kind):
    """A lower and an upper bound, each judged by itself: relative to a wide interval, an error of
    its lower bound would be small.
    """

    name = "interval"
    title = Words("interval")
    words = Words("an interval, two numbers as in [low, high]")
    shape = (2,)

    def is_right(self, given: Points, key: Points, atol: float, rtol: float = RTOL) -> bool:
        return all(is_near((x,), (k,), atol, rtol) for x, k in zip(given[0], key[0], strict=True))

    def slips(self, fit: Fit) -> slips.Models:
        return slips.of_interval(fit)

    def places(self) -> list[str]:
        return [_("lower bound"), _("upper bound")]


class _Formula(Kind):
    """Formulas in the symbols of the problem, which are exact whatever their values."""

    rtol = tolerance.FORMULA_FIT
    is_formula = True
    has_size = False

    def _component(self, x, form, symbols, budget):
        return read_formula(x, form, symbols, budget)

    def _points(self, trees, form, symbols, budget):
        return formula_values(trees, symbols, budget)

    def is_right(self, given, key, atol, rtol=RTOL):
        """True at every point where the key has a value."""
        return formula_is_near(given, key, atol)

    def factors(self, unit):
        """The pure ones, and those of an angle: a formula is in no other unit."""
        return slips.PURE | (slips.ANGLES if unit_of(unit).is_of_angle else {})

    def observed(self, given, key):
        """The remark that only a number is wrong, or that some components are right."""
        pairs = zip(chain(*given), chain(*key), strict=True)
        ratios = [x / k if k else math.inf for x, k in pairs if k or x]
        first = next((x for x in ratios if math.isfinite(x)), 0.0)
        alike = first and all(abs(x - first) <= self.rtol * abs(first) for x in ratios)
        return causes.NUMBERS if alike else self._in_part(given, key)

    def unfit(self, points):
        """Why it is a bad key: no number at most points."""
        few = sum(math.isfinite(math.hypot(*x)) for x in points) < tolerance.MAJORITY * len(points)
        return "= nan at most points of its symbols" if few else None

    def change(self, moved, points):
        return 0.0


class Expression(_Formula):
    """One formula."""

    name = "expression"
    title = Words("formula")
    words = Words("a formula in the problem's symbols")
    with_numbers = "number"


class VectorExpression(_Formula, VectorKind):
    """Three formulas, components in the axes that the problem names."""

    name = "vector_expression"
    title = Words("vector of formulas")
    words = Words("a vector of three formulas, as in [r*omega, 0, 0]")
    with_numbers = "vector"


class MatrixExpression(_Formula, Matrix):
    """Three rows of three formulas."""

    name = "matrix_expression"
    title = Words("matrix of formulas")
    words = Words("a 3 x 3 matrix of formulas")
    with_numbers = "matrix"


class _Word(Kind):
    """An answer that is right or wrong, nothing between."""

    is_word = True
    has_size = False
    python_type: ClassVar[type]

    def readings(self, tree, form, symbols, budget):
        return [((tree,),)] if type(tree) is self.python_type else []

    def is_right(self, given, key, atol, rtol=RTOL):
        return given == key

    def is_zero(self, points, atol):
        return False

    def observed(self, given, key):
        return

    def unfit(self, points):
        return

    def change(self, moved, points):
        return 0.0 if moved == points else math.inf


class Count(_Word):
    """A whole number, without a unit."""

    name = "count"
    title = Words("count")
    words = Words("a whole number")
    python_type = int

    def read(self, value: Any, form: StatedForm, symbols: Mapping[str, str], budget: Budget) -> int:
        """A whole number, also as 3.0; raises :class:`~.messages.AnswerError` of another one."""
        with contextlib.suppress(ArithmeticError, TypeError, ValueError):
            if not isinstance(value, (bool, str)) and int(value) == value and abs(value) < MOST:
                return int(value)
        raise form.error("got {value}", value=clipped(value))


class Choice(_Word):
    """One of the words that the form lists."""

    name = "choice"
    title = Words("choice")
    words = Words("one of the words")
    python_type = str
    has_options = True

    def read(self, value: Any, form: StatedForm, symbols: Mapping[str, str], budget: Budget) -> str:
        """The word of the list that is meant: capitals and blanks say nothing, but between words
        that differ in nothing else.
        """
        given = str(value) if isinstance(value, str) else ""
        for plain in (str, _plain, lambda text: _plain(text).casefold()):
            found = {word for word in form.of if plain(word) == plain(given)}
            if len(found) == 1:
                return found.pop()
        raise form.error("got {value}", value=repr(str(value)[:80]))


def _plain(word):
    return " ".join(normalize("NFKC", word).split())


KINDS: dict[str, Kind] = {
    kind.name: kind()
    for kind in (
        Number, VectorKind, Direction, Matrix, Interval, Count, Choice,
        Expression, VectorExpression, MatrixExpression,
    )
}  # fmt: skip


def _kind(name):
    return KINDS[name]

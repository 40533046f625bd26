"""Linear equations for unknown rates, accelerations and reactions, over scalars of every kind.

Velocities are linear in rates, the Newton-Euler equations (8.21) in accelerations and forces. The
equations are written as what must vanish and run on :class:`LinearForm` unknowns, which read off
the coefficients, each in its own unit. :func:`solve_rates` is for the few rates of a rolling
contact or a joint; :func:`solve_linear` for equations with names, and a report.
"""

from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from contextvars import ContextVar
from dataclasses import dataclass, field
from functools import cache
from inspect import signature
from math import prod
from operator import add, mul
from types import MappingProxyType
from typing import Any, NoReturn

from .elimination import Elimination, LinearEquation, LinearError, Varies
from .errors import checked, checked_but
from .late import np
from .ledger import distinct
from .names import listed
from .scalars import (
    ZERO,
    Scalar,
    ScalarError,
    Scaled,
    Triple,
    Unordered,
    _Own,
    is_numeric,
    is_zero,
    largest_abs,
    max_abs,
    min_abs,
    outranks,
    probe,
    real_scalar,
    scalar,
    short,
    short_repr,
    to_plain,
)
from .vectors import Vector

# Unknowns that Cramer's rule solves at once; its formulas grow as the factorial of their number, so
# more are eliminated one by one.
LARGEST_CORE = 6

# Surplus conditions of solve_rates: data that agree to nine digits agree.
AGREEMENT = 1e-9
# Cramer's rule for numbers of every kind: 450 round-offs of a float, relative to the largest
# coefficient or to the product of the rows.
RATE_NOISE = 1e-13


class _NoUnknown(LinearError, AttributeError):
    """There is no unknown of this name; an AttributeError too, so that ``hasattr`` is False."""


class LinearForm(Unordered, _Own):
    """``value + c[0]*u[0] + c[1]*u[1] + …``: a scalar that is linear in unknowns. A product of
    unknowns, or a function of one, raises :class:`ScalarError`.

    >>> 3.0 * LinearForm(2.0, (1, ZERO)) - LinearForm(ZERO, (ZERO, 1))
    LinearForm(6.0, (3.0, -1))
    """

    __slots__ = ("coefficients", "value")
    rank = 5
    advice = "the conditions must be linear in the unknowns"

    @checked_but("value", "coefficients")  # every operation makes one of these
    def __init__(self, value: Scalar, coefficients: Iterable[Scalar]):
        self.value, self.coefficients = value, tuple(coefficients)

    def __repr__(self):
        coefficients = ", ".join(map(short_repr, self.coefficients))
        end = "," * (len(self.coefficients) == 1)
        return f"LinearForm({short_repr(self.value)}, ({coefficients}{end}))"

    def _of(self, x: Scalar) -> "LinearForm":
        """The linear form that ``x`` is, or the constant one in the same unknowns."""
        return x if isinstance(x, LinearForm) else LinearForm(x, [ZERO] * len(self.coefficients))

    def _parts(self) -> tuple:
        """The value, and the coefficients in order."""
        return self.value, *self.coefficients

    @staticmethod
    def _of_parts(parts: tuple) -> "LinearForm":
        """The linear form of these parts."""
        return LinearForm(parts[0], parts[1:])

    @staticmethod
    def _refuse(what: str) -> NoReturn:
        raise ScalarError(f"{what}; the conditions must be linear in the unknowns")

    def _each(self, change):
        return LinearForm(change(self.value), map(change, self.coefficients))

    def __add__(self, other: Scalar) -> "LinearForm":
        if isinstance(other, LinearForm):
            coefficients = map(add, self.coefficients, other.coefficients)
            return LinearForm(self.value + other.value, coefficients)
        if outranks(other, self):
            return NotImplemented
        return LinearForm(self.value + real_scalar(other), self.coefficients)

    __radd__ = __add__

    def __neg__(self) -> "LinearForm":
        return self._each(lambda x: -x)

    def __mul__(self, other: Scalar) -> Scalar:
        if other is ZERO:
            return ZERO
        if isinstance(other, Scaled) or outranks(other, self):
            return NotImplemented
        if isinstance(other, LinearForm):
            self._refuse("two unknowns are multiplied")
        other = real_scalar(other)
        return self._each(lambda x: x * other)

    __rmul__ = __mul__

    def __truediv__(self, other: Scalar) -> "LinearForm":
        if outranks(other, self):
            return NotImplemented
        other = real_scalar(other)
        return self._each(lambda x: x / other)

    def __rtruediv__(self, other: Scalar) -> NoReturn:
        self._refuse("an unknown occurs in a denominator")

    @checked
    def function(self, name: str, *args: Scalar) -> Scalar:
        """Raises :class:`ScalarError`: a function of an unknown is not linear in it."""
        self._refuse(f"{name} is taken of an unknown")

    def __pow__(self, power: Scalar) -> NoReturn:
        self._refuse("an unknown is raised to a power")

    def __abs__(self) -> NoReturn:
        self._refuse("the absolute value is taken of an unknown")


# -- the equations that were solved, for worked solutions


@dataclass(frozen=True)
class Solved:
    """Linear equations with their solution.

    equations : pairs of the coefficients of the unknowns and the right side
    names : of the unknowns. values : of those that are determined, by their names
    """

    equations: Sequence[tuple[Sequence[Scalar], Scalar]]
    names: Sequence[str]
    values: Mapping[str, Scalar]


_shown: ContextVar[list[Solved] | None] = ContextVar("shown", default=None)


@contextmanager
def solved_equations() -> Iterator[list[Solved]]:
    """A list of the linear equations that are solved in the ``with`` block.

    >>> with solved_equations() as found:
    ...     _ = solve_rates(lambda spin: 0.5 * spin - 2.0, 1)
    >>> found[0].equations, dict(found[0].values)
    ([((0.5,), 2.0)], {'spin': 4.0})
    """
    found: list[Solved] = []
    token = _shown.set(found)
    try:
        yield found
    finally:
        _shown.reset(token)


def _show(equations, names, values):
    if (found := _shown.get()) is not None:
        found.append(Solved([(e.coefficients, e.right) for e in equations], names, values))


def _arguments(conditions):
    """The names of the arguments of a function; none if it is in C and has no signature."""
    try:
        parameters = signature(conditions).parameters.values()
    except (TypeError, ValueError):
        return []
    return [
        p.name
        for p in parameters
        if p.default is p.empty and p.kind in (p.POSITIONAL_ONLY, p.POSITIONAL_OR_KEYWORD)
    ]


# -- a few rates


@checked
def solve_rates(conditions: Callable[..., Any], count: int) -> Triple:
    """The unknown rates that make ``conditions`` vanish, a tuple: rolling without slip, meshing
    gears, joints (4.4, 4.9). There may be more conditions than rates if they agree.

    conditions : a function of ``count`` rates that returns what must be zero (scalars, Vectors, or
        a tuple of them), linear in the rates, as every velocity is
    Raises :class:`LinearError` if the conditions do not determine a rate or contradict each other,
    and :class:`ScalarError` if they are not linear.

    >>> from newton_euler import Frame, moving
    >>> ground = Frame("ground")
    >>> def slip(spin):  # a wheel of radius 0.5 whose centre moves at 2 along x
    ...     C = ground.point("C", moving(0.0, rate=2.0), 0, 0.5)
    ...     wheel = ground.rotate("wheel", "y", rate=spin, origin=C)
    ...     return wheel.point("contact", 0, 0, -0.5).velocity(ground)
    >>> solve_rates(slip, 1)
    (4.0,)
    """
    equations = _equations(conditions(*_unknowns(count)), count)
    noise = RATE_NOISE * largest_abs(c for e in equations for c in e.coefficients)
    is_there = lambda c: not is_numeric(c) or max_abs(c) > noise  # noqa: E731
    rows = [e.parts() for e in equations if any(map(is_there, e.coefficients))]
    if len(rows) < count:
        raise LinearError(
            f"{len(rows)} conditions contain the rates, but {count} rates are unknown: "
            f"{count - len(rows)} more are needed"
        )
    # Surplus conditions: the normal equations hold for any kind of scalar, and at any values of
    # those without a value, where a choice of conditions could divide by zero.
    if len(rows) > count:
        columns = [*zip(*rows, strict=True)]
        rows = [[sum(map(mul, a, b), ZERO) for b in columns] for a in columns[:count]]
    rates = _cramer([row[:count] for row in rows], [row[count] for row in rows])
    terms = [[*map(mul, e.coefficients, rates), -e.right] for e in equations]
    parts = [x for row in terms for x in row]
    if all(map(is_numeric, parts)):
        worst = largest_abs(sum(row, ZERO) for row in terms)
        if worst > AGREEMENT * largest_abs(parts):
            raise LinearError(
                "the conditions contradict each other: with the rates that fit best, one of them "
                f"is {worst:.3g} instead of 0"
            )
    rates = tuple(map(to_plain, rates))
    if _shown.get() is not None:
        names = _arguments(conditions)
        names = names if len(names) == count else [f"u_{n}" for n in range(1, count + 1)]
        _show(equations, names, dict(zip(names, rates, strict=True)))
    return rates


def _unknowns(count):
    return [LinearForm(ZERO, (int(n == m) or ZERO for m in range(count))) for n in range(count)]


def _cramer(matrix, right):
    """The solution for scalars of any kind by Cramer's rule: no pivot, no comparison."""
    every = tuple(range(len(matrix)))

    @cache
    def minor(rows, columns):
        """The determinant of these rows and columns; common minors are computed once."""
        if not rows:
            return 1
        first, rest, out = matrix[rows[0]], rows[1:], ZERO
        for k, c in enumerate(columns):
            if first[c] is not ZERO:
                out = out + (-1) ** k * (first[c] * minor(rest, columns[:k] + columns[k + 1 :]))
        return out

    determinant = minor(every, every)
    if determinant is ZERO or (
        is_numeric(determinant)
        and min_abs(determinant) <= RATE_NOISE * prod(largest_abs(row) or 1 for row in matrix)
    ):
        raise LinearError(
            "the conditions do not determine the rates: some are equivalent, or do not contain one"
        )

    def cofactor(n, k):
        return (-1) ** (n + k) * minor(every[:n] + every[n + 1 :], every[:k] + every[k + 1 :])

    # cofactor by determinant first: common factors cancel in a formula that is not simplified
    return [sum((cofactor(n, k) / determinant * right[n] for n in every), ZERO) for k in every]


# -- many unknowns, equations with names


@dataclass(frozen=True)
class Solution:
    """The solution that :func:`solve_linear` returns; ``print`` it for a report in words.
    ``s.alpha`` or ``s["alpha"]`` is an unknown's value; asking for one that is not determined
    raises :class:`LinearError`. Iterating gives the values in the order of the unknowns.

    names : the unknowns
    values, undetermined : those that are determined, by name; the names of the others
    relations : what the equations determine of those, as "A_x = 3 - B_x" (for numbers)
    redundant : by name, the equations that follow from others, with the names of these

    >>> s = solve_linear(lambda A, B: (A + B - 3.0, A - B - 1.0))
    >>> s.A, s["B"], s.undetermined
    (2.0, 1.0, ())
    """

    names: tuple
    values: Mapping
    undetermined: tuple = ()
    relations: tuple = ()
    redundant: Mapping = field(default_factory=dict)

    def __getitem__(self, name: str) -> Scalar:
        if isinstance(name, str) and name in self.values:
            return self.values[name]
        if not isinstance(name, str) or name not in self.names:
            raise _NoUnknown(f"there is no unknown {name!r}; there are {', '.join(self.names)}")
        raise LinearError(f"{name} is not determined by the equations. {self.report()}")

    def __getattr__(self, name: str) -> Scalar:
        if name.startswith("__"):
            raise AttributeError(name)
        return self[name]

    def __iter__(self) -> Iterator[Scalar]:
        return (self[name] for name in self.names)

    def __len__(self) -> int:
        return len(self.names)

    def report(self) -> str:
        """Sentences: which unknowns are not determined, and which equations are redundant."""
        sentences = []
        if self.undetermined:
            known = f": only {' and '.join(self.relations)} is known" if self.relations else ""
            sentences.append(
                f"Not determined: {', '.join(self.undetermined)}{known}; more equations are "
                "needed, or fewer unknowns"
            )
        sentences += [
            f"The equation {name!r} is redundant: it follows from {listed(map(repr, others))}"
            for name, others in self.redundant.items()
        ]
        nothing = "The equations determine every unknown, and each of them is needed"
        return ". ".join(sentences) or nothing

    def __str__(self):
        lines = [
            f"{name} = {short(self.values[name]) if name in self.values else 'not determined'}"
            for name in self.names
        ]
        return "\n".join([*lines, self.report()])


@checked
def solve_linear(conditions: Callable, names: str | Sequence[str] | None = None) -> Solution:
    """The unknown accelerations, forces and rates that make named equations vanish, with a report:
    a :class:`Solution`. :class:`LinearError` names equations that contradict others.

    conditions : a function of the unknowns that returns what must be zero, linear in them: best a
        dict of scalars and Vectors by the name of the equation (a Vector is three equations, as
        "force.x"); or a tuple, or one of them. Each equation may have its own unit
    names : of the unknowns, in order, as "a N alpha" or a tuple; default: those of the arguments

    Numbers are eliminated equation by equation, with a choice of pivots. Arrays are solved for all
    instants. Expressions give formulas, without simplification: unknowns that stand alone first,
    the rest by Cramer's rule. SymPy coefficients are tested for zero at a point, with numbers in
    the place of the symbols. Traced and heyoka expressions and dimensions are zero only by their
    form, and surplus equations of those are not compared.

    >>> from newton_euler import cos, sin
    >>> def laws(N, F, a):  # a block of 2 kg slides on a slope of 0.3 rad
    ...     return {
    ...         "along": 2.0 * a - 2.0 * 9.81 * sin(0.3) + F,
    ...         "across": N - 2.0 * 9.81 * cos(0.3),
    ...         "friction": F - 0.1 * N,
    ...     }
    >>> round(solve_linear(laws).a, 6)
    1.961868
    >>> print(solve_linear(lambda A, B: {"force": A + B - 3.0}))
    A = not determined
    B = not determined
    Not determined: A, B: only A = 3 - B is known; more equations are needed, or fewer unknowns
    """
    if names is None:
        names = _arguments(conditions)
    names = tuple(names.replace(",", " ").split() if isinstance(names, str) else names)
    if not names:
        raise LinearError("there are no unknowns: name them, as in solve_linear(laws, 'a N alpha')")
    if twice := [n for n in names if names.count(n) > 1]:
        raise LinearError(f"the unknown {twice[0]!r} is named twice")
    if taken := [n for n in names if n in Solution.__dataclass_fields__ or n == "report"]:
        raise LinearError(f"{taken[0]!r} is a part of the solution: give the unknown another name")
    equations = _equations(conditions(*_unknowns(len(names))), len(names))
    return _solved([e for e in equations if not all(map(is_zero, e.parts()))], names)


def _solved(equations, names):
    made_up = {}

    def known_or_made_up(x):
        if (known := probe(x)) is not None:
            return known
        # numbers between 0.5 and 1.5 without a pattern (steps of the golden ratio), for expressions
        # whose value cannot be known
        return made_up.setdefault(id(x), (0.37 + 0.6180339887 * len(made_up)) % 1 + 0.5)

    samples = [e.each(known_or_made_up) for e in equations]
    numbers = all(probe(x) is x for e in equations for x in e.parts())
    try:
        found = Elimination(samples, len(names), not made_up, numbers)
    except Varies:
        return _instant_by_instant(equations, names)
    values = found.values if numbers else _of_expressions(equations, found)
    named = MappingProxyType({names[k]: to_plain(values[k]) for k in sorted(values)})
    _show(equations, names, named)
    return Solution(
        names,
        named,
        tuple(n for k, n in enumerate(names) if k not in found.values),
        tuple(found.relations(names)) if numbers else (),
        MappingProxyType(found.redundant()),
    )


def _equations(conditions, count):
    """The conditions as equations with distinct names, as "force.x" of a Vector, "equation 2"."""
    if not isinstance(conditions, Mapping):
        parts = conditions if isinstance(conditions, (tuple, list)) else (conditions,)
        conditions = {f"equation {n}": x for n, x in enumerate(parts, 1)}
    rows = [
        (group, name, x)
        for group, condition in enumerate(conditions.items())
        for name, x in _scalars(*condition)
    ]
    return [
        LinearEquation(name, x.coefficients, -x.value, group)
        if isinstance(x, LinearForm)
        else LinearEquation(name, (ZERO,) * count, -x, group)
        for name, (group, _, x) in zip(distinct([name for _, name, _ in rows]), rows, strict=True)
    ]


def _scalars(name, value):
    """Pairs of a name and a scalar: the value, or its components or parts."""
    if isinstance(value, Vector):
        return [(f"{name}.{axis}", scalar(x)) for axis, x in zip("xyz", value.c, strict=True)]
    if getattr(getattr(value, "dtype", None), "kind", "") == "O":  # as A @ numpy.array([x, y])
        value = value.tolist()
    if isinstance(value, (tuple, list)):
        return [pair for n, x in enumerate(value, 1) for pair in _scalars(f"{name}.{n}", x)]
    return [(name, scalar(value))]


def _instant_by_instant(equations, names):
    """The solution for arrays that have no common pivot: each instant by itself, then together."""
    shape = np.broadcast_shapes(*(np.shape(x) for e in equations for x in e.parts()))

    def at(n):
        return [
            e.each(lambda x: np.broadcast_to(x, shape)[n] if np.shape(x) else x) for e in equations
        ]

    every = [_solved(at(n), names) for n in np.ndindex(shape)]
    undetermined = {s.undetermined for s in every}
    if len(undetermined) > 1:
        raise LinearError(
            f"the equations determine {', '.join(sorted(set().union(*undetermined)))} at some "
            "instants and not at others; solve these instants separately"
        )
    values = {
        name: np.array([float(s.values[name]) for s in every]).reshape(shape)
        for name in every[0].values
    }
    redundant = {name: others for s in every for name, others in s.redundant.items()}
    return Solution(names, MappingProxyType(values), *undetermined, (), MappingProxyType(redundant))


# -- expressions: what stands alone first, the rest by Cramer's rule


def _of_expressions(equations, found):
    """The determined unknowns as formulas, from the equations found to be independent."""

    def occurs(c):
        known = None if c is ZERO else probe(c)
        return c is not ZERO and (known is None or max_abs(known) > 0)

    rows = [
        ({k: c for k, c in enumerate(e.coefficients) if k in found.rows and occurs(c)}, e.right)
        for n, e in enumerate(equations)
        if n not in found.dependent
    ]
    return {k: x for k, x in solve_regular(rows).items() if k in found.values}


def solve_regular(rows: list[tuple[Mapping[int, Scalar], Scalar]]) -> dict[int, Scalar]:
    """The unknowns by number, from as many independent equations, pairs (coefficients by unknown,
    right side). Pivots are chosen by Markowitz's rule, the place that changes the fewest others:
    best an unknown alone in its equation, or one that occurs nowhere else and follows from the
    others. Without such a place, Cramer's rule solves the last few.
    """
    if not rows:
        return {}
    if not all(c for c, _ in rows):
        raise LinearError("the equations do not determine the unknowns: one of them contains none")
    occurring = Counter(k for c, _ in rows for k in c)

    def touched(place):
        n, k = place
        c = rows[n][0]
        largest = -min_abs(c[k]) if is_numeric(c[k]) else 1.0
        return (len(c) - 1) * (occurring[k] - 1), len(c), largest

    n, k = min(((n, k) for n, (c, _) in enumerate(rows) for k in c), key=touched)
    coefficients, right = rows[n]
    if min(len(coefficients), occurring[k]) > 1 and len(rows) <= LARGEST_CORE:
        unknowns = sorted(occurring)
        matrix = [[c.get(k, ZERO) for k in unknowns] for c, _ in rows]
        return dict(zip(unknowns, _cramer(matrix, [b for _, b in rows]), strict=True))
    p, rest = coefficients[k], []
    others = {j: c for j, c in coefficients.items() if j != k}
    for c, b in rows[:n] + rows[n + 1 :]:
        if k in c:
            factor = c[k] / p
            b = b - (factor * right if others else c[k] * (right / p))
            c = {
                j: c.get(j, ZERO) - factor * others[j] if j in others else c[j]
                for j in {**c, **others}
                if j != k
            }
        rest.append((c, b))
    values = solve_regular(rest)
    return {**values, k: (right - sum((c * values[j] for j, c in others.items()), ZERO)) / p}

"""Linear equations for unknown rates, accelerations and reactions, over scalars of every kind, and
what they leave open.

Velocities are linear in rates, the Newton-Euler equations (8.21) in accelerations and forces. The
equations are written as what must vanish and run on :class:`LinearForm` unknowns, which read off
the coefficients, each in its own unit. :func:`solve_rates` is for the few rates of a rolling
contact or a joint; :func:`solve_linear` for whole sets of equations with names, and it reports what
they leave open.
"""

from collections import Counter
from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cache
from inspect import signature
from math import prod
from types import MappingProxyType

from .scalars import (
    ZERO,
    ScalarError,
    Scaled,
    _Own,
    coarseness,
    is_numeric,
    is_zero,
    least,
    outranks,
    pi,
    plain,
    sampled,
    scalar,
    short,
    size,
)
from .vectors import FrameError, Vector

# unknowns that are solved together by Cramer's rule; of more, one after the other is eliminated
LARGEST_CORE = 6

# Thresholds of the elimination, in round-offs of the coarsest number. Measured on 3000 surplus
# equations of systems with 2 to 12 random unknowns and
# condition numbers up to 1e4: what should vanish is at most 2**2 of them in a row, and 2**4 in a
# right side; what should not, at least 2**37.
# beside the largest coefficient of a condition: what is left of a sum of a few terms that cancel,
# as of a turned vector's components
LEFT_OVER = 16
# beside the largest coefficient that was subtracted: a thousand times what is measured, for longer
# chains of equations
NO_PIVOT = 2**12
# beside the pivot, or the largest part of a sum: halfway between both measured sizes
ABSENT = 2**19
# beside the terms of the equation: 1e-9, so that data that agree in nine digits agree
CONTRADICTION = 2**22
AGREEMENT = 1e-9  # the same for the surplus conditions of solve_rates
# of solve_rates, for every kind of number: 450 round-offs of a float beside the largest
# coefficient, or the product of the rows
RATE_NOISE = 1e-13


class LinearError(FrameError):
    """Linear equations that contradict each other, or a question for an unknown that they leave
    open.

    equations : the names of the equations that are to blame
    """

    def __init__(self, message, equations=()):
        super().__init__(message)
        self.equations = tuple(equations)


class LinearForm(_Own):
    """``value + c[0]*u[0] + c[1]*u[1] + …``: a scalar that is linear in unknowns.

    Running conditions on it reads off their coefficients, each in its own unit. A product of
    unknowns, or a function of one, raises :class:`ScalarError`.

    >>> 3.0 * LinearForm(2.0, (1, ZERO)) - LinearForm(ZERO, (ZERO, 1))
    LinearForm(6.0, (3.0, -1))
    """

    __slots__ = ("coefficients", "value")
    rank = 5

    def __init__(self, value, coefficients):
        self.value, self.coefficients = value, tuple(coefficients)

    def __repr__(self):
        return f"LinearForm({plain(self.value)!r}, {tuple(map(plain, self.coefficients))!r})"

    @staticmethod
    def _refuse(what):
        raise ScalarError(
            f"{what}; the conditions must be linear in the unknowns, as velocities are in rates"
        )

    def _each(self, change):
        return LinearForm(change(self.value), map(change, self.coefficients))

    def __add__(self, other):
        if isinstance(other, LinearForm):
            return LinearForm(
                self.value + other.value,
                (a + b for a, b in zip(self.coefficients, other.coefficients, strict=True)),
            )
        if outranks(other, self):
            return NotImplemented
        return LinearForm(self.value + scalar(other), self.coefficients)

    __radd__ = __add__

    def __neg__(self):
        return self._each(lambda x: -x)

    def __sub__(self, other):
        return self + -other

    def __rsub__(self, other):
        return -self + other

    def __mul__(self, other):
        if other is ZERO:
            return ZERO
        if isinstance(other, Scaled) or outranks(other, self):
            return NotImplemented
        if isinstance(other, LinearForm):
            self._refuse("two unknowns are multiplied")
        return self._each(lambda x: x * other)

    __rmul__ = __mul__

    def __truediv__(self, other):
        if isinstance(other, LinearForm):
            return other.__rtruediv__(self)
        return NotImplemented if outranks(other, self) else self._each(lambda x: x / other)

    def __rtruediv__(self, other):
        self._refuse("an unknown stands in a denominator")

    def function(self, name, *args):
        """The function of this name, for :func:`function`."""
        self._refuse(f"{name} is taken of an unknown")

    def __pow__(self, power):
        self._refuse("an unknown is raised to a power")

    def pi(self):
        """The number pi in the kind of the value."""
        return pi(self.value)


# -- a few rates


def solve_rates(conditions, count):
    """The unknown rates that make ``conditions`` vanish: rolling without slip, meshing gears,
    joints (4.4, 4.9).

    conditions : a function of ``count`` rates that returns what must be zero (scalars, Vectors, or
        a tuple of them), linear in the rates, as every velocity is
    Returns a tuple of ``count`` scalars, of the kind of the conditions. There may be more
    conditions than rates if they agree. Raises :class:`FrameError` if the conditions leave a rate
    open or contradict each other, and :class:`ScalarError` if they are not linear in the rates. For
    equations with names, and a report, see :func:`solve_linear`.

    >>> from newton_euler import Frame, moving
    >>> ground = Frame("ground")
    >>> def slip(spin):  # a wheel of radius 0.5 whose centre moves at 2 along x
    ...     wheel = ground.rotate("wheel", "y", rate=spin, origin=ground.point("C", moving(0.0, rate=2.0), 0, 0.5))
    ...     return wheel.point("contact", 0, 0, -0.5).velocity(ground)
    >>> solve_rates(slip, 1)
    (4.0,)
    """
    equations = _equations(conditions(*_unknowns(count)), count)
    largest = _largest(c for e in equations for c in e.coefficients)
    # others are rounding
    used = [
        e
        for e in equations
        if any(not is_numeric(c) or size(c) > RATE_NOISE * largest for c in e.coefficients)
    ]
    if len(used) < count:
        raise LinearError(
            f"{len(used)} conditions contain the rates, but {count} rates are unknown: "
            f"{count - len(used)} more are needed"
        )
    rows = [e.parts() for e in used]
    # agreeing surplus conditions: the normal equations, which any kind of scalar can solve
    if len(used) > count:
        rows = [
            [sum((row[a] * row[b] for row in rows), ZERO) for b in range(count + 1)]
            for a in range(count)
        ]
    rates = _cramer([row[:count] for row in rows], [row[count] for row in rows])
    _check_solution(equations, rates)
    return tuple(plain(r) for r in rates)


def _unknowns(count):
    return [LinearForm(ZERO, (1 if n == m else ZERO for m in range(count))) for n in range(count)]


def _largest(values):
    return max((size(x) for x in values if is_numeric(x)), default=0.0)


def _cramer(matrix, right):
    """Linear equations over scalars of any kind: Cramer's rule, which needs neither a pivot nor a
    comparison.
    """
    everything = tuple(range(len(matrix)))

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

    def cofactor(n, k):
        return (-1) ** (n + k) * minor(
            everything[:n] + everything[n + 1 :], everything[:k] + everything[k + 1 :]
        )

    determinant = minor(everything, everything)
    if determinant is ZERO or (
        is_numeric(determinant)
        and least(determinant) <= RATE_NOISE * prod(_largest(row) or 1 for row in matrix)
    ):
        raise LinearError(
            "the conditions do not determine the rates: some of them say the same, or a rate "
            "does not occur in them"
        )
    # cofactor by determinant first: what is common to both cancels in a formula without being
    # simplified
    return [
        sum((cofactor(n, k) / determinant * right[n] for n in everything), ZERO) for k in everything
    ]


def _check_solution(equations, rates):
    rows = [
        [*(c * r for c, r in zip(e.coefficients, rates, strict=True)), -e.right] for e in equations
    ]
    parts = [x for row in rows for x in row]
    if all(map(is_numeric, parts)) and (
        worst := _largest(sum(row, ZERO) for row in rows)
    ) > AGREEMENT * _largest(parts):
        raise LinearError(
            "the conditions contradict each other: with the rates that fit best, one of them "
            f"is {worst:.3g} instead of 0"
        )


# -- many unknowns, equations with names


@dataclass(frozen=True)
class Solution:
    """What :func:`solve_linear` found; ``print`` it for a report in words.

    ``s.alpha`` or ``s["alpha"]`` is an unknown's value; asking for one that the equations leave
    open raises :class:`LinearError`. Iterating gives the values in the order of the unknowns.

    names : the unknowns
    values : those that are determined, by name
    undetermined : the names of the others
    relations : sentences, as "A_x = 3 - B_x", that are all the equations say of those (for numbers)
    redundant : by name, the equations that follow from others, with the names of these
    """

    names: tuple
    values: Mapping
    undetermined: tuple = ()
    relations: tuple = ()
    redundant: Mapping = field(default_factory=dict)

    def __getitem__(self, name):
        if name in self.values:
            return self.values[name]
        if name not in self.names:
            raise LinearError(f"there is no unknown {name!r}; there are {', '.join(self.names)}")
        raise LinearError(f"{name} is not determined by the equations. {self.report()}")

    def __getattr__(self, name):
        if name.startswith("__"):
            raise AttributeError(name)
        return self[name]

    def __iter__(self):
        return (self[name] for name in self.names)

    def __len__(self):
        return len(self.names)

    def report(self):
        """In words, what the equations leave open and which of them say nothing new."""
        said = []
        if self.undetermined:
            known = f": only {' and '.join(self.relations)} is known" if self.relations else ""
            said.append(
                f"Not determined: {', '.join(self.undetermined)}{known}; more equations are "
                "needed, or fewer unknowns"
            )
        for name, others in self.redundant.items():
            said.append(
                f"The equation {name!r} says nothing new: it follows from {_quoted(others)}"
            )
        return (
            ". ".join(said) or "The equations determine every unknown, and each of them is needed"
        )

    def __str__(self):
        lines = [
            f"{name} = {short(self.values[name]) if name in self.values else 'not determined'}"
            for name in self.names
        ]
        return "\n".join([*lines, self.report()])


def solve_linear(conditions, names=None):
    """The unknown accelerations, forces and rates that make named equations vanish, with a report:
    a :class:`Solution`.

    conditions : a function of the unknowns that returns what must be zero, linear in them: best a
        dict of scalars and Vectors by the name of the equation (a Vector is three equations, as
        "force.x"); or a tuple, or one of them. Each equation may have its own unit
    names : of the unknowns, in the order of the arguments, as "a N alpha" or a tuple; default: the
        names of the arguments

    Numbers are eliminated equation by equation, with a choice of pivots: what follows from the
    equations before it is named in ``redundant``, what contradicts them raises :class:`LinearError`
    with the names of those concerned, and what is left open is in ``undetermined``. Arrays are
    solved for all instants. Expressions give formulas, without simplification: unknowns that stand
    alone first, the rest by Cramer's rule. Whether SymPy's vanish is seen at a point, with numbers
    in the place of the symbols; traced and heyoka expressions and dimensions are taken to vanish
    only where they do by their form, and of those surplus equations are not compared.

    >>> def laws(N, F, a):  # a block of 2 kg on a slope of 0.3 rad that slides: along it, across it, friction
    ...     return {"along": 2.0*a - 2.0*9.81*sin(0.3) + F, "across": N - 2.0*9.81*cos(0.3), "friction": F - 0.1*N}
    >>> from newton_euler import cos, sin
    >>> s = solve_linear(laws)
    >>> round(s.a, 6), round(s.N, 6)
    (1.961868, 18.743702)
    >>> print(solve_linear(lambda A, B: {"force": A + B - 3.0}))
    A = not determined
    B = not determined
    Not determined: A, B: only A = 3 - B is known; more equations are needed, or fewer unknowns
    """
    names = _names(conditions, names)
    equations = _equations(conditions(*_unknowns(len(names))), len(names))
    return _solved([e for e in equations if not all(map(is_zero, e.parts()))], names)


def _solved(equations, names):
    samples, faithful = _samples(equations)
    numbers = all(
        a is b
        for e, s in zip(equations, samples, strict=True)
        for a, b in zip(e.parts(), s.parts(), strict=True)
    )
    try:
        found = _Elimination(samples, len(names), faithful, numbers)
    except _Varies:
        return _instant_by_instant(equations, names)
    values = found.values if numbers else _of_expressions(equations, found)
    return Solution(
        tuple(names),
        MappingProxyType({names[k]: plain(values[k]) for k in sorted(values)}),
        tuple(names[k] for k in found.open),
        tuple(found.relations(names)) if numbers else (),
        MappingProxyType(found.redundant()),
    )


def _names(conditions, names):
    if names is None:
        parameters = signature(conditions).parameters.values()
        names = [
            p.name
            for p in parameters
            if p.default is p.empty and p.kind in (p.POSITIONAL_ONLY, p.POSITIONAL_OR_KEYWORD)
        ]
    names = names.replace(",", " ").split() if isinstance(names, str) else list(names)
    twice = [n for n in names if names.count(n) > 1]
    if twice or not names:
        why = (
            f"the unknown {twice[0]!r} is named twice"
            if twice
            else "there are no unknowns: name them, as in solve_linear(laws, 'a N alpha')"
        )
        raise LinearError(why)
    return names


@dataclass(frozen=True)
class _Equation:
    """The sum of coefficient times unknown is ``right``. ``group`` numbers the condition, of which
    a Vector makes three equations.
    """

    name: str
    coefficients: tuple
    right: object
    group: int

    def parts(self):
        return (*self.coefficients, self.right)

    def each(self, change):
        return _Equation(
            self.name, tuple(map(change, self.coefficients)), change(self.right), self.group
        )


def _equations(conditions, count):
    """The conditions as equations with names: "force" of a scalar, "force.x" of a Vector, numbers
    for those without a name.
    """
    if isinstance(conditions, Mapping):
        named = list(conditions.items())
    else:
        named = [
            (f"equation {n + 1}", x)
            for n, x in enumerate(
                conditions if isinstance(conditions, (tuple, list)) else (conditions,)
            )
        ]
    return [
        _equation(name, x, group, count)
        for group, (title, value) in enumerate(named)
        for name, x in _spread(title, value)
    ]


def _spread(name, value):
    if isinstance(value, Vector):
        return [(f"{name}.{axis}", scalar(x)) for axis, x in zip("xyz", value.c, strict=True)]
    if isinstance(value, (tuple, list)):
        return [pair for n, part in enumerate(value) for pair in _spread(f"{name}.{n + 1}", part)]
    return [(name, scalar(value))]


def _equation(name, x, group, count):
    return (
        _Equation(name, x.coefficients, -x.value, group)
        if isinstance(x, LinearForm)
        else _Equation(name, (ZERO,) * count, -x, group)
    )


def _samples(equations):
    """The equations with numbers in the place of expressions, and whether they stand for their
    values (else: for any value).
    """
    made_up = {}

    def number(x):
        known = sampled(x)
        return (
            made_up.setdefault(id(x), (0.37 + 0.6180339887 * len(made_up)) % 1 + 0.5)
            if known is None
            else known
        )

    return [e.each(number) for e in equations], not made_up


# -- numbers: equation by equation


class _Varies(Exception):
    """No unknown can serve as the pivot at all instants of the arrays."""


def _less(row, factor, other, pivot):
    """The row less ``factor`` times another, in which the pivot is 1."""
    row = [a - factor * b for a, b in zip(row, other, strict=True)]
    row[pivot] = ZERO
    return row


class _Elimination:
    """Equations of numbers, taken one after the other: what is new gives a pivot, what is not must
    agree.

    A row is a sum of equations: its coefficients, its right side, and how much of each equation is
    in it. ``rows`` has them by the unknown that is their pivot, with 1 there, ``dependent`` those
    without by the number of the last equation. Sizes are compared unknown by unknown (in ``scale``)
    and within a condition (``usual``, for each equation), so that units do not matter; a few
    round-offs count as nothing.
    """

    def __init__(self, equations, count, faithful, numbers):
        self.equations, self.count, self.numbers = equations, count, numbers
        self.round_off = float(coarseness([x for e in equations for x in e.parts()]))
        self.scale = self._scales()
        self.usual = self._by_group([self._relative(e.coefficients) for e in equations])
        self.rows, self.dependent = {}, {}
        for n in range(len(equations)):
            self._take(n)
        self.free = {pivot: self._free(pivot, row) for pivot, row in self.rows.items()}
        self.values = {
            pivot: row[count] for pivot, row in self.rows.items() if not self.free[pivot]
        }
        self.open = [k for k in range(count) if k not in self.values]
        for row in self.dependent.values() if faithful else ():
            self._check(row)

    def _by_group(self, values):
        """For each equation the largest of its values and of those of the same condition."""
        largest = {}
        for e, own in zip(self.equations, values, strict=True):
            largest[e.group] = max(largest.get(e.group, 0.0), _largest(own))
        return [largest[e.group] for e in self.equations]

    def _scales(self):
        """The size of the coefficients of each unknown; 0 if there are none but rounding errors."""
        noise = [
            LEFT_OVER * self.round_off * x
            for x in self._by_group([e.coefficients for e in self.equations])
        ]
        columns = zip(*(e.coefficients for e in self.equations), strict=True)
        return [
            max(
                (size(x) for x, small in zip(c, noise, strict=True) if size(x) > small), default=0.0
            )
            for c in columns
        ] or [0.0] * self.count

    def _relative(self, row, measure=size):
        """The size of the coefficients of a row, each relative to what is usual for its unknown."""
        return [
            measure(x) / s if s and x is not ZERO else 0.0
            for x, s in zip(row, self.scale, strict=False)
        ]

    def _take(self, n):
        row, usual = (
            [
                *self.equations[n].parts(),
                *(int(n == m) or ZERO for m in range(len(self.equations))),
            ],
            self.usual[n],
        )
        for pivot, other in self.rows.items():
            if (factor := row[pivot]) is not ZERO:
                row = _less(row, factor, other, pivot)
                usual = max(usual, *self._relative([factor * x for x in other[: self.count]]))
        pivot = self._pivot(row, NO_PIVOT * self.round_off * usual)
        if pivot is None:
            self.dependent[n] = row
            return
        row = [x / row[pivot] for x in row]
        row[pivot] = 1
        self.rows = {
            k: r if r[pivot] is ZERO else _less(r, r[pivot], row, pivot)
            for k, r in self.rows.items()
        } | {pivot: row}

    def _pivot(self, row, noise):
        """The unknown with the largest coefficient at every instant; None if all are rounding
        errors.
        """
        smallest = self._relative(row, least)
        best = max(range(self.count), key=smallest.__getitem__)
        if smallest[best] > noise:
            return best
        if max(self._relative(row)) > noise:
            raise _Varies
        return None

    def _free(self, pivot, row):
        """The unknowns beside the pivot in a row."""
        allowed = ABSENT * self.round_off / self.scale[pivot]
        return [
            k for k, s in enumerate(self.scale) if k != pivot and s and size(row[k]) / s > allowed
        ]

    def _check(self, row):
        involved = self._involved(row)
        terms = [
            [
                e.right,
                *(c * self.values[k] for k, c in enumerate(e.coefficients) if k in self.values),
            ]
            for e in self.equations
        ]
        sizes = self._by_group(terms)
        own = max(size(row[self.count + 1 + n]) * sizes[n] for n in involved)
        difference = size(row[self.count])
        if difference <= CONTRADICTION * self.round_off * own + NO_PIVOT * self.round_off * max(
            sizes
        ):
            return
        *others, name = names = [self.equations[n].name for n in involved]
        off = f"is off by {difference:.3g}" if self.numbers else "does not hold"
        if not others:
            raise LinearError(f"the equation {name!r} {off}: no unknown occurs in it", names)
        raise LinearError(
            f"the equations contradict each other: {name!r} {off} if {_quoted(others)} "
            f"hold{'s' * (len(others) == 1)}",
            names,
        )

    def _involved(self, row):
        """The equations of which a row is the sum, in their order."""
        weights = {
            n: size(w) * self.usual[n] for n, w in enumerate(row[self.count + 1 :]) if w is not ZERO
        }
        return [
            n for n, w in weights.items() if w >= ABSENT * self.round_off * max(weights.values())
        ]

    def relations(self, names):
        """What is known of the unknowns that are not determined, in words."""
        for pivot, free in self.free.items():
            row = self.rows[pivot][: self.count + 1]
            if free and not any(getattr(x, "shape", ()) for x in row):
                yield f"{names[pivot]} = {short(row[self.count])}" + "".join(
                    _term(row[k], names[k]) for k in free
                )

    def redundant(self):
        """By name, the equations that follow from others."""
        found = (
            [self.equations[n].name for n in self._involved(row)] for row in self.dependent.values()
        )
        return {last: tuple(others) for *others, last in found if others}


def _term(coefficient, name):
    c = float(coefficient)
    return f" {'-' if c > 0 else '+'} {'' if abs(c) == 1 else f'{abs(c):.6g} '}{name}"


def _instant_by_instant(equations, names):
    """Arrays that have no common pivot: each instant by itself, then together again."""
    import numpy as np

    shape = np.broadcast_shapes(*(np.shape(x) for e in equations for x in e.parts()))
    every = [
        _solved(
            [
                e.each(lambda x: np.broadcast_to(x, shape)[n] if np.shape(x) else x)  # noqa: B023
                for e in equations
            ],
            names,
        )
        for n in np.ndindex(shape)
    ]
    kinds = {s.undetermined for s in every}
    if len(kinds) > 1:
        left = sorted({name for kind in kinds for name in kind})
        raise LinearError(
            f"the equations determine {', '.join(left)} at some instants and not at others; "
            "solve these instants apart"
        )
    values = {
        name: np.array([float(s.values[name]) for s in every]).reshape(shape)
        for name in every[0].values
    }
    redundant = {name: others for s in every for name, others in s.redundant.items()}
    return Solution(
        tuple(names),
        MappingProxyType(values),
        every[0].undetermined,
        (),
        MappingProxyType(redundant),
    )


# -- expressions: what stands alone first, the rest by Cramer's rule


def _of_expressions(equations, found):
    """The determined unknowns as formulas, from the equations that the elimination of numbers in
    their place found to be independent.
    """
    rows = [
        (
            {
                k: c
                for k, c in enumerate(e.coefficients)
                if k in found.rows and c is not ZERO and size(_sample_or_one(c))
            },
            e.right,
        )
        for n, e in enumerate(equations)
        if n not in found.dependent
    ]
    return {k: x for k, x in solve_regular(rows).items() if k in found.values}


def _sample_or_one(x):
    """A number for ``x``; 1 if its value cannot be known."""
    known = sampled(x)
    return 1.0 if known is None else known


def solve_regular(rows):
    """The unknowns by number, from as many independent equations, each a pair (coefficients by
    unknown, right side).

    One unknown after the other is taken from the place that touches the fewest other places: best
    one that is known at once, or that occurs nowhere else and follows when the others are known.
    Where there is none of these and few unknowns are left, they are found by Cramer's rule.
    """
    if not rows:
        return {}
    if not all(c for c, _ in rows):
        raise LinearError("the equations do not determine the unknowns: one of them contains none")
    occurring = Counter(k for c, _ in rows for k in c)

    def touched(place):
        n, k = place
        c = rows[n][0]
        return (len(c) - 1) * (occurring[k] - 1), len(c), -least(c[k]) if is_numeric(c[k]) else 1.0

    n, k = min(((n, k) for n, (c, _) in enumerate(rows) for k in c), key=touched)
    coefficients, right = rows[n]
    if min(len(coefficients), occurring[k]) > 1 and len(rows) <= LARGEST_CORE:
        unknowns = sorted(occurring)
        return dict(
            zip(
                unknowns,
                _cramer(
                    [[c.get(k, ZERO) for k in unknowns] for c, _ in rows], [b for _, b in rows]
                ),
                strict=True,
            )
        )
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


def _quoted(names):
    return " and ".join(
        [", ".join(map(repr, names[:-1])), repr(names[-1])] if len(names) > 1 else map(repr, names)
    )

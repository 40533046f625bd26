"""Linear equations for unknown rates, accelerations and reactions, over scalars of every kind, and what they leave open.

Velocities are linear in rates, the Newton-Euler equations (8.21) in accelerations and forces. The equations are written as what must vanish and
run on :class:`newton_euler.scalars.Linear` unknowns, which read off the coefficients, each in its own unit. :func:`solve_rates` is for the few rates
of a rolling contact or a joint; :func:`solve_linear` for whole sets of equations with names, and it reports what they leave open.
"""

from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cache
from inspect import signature
from types import MappingProxyType

from .scalars import ZERO, Linear, coarseness, is_numeric, is_zero, least, plain, sampled, scalar, size
from .vectors import FrameError, Vector

LARGEST_CORE = 6  # unknowns that are solved together by Cramer's rule; of more, one after the other is eliminated


class LinearError(FrameError):
    """Linear equations that contradict each other, or a question for an unknown that they leave open.

    equations : the names of the equations that are to blame
    """

    def __init__(self, message, equations=()):
        super().__init__(message)
        self.equations = tuple(equations)


# -- a few rates


def solve_rates(conditions, count):
    """The unknown rates that make ``conditions`` vanish: rolling without slip, meshing gears, joints (4.4, 4.9).

    conditions : a function of ``count`` rates that returns what must be zero (scalars, Vectors, or a tuple of them), linear in the
        rates, as every velocity is
    Returns a tuple of ``count`` scalars, of the kind of the conditions. There may be more conditions than rates if they agree. Raises
    :class:`FrameError` if the conditions leave a rate open or contradict each other, and :class:`ScalarError`
    if they are not linear in the rates. For equations with names, and a report, see :func:`solve_linear`.

    >>> from newton_euler import Frame, moving
    >>> ground = Frame("ground")
    >>> def slip(spin):  # a wheel of radius 0.5 whose centre moves at 2 along x
    ...     wheel = ground.rotate("wheel", "y", rate=spin, origin=ground.point("C", moving(0.0, rate=2.0), 0, 0.5))
    ...     return wheel.point("contact", 0, 0, -0.5).velocity(ground)
    >>> solve_rates(slip, 1)
    (4.0,)
    """
    rows = [(row.coefficients, row.right) for row in _equations(conditions(*_unknowns(count)), count)]
    largest = _largest(x for row, _ in rows for x in row)
    used = [row for row in rows if any(not is_numeric(x) or size(x) > 1e-13 * largest for x in row[0])]  # others are rounding
    if len(used) < count:
        raise LinearError(f"{len(used)} conditions contain the rates, but {count} rates are unknown: {count - len(used)} more are needed")
    if len(used) > count:  # agreeing surplus conditions: the normal equations, which any kind of scalar can solve
        used = [([_sum(m[a] * m[b] for m, _ in used) for b in range(count)], _sum(m[a] * c for m, c in used)) for a in range(count)]
    rates = _cramer([list(m) for m, _ in used], [c for _, c in used])
    _check_solution(rows, rates)
    return tuple(plain(r) for r in rates)


def _unknowns(count):
    return [Linear(ZERO, (1 if n == m else ZERO for m in range(count))) for n in range(count)]


def _sum(values):
    total = ZERO
    for v in values:
        total = total + v
    return total


def _largest(values):
    return max((size(x) for x in values if is_numeric(x)), default=0.0)


def _cramer(matrix, right):
    """Linear equations over scalars of any kind: Cramer's rule, which needs neither a pivot nor a comparison."""
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
        return (-1) ** (n + k) * minor(everything[:n] + everything[n + 1 :], everything[:k] + everything[k + 1 :])

    determinant = minor(everything, everything)
    scale = 1
    for row in matrix:
        scale *= _largest(row) or 1
    if determinant is ZERO or (is_numeric(determinant) and least(determinant) <= 1e-13 * scale):
        raise LinearError("the conditions do not determine the rates: some of them say the same, or a rate does not occur in them")
    # cofactor by determinant first: what is common to both cancels in a formula without being simplified
    return [_sum(cofactor(n, k) / determinant * right[n] for n in everything) for k in everything]


def _check_solution(rows, rates):
    terms = [[c * r for c, r in zip(coefficients, rates, strict=True)] for coefficients, _ in rows]
    parts = [x for row in terms for x in row] + [right for _, right in rows]
    if not all(map(is_numeric, parts)):
        return
    differences = [_sum(row) - right for row, (_, right) in zip(terms, rows, strict=True)]
    allowed = 1e-9 * _largest(parts)
    if (worst := _largest(differences)) > allowed:
        raise LinearError(f"the conditions contradict each other: with the rates that fit best, one of them is {worst:.3g} instead of 0")


# -- many unknowns, equations with names


@dataclass(frozen=True)
class Solution:
    """What :func:`solve_linear` found; ``print`` it for a report in words.

    ``s.alpha`` or ``s["alpha"]`` is an unknown's value; asking for one that the equations leave open raises :class:`LinearError`. Iterating
    gives the values in the order of the unknowns.

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
            said.append(f"Not determined: {', '.join(self.undetermined)}{known}; more equations are needed, or fewer unknowns")
        for name, others in self.redundant.items():
            said.append(f"The equation {name!r} says nothing new: it follows from {_quoted(others)}")
        return ". ".join(said) or "The equations determine every unknown, and each of them is needed"

    def __str__(self):
        lines = [f"{name} = {_short(self.values[name]) if name in self.values else 'not determined'}" for name in self.names]
        return "\n".join([*lines, self.report()])


def solve_linear(conditions, names=None):
    """The unknown accelerations, forces and rates that make named equations vanish, with a report: a :class:`Solution`.

    conditions : a function of the unknowns that returns what must be zero, linear in them: best a dict of scalars and Vectors by the name of the
        equation (a Vector is three equations, as "force.x"); or a tuple, or one of them. Each equation may have its own unit
    names : of the unknowns, in the order of the arguments, as "a N alpha" or a tuple; default: the names of the arguments

    Numbers are eliminated equation by equation, with a choice of pivots: what follows from the equations before it is named in ``redundant``, what
    contradicts them raises :class:`LinearError` with the names of those concerned, and what is left open is in ``undetermined``. Arrays are solved
    for all instants. Expressions give formulas, without simplification: unknowns that stand alone first, the rest by Cramer's rule. Whether
    SymPy's vanish is seen at a point, with numbers in the place of the symbols; traced and heyoka expressions and dimensions are taken to vanish
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
    equations = [e for e in _equations(conditions(*_unknowns(len(names))), len(names)) if not e.says_nothing()]
    samples, faithful = _samples(equations)
    numbers = all(a is b for e, s in zip(equations, samples, strict=True) for a, b in zip(e.parts(), s.parts(), strict=True))
    try:
        found = _Elimination(samples, len(names), faithful, numbers)
    except _Varies:
        return _instant_by_instant(equations, names)
    values = found.values() if numbers else _of_expressions(equations, found)
    return Solution(
        tuple(names),
        MappingProxyType({names[k]: plain(values[k]) for k in sorted(values)}),
        tuple(names[k] for k in found.open()),
        tuple(found.relations(names)) if numbers else (),
        MappingProxyType(found.redundant()),
    )


def _names(conditions, names):
    if names is None:
        parameters = signature(conditions).parameters.values()
        names = [p.name for p in parameters if p.default is p.empty and p.kind in (p.POSITIONAL_ONLY, p.POSITIONAL_OR_KEYWORD)]
    names = names.replace(",", " ").split() if isinstance(names, str) else list(names)
    twice = [n for n in names if names.count(n) > 1]
    if twice or not names:
        why = f"the unknown {twice[0]!r} is named twice" if twice else "there are no unknowns: name them, as in solve_linear(laws, 'a N alpha')"
        raise LinearError(why)
    return names


@dataclass(frozen=True)
class _Equation:
    """The sum of coefficient times unknown is ``right``. ``group`` numbers the condition, of which a Vector makes three equations."""

    name: str
    coefficients: tuple
    right: object
    group: int

    def parts(self):
        return (*self.coefficients, self.right)

    def says_nothing(self):
        return all(is_zero(x) for x in self.parts())


def _equations(conditions, count):
    """The conditions as equations with names: "force" of a scalar, "force.x" of a Vector, numbers for those without a name."""
    if isinstance(conditions, Mapping):
        named = list(conditions.items())
    else:
        named = [(f"equation {n + 1}", x) for n, x in enumerate(conditions if isinstance(conditions, (tuple, list)) else (conditions,))]
    return [_equation(name, x, group, count) for group, (title, value) in enumerate(named) for name, x in _spread(title, value)]


def _spread(name, value):
    if isinstance(value, Vector):
        return [(f"{name}.{axis}", scalar(x)) for axis, x in zip("xyz", value.c, strict=True)]
    if isinstance(value, (tuple, list)):
        return [pair for n, part in enumerate(value) for pair in _spread(f"{name}.{n + 1}", part)]
    return [(name, scalar(value))]


def _equation(name, x, group, count):
    return _Equation(name, x.coefficients, -x.value, group) if isinstance(x, Linear) else _Equation(name, (ZERO,) * count, -x, group)


def _samples(equations):
    """The equations with numbers in the place of expressions, and whether they stand for their values (else: for any value)."""
    made_up = {}

    def number(x):
        known = sampled(x)
        if known is None:
            known = made_up.setdefault(id(x), (0.37 + 0.6180339887 * len(made_up)) % 1 + 0.5)
        return known

    samples = [_Equation(e.name, tuple(map(number, e.coefficients)), number(e.right), e.group) for e in equations]
    return samples, not made_up


# -- numbers: equation by equation


class _Varies(Exception):
    """No unknown can serve as the pivot at all instants of the arrays."""


@dataclass
class _Row:
    """An equation after the elimination: coefficients with 1 at the pivot, right side, and how much of each equation is in it."""

    pivot: int
    coefficients: list
    right: object
    weights: dict

    def less(self, other, factor):
        """This row less ``factor`` times another."""
        weights = dict(self.weights)
        for n, w in other.weights.items():
            weights[n] = weights.get(n, ZERO) - factor * w
        coefficients = [a - factor * b for a, b in zip(self.coefficients, other.coefficients, strict=True)]
        coefficients[other.pivot] = ZERO
        return _Row(self.pivot, coefficients, self.right - factor * other.right, weights)

    def over(self, pivot):
        """This row with 1 at the pivot."""
        p = self.coefficients[pivot]
        coefficients = [x / p for x in self.coefficients]
        coefficients[pivot] = 1
        return _Row(pivot, coefficients, self.right / p, {n: w / p for n, w in self.weights.items()})


class _Elimination:
    """Equations of numbers, taken one after the other: what is new gives a pivot, what is not must agree.

    Sizes are compared unknown by unknown (in ``scale``) and within a condition, so that units do not matter; a few round-offs count as nothing.
    """

    def __init__(self, equations, count, faithful=True, numbers=True):
        self.equations, self.count, self.numbers = equations, count, numbers
        self.round_off = float(coarseness([x for e in equations for x in e.parts()]))
        self.scale = self._scales()
        self.rows, self.dependent = [], []
        for n in range(len(equations)):
            self._take(n)
        if faithful:
            for row in self.dependent:
                self._check(row)

    def _scales(self):
        """The size of the coefficients of each unknown; 0 if there are none but rounding errors."""
        largest = {}
        for e in self.equations:
            largest[e.group] = max(largest.get(e.group, 0.0), _largest(e.coefficients))
        scale = [0.0] * self.count
        for e in self.equations:
            for k, x in enumerate(e.coefficients):
                if size(x) > 16 * self.round_off * largest[e.group]:
                    scale[k] = max(scale[k], size(x))
        return scale

    def _relative(self, coefficients, measure=size):
        """The size of the coefficients of a row, each relative to what is usual for its unknown."""
        return [measure(x) / s if s and x is not ZERO else 0.0 for x, s in zip(coefficients, self.scale, strict=True)]

    def _usual(self, n):
        """The size of the coefficients in the condition that the equation belongs to."""
        return max(max(self._relative(e.coefficients), default=0.0) for e in self.equations if e.group == self.equations[n].group)

    def _take(self, n):
        equation = self.equations[n]
        row = _Row(-1, list(equation.coefficients), equation.right, {n: 1})
        usual = self._usual(n)
        for other in self.rows:
            if (factor := row.coefficients[other.pivot]) is not ZERO:
                row = row.less(other, factor)
                usual = max(usual, max(self._relative([factor * x for x in other.coefficients])))
        if (pivot := self._pivot(row, 4096 * self.round_off * usual)) is None:
            self.dependent.append(row)
            return
        row = row.over(pivot)
        self.rows = [r.less(row, r.coefficients[pivot]) if r.coefficients[pivot] is not ZERO else r for r in self.rows] + [row]

    def _pivot(self, row, noise):
        """The unknown with the largest coefficient at every instant; None if all are rounding errors."""
        smallest = self._relative(row.coefficients, least)
        best = max(range(self.count), key=smallest.__getitem__)
        if smallest[best] > noise:
            return best
        if max(self._relative(row.coefficients)) > noise:
            raise _Varies
        return None

    def _check(self, row):
        involved = self._involved(row)
        values = self.values()
        terms = {e.name: [e.right, *(c * values[k] for k, c in enumerate(e.coefficients) if k in values)] for e in self.equations}
        by_group = {}
        for e in self.equations:
            by_group[e.group] = max(by_group.get(e.group, 0.0), _largest(terms[e.name]))
        own = max(size(row.weights[n]) * by_group[self.equations[n].group] for n in involved)
        allowed = 2**22 * self.round_off * own + 4096 * self.round_off * max(by_group.values())
        if size(row.right) > allowed:
            self._contradiction([self.equations[n].name for n in involved], size(row.right))

    def _contradiction(self, names, difference):
        *others, name = names
        off = f"is off by {difference:.3g}" if self.numbers else "does not hold"
        if not others:
            raise LinearError(f"the equation {name!r} {off}: no unknown occurs in it", names)
        raise LinearError(f"the equations contradict each other: {name!r} {off} if {_quoted(others)} hold{'s' * (len(others) == 1)}", names)

    def _involved(self, row):
        """The equations of which a row is the sum, in their order."""
        heaviest = max(self._weight(*pair) for pair in row.weights.items())
        return [n for n, w in sorted(row.weights.items()) if self._weight(n, w) >= 2**19 * self.round_off * heaviest]

    def _weight(self, n, w):
        return size(w) * self._usual(n)

    # -- what it found

    def _free(self, row):
        """The unknowns beside the pivot in a row."""
        allowed = 2**19 * self.round_off / self.scale[row.pivot]
        return [k for k, x in enumerate(row.coefficients) if k != row.pivot and self.scale[k] and size(x) / self.scale[k] > allowed]

    def open(self):
        """The unknowns that are not determined."""
        determined = {row.pivot for row in self.rows if not self._free(row)}
        return [k for k in range(self.count) if k not in determined]

    def values(self):
        """The unknowns that are."""
        return {row.pivot: row.right for row in self.rows if not self._free(row)}

    def relations(self, names):
        """What is known of the unknowns that are not determined, in words."""
        for row in self.rows:
            if (free := self._free(row)) and not any(getattr(x, "shape", ()) for x in (row.right, *row.coefficients)):
                yield f"{names[row.pivot]} = {_short(row.right)}" + "".join(_term(row.coefficients[k], names[k]) for k in free)

    def redundant(self):
        """By name, the equations that follow from others."""
        out = {}
        for row in self.dependent:
            *others, last = (self.equations[n].name for n in self._involved(row))
            out[last] = tuple(others)
        return {name: others for name, others in out.items() if others}


def _term(coefficient, name):
    c = float(coefficient)
    return f" {'-' if c > 0 else '+'} {'' if abs(c) == 1 else f'{abs(c):.6g} '}{name}"


def _instant_by_instant(equations, names):
    """Arrays that have no common pivot: each instant by itself, then together again."""
    import numpy as np

    shape = np.broadcast_shapes(*(np.shape(x) for e in equations for x in e.parts()))

    def instant(x, n):
        return x if x is ZERO or not np.shape(x) else np.broadcast_to(x, shape)[n]

    solved = []
    for n in np.ndindex(shape):
        now = [_Equation(e.name, tuple(instant(x, n) for x in e.coefficients), instant(e.right, n), e.group) for e in equations]
        solved.append(_Elimination(now, len(names)))
    kinds = {tuple(s.open()) for s in solved}
    if len(kinds) > 1:
        left = sorted({names[k] for kind in kinds for k in kind})
        raise LinearError(f"the equations determine {', '.join(left)} at some instants and not at others; solve these instants apart")
    values = [s.values() for s in solved]
    together = {k: np.array([float(v[k]) for v in values]).reshape(shape) for k in sorted(values[0])}
    redundant = {name: others for s in solved for name, others in s.redundant().items()}
    left = tuple(names[k] for k in solved[0].open())
    return Solution(tuple(names), MappingProxyType({names[k]: x for k, x in together.items()}), left, (), MappingProxyType(redundant))


# -- expressions: what stands alone first, the rest by Cramer's rule


def _of_expressions(equations, found):
    """The determined unknowns as formulas, from the equations that the elimination of numbers in their place found to be independent."""
    surplus = {max(row.weights) for row in found.dependent}
    pivots = {row.pivot for row in found.rows}
    rows = []
    for n, e in enumerate(equations):
        if n not in surplus:
            rows.append(({k: c for k, c in enumerate(e.coefficients) if k in pivots and c is not ZERO and size(_sample_or_one(c))}, e.right))
    values = solve_regular(rows)
    return {k: x for k, x in values.items() if k not in found.open()}


def _sample_or_one(x):
    """A number for ``x``; 1 if its value cannot be known."""
    known = sampled(x)
    return 1.0 if known is None else known


def solve_regular(rows):
    """The unknowns by number, from as many independent equations, each a pair (coefficients by unknown, right side)."""
    if not rows:
        return {}
    n = min(range(len(rows)), key=lambda n: len(rows[n][0]))
    if not rows[n][0]:
        raise LinearError("the equations do not determine the unknowns: one of them contains none")
    if len(rows[n][0]) == 1:
        return _known_first(rows, n)
    occurrences = {}
    for m, (coefficients, _) in enumerate(rows):
        for k in coefficients:
            occurrences.setdefault(k, []).append(m)
    alone = [(k, ms[0]) for k, ms in occurrences.items() if len(ms) == 1]
    if alone:
        return _left_for_last(rows, *alone[0])
    if len(rows) > LARGEST_CORE:
        return _one_eliminated(rows, n)
    unknowns = sorted(occurrences)
    return dict(zip(unknowns, _cramer([[c.get(k, ZERO) for k in unknowns] for c, _ in rows], [b for _, b in rows]), strict=True))


def _known_first(rows, n):
    """The equation n has one unknown: its value goes into the others."""
    ((k, p),) = rows[n][0].items()
    value = rows[n][1] / p
    rest = [(_without(c, k), b - c[k] * value if k in c else b) for m, (c, b) in enumerate(rows) if m != n]
    return {k: value, **solve_regular(rest)}


def _left_for_last(rows, k, n):
    """The unknown k occurs in the equation n alone: it follows when the others are known."""
    values = solve_regular([row for m, row in enumerate(rows) if m != n])
    coefficients, right = rows[n]
    value = right - _sum(c * values[j] for j, c in coefficients.items() if j != k)
    return {**values, k: value / coefficients[k]}


def _one_eliminated(rows, n):
    """One unknown of the equation n expressed by the others: that with a plain number before it, if there is one."""
    coefficients, right = rows[n]
    k = max(coefficients, key=lambda k: (is_numeric(coefficients[k]), abs(_sample_or_one(coefficients[k]))))
    p, rest = coefficients[k], []
    for m, (c, b) in enumerate(rows):
        if m != n and k in c:
            c, f = dict(c), c[k] / p
            for j, x in coefficients.items():
                c[j] = c.get(j, ZERO) - f * x
            b = b - f * right
        if m != n:
            rest.append((_without(c, k), b))
    return _left_for_last([(coefficients, right), *rest], k, 0)


def _without(coefficients, k):
    return {j: x for j, x in coefficients.items() if j != k}


def _quoted(names):
    return " and ".join([", ".join(map(repr, names[:-1])), repr(names[-1])] if len(names) > 1 else map(repr, names))


def _short(x):
    return f"{float(x):.6g}" if is_numeric(x) and not getattr(x, "shape", ()) else str(x)

"""What a traced computation gives with one slip in it, for all slips at once, and which of them a
wrong answer meets more closely than by chance.

**The test.** A slip is at a distance ``gap`` from an answer, no less than what the answer was
rounded by. Of the slips that are as simple or simpler, ``n`` are within a quarter of the size of
the answer; in the ``d`` components in which it differs from the key, a random answer at this place
would be as near to one of them with the chance ``n (gap / a quarter)^d``. A slip is named where
that is at most half a percent.
"""

import math
from collections.abc import Iterable, Mapping, Sequence
from functools import cached_property
from typing import Any, NamedTuple

from ..algebra.compile import Compiled
from ..algebra.scalars import to_plain
from ..algebra.source import WITHIN, operations
from ..algebra.trace import Inner, Step
from ..algebra.units import SI, System
from .causes import Cause
from .edits import Edit, edits_of, steps_in
from .fit import Fit
from .kinds import Kind
from .tolerance import NOISE, ROUND_OFF, Points

AROUND = 0.25  # of the size of an answer: where slips are counted
CHANCE = 0.01  # by which a random answer may meet a slip that is named, where slips are many
CHANCE_ROUNDED = 0.0005  # the same where it differs by more than the digits written
CHANCE_BESIDE = 0.05  # the same where some of its components are right


class Traced(NamedTuple):
    """An answer of a traced computation: [(component, factor to its unit)], and the number of
    points at which it is compared.
    """

    parts: Sequence[tuple[Any, float]]
    points: int


class Computation:
    """A traced computation: the steps that its answers need, and the slips in it."""

    def __init__(
        self,
        answers: Mapping[str, Traced],
        units: Mapping[str, str],
        system: System,
    ):
        self.answers = answers
        self.steps = needed(x for traced in answers.values() for x, _ in traced.parts)
        self.edits: list[Edit] = edits_of(
            self.steps, [[x for x, _ in a.parts] for a in answers.values()], units, system
        )
        self.places: dict[Cause, list[int]] = {}
        self.own: dict[int, tuple[list[int], list[Any]]] = {}  # of a step: edits, expressions
        for n, edit in enumerate(self.edits):
            self.places.setdefault(edit.cause, []).append(n)
            for number, expression in edit.instead.items():
                lanes, expressions = self.own.setdefault(number, ([], []))
                lanes.append(n)
                expressions.append(expression)
        self.run = {
            a: Compiled("the formula inside", a.parameters, a.trace, a.leaves)
            for s in self.steps
            for a in s.args
            if isinstance(a, Inner)
        }

    @cached_property
    def ranks(self) -> Any:
        """How simple each is, as an array."""
        from numpy import array

        return array([e.rank for e in self.edits])


def needed(leaves: Iterable[Any]) -> list[Step]:
    """The steps that these need, in order."""
    waiting, found = [x for x in leaves if isinstance(x, Step)], {}
    while waiting:
        s = waiting.pop()
        if s.number not in found:
            found[s.number] = s
            waiting += steps_in(s)
    return [found[n] for n in sorted(found)]


class Perturbed:
    """A computation with each slip, for the numbers of one student, arrays for symbols."""

    def __init__(self, computation: Computation, values: Mapping[str, Any]):
        self.computation, self.values = computation, values

    @cached_property
    def _rows(self):
        """{answer: array (slips, points, components)}."""
        import numpy as np

        with np.errstate(all="ignore"):
            lanes = _Lanes(self.computation, self.values)
            rows = {s.number: lanes.row(s) for s in self.computation.steps}
        count = len(self.computation.edits)
        found = {}
        for key, (parts, points) in self.computation.answers.items():
            columns = [f * (rows[x.number] if isinstance(x, Step) else float(x)) for x, f in parts]
            # a number has one point, beside formulas too
            one = [c[..., :points] if np.ndim(c) else c for c in columns]
            found[key] = np.stack([np.broadcast_to(c, (count, points)) for c in one], axis=-1)
        return found

    def of(self, key: str, cause: Cause) -> list[Points]:
        """What the slips of this cause make of an answer; none if it is no slip of this kind."""
        if key not in self.computation.answers:
            return []
        return [_points(self._rows[key][n]) for n in self.computation.places.get(cause, ())]

    def near(self, key: str, fit: Fit, kind: Kind) -> list[tuple[int, Cause, Points]]:
        """[(level, cause, points)] of the slips that an answer is nearer to than by chance."""
        import numpy as np

        edits = self.computation.edits
        if not edits or fit.index is None or not 0 < math.hypot(*fit.first[0]) < math.inf:
            return []
        rows = self._rows[key]
        with np.errstate(all="ignore"):
            if kind.is_formula:
                places = _formulas_near(rows, fit)
            else:
                places = _numbers_near(rows, fit, kind, self.computation.ranks)
        return [
            (edits[n].level, edits[n].cause, kind.like(_points(rows[n]), fit.given)) for n in places
        ]


def _points(row):
    return tuple(map(tuple, row.tolist()))


def _formulas_near(rows, fit):
    """Of formulas: those near at the first point where the key has a value; few are, by chance."""
    import numpy as np

    given = np.array(fit.given[fit.index])
    gaps = np.linalg.norm(rows[:, fit.index] - given, axis=-1)
    return np.flatnonzero(gaps <= fit.rtol * np.linalg.norm(given)).tolist()


def _numbers_near(rows, fit, kind, ranks):
    import numpy as np

    given, key = np.array(fit.given[0]), np.array(fit.key[0])
    rows = rows[:, 0]
    if not kind.has_size:
        rows = np.array([kind.like((row,), fit.given)[0] for row in rows.tolist()])
    size = np.linalg.norm(given)
    gaps = np.linalg.norm(rows - given, axis=1)
    around = (gaps <= AROUND * size) & (np.linalg.norm(rows - key, axis=1) > NOISE * size)
    nearest = max(fit.rounding, ROUND_OFF * size)
    there = int((abs(key) > NOISE * fit.sizes[0]).sum()) or 1
    wrong = int((abs(given - key) > max(nearest, NOISE * fit.sizes[0])).sum())
    found = []
    for n in np.flatnonzero(around & (gaps <= fit.rtol * size)):
        others = rows[around & (ranks <= ranks[n])]
        count = len(np.unique(np.round(others / size, 9), axis=0))
        share = max(gaps[n], nearest) / (AROUND * size)
        limit = CHANCE if gaps[n] <= nearest else CHANCE_ROUNDED
        if count * share**there <= limit and count * share**wrong <= CHANCE_BESIDE:
            found.append(int(n))
    return found


NO_SLIPS = Perturbed(Computation({}, {}, SI), {})


class _Lanes:
    """The steps of a computation, computed with each edit: rows (slips, points), or (points,) of
    what no edit reaches.
    """

    def __init__(self, computation, values):
        import numpy as np

        self.np, self.run, self.operations = np, computation.run, operations(np)
        # a number is not an array of one, which costs more
        self.values = {n: np.asarray(x, float)[()] for n, x in values.items()}
        self.points = max((np.size(x) for x in self.values.values()), default=1)
        self.count, self.own = len(computation.edits), computation.own
        self.base, self.rows = {}, {}
        for s in computation.steps:
            self.base[s.number] = self._plain(s, self.base)

    def row(self, s):
        """The row of a step, of which the arguments have theirs."""
        row = self.base[s.number]
        if any(self.rows[a.number] is not self.base[a.number] for a in steps_in(s)):
            row = self._within(s) if s.op in WITHIN else self._plain(s, self.rows)
        if s.number in self.own:
            lanes, expressions = self.own[s.number]
            row = self.np.array(self.np.broadcast_to(row, (self.count, self.points)))
            row[lanes] = self._columns([self._expression(x) for x in expressions])
        self.rows[s.number] = row
        return row

    def _columns(self, numbers):
        if self.points == 1:
            return self.np.array(numbers, float).reshape(-1, 1)
        return [self.np.broadcast_to(x, self.points) for x in numbers]

    def _plain(self, s, rows):
        if s.op == "argument":
            return self.values[s.args[0]]
        args = (rows[a.number] if isinstance(a, Step) else self._constant(a) for a in s.args)
        found = self.operations[s.op](*args)
        return tuple(map(to_plain, found)) if s.op in WITHIN else found

    def _constant(self, a):
        return self.run[a] if isinstance(a, Inner) else to_plain(a)

    def _expression(self, x):
        if isinstance(x, Step):
            return self.base[x.number]
        if not isinstance(x, tuple):
            return self._constant(x)
        return self.operations[x[0]](*map(self._expression, x[1:]))

    def _within(self, s):
        """The values of integrals and roots, computed where an edit reaches them; nan where there
        are none.
        """
        np, whole = self.np, (self.count, self.points)
        moved = np.zeros(whole, bool)
        for a in steps_in(s):
            moved |= self.rows[a.number] != self.base[a.number]
        found = [np.array(np.broadcast_to(x, whole)) for x in self.base[s.number]]
        for row in found:
            row[moved] = np.nan
        if s.op != "over_cube":
            moved[moved] = self._has_value(s.op, *self._at(s, moved))
        try:
            numbers = self.operations[s.op](*self._at(s, moved))
        except (ArithmeticError, ValueError):
            return tuple(found)
        for row, x in zip(found, numbers, strict=True):
            row[moved] = to_plain(x)
        return tuple(found)

    def _at(self, s, places):
        """The arguments of a step at these places of its row."""
        whole = places.shape
        return [
            self.np.broadcast_to(self.rows[a.number], whole)[places]
            if isinstance(a, Step)
            else self._constant(a)
            for a in s.args
        ]

    def _has_value(self, op, formula, low, high, *outer):
        """True where an integrand has values, or a function opposite signs at both ends."""
        if op == "root":
            return formula(low, *outer)[0] * formula(high, *outer)[0] <= 0
        return self.np.isfinite(sum(formula((low + high) / 2, *outer)))

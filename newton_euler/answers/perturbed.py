"""What a traced computation gives with one slip in it, for all slips at once."""

from collections.abc import Mapping
from functools import cached_property
from typing import Any

from ..algebra.compile import Compiled
from ..algebra.scalars import to_plain
from ..algebra.source import WITHIN, operations
from ..algebra.trace import Inner, Step
from ..algebra.units import unit
from .edits import edits_of
from .formulas import Edit, Formulas, needed, steps_in
from .near import Ranked, Slips


class Computation:
    """A traced computation: the steps that its answers need, and the slips in it."""

    def __init__(self, formulas: Formulas):
        self.answers, self.system = formulas.answers, formulas.system
        self.steps = needed(x for a in self.answers.values() for x in a.parts)
        self.edits: list[Edit] = edits_of(formulas)
        stages = [x for stage in formulas.stages for x in stage.parts]
        self.every = needed([*self.steps, *stages])
        self.ranked = Ranked([(e.rank, e.cause) for e in self.edits])
        self.own: dict[int, tuple[list[int], list[Any]]] = {}  # of a step: edits, expressions
        for n, edit in enumerate(self.edits):
            for number, expression in edit.instead.items():
                lanes, expressions = self.own.setdefault(number, ([], []))
                lanes.append(n)
                expressions.append(expression)
        self.run = {
            a: Compiled("the formula inside", a.parameters, a.trace, a.leaves)
            for s in self.every
            for a in s.args
            if isinstance(a, Inner)
        }


class Perturbed(Slips):
    """A computation with each slip, for the numbers of one student, arrays for symbols."""

    def __init__(self, computation: Computation, values: Mapping[str, Any]):
        self.computation, self.values = computation, values

    def of_answer(self, key: str) -> tuple[Ranked, Any] | None:
        """As for :class:`.near.Slips`."""
        ranked = self.computation.ranked
        return (ranked, self._rows[key]) if ranked.slips and key in self._rows else None

    @cached_property
    def _rows(self):
        """{answer: array (slips, points, components)}."""
        import numpy as np

        with np.errstate(all="ignore"):
            lanes = _Lanes(self.computation, self.values)
            rows = {s.number: lanes.row(s) for s in self.computation.steps}
            return {k: self._answer(a, rows) for k, a in self.computation.answers.items()}

    def _answer(self, answer, rows):
        import numpy as np

        numbers = [rows[x.number] if isinstance(x, Step) else float(x) for x in answer.parts]
        factor = unit(answer.unit).from_base(1.0, self.computation.system)
        columns = [factor * x for x in numbers]
        # a number has one point, beside formulas too
        one = [c[..., : answer.points] if np.ndim(c) else c for c in columns]
        shape = len(self.computation.edits), answer.points
        return np.stack([np.broadcast_to(c, shape) for c in one], axis=-1)


class _Lanes:
    """The steps of a computation, computed with each edit: rows (slips, points), or (points,) of
    what no edit reaches.
    """

    def __init__(self, computation, values):
        import numpy as np

        self.np, self.run, self.operations = np, computation.run, operations(np)
        # a number is not an array of one, which costs more
        self.values = {n: np.squeeze(x)[()] for n, x in values.items()}
        self.points = max((np.size(x) for x in self.values.values()), default=1)
        self.count, self.own = len(computation.edits), computation.own
        self.base, self.rows = {}, {}
        for s in computation.every:
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

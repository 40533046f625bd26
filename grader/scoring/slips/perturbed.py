"""A traced computation with one slip in it, for all slips at once: each step that a slip reaches
has a row with its value under each. Written once as text, as formulas are.
"""

import math
from collections.abc import Mapping
from typing import Any

from newton_euler.algebra.compile import Compiled
from newton_euler.algebra.integrals import integrals
from newton_euler.algebra.late import np
from newton_euler.algebra.scalars import to_plain
from newton_euler.algebra.source import WITHIN, operations
from newton_euler.algebra.trace import Inner, Step
from newton_euler.algebra.units import unit
from newton_euler.answers.near import Ranked, Slips

from .edits import edits_of
from .edits_of_equations import solution
from .edits_of_roots import beside, rooted
from .facts import entries, square
from .formulas import Edit, Formulas, steps_in, steps_needed

INFIX = {"+", "-", "*", "/", "**"}


class Computation:
    """A traced computation: the steps that its answers need, and the slips in it."""

    def __init__(self, formulas: Formulas):
        self.answers = formulas.answers
        self.steps = steps_needed(x for a in self.answers.values() for x in a.parts)
        self.edits: list[Edit] = edits_of(formulas)
        self.ranked = Ranked([(e.rank, e.cause) for e in self.edits])
        stages = [x for stage in formulas.stages for x in stage.parts]
        systems = square(formulas.systems)
        inside = [x for s in systems for x in (*entries(s), *s.values.values())]
        anew = [x for edit in self.edits for parts in edit.answers.values() for x in parts]
        self.every = steps_needed([*self.steps, *stages, *inside, *anew, *formulas.given.values()])
        self.arguments_of = {k: _arguments(a.parts) for k, a in self.answers.items()}
        system = formulas.system
        self.factors = {k: unit(a.unit).from_base(1.0, system) for k, a in self.answers.items()}
        units = {n: unit(formulas.units[n]) for n in _arguments(self.every)}
        self.to_base = {n: u.to_base(1.0, system) for n, u in units.items()}
        self.names: dict[str, Any] = operations(np)
        self.names |= {"answer": self._answer, "within": self._within, "equations": solution}
        self.names |= {"inside": _inside, "between": _between, "rooted": rooted, "beside": beside}
        exec(compile(_Text(self).text, "the slips", "exec"), self.names)
        self._run = self.names["slips"]

    def rows(self, values: Mapping[str, Any]) -> dict[str, Any]:
        """{answer: array (slips, components)} for one value of each argument, in the unit of the
        text.
        """
        base = (np.float64(values[n] * factor) for n, factor in self.to_base.items())
        with np.errstate(all="ignore"):
            return dict(zip(self.answers, self._run(*base), strict=True))

    def _answer(self, key, lanes, anew, *components):
        found = np.empty((len(components), len(self.edits)))
        for n, x in enumerate(components):
            found[n] = x
        if lanes is not None:
            found[:, lanes] = anew
        return (self.factors[key] * found).T

    def _within(self, op, base, before, args):
        """Integrals or roots, anew where an edit changes their arguments; nan without a value."""
        count = len(self.edits)
        moved = np.zeros(count, bool)
        for a, b in zip(args, before, strict=True):
            if a is not b:
                moved |= a != b
        found = [np.full(count, float(x)) for x in base]
        for row in found:
            row[moved] = np.nan
        run = self.names[op]
        # a root evaluates a formula at the same array of points many times
        inner = args[0].on(np) if op == "root" else args[0]

        def at():
            return [inner, *(np.broadcast_to(a, (count,))[moved] for a in args[1:])]

        if op != "over_cube":
            moved[moved] = _has_value(op, *at())
        try:
            numbers = run(*at()) if moved.any() else []
        except (ArithmeticError, ValueError):
            return tuple(found)
        for row, x in zip(found, numbers, strict=False):
            row[moved] = to_plain(x)
        return tuple(found)


def _has_value(op, formula, low, high, *outer):
    """True if an integrand has values, or a function has opposite signs at both ends."""
    if op == "root":
        return formula(low, *outer)[0] * formula(high, *outer)[0] <= 0
    return np.isfinite(sum(formula((low + high) / 2, *outer)))


def _arguments(leaves):
    """The names of the arguments that these leaves need."""
    return [s.args[0] for s in steps_needed(leaves) if s.op == "argument"]


class _Text:
    """The text of a :class:`Computation`: b7 is the value of the step 7, r7 its row."""

    def __init__(self, computation):
        self.names, self.lines, self.edits = computation.names, [], computation.edits
        self.rows = {s.number: f"b{s.number}" for s in computation.every}
        for s in computation.every:
            if s.op != "argument":
                self.lines.append(f"b{s.number} = {self._operation(s.op, s.args, 'b')}")
        self._rows(computation)
        arguments = [f"b{s.number}" for s in computation.every if s.op == "argument"]
        results = "".join(f"{self._answer(key, a)}, " for key, a in computation.answers.items())
        lines = "".join(f"    {line}\n" for line in self.lines)
        self.text = f"def slips({', '.join(arguments)}):\n{lines}    return ({results})\n"

    def _rows(self, computation):
        own: dict[int, list[int]] = {}
        for n, edit in enumerate(self.edits):
            for number in edit.instead:
                own.setdefault(number, []).append(n)
        instead = [(number, n) for number, lanes in own.items() for n in lanes]
        expressions = (self._expression(self.edits[n].instead[number]) for number, n in instead)
        self.names |= {"full": _full, "array": np.array, "count": len(self.edits)}
        self.lines.append(f"instead = array(({''.join(f'{x}, ' for x in expressions)}), float)")
        start = {number: sum(map(len, list(own.values())[:n])) for n, number in enumerate(own)}
        for s in computation.steps:
            lanes = own.get(s.number)
            row = self._row(s) if lanes or self._is_reached(s) else None
            if row is None:
                continue
            name = self.rows[s.number] = f"r{s.number}"
            self.lines.append(f"{name} = {row}")
            if lanes:
                self.names[f"i{s.number}"] = np.array(lanes)
                ends = f"{start[s.number]}:{start[s.number] + len(lanes)}"
                self.lines.append(f"{name}[i{s.number}] = instead[{ends}]")

    def _is_reached(self, s):
        return any(self.rows[a.number][0] == "r" for a in steps_in(s))

    def _row(self, s):
        if not self._is_reached(s):
            return f"full(count, b{s.number})"
        if s.op not in WITHIN:
            return self._operation(s.op, s.args, "")
        before, now = (", ".join(self._spelled(a, letter) for a in s.args) for letter in ("b", ""))
        return f"within({s.op!r}, b{s.number}, ({before},), ({now},))"

    def _operation(self, op, args, letter):
        return _written(op, [self._spelled(a, letter) for a in args])

    def _spelled(self, a, letter):
        """A step as its value, or else its row if it has one; a number as it is."""
        if isinstance(a, Step):
            return f"b{a.number}" if letter else self.rows[a.number]
        is_formula = isinstance(a, Inner)
        a = Compiled("inside", a.parameters, a.trace, a.leaves) if is_formula else to_plain(a)
        if type(a) in (int, float) and abs(a) < math.inf:
            return f"({a!r})"
        self.names[name := f"c{len(self.names)}"] = a
        return name

    def _expression(self, x):
        if not isinstance(x, tuple):
            return self._spelled(x, "b")
        return f"({_written(x[0], [self._expression(a) for a in x[1:]])})"

    def _answer(self, key, a):
        anew = {n: e.answers[key] for n, e in enumerate(self.edits) if key in e.answers}
        self.names[lanes := f"lanes_{key}"] = np.array([*anew]) if anew else None
        rows = ""
        for row in zip(*anew.values(), strict=True):
            rows += f"({''.join(self._spelled(x, 'b') + ', ' for x in row)}), "
        parts = ", ".join(self._spelled(x, "") for x in a.parts)
        return f"answer({key!r}, {lanes}, ({rows}), {parts})"


def _written(op, args):
    if op in INFIX:
        return f"{args[0]} {op} {args[1]}"
    return f"{args[0]}[{args[1]}]" if op == "item" else f"{op}({', '.join(args)})"


def _inside(formula, n, *args):
    return formula(*args)[n]


def _between(formula, low, high, *outer):
    """The integrals; nan where they do not exist."""
    try:
        return integrals(lambda x: formula(x, *outer), low, high)
    except (ArithmeticError, ValueError):
        return [math.nan] * len(formula.leaves)


def _full(count, x):
    found = np.empty(count)
    found.fill(x)  # np.full takes three times as long
    return found


class Perturbed(Slips):
    """A computation with each slip, for the numbers of one student in the units of the text, arrays
    for symbols.
    """

    def __init__(self, computation: Computation, values: Mapping[str, Any]):
        self.computation, self.values = computation, values
        self._found: dict[int, dict[str, Any]] = {}

    def ranked(self, key: str) -> Ranked | None:
        has_slips = key in self.computation.answers and self.computation.edits
        return self.computation.ranked if has_slips else None

    def points(self, key: str) -> int:
        return self.computation.answers[key].points

    def is_of_symbols(self, key: str) -> bool:
        return all(getattr(self.values[n], "shape", ()) for n in self.computation.arguments_of[key])

    def is_size(self, key: str) -> bool:
        return _is_size(self.computation.answers[key].parts[0])

    def at(self, key: str, point: int) -> Any:
        """An answer with each slip at a point; every answer at a point is computed at once."""
        if point not in self._found:
            values = {n: _at(x, point) for n, x in self.values.items()}
            self._found[point] = self.computation.rows(values)
        return self._found[point][key]


def _is_size(x):
    """True of the root of a square, and of such a root times something."""
    inside = steps_in(x) if isinstance(x, Step) else ()
    if inside and x.op == "sqrt":
        return len(steps_in(inside[0])) == 2 and len({*inside[0].args}) == 1
    return bool(inside) and x.op in ("*", "/") and any(map(_is_size, inside))


def _at(x, point):
    """A value at one point: a number is the same at all."""
    return x[point if len(x) > 1 else 0] if getattr(x, "shape", ()) else x

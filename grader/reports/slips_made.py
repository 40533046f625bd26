"""Slips like students', by random edits of a problem's formulas, to measure the diagnosis;
independent of what the diagnosis looks for.
"""

import math
import random
from collections.abc import Iterator, Mapping
from itertools import combinations
from typing import Any, NamedTuple

from exercises.catalogue import Problem
from exercises.catalogue.tracing import traced_quantities
from exercises.catalogue.variants import POINTS, as_points, draw, flat, symbol_points
from newton_euler.algebra import scalars
from newton_euler.algebra.scalars import ZERO
from newton_euler.algebra.source import operations
from newton_euler.algebra.trace import Inner, Step
from newton_euler.algebra.units import SI, US, Dimension, unit
from newton_euler.algebra.vectors import Vector

from ..scoring.slips.formulas import dimensions_of, steps_needed
from .setups_made import of_setups

OPERATIONS = operations(scalars) | {"pi": scalars.pi}
TWINS = {"sin": "cos", "cos": "sin", "asin": "acos", "acos": "asin"}
SETUPS = 4  # slips in the set-up of each problem
OF_INERTIA = Dimension(1, 2, 0)
OF_GRAVITY = Dimension(0, 1, -2)


class SlipEdit(NamedTuple):
    """Another expression (a step, a number, or an operation on them) for a step, everywhere or only
    in ``user``.
    """

    step: Step
    instead: Any
    user: Step | None = None


class ProblemFormulas:
    """The computation of a problem in base units: the steps, and the components of each answer with
    their factor to the unit of the text.
    """

    def __init__(self, p: Problem):
        found = traced_quantities(p)
        self.problem, self.given, self.answers = p, found.givens, {}
        for a in (a for a in p.answers if not a.kind.is_word):
            factor = unit(a.unit).from_base(1.0, p.system)
            self.answers[a.key] = [(x, factor) for x in found.components[a.key]]
        self.steps = steps_needed(x for parts in self.answers.values() for x, _ in parts)
        self.own = US if any(unit(u).is_of_feet for u in p.units.values()) else SI
        self.metres = 0.3048 if self.own is US else 1.0
        stated = {unit(u) for u in (*p.units.values(), *(found.units[k] for k in self.answers))}
        sizes = {(float(u.to_base(1.0, SI)), u.dimension.powers[1]) for u in stated}
        if self.own is SI and all(math.isclose(x, 0.001 ** float(n)) for x, n in sizes if n):
            self.metres = 0.001  # all lengths are in mm

    def one(self, dimension: Any) -> float:
        """A quantity of 1 in the student's units: feet and pounds if the text has them, mm if it
        has no m.
        """
        if not isinstance(dimension, Dimension):
            return 1.0
        mass, length, _ = dimension.powers
        kilograms = 14.593902937206365 if self.own is US else 1.0
        return (
            kilograms ** float(mass)
            * self.metres ** float(length)
            / float(self.problem.system.factor(dimension))
        )

    def base(self, values: Mapping[str, Any]) -> dict[str, Any]:
        """The values of the text in base units."""
        return vars(self.problem.base(values))["_values"]

    def run(self, key: str, values: Mapping[str, Any], edits: tuple[SlipEdit, ...] = ()) -> tuple:
        """The components of an answer, with edits."""
        value = _Evaluation(values, edits).value
        return tuple(0.0 if x is ZERO else value(x) * factor for x, factor in self.answers[key])


class _Evaluation:
    """Steps evaluated with edits, each once."""

    def __init__(self, values, edits=()):
        self.values, self.found = values, {}
        self.everywhere = {e.step.number: e.instead for e in edits if e.user is None}
        self.within = {(e.user.number, e.step.number): e.instead for e in edits if e.user}

    def value(self, x):
        """The number of a step, of a number, or of an operation (name, *arguments)."""
        if isinstance(x, tuple):
            return self._operated(x[0], [self.value(a) for a in x[1:]])
        if not isinstance(x, Step):
            return x
        if x.number not in self.found:
            instead = self.everywhere.get(x.number)
            self.found[x.number] = self._plain(x) if instead is None else self._instead(x, instead)
        return self.found[x.number]

    def _instead(self, step, instead):
        without = _Evaluation(self.values)  # the replacement of a step may contain it
        without.within = self.within
        return without.value(instead)

    def _plain(self, s):
        if s.op == "argument":
            return self.values[s.args[0]]
        return self._operated(
            s.op,
            [
                self.value(self.within.get((s.number, a.number), a) if isinstance(a, Step) else a)
                for a in s.args
            ],
        )

    def _operated(self, op, args):
        if isinstance(args[0] if args else None, Inner):
            return _within(op, *args)
        return OPERATIONS[op](*args)


def _within(op, inner, *args):
    def formula(*numbers):
        value = _Evaluation(dict(zip(inner.parameters, numbers, strict=True))).value
        return tuple(value(x) for x in inner.leaves)

    return OPERATIONS[op](formula, *args)


# -- the kinds of slips


def edits(f: ProblemFormulas, values: Mapping[str, Any]) -> dict[str, list[tuple[SlipEdit, ...]]]:
    """{kind of slip: its possible edits of these formulas}."""
    found: dict[str, list[tuple[SlipEdit, ...]]] = {}
    dimensions = dimensions_of(f.steps, {n: unit(u) for n, u in f.problem.units.items()})
    for s in f.steps:
        for kind, edit in _edits_of(s, f, values, dimensions):
            found.setdefault(kind, []).append((edit,))
    return found


def _edits_of(s, f, values, dimensions):
    steps = [a for a in s.args if isinstance(a, Step)]
    numbers = [a for a in s.args if not isinstance(a, (Step, Inner)) and s.op in ("*", "/")]
    if s.op == "argument":
        yield from _of_given(s, f, values)
    if s.op in "*/" and len(steps) == 2:
        kind = "square lost" if steps[0] is steps[1] else "factor dropped"
        yield kind, SlipEdit(s, (s.op, steps[0], f.one(dimensions.get(steps[1]))))
        if s.op == "*" and steps[0] is not steps[1]:
            yield kind, SlipEdit(s, ("*", steps[1], f.one(dimensions.get(steps[0]))))
    if s.op in ("sqrt", "**"):
        root = f.one(dimensions.get(s)) / f.one(dimensions.get(steps[0]))
        yield "square lost", SlipEdit(s, ("*", steps[0], root))
    if s.op in "*/" and numbers and steps and steps[0] is s.args[0]:
        constant = float(numbers[0])
        if abs(constant) in (0.5, 2.0):
            yield "2 or 1/2 lost", SlipEdit(s, steps[0])
        if s.op == "/" and abs(constant) in (3.0, 12.0):
            yield "1/12 for 1/3", SlipEdit(s, (s.op, steps[0], 36.0 / constant))
    if s.op in TWINS:
        yield "sin for cos", SlipEdit(s, (TWINS[s.op], *s.args))
    if s.op in ("+", "-") and len(steps) == 2:
        yield from _of_sum(s, steps, dimensions)
    gravity = [a for a in steps if dimensions.get(a) == OF_GRAVITY and a.op == "argument"]
    if s.op == "*" and len(gravity) == 1 and len(steps) == 2:
        other = next(a for a in steps if a is not gravity[0])
        yield "g left out", SlipEdit(s, ("*", other, f.one(OF_GRAVITY)))
    if s.op == "*":
        for a in steps:
            if a.op == "argument" and dimensions.get(a) == Dimension(1, 0, 0):
                yield "g put in", SlipEdit(a, ("*", a, 32.2 if f.own is US else 9.81), s)


def _of_sum(s, steps, dimensions):
    a, b = steps
    inertia = dimensions.get(s) == OF_INERTIA
    for term, other, sign in ((a, b, s.op == "-"), (b, a, False)):
        if term.op in ("+", "-"):
            continue  # several terms
        kind = "parallel axis" if inertia and _has_square(term) else "term left out"
        yield kind, SlipEdit(s, ("neg", other) if sign else other)
        kind = "parallel axis" if inertia and _has_square(term) else "sign of one term"
        turned = (
            ("-", other, term)
            if s.op == "+"
            else ("+", a, b)
            if term is b
            else ("neg", ("+", a, b))
        )
        yield kind, SlipEdit(s, turned)


def _has_square(s):
    inner = [a for a in s.args if isinstance(a, Step)]
    return s.op in "*/" and (s.args[0] is s.args[-1] or any(map(_has_square, inner)))


def _of_given(s, f, values):
    name = s.args[0]
    stated, factor = (
        f.problem.units[name],
        unit(f.problem.units[name]).to_base(1.0, f.problem.system),
    )
    for other, step in f.given.items():
        if other != name and f.problem.units[other] == stated and values[other] is not values[name]:
            yield "another given", SlipEdit(s, step)
            users = [u for u in f.steps if any(a is s for a in u.args)]
            if len(users) > 1:
                yield "another given", SlipEdit(s, step, users[len(users) // 2])
    if name in f.problem.givens and factor != 1 and values[name]:
        kind = "degrees" if stated == "deg" else "units"
        yield kind, SlipEdit(s, ("*", s, 1 / factor))
        if kind == "units" and not 0.99 < factor**2 < 1.01:
            yield kind, SlipEdit(s, ("*", s, 1 / factor**2))


# -- answers with slips


class SlippedAnswers(NamedTuple):
    """Answers with one slip: {key: components} of all, in floats or trees of formulas, and the keys
    of the wrong ones.
    """

    kind: str
    answers: dict[str, tuple]
    wrong: tuple[str, ...]
    name: str = ""  # name of a listed mistake


def made(p: Problem, values: Mapping[str, float], rng: random.Random) -> Iterator[SlippedAnswers]:
    """Slips of every possible kind in a problem, in all answers that they affect or in one."""
    f = ProblemFormulas(p)
    base = f.base({**values, **symbol_points(p)})
    right = {key: f.run(key, base) for key in f.answers}
    for kind, choices in edits(f, base).items():
        for edit in rng.sample(choices, min(2, len(choices))):
            yield from _spread(kind, _changed(f, base, right, edit), right, rng)
    own = random.Random(f"{p.id} {values}")  # so that the others stay the same
    for wrong in of_setups(p, values, own, SETUPS):
        yield from _spread("another set-up", {k: wrong[k] for k in right}, right, own)
    yield from _of_other_numbers(p, f, right, rng)
    yield from _following(f, base, right, rng)
    yield from _going_on(f, base, right, rng)
    yield from _listed(p, values, right, rng)
    yield from _in_other_places(p, values, right)


def _changed(f, base, right, edit):
    """{key: components} of the answers with an edit, if they have values."""
    found = {}
    for key in right:
        try:
            found[key] = f.run(key, base, edit)
        except (ArithmeticError, ValueError, TypeError):
            continue
    return found


def _spread(kind, wrong, right, rng):
    changed = [k for k in wrong if not _same(wrong[k], right[k])]
    if not changed:
        return
    if rng.random() < 0.5:
        changed = [rng.choice(changed)]
    yield SlippedAnswers(kind, {**right, **{k: wrong[k] for k in changed}}, tuple(changed))


def _same(a, b):
    points = zip(as_points(a, POINTS), as_points(b, POINTS), strict=True)
    return all(math.dist(x, y) <= 1e-9 * math.hypot(*x) for x, y in points)


def _of_other_numbers(p, f, right, rng):
    if not any(g.vary for g in p.givens.values()):
        return
    for kind, values in (
        ("book's numbers", p.book_values),
        ("another variant", draw(p, rng.randbytes(8))),
    ):
        base = f.base({**values, **symbol_points(p)})
        yield from _spread(kind, {key: f.run(key, base) for key in right}, right, rng)


def _following(f, base, right, rng):
    """A wrong number in one answer, and the answers computed from it."""
    for key, edit in _wrong_numbers(f, right, rng):
        wrong, later = _later(f, base, right, key, edit)
        if later:
            yield SlippedAnswers("follows", {**right, **wrong}, later)


def _going_on(f, base, right, rng):
    """The same with a further slip in an answer computed from the wrong one."""
    choices = [e for every in edits(f, base).values() for e in every]
    for key, edit in _wrong_numbers(f, right, rng):
        follows, later = _later(f, base, right, key, edit)
        before = {s.number for s in steps_needed(x for x, _ in f.answers[key])}
        after = [e for e in choices if e[0].step.number not in before]
        for slip in rng.sample(after, min(2, len(after))) if later else ():
            wrong, _ = _later(f, base, right, key, (*edit, *slip))
            changed = tuple(k for k in later if k in wrong and not _same(wrong[k], follows[k]))
            if changed:
                yield SlippedAnswers("slip in going on", {**right, **follows, **wrong}, changed)


def _wrong_numbers(f, right, rng):
    """(answer, edits that make it wrong) for answers from which others may follow."""
    for key in list(right)[:-1]:
        parts = [x for x, _ in f.answers[key]]
        if all(isinstance(x, Step) and x.op != "argument" for x in parts):
            factor = rng.choice((0.61, 0.83, 1.37, 1.71))
            yield key, tuple(SlipEdit(x, ("*", x, factor)) for x in parts)


def _later(f, base, right, key, edit):
    """An answer and later ones with an edit, and the keys of the later ones that it changes."""
    keys = list(right)
    wrong = _changed(f, base, {k: right[k] for k in keys[keys.index(key) :]}, edit)
    return wrong, tuple(k for k in wrong if k != key and not _same(wrong[k], right[k]))


LISTED = "listed, in one part"


def _listed(p, values, right, rng):
    """Each listed mistake in one part, the others right."""
    for name, answers in p.wrong({**values, **symbol_points(p)}).items():
        numbers = {k: flat(x) for k, x in answers.items() if k in right}
        numbers = {k: x for k, x in numbers.items() if not _same(x, right[k])}
        if numbers and (len(right) > 1):
            key = rng.choice(sorted(numbers))
            yield SlippedAnswers(LISTED, {**right, key: numbers[key]}, (key,), name)


def _in_other_places(p, values, right):
    """Answers exchanged with others of the same kind and unit, and vectors along other axes."""
    for a, b in combinations([p.answer(key) for key in right], 2):
        if (a.kind, a.unit) == (b.kind, b.unit):
            wrong = {a.key: right[b.key], b.key: right[a.key]}
            yield SlippedAnswers("exchanged", {**right, **wrong}, (a.key, b.key))
    for key, x in p.solve({**values, **symbol_points(p)}).items():
        for frame in x.frame.tree if isinstance(x, Vector) else ():
            if not _same(other := flat(x.components(frame)), right[key]):
                yield SlippedAnswers("other axes", {**right, key: other}, (key,))

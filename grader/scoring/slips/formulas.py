"""The traced computation of a problem, and the edits of it that slips make."""

from collections.abc import Collection, Iterable, Mapping, Sequence
from functools import reduce
from typing import Any, NamedTuple

from newton_euler.algebra import scalars
from newton_euler.algebra.linear import Solved
from newton_euler.algebra.scalars import NewtonEulerError
from newton_euler.algebra.source import operations
from newton_euler.algebra.trace import Step, Trace
from newton_euler.algebra.units import Dimension, System, Unit
from newton_euler.answers.causes import Cause, computed
from newton_euler.answers.kinds import KINDS, Kind

PRODUCT, SUM = ("*", "/"), ("+", "-")


class TracedAnswer(NamedTuple):
    """An answer of a traced computation: its components in base units, its unit, its kind, and the
    number of points at which it is compared.
    """

    parts: Sequence[Any]
    unit: str
    kind: Kind = KINDS["number"]
    points: int = 1


class Intermediate(NamedTuple):
    """A quantity on the way to the answers: its name, where the book has it, its components, its
    kind, and its meaning, "the speed of B".
    """

    name: str
    where: str
    parts: Sequence[Any]
    kind: Kind = KINDS["number"]
    means: str = ""


class Formulas(NamedTuple):
    """A traced computation.

    units : of the givens and symbols, which are the arguments, in base units of the ``system``
    where : the section of the problem
    means : of the givens, in a few words
    systems : the linear equations that are solved on the way
    symbols : the arguments that stay symbols in the answers
    given : the steps of all givens and symbols of the problem, even those that no answer needs
    setups : the slips in setting up the system
    components : of the student's earlier vectors, {argument: name of its vector}
    """

    answers: Mapping[str, TracedAnswer]
    units: Mapping[str, str]
    system: System
    stages: Sequence[Intermediate] = ()
    where: str = ""
    means: Mapping[str, str] = {}
    systems: Sequence[Solved] = ()
    symbols: Collection[str] = ()
    given: Mapping[str, Step] = {}
    setups: "Sequence[Edit]" = ()
    components: Mapping[str, str] = {}


class Edit(NamedTuple):
    """A slip: other expressions for some steps, {number: expression}. An expression is a number, a
    step, or an operation and its expressions, as a tuple. The lower the ``rank``, the simpler; two
    of one ``level`` are equally simple. Where something is set up otherwise, all ``answers`` are
    computed anew, {key: components}.
    """

    rank: int
    cause: Cause
    instead: dict[int, Any]
    answers: Mapping[str, Sequence[Any]] = {}


def edit(
    rank: int, name: str, words: str, instead: dict[int, Any], does: str = "", of: str = ""
) -> Edit:
    """The :class:`Edit` of a slip in the computation."""
    return Edit(rank, computed(name, words, "", does, of), instead)


def total(terms: Iterable[Any]) -> Any:
    """The expression of a sum."""
    return reduce(lambda a, b: ("+", a, b), terms)


def multiplied(factors: Iterable[Any]) -> Any:
    """The expression of a product."""
    return reduce(lambda a, b: ("*", a, b), factors)


def steps_in(s: Step) -> list[Step]:
    """The arguments of a step that are steps."""
    return [a for a in s.args if isinstance(a, Step)]


def steps_needed(leaves: Iterable[Any]) -> list[Step]:
    """The steps that these leaves need, in order."""
    waiting, found = [x for x in leaves if isinstance(x, Step)], dict[int, Step]()
    while waiting:
        s = waiting.pop()
        if s.number not in found:
            found[s.number] = s
            waiting += steps_in(s)
    return [found[n] for n in sorted(found)]


def with_arguments(leaves: Iterable[Any], names: Mapping[int, str]) -> list[Any]:
    """The leaves in a trace of their own, in which the steps with these numbers are arguments."""
    leaves, trace, found = [*leaves], Trace(), dict[int, Any]()

    def now(x):
        return found[x.number] if isinstance(x, Step) else x

    for s in steps_needed(leaves):
        op, args = ("argument", [names[s.number]]) if s.number in names else (s.op, s.args)
        found[s.number] = trace.new(op, *map(now, args))
    return [now(x) for x in leaves]


def users_of(steps: Iterable[Step]) -> dict[Step, list[Step]]:
    """{step: the steps that use it}."""
    users: dict[Step, list[Step]] = {s: [] for s in steps}
    for s in users:
        for a in dict.fromkeys(steps_in(s)):
            users[a].append(s)
    return users


def dimensions_of(steps: Sequence[Step], units: Mapping[str, Unit]) -> dict[Step, Dimension | None]:
    """The dimension of each step; None where it has no whole powers, or is within a root."""
    given = {s: units[s.args[0]].dimension for s in steps if s.op == "argument"}
    found = _dimensions(steps, given)
    return {s: d if isinstance(d, Dimension) and _is_whole(d) else None for s, d in found.items()}


def _dimensions(steps, given):
    run, found = operations(scalars), dict[Step, Any]()
    for s in steps:
        try:
            args = [found[a] if isinstance(a, Step) else a for a in s.args]
            if s.op == "integral":
                found[s] = _of_integral(*args)
            else:
                number = Dimension() if s.op == "pi" else None
                found[s] = given.get(s) or number or run[s.op](*args)
        except (NewtonEulerError, TypeError, AttributeError, KeyError):
            found[s] = None
    return found


def _of_integral(inner, low, high, *outer):
    """The dimensions of an integral: a limit that is a number is zero, or of no dimension."""
    own = next((d for d in (low, high) if isinstance(d, Dimension)), Dimension())
    values = dict(zip(inner.parameters, (own, *outer), strict=True))
    steps = steps_needed(inner.leaves)
    given = {s: values[s.args[0]] for s in steps if s.op == "argument"}
    found = _dimensions(steps, given)
    return [found[x] * own if isinstance(x, Step) else own for x in inner.leaves]


def _is_whole(dimension):
    return all(p.denominator == 1 for p in dimension.powers)

"""A problem traced once: steps and answers as traced scalars, linear equations solved for them."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from newton_euler.algebra.linear import Solved, solved_equations
from newton_euler.algebra.trace import Step as Scalar
from newton_euler.algebra.trace import Trace
from newton_euler.answers.kinds import Kind

from .model import Problem
from .steps import Step, further_terms, listed_steps
from .variants import flat


@dataclass(frozen=True)
class TracedProblem:
    """The computation of a problem in base units.

    givens : {given or symbol: its traced argument}
    components : {key: its traced numbers}, steps first, then answers; without words and counts
    units : {key: the unit in which it is stated}; kinds : {key: its kind}
    solved : the linear equations, in the order of their solution
    steps : with traced values
    """

    trace: Trace
    givens: Mapping[str, Scalar]
    components: Mapping[str, Sequence[Any]]
    units: Mapping[str, str]
    kinds: Mapping[str, Kind]
    solved: Sequence[Solved]
    steps: Sequence[Step]


def traced_quantities(p: Problem, to_be_read: bool = False) -> TracedProblem:
    """The traced computation of ``p``. ``to_be_read`` adds the terms of the answers to the steps
    and, where nothing is given, the argument "one" for the number 1, so that constants show how
    they are found. Raises ScalarError if the code branches on values.
    """
    trace = Trace()
    givens = {n: trace.new("argument", n) for n in p.units}
    one = 1.0 if p.units or not to_be_read else trace.new("argument", "one")
    g = p.base(dict.fromkeys(p.units, 1.0), one).but(**givens)
    with solved_equations() as solved:
        steps = listed_steps(p, g)
        answers = p.code.solve(g)
        steps += further_terms(p, steps, answers) if to_be_read else []
    found = [(s.key, s.value, s.unit, s.kind) for s in steps]
    found += [(a.key, answers[a.key], a.unit, a.kind) for a in p.answers if not a.kind.is_word]
    numbers = [x for x in found if not isinstance(x[1], (str, int)) and not callable(x[1])]
    return TracedProblem(
        trace,
        givens,
        {key: flat(x) for key, x, _, _ in numbers},
        {key: stated for key, _, stated, _ in numbers},
        {key: kind for key, _, _, kind in numbers},
        tuple(solved),
        steps,
    )


def before(parts: Sequence[Any]) -> set[int]:
    """The numbers of traced quantities and of everything they are computed from."""
    found, waiting = set(), [*parts]
    while waiting:
        a = waiting.pop()
        if isinstance(a, (tuple, list)):
            waiting += a
        elif isinstance(a, Scalar) and a.number not in found:
            found.add(a.number)
            waiting += a.args
    return found


def numbers_of(parts: Sequence[Any]) -> set[int]:
    """The numbers of traced quantities themselves, up to the sign."""
    inner = (x.args[0] if getattr(x, "op", "") == "neg" else x for x in parts)
    return {x.number for x in inner if isinstance(x, Scalar)}

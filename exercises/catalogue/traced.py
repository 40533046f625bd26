"""What the code of a problem computes, traced once: its givens, its steps and answers as traced
scalars, and the linear equations that it solves on the way.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from newton_euler.algebra.linear import Solved, solved_equations
from newton_euler.algebra.trace import Trace

from .model import Problem
from .steps import listed_steps, terms
from .variants import flat


@dataclass(frozen=True)
class Traced:
    """The computation of a problem, in base units.

    givens : the traced number of each given and symbol
    components : {key: its traced numbers}, of the steps in their order and then of the answers;
        words and counts are left out
    units : the unit in which each of them is stated
    solved : the linear equations that were solved, in their order
    """

    trace: Trace
    givens: Mapping[str, Any]
    components: Mapping[str, Sequence[Any]]
    units: Mapping[str, str]
    solved: Sequence[Solved]


def traced(p: Problem) -> Traced:
    """The traced computation of ``p``. Raises ScalarError where it branches on values."""
    trace = Trace()
    g = p.base({n: trace.new("argument", n) for n in p.units})
    with solved_equations() as solved:
        found = {s.key: (s.value, s.unit) for s in listed_steps(p, g)}
        found |= {k: (x, p.answer(k).unit) for k, x in p.code.solve(g).items()
                  if not p.answer(k).kind.is_word}  # fmt: skip
    numbers = {k: x for k, x in found.items() if not isinstance(x[0], (str, int, bool))}
    numbers = {k: x for k, x in numbers.items() if not callable(x[0])}
    return Traced(
        trace,
        {n: getattr(g, n) for n in p.units},
        {key: tuple(flat(x)) for key, (x, _) in numbers.items()},
        {key: stated for key, (_, stated) in numbers.items()},
        tuple(solved),
    )

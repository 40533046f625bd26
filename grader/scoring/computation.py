"""What a problem computes, traced in base units: where the slips are looked for that no problem
lists.
"""

from collections.abc import Mapping
from functools import cache
from typing import Any

from exercises.catalogue import Problem
from exercises.catalogue import problem as find_problem
from exercises.catalogue.tracing import traced_quantities
from exercises.catalogue.variants import POINTS
from newton_euler.algebra.units import unit
from newton_euler.answers.perturbed import Computation, Perturbed, Traced


def perturbed(problem: Problem, sample: Mapping[str, Any]) -> Perturbed:
    """The slips in the computation of ``problem`` for a student's numbers, in the units of the
    text.
    """
    values = {n: unit(u).to_base(sample[n], problem.system) for n, u in problem.units.items()}
    return Perturbed(_computation(problem.id), values)


@cache
def _computation(problem_id):
    p = find_problem(problem_id)
    found = traced_quantities(p).components
    answers = {
        a.key: Traced(
            [(x, unit(a.unit).from_base(1.0, p.system)) for x in found[a.key]],
            POINTS if a.kind.is_formula else 1,
        )
        for a in p.answers
        if a.key in found
    }
    return Computation(answers, p.units, p.system)

"""What a problem computes, traced in base units: where the slips are looked for that no problem
lists.
"""

import re
from collections.abc import Mapping
from functools import cache
from typing import Any

import numpy as np

from exercises.catalogue import Problem
from exercises.catalogue import problem as find_problem
from exercises.catalogue.following import earlier_answers, follow_in_base
from exercises.catalogue.tracing import traced_quantities
from exercises.catalogue.variants import POINTS, flat
from newton_euler.algebra.trace import Trace
from newton_euler.answers.formulas import Formulas, Stage, Traced
from newton_euler.answers.perturbed import Computation, Perturbed

FEW = 7  # words that say what a quantity is


def perturbed(problem: Problem, sample: Mapping[str, Any]) -> Perturbed:
    """The slips in the computation of ``problem`` for a student's numbers, in the units of the
    text.
    """
    return Perturbed(_computation(problem.id), sample)


def perturbed_steps(problem: Problem, sample: Mapping[str, Any]) -> Perturbed:
    """The same for the steps on the way to the answers."""
    return Perturbed(_computation_of_steps(problem.id), sample)


def perturbed_sequel(
    problem: Problem, key: str, sample: Mapping[str, Any], earlier: Mapping[str, Any]
) -> Perturbed:
    """The slips in computing the answer ``key`` from a student's ``earlier`` answers, {answer:
    points}.
    """
    columns = {
        n: column
        for name, points in earlier.items()
        for n, column in zip(_names(problem, name), np.array(points, float).T, strict=True)
    }
    return Perturbed(_sequel(problem.id, key), {**sample, **columns})


@cache
def _sequel(problem_id, key):
    """How an answer follows from earlier ones, their components named as givens are."""
    p, trace = find_problem(problem_id), Trace()
    stated = {n: p.answer(e).unit for e in earlier_answers(p)[key] for n in _names(p, e)}
    units, asked = {**p.units, **stated}, p.answer(key)
    base = {n: trace.new("argument", n) for n in units}
    g = p.base(dict.fromkeys(p.units, 1.0)).but(**{n: base[n] for n in p.units})
    earlier = {e: tuple(base[n] for n in _names(p, e)) for e in earlier_answers(p)[key]}
    answer = Traced(
        flat(follow_in_base(p, key, g, earlier)), asked.unit, POINTS if asked.kind.is_formula else 1
    )
    return Computation(Formulas({key: answer}, units, p.system, (), section(p.section), _means(p)))


def _names(p, key):
    """The names of the components of an answer."""
    length = p.answer(key).kind.length
    return [key] if length == 1 else [f"{key}_{n}" for n in range(1, length + 1)]


@cache
def _computation(problem_id):
    return Computation(formulas(find_problem(problem_id)))


@cache
def _computation_of_steps(problem_id):
    return Computation(formulas(find_problem(problem_id), of_steps=True))


def formulas(p: Problem, of_steps: bool = False) -> Formulas:
    """The traced answers of a problem, or its steps as answers, and the steps as stages on the
    way.
    """
    found = traced_quantities(p)
    asked = {a.key for a in p.answers}
    steps = [s for s in found.steps if s.key in found.components and s.key not in asked]
    answers = {
        a.key: Traced(found.components[a.key], a.unit, POINTS if a.kind.is_formula else 1)
        for a in p.answers
        if a.key in found.components
    }
    if of_steps:
        answers = {s.key: Traced(found.components[s.key], s.unit) for s in steps}
    stages = [Stage(s.key, _where(p, s), found.components[s.key], _named(s)) for s in steps]
    return Formulas(answers, p.units, p.system, stages, section(p.section), _means(p))


def _named(step):
    """What a step is in a few words: its name is not one of the text."""
    term = f"{step.term[0]} term" if step.term else "quantity on the way"
    return _brief(step.means) or term


def _means(p):
    return {n: _brief(q.means) for n, q in p.givens.items()}


def _brief(means):
    """The first words of a meaning, as "mass" of "mass, W/g"; "" if they are long."""
    first = re.split("[,;:(]", means)[0].strip()
    return first if len(first.split()) <= FEW and not re.search(r"[$\\{]", first) else ""


def _where(p, step):
    """Where a step is explained, or its problem, if that is in another chapter."""
    chapter = p.section.partition(".")[0]
    at, equation = (
        n if n.partition(".")[0] == chapter else "" for n in (step.section, step.equation)
    )
    return section(at or p.section) + (f", ({equation})" if equation else "")


def section(number: str) -> str:
    """A section of the book in words, "section 4.10"; "" for none."""
    return f"{'section' if number[0].isdigit() else 'appendix'} {number}" if number else ""

"""The computation of a problem, traced in base units, to find slips that no problem lists."""

import re
from collections.abc import Callable, Mapping
from functools import cache
from typing import Any

import numpy as np

from exercises.catalogue import Problem
from exercises.catalogue.following import earlier_answers, follow_in_base
from exercises.catalogue.steps import listed_steps
from exercises.catalogue.tracing import traced_quantities
from exercises.catalogue.variants import POINTS, flat
from exercises.catalogue.wording import term_text
from grader.scoring.slips.edits_of_setups import of_setups
from grader.scoring.slips.edits_of_terms import of_terms
from grader.scoring.slips.formulas import (
    Formulas,
    Intermediate,
    TracedAnswer,
    steps_needed,
    with_arguments,
)
from grader.scoring.slips.perturbed import Computation, Perturbed
from newton_euler.algebra.compile import Compiled
from newton_euler.algebra.language import Words, cached_by_language, spoken
from newton_euler.algebra.trace import Step, Trace
from newton_euler.algebra.units import unit
from newton_euler.algebra.vectors import Vector

FEW, MORE = 7, 11  # the most words for a given, and for a step, which has no other name


def perturbed(problem: Problem, sample: Mapping[str, Any], of_steps: bool = False) -> Perturbed:
    """The slips in the computation of the answers to ``problem``, or of the steps on the way to
    them, for a student's numbers in the units of the text.
    """
    return Perturbed(_computation(problem, of_steps), sample)


def perturbed_sequel(
    problem: Problem, key: str, sample: Mapping[str, Any], earlier: Mapping[str, Any]
) -> Perturbed:
    """The slips in computing the answer ``key`` from a student's ``earlier`` answers, {answer:
    points}.
    """
    return Perturbed(_sequel(problem, key), {**sample, **columns(problem, earlier)})


def columns(problem: Problem, earlier: Mapping[str, Any]) -> dict[str, Any]:
    """{name of a component: its number, or its points} of earlier answers."""
    return {
        n: column[0] if len(column) == 1 else np.array(column, float)
        for name, points in earlier.items()
        for n, column in zip(names(problem, name), zip(*points, strict=True), strict=True)
    }


@cached_by_language
def _sequel(p, key):
    return Computation(_following(p, key))


def _following(p, key):
    """How an answer follows from earlier ones, their components named as givens are."""
    if key not in earlier_answers(p):
        return followed(p)[key]
    trace = Trace()
    stated = {n: p.answer(e).unit for e in earlier_answers(p)[key] for n in names(p, e)}
    base = {n: trace.new("argument", n) for n in (*p.units, *stated)}
    g = p.base(dict.fromkeys(p.units, 1.0)).but(**{n: base[n] for n in p.units})
    earlier = {e: tuple(base[n] for n in names(p, e)) for e in earlier_answers(p)[key]}
    return _of_one(p, key, flat(follow_in_base(p, key, g, earlier)), stated)


def _of_one(p, key, parts, stated):
    asked = p.answer(key)
    points = POINTS if asked.kind.is_formula else 1
    answers = {key: TracedAnswer(parts, asked.unit, asked.kind, points)}
    own = {n: e.key for e in p.answers if e.kind.length > 1 for n in names(p, e.key) if n in stated}
    units, where = {**p.units, **stated}, section(p.section)
    return Formulas(answers, units, p.system, (), where, _means(p), components=own)


@cached_by_language
def followed(p: Problem) -> Mapping[str, Formulas]:
    """{later answer: how it is computed from earlier ones}, where the computation of the problem
    goes through these.
    """
    found, before = {}, dict[int, str]()
    components = traced_quantities(p).components if len(p.answers) > 1 else {}
    for key in (a.key for a in p.answers if a.key in components):
        leaves = with_arguments(components[key], before)
        used = {s.args[0] for s in steps_needed(leaves) if s.op == "argument"} - p.units.keys()
        if used and any(map(_is_computed, leaves)):
            earlier = [a for a in p.answers if used & {*names(p, a.key)}]
            stated = {n: a.unit for a in earlier for n in names(p, a.key)}
            found[key] = _of_one(p, key, leaves, stated)
        for n, x in zip(names(p, key), components[key], strict=True):
            if _is_computed(x) and n not in p.units:
                before.setdefault(x.number, n)
    return found


@cache
def computed_from(p: Problem) -> dict[str, tuple[str, ...]]:
    """{later answer: names of the earlier ones that its computation goes through}."""
    return {
        key: tuple(a.key for a in p.answers if names(p, a.key)[0] in formulas.units)
        for key, formulas in followed(p).items()
    }


@cache
def earlier_of(p: Problem) -> dict[str, tuple[str, ...]]:
    """{later answer: names of the earlier ones from which it follows}."""
    return computed_from(p) | earlier_answers(p)


@cache
def sequel_of(p: Problem, key: str) -> Callable[..., list[Any]]:
    """An answer of :func:`followed` from the values and the components of earlier ones by name."""
    f = followed(p)[key]
    (answer,) = f.answers.values()
    to_base = {
        s.args[0]: unit(f.units[s.args[0]]).to_base(1.0, f.system)
        for s in steps_needed(answer.parts)
        if s.op == "argument"
    }
    trace = next(x.trace for x in answer.parts if isinstance(x, Step))
    run = Compiled("sequel", list(to_base), trace, answer.parts)
    factor = unit(answer.unit).from_base(1.0, f.system)
    return lambda values: [factor * x for x in run(*(values[n] * u for n, u in to_base.items()))]


def _is_computed(x):
    while isinstance(x, Step) and x.op == "neg":
        x = x.args[0]
    return isinstance(x, Step) and x.op != "argument"


def names(p: Problem, key: str) -> list[str]:
    """The names of the components of an answer in how others follow from it."""
    length = p.answer(key).kind.length
    return [key] if length == 1 else [f"{key}_{n}" for n in range(1, length + 1)]


@cached_by_language
def _computation(p, of_steps):
    return Computation(formulas(p, of_steps))


def formulas(p: Problem, of_steps: bool = False) -> Formulas:
    """The traced answers of a problem, or its steps as answers, and the steps as stages on the
    way.
    """
    found = traced_quantities(p)
    asked = {a.key for a in p.answers}
    steps = [s for s in found.steps if s.key in found.components and s.key not in asked]
    answers = {
        a.key: TracedAnswer(
            _with_zeros(found.components[a.key], a.kind),
            a.unit,
            a.kind,
            POINTS if a.kind.is_formula else 1,
        )
        for a in p.answers
        if a.key in found.components
    }
    if of_steps:
        answers = {s.key: TracedAnswer(found.components[s.key], s.unit, s.kind) for s in steps}
    stages = [
        Intermediate(s.key, _where(p, s), found.components[s.key], s.kind, _named(s)) for s in steps
    ]
    symbols = p.units.keys() - p.givens.keys()
    where, means = section(p.section), _means(p)
    solved, given = found.solved, found.givens
    setups = [] if of_steps else [*_setups(p, answers.keys(), given)]
    return Formulas(
        answers, p.units, p.system, stages, where, means, solved, symbols, given, setups
    )


def _setups(p, keys, given):
    """The slips in setting up the system, as they show in the answers ``keys``."""
    g = p.base(dict.fromkeys(p.units, 1.0)).but(**given)

    def compute(changes):
        right = p.code.solve(g.but(**changes))
        return {key: flat(right[key]) for key in keys}

    yield from of_setups(compute, given, {a.key for a in p.answers if a.kind.is_vector})
    vectors = {k: v for k, v in p.code.solve(g).items() if k in keys and isinstance(v, Vector)}
    steps = {s.key: s.value for s in listed_steps(p, g)}
    sizes = {key: steps[step] for key, step in sizes_of(p).items() if key in keys}
    yield from of_terms(vectors, sizes, lambda name, v: term_text(name, v.equation, p))


@cache
def sizes_of(p: Problem) -> Mapping[str, str]:
    """{answer: the step of which it is the size}, where this is a vector with named terms."""
    found = traced_quantities(p)
    vectors = [(s.key, s.value) for s in found.steps if isinstance(s.value, Vector)]
    terms = [(key, v.norm()) for key, v in vectors if v.terms]
    sizes = {x.number: key for key, x in terms if isinstance(x, Step)}
    parts = found.components.items()
    return {k: sizes[x.number] for k, (x, *_) in parts if getattr(x, "number", -1) in sizes}


def _with_zeros(parts, kind):
    """The components of a vector, its zeros as steps, so that a slip can be made in them."""
    trace = next((x.trace for x in parts if isinstance(x, Step)), None) if kind.is_vector else None
    return [
        trace.new("*", 0.0, 0.0) if trace and not isinstance(x, Step) and x == 0 else x
        for x in parts
    ]


def _named(step):
    """A step in a few words, since its name does not occur in the text."""
    if brief := _brief(spoken(step.means), MORE):
        owner, _, rest = brief.partition(" ")
        if owner in ("its", "their"):  # refers to the step before
            return Words("the {what}", what=f"{rest} {step.key}")
        return Words("the {what}", what=brief.removeprefix("the "))
    return term_text(*step.term) if step.term else ""


def _means(p):
    return {n: _brief(q.means) for n, q in p.givens.items()}


def _brief(means, most=FEW):
    """The first words of a meaning, as "mass" of "mass, W/g"; "" if they are long."""
    first = re.split("[,;:=]", re.sub(r"(?<!\bof )\(.*", "", means))[0].strip()
    is_whole = not re.search(r"[$\\{]|[-+*/]$", first)
    return first if len(first.split()) <= most and is_whole else ""


def _where(p, step):
    """Where a step is explained, or its problem, if that is in another chapter."""
    chapter = p.section.partition(".")[0]
    at, equation = (
        n if n.partition(".")[0] == chapter else "" for n in (step.section, step.equation)
    )
    found = section(at or p.section)
    return Words("{section}, ({equation})", section=found, equation=equation) if equation else found


@cache
def section(number: str) -> str:
    """A section of the book in words, "section 4.10"; "" for none."""
    if not number:
        return ""
    if number[0].isdigit():
        return Words("section {number}", number=number)
    return Words("appendix {number}", number=number)

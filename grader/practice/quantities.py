"""The quantities that practice checks: the steps of a problem, then its answers, with right numbers
and wrong models.
"""

import contextlib
import math
from typing import Any

import numpy as np

from exercises.catalogue import Problem
from exercises.catalogue.steps import in_unit, listed_steps, repeated, steps
from exercises.catalogue.variants import at_points, flat
from newton_euler.algebra.language import spoken
from newton_euler.algebra.vectors import Vector
from newton_euler.answers.causes import listed
from newton_euler.answers.kinds import KINDS
from newton_euler.answers.notation import symbol
from newton_euler.answers.tolerance import is_apart

from ..assignment.cells import Values
from ..assignment.notebook import typeset
from ..scoring.wrong_models import general_models
from .plain import plain

KEPT = 10  # digits of numbers of wrong models
NOISE = 1e-12  # below this, in the unit of the text, model and key are both zero


def quantities(p: Problem, values: Values) -> tuple[list[dict[str, Any]], dict[str, Any]]:
    """([description for the file], {key: numbers or word}) of all quantities, steps first."""
    described, right = [], {}
    for s in [s for s in steps(p, values) if s.key not in repeated(p)]:
        described.append({
            "key": s.key, "kind": s.kind.name, "unit": s.unit, "means": typeset(spoken(s.means), p),
            "plain": plain(spoken(s.means), p.units), "section": s.section or p.section,
            "equation": s.equation, "latex": symbol(s.key, s.is_vector), "atol": 0.0, "of": [],
            "sum": s.of, "step": True, "rtol": p.answers[0].rtol,
        })  # fmt: skip
        right[s.key] = _numbers(s.value, s.kind)
    for key, x in p.solve(values).items():
        a, is_sum = p.answer(key), isinstance(x, Vector) and len(x.terms) > 1
        described.append({
            "key": key, "kind": a.kind.name, "unit": a.unit, "means": typeset(a.means, p),
            "plain": plain(a.means, p.units), "section": p.section,
            "equation": x.equation.number if is_sum else "", "latex": p.notation[key],
            "atol": a.atol, "of": list(a.of), "sum": "", "step": False, "rtol": a.rtol,
        })  # fmt: skip
        right[key] = _numbers(x, a.kind)
    return described, right


def _numbers(x, kind):
    return x if kind.is_word else [float(part) for part in flat(x)]


def wrong_numbers(
    p: Problem, values: Values, described: list[dict[str, Any]], right: dict[str, Any]
) -> list[tuple]:
    """[(key, cause, numbers)] of the wrong models of all quantities, where they differ from the
    key.
    """
    g = p.base(values)
    found = []
    _, wrong = at_points(p, values)
    for name, answers in wrong.items():
        cause = listed(name, p.mistakes[name])
        for key, (point,) in answers.items():
            found.append((key, cause, point[0] if p.answer(key).kind.is_word else point))
    with np.errstate(all="ignore"):
        for compute in (_answers_of(p), _steps_of(p)):
            with contextlib.suppress(ArithmeticError, ValueError):
                found += general_models(p, g, compute(g), compute)
    kinds = {q["key"]: KINDS[q["kind"]] for q in described}
    return [
        (key, cause, _short(x)) for key, cause, x in found if _differs(kinds[key], x, right[key])
    ]


def _answers_of(p):
    def compute(g):
        found = {k: x for k, x in p.code.solve(g).items() if not p.answer(k).kind.is_word}
        return p.in_units(found)

    return compute


def _steps_of(p):
    def compute(g):
        found = {s.key: in_unit(s.value, s.unit, p.system) for s in listed_steps(p, g)}
        return {k: x for k, x in found.items() if not (isinstance(x, str) or k in repeated(p))}

    return compute


def _differs(kind, x, right):
    """True if a model has real numbers that differ from the key."""
    if kind.is_word:
        return isinstance(x, (str, int)) and x != right
    key, numbers = (tuple(right),), (tuple(float(part) for part in x),)
    size = math.hypot(*numbers[0], *right)  # a mistake is invisible if both are zero
    return size > NOISE and math.isfinite(size) and is_apart(kind.like(numbers, key), key)


def _short(x):
    """Numbers rounded; a word or count unchanged."""
    return x if isinstance(x, (str, int)) else [float(f"{float(part):.{KEPT}g}") for part in x]

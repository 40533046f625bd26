"""Checks of a problem: its two ways to the key against each other, its units, and its mistakes
against the key.
"""

import random

from mpmath import mp, mpf

from newton_euler.algebra.scalars import max_abs
from newton_euler.algebra.units import Dimension, DimensionError, unit

from .catalogue import CatalogueError
from .proofs import DIGITS
from .variants import SEPARATION, distance, draw, evaluate, flat, symbol_values

# relative, solve in floats against prove; in 50 digits they must agree to the square of it
AGREEMENT = 1e-9
_SEED = b"check"


def check(p, seeds=1):
    """Everything that is wrong with problem ``p``, as sentences; an empty list if it holds.

    Checks the book's numbers (seed 0) and ``seeds - 1`` drawn variants: solve against prove in
    floats and in 50 digits, every mistake away from the key, and once the units of every answer by
    running ``solve`` on dimensions.
    """
    faults = _fit(p) or _dimensions(p)
    for n in range(seeds):
        faults = faults or [f"{fault} (seed {n})" for fault in _agreement(p, n)]
    return faults


def values(p, seed):
    """The book's numbers for seed 0, otherwise a drawn variant; with a value for every symbol."""
    given = p.book_values if seed == 0 else draw(p, _SEED + str(seed).encode())
    return {**given, **symbol_values(p, random.Random(f"{p.id}:{seed}"))}


def _fit(p):
    """Names in the text against names in the code."""
    try:
        g = p.base(values(p, 0))
        named, solved, proved = (
            p.code.mistakes(g),
            p.code.solve(g),
            p.code.prove(_precise(p, values(p, 0))),
        )
    except CatalogueError as error:
        return [str(error)]
    missing = [m for m in p.mistakes if m not in named]
    faults = [
        f"the mistake {m} is in {p.name}.yaml but not computed; compute it, or move it to "
        "struck: with a reason"
        for m in missing
    ]
    faults += [
        f"the mistake {m} is computed but not in {p.name}.yaml"
        for m in named
        if m not in p.mistakes
    ]
    asked = [a.key for a in p.answers]
    for what, got in (("solve", solved), ("prove", proved)):
        if list(got) != asked:
            return [*faults, f"{what} returns {list(got)} but the problem asks for {asked}"]
    for name, answers in named.items():
        if not answers or not set(answers) <= set(asked):
            faults.append(
                f"the mistake {name} must give some of {asked}, and gives {list(answers)}"
            )
        for key, answer in answers.items():
            if (
                key in solved
                and hasattr(answer, "frame")
                and answer.frame.name != solved[key].frame.name
            ):
                faults.append(
                    f"{key} is in {solved[key].frame.name}, but the mistake {name} has it in "
                    f"{answer.frame.name}: use in_frame"
                )
    return faults


def _dimensions(p):
    """Run solve on dimensions: a sum of unlike quantities raises, and each answer must have the
    dimension of its unit.
    """
    pure = p.base(dict.fromkeys(p.units, 1.0))
    g = pure.but(**{n: unit(u).dimension for n, u in p.units.items()})
    try:
        answers = p.code.solve(g)
    except DimensionError as error:
        return [f"solve adds unlike quantities: {error}"]
    faults = []
    for key, answer in answers.items():
        a = p.answer(key)
        if a.kind in ("count", "choice"):
            continue
        asked = unit(a.unit).dimension
        for x in flat(answer):
            if x != asked if isinstance(x, Dimension) else x and any(asked.powers):
                faults.append(f"{key} is asked for in {a.unit}, {asked}, but solve gives {x}")
    return faults or _exchanged(p, g)


def _exchanged(p, g):
    """Mistakes whose answer has the dimension of another answer: stored under the wrong key. Other
    dimensions may be what is wrong about them.
    """
    try:
        named = p.code.mistakes(g)
    except DimensionError:  # a wrong model may add unlike quantities
        return []
    asked = {a.key: unit(a.unit).dimension for a in p.answers if a.kind not in ("count", "choice")}
    faults = []
    for name, answers in named.items():
        for key, answer in answers.items():
            found = {x for x in flat(answer) if isinstance(x, Dimension)} - {asked.get(key)}
            faults += [
                f"the mistake {name} gives {key} the dimension of {k}"
                for k, d in asked.items()
                if key in asked and d in found
            ]
    return faults


def _precise(p, given):
    with mp.workdps(DIGITS):
        return p.base({n: mpf(repr(v)) for n, v in given.items()})


def _agreement(p, seed):
    try:
        given = values(p, seed)
        right, wrong = evaluate(p, given)
    except CatalogueError as error:
        return [str(error)]
    with mp.workdps(DIGITS):
        g = _precise(p, given)
        proved, precise = p.in_units(p.code.prove(g)), p.in_units(p.code.solve(g))
    faults = []
    for key in right:
        a = p.answer(key)
        if a.kind in ("count", "choice"):
            if proved[key] != right[key][0]:
                faults.append(f"{key}: solve says {right[key][0]}, prove says {proved[key]}")
            continue
        for numbers, tolerance, how in (
            (right[key], AGREEMENT, "floats"),
            (flat(precise[key]), AGREEMENT**2, "50 digits"),
        ):
            by_proof = flat(proved[key])
            gap = _gap(numbers, by_proof)
            if not gap <= tolerance:
                faults.append(
                    f"{key}: solve in {how} and prove differ by {gap:.1e} of its size: "
                    f"{_shown(numbers)} against {_shown(by_proof)}"
                )
    for name, answers in wrong.items():
        for key, answer in answers.items():
            if (
                p.answer(key).kind not in ("count", "choice")
                and distance(answer, right[key]) < SEPARATION
            ):
                faults.append(f"the mistake {name} gives nearly the right {key}: {_shown(answer)}")
    return faults


def _gap(a, b):
    with mp.workdps(DIGITS):
        if len(a) != len(b):
            return float("inf")
        whole = mp.sqrt(sum(mpf(y) ** 2 for y in b))
        return float(
            mp.sqrt(sum((mpf(x) - y) ** 2 for x, y in zip(a, b, strict=True))) / (whole or 1)
        )


def _shown(numbers):
    return "(" + ", ".join(f"{max_abs(x) * (1 if x >= 0 else -1):.6g}" for x in numbers) + ")"


__all__ = ["AGREEMENT", "check", "values"]

"""Measuring how well practice explains wrong answers: listed mistakes, common slips in every step,
and random numbers.
"""

import json
import math
import random
import statistics
import time
from collections import Counter
from collections.abc import Callable, Iterable, Sequence
from typing import Any

from exercises.catalogue import Problem
from newton_euler.answers.causes import (
    OPPOSITE,
    ROUNDED,
    Cause,
    exchanged_components,
    left_out_components,
    reversed_components,
)
from newton_euler.answers.kinds import KINDS, Kind
from newton_euler.answers.tolerance import is_apart
from newton_euler.classroom.practising.problems import PracticeProblem
from newton_euler.classroom.practising.progress import Progress

from ..course.processes import process_pool
from .build import LeftOut, page_of
from .quantities import NOISE

LISTED, SLIPS, RANDOM = "listed mistakes", "slips in steps", "random numbers"
DIGITS = 6  # digits of a student's answer
RANDOMS = 5  # answers for each quantity, within a factor of three of the size of the right one


def practice_shares(
    problems: Iterable[Problem], variants: int, progress: Callable[[], object] = lambda: None
) -> tuple[dict[str, Counter], float]:
    """{kind of answer: Counter of named, misnamed, unnamed, passed} over ``variants`` sets of
    numbers of each problem, and the median time of a check in seconds.

    A slip also counts as named if it is taken for another one with the same numbers.
    """
    found: dict[str, Counter] = {LISTED: Counter(), SLIPS: Counter(), RANDOM: Counter()}
    times: list[float] = []
    with process_pool() as pool:
        names = [p.id for p in problems]
        for shares, took in pool.map(_measured, names, [variants] * len(names)):
            for name, counts in shares.items():
                found[name].update(counts)
            times += took
            progress()
    return found, statistics.median(times) if times else 0.0


def _measured(name, variants):
    found, times = {LISTED: Counter(), SLIPS: Counter(), RANDOM: Counter()}, []
    page = page_of(name, variants, "solution", draw=lambda p, values: None)
    for n in range(0 if isinstance(page, LeftOut) else len(page[0]["variants"])):
        _measure(page[0], n, found, times)
    return found, times


class _Memory:
    """A practice file of one page, in memory."""

    help = "solution"

    def __init__(self, page):
        self._page = json.loads(json.dumps(page))

    def page(self, problem):
        return self._page


def _measure(page, number, found, times):
    p = PracticeProblem(_Memory(page), page["id"], Progress(None))
    for _ in range(number):
        p.new()
    variant, labels = page["variants"][number], page["labels"]
    asked = {q["key"]: q for q in page["quantities"] if q["key"] in variant["right"]}
    models = {}
    for label, x in variant["wrong"]:
        key, *cause = labels[label]
        models.setdefault(key, []).append((Cause(*cause), x))
    rng = random.Random(f"{page['id']} {number}")
    for key, q in asked.items():
        right = variant["right"][key]
        for cause, x in models.get(key, ()):
            if cause.group == "listed":
                found[LISTED][_outcome(p, q, x, right, cause, models[key], times)] += 1
            elif q["step"] and cause.group in ("omitted", "term", "unit", "axes"):
                found[SLIPS][_outcome(p, q, x, right, cause, models[key], times)] += 1
        if KINDS[q["kind"]].is_word:
            continue
        for cause, x in slips(KINDS[q["kind"]], right) if q["step"] else ():
            found[SLIPS][_outcome(p, q, x, right, cause, models.get(key, []), times)] += 1
        size = math.hypot(*right) or 1.0
        for _ in range(RANDOMS):
            direction = [rng.gauss(0, 1) for _ in right]
            scale = size * 3 ** rng.uniform(-1, 1) / math.hypot(*direction)
            x = [scale * part for part in direction]
            found[RANDOM][_outcome(p, q, x, right, None, models.get(key, []), times)] += 1


def _outcome(p, q, x, right, cause, models, times):
    """The outcome for a wrong value: named, misnamed, unnamed or passed."""
    checked = _checked(p, q, x, times)
    if checked.verdicts[q["key"]] == "right":
        return "passed"
    # an observation does not name a mistake
    named = {c for c in checked.explained[q["key"]] if c != ROUNDED and not c.is_observation}
    if not named:
        return "unnamed"
    same = {c for c, other in models if _equal(x, other)}
    if not KINDS[q["kind"]].is_word:
        same |= {c for c, other in slips(KINDS[q["kind"]], right) if _equal(x, other)}
    return "named" if cause is None or {cause, *same} & named else "misnamed"


def _checked(p, q, x, times):
    check = p.check_step if q["step"] else p.check
    p.forget()
    given, start = {q["key"]: _written(x, KINDS[q["kind"]])}, time.perf_counter()
    checked = check(**given)
    times.append(time.perf_counter() - start)
    return checked


def _written(x, kind):
    if not isinstance(x, list):
        return x
    return kind.nested([float(f"{part:.{DIGITS}g}") for part in x])


def _equal(x, other):
    if not isinstance(x, list) or not isinstance(other, list):
        return x == other
    return math.dist(x, other) <= 10 ** (1 - DIGITS) * math.hypot(*x)


def slips(kind: Kind, right: Sequence[float]) -> list[tuple[Any, list[float]]]:
    """[(cause, numbers)] of general slips that change the answer: signs, components exchanged or
    left out.
    """
    found = [(OPPOSITE, [-x for x in right])]
    size = math.hypot(*right)
    if kind.is_vector:
        there = [n for n, x in enumerate(right) if abs(x) > 1e-9 * size]
        for n in there if len(there) > 1 else ():
            turned = [-x if m == n else x for m, x in enumerate(right)]
            found.append((reversed_components([n]), turned))
            without = [0.0 if m == n else x for m, x in enumerate(right)]
            found.append((left_out_components([n]), without))
        for a, b in ((0, 1), (1, 2), (0, 2)):
            swapped = list(right)
            swapped[a], swapped[b] = right[b], right[a]
            found.append((exchanged_components((a, b)), swapped))
    return [(c, x) for c, x in found if size > NOISE and is_apart((tuple(x),), (tuple(right),))]

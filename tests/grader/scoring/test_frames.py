"""One vector is one guess, in every problem that asks for one."""

import itertools
import math

import pytest

from exercises.catalogue import chapters, problems
from exercises.catalogue.checks import values as numbers
from exercises.catalogue.variants import evaluate
from grader.scoring import score_receipt
from newton_euler import Frame
from newton_euler.answers.receipts import record


def vectors(chapter):
    """(problem, answer, numbers, components) of all that ask for a vector."""
    for p in problems(chapter):
        values = numbers(p, 1)
        for a in p.answers:
            if a.kind.name == "vector":
                yield p, a, values, [float(x) for x in evaluate(p, values)[0][a.key]]


def earns(p, a, values, value):
    read, faults = record({a.key: a.form}, {}, {a.key: value})
    score = score_receipt(p, values, {"answers": read, "faults": faults})
    return next(part.points for part in score.parts if part.key == a.key) > 0


@pytest.mark.one_in(3)
@pytest.mark.parametrize("chapter", chapters())
def test_half_turns_of_frames_give_no_further_guesses(chapter):
    """Of all patterns of sign one earns the points."""
    mine = Frame("ground")
    for axis in "xyx":
        mine = mine.rotate("mine", axis, angle=math.pi, rate=1.0)
    for p, a, values, key in vectors(chapter):
        signs = itertools.product(*((1, -1) if abs(x) > 1e-9 * math.hypot(*key) else (1,)
                                    for x in key))  # fmt: skip
        passed = [s for s in signs
                  if earns(p, a, values, mine.vector(*(n * x for n, x in zip(s, key, strict=True))))]  # fmt: skip
        assert len(passed) == 1, (p.id, a.key, passed)


@pytest.mark.parametrize("chapter", chapters())
def test_the_vector_of_the_model_is_right_as_the_model_has_it(chapter):
    for p, a, values, _ in vectors(chapter):
        assert earns(p, a, values, p.solve(values)[a.key]), (p.id, a.key)

"""Random receipts: they earn nothing unless they are right, raise nothing, and none takes long."""

import json
import random
import time

import numpy as np
import pytest

from exercises.catalogue import problems
from exercises.catalogue.variants import draw, evaluate, symbol_values
from grader.scoring import score_receipt
from newton_euler.answers.trees import evaluate as tree_value

from .answered import right_trees
from .random_receipts import receipt

CH04 = problems("ch04")
VALUES = {p.id: draw(p, b"random receipts") for p in CH04}
LONGEST = 0.05  # seconds of the scorer's own time for one receipt
KEYS = {p.id: right_trees(p, VALUES[p.id]) for p in CH04}


def is_right(p, key, tree):
    """Whether an answer is right, found in another way: formulas at points of its own."""
    readings = tree.values() if isinstance(tree, dict) else [tree]
    sample = {n: np.array([x]) for n, x in symbol_values(p, random.Random(7)).items()}
    right = np.ravel(evaluate(p, {**VALUES[p.id], **sample})[0][key]).astype(float)
    for reading in readings:
        parts = reading if len(right) > 1 else [reading]
        with np.errstate(all="ignore"):
            got = np.array([np.ravel(tree_value(x, sample))[0] for x in parts])
        near = np.linalg.norm(got - right) <= 0.005001 * np.linalg.norm(right)
        if near or np.linalg.norm(got) <= 1e-6 >= np.linalg.norm(right):
            return True
    return False


def took(p, given):
    """(the scorer's own time for a receipt, the score)."""
    start = time.process_time()
    score = score_receipt(p, VALUES[p.id], given)
    return time.process_time() - start, score


def try_receipts(seed, count):
    """The longest time of ``count`` receipts; of slow ones the shortest of ten tries."""
    rng, longest = random.Random(seed), 0.0
    for _ in range(count):
        p = rng.choice(CH04)
        given = receipt(rng, p, KEYS[p.id])
        seconds, score = took(p, given)
        if seconds > longest:
            longest = max(longest, min([seconds, *(took(p, given)[0] for _ in range(9))]))
        assert [part.key for part in score.parts] == [a.key for a in p.answers]
        assert all(part.message.isprintable() for part in score.parts)
        assert json.loads(score.json())["points"] == score.points
        for part in score.parts:
            if part.points:
                assert is_right(p, part.key, given["answers"][part.key]), (p.id, given)
    return longest


def test_random_receipts_earn_nothing_unless_right_and_raise_nothing():
    for seed in range(2):
        try_receipts(seed, 500)


def warm_up():
    """Trace the key and the wrong models of every problem, which is done once."""
    for p in CH04:
        zeros = {a.key: [0.0] * 3 if a.kind.is_vector else 0.5 for a in p.answers}
        score_receipt(p, VALUES[p.id], {"answers": zeros})


@pytest.mark.slow
def test_a_million_random_receipts_and_none_takes_longer_than_its_limit():
    warm_up()
    longest = max(try_receipts(f"slow {n}", 10_000) for n in range(100))
    assert longest < LONGEST, longest

"""What scoring a receipt costs, relative to solving its problem once by the engine: in one run, for
a class that has everything right and one that has everything wrong.
"""

import time

import pytest

from exercises.catalogue import problems
from exercises.catalogue.variants import POINTS, draw
from grader.scoring import score_receipt
from grader.scoring.numbers import numbers_of
from newton_euler.answers.receipts import record

pytestmark = [pytest.mark.benchmark, pytest.mark.slow]
CH04 = problems("ch04")
STUDENTS = 40


def right_answers(p, values):
    forms = {a.key: a.form for a in p.answers}
    units = {n: s.unit for n, s in p.symbols.items()}
    return record(forms, units, p.solve({**p.sympy_symbols(), **values}))[0]


def too_large(kind, tree):
    if kind.endswith("expression"):
        return [["*", 1.37, x] for x in tree] if kind.startswith("vector") else ["*", 1.37, tree]
    return [1.37 * x for x in tree] if isinstance(tree, list) else 1.37 * tree


def seconds(work):
    """The CPU time for all problems of all students, the least of three rounds."""
    best = []
    for _ in range(3):
        start = time.process_time()
        for student in range(STUDENTS):
            for p in CH04:
                work(p, student)
        best.append(time.process_time() - start)
    return min(best)


def test_scoring_a_class_against_solving_its_problems():
    values = [{p.id: draw(p, f"s{n}".encode()) for p in CH04} for n in range(STUDENTS)]
    right = [{p.id: right_answers(p, v[p.id]) for p in CH04} for v in values]
    off = lambda p, r: {a.key: too_large(a.kind.name, r[p.id][a.key]) for a in p.answers}
    wrong = [{p.id: off(p, r) for p in CH04} for r in right]
    samples = [{p.id: numbers_of(p, v[p.id]).sample for p in CH04} for v in values]
    solving = seconds(lambda p, n: p.solve(samples[n][p.id]))
    costs = {}
    for name, answers in (("right", right), ("wrong", wrong)):
        receipts = [{i: {"answers": found} for i, found in own.items()} for own in answers]
        costs[name] = seconds(
            lambda p, n, r=receipts: score_receipt(p, values[n][p.id], r[n][p.id])
        )
        each, of_solving = 1e6 * costs[name] / STUDENTS / len(CH04), costs[name] / solving
        print(f"\n{name}: {each:.0f} us a receipt, {of_solving:.2f} of solving it", end="")
    print(f"; formulas are compared at {POINTS} points")
    assert costs["right"] < solving
    # each wrong part is compared with some hundred slips, computed for the student's numbers and
    # again from their own earlier answers: half of this time, and what names 5 wrong parts in 6
    assert costs["wrong"] < 7 * solving  # 4.5 to 6.2 are measured on a quiet machine

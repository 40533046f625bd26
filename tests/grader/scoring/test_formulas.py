"""Formulas: equivalent ones are right, nearly equal ones wrong, at points that are the same for all."""

import pytest

from exercises.catalogue import problem
from exercises.catalogue.variants import POINTS
from grader.scoring import score_receipt
from grader.scoring.numbers import Numbers, numbers_of
from newton_euler.answers.trees import NODES
from tests.grader.scoring.answered import judged

OMEGA, NU, D, TILT = "omega", "nu", "d", "tilt"
SPEED = ["^", ["+", ["^", NU, 2], ["^", ["*", OMEGA, D, ["sin", TILT]], 2]], 0.5]  # 4/2
OF_COSINE = ["+", 1, ["*", -1, ["^", ["cos", TILT], 2]]]
IN_DEGREES = ["sin", ["*", "pi", ["/", TILT, 180]]]


@pytest.mark.parametrize("tree", [
    SPEED,
    ["sqrt", ["+", ["*", NU, NU], ["*", OMEGA, OMEGA, D, D, OF_COSINE]]],
    ["*", NU, ["sqrt", ["+", 1.0, ["^", ["/", ["*", OMEGA, D, ["sin", TILT]], NU], 2.0]]]],
    ["*", ["/", "pi", 3.1416], SPEED],
    ["Abs", ["*", -1, SPEED]],
    ["exp", ["log", SPEED]],
    ["+", SPEED, ["*", 1e-6, OMEGA, D]],
])  # fmt: skip
def test_equivalent_formulas_are_right(tree):
    assert judged(problem("4/2"), {"speed": tree})["speed"].verdict == "right"


@pytest.mark.parametrize("tree", [
    ["*", 1.0002, SPEED],
    ["+", SPEED, ["*", 3e-4, OMEGA, D]],
    ["^", ["+", ["^", NU, 2], ["^", ["*", OMEGA, D, TILT], 2]], 0.5],  # sin x = x for small x
    ["^", ["+", ["^", NU, 2], ["^", ["*", OMEGA, D, IN_DEGREES], 2]], 0.5],
    ["+", NU, ["*", OMEGA, D, ["sin", TILT]]],
    1.234,
    NU,
    "pi",
])  # fmt: skip
def test_nearly_equal_formulas_are_wrong(tree):
    assert judged(problem("4/2"), {"speed": tree})["speed"].verdict == "wrong"


def test_a_formula_is_compared_at_the_same_points_for_everyone():
    sample = numbers_of(problem("4/2"), {}).sample
    again = Numbers(problem("4/2"), {}).sample
    assert all((sample[n] == again[n]).all() and len(sample[n]) == POINTS for n in sample)


def test_an_imaginary_part_is_not_dropped_and_a_number_beside_formulas_is_one_number():
    trick = ["+", SPEED, ["*", 5.0, ["^", -1.0, 0.5]]]
    assert judged(problem("4/2"), {"speed": trick})["speed"].verdict == "unreadable"
    # not one for each point at which the formulas are compared
    p = problem("A/9")
    answers = {"dudt": [["*", 4, "t"], ["*", 6, "t"], ["+", ["*", 2, "t"], -1]]}
    parts = score_receipt(p, p.book_values, {"answers": {**answers, "dudt_1": [8, 12, 3]}}).parts
    assert [x.verdict for x in parts] == ["right", "right"]
    wrong = score_receipt(p, p.book_values, {"answers": {"dudt_1": [8, 11, 3]}}).parts[1]
    assert wrong.diagnosis.startswith("keeps the constant along j")


def test_formulas_have_their_operations_together_and_each():
    padded = ["+", SPEED, *[["*", 0, OMEGA] for _ in range(NODES // 3)]]
    part = judged(problem("4/2"), {"speed": padded})["speed"]
    assert (part.points, part.verdict) == (0, "unreadable")
    assert "more than 5000 operations" in part.message
    half = ["+", SPEED, *[["*", 0, OMEGA] for _ in range(NODES // 5)]]
    parts = judged(problem("4/2"), {"speed": half, "acc_mag": half})
    assert [part.verdict for part in parts.values()] == ["right", "unreadable"]


@pytest.mark.parametrize(("x", "silent"), [(10.4, True), (10.4173, False)])
def test_a_number_of_few_digits_beside_a_formula_is_met_by_chance(x, silent):
    """10.4 - 6.6 + 1.4 is half of 10.4, as happens with many numbers of two digits."""
    values = {"N_x": x, "N_y": -6.6, "N_z": 1.4}
    plane = ["+", *(["*", a, b] for a, b in zip(values.values(), "xyz", strict=True)), -x / 2]
    causes = judged(problem("A/27"), {"F": plane}, values)["F"].causes
    assert all(c.is_observation for c in causes) is silent

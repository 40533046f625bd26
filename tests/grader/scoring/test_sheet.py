"""Points of a sheet: shared out by weights, and scored as the sheet asked, whatever the exercise
asks today.
"""

from dataclasses import replace

import pytest

from exercises.catalogue import problem
from exercises.catalogue.variants import draw
from grader.scoring import ScoreError, score_receipt
from tests.grader.scoring.answered import right_trees

ELBOW = problem("4/16")  # alpha_CD, v_D, a_D
VALUES = draw(ELBOW, b"tests of sheet")


def key(p=ELBOW, values=VALUES):
    return right_trees(p, values)


def earned(answers, p=ELBOW, values=VALUES, **sheet):
    score = score_receipt(p, values, {"answers": answers}, **sheet)
    return score.points, score.out_of, [(part.points, part.out_of) for part in score.parts]


@pytest.mark.parametrize("points", [0, 1, 3, 9, 10, 0.1, 2.5, 7])
def test_all_right_earns_what_the_cell_is_worth_and_never_more(points):
    assert earned(key(), points=points)[:2] == (points, points)


def test_one_right_of_three_earns_a_third_and_without_points_each_is_worth_one():
    assert earned({"v_D": key()["v_D"]}, points=9) == (3, 9, [(0, 3), (3, 3), (0, 3)])
    assert earned(key())[2] == [(1, 1)] * 3


def test_weights_share_the_points_and_may_be_zero_or_those_of_the_exercise():
    weights = {"alpha_CD": 1, "v_D": 2, "a_D": 3}
    assert earned(key(), points=12, weights=weights)[2] == [(2, 2), (4, 4), (6, 6)]
    assert earned(key(), weights={"a_D": 4})[2] == [(0.5, 0.5), (0.5, 0.5), (2, 2)]
    assert earned(key(), points=4, weights={"alpha_CD": 0})[2] == [(0, 0), (2, 2), (2, 2)]
    assert earned(key(), points=4, weights=dict.fromkeys(key(), 0))[:2] == (0, 0)
    answers = tuple(replace(a, weight=3.0 if a.key == "a_D" else 1.0) for a in ELBOW.answers)
    p = replace(ELBOW, answers=answers)
    assert earned(key(), p, points=10)[2] == [(2, 2), (2, 2), (6, 6)]
    assert earned(key(), p, points=10, weights={"a_D": 0.5})[2] == [(4, 4), (4, 4), (2, 2)]


def test_what_follows_may_earn_all_and_what_the_sheet_did_not_ask_for_nothing():
    assert earned(key(), points=3, follow_through=1)[0] == 3
    asked = {"a_D": "vector, mm/s^2", "v_D": "vector, mm/s"}
    score = score_receipt(ELBOW, VALUES, {"answers": key()}, asked=asked)
    assert [(part.key, part.points) for part in score.parts] == [("a_D", 1), ("v_D", 1)]


@pytest.mark.parametrize(("sheet", "message"), [
    ({"points": -1}, "the points of 4/16 must be a number, 0 or more, not -1"),
    ({"follow_through": 1.01}, "follow_through must be a share from 0 to 1, not 1.01"),
    ({"points": float("nan")}, "the points of 4/16 must be a number"),
    ({"points": True}, "the points of 4/16 must be a number"),
    ({"weights": {"v_D": "2"}}, "the weight of v_D in 4/16 must be a number"),
    ({"weights": {"v": 2}}, "a weight for v in 4/16.*it asks for alpha_CD, v_D, a_D"),
    ({"asked": {"v_E": "vector, mm/s"}}, "the sheet asks for v_E in 4/16; today's exercise"),
    ({"asked": {"v_D": "tensor, mm/s"}}, "the form of v_D on the sheet of 4/16: no such kind"),
    ({"asked": {"v_D": "number, mm/s"}}, "as number, mm/s, today's 4/16 asks for v_D as vec"),
    ({"asked": {"v_D": "vector, mm"}}, "in mm, today's 4/16 asks .* differ in dimension"),
])  # fmt: skip
def test_what_does_not_fit_the_exercise_is_reported_with_what_to_do(sheet, message):
    with pytest.raises(ScoreError, match=message):
        score_receipt(ELBOW, VALUES, {"answers": key()}, **sheet)


@pytest.mark.parametrize(("unit", "size"), [("mm/s", 1.0), ("m/s", 1000.0), ("in/s", 25.4)])
def test_an_answer_is_scored_in_the_unit_that_the_sheet_asked_for(unit, size):
    v_D = [x / size for x in key()["v_D"]]
    asked = {"v_D": f"vector, {unit}"}
    assert earned({"v_D": v_D}, asked=asked, points=5) == (5, 5, [(5, 5)])
    assert earned({"v_D": [1.01 * x for x in v_D]}, asked=asked, points=5) == (0, 5, [(0, 5)])


def test_a_formula_is_scored_in_the_unit_that_the_sheet_asked_for():
    p = problem("4/2")
    speed = ["*", 1000, key(p, {})["speed"]]
    assert earned({"speed": speed}, p, {}, asked={"speed": "expression, mm/s"})[:2] == (1, 1)

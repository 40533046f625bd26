"""A later answer that is right given the student's own wrong earlier one earns what the instructor
set, and a message says so.
"""

from dataclasses import replace

import numpy as np
import pytest

from exercises.catalogue import problem, select
from exercises.catalogue.following import earlier_answers, follow
from exercises.catalogue.variants import distance, draw
from grader.scoring import ScoreError, score_receipt
from grader.scoring.computation import columns, sequel_of
from grader.scoring.numbers import numbers_of
from tests.grader.scoring.answered import plain

FOLLOWING = [(p, key) for p in select(["all"]) for key in earlier_answers(p)]
ROBOT = problem("4/3")  # the acceleration of P, and its magnitude
VALUES = draw(ROBOT, b"tests of following")


def judged(p, values, answers, **sheet):
    score = score_receipt(p, values, {"answers": answers}, **sheet)
    return {part.key: part for part in score.parts}


def wrong_acceleration():
    x, y, z = numbers_of(ROBOT, VALUES).key["a"][0]
    return [1.2 * x, y, z]


def robot(size, **sheet):
    return judged(ROBOT, VALUES, {"a": wrong_acceleration(), "acc_mag": size}, **sheet)["acc_mag"]


SIZE = float(np.linalg.norm(wrong_acceleration()))


def test_what_follows_is_reported_and_earns_the_share_of_instructor_or_exercise():
    part = robot(SIZE)
    assert (part.points, part.verdict) == (0, "wrong")
    assert part.message == "not right; it follows from your a"
    assert part.diagnosis == "follows from a wrong a"
    part = robot(SIZE, points=8, follow_through=0.75)
    assert (part.points, part.out_of) == (3, 4)
    assert part.message == "not right; it follows from your a, which earns 3 of 4"
    answers = tuple(replace(a, follow_through=0.5) for a in ROBOT.answers)
    p = replace(ROBOT, answers=answers)
    given = {"a": wrong_acceleration(), "acc_mag": SIZE}
    assert judged(p, VALUES, given)["acc_mag"].points == 0.5
    assert judged(p, VALUES, given, follow_through=0)["acc_mag"].points == 0


def test_answers_in_another_unit_follow_and_the_books_earn_nothing():
    mm = {"a": [1000 * x for x in wrong_acceleration()], "acc_mag": 1000 * SIZE}
    asked = {"a": "vector, mm/s^2", "acc_mag": "number, mm/s^2"}
    assert judged(ROBOT, VALUES, mm, asked=asked, follow_through=0.5)["acc_mag"].points == 0.5
    book = numbers_of(ROBOT, ROBOT.book_values).key
    given = {"a": list(book["a"][0]), "acc_mag": book["acc_mag"][0][0]}
    parts = judged(ROBOT, VALUES, given, follow_through=1)
    assert [part.points for part in parts.values()] == [0, 0]
    assert "the answer for the book's numbers" in parts["acc_mag"].message


@pytest.mark.parametrize("share", [-0.1, 1.1, "half", float("nan")])
def test_an_invalid_share_is_refused(share):
    with pytest.raises(ScoreError, match="follow_through must be"):
        robot(SIZE, follow_through=share)


NUMERIC = [(p, key) for p, key in FOLLOWING if not (p.symbolic or p.answer(key).kind.is_word)]


@pytest.mark.one_in(4)
@pytest.mark.parametrize(("p", "key"), NUMERIC, ids=[f"{p.id} {k}" for p, k in NUMERIC])
def test_in_every_problem_a_later_answer_follows_from_a_wrong_one(p, key):
    values = draw(p, b"following")
    numbers = numbers_of(p, values)
    right = {name: numbers.key[name][0] for name in earlier_answers(p)[key]}
    wrong, later = next(filter(None, (other(p, key, numbers, right, f) for f in FACTORS)))
    first = next(iter(right))
    given = {**right, first: wrong, key: later}
    given = {name: list(x) if len(x) > 1 else x[0] for name, x in given.items()}
    part = judged(p, values, given, follow_through=0.5)[key]
    assert part.points == pytest.approx(part.out_of / 2), part
    assert f"it follows from your {first}, which earns {part.points:.3g} of" in part.message


# ``follows`` is not written, but the computation goes through the earlier answer
THROUGH = [("2/16", "v_tape", "a_P1"), ("4/27", "v_A", "a_A"), ("6/18", "t_D", "d_up")]


@pytest.mark.parametrize(("name", "first", "key"), THROUGH)
def test_an_answer_follows_from_those_that_its_computation_goes_through(name, first, key):
    p = problem(name)
    numbers = numbers_of(p, draw(p, b"through"))
    values = {n: numbers.sample[n] for n in p.givens}
    assert first in numbers.earlier[key]
    assert key not in earlier_answers(p)
    right = {n: numbers.key[n] for n in numbers.earlier[key]}
    assert np.allclose(numbers.following(key, right), numbers.key[key], rtol=1e-9)
    wrong = {**right, first: tuple(tuple(1.3 * x for x in point) for point in right[first])}
    (later,) = numbers.following(key, wrong)
    assert distance(later, numbers.key[key][0]) > 0.05
    given = {n: plain(x[0]) for n, x in {**wrong, key: (later,)}.items()}
    assert "it follows from your" in judged(p, values, given)[key].message
    slips = [x for x in numbers.sequel(key, wrong).at(key, 0) if distance(x, later) > 0.05][:10]
    parts = [judged(p, values, {**given, key: plain(slip)})[key] for slip in slips]
    goes_on = [str(part.diagnosis).startswith(f"goes on from your {first}, but ") for part in parts]
    assert sum(goes_on) >= 0.7 * len(slips)


FACTORS = 1.3, 0.8, 1.05, 3.0  # not every wrong answer leads to another


def other(p, key, numbers, right, factor):
    """(an earlier answer, made wrong; the one that follows), or None if it is nearly the right one."""
    first = next(iter(right))
    if p.answer(first).kind.name == "choice":
        wrong = tuple(next(w for w in p.answer(first).of if w != x) for x in right[first])
    elif p.answer(first).kind.name == "count":
        wrong = tuple(x + 1 for x in right[first])
    else:  # another direction too
        wrong = tuple(x * factor ** (n + 1) or 1.0 for n, x in enumerate(right[first]))
    with np.errstate(all="ignore"):
        try:
            later = follow(p, key, numbers.sample, {**right, first: wrong})
        except (ArithmeticError, ValueError):
            return None
    if p.answer(key).kind.is_word:
        return (wrong, later) if (later,) != numbers.key[key] else None
    later = tuple(x if isinstance(x, int) else float(x) for x in later)
    if not all(map(np.isfinite, later)):
        return None
    return (wrong, later) if distance(later, numbers.key[key][0]) > 0.03 else None


def test_formulas_follow_too():
    p = problem("4/34")  # omega_disk = (0, P, omega), alpha_disk = (-omega P, 0, 0)
    wrong = ["P", 0, "omega"]
    alpha = [0, ["*", "omega", "P"], 0]  # omega k x (P i + omega k)
    part = judged(p, {}, {"omega_disk": wrong, "alpha_disk": alpha}, follow_through=0.5)
    assert part["alpha_disk"].points == 0.5
    other = judged(p, {}, {"omega_disk": wrong, "alpha_disk": [0, "omega", 0]}, follow_through=0.5)
    assert other["alpha_disk"].points == 0


@pytest.mark.parametrize(("name", "key", "earlier"), [
    ("3/2", "v_n", "v"), ("4/17", "a_D", "v_D"), ("4/41", "a_B", "v_B"),
])  # fmt: skip
def test_the_way_of_the_solution_is_accepted_where_follows_is_another(name, key, earlier):
    p = problem(name)
    values = draw(p, b"two ways")
    numbers = numbers_of(p, values)
    wrong = {earlier: [1.3 * x for x in numbers.key[earlier][0]]}
    found = sequel_of(p, key)({**values, **columns(p, {earlier: (wrong[earlier],)})})
    part = judged(p, values, {**wrong, key: plain(found)})[key]
    assert part.message.startswith(f"not right; it follows from your {earlier}")


@pytest.mark.parametrize("number", ["11/11", "11/12", "7/24", "2/25"])
def test_a_huge_number_for_all_follows_from_nothing_where_more_is_to_be_computed(number):
    p = problem(number)
    values = draw(p, b"huge")
    for x in (1e5, 1e9, -1e9, 1e30, 1e150, 1e300, 8e307):
        given = {a.key: [x] * a.kind.length if a.kind.length > 1 else x for a in p.answers}
        parts = judged(p, values, given, follow_through=1).values()
        assert not sum(part.points for part in parts), x


@pytest.mark.parametrize(
    ("name", "key", "given", "word"),
    [
        ("6/22", "side", {"x": 0}, "same point"),
        ("9/5", "balance", {"Hdot_O": [0, 0, 0]}, "dynamic"),
    ],
)
def test_a_word_follows_from_a_wrong_answer(name, key, given, word):
    p = problem(name)
    values = draw(p, b"words") if p.givens else {}
    keys = numbers_of(p, values).key.items()
    right = {k: plain(x[0]) for k, x in keys if not p.symbolic and not p.answer(k).kind.is_word}
    message = judged(p, values, {**right, **given, key: word})[key].message
    assert message.startswith(f"not right; it follows from your {next(iter(given))}")

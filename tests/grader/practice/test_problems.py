"""A student's way through a problem."""

import math
from itertools import pairwise

import pytest

from exercises.catalogue import problem
from newton_euler.classroom import AnswerError, PracticeFileError, practice

BOOK = {"alpha_CD": [0, -0.27, 0], "v_D": [-9.6, 6.235383, -3.6]}
BOOK["a_D"] = [-7.482459, -7.38, -2.805922]


@pytest.fixture
def elbow(practice_file):
    return practice(practice_file, progress=None)["4/16"]


def test_the_numbers_of_the_book_come_first_and_the_text_has_those_at_hand(elbow):
    book = problem("4/16").book_values
    assert elbow.givens == book
    seen = [elbow.givens] + [elbow.new().givens for _ in range(3)]
    assert seen[0] == seen[3] == book
    assert all(a != b for a, b in pairwise(seen))
    elbow.new()
    for name, x in elbow.givens.items():
        assert f"{name} = {x:.6g}" in repr(elbow)
        assert f"`{name} = {x:.6g}`" in elbow._repr_markdown_()
    assert elbow.figure.startswith(b"\x89PNG")


def test_right_answers_are_right_in_few_digits_too(elbow):
    assert elbow.check(**BOOK).verdicts == dict.fromkeys(BOOK, "right")
    output = elbow.check(v_D=[-9.6, 6.255, -3.6])
    assert output.verdicts == {"v_D": "right"}
    assert "rounded too early" in output.text
    assert elbow.check(v_D=[-9.6, 6.24, -3.6]).text == "v_D: right"


@pytest.mark.parametrize(("given", "words"), [
    ([0, 0, 0], "leaves out omega x omega_rel"),
    ([0, 0.27, 0], "the other way round"),
    ([0.27, 0, 0], "its magnitude is right, its direction is not"),
    ([0, -0.2635, 0], "check each number and term in it"),
    ([1.9, 0.3, 0.1], "not right"),
    ("fast", "expected a vector"),
    (3.0, "expected a vector"),
])  # fmt: skip
def test_what_is_wrong_with_an_answer_is_reported(elbow, given, words):
    checked = elbow.check(alpha_CD=given)
    assert checked.verdicts["alpha_CD"] in ("wrong", "unreadable")
    assert words in checked.text
    assert "-0.27" not in checked.text


def test_answers_of_other_numbers_are_right_for_those_and_known_as_the_books(elbow, practice_file):
    assert "the book's numbers" in elbow.new().check(v_D=BOOK["v_D"]).text
    for name in ("4/16", "2/18"):
        p = practice(practice_file, progress=None)[name].new()
        assert set(p.check(**problem(name).solve(p.givens)).verdicts.values()) == {"right"}


def test_steps_are_checked_in_any_order_and_what_is_right_needs_no_hint(elbow):
    assert elbow.check_step(a_D_coriolis=[-7.482459, 0, 0]).text == "a_D_coriolis: right"
    output = elbow.check_step(omega_CD=[0.45, 0, 0.6])
    assert "the turning of CD with the opposite sign" in output.text
    elbow.check_step(omega_CD=[-0.45, 0, 0.6])
    assert "Find v_r" in elbow.next_step().text


def test_a_step_that_follows_rightly_from_a_wrong_one_is_reported_as_such(elbow):
    """v_r = omega_rel x r with the wrong way of turning, and 2 omega x v_r with that."""
    elbow.check_step(v_r=[0, -6.235383, 3.6])
    output = elbow.check_step(a_D_coriolis=[7.482459, 0, 0])
    assert "it follows correctly from your v_r: correct that first" in output.text
    assert output.verdicts == {"a_D_coriolis": "wrong"}
    elbow.check_step(v_r=[0, 6.235383, -3.6])
    assert "follows" not in elbow.check_step(a_D_coriolis=[7.482459, 0, 0]).text


def test_it_follows_through_steps_that_nobody_asked_about(elbow):
    elbow.check_step(v_r=[0, -6.235383, 3.6])
    assert "it follows correctly from your v_r" in elbow.check(v_D=[-9.6, -6.235383, 3.6]).text


def test_hints_say_where_then_how_then_the_value(elbow):
    first, second, third, then = (elbow.next_step().text for _ in range(4))
    assert "omega_CD" in first
    assert "Section 4.9" in first
    assert "(4.22)" not in first
    assert "(4.22)" in second
    assert "-0.45" not in second
    assert "It is [-0.45, 0, 0.6] rad/s" in third
    assert "v_r" in then


def test_the_solution_has_steps_and_the_ledger_in_the_numbers_at_hand(elbow):
    output = elbow.new().solution()
    right = problem("4/16").solve(elbow.givens)["a_D"].components()
    assert f"{right[0]:.6g}" in output.text
    assert "| term | value |" in output.markdown
    assert "Coriolis" in output.markdown
    assert elbow.next_step().text.startswith("nothing is left")


def test_an_instructor_decides_how_much_help_there_is(hints_file, checks_file):
    p = practice(hints_file, progress=None)["4/16"]
    assert [("It is [" in p.next_step().text) for _ in range(4)] == [False] * 4
    assert p.solution().text == "this practice file has no solutions"
    assert p.steps
    p = practice(checks_file, progress=None)["4/16"]
    assert p.next_step().text == "this practice file gives no hints"
    assert p.steps == {}
    assert "leaves out omega x omega_rel" in p.check(alpha_CD=[0, 0, 0]).text
    with pytest.raises(AnswerError, match="no steps to check"):
        p.check_step(omega_CD=[0, 0, 0])


@pytest.mark.parametrize(("call", "message"), [
    (lambda p: p.check(alpha=1), "no answer 'alpha'; it has alpha_CD, v_D, a_D"),
    (lambda p: p.check(v_r=[1, 2, 3]), r"v_r is checked by p.check_step\(v_r="),
    (lambda p: p.check_step(v_D=[1, 2, 3]), r"v_D is checked by p.check\(v_D="),
    (lambda p: p.check(), "write a value for an answer: alpha_CD"),
    (lambda p: p.check([1, 2, 3]), "write the name before each value, as alpha_CD=..."),
])  # fmt: skip
def test_a_name_that_is_not_asked_for_is_refused_with_those_that_are(elbow, call, message):
    with pytest.raises(AnswerError, match=message):
        call(elbow)


def test_a_problem_in_symbols_is_asked_with_numbers_and_a_missing_one_reported(practice_file):
    p = practice(practice_file, progress=None)["4/2"]
    assert set(p.givens) == set(problem("4/2").units)
    d, w, nu, tilt = (p.givens[n] for n in ("d", "omega", "nu", "tilt"))
    assert p.check(speed=math.hypot(nu, d * w * math.sin(tilt))).text == "speed: right"
    assert "sqrt" not in p.solution().text
    with pytest.raises(PracticeFileError, match="no problem '9/9'; it has 4/1, 4/2"):
        practice(practice_file, progress=None)["9/9"]


def test_first_tries_and_help_are_counted_and_kept(practice_file, tmp_path):
    kept = tmp_path / "own.json"
    p = practice(practice_file, progress=kept)["4/16"]
    p.check(alpha_CD=[0, -0.27, 0])
    p.check(v_D=[1, 2, 3])
    p.check(v_D=[-9.6, 6.235383, -3.6])
    p.next_step()
    again = practice(practice_file, progress=kept)
    counts = again._progress.counts("4/16")
    assert counts == {"tried": 2, "right": 2, "at first go": 1, "with help": 1}
    row = next(line for line in repr(again).splitlines() if line.startswith("4/16"))
    assert row.split()[-4:] == ["2", "2", "1", "1"]

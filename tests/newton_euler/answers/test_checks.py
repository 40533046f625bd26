"""Answers that a receipt checks against a seal: the first tries are free, guessing costs time."""

import json
import math

import pytest

from newton_euler.answers import checks, seals
from newton_euler.answers.checks import FREE, LONGEST, Check, check
from newton_euler.answers.kinds import KINDS
from newton_euler.answers.seals import seal
from newton_euler.classroom import expect, given, receipt

NUMBER, VECTOR = KINDS["number"], KINDS["vector"]


@pytest.fixture
def clock(monkeypatch, tmp_path):
    """A clock that stands still, in a notebook that has been opened."""
    now = [1e9]
    monkeypatch.setattr(checks.time, "time", lambda: now[0])
    monkeypatch.setattr(checks, "in_notebook", lambda: True)
    monkeypatch.setattr(checks, "_kept", {})
    monkeypatch.setattr(seals, "COST", 2)
    monkeypatch.chdir(tmp_path)
    return now


def guessed(sealed, kind, guesses):
    return [check(sealed, kind, x).right for x in guesses]


def test_a_guesser_learns_nothing_after_the_free_answers(clock):
    sealed = seal(NUMBER, [2.5])
    assert guessed(sealed, NUMBER, range(100, 100 + FREE)) == [False] * FREE
    assert guessed(sealed, NUMBER, [1.0, 2.5, 3.0]) == [None] * 3
    waits = []
    for n in range(15):
        waits.append(check(sealed, NUMBER, 7.0).wait)
        clock[0] += waits[-1]
        assert check(sealed, NUMBER, 200.0 + n).right is False
    assert waits == [min(2.0**n, LONGEST) for n in range(15)]
    clock[0] += LONGEST
    assert check(sealed, NUMBER, 2.5) == Check(True, FREE + 15, 0.0)


def test_an_answer_given_again_costs_nothing_and_each_frame_is_a_guess(clock):
    sealed = seal(NUMBER, [2.5])
    assert guessed(sealed, NUMBER, [7.0] * 50 + [2.5] * 3) == [False] * 50 + [True] * 3
    assert check(sealed, NUMBER, 7.0) == Check(False, 1, 0.0)
    sealed = seal(VECTOR, [1.0, 2.0, 2.0])
    assert check(sealed, VECTOR, {str(n): [1.0, 2.0, -n] for n in range(1, 5)}).wrong == 4


@pytest.mark.parametrize("between", [
    lambda: None, lambda: checks.FILE.write_text("damaged"), lambda: checks.FILE.unlink(),
    lambda: checks.FILE.write_text("[" * 10**5),
], ids=["", "damaged", "deleted", "deep"])  # fmt: skip
def test_a_count_goes_on_in_this_kernel_and_the_next(clock, monkeypatch, between):
    sealed = seal(NUMBER, [2.5])
    guessed(sealed, NUMBER, range(100, 100 + FREE))
    kept = checks.FILE.read_text()
    between()
    assert check(sealed, NUMBER, 2.5).right is None
    checks.FILE.write_text(kept)
    monkeypatch.setattr(checks, "_kept", {})
    assert check(sealed, NUMBER, 2.5).right is None
    assert check(seal(NUMBER, [2.5]), NUMBER, 2.5).right  # another answer is still checked


def test_what_another_kernel_counts_meanwhile_is_kept(clock, monkeypatch):
    """The other kernel writes while this one computes the hash of an answer."""
    theirs = {"salt of another answer": {"wrong": ["a", "b"], "next": 2e9}}
    monkeypatch.setattr(checks, "opens", lambda *_: checks.FILE.write_text(json.dumps(theirs)) < 0)
    sealed = seal(NUMBER, [2.5])
    assert check(sealed, NUMBER, 7.0).wrong == 1
    kept = json.loads(checks.FILE.read_text())
    assert {**theirs, sealed["salt"]: kept[sealed["salt"]]} == kept


@pytest.mark.parametrize("entry", [
    None, [], {}, {"wrong": 5, "next": 0}, {"wrong": [], "next": 10**400},
    {"wrong": [], "next": math.nan}, {"wrong": [[]], "next": "x"},
])  # fmt: skip
def test_a_damaged_entry_loses_no_count_of_the_others(clock, monkeypatch, entry):
    sealed = seal(NUMBER, [2.5])
    guessed(sealed, NUMBER, range(100, 100 + FREE))
    checks.FILE.write_text(json.dumps({"damaged": entry, **json.loads(checks.FILE.read_text())}))
    monkeypatch.setattr(checks, "_kept", {})
    assert check(sealed, NUMBER, 2.5).right is None


def test_a_clock_set_back_does_not_lock_a_student_out(clock):
    sealed = seal(NUMBER, [2.5])
    guessed(sealed, NUMBER, range(100, 100 + FREE))
    clock[0] -= 1e8
    assert check(sealed, NUMBER, 2.5).wait == LONGEST
    clock[0] += LONGEST
    assert check(sealed, NUMBER, 2.5).right


def test_a_seal_of_another_version_says_nothing():
    """Copies handed out before an update hold such seals."""
    assert check({"salt": "00", "size": 1, "hashes": ["a"]}, NUMBER, 2.5) is None
    assert check({"salt": "00", "hashes": ["a"]}, KINDS["choice"], "stable") is None


def test_the_receipt_says_how_long_to_wait_and_keeps_the_count(clock, monkeypatch):
    shown = []
    monkeypatch.setattr("newton_euler.answers.receipts.in_notebook", lambda: True)
    monkeypatch.setattr("IPython.display.display", lambda data, **rest: shown.append((data, rest)))
    expect("0/8", v="number, m/s")
    given("0/8", sealed={"v": seal(NUMBER, [2.5])})
    for n in range(FREE + 1):
        receipt("0/8", v=100.0 + n)._ipython_display_()
    data, rest = shown[-1]
    assert "v is not checked yet (after 6 wrong answers, the next check is in 1 s)." in str(data)
    assert json.dumps(rest["metadata"]) == '{"newton_euler": {"wrong": {"v": 6}}}'

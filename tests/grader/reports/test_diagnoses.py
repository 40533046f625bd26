"""``python -m grader diagnose``: how often the listed mistakes are named."""

import re

import pytest

from exercises.catalogue import problem
from grader.reports import diagnoses as module
from grader.reports import diagnosis_shares
from newton_euler.answers import Cause
from tests.grader.courses import command, ran


def test_the_shares_are_printed_with_their_sum():
    out = ran(command("diagnose", "4/16", "4/2", "--draws", 2))
    lines = [line.split() for line in out.splitlines() if line.strip()]
    assert [line[0] for line in lines if line[0] in ("4/16", "4/2", "all")] == [
        "4/16",
        "4/2",
        "all",
    ]
    made = {line[0]: int(line[1]) for line in lines if line[0] in ("4/16", "4/2", "all")}
    assert made["all"] == made["4/16"] + made["4/2"] > 10
    total = next(line for line in lines if line[0] == "all")
    assert sum(map(float, total[2:])) == pytest.approx(100, abs=0.3)
    assert float(total[2]) > 90


def test_a_mistake_told_as_another_is_misnamed_and_one_taken_for_right_fails(monkeypatch):
    p = problem("4/16")
    original = module.score_receipt

    def otherwise(*arguments):
        score = original(*arguments)
        for part in score.parts:
            other = (Cause("listed", "another", ""),) if part.causes else ()
            object.__setattr__(part, "causes", other)
        return score

    monkeypatch.setattr(module, "score_receipt", otherwise)
    counts = diagnosis_shares([p], 1)["4/16"]
    assert counts["misnamed"] > 0
    assert counts["named"] == 0

    def generous(*arguments):
        score = original(*arguments)
        for part in score.parts:
            object.__setattr__(part, "verdict", "right")
        return score

    monkeypatch.setattr(module, "score_receipt", generous)
    code, out = command("diagnose", "4/16", "--draws", 1)
    assert code == 1
    assert re.search(r"4/16 .*100\.0", out)

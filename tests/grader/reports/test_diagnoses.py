"""``python -m grader diagnose``: how often the listed mistakes are named."""

import re
from collections import Counter
from dataclasses import replace

import pytest

from exercises.catalogue import problem
from grader.reports import diagnoses as module
from grader.reports import diagnosis_shares, slip_shares
from newton_euler.answers import Cause
from tests.grader.courses import command, ran, refused


def test_the_shares_are_printed_with_their_sum():
    out = ran(command("diagnose", "4/16", "4/2", "--draws", 2))
    listed, slips = out.split("Unlisted slips")
    assert "sign of one term" in slips
    lines = [line.split() for line in listed.splitlines() if line.strip()]
    rows = {line[0]: line[1:] for line in lines if line[0] in ("4/16", "4/2", "all")}
    assert list(rows) == ["4/16", "4/2", "all"]
    one, two, every = (int(made) for made, *_ in rows.values())
    assert every == one + two > 10
    named, *others = map(float, rows["all"][1:])
    assert named + sum(others) == pytest.approx(100, abs=0.3)
    assert named > 90


def test_a_mistake_named_as_another_is_misnamed_and_one_taken_for_right_fails(monkeypatch):
    p = problem("4/16")
    original = module.score_receipt

    def scored(change):
        def score(*arguments):
            found = original(*arguments)
            return replace(found, parts=tuple(map(change, found.parts)))

        monkeypatch.setattr(module, "score_receipt", score)

    another = (Cause("listed", "another", ""),)
    scored(lambda part: replace(part, causes=another if part.causes else ()))
    counts = diagnosis_shares([p], 1)["4/16"]
    assert counts["misnamed"] > 0
    assert counts["named"] == 0

    scored(lambda part: replace(part, verdict="right"))
    assert re.search(r"4/16 .*100\.0", refused(command("diagnose", "4/16", "--draws", 1), 1))


def test_most_unlisted_slips_are_named_and_very_few_wrongly():
    problems = [problem(name) for name in ("2/21", "3/26", "4/41", "7/23", "10/9", "11/2", "A/21")]
    found = slip_shares(problems, 2)
    assert not found.pop("random numbers")["named"]
    assert found.pop("listed, in one part")["named"] > 30
    assert found["another set-up"]["named"] > 10
    found.pop("another variant")  # nobody knows its numbers
    counts = sum(found.values(), Counter())
    assert counts["named"] + counts["followed"] > 0.8 * counts.total() > 100
    assert counts["misnamed"] <= 0.01 * counts.total()

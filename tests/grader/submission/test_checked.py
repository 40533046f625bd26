"""How many wrong answers a notebook says it has checked, as the instructor sees it."""

import copy

import pytest

from exercises.catalogue import problem
from grader.assignment.notebook import build_notebook
from grader.submission.rebuild import rebuild

MASTER = build_notebook([problem("4/16")], "a title", 10, 100)


def handed_in(output):
    """The note on 4/16 where its receipt has this output."""
    submitted = copy.deepcopy(MASTER)
    next(c for c in submitted["cells"] if c["id"] == "receipt-4-16")["outputs"] = output
    return rebuild(MASTER, submitted)[1].notes.get("4/16", "")


def counted(wrong):
    return [{"output_type": "display_data", "metadata": {"newton_euler": {"wrong": wrong}}}]


def test_the_count_is_a_note_on_the_problem():
    assert handed_in(counted({"v_D": 7})) == "wrong answers checked before it was handed in: v_D 7"


@pytest.mark.parametrize("output", [
    None, 3, [], [None], [{"metadata": 3}], counted(None), counted({}), counted({"v_D": "7"}),
    counted({"v_D": 0}), counted({"v_D": -1}), counted({"v_D": 10**400}), counted({"v_D": True}),
    counted({"<script>": 7}), counted({"v_D": {"a": 1}}),
], ids=lambda x: str(x)[:80])  # fmt: skip
def test_anything_else_in_its_place_is_ignored(output):
    assert handed_in(output) == ""

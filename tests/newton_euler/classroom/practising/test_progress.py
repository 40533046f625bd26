"""The record of a student's tries, and the table made from it."""

import json

import pytest

from newton_euler.classroom import PracticeFileError, practice
from newton_euler.classroom.practising.progress import Progress, mastery


def test_tries_after_the_right_one_change_nothing_and_mastery_needs_first_goes():
    kept = Progress(None)
    for right in (False, True, False, True):
        kept.tried("4/1", 0, "v", right)
    assert kept.entry("4/1", 0, "v") == {"tries": 2, "right": 2, "help": 0}
    kept.helped("4/1", 0, "v", 3)
    assert kept.entry("4/1", 0, "v")["help"] == 0

    def of(tried, first):
        return mastery({"tried": tried, "right": tried, "at first go": first, "with help": 0})

    assert [of(0, 0), of(4, 4), of(10, 8), of(10, 4), of(10, 3)] == [
        "not tried", "nearly there", "mastered", "nearly there", "needs practice",
    ]  # fmt: skip


def test_two_notebooks_do_not_lose_each_others_tries(tmp_path):
    one, other = Progress(tmp_path / "p.json"), Progress(tmp_path / "p.json")
    one.tried("4/1", 0, "v", True)
    other.tried("4/1", 0, "w", True)
    other.tried("4/2", 0, "v", True)
    found = Progress(tmp_path / "p.json")
    assert found.counts("4/1")["right"] == 2
    assert found.counts("4/2")["right"] == 1


@pytest.mark.parametrize("text", ["", "{", "[]", '{"format": 9, "problems": {}}', "{}"])
def test_a_damaged_file_is_kept_aside_and_reported(tmp_path, text):
    path = tmp_path / "p.json"
    path.write_text(text)
    kept = Progress(path)
    assert "kept as p.json.damaged" in kept.note
    assert (tmp_path / "p.json.damaged").read_text() == text
    kept.tried("4/1", 0, "v", True)
    assert json.loads(path.read_text())["problems"]["4/1"]


def test_where_nothing_can_be_written_it_is_kept_while_python_runs(tmp_path):
    kept = Progress(tmp_path / "missing" / "p.json")
    kept.tried("4/1", 0, "v", True)
    assert kept.counts("4/1")["right"] == 1
    assert "only while this kernel runs" in kept.note


@pytest.mark.parametrize("content", [None, b"", b"text"])
def test_a_file_that_is_not_a_practice_file_is_refused(tmp_path, content):
    path = tmp_path / "x.practice"
    if content is not None:
        path.write_bytes(content)
    words = "there is no practice file" if content is None else "is not a practice file"
    with pytest.raises(PracticeFileError, match=words):
        practice(path)

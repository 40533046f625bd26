"""What to do next, after what went wrong."""

from datetime import date, timedelta

import pytest

from newton_euler.answers.causes import Cause
from newton_euler.classroom.practising.advice import GAPS, advise
from newton_euler.classroom.practising.progress import Progress

SECTIONS = {"1/1": "1.1", "1/2": "1.1", "1/3": "1.1", "1/4": "1.2"}
MISTAKE = Cause("listed", "no_term", "leaves out the term: it turns")


@pytest.fixture
def days():
    """Today's date, in a list of one element that tests change."""
    return [date(2026, 3, 1)]


@pytest.fixture
def progress(days):
    return Progress(None, today=lambda: days[0])


def test_one_begins_at_the_first_and_finishes_what_is_wrong_today(progress):
    found = advise(SECTIONS, progress)
    assert (found.problem, found.sentence) == ("1/1", "Begin with 1/1, section 1.1.")
    assert advise({}, progress).problem == ""
    progress.tried("1/2", 0, "v", False, MISTAKE)
    assert advise(SECTIONS, progress, now="1/2").problem == "1/2"
    assert "v is not right yet" in advise(SECTIONS, progress).sentence


def test_after_a_mistake_comes_a_problem_of_its_section_in_which_it_can_be_made(progress):
    progress.tried("1/1", 0, "v", False, MISTAKE)
    progress.tried("1/1", 0, "v", True)
    listed = lambda p: {("listed", "no_term")} if p == "1/3" else set()
    found = advise(SECTIONS, progress, "1/1", listed)
    assert found.problem == "1/3"
    words = "from section 1.1, too: today your v of 1/1 fitted a solution that leaves out the term."
    assert found.sentence == f"1/3 is {words}"
    assert advise(SECTIONS, progress, "1/1").problem == "1/2"


@pytest.mark.parametrize("well", range(len(GAPS)))
def test_a_problem_comes_again_after_more_days_the_better_it_went(progress, days, well):
    for variant in range(well):
        progress.tried("1/1", variant, "v", True)
    if not well:
        progress.tried("1/1", 0, "v", False, MISTAKE)
        progress.tried("1/1", 0, "v", True)
    days[0] += timedelta(GAPS[well] - 1)
    assert advise(SECTIONS, progress).problem != "1/1"
    days[0] += timedelta(1)
    found = advise(SECTIONS, progress)
    assert found.problem == "1/1"
    assert found.sentence.startswith("Again 1/1, with other numbers: ")


def test_where_all_is_right_it_goes_on_and_ends_in_words(progress):
    progress.tried("1/3", 0, "v", True)
    words = "1/4 begins section 1.2: what you tried before is right."
    assert advise(SECTIONS, progress).sentence == words
    for p in SECTIONS:
        progress.tried(p, 0, "v", True)
    found = advise(SECTIONS, progress)
    assert (found.problem, "comes again in 3 days" in found.sentence) == ("", True)


def test_the_longer_of_two_records_counts_also_of_an_older_notebook_without_days(progress):
    entry = '{"v": {"tries": 2, "right": 2, "help": 0}}'
    progress.take_in(f'{{"format": 1, "problems": {{"1/1": {{"0": {entry}}}}}}}')
    assert advise(SECTIONS, progress).problem == "1/1"
    longer, shorter = Progress(None), Progress(None)
    for right in (False, False, True):
        longer.tried("1/1", 0, "v", right, MISTAKE)
    shorter.tried("1/1", 0, "v", False)
    progress.tried("1/1", 0, "a", True)
    for record in (shorter, longer, shorter):
        progress.take_in(str(record))
    assert progress.entry("1/1", 0, "v")["right"] == 3
    assert progress.entry("1/1", 0, "a")["right"] == 1


DEEP = "[" * 100_000
BAD = [
    "", "[]", "{}", DEEP, '{"format": 1}', '{"format": 2, "problems": {}}', '{"format": 1, "problems": []}x',
    *(f'{{"format": 1, "problems": {{"1/1": {inner}}}}}' for inner in (
        "[]", '{"x": {}}', '{"0": []}', '{"0": {"v": 1}}', '{"0": {"v": {"tries": -1}}}', '{"0": {"v": {"tries": 1e999}}}',
        '{"0": {"v": {"day": "soon"}}}', '{"0": {"v": {"cause": ["a"]}}}', '{"0": {"v": {"cause": ["a", "b", "\\u001b[2J"]}}}',
        '{"0": {"v": {"script": 1}}}', '{"0": {"v": {"tries": true}}}',
    )),
]  # fmt: skip


@pytest.mark.parametrize("text", BAD, ids=range(len(BAD)))
def test_what_is_not_a_record_of_progress_is_refused_in_words_and_changes_nothing(progress, text):
    progress.tried("1/1", 0, "v", True)
    before = str(progress)
    with pytest.raises(ValueError, match=r"."):
        progress.take_in(text)
    assert str(progress) == before

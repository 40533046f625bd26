"""What problems are chosen by, checked against the catalogue's own data."""

import pytest

from exercises.catalogue import problem, problems
from exercises.catalogue.survey import Wanted, entry, matching
from exercises.catalogue.variants import sheets

CHAPTER = problems("ch04")


def ids(**wanted):
    return {e.id for e in matching(CHAPTER, Wanted(**wanted))}


def test_an_entry_says_what_the_problem_says():
    for p in (problem("4/16"), problem("5/26"), problem("7/5")):
        e = entry(p)
        row = e.id, e.section, e.sheets, e.answers
        assert row == (p.id, p.section, sheets(p), len(p.answers))
        assert set(e.kinds) == {a.kind for a in p.answers}
        assert 1 <= e.difficulty <= 5
        assert e.minutes % 5 == 0 < e.minutes
    assert (entry(problem("4/16")).steps, entry(problem("4/16")).terms) == (2, 6)
    assert "4.18" in entry(problem("4/16")).equations


def test_what_is_longer_is_harder_and_takes_longer():
    short, long = entry(problem("A/1")), entry(problem("7/13"))
    assert short.operations < long.operations
    assert (short.difficulty, short.minutes) < (long.difficulty, long.minutes)


def test_every_filter_leaves_what_fits_and_takes_the_rest():
    by_hand = {
        "sections": (("4.10",), lambda p, e: p.section == "4.10"),
        "kinds": (("number",), lambda p, e: any(str(a.kind) == "number" for a in p.answers)),
        "equations": (("4.18", "4.22"), lambda p, e: {"4.18", "4.22"} <= set(e.equations)),
        "words": (("rod", "hinge"), lambda p, e: "rod" in e.words and "hinge" in e.words),
        "spans": ({"minutes": (0, 20), "steps": (3, 9)}, lambda p, e: e.minutes <= 20 and 3 <= e.steps <= 9),
    }  # fmt: skip
    for name, (value, fits) in by_hand.items():
        expected = {p.id for p in CHAPTER if fits(p, entry(p))}
        assert 0 < len(expected) < len(CHAPTER), name
        assert ids(**{name: value}) == expected, name


@pytest.mark.parametrize(("wanted", "found"), [
    ({"sections": ("4",)}, len(CHAPTER)), ({"sections": ("4.1",)}, 0), ({"words": ("4/16",)}, 1),
    ({"words": ("ROBOT",)}, "4/3"), ({"words": ("obot",)}, 0), ({}, len(CHAPTER)),
])  # fmt: skip
def test_sections_and_words_are_whole_or_begin_so(wanted, found):
    if isinstance(found, str):
        assert found in ids(**wanted)
    else:
        assert len(ids(**wanted)) == found

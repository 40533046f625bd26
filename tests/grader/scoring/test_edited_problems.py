"""A problem that is edited while a process runs, as in the server of the formgrader."""

import os
import shutil

import pytest

from exercises import problem
from exercises.catalogue import problems
from exercises.catalogue.reading import read_once
from grader.grading.records import problem_state
from grader.scoring import score_receipt
from grader.scoring.computation import followed, sizes_of
from grader.scoring.numbers import numbers_of
from tests.exercises.test_slips_of_authors import GOOD, place

SHARED = "\n\ndef left(g):\n    return g.L - g.r\n"
EDITS = {  # file: (old, new) of an edit after which the bead needs twice the time
    "p01.py": ('"time": (g.L - g.r) / g.v', '"time": 2 * (g.L - g.r) / g.v'),
    "shared.py": ("return g.L - g.r", "return 2 * (g.L - g.r)"),
    "p01.yaml": ("unit: s, means: time until", "unit: min, means: time until"),
}


@pytest.fixture
def bead(tmp_path):
    """The file of the bead's folder by its name; the time is computed by shared.py."""
    folder = tmp_path / "bead"
    shutil.copytree(GOOD / "bead", folder, ignore=shutil.ignore_patterns("__*"))
    code = folder / "p01.py"
    code.write_text("from .shared import left\n" + code.read_text())
    (folder / "shared.py").write_text(SHARED)
    with place(tmp_path):
        yield lambda name: folder / name


def edit(path, old, new):
    assert old in path.read_text()
    path.write_text(path.read_text().replace(old, new))
    later = path.stat().st_mtime_ns + 10**9
    os.utime(path, ns=(later, later))


def verdict(time):
    p = problem("bead/1")
    parts = score_receipt(p, p.book_values, {"answers": {"time": time}}).parts
    return next(part.verdict for part in parts if part.key == "time")


@pytest.mark.parametrize("file", EDITS)
def test_an_edited_problem_is_graded_by_the_new_key(bead, file):
    if file == "shared.py":
        edit(bead("p01.py"), EDITS["p01.py"][0], '"time": left(g) / g.v')
    before, state = problem("bead/1"), problem_state("bead/1")
    assert problem("bead/1") is before is problems("bead")[0]
    assert (verdict(20 / 3), numbers_of(before, before.book_values).key["time"]) == (
        "right", ((pytest.approx(20 / 3),),))  # fmt: skip
    edit(bead(file), *EDITS[file])
    new = 40 / 3 if file.endswith(".py") else 1 / 9
    assert (verdict(new), verdict(20 / 3)) == ("right", "wrong")
    assert problem_state("bead/1") != state


def test_what_a_problem_computes_is_kept_by_the_problem_not_by_its_number(bead):
    kept = lambda p: [f(p) for f in (followed, sizes_of)]
    before = problem("bead/1")
    first = kept(before)
    assert all(x is y for x, y in zip(first, kept(before), strict=True))
    edit(bead("p01.py"), *EDITS["p01.py"])
    assert not any(x is y for x, y in zip(first, kept(problem("bead/1")), strict=True))


def test_a_problem_that_is_edited_while_one_submission_is_graded_counts_from_the_next(bead):
    with read_once():
        before = problem("bead/1")
        edit(bead("p01.yaml"), *EDITS["p01.yaml"])
        assert problem("bead/1") is before
    assert problem("bead/1") is not before

"""Typical slips of authors in their first problem: each is an edit of a good problem, and the
message says where it is and what to do.
"""

import contextlib
import os
import re
import shutil
from pathlib import Path

import pytest
import yaml

import exercises
from exercises.catalogue import CatalogueError, places, problem, reading
from exercises.catalogue.checks import alike, check
from exercises.catalogue.overlooked import missing_in_figure

GOOD = Path(__file__).with_name("own_problems")


@contextlib.contextmanager
def place(folder):
    """Register the problems in this folder, and remove them afterwards."""
    path = list(exercises.__path__)
    names = places.use(folder)
    try:
        yield names
    finally:
        os.environ.pop(places.VARIABLE)
        exercises.__path__[:] = path
        reading.forget()


def found(folder, seeds=3):
    """What the checks say of bead/1 in this folder."""
    with place(folder):
        try:
            p = problem("bead/1")
            return check(p, seeds) or [*alike(p, seeds), *missing_in_figure(p)]
        except CatalogueError as error:
            return [str(error)]


def edited(tmp_path, slip):
    """A copy of the good problem with parts of its files replaced."""
    shutil.copytree(GOOD / "bead", tmp_path / "bead", ignore=shutil.ignore_patterns("__*"))
    for part, file in FILES.items():
        path = tmp_path / "bead" / file
        for old, new in slip.get(part, []):
            text = path.read_text()
            assert text.count(old) == 1, (old, text.count(old))
            path.write_text(text.replace(old, new))
    return tmp_path


def test_the_good_problem_is_found_good():
    assert found(GOOD) == []


SLIPS = yaml.safe_load(Path(__file__).with_name("slips_of_authors.yaml").read_text("utf-8"))
FILES = {"text": "p01.yaml", "code": "p01.py"}


@pytest.mark.parametrize("slip", SLIPS, ids=[s.replace(" ", "_") for s in SLIPS])
def test_a_slip_is_found_in_words(slip, tmp_path):
    sentences = found(edited(tmp_path, SLIPS[slip]))
    assert any(re.search(SLIPS[slip]["found"], s, re.S) for s in sentences), sentences

"""Slips in the computation, named in practice."""

import json
import re
import zipfile

import numpy as np
import pytest

from exercises.catalogue import problem
from exercises.catalogue.steps import steps
from exercises.catalogue.variants import flat
from grader.practice.build import page_of
from grader.practice.slips import without_formulas
from grader.scoring import score_receipt
from grader.scoring.computation import perturbed
from newton_euler.algebra.language import Words
from newton_euler.answers.near import SIMPLE
from newton_euler.classroom import practice


def simple_slips(name, values):
    """(answer, wrong number) of the simplest slips in the answers that are numbers."""
    slips = perturbed(problem(name), values)
    for a in problem(name).answers:
        if a.kind.length == 1 and not a.kind.is_word:
            ranked, rows = slips.ranked(a.key), slips.at(a.key, 0)
            for (rank, _), (x,) in zip(ranked.slips, rows.tolist(), strict=True):
                if rank == SIMPLE and abs(x) > 1e-6:
                    yield a.key, x


@pytest.mark.parametrize("name", ["2/18", "4/1"])
def test_a_simple_slip_is_named_as_in_grading(practice_file, name):
    p = practice(practice_file, progress=None)[name].new()
    named = 0
    for key, x in simple_slips(name, p.givens):
        parts = score_receipt(problem(name), p.givens, {"answers": {key: x}}).parts
        graded = next(part for part in parts if part.key == key)
        p.forget()
        checked = p.check(**{key: x}).explained[key]
        named += bool(graded.causes)
        # a rarer slip that gives the same numbers is not in the file
        assert {c.name for c in checked} <= {c.name for c in graded.causes} or not graded.causes
        assert checked or all(c.group not in ("listed", "computed") for c in graded.causes)
    assert named > 2


@pytest.mark.parametrize("name", ["2/18", "4/16"])
def test_a_simple_slip_in_a_step_is_named(practice_file, name):
    p = practice(practice_file, progress=None)[name].new()
    slips, named, made = perturbed(problem(name), p.givens, of_steps=True), 0, 0
    keys = {s.key: s.value for s in steps(problem(name), p.givens)}
    for key in p.steps:
        if (ranked := slips.ranked(key)) is None:
            continue
        right = np.array(flat(keys[key]), float)
        for (rank, _), x in zip(ranked.slips, slips.at(key, 0), strict=True):
            if rank == SIMPLE and abs(x - right).max() > 0.1 * abs(right).max():
                p.forget()
                found = p.check_step(**{key: x.tolist() if len(x) > 1 else float(x[0])})
                made += 1
                named += bool(found.explained[key])
    assert named >= 0.8 * made > 0


def test_a_file_holds_what_slips_give_and_not_the_formulas(practice_file):
    with zipfile.ZipFile(practice_file) as archive:
        page = json.loads(archive.read("2-18.json"))
    assert page["slips"]
    for variant in page["variants"]:
        for place, numbers in variant["slips"]:
            assert 0 <= place < len(page["slips"])
            assert all(isinstance(x, float) for x in numbers)


@pytest.mark.parametrize(("name", "graded"), [
    ("4/10", None), ("8/8", None), ("9/8", None), ("7/6", None), ("4/18", []), ("4/40", []),
])  # fmt: skip
def test_no_wording_of_a_mistake_gives_the_formula_of_what_is_graded(name, graded):
    """In 4/10 the two terms that a slip may leave out were the answer, in 7/6 a listed mistake."""
    page, _ = page_of(name, 2, "solution", graded, draw=lambda p, values: None)
    wordings = json.dumps([row[3:] for row in page["slips"] + page["labels"]], ensure_ascii=False)
    assert " in {names}" in wordings or "…" in wordings
    symbol = rf"\b({'|'.join(problem(name).units)})\b"
    assert not re.search(rf"{symbol}[*/^]|[*/]{symbol}", wordings), wordings


@pytest.mark.parametrize(("formula", "shown"), [
    ("2*m*g", "the term in m, g"), ("m + g", "the term in m, g"), ("-m/(2*g)", "the term in m, g"),
    ("m", "the term m"), ("cos(m)", "the term cos(m)"), ("1/2", "the term 1/2"),
    ("the well-known, m*g/2, m^2)", "the term the well-known, …, …"),
    ("so that f = +m^2: read m's text.", "the term so that f = …: read m's text."),
])  # fmt: skip
def test_a_formula_is_called_by_the_names_in_it(formula, shown):
    assert without_formulas(Words("the term {formula}", formula=formula), {"m", "g"}) == shown

"""Banks judge as our grading does: what is right, what is just within and just outside the
tolerance, and every listed mistake with its diagnosis.
"""

import itertools
import xml.etree.ElementTree as ET
import zipfile

import pytest

from exercises.catalogue import problem, select
from exercises.catalogue.variants import flat
from grader.assignment.spec import Item, Spec, spec_of
from grader.commands import bank
from grader.course import CourseError
from grader.lms import FORMATS, write_bank
from grader.lms.pages import html
from grader.lms.write import variants_of
from grader.practice.plain import plain
from grader.practice.twins import sets_of_numbers, twin
from grader.scoring.margins import margins
from tests.grader.courses import command, ran
from tests.grader.lms.platforms import PLATFORMS

# mistakes too near to each other, vectors, a direction with a vector, a choice with a count, formulas, matrices, bounds,
# one number alone, one choice alone
FEW = "4/1", "4/16", "A/19", "5/26", "7/1", "3/27", "2/4", "2/8"
SEED = "tests"


def numbers_of(name, count):
    """[{name: number}] of the variants, as the bank draws them."""
    p = twin(problem(name))
    book = not any(g.vary for g in p.givens.values())
    return p, sets_of_numbers(p, count, (), SEED, book)


def as_read(a, x):
    """The components of an answer, as a response."""
    if a.kind.is_word:
        return [x if a.of else float(x)]
    return [float(part) for part in flat(x)]


def asked_of(p):
    one_number = lambda kind: len(kind.sealed((1.0,) * kind.length)) == 1
    return [a for a in p.answers if a.kind.is_word or one_number(a.kind)]


def check(numbers, form, tmp_path, count=2):
    """Answer every question of these problems in every way that matters; returns how often."""
    path, seen = tmp_path / form, 0
    write_bank(path, spec_of("hw", numbers), form, count, SEED, workers=1)
    judges = PLATFORMS[form](path.read_bytes())
    assert path.stat().st_mode & 0o777 == 0o600
    for name in numbers:
        p, sets = numbers_of(name, count)
        for n, values in enumerate(sets, 1):
            judge = judges.pop(f"{name.replace('/', '-')}-{n}")
            asked, found = asked_of(p), p.solve(values)
            right = [as_read(a, found[a.key]) for a in asked]
            assert judge(right)[0] == pytest.approx(1), name
            seen += _near(judge, asked, right)
            seen += _mistakes(judge, p, values, asked, right)
    assert not judges
    return seen


def _near(judge, asked, right):
    """Move each number to both sides of each edge: right exactly where our grading says so."""
    seen = 0
    for m, a in enumerate(asked):
        if a.kind.is_word:
            continue
        key = tuple(right[m])
        for c, (x, off) in enumerate(zip(key, margins(a, key), strict=True)):
            for share, side in itertools.product((0.99, 1.01), (1, -1)):
                moved = [*key]
                moved[c] = x + side * share * off
                ours = a.kind.is_right((tuple(moved),), (key,), a.atol)
                whole = [*right[:m], moved, *right[m + 1 :]]
                assert (judge(whole)[0] > 1 - 1e-9) == ours == (share < 1), (a.key, c, share)
                seen += 1
    return seen


def _mistakes(judge, p, values, asked, right):
    """Each listed mistake earns nothing for what it spoils, and gets its diagnosis."""
    seen = 0
    for name, answers in p.wrong(values).items():
        for m, a in enumerate(asked):
            if a.key not in answers:
                continue
            wrong = as_read(a, answers[a.key])
            if a.kind.is_word:
                ours = wrong == right[m]
            else:
                ours = a.kind.is_right((tuple(wrong),), (tuple(right[m]),), a.atol)
            if ours or any(x != x for x in wrong):
                continue
            share, output = judge([*right[:m], wrong, *right[m + 1 :]])
            assert share < 1 - 1e-9, (p.id, name, a.key)
            text = " ".join(plain(p.mistakes[name], p.units).split())
            assert any(text in s for s in output), (p.id, name, a.key, output)
            seen += 1
    return seen


@pytest.mark.parametrize("form", FORMATS)
def test_a_bank_judges_as_our_grading_does(form, tmp_path):
    assert check(FEW, form, tmp_path, count=1) > 100


@pytest.mark.slow
@pytest.mark.parametrize("form", FORMATS)
@pytest.mark.parametrize("chapter", ["appA", *(f"ch{n:02d}" for n in range(2, 12))])
def test_every_problem_is_judged_as_our_grading_does(chapter, form, tmp_path):
    assert check([p.id for p in select((chapter,))], form, tmp_path)


def test_margins_are_where_an_answer_stops_being_right():
    a = problem("4/16").answer("v_D")
    assert margins(a, (3.0, -4.0, 0.0)) == pytest.approx([0.025] * 3)  # half a percent of 5
    assert margins(a, (5.0, 0.01, 0.0)) == pytest.approx([0.025, 0.005, 0.025], rel=1e-3)
    low, high = margins(problem("2/4").answers[0], (1.0, 100.0))
    assert (low, high) == pytest.approx((0.005, 0.5))  # each bound by itself
    assert margins(problem("A/19").answer("n"), (1.0, 0.0, 0.0)) is None


def test_what_is_left_out_is_reported(tmp_path):
    sheet = spec_of("hw", ["A/19", "5/26", "7/1"])
    made = write_bank(tmp_path / "b", sheet, "qti", 3, SEED, workers=1)
    output = "\n".join(made.notes)
    assert "A/19 n left out: a direction" in output
    assert "5/26 has 1 of 3 variants" in output
    assert "7/1 asks for formulas on a sheet: asked with numbers" in output
    assert made.questions == 3 + 1 + 3


def test_a_mistake_is_not_listed_where_it_leaves_a_component_right():
    (q,), _ = variants_of(("4/16", "", {}, None), 1, SEED)
    blanks = [b for part in q.parts for b in part.blanks]
    assert all(abs(w.point[0] - b.key) > b.off for b in blanks for w in b.wrong)
    assert sum(len(b.wrong) for b in blanks) < 3 * sum(len(part.wrong) for part in q.parts)


def test_no_answer_is_near_one_that_a_course_grades(tmp_path):
    p, sets = numbers_of("4/16", 3)
    found, _ = variants_of(("4/16", "", {}, sets), 3, SEED)
    keys = [tuple(flat(p.solve(v)["v_D"])) for v in sets]
    practised = [part.key for q in found for part in q.parts if part.asked.key == "v_D"]
    assert len(practised) == 3
    assert not set(practised) & set(keys)
    assert variants_of(("5/26", "", {}, [{}]), 2, SEED)[0] == []  # the same for everybody: graded
    words = r"no question is left: .*would give away a graded answer"
    with pytest.raises(CourseError, match=words):
        write_bank(tmp_path / "b", spec_of("hw", ["5/26"]), "moodle", 2, SEED, {"5/26": [{}]}, 1)


def test_the_numbers_of_the_book_and_of_practice_are_not_in_a_bank():
    p, sets = numbers_of("4/16", 10)
    assert p.book_values not in sets
    assert not [v for v in sets_of_numbers(p, 10) if v in sets]


def test_texts_are_html_whose_formulas_mathjax_finds():
    assert html("A $a < b$ & **c**") == r"<p>A \(a &lt; b\) &amp; <strong>c</strong></p>"
    for name in ("4/16", "7/1", "11/13"):
        (q,), _ = variants_of((name, "", {}, None), 1, SEED)
        shown = html(q.text)
        assert "$" not in shown
        assert shown.count(r"\(") == shown.count(r"\)") > 0
        ET.fromstring(f"<div>{shown}</div>")


@pytest.mark.parametrize("form", FORMATS)
def test_tolerance_points_and_weights_are_those_of_the_sheet(form, tmp_path):
    options = {"points": 12, "tolerance": 0.04, "weights": {"a_D": 4}}
    made = Spec("hw", "Homework", (Item(problem("4/16"), options=options),))
    write_bank(tmp_path / "b", made, form, 1, SEED, workers=1)
    (judge,) = PLATFORMS[form]((tmp_path / "b").read_bytes()).values()
    p, (values,) = numbers_of("4/16", 1)
    right = [as_read(a, p.solve(values)[a.key]) for a in p.answers]
    assert judge([*right[:2], [1e6] * 3])[0] == pytest.approx(2 / 6)
    assert judge([[1.03 * x for x in part] for part in right])[0] == pytest.approx(1)
    assert judge([[1.05 * x for x in part] for part in right])[0] < 0.9


@pytest.mark.parametrize("form", FORMATS)
def test_a_bank_of_an_exam_or_of_a_sheet_without_help_has_no_diagnoses(form, tmp_path):
    p, (values,) = numbers_of("4/16", 1)
    item = Item(p)
    silent, exam = Item(p, options={"help": "none"}), Spec("hw", "", (item,), late="refuse")
    text = " ".join(plain(next(iter(p.mistakes.values())), p.units).split())
    silences = [(Spec("hw", "", (silent,)), False), (exam, False)]
    for sheet, says in ((Spec("hw", "", (item,)), True), *silences):
        made = write_bank(tmp_path / "b", sheet, form, 1, SEED, workers=1)
        (judge,) = PLATFORMS[form]((tmp_path / "b").read_bytes()).values()
        right = {a.key: as_read(a, p.solve(values)[a.key]) for a in p.answers}
        wrong = {k: [*flat(x)] for k, x in next(iter(p.wrong(values).values())).items()}
        assert any(text in output for output in judge([*{**right, **wrong}.values()])[1]) == says
        assert any("no diagnoses" in note for note in made.notes) != says
        assert any("the window of the exam" in note for note in made.notes) == bool(sheet.late)
        assert any("follows from a wrong one" in note for note in made.notes)


def test_a_changed_text_has_the_numbers_of_each_variant(tmp_path):
    p = problem("4/16")
    text = f"## Mine\n\nOurs turns at ${p.notation['omega']} = 0.6$."
    (q, r), _ = variants_of(("4/16", text, {"points": 7}, None), 2, SEED)
    assert q.text != r.text
    assert "Ours turns" in q.text
    assert "= 0.6$" not in q.text


def test_special_characters_of_the_formats_in_a_text_do_no_harm(tmp_path):
    from dataclasses import replace

    from grader.lms import moodle
    from grader.lms.questions import Wrong

    evil = 'uses a#b ~ {1:SA:=x} \\} <b> & "quotes" 50%'
    (q,), _ = variants_of(("4/16", "", {}, None), 1, SEED)
    part = replace(q.parts[1], wrong=(Wrong((1.0, 2.0, 3.0), (0.1, 0.1, 0.1), evil),))
    q = replace(q, parts=(part, q.parts[2]))
    judge = PLATFORMS["moodle"](moodle.write("hw", [q]))[q.ident]
    share, output = judge([[1.0, 2.0, 3.0], list(q.parts[1].key)])
    assert share == pytest.approx(0.5)
    assert output[:3] == [f"It fits a solution that {evil}."] * 3


def test_the_command_offers_every_format():
    (form,) = [x for x in bank.params if x.name == "form"]
    assert list(form.type.choices) == list(FORMATS)


@pytest.mark.integration
def test_the_command_writes_a_bank_and_what_it_leaves_out(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    options = "--format", "canvas", "--variants", 2
    output = ran(command("bank", "hw3", "--problems", "4/16", "A/19", *options))
    assert "4 questions of 2 problems" in output
    assert "A/19 n left out" in (tmp_path / "hw3-canvas.zip.txt").read_text()
    assert zipfile.is_zipfile(tmp_path / "hw3-canvas.zip")

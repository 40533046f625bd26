"""Sheets and keys as PDF: what they show, whom they are for; every problem can be printed."""

import copy
import csv
import hashlib
import importlib.util
import re
from dataclasses import replace

import pytest

from exercises.catalogue import problem, select
from exercises.catalogue.variants import draw
from grader.assignment.spec import spec_of
from grader.paper import PaperError, write, write_papers
from grader.paper.markup import formula, typst
from grader.paper.sheet import PaperItem, Student, key, overview, sheet, variant_code
from grader.paper.write import NEEDED, pdf
from tests.grader.courses import command, ran
from tests.grader.instructors_cells import OWN, cell

pytestmark = pytest.mark.skipif(
    not all(map(importlib.util.find_spec, NEEDED)), reason="typst is not installed"
)
FEW = "4/3", "3/27", "A/19", "5/26", "4/10"  # vectors, matrices, a direction, words, formulas


def of(*numbers, seed="ada"):
    """(entries, student) of a sheet of these problems."""
    values = {n: draw(problem(n), f"{seed} {n}".encode()) for n in numbers}
    student = Student("ada", "Ada *#$_\\", "ABCD-1234", values)
    return [PaperItem(n, "", 2) for n in numbers], student


def raw(files):
    """Any remains of LaTeX or Markdown: outside strings and formulas."""
    text = re.sub(r'"(?:[^"\\]|\\.)*"', "", files["main.typ"].decode())
    formulas = re.findall(r"\$([^$]*)\$", text)
    outside = re.sub(r"\$[^$]*\$", "", text)
    return re.findall(r"\$|\\|\*\*|`", outside) + [
        f for f in formulas if re.search(r"\\[A-Za-z]|\\text|\blimits", f)
    ]


CHAPTERS = "appA", *(f"ch{n:02d}" for n in range(2, 12))


@pytest.mark.parametrize(
    "some", [FEW, *(pytest.param(c, marks=pytest.mark.slow) for c in CHAPTERS)]
)
def test_sheet_key_and_overview_are_printed_and_nothing_of_latex_is_left(some):
    numbers = some if some is FEW else [p.id for p in select((some,))]
    for first in range(0, len(numbers), 10):
        entries, student = of(*numbers[first : first + 10])
        papers = [made("Homework", entries, student) for made in (sheet, key)]
        assert [raw(files) for files in papers] == [[], []]
        papers.append(overview("Homework", entries, [student, student]))
        assert all(pdf(files).startswith(b"%PDF") for files in papers)


def test_in_a_key_matrices_fit_the_line_and_a_heading_stays_with_its_answers():
    text = key("Homework", *of("7/3", "4/3"))["main.typ"].decode()
    outside = re.sub(r"#side\(\$.*?\$, \d+cm\)", "", text)
    assert text.count("mat(") > 3
    assert "mat(" not in outside
    for problem_and_table in text.split("#block(breakable: false)[")[1:]:
        assert "level: 2" in problem_and_table.partition("#terms-table(")[0]


def test_a_sheet_has_the_students_numbers_and_nothing_of_the_key():
    entries, student = of("4/16")
    shown = sheet("Homework", entries, student)["main.typ"].decode()
    answers = key("Homework", entries, student)["main.typ"].decode()
    numbers = student.values["4/16"]
    assert all(f"{x:g}" in shown for x in numbers.values())
    right = problem("4/16").solve(numbers)["v_D"]
    assert all(f"{x:.6g}".lstrip("-") in answers for x in right)
    assert not any(f"{x:.6g}".lstrip("-") in shown for x in right if x)
    assert student.code in shown
    assert student.code in answers


def test_figures_and_changed_texts_have_the_students_own_numbers():
    figure = lambda seed: sheet("Homework", *of("4/16", seed=seed))["4-16.svg"]
    assert figure("ada") == figure("ada") != figure("emmy")
    assert b"<path" in figure("ada")
    assert b"<image" not in figure("ada")
    assert b"<text" not in figure("ada")  # its fonts need not be there
    _, student = of("4/16")
    text = "## Mine\n\nOurs turns at $\\omega = 0.6$ always."
    shown = sheet("Homework", [PaperItem("4/16", text, 2)], student)["main.typ"].decode()
    assert f"$omega = {student.values['4/16']['omega']:g}$" in shown


def test_what_is_the_same_for_everybody_appears_once_and_a_code_depends_on_the_numbers():
    entries, student = of("4/3", "5/26")
    shown = overview("Homework", entries, [student] * 5)["main.typ"].decode()
    assert shown.count('"ABCD-1234"') == 5
    assert shown.count('"all"') == 1
    codes = {variant_code(s, {"4/3": {"a": x}}) for s in (b"1", b"2") for x in (1, 2)}
    assert len(codes) == 4
    assert all(re.fullmatch(r"[A-Z2-7]{4}-[A-Z2-7]{4}", c) for c in codes)


def test_what_a_user_types_is_shown_and_never_run():
    evil = 'A #read("/etc/passwd") $x_1$ \\ // */ ] "quoted" `code` <a> @b = \x00'
    entries = [PaperItem(text=evil), *of("4/3")[0]]
    student = replace(of("4/3")[1], name=evil, login="a.b")
    files = sheet(evil, entries, student)
    assert pdf(files).startswith(b"%PDF")
    assert "read" not in re.sub(r'"(?:[^"\\]|\\.)*"', "", files["main.typ"].decode())
    assert "\\u0000" not in files["main.typ"].decode()  # a string of Typst has no such escape


def test_a_formula_that_cannot_be_set_is_named():
    _, student = of("4/3")
    with pytest.raises(PaperError, match=r"\\frac\{1\$ is not a formula of LaTeX \(Unmatched"):
        typst(r"so $x = \frac{1$")
    with pytest.raises(PaperError, match=r"cannot be set: it has no command \\foo"):
        pdf(sheet("Homework", [PaperItem(text=r"so $\foo x$")], student))


def test_markdown_of_an_instructor_is_typeset_and_a_unit_follows_its_number():
    text = "# T\n\n1. *a*\n2. **b** [c](d)\n\n| x | y |\n|---|---|\n| 1 | $\\frac12$ |\n\n---\n\n```\nf\n```\n"
    made = typst(text + "\n![words](u.png) <b>h</b>")
    for piece in ("heading(level: 1)", "#enum", "#emph", "#strong", "#link", "#terms-table", "$1/2$",
                  "#line", "#raw(block: true", "words"):  # fmt: skip
        assert piece in made
    assert '"/s"' in formula(r"12^\circ\text{/s}")
    assert ' "/s"' not in formula(r"12^\circ\text{/s}")


def test_a_class_without_a_course_has_a_secret_of_its_own(tmp_path):
    class_, spec = [{"id": "ada"}, {"id": "emmy"}], spec_of("hw3", ["4/3"])
    first = write_papers(tmp_path / "a", spec, class_, workers=1)
    assert [p.name for p in first.sheets + first.keys] == ["ada.pdf", "emmy.pdf"] * 2
    made = {p: hashlib.sha256(p.read_bytes()).digest() for p in (tmp_path / "a").rglob("*.pdf")}
    assert len({*made.values()}) == 5  # two sheets, two keys, the overview
    assert all(p.stat().st_mode & 0o777 == 0o600 for p in made)
    assert all(p.parent.stat().st_mode & 0o777 == 0o700 for p in made)
    again = write_papers(tmp_path / "a", spec, class_, key_for=["emmy"], workers=1)
    assert (again.sheets, len(again.keys)) == ((), 1)
    assert hashlib.sha256(again.keys[0].read_bytes()).digest() == made[again.keys[0]]
    other = write_papers(tmp_path / "b", spec, class_[:1], workers=1)
    assert other.sheets[0].read_bytes() != first.sheets[0].read_bytes()
    with pytest.raises(PaperError, match="--key-for bob: no such student"):
        write_papers(tmp_path / "a", spec, class_, key_for=["bob"], workers=1)


def test_without_typst_it_says_what_to_install(monkeypatch):
    monkeypatch.setattr(write, "NEEDED", ("typst", "no_such_wheel"))
    words = r"no_such_wheel, not installed here: pip install -e '\.\[paper\]'"
    with pytest.raises(PaperError, match=words):
        write.require_typst()


@pytest.mark.integration
def test_the_paper_of_a_course_has_the_numbers_and_texts_of_its_sheets(tmp_path):
    roster, course = tmp_path / "roster.csv", tmp_path / "mechanics"
    with roster.open("w", newline="") as f:
        csv.writer(f).writerows([["login", "first name", "last name"], ["ada", "Ada", "Lovelace"]])
    where = "--course", course, "--students", roster
    ran(command("build", "hw3", "4/3", "--points", "4/3=7", *where))
    from grader.assignment.chosen import chosen
    from grader.course import Course
    from grader.course.files import read_json, write_json
    from grader.paper.write import _entry

    path = Course(course).source("hw3")
    notebook = read_json(path)
    role = lambda c: c["metadata"]["newton_euler"]["role"]
    text = next(c for c in notebook["cells"] if role(c) == "statement")
    text["source"] = text["source"].replace("The base of a robot", "The base of Marvin")
    rubric = cell("markdown", "Is $a$ constant?\n### BEGIN SOLUTION\nNever.\n### END SOLUTION",
                  "rubric", grade=True, solution=True, points=4)  # fmt: skip
    rule = cell("markdown", "No *pens*.", "rule", locked=True)
    notebook["cells"] += [*copy.deepcopy(OWN), rubric, rule]
    write_json(path, notebook)
    output = ran(command("paper", "hw3", "--course", course))
    assert "does not run it: helper, square, test_square, share, a cell of code\n" in output
    assert (course / "paper" / "hw3" / "sheets" / "ada.pdf").exists()
    items = chosen("hw3", course=Course(course)).items
    entries = [_entry(i) for i in items]
    assert [e.points for e in entries] == [7, 3, 2, 5, 4, 0]
    kept = Course(course).values("hw3", "ada", [items[0].problem])
    student = Student("ada", "Ada", "X", kept)
    papers = (made("Homework", entries, student) for made in (sheet, key))
    front, solved = (files["main.typ"].decode() for files in papers)
    assert "Marvin" in front
    assert all(f"{x:g}" in front for x in kept["4/3"].values())
    for asked, graded_by in (("Measure it", "2 for a photo"), ("constant?", "Never"),
                             ("Your answer", "Why?"), ("Your answer", "# your plot")):  # fmt: skip
        assert asked in front
        assert graded_by not in front
        assert graded_by in solved
    assert "MARK SCHEME" not in front + solved

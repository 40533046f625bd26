"""CSV of every part, and the files that Canvas, Moodle and Gradescope import."""

import csv
import re
import string

import pytest
from nbgrader.api import Grade

from grader.commands.results import export as export_command
from grader.grading import grade
from grader.reports import FORMATS
from grader.reports.export import cell
from tests.grader.courses import command, points, ran
from tests.grader.reports.results import MISTAKE, NAMES, graded_course


def rows_of(path, encoding="utf-8"):
    with open(path, newline="", encoding=encoding) as f:
        return list(csv.reader(f))


def test_the_command_offers_every_format():
    (option,) = [p for p in export_command.params if p.name == "form"]
    assert list(option.type.choices) == list(FORMATS)


def test_every_part_has_a_line_and_no_text_is_a_formula_of_a_spreadsheet(tmp_path):
    course = graded_course(tmp_path / "c")
    ran(command("export", "ch04", "--course", course.path, "--to", tmp_path / "parts.csv"))
    header, *rows = rows_of(tmp_path / "parts.csv", "utf-8-sig")
    assert header[:5] == ["student", "last_name", "first_name", "problem", "part"]
    assert len(rows) == 20 * 4
    assert {r[1] for r in rows} == {*NAMES[:3], "'=cmd()", NAMES[4]}
    assert {r[8] for r in rows} == {"'=not right"}
    assert {r[9] for r in rows} == {"", MISTAKE}


def exported(fresh, form, tmp_path):
    fresh.enrol([
        {"id": "ada", "first_name": "Ada", "last_name": "Love, Jr.", "email": "a@uni.edu",
         "lms_user_id": "4711"},
        {"id": "zoe", "first_name": "Zoë", "last_name": 'O"Hara', "email": "z@uni.edu"},
    ])  # fmt: skip
    path = tmp_path / f"{form}.csv"
    ran(command("export", "ch04", "--course", fresh.path, "--format", form, "--to", path))
    return rows_of(path), path.read_text(encoding="utf-8")


@pytest.mark.parametrize("form", [form for form in FORMATS if form != "parts"])
def test_no_name_or_id_is_a_formula_of_a_spreadsheet_for_a_platform(fresh, form, tmp_path):
    hostile = {"first_name": "@SUM(1)", "last_name": "+1+cmd", "email": "-2@uni.edu"}
    others = {"first_name": "\n=1", "last_name": "\u200b＝2", "email": "\x00 @3"}
    fresh.enrol([{"id": "ada", **hostile, "lms_user_id": "=4711"}, {"id": "ben", **others}])
    path = tmp_path / f"{form}.csv"
    ran(command("export", "ch04", "--course", fresh.path, "--format", form, "--to", path))
    read = [c for row in rows_of(path, "utf-8-sig") for c in row]
    plain = [c.lstrip(f"{string.whitespace}\0\u200b") for c in read]
    assert not [c for c in plain if c.startswith(tuple("=+-@＝＋－＠"))]
    assert any("+1+cmd" in c for c in read)


@pytest.mark.parametrize("text", [
    "=1", "\t=1", "\r=1", "\x00=1", "\u200b=1", "\ufeff＝1", "\xa0@A", "−1", "﹦1", "Ada;=1", "Ada\t+1", "Ada\n-1",
    "Ada;\u200b=1", "Ada\t\xad\u2060@1", "Ada;\ufeff＝1", "⁺1", "⁼1", "Ada;₋1", "\u034f=1", "\ufe0f=1",
    "\u2800=1", "\u3164=1", "Ada;\xa0=1", "Ada\n\u3000=1", "Ada;\x1f=1", "Ada;\uffa0=1", "Ada\v=1", "Ada\x85=1", "Ada\u2028+1", 'Ada;"=1;', '"=1',
])  # fmt: skip
def test_no_text_is_a_formula_wherever_a_spreadsheet_ends_its_cells(text):
    parts = re.split("[;\t\r\n\v\x85\u2028]", cell(text))
    assert not [p for p in parts if re.match(r"([^\w']|[\u3164\uffa0])*[=+\-@−＝＋－＠﹦⁺⁼₋]", p)]


@pytest.mark.parametrize("text", ["Ada", "O'Hara; J.", "1 - 2", "a; -3 instead of 3"])
def test_an_honest_text_stays_as_it_is(text):
    assert cell(text) == text


def test_canvas_imports_the_points_under_its_own_ids(fresh, tmp_path):
    rows, text = exported(fresh, "canvas", tmp_path)
    assert rows[0] == ["Student", "ID", "SIS User ID", "SIS Login ID", "Section", "ch04"]
    assert rows[1] == ["    Points Possible", "", "", "", "", "11"]
    assert ["Love, Jr., Ada", "4711", "", "ada", "", "11"] in rows
    assert ['O"Hara, Zoë', "", "", "zoe", "", ""] in rows  # nothing handed in: no zero
    assert '"Love, Jr., Ada"' in text
    assert '"O""Hara, Zoë"' in text


def test_moodle_finds_students_by_address_or_id(fresh, tmp_path):
    rows, _ = exported(fresh, "moodle", tmp_path)
    assert rows[0] == [
        "First name", "Last name", "ID number", "Username", "Email address", "ch04",
    ]  # fmt: skip
    assert ["Ada", "Love, Jr.", "ada", "ada", "a@uni.edu", "11"] in rows


def test_gradescope_has_its_columns(fresh, tmp_path):
    rows, _ = exported(fresh, "gradescope", tmp_path)
    assert rows[0] == [
        "First Name", "Last Name", "SID", "Email", "Sections", "ch04", "ch04 - Max Points",
    ]  # fmt: skip
    assert ["Ada", "Love, Jr.", "ada", "a@uni.edu", "", "11", "11"] in rows


@pytest.mark.integration
def test_the_points_are_those_of_the_gradebook_with_what_a_person_gave_and_took(fresh, tmp_path):
    with fresh.gradebook() as book:
        submission = book.find_submission("ch04", "ada")
        (notebook,) = submission.notebooks
        grade = next(g for g in notebook.grades if g.name == "answer-4-16")
        grade.manual_score, grade.extra_credit, grade.needs_manual_grade = 1, 0.5, True
        notebook.late_submission_penalty = 2
        book.db.commit()
    assert points(fresh)["ada"]["answer-4-16"][1] == 1
    rows, _ = exported(fresh, "canvas", tmp_path)
    assert ["Love, Jr., Ada", "4711", "", "ada", "", "7.5"] in rows
    where = "--course", fresh.path, "--to", tmp_path / "m.csv"
    _, out = command("export", "ch04", "--format", "moodle", *where)
    assert "1 student with cells that wait for a person" in out
    assert "The penalties of 1 student for lateness are subtracted; see --no-penalties." in out
    ran(command("export", "ch04", "--format", "canvas", "--no-penalties", *where))
    assert ["Love, Jr., Ada", "4711", "", "ada", "", "9.5"] in rows_of(tmp_path / "m.csv")


@pytest.mark.integration
def test_the_lines_of_a_student_sum_up_to_the_gradebook_with_own_questions_too(fresh, tmp_path):
    """And ``stats`` has a line for such a question; its correlation was computed by hand."""
    grade(fresh, "ch04")
    with fresh.gradebook() as book:
        (master,) = book.find_assignment("ch04").notebooks
        book.add_grade_cell("essay", "ch04", "ch04", max_score=5, cell_type="markdown")
        for submission in book.assignment_submissions("ch04"):
            (notebook,) = submission.notebooks
            cell = book.find_grade_cell("essay", "ch04", "ch04")
            given = 3 if submission.student_id == "ada" else 1
            notebook.grades.append(Grade(cell=cell, notebook=notebook, manual_score=given))
        changed = book.find_grade("answer-4-16", "ch04", "ch04", "ben")
        changed.manual_score, changed.extra_credit = 2.5, 0.25
        book.db.commit()
        assert master.name == "ch04"
    path = tmp_path / "parts.csv"
    assert command("export", "ch04", "--course", fresh.path, "--to", path)[0] == 0
    header, *rows = rows_of(path, "utf-8-sig")
    place = {name: n for n, name in enumerate(header)}
    with fresh.gradebook() as book:
        for student in fresh.roster():
            own = [r for r in rows if r[place["student"]] == student]
            points = sum(float(r[place["points"]]) for r in own)
            assert points == pytest.approx(book.find_submission("ch04", student).score), student
            assert [r[place["points"]] for r in own if r[place["problem"]] == "essay"]
    _, out = command("stats", "ch04", "--course", fresh.path)
    (line,) = [x for x in out.splitlines() if x.strip().startswith("essay")]
    assert line.split()[1:3] == ["0.27", "0.64"]

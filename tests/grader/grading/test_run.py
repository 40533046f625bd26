"""A run over all submissions: what cannot be graded is reported and touches nobody else; only what
changed runs again.
"""

import json
import re
import shutil

import pytest

from grader.course import CourseError
from grader.grading import grade
from grader.submission import UnreadableError, parse_notebook
from tests.grader.courses import command, nbgrader, points, read, refused, submit, total
from tests.grader.submissions import DAMAGED, RIGHT, work


def test_unchanged_submissions_are_not_run_again_and_changed_ones_are(fresh, monkeypatch):
    from grader.grading import one

    ran, run = [], one.execute
    monkeypatch.setattr(one, "execute", lambda h, s, n: ran.append(s.student) or run(h, s, n))
    everyone = sorted(fresh.roster())
    first = {r.student: r.points for r in grade(fresh, "ch04")}
    assert sorted(ran) == everyone
    ran.clear()
    again = grade(fresh, "ch04")
    assert ran == []
    assert all(r.unchanged for r in again)
    assert {r.student: r.points for r in again} == first
    submit(fresh, "dan", work(fresh, "dan"))
    assert {r.student for r in grade(fresh, "ch04") if not r.unchanged} == {"dan"}
    assert ran == ["dan"]
    ran.clear()
    grade(fresh, "ch04", ["ada"], force=True)
    assert ran == ["ada"]


def test_the_record_of_scores_holds_every_part(course):
    record = json.loads((course.path / "scores/ch04/ben.json").read_text())
    assert [s["problem"] for s in record["scores"]] == ["4/1", "4/2", "4/10", "4/16", "4/31"]
    assert any(p["diagnosis"] for s in record["scores"] for p in s["parts"])
    assert course.secret.hex() not in json.dumps(record)


def test_unsandboxed_grading_says_so_in_the_notebook_and_counts_for_no_run_in_the_cage(fresh):
    (result,) = grade(fresh, "ch04", ["ada"], sandbox=False)
    assert "unsandboxed: asked for" in result.note
    notebook = read(fresh.path / "autograded/ada/ch04/ch04.ipynb")
    assert "unsandboxed" in notebook["cells"][0]["source"]
    (again,) = grade(fresh, "ch04", ["ada"])
    assert (again.unchanged, again.sandbox) == (False, "namespaces")


def test_a_damaged_notebook_is_reported_and_its_earlier_grade_and_everybody_elses_stay(fresh):
    grade(fresh, "ch04", workers=1)
    before = points(fresh)
    kept = (fresh.path / "autograded/ada/ch04/ch04.ipynb").read_text()
    text, why = DAMAGED["truncated"]
    submit(fresh, "ada", text)
    for force in (False, True):
        results = {r.student: r for r in grade(fresh, "ch04", force=force, workers=1)}
        assert why in results["ada"].problem
        assert "ask for it again. An earlier grade stays as it is" in results["ada"].problem
        assert points(fresh) == before
        assert (fresh.path / "autograded/ada/ch04/ch04.ipynb").read_text() == kept
        assert not [s for s, r in results.items() if r.problem and s != "ada"]


@pytest.mark.parametrize("how", DAMAGED)
def test_what_is_not_a_notebook_is_refused_in_a_sentence(how):
    text, why = DAMAGED[how]
    with pytest.raises(UnreadableError, match=re.escape(why)):
        parse_notebook("ch04.ipynb", text.encode())


def test_a_notebook_that_is_not_text_or_huge_is_reported(fresh):
    path = submit(fresh, "dan", "")
    path.write_bytes(b"\x89PNG\r\n\x1a\n\xff")
    assert "cannot be read" in grade(fresh, "ch04", ["dan"], workers=1)[0].problem
    with open(path, "wb") as f:
        f.truncate(10**9)
    assert grade(fresh, "ch04", ["dan"], workers=1)[0].problem.startswith(
        "ch04.ipynb: it has more than the 67.1 MB that are read"
    )


def test_a_submission_named_differently_is_found_and_reported(fresh):
    path = fresh.path / "submitted/dan/ch04/ch04.ipynb"
    path.rename(path.with_name("Homework (1).ipynb"))
    result = grade(fresh, "ch04", ["dan"], workers=1)[0]
    assert "expected the notebook ch04.ipynb" in result.problem
    assert "it holds Homework (1).ipynb; if that is the work, rename it" in result.problem


def test_a_strangers_folder_is_reported_and_gets_no_entry(fresh):
    submit(fresh, "nobody", work(fresh, "dan"))
    out = refused(command("grade", "ch04", "--course", fresh.path, "--workers", 1), 1)
    assert (
        "Not graded: nobody is not on the roster; check the folder's name, or add the student "
        "with: nbgrader db student add nobody"
    ) in out
    assert "nobody" not in fresh.roster()
    assert {s: total(c) for s, c in points(fresh).items()} == {**RIGHT, "dan": 0}


@pytest.mark.parametrize("route", ["grader", "nbgrader"])
def test_an_assignment_that_was_not_released_is_reported(fresh, route):
    shutil.rmtree(fresh.path / "release")
    if route == "grader":
        out = refused(command("grade", "ch04", "--course", fresh.path))
        assert "there is no released ch04" in out
        assert "generate it with: nbgrader generate_assignment ch04" in out
    else:
        for s in ("ben", "cleo", "dan", "eve", "mallory"):
            shutil.rmtree(fresh.path / "submitted" / s)
        code, out = nbgrader("autograde", "ch04", cwd=fresh.path)
        assert code != 0
        assert "there is no released ch04" in out


def test_an_assignment_or_a_student_without_work_is_refused(fresh):
    with fresh.gradebook() as book:
        book.remove_assignment("ch04")
    with pytest.raises(CourseError, match=r"the gradebook does not know ch04; generate it again"):
        grade(fresh, "ch04")
    with pytest.raises(CourseError, match=r"there is no released ch05.*build it with"):
        grade(fresh, "ch05")
    with pytest.raises(CourseError, match=r"no submission of ch04 by zoe; there are ada, ben"):
        grade(fresh, "ch04", ["zoe"])


def test_a_bug_in_grading_one_submission_keeps_nobody_else_from_a_grade(fresh, monkeypatch):
    from grader.grading import one

    original = one.grade_notebook
    broken = lambda sheet, *rest: 1 / 0 if sheet.student == "ben" else original(sheet, *rest)
    monkeypatch.setattr(one, "grade_notebook", broken)
    results = {r.student: r for r in grade(fresh, "ch04", force=True, workers=1)}
    words = "could not be graded, which is a bug of the grader: ZeroDivisionError"
    assert words in results["ben"].problem
    assert not [s for s, r in results.items() if r.problem and s != "ben"]

"""Whatever comes in, it is told in words what was expected, what came and what to do; nobody else's grade is touched, nothing is half-written."""

import json
import os
import shutil

import pytest

from grader.assignment import master_notebook
from grader.course import Course, CourseError, check_id, read_roster, write_json
from grader.grading import grade
from tests.grader.courses import nbgrader, points, read, submit, total
from tests.grader.nbgrader_hooks.test_preprocessors import work
from tests.grader.test_command_line import command


def graded(course, student, **options):
    """The Result of one student, and everybody's points."""
    (result,) = (r for r in grade(course, "ch04", **options) if r.student == student)
    return result, {s: total(c) for s, c in points(course).items()}


RIGHT = {"ada": 11, "ben": 8, "cleo": 4, "eve": 9, "mallory": 0}

ANSWERS = {  # the cell of 4/16 (alpha_CD, v_D, a_D) or 4/1: what is said of it
    "wrong shape": ("v_D = [1, 2]", "v_D", "expected a vector, three numbers as in [1.0, 0, -2.5], in mm/s; got 2 numbers: [1, 2]"),
    "wrong kind": (
        "v_D = 'fast'",
        "v_D",
        "expected a vector, three numbers as in [1.0, 0, -2.5], in mm/s; got the text 'fast'; write it without quotation marks",
    ),
    "nan": (
        "import numpy as np\nv_D = np.array([1, 0, 2]) * np.nan",
        "v_D",
        "got nan, which comes from a division by zero or the root of a negative number",
    ),
    "still a symbol": ("import sympy\nv_D = [sympy.Symbol('q'), 0, 0]", "v_D", "q still contains q; put in the numbers"),
    "a dict": ("v_D = {'x': 1}", "v_D", "got a dict, which has no order"),
    "a lambda": ("v_D = lambda t: t", "v_D", "expected a vector"),
}


def test_answers_that_cannot_be_read_are_told_with_what_was_expected_and_the_rest_counts(fresh):
    for n, (name, (text, key, words)) in enumerate(ANSWERS.items()):
        answers = work(fresh, "dan")
        submit(fresh, "dan", work(fresh, "dan", p4_16=next(c["source"] for c in answers["cells"] if c["id"] == "answer-4-16") + "\n" + text))
        result, everybody = graded(fresh, "dan", workers=1) if n == 0 else (grade(fresh, "ch04", ["dan"], workers=1)[0], None)
        part = next(p for p in result.scores["4/16"].parts if p.key == key)
        assert part.verdict == "unreadable", name
        assert words in part.message
        assert result.points == 10
        assert everybody is None or everybody == {**RIGHT, "dan": 10}


def test_the_right_vector_in_another_frame_is_told(fresh):
    from exercises.catalogue import problem

    values = fresh.values("ch04", "dan", [problem("4/16")])["4/16"]
    a_D = problem("4/16").solve(values)["a_D"]
    rod = next(f for f in a_D.frame.tree if f.name == "rod")
    cell = f"a_D = {[float(x) for x in a_D.components(rod)]}"
    submit(fresh, "dan", work(fresh, "dan", p4_16=cell))
    result = grade(fresh, "ch04", ["dan"], workers=1)[0]
    assert "components along the axes of the rod" in result.scores["4/16"].parts[2].message


def without(notebook, *cell_ids):
    return {**notebook, "cells": [c for c in notebook["cells"] if c["id"] not in cell_ids]}


def copied(notebook, cell_id, text):
    cell = next(c for c in notebook["cells"] if c["id"] == cell_id)
    return {**notebook, "cells": [*notebook["cells"], {**cell, "id": "copied", "source": text}]}


def untouched(course, student):
    return read(course.personal_path("ch04", student))


NOTEBOOKS = {  # how it was changed: (points of dan, problem, what is said)
    "no receipt cell": (lambda c: without(work(c, "dan"), "receipt-4-16"), 11, None, ""),
    "no statement and no numbers": (lambda c: without(work(c, "dan"), "statement-4-16", "givens-4-16", "setup"), 11, None, ""),
    "no answer cell": (
        lambda c: without(work(c, "dan"), "answer-4-16"),
        8,
        "4/16",
        "the answer cell of 4/16 is missing from the notebook; fetch the assignment again",
    ),
    "a copied answer cell": (
        lambda c: copied(work(c, "dan"), "answer-4-16", "v_D = 1"),
        11,
        "4/16",
        "2 copies of the answer cell; the first one that was filled in was graded",
    ),
    "worked in the copy": (
        lambda c: copied(without(untouched(c, "dan")), "answer-4-16", next(x["source"] for x in work(c, "dan")["cells"] if x["id"] == "answer-4-16")),
        3,
        "4/16",
        "2 copies of the answer cell; the first one that was filled in was graded",
    ),
    "a copied receipt cell": (lambda c: copied(work(c, "dan"), "receipt-4-16", "receipt('4/16')"), 11, None, ""),
    "cells in another order": (lambda c: {**work(c, "dan"), "cells": work(c, "dan")["cells"][::-1]}, 11, None, ""),
    "no metadata of ours": (lambda c: {**work(c, "dan"), "metadata": {}}, 11, None, ""),
    "no nbgrader metadata": (
        lambda c: json.loads(json.dumps(work(c, "dan")).replace('"nbgrader"', '"gone"')),
        0,
        "4/16",
        "the answer cell of 4/16 is missing",
    ),
    "metadata of an old schema": (
        lambda c: json.loads(json.dumps(work(c, "dan")).replace('"schema_version": 3', '"schema_version": 1')),
        11,
        None,
        "",
    ),
    "text as a list of lines": (
        lambda c: {**work(c, "dan"), "cells": [{**x, "source": x["source"].splitlines(True)} for x in work(c, "dan")["cells"]]},
        11,
        None,
        "",
    ),
    "half a character": (lambda c: work(c, "dan", p4_1="speed = '\ud800'"), 9, None, ""),
    "markup in an error": (
        lambda c: work(c, "dan", p4_1="raise ValueError('[/red] [bold] <script>alert(1)</script> ' + chr(27))"),
        9,
        "4/1",
        "[/red] [bold] <script>",
    ),
    "a magic and a shell command": (lambda c: work(c, "dan", p4_1="%matplotlib inline\n!ls\nspeed = 1"), 9, None, ""),
    "ends the process": (
        lambda c: work(c, "dan", p4_31="import os; os._exit(0)"),
        9,
        "4/31",
        "the end of its process: the cell ended Python, crashed it",
    ),
}


@pytest.mark.parametrize("how", NOTEBOOKS)
def test_a_notebook_that_was_changed_is_graded_by_its_answer_cells_alone(fresh, how):
    change, expected, number, words = NOTEBOOKS[how]
    submit(fresh, "dan", change(fresh))
    result = grade(fresh, "ch04", ["dan"], workers=1)[0]
    assert (result.problem, result.points) == ("", expected)
    if number:
        assert words in result.scores[number].note


@pytest.mark.slow
def test_the_same_notebooks_get_the_same_points_from_nbgrader(fresh):
    for name in ("personal/ch04", "submitted"):
        shutil.rmtree(fresh.path / name)
    with fresh.gradebook() as book:
        for n in range(len(NOTEBOOKS)):
            book.add_student(f"dan{n}")
    expected = {}
    for n, (change, right, *_) in enumerate(NOTEBOOKS.values()):
        student = f"dan{n}"
        write_json(fresh.personal_path("ch04", student), master_notebook(fresh, "ch04", student))
        submit(fresh, student, change(Named(fresh, student)))
        expected[student] = right
    assert {r.student: r.points for r in grade(fresh, "ch04")} == expected
    ours = points(fresh)
    code, out = nbgrader("autograde", "ch04", "--force", cwd=fresh.path)
    assert code == 0, out
    theirs = points(fresh)
    assert {s: theirs[s] for s in expected} == {s: ours[s] for s in expected}


class Named:
    """A course in which whoever is asked for is this student."""

    def __init__(self, course, student):
        self.course, self.student = course, student

    def personal_path(self, assignment, _):
        return self.course.personal_path(assignment, self.student)

    def values(self, assignment, _, problems):
        return self.course.values(assignment, self.student, problems)


DAMAGED = {
    "truncated": ('{"cells": [{"cell_type": "co', "is damaged and cannot be read as a notebook"),
    "empty": ("", "ch04.ipynb is empty"),
    "not json": ("# my homework\n", "is damaged and cannot be read as a notebook"),
    "a list": ("[1, 2, 3]", "is not a notebook of format 4: it has no list of cells"),
    "no cells": ('{"nbformat": 4}', "it has no list of cells"),
    "cells of another kind": ('{"cells": 3, "nbformat": 4, "nbformat_minor": 5, "metadata": {}}', "it has no list of cells"),
    "format 3": ('{"worksheets": [], "nbformat": 3, "nbformat_minor": 0, "metadata": {}}', "it has no list of cells"),
    "nested deep": ("[" * 100_000, "is damaged and cannot be read as a notebook"),
}


@pytest.mark.parametrize("how", DAMAGED)
def test_a_damaged_notebook_is_told_and_its_earlier_grade_and_everybody_elses_stay(fresh, how):
    grade(fresh, "ch04", workers=1)
    before = points(fresh)
    kept = (fresh.path / "autograded/ada/ch04/ch04.ipynb").read_text()
    submit(fresh, "ada", DAMAGED[how][0])
    results = {r.student: r for r in grade(fresh, "ch04", force=how == "truncated", workers=1)}
    assert DAMAGED[how][1] in results["ada"].problem
    assert "ask for it again. An earlier grade stays as it is" in results["ada"].problem
    assert points(fresh) == before
    assert (fresh.path / "autograded/ada/ch04/ch04.ipynb").read_text() == kept
    assert not [s for s, r in results.items() if r.problem and s != "ada"]


def test_a_notebook_that_is_not_text_or_huge_is_told(fresh):
    path = submit(fresh, "dan", "")
    path.write_bytes(b"\x89PNG\r\n\x1a\n\xff")
    assert "cannot be read" in grade(fresh, "ch04", ["dan"], workers=1)[0].problem
    with open(path, "wb") as f:
        f.truncate(10**9)
    assert grade(fresh, "ch04", ["dan"], workers=1)[0].problem.startswith("ch04.ipynb has 1000 MB, more than the 67 MB that are read")


def test_a_submission_named_differently_is_found_and_told(fresh):
    (fresh.path / "submitted/dan/ch04/ch04.ipynb").rename(fresh.path / "submitted/dan/ch04/Homework (1).ipynb")
    result = grade(fresh, "ch04", ["dan"], workers=1)[0]
    assert "expected the notebook ch04.ipynb" in result.problem
    assert "it holds Homework (1).ipynb; if that is the work, rename it" in result.problem


def test_a_folder_of_somebody_unknown_is_told_and_gets_no_entry(fresh):
    submit(fresh, "nobody", work(fresh, "dan"))
    code, out = command("grade", "ch04", "--course", fresh.path, "--workers", 1)
    assert code == 1
    said = " ".join(out.split())
    assert "Not graded: nobody is not on the roster; check the folder's name, or add the student with: nbgrader db student add nobody" in said
    assert "nobody" not in fresh.roster()
    assert {s: total(c) for s, c in points(fresh).items()} == {**RIGHT, "dan": 0}


@pytest.mark.slow
def test_nbgrader_reports_a_damaged_notebook_and_somebody_unknown_and_grades_the_rest(fresh):
    submit(fresh, "nobody", work(fresh, "dan"))
    submit(fresh, "ben", DAMAGED["truncated"][0])
    with fresh.gradebook() as book:
        book.remove_submission("ch04", "ada")
        book.remove_submission("ch04", "eve")
    code, out = nbgrader("autograde", "ch04", cwd=fresh.path)
    assert code != 0
    assert "error processing assignment 'ch04' for student 'ben'" in out
    assert "No student with ID 'nobody' exists" in out
    everybody = {s: total(c) for s, c in points(fresh).items()}
    assert (everybody["ada"], everybody["eve"]) == (11, 9)
    assert everybody["ben"] == 8  # as before
    assert "nobody" not in everybody


# -- the course


def test_a_course_without_its_secret_says_what_to_do(fresh):
    (fresh.path / ".course_secret").unlink()
    with pytest.raises(CourseError, match=r"is missing; without it no student's numbers can be derived. Restore it from a backup"):
        grade(Course(fresh.path), "ch04")
    (fresh.path / ".course_secret").write_text("not hexadecimal")
    with pytest.raises(CourseError, match=r"is damaged: expected one line of hexadecimal digits. Restore it"):
        grade(Course(fresh.path), "ch04")
    code, out = command("grade", "ch04", "--course", fresh.path)
    assert (code, "Traceback" in out) == (2, False)


def test_another_secret_is_noticed_before_everybody_is_wrong(fresh):
    before = points(fresh)
    (fresh.path / ".course_secret").write_text("ab" * 32)
    results = grade(Course(fresh.path), "ch04", workers=1)
    assert all("has other numbers for 4/1 than are derived now" in r.problem for r in results)
    assert points(fresh) == before


@pytest.mark.parametrize("route", ["grader", "nbgrader"])
def test_an_assignment_that_was_not_released_is_told(fresh, route):
    shutil.rmtree(fresh.path / "release")
    if route == "grader":
        code, out = command("grade", "ch04", "--course", fresh.path)
        assert code == 2
        assert "there is no released ch04" in out
        assert "generate it with: nbgrader generate_assignment ch04" in " ".join(out.split())
    else:
        for s in ("ben", "cleo", "dan", "eve", "mallory"):
            shutil.rmtree(fresh.path / "submitted" / s)
        code, out = nbgrader("autograde", "ch04", cwd=fresh.path)
        assert code != 0
        assert "there is no released ch04" in out


def test_an_assignment_that_the_gradebook_does_not_know_is_told(fresh):
    with fresh.gradebook() as book:
        book.remove_assignment("ch04")
    with pytest.raises(CourseError, match=r"the gradebook does not know ch04; generate it again"):
        grade(fresh, "ch04")


def test_an_assignment_of_another_name_is_told(fresh):
    with pytest.raises(CourseError, match=r"there is no released ch05.*build it with"):
        grade(fresh, "ch05")


def test_a_student_without_submission_is_told(fresh):
    with pytest.raises(CourseError, match=r"no submission of ch04 by zoe; there are ada, ben"):
        grade(fresh, "ch04", ["zoe"])


def test_an_empty_roster_is_told(ungraded):
    from grader.assignment.personal import make_personal_copies

    with ungraded.gradebook() as book:
        for s in ungraded.roster():
            book.remove_student(s)
    with pytest.raises(CourseError, match=r"nobody is on the roster; add students with"):
        make_personal_copies(ungraded, "ch04")
    with pytest.raises(CourseError, match=r"zoe: not on the roster; add the student first: nbgrader db student add zoe"):
        make_personal_copies(ungraded, "ch04", ["zoe"])


ROSTERS = {
    "no id": ("name,email\nada,a@b\n", r"expected a CSV file, separated by commas, whose first line names a column id.*got \['name', 'email'\]"),
    "semicolons": ("id;first_name\nada;Ada\n", r"separated by commas.*got \['id;first_name'\]"),
    "empty": ("", "got no rows"),
    "only a header": ("id,first_name\n", "got no rows"),
    "a blank id": ("id,first_name\nada,Ada\n,Ben\n", "line 3: no id"),
    "twice": ("id\nada\nada\n", "line 3: the id 'ada' is there twice"),
    "a slash": ("id\na/b\n", r"line 2: 'a/b' cannot be a student id: folders are named by it"),
    "a plus": ("id\na+b\n", r"nbgrader splits names at '\+'"),
    "dots": ("id\n..\n", "cannot be a student id"),
}


@pytest.mark.parametrize("how", ROSTERS)
def test_a_roster_that_cannot_be_used_is_told_and_no_course_is_made(tmp_path, how):
    path = tmp_path / "roster.csv"
    path.write_text(ROSTERS[how][0])
    with pytest.raises(CourseError, match=ROSTERS[how][1]):
        read_roster(path)
    code, out = command("build", "ch04", "--course", tmp_path / "c", "--students", path, "--problem", "4/1")
    assert (code, "Traceback" in out) == (2, False)
    assert not (tmp_path / "c").exists()


def test_a_roster_in_latin_1_is_told(tmp_path):
    (tmp_path / "r.csv").write_bytes("id,first_name\nzoe,Zoë\n".encode("latin-1"))
    with pytest.raises(CourseError, match="save it again as 'CSV UTF-8'"):
        read_roster(tmp_path / "r.csv")


@pytest.mark.parametrize("student", ["ada", "s1234567", "ada.lovelace@uni.edu", "müller", "Ada Lovelace", "o'brien", "a_b-c", "学生"])
def test_ids_that_folders_can_have_are_taken(student):
    assert check_id(student) == student


@pytest.mark.parametrize("student", ["", ".", "..", "a/b", "a\\b", "a+b", "*", "a?", "[a]", "a\nb", "a\0", " a", "a ", "-rf", ".hidden", "a{b}"])
def test_ids_that_would_lead_elsewhere_are_refused(student):
    with pytest.raises(CourseError, match="cannot be a student id"):
        check_id(student)


def test_a_course_folder_that_exists_is_left_as_it_is(tmp_path):
    (tmp_path / "notes.txt").write_text("mine")
    code, out = command("build", "ch04", "--course", tmp_path, "--problem", "4/1")
    assert code == 2
    assert "exists and is not empty; name a new folder, or add to the course in it with build --update" in out
    assert os.listdir(tmp_path) == ["notes.txt"]


def test_a_failure_while_figures_are_drawn_leaves_no_half_made_course(tmp_path, monkeypatch):
    from grader.assignment import build as building

    monkeypatch.setattr(building, "figure_png", lambda *a: 1 / 0)
    with pytest.raises(ZeroDivisionError):
        building.build_assignment(tmp_path / "c", "ch04", None, ("4/1",))
    assert not (tmp_path / "c").exists()


def test_a_bug_in_grading_one_submission_keeps_nobody_else_from_a_grade(fresh, monkeypatch):
    from grader.submission import pipeline

    original = pipeline.score_answers
    monkeypatch.setattr(pipeline, "score_answers", lambda own, *rest: 1 / 0 if own.student == "ben" else original(own, *rest))
    results = {r.student: r for r in grade(fresh, "ch04", force=True, workers=1)}
    assert "could not be graded, which is a bug of the grader: ZeroDivisionError" in results["ben"].problem
    assert not [s for s, r in results.items() if r.problem and s != "ben"]

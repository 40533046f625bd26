"""Whatever an instructor changes after the build, grading follows."""

import json

from exercises.catalogue import problem
from grader.assignment import make_personal_copies
from grader.assignment.numbers import numbers_path
from grader.grading import grade
from tests.grader.courses import change_source, points, read, submit
from tests.grader.submissions import work


def role(cell):
    own = cell["metadata"].get("newton_euler", {})
    return own.get("role"), own.get("problem")


def answer(cells, number):
    return next(c for c in cells if role(c) == ("answer", number))


def parts(result, number):
    return {p.key: (p.points, p.out_of) for p in result.scores[number].parts}


def graded(course, change=None, **cells):
    """dan's result once the instructor has changed the cells of the source notebook."""
    if change:
        change_source(course, change)
    submit(course, "dan", work(course, "dan", **cells))
    (result,) = grade(course, "ch04", ["dan"])
    return result


def test_points_in_the_notebook_are_the_truth_and_parts_share_them(ungraded):
    def nine(cells):
        answer(cells, "4/16")["metadata"]["nbgrader"]["points"] = 9

    result = graded(ungraded, nine)
    assert parts(result, "4/16") == dict.fromkeys(("alpha_CD", "v_D", "a_D"), (3.0, 3.0))
    assert (result.points, result.out_of) == (17, 17)
    assert points(ungraded)["dan"]["answer-4-16"][0] == 9


def test_an_instructor_sets_the_weights_of_parts_in_the_notebook(ungraded):
    def weigh(cells):
        answer(cells, "4/16")["metadata"]["newton_euler"]["weights"] = {"a_D": 4}

    result = graded(ungraded, weigh, p4_16="alpha_CD = v_D = [1, 2, 3]")
    assert [out_of for _, out_of in parts(result, "4/16").values()] == [0.5, 0.5, 2.0]


def test_a_weight_that_cannot_be_used_is_reported_and_grades_nobody(ungraded):
    def weigh(cells):
        answer(cells, "4/16")["metadata"]["newton_euler"]["weights"] = {"a_E": 4}

    result = graded(ungraded, weigh)
    assert "there is a weight for a_E in 4/16, which does not ask for it" in result.problem


def test_problems_in_another_order_and_own_cells_between_them_are_graded(ungraded):
    def turn_round(cells):
        by_problem = {}
        for c in cells[2:]:
            by_problem.setdefault(role(c)[1], []).append(c)
        hint = {"cell_type": "markdown", "id": "hint", "metadata": {}, "source": "A hint."}
        groups = reversed(by_problem.values())
        cells[2:] = [c for group in groups for c in (*group, dict(hint))][:-1]
        for n, c in enumerate(cells):
            c["id"] = f"hint-{n}" if c["id"] == "hint" else c["id"]

    result = graded(ungraded, turn_round)
    assert list(result.scores) == ["4/31", "4/16", "4/10", "4/2", "4/1"]
    assert (result.points, result.out_of) == (11, 11)


def test_an_instructors_words_in_a_statement_reach_every_student(ungraded):
    def reword(cells):
        cell = next(c for c in cells if role(c) == ("statement", "4/16"))
        cell["source"] = cell["source"].replace("Elbow arm", "The arm of our lab") + "\n\nNew: c."
        cell = next(c for c in cells if role(c) == ("givens", "4/16"))
        cell["source"] += "\nc = 4.5  # mm: a given of the instructor's own"

    change_source(ungraded, reword)
    own = {role(c): c["source"] for c in read(ungraded.personal_path("ch04", "dan"))["cells"]}
    values = ungraded.values("ch04", "dan", [problem("4/16")])["4/16"]
    assert "The arm of our lab" in own["statement", "4/16"]
    assert f"omega = {values['omega']:g} " in own["givens", "4/16"] + " "
    assert "c = 4.5" in own["givens", "4/16"]
    assert graded(ungraded, p4_1="speed = c").points == 9


def other_numbers(course, assignment, student, problems):
    return {p.id: dict.fromkeys(p.book_values, 1.25) for p in problems}


def test_numbers_in_hand_are_graded_though_a_range_was_narrowed(ungraded, monkeypatch):
    submit(ungraded, "dan", work(ungraded, "dan"))
    before = numbers_path(ungraded, "ch04", "dan").read_text()
    monkeypatch.setattr(type(ungraded), "values", other_numbers)
    (result,) = grade(ungraded, "ch04", ["dan"])
    assert result.points == 11
    make_personal_copies(ungraded, "ch04", ["dan"], workers=1)
    assert numbers_path(ungraded, "ch04", "dan").read_text() == before


def test_numbers_of_a_course_that_did_not_keep_them_are_read_from_the_copies(ungraded, monkeypatch):
    submit(ungraded, "dan", work(ungraded, "dan"))
    kept = json.loads(numbers_path(ungraded, "ch04", "dan").read_text())
    numbers_path(ungraded, "ch04", "dan").unlink()
    monkeypatch.setattr(type(ungraded), "values", other_numbers)
    assert grade(ungraded, "ch04", ["dan"])[0].points == 11
    assert json.loads(numbers_path(ungraded, "ch04", "dan").read_text()) == kept


def test_cells_that_a_student_added_run_in_their_place(fresh):
    own = work(fresh, "dan")
    cells = own["cells"]
    (at,) = [n for n, c in enumerate(cells) if role(c) == ("answer", "4/16")]
    text = cells[at]["source"]
    helper = {"cell_type": "code", "id": "mine", "metadata": {}, "outputs": [],
              "execution_count": None, "source": text.replace("a_D =", "helper =")}  # fmt: skip
    later = {**helper, "id": "later", "source": "a_D = helper"}
    cells[at]["source"] = "# my work is in the cells around\na_D = None"
    cells[at + 1 : at + 1] = [later]
    cells[at:at] = [helper]
    submit(fresh, "dan", own)
    (result,) = grade(fresh, "ch04", ["dan"])
    assert result.points == 11
    kept = [c["source"] for c in read(fresh.path / "autograded/dan/ch04/ch04.ipynb")["cells"]]
    assert kept.index(helper["source"]) < kept.index(later["source"])


def test_work_in_the_cells_of_numbers_and_imports_is_kept_but_changes_no_number(fresh):
    own = work(fresh, "dan", p4_1="import_of_mine; speed = SPEED")
    speed = next(c["source"] for c in work(fresh, "dan")["cells"] if role(c) == ("answer", "4/1"))
    for c in own["cells"]:
        if role(c) == ("setup", None):
            c["source"] += "\nimport_of_mine = 1"
        if role(c) == ("givens", "4/1"):
            c["source"] = (
                c["source"].replace("n = ", "n = 0*") + "\n" + speed.replace("speed", "SPEED")
            )
    submit(fresh, "dan", own)
    (result,) = grade(fresh, "ch04", ["dan"])
    assert result.points == 10  # all but the magnitude that 4/1 also asks for
    assert [s.note for s in result.scores.values() if s.note] == []


def test_a_problem_uses_its_own_givens_though_another_shares_the_names(fresh):
    """The cells of two problems were moved: 4/16's answer comes after the givens of 4/31."""
    own = work(fresh, "dan", p4_16="v_D = [omega, b_dot, 0]")
    cells = own["cells"]
    moved = [c for c in cells if role(c) == ("answer", "4/16")]
    cells[:] = [c for c in cells if c not in moved] + moved
    submit(fresh, "dan", own)
    (result,) = grade(fresh, "ch04", ["dan"])
    values = fresh.values("ch04", "dan", [problem("4/16")])["4/16"]
    record = json.loads(fresh.record_path("ch04", "dan").read_text())
    read_v = record["notebooks"]["ch04"]["executed"]["receipts"]["4/16"]["answers"]["v_D"]
    assert read_v == [values["omega"], values["b_dot"], 0]
    assert result.points == 8


def test_a_resubmission_with_equal_points_has_its_own_time_and_comment(fresh):
    grade(fresh, "ch04")
    submit(fresh, "ben", work(fresh, "ben", p4_1="speed = 12345.0", p4_2="1/0"))
    folder = fresh.path / "submitted/ben/ch04"
    (folder / "timestamp.txt").write_text("2026-11-21 10:00:00.000000 UTC")
    grade(fresh, "ch04")
    with fresh.gradebook() as book:
        assert str(book.find_submission("ch04", "ben").timestamp).startswith("2026-11-21 10:00")
    assert "ZeroDivisionError" in points(fresh)["ben"]["answer-4-2"][2]

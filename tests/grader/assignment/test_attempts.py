"""Another attempt, with fresh numbers, where the instructor allows it."""

import json

import pytest

from grader.assignment.attempts import new_attempt, put_back
from grader.course import CourseError
from grader.grading import grade
from tests.grader.courses import command, give, gradebook_rows, nbgrader, ran, read, submit
from tests.grader.submissions import work


def rows_of(course, student):
    return [r for r in gradebook_rows(course) if r[0] == student]


def kept_numbers(course, student):
    return json.loads((course.path / "numbers/ch04" / f"{student}.json").read_text())


def test_a_new_attempt_has_fresh_numbers_and_the_earlier_grade_stands_until_it_is_graded(fresh):
    grade(fresh, "ch04")
    before, numbers = rows_of(fresh, "ben"), kept_numbers(fresh, "ben")
    out = ran(command("retry", "ch04", "--course", fresh.path, "--student", "ben"))
    assert "Attempt 2 of ben" in out
    now = kept_numbers(fresh, "ben")
    assert [i for i in now if now[i] == numbers[i] and now[i]] == []
    sheet = fresh.personal_path("ch04", "ben").read_text()
    assert f"omega = {now['4/16']['omega'][0]:.6g} " in sheet
    grade(fresh, "ch04")
    assert rows_of(fresh, "ben") == before
    submit(fresh, "ben", answered(fresh, "ben"))
    assert next(r for r in grade(fresh, "ch04") if r.student == "ben").points == 11


def answered(course, student):
    """A notebook that is right for the numbers on record."""
    from exercises.catalogue import problem
    from grader.demo import sample_students as sample

    texts = {}
    for number, given in kept_numbers(course, student).items():
        p, values = problem(number), {n: x for n, (x, _) in given.items()}
        texts[number] = sample.cell_text(p, sample.right_answers(p, values))
    return sample.fill_in(read(course.personal_path("ch04", student)), texts)


def test_the_work_of_the_earlier_attempt_is_not_graded_with_the_new_numbers(fresh):
    grade(fresh, "ch04")
    before, path = rows_of(fresh, "ada"), fresh.path / "submitted/ada/ch04/ch04.ipynb"
    content = path.read_text()
    new_attempt(fresh, "ch04", "ada")
    submit(fresh, "ada", content)  # as nbgrader collect does once more
    result = next(r for r in grade(fresh, "ch04") if r.student == "ada")
    assert "is that of attempt 1, whose grade stays" in result.problem
    code, _ = nbgrader("autograde", "ch04", "--student=ada", cwd=fresh.path)
    assert code != 0
    assert rows_of(fresh, "ada") == before


def test_an_earlier_attempt_can_count_again(fresh):
    grade(fresh, "ch04")
    before, numbers = rows_of(fresh, "ada"), kept_numbers(fresh, "ada")
    new_attempt(fresh, "ch04", "ada")
    blank = read(fresh.personal_path("ch04", "ada"))
    submit(fresh, "ada", blank)
    (fresh.path / "submitted/ada/ch04/timestamp.txt").write_text("2026-11-21 10:00:00.0 UTC")
    assert next(r for r in grade(fresh, "ch04") if r.student == "ada").points == 0
    put_back(fresh, "ch04", "ada", 1)
    assert kept_numbers(fresh, "ada") == numbers
    grade(fresh, "ch04")
    assert rows_of(fresh, "ada") == before
    put_back(fresh, "ch04", "ada", 2)
    assert next(r for r in grade(fresh, "ch04") if r.student == "ada").points == 0


def test_a_student_who_has_not_handed_in_has_nothing_to_try_again(ungraded):
    with pytest.raises(CourseError, match="ada has not handed in ch04"):
        new_attempt(ungraded, "ch04", "ada")
    with pytest.raises(CourseError, match=r"zoe: not on the roster; .*enrol"):
        new_attempt(ungraded, "ch04", "zoe")
    with pytest.raises(CourseError, match=r"ada has no attempt 1 at ch04 .* there are none"):
        put_back(ungraded, "ch04", "ada", 1)
    assert work(ungraded, "ada")


def given(course, student):
    """What a person gave: (points, extra credit, comment) for the answer to 4/16."""
    with course.gradebook() as book:
        cell = "answer-4-16", "ch04", "ch04", student
        grade_, comment = book.find_grade(*cell), book.find_comment(*cell)
        return grade_.manual_score, grade_.extra_credit, comment.manual_comment


def test_another_attempt_inherits_nothing_that_a_person_gave_until_the_first_counts_again(fresh):
    grade(fresh, "ch04")
    give(fresh, "ben", "answer-4-16", 1.5, 0.25, "Neat.")
    new_attempt(fresh, "ch04", "ben")
    assert given(fresh, "ben") == (1.5, 0.25, "Neat.")  # the grade stands until the new sheet's
    submit(fresh, "ben", answered(fresh, "ben"))
    (result,) = grade(fresh, "ch04", ["ben"])
    assert (result.points, given(fresh, "ben")) == (11, (None, None, None))
    grade(fresh, "ch04", ["ben"], force=True)
    give(fresh, "ben", "answer-4-16", 2.5, 0.0, "Better.")
    put_back(fresh, "ch04", "ben", 1)
    grade(fresh, "ch04", ["ben"])
    assert given(fresh, "ben") == (1.5, 0.25, "Neat.")
    put_back(fresh, "ch04", "ben", 2)
    grade(fresh, "ch04", ["ben"])
    assert given(fresh, "ben") == (2.5, 0.0, "Better.")


def test_the_answer_for_an_earlier_sheet_is_recognised_as_such(fresh):
    right = work(fresh, "dan")
    submit(fresh, "dan", right)
    grade(fresh, "ch04", ["dan"])
    new_attempt(fresh, "ch04", "dan")
    cells = {c["id"]: c["source"] for c in right["cells"]}
    own = read(fresh.personal_path("ch04", "dan"))
    for c in own["cells"]:
        if c["id"] in ("answer-4-16", "answer-4-31"):
            c["source"] = cells[c["id"]]
    submit(fresh, "dan", own)
    (result,) = grade(fresh, "ch04", ["dan"])
    words = "not right: this is the answer for the numbers of an earlier sheet; yours are others"
    assert {p.message for p in result.scores["4/16"].parts} == {words}
    assert {c.name for p in result.scores["4/31"].parts for c in p.causes} == {"earlier"}

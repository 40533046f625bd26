"""An exam: its window, the one attempt that counts, its numbers, what is refused."""

import random
from datetime import UTC, datetime, timedelta

import pytest
from sympy import symbols

from exercises.catalogue import problem
from grader.assignment import numbers
from grader.assignment.numbers import keep_numbers, kept_numbers
from grader.course import Course, CourseError
from grader.course.creation import new_course
from grader.course.exam import ExamWindow, LateError, is_exam, refuse_before_opening, set_exam
from grader.practice.twins import sets_of_numbers
from newton_euler.classroom import expect, receipt
from tests.grader.courses import command, nbgrader, points, ran, read, refused, total
from tests.grader.submissions import work

NINE = datetime(2027, 1, 31, 9)
WINDOW = ExamWindow(NINE, NINE + timedelta(hours=2), extensions={"eve": timedelta(minutes=30)})
PASSED = "2026-01-31 09:00 UTC", "2026-01-31 11:00 UTC"  # a window that is over


def after(minutes):
    return NINE + timedelta(minutes=minutes)


@pytest.mark.parametrize(("student", "minutes", "words"), [
    ("ada", 0, ""), ("ada", 120, ""), ("eve", 150, ""),
    ("ada", -3, "handed in 3 min before the exam opened"),
    ("ada", 120.5, "handed in 30 s after the exam closed"),
    ("eve", 155, "handed in 5 min after the exam closed"),
])  # fmt: skip
def test_work_outside_of_the_window_is_noted_or_refused(student, minutes, words):
    marking = ExamWindow(WINDOW.opens, WINDOW.closes, "mark", WINDOW.extensions)
    assert marking.remark(student, after(minutes)) == words
    if "closed" not in words:
        assert WINDOW.remark(student, after(minutes)) == words
        return
    with pytest.raises(LateError, match=words):
        WINDOW.remark(student, after(minutes))


def test_the_first_work_within_the_window_counts_else_the_first_of_all():
    rng = random.Random("exams")
    for _ in range(200):
        times = [after(rng.uniform(-60, 200)) for _ in range(rng.randint(1, 5))]
        within = [t for t in times if after(0) <= t <= after(120)]
        assert WINDOW.first("ada", times) == min(within or times)


def test_a_receipt_of_an_exam_doubts_nothing():
    form, L = {"v": "number, m/s", "n": "expression, m/s"}, symbols("L")
    expect("0/51", {"L": "m"}, sane={"v": "magnitude"}, **form)
    assert "look again" in repr(receipt("0/51", v=-1.0, n=2 * L))
    expect("0/51", {"L": "m"}, sane=False, **form)
    assert "look again" not in repr(receipt("0/51", v=-1.0, n=2 * L))


class Given:
    """In place of the numbers drawn: first the practised ones, then others."""

    def __init__(self, practised):
        self.left, self.asked = [dict(x) for x in practised], 0

    def __call__(self, assignment, student, problems):
        self.asked += 1
        values = self.left.pop() if self.left else problems[0].book_values | {"b": 5.5}
        return {problems[0].id: values}


def test_its_numbers_are_on_no_other_sheet_and_need_a_secret_of_their_own(tmp_path, monkeypatch):
    p = problem("4/16")
    with new_course(tmp_path / "mechanics") as course:
        as_homework = course.values("midterm", "ada", [p])
        set_exam(course, "midterm", NINE.replace(tzinfo=UTC))
        drawn = course.values("midterm", "ada", [p])
        assert drawn != as_homework
        # a friend had these numbers in homework, and another friend the next ones drawn
        keep_numbers(course, "hw1", "ben", [p], drawn)
        second = kept_numbers(course, "midterm", "ada", [p])
        assert second != drawn
        keep_numbers(course, "hw2", "eve", [p], second)
        assert kept_numbers(course, "midterm", "ada", [p]) == second  # once handed out they stay
        (course.path / "numbers/midterm/ada.json").unlink()
        assert kept_numbers(course, "midterm", "ada", [p]) not in (drawn, second)
        monkeypatch.setattr(numbers, "_taken", lambda folders: {})
        practised = {tuple(sorted(x.items())) for x in sets_of_numbers(p, 10)}
        monkeypatch.setattr(type(course), "values", given := Given(practised))
        (course.path / "numbers/midterm/ada.json").unlink()
        (last,) = kept_numbers(course, "midterm", "ada", [p]).values()
        assert tuple(sorted(last.items())) not in practised
        assert given.asked == len(practised) + 1
        with pytest.raises(CourseError, match="was handed out as homework"):
            set_exam(course, "hw1", None)


def test_nothing_reaches_students_before_it_opens(tmp_path):
    with new_course(tmp_path / "mechanics") as course:
        set_exam(course, "midterm", NINE.replace(tzinfo=UTC))
        with pytest.raises(CourseError, match="opens at 2027-01-31T09:00:00 UTC"):
            refuse_before_opening(course, "midterm", after(-1))
        refuse_before_opening(course, "midterm", after(0))
        refuse_before_opening(course, "hw1", after(-1))


@pytest.fixture
def inbound(tmp_path):
    return tmp_path / "exchange/mechanics/inbound"


def handed_in(inbound, student, time, notebook):
    import json

    folder = inbound / f"{student}+midterm+{time}+random"
    folder.mkdir(parents=True)
    (folder / "timestamp.txt").write_text(time)
    (folder / "midterm.ipynb").write_text(json.dumps(notebook))


FILE = """\
title: Midterm
mode: exam
opens: {}
closes: {}
problems: [4/1, 7/5]
"""


@pytest.mark.integration
@pytest.mark.slow
def test_an_exam_from_the_file_to_the_feedback(tmp_path, inbound):
    """Built after homework of the same problems, released, handed in early, late and twice, graded
    by both routes, with feedback once it is over.
    """
    place, roster, file = tmp_path / "mechanics", tmp_path / "roster.csv", tmp_path / "midterm.yaml"
    roster.write_text("id\nada\nben\ncleo\ndan\n")
    file.write_text(FILE.format(*PASSED))
    (tmp_path / "exchange").mkdir(mode=0o777)
    ran(command("build", "hw1", "--problems", "4/1", "7/5", "--students", roster, "--course", place,
                "--exchange", tmp_path / "exchange"))  # fmt: skip
    course, problems = Course(place), [problem("4/1"), problem("7/5")]
    ran(nbgrader("generate_assignment", "hw1", cwd=place))
    ran(command("personal", "hw1", "--course", place))
    ran(command("build", file, "--course", place, "--update"))
    assert is_exam(course, "midterm")
    assert command("build", "hw1", "--course", place, "--update", "--exam", "--closes", PASSED[1],
                   "--problems", "4/1")[0] == 2  # fmt: skip
    assert course.values("midterm", "ada", problems) != course.values("hw1", "ada", problems)
    window = "--opens", PASSED[1], "--closes", PASSED[0], "--course", place, "--update"
    out = refused(command("build", "late", "--problems", "4/1", "--exam", *window))
    assert ("must open before" in out, course.source("late").exists()) == (True, False)
    out = refused(command("due", "midterm", PASSED[0], "--course", place))
    assert "after that date" in out
    ran(nbgrader("generate_assignment", "midterm", cwd=place))
    # before it opens, nothing of it reaches students
    ran(command("build", "midterm", "--problems", "4/1", "7/5", "--exam", "--opens",
                "2099-01-01 09:00 UTC", "--closes", "2099-01-01 11:00 UTC", "--course", place,
                "--update"))  # fmt: skip
    out = refused(nbgrader("release_assignment", "midterm", cwd=place), None)
    assert "opens at 2099-01-01T09:00:00 UTC" in out
    ran(command("build", file, "--course", place, "--update"))
    ran(nbgrader("release_assignment", "midterm", cwd=place))
    assert command("personal", "midterm", "--course", place, "--right-or-wrong")[0] == 2
    sheet = read(course.personal_path("midterm", "ada"))
    texts = "\n".join(c["source"] for c in sheet["cells"])
    assert "This is an exam" in texts
    assert "sane=False" in texts
    assert "sealed=" not in texts
    right = {s: work(course, s, assignment="midterm") for s in course.roster()}
    empty = read(course.personal_path("midterm", "ada"))
    handed_in(inbound, "ada", "2026-01-31 10:00:00.000000 UTC", right["ada"])
    handed_in(inbound, "ada", "2026-01-31 10:30:00.000000 UTC", empty)
    handed_in(inbound, "ben", "2026-01-31 08:58:00.000000 UTC", right["ben"])
    handed_in(inbound, "cleo", "2026-01-31 11:07:00.000000 UTC", right["cleo"])
    out = ran(nbgrader("collect", "midterm", cwd=place, TZ="America/New_York"))
    assert "ada handed in the exam 2 times; the one of 2026-01-31 10:00:00 UTC counts" in out
    ran(nbgrader("collect", "midterm", "--update", cwd=place))  # later work is not an update
    out = refused(command("grade", "midterm", "--course", place), 1)
    assert "cleo was handed in 7 min after the exam closed" in out
    assert "handed in 2 min before the exam opened" in out
    found = points(course, "midterm")
    assert (set(found), total(found["ada"]) > 0) == ({"ada", "ben"}, True)
    code, out = nbgrader("autograde", "midterm", "--student=cleo", cwd=place)
    assert (code != 0, "7 min after the exam closed" in out) == (True, True)
    # dan, who has not handed in, has an extension: no feedback for anybody
    later = f"{datetime.now(UTC) + timedelta(days=1):%Y-%m-%d %H:%M} UTC"
    ran(command("due", "midterm", later, "--student", "dan", "--course", place))
    for step in ("generate_feedback", "release_feedback"):
        code, out = nbgrader(step, "midterm", cwd=place)
        assert (code != 0, "is not over for everybody" in out) == (True, True)
    ran(command("due", "midterm", "none", "--student", "dan", "--course", place))
    ran(command("due", "midterm", "2026-01-31 11:10 UTC", "--student", "cleo", "--course", place))
    ran(command("grade", "midterm", "--course", place))
    assert total(points(course, "midterm")["cleo"]) == total(found["ada"])
    ran(nbgrader("generate_feedback", "midterm", cwd=place))
    assert "before the exam opened" in (place / "feedback/ben/midterm/midterm.html").read_text()
    out = refused(command("retry", "midterm", "--student", "ada", "--course", place))
    assert "there is one attempt" in out

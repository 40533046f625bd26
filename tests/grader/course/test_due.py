"""Due dates for everyone and for one student, and what late work loses."""

from datetime import UTC, datetime, timedelta

import pytest

from grader.course import Course, CourseError
from grader.course.creation import new_course
from grader.course.due import due_dates, is_over, set_due, set_own_due
from grader.course.exam import set_exam
from grader.grading import grade
from grader.nbgrader_hooks.late import LatePolicy
from tests.grader.courses import append_config, command, nbgrader, ran, refused

BEN = 6  # the points of his work, handed in on time


def late_by(course, student, when):
    folder = course.path / "submitted" / student / "ch04"
    (folder / "timestamp.txt").write_text(f"{when} UTC")


def graded(course, *students):
    return {r.student: (r.points, r.penalty) for r in grade(course, "ch04", students)}


@pytest.fixture
def two_days_late(fresh):
    """ada and ben handed in 30 hours after the due date."""
    ran(command("due", "ch04", "2026-11-19 12:00 UTC", "--course", fresh.path))
    for student in ("ada", "ben"):
        late_by(fresh, student, "2026-11-20 18:00:00.0")
    return fresh


def test_late_work_loses_what_the_policy_says_by_both_routes_until_it_is_off(two_days_late):
    course = two_days_late
    assert graded(course, "ada") == {"ada": (11, 0)}
    for share, lost in (("10%", 2.2), ("zero", 11.0), ("60 %", 11.0)):
        ran(command("late", share, "--course", course.path))
        found = graded(course, "ada")["ada"]
        assert found == (pytest.approx(11 - lost), pytest.approx(lost))
    ran(command("late", "10%", "--course", course.path))
    ran(nbgrader("autograde", "ch04", "--student=ada", cwd=course.path))
    with course.gradebook() as book:
        found = book.find_submission("ch04", "ada").late_submission_penalty
        assert found == pytest.approx(2.2)
    ran(command("late", "none", "--course", course.path))
    assert graded(course, "ada") == {"ada": (11, 0)}


@pytest.mark.parametrize(("seconds", "lost"), [
    (1, 1.0), (86_400, 1.0), (86_401, 2.0), (864_000, 10.0), (950_400, 10.0),
])  # fmt: skip
def test_each_day_begun_costs_its_share_and_all_days_no_more_than_all(seconds, lost):
    policy = LatePolicy(share_per_day=0.1)
    assert policy.late_submission_penalty("ada", 10.0, seconds) == pytest.approx(lost)


def test_a_policy_of_the_instructors_own_comes_first(two_days_late):
    ran(command("late", "none", "--course", two_days_late.path))
    assert graded(two_days_late, "ada") == {"ada": (11, 0)}
    append_config(
        two_days_late,
        "c.AssignLatePenalties.plugin_class = 'nbgrader.plugins.LateSubmissionPlugin'\n"
        "c.LateSubmissionPlugin.penalty_method = 'zero'",
    )
    assert graded(two_days_late, "ada") == {"ada": (0, 11)}


def test_one_student_has_a_date_of_their_own_before_and_after_handing_in(two_days_late):
    course = two_days_late
    ran(command("late", "zero", "--course", course.path))
    own = "due", "ch04", "2026-11-21 12:00 UTC", "--course", course.path, "--student"
    ran(command(*own, "ada"))
    assert graded(course, "ada", "ben") == {"ada": (11, 0), "ben": (0, BEN)}
    ran(command(*own, "ben"))
    ran(command("due", "ch04", "2026-11-18 12:00 UTC", "--course", course.path))
    assert graded(course, "ada", "ben") == {"ada": (11, 0), "ben": (BEN, 0)}
    ran(command("due", "ch04", "none", "--course", course.path, "--student", "ada"))
    assert graded(course, "ada", "ben") == {"ada": (0, 11), "ben": (BEN, 0)}
    ran(command("due", "ch04", "none", "--course", course.path))
    assert graded(course, "ada", "ben") == {"ada": (11, 0), "ben": (BEN, 0)}


def test_an_extension_that_the_formgrader_gave_stays(two_days_late):
    course = two_days_late
    ran(command("late", "zero", "--course", course.path))
    grade(course, "ch04", ["ada"])
    with course.gradebook() as book:
        book.grant_extension("ch04", "ada", days=3)
    assert graded(course, "ada") == {"ada": (11, 0)}


@pytest.fixture
def empty(tmp_path):
    """A course with two students and an assignment without problems."""
    with new_course(tmp_path / "empty") as course:
        (course.path / "source/ch04").mkdir(parents=True)
        with course.gradebook() as book:
            for student in ("ada", "ben"):
                book.add_student(student)
        yield course


def test_an_assignment_is_over_when_the_last_extension_of_either_kind_has_passed(empty):
    def over(hours):
        set_own_due(empty, "ch04", ["ada"], datetime.now(UTC) + timedelta(hours=hours))
        return is_over(empty, "ch04")

    set_due(empty, "ch04", datetime.now(UTC) + timedelta(hours=1))
    assert not over(-1)  # nor for the others
    set_due(empty, "ch04", datetime.now(UTC) - timedelta(hours=1))
    assert [over(hours) for hours in (1, -0.5, -2)] == [False, True, True]
    with empty.gradebook() as book:
        book.add_submission("ch04", "ben")
        book.grant_extension("ch04", "ben", hours=2)
    assert not is_over(empty, "ch04")


def test_an_exam_closes_after_it_has_opened(empty):
    opens = datetime(2027, 1, 31, 9, tzinfo=UTC)
    set_exam(empty, "ch04", opens)
    with pytest.raises(CourseError, match="opens at 2027-01-31T09:00:00 UTC, after that date"):
        set_due(empty, "ch04", opens)
    set_due(empty, "ch04", opens + timedelta(seconds=1))


@pytest.mark.parametrize(("arguments", "words"), [
    (("late", "lots"), "expected none, zero or a share, as in 10%"),
    (("late", "--", "-5%"), "expected none, zero or a share"),
    (("late", "120%"), "expected none, zero or a share"),
    (("due", "ch04", "2027-01-31 23:59 UTC", "--student", "zoe"), "zoe: not on the roster"),
    (("due", "ch04", "2027-01-31 23:59 UTC", "--student", "ada"), "no due date for everybody"),
])  # fmt: skip
def test_what_cannot_be_set_is_reported_and_changes_nothing(fresh, arguments, words):
    name, *others = arguments
    assert words in refused(command(name, "--course", fresh.path, *others))
    assert Course(fresh.path).settings.keys() == {"id", "secret_sha256"}
    assert not (fresh.path / "extensions.json").exists()


def test_the_next_year_has_last_years_dates_some_days_later_or_none(fresh, tmp_path):
    ran(command("due", "ch04", "2026-11-19 12:00 UTC", "--course", fresh.path))
    out = ran(command("next-year", fresh.path, "--course", tmp_path / "m27", "--later", 364))
    assert "ch04 is due 2027-11-18 12:00 UTC" in out
    assert due_dates(Course(tmp_path / "m27")) == {"ch04": datetime(2027, 11, 18, 12)}
    out = ran(command("next-year", fresh.path, "--course", tmp_path / "m28"))
    assert "Without a due date: ch04" in out
    assert due_dates(Course(tmp_path / "m28")) == {}

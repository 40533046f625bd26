"""A course folder: its id, its secret, its gradebook."""

import shutil
import sqlite3

import pytest

from grader.course import Course, CourseError
from grader.grading import grade
from tests.grader.courses import REPOSITORY, append_config, command, points, refused

DAMAGED = "is damaged: expected one line of 64 hexadecimal digits"
BAD_SECRETS = {
    "not hexadecimal": ("not hexadecimal", DAMAGED),
    "empty": ("", DAMAGED),
    "short": ("ab" * 31, DAMAGED),
    "another": ("ab" * 32, "is not the secret that the course was made with"),
}


def test_a_course_without_its_secret_says_what_to_do(fresh):
    (fresh.path / ".course_secret").unlink()
    words = "is missing; without it no student's numbers can be derived. Restore it from a backup"
    with pytest.raises(CourseError, match=words):
        grade(Course(fresh.path), "ch04")


@pytest.mark.parametrize("how", BAD_SECRETS)
def test_an_empty_short_or_changed_secret_is_refused_before_anybody_is_graded(fresh, how):
    text, words = BAD_SECRETS[how]
    before = points(fresh)
    (fresh.path / ".course_secret").write_text(text)
    with pytest.raises(CourseError, match=words):
        grade(Course(fresh.path), "ch04")
    refused(command("grade", "ch04", "--course", fresh.path))
    assert points(fresh) == before


def test_the_id_of_a_course_stays_when_its_folder_is_renamed(fresh, tmp_path):
    assert fresh.name == "mechanics"
    moved = shutil.move(fresh.path, tmp_path / "Mécanique 2026 (old)")
    assert Course(moved).name == "mechanics"
    assert sum(r.points for r in grade(Course(moved), "ch04")) > 0


def test_the_configuration_of_a_course_names_no_place(course):
    for name in ("nbgrader_config.py", "nbgrader_config.json", "course.json"):
        text = (course.path / name).read_text()
        assert str(course.path) not in text
        assert "/course/" not in text
    assert str(REPOSITORY) not in (course.path / "nbgrader_config.py").read_text()


def test_ids_that_differ_by_case_only_are_refused_and_noticed(fresh):
    with pytest.raises(CourseError, match="'Ada' differs from 'ada', who is on the roster, only"):
        fresh.enrol(["Ada"])
    with pytest.raises(CourseError, match="differs from"):
        fresh.enrol(["zoe\u0301", "zo\u00e9"])  # an accent apart and within
    assert fresh.enrol(["ada", "new"]) == 1
    with fresh.gradebook() as book:
        book.add_student("ADA")
    with pytest.raises(CourseError, match=r"'ADA' and 'ada' on the roster differ .* remove ada"):
        fresh.roster()


def test_a_locked_gradebook_is_reported_in_a_sentence_and_nothing_is_lost(fresh):
    before = points(fresh)
    lock = sqlite3.connect(fresh.path / "gradebook.db")
    lock.execute("BEGIN EXCLUSIVE")
    try:
        out = refused(command("grade", "ch04", "--course", fresh.path))
    finally:
        lock.close()
    assert "another program is writing to it; wait until it has ended" in out
    assert points(fresh) == before


@pytest.mark.parametrize(("code", "words"), [
    ("SQLITE_READONLY_DIRECTORY", "cannot be written; give yourself write permission"),
    ("SQLITE_FULL", "the disk is full; make room"),
    ("SQLITE_CANTOPEN", "cannot be opened"),
    ("SQLITE_ERROR", "nbgrader db upgrade"),
])  # fmt: skip
def test_an_error_of_the_database_comes_with_what_to_do(fresh, code, words):
    from sqlalchemy.exc import OperationalError

    error = sqlite3.OperationalError("in words that may change")
    error.sqlite_errorname = code
    with pytest.raises(CourseError, match=words), fresh.gradebook():
        raise OperationalError("INSERT", {}, error)


def test_a_damaged_identity_or_gradebook_is_reported(fresh):
    (fresh.path / "gradebook.db").write_bytes(b"not a database at all" * 100)
    with pytest.raises(CourseError, match=r"could not be used .*it is damaged; restore it from"):
        fresh.roster()
    (fresh.path / "course.json").write_text("{")
    with pytest.raises(CourseError, match=r"course.json is damaged .* restore it from a backup"):
        _ = Course(fresh.path).name


def test_an_error_in_the_instructors_configuration_names_the_line(fresh):
    append_config(fresh, "c.Exchange.root = (")
    with pytest.raises(CourseError, match=r"nbgrader_config.py, line \d+ does not run"):
        fresh.config()

"""A course folder is made whole or not at all, and belongs to its owner alone."""

import os
import signal
import stat
import sys

import pytest

from grader.course import Course, CourseError
from grader.course.creation import MADE, UNFINISHED, new_course
from tests.grader.courses import command, ran, refused, run


def test_build_says_how_many_it_enrolled_and_how_the_roster_was_read(tmp_path):
    roster = tmp_path / "roster.csv"
    roster.write_text("Vorname;Nachname;Matrikelnummer\nAda;L.;1001\nBen;M.;1002\n")
    place = tmp_path / "Méca 2026"
    out = ran(command(
        "build", "ch04", "--course", place, "--students", roster, "--problem", "4/1",
        "--due", "2027-01-31 23:59 Europe/Berlin", "--exchange", tmp_path / "exchange",
    ))  # fmt: skip
    output = " ".join(out.split())
    assert "Enrolled 2 students (ids from the column 'Matrikelnummer', UTF-8, sep" in output
    assert "The roster of the course Meca-2026 has 2 students." in output
    assert "Due 2027-01-31 22:59 UTC" in output
    assert "'Next" not in output
    assert stat.S_IMODE((tmp_path / "exchange").stat().st_mode) == 0o777
    course = Course(place)
    assert course.config().Exchange.root == str(tmp_path / "exchange")
    with course.gradebook() as book:
        assert str(book.find_assignment("ch04").duedate) == "2027-01-31 22:59:00"
    roster.write_text("id\n1002\n1003\n")
    _, out = command(
        "build", "ch04", "--course", place, "--students", roster, "--problem", "4/1", "--update"
    )
    assert "Enrolled 1 student (" in out
    assert " has 3 students." in out


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("soon", "expected a date, a time and the name of a zone"),
        ("2027-13-01 10:00", "expected a date, a time and the name of a zone"),
        ("2027-01-31 23:59 Europe/Berln", "'Europe/Berln'; did you mean Europe/Berlin?"),
        ("2027-01-31 23:59 CEST", "there is no time zone 'CEST'; write it as Europe/Berlin"),
    ],
)
def test_a_due_date_that_cannot_be_read_is_refused(tmp_path, text, words):
    assert words in refused(command("build", "ch04", "--course", tmp_path / "c", "--due", text))
    assert not (tmp_path / "c").exists()


def test_the_course_folder_and_personal_copies_are_readable_by_their_owner_alone(tmp_path, course):
    before = os.umask(0)
    try:
        with new_course(tmp_path / "c") as course:
            pass
    finally:
        os.umask(before)
    assert stat.S_IMODE(course.path.stat().st_mode) == 0o700
    assert stat.S_IMODE((course.path / ".course_secret").stat().st_mode) == 0o600
    for path in (course.path / "personal").rglob("*.ipynb"):
        assert stat.S_IMODE(path.stat().st_mode) == 0o600


def test_git_sees_no_secret_and_nothing_about_students(course, tmp_path):
    git = ("git", "-C", str(course.path))
    ran(run(*git, "init", "-q"))
    try:
        out = ran(run(*git, "status", "--porcelain", "--untracked-files=all"))
    finally:
        run("rm", "-rf", str(course.path / ".git"))
    seen = {line[3:].strip('"').split("/")[0] for line in out.splitlines()}
    assert seen == {
        ".gitignore", ".newton_euler_demo", "built", "course.json", "nbgrader_config.json",
        "nbgrader_config.py", "release", "source", "student",
    }  # fmt: skip


def test_a_failure_leaves_nothing_of_a_course(tmp_path):
    (tmp_path / "empty").mkdir()
    for place in (tmp_path / "new", tmp_path / "empty"):
        with pytest.raises(ZeroDivisionError), new_course(place):
            _ = 1 / 0
    assert not (tmp_path / "new").exists()
    assert os.listdir(tmp_path / "empty") == []


BUILD = """
import os, signal, sys
from grader.course import Course, folder
from grader.assignment import build
whole = build.write_json
def dies(*a, **k):
    if sys.argv[2] == "source": os.kill(os.getpid(), signal.SIGKILL)
    whole(*a, **k)
build.write_json = dies
Course.enrol = lambda *a: os.kill(os.getpid(), signal.SIGKILL)
build.build_assignment(sys.argv[1], "ch04", sys.argv[3], ("4/1",))
"""


@pytest.mark.parametrize("when", ["source", pytest.param("enrol", marks=pytest.mark.slow)])
def test_the_build_after_a_killed_one_starts_afresh(tmp_path, when):
    roster = tmp_path / "roster.csv"
    roster.write_text("id\nada\n")
    place = tmp_path / "c"
    code, _ = run(sys.executable, "-c", BUILD, str(place), when, str(roster))
    assert code == -signal.SIGKILL
    assert (place / UNFINISHED).exists()
    out = refused(command("build", "ch04", "--course", place, "--update"))
    assert "run the same build again, without --update: it begins afresh" in out
    ran(command("build", "ch04", "--course", place, "--students", roster, "--problem", "4/1"))
    assert Course(place).roster() == ["ada"]
    assert not (place / UNFINISHED).exists()
    assert {p.name for p in place.iterdir()} <= MADE


def test_someone_elses_files_in_an_unfinished_course_are_not_removed(tmp_path):
    (tmp_path / UNFINISHED).touch()
    (tmp_path / "thesis.tex").write_text("mine")
    with pytest.raises(CourseError, match="exists and is not empty"), new_course(tmp_path):
        pass
    assert (tmp_path / "thesis.tex").exists()


def test_a_course_in_an_unknown_language_is_refused(tmp_path):
    with new_course(tmp_path / "kurs") as course:
        course.set(language="xx")
    with pytest.raises(CourseError, match=r"course.json: there is no language 'xx' here"):
        Course(tmp_path / "kurs")

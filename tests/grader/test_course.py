"""A course folder: its secret, its roster, ids of students."""

import os

import pytest

from grader.course import Course, CourseError, check_id, read_roster
from grader.grading import grade
from tests.grader.courses import command, points


def test_a_course_without_its_secret_says_what_to_do(fresh):
    (fresh.path / ".course_secret").unlink()
    with pytest.raises(
        CourseError,
        match=r"is missing; without it no student's numbers can be derived. Restore it from a "
        r"backup",
    ):
        grade(Course(fresh.path), "ch04")
    (fresh.path / ".course_secret").write_text("not hexadecimal")
    with pytest.raises(
        CourseError, match=r"is damaged: expected one line of hexadecimal digits. Restore it"
    ):
        grade(Course(fresh.path), "ch04")
    code, out = command("grade", "ch04", "--course", fresh.path)
    assert (code, "Traceback" in out) == (2, False)


def test_another_secret_is_noticed_before_everybody_is_wrong(fresh):
    before = points(fresh)
    (fresh.path / ".course_secret").write_text("ab" * 32)
    results = grade(Course(fresh.path), "ch04", workers=1)
    assert all("has other numbers for 4/1 than are derived now" in r.problem for r in results)
    assert points(fresh) == before


ROSTERS = {
    "no id": (
        "name,email\nada,a@b\n",
        r"expected a CSV file, separated by commas, whose first line names a column id.*got "
        r"\['name', 'email'\]",
    ),
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
    code, out = command(
        "build", "ch04", "--course", tmp_path / "c", "--students", path, "--problem", "4/1"
    )
    assert (code, "Traceback" in out) == (2, False)
    assert not (tmp_path / "c").exists()


def test_a_roster_in_latin_1_is_told(tmp_path):
    (tmp_path / "r.csv").write_bytes("id,first_name\nzoe,Zoë\n".encode("latin-1"))
    with pytest.raises(CourseError, match="save it again as 'CSV UTF-8'"):
        read_roster(tmp_path / "r.csv")


@pytest.mark.parametrize(
    "student",
    [
        "ada",
        "s1234567",
        "ada.lovelace@uni.edu",
        "müller",
        "Ada Lovelace",
        "o'brien",
        "a_b-c",
        "学生",
    ],
)
def test_ids_that_folders_can_have_are_taken(student):
    assert check_id(student) == student


@pytest.mark.parametrize(
    "student",
    [
        "",
        ".",
        "..",
        "a/b",
        "a\\b",
        "a+b",
        "*",
        "a?",
        "[a]",
        "a\nb",
        "a\0",
        " a",
        "a ",
        "-rf",
        ".hidden",
        "a{b}",
    ],
)
def test_ids_that_would_lead_elsewhere_are_refused(student):
    with pytest.raises(CourseError, match="cannot be a student id"):
        check_id(student)


def test_a_course_folder_that_exists_is_left_as_it_is(tmp_path):
    (tmp_path / "notes.txt").write_text("mine")
    code, out = command("build", "ch04", "--course", tmp_path, "--problem", "4/1")
    assert code == 2
    assert (
        "exists and is not empty; name a new folder, or add to the course in it with build --update"
    ) in out
    assert os.listdir(tmp_path) == ["notes.txt"]

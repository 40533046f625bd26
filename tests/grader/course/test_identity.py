"""Ids of students and of courses."""

import pytest

from grader.course import CourseError, check_id
from grader.course.identity import course_id, same_student


@pytest.mark.parametrize(("name", "expected"), [
    ("mechanics", "mechanics"),
    ("Méca 2026", "Meca-2026"),
    ("  a+b (Tue/Thu)  ", "a-b-Tue-Thu"),
    ("力学", "course"),
    ("..", "course"),
])  # fmt: skip
def test_a_course_has_an_id_that_every_machine_can_write(name, expected):
    assert course_id(name) == expected


@pytest.mark.parametrize("student", [
    "ada", "s1234567", "ada.lovelace@uni.edu", "müller", "Ada Lovelace", "o'brien", "a_b-c", "学生",
])  # fmt: skip
def test_ids_that_folders_can_have_are_taken(student):
    assert check_id(student) == student


@pytest.mark.parametrize("student", [
    "", ".", "..", "a/b", "a\\b", "a+b", "*", "a?", "[a]", "a\nb", "a\0", " a", "a ", "-rf",
    ".hidden", "a{b}", "x" * 101, "a\u202eb", "ada\u200b", "a\x9b2J", "\xad", "a\x7f", "\ud800",
])  # fmt: skip
def test_ids_that_would_lead_elsewhere_are_refused(student):
    with pytest.raises(CourseError, match="cannot be a student id"):
        check_id(student)


@pytest.mark.parametrize(("one", "other"), [
    ("Ada", "ada"), ("m\u00fcller", "mu\u0308ller"), ("stra\u00dfe", "STRASSE"),
    ("\u0390", "\u03aa\u0301"), ("\u01f0", "J\u030c"), ("\uff41da", "ada"),
])  # fmt: skip
def test_ids_that_some_machine_would_put_into_one_folder_are_of_one_student(one, other):
    assert same_student(one) == same_student(other)

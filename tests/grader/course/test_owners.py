"""Whose a file is by its name, as platforms name work; also work of people on no roster."""

import tomllib
from pathlib import Path

import pytest
from nbgrader.api import Student

from grader.course.owners import Person, owners

ROSTER = [
    {"id": "ada", "first_name": "Ada", "last_name": "Lovelace", "lms_user_id": "4711"},
    {"id": "ben", "first_name": "Ben", "last_name": "Müller-Lüdenscheidt"},
    {"id": "cleo", "first_name": "Cléo", "last_name": "de Mérode"},
    {"id": "dan", "email": "daniel.g@uni.edu"},
    {"id": "eve"},
    {"id": "s1234567", "first_name": "Ann", "last_name": "Lee"},
]
COMMON = (
    "late", "attempt", "homework", "notebook", "copy", "file", "assignment", "submission", "work",
    "final", "ch04", "hw", "1", "2026", "submissions", "assignsubmission",
)  # fmt: skip
MOODLE = "_77_assignsubmission_file_/"


def owned(names, *more):
    people = {s["id"]: Person.read(Student(**s)) for s in (*ROSTER, *({"id": i} for i in more))}
    return [found[0] if len(found) == 1 else "" for found in owners(names, "ch04", people).values()]


FILES = tomllib.loads(
    Path(__file__).with_name("owners.toml").read_text(encoding="utf-8").replace("$MOODLE", MOODLE)
)
HONEST = FILES["honest"]


@pytest.mark.parametrize("ids", [(), COMMON], ids=["", "ids are common words"])
@pytest.mark.parametrize(("name", "student"), HONEST.items(), ids=HONEST)
def test_work_finds_its_owner_as_platforms_and_people_name_it(name, student, ids):
    assert owned([name], *ids) == [student]


STRANGERS = FILES["strangers"]["files"]


@pytest.mark.parametrize("others", [
    [], ["eve.ipynb"], ["eve/a.ipynb", "ben/a.ipynb"], ["ben_1_ch04.ipynb", "eve_2_ch04.ipynb"],
    [f"Ben Müller-Lüdenscheidt{MOODLE}ch04.ipynb", "eve/ada.ipynb"],
], ids=str)  # fmt: skip
@pytest.mark.parametrize("stranger", STRANGERS)
def test_the_work_of_a_stranger_is_given_to_nobody(stranger, others):
    """Even where they share a name or number with a student, or name files after one."""
    found = dict(zip([stranger, *others], owned([stranger, *others]), strict=True))
    assert found == {stranger: ""} | {name: name[:3].lower() for name in others}


@pytest.mark.parametrize("name", [
    f"May Final{MOODLE}ch04.ipynb", "finalmay_5_98_ch04.ipynb", "Final, May(late)/ch04.ipynb",
    "12-34 - May Final - Oct 3, 2026 1122 PM/ch04.ipynb", "late/ch04.ipynb",
    "ch04_late_attempt_2026-05-01-10-11-12_work.ipynb",
])  # fmt: skip
def test_a_student_whose_name_is_a_common_word_is_found_where_a_platform_names_who_it_is(name):
    student = Person.read(Student(id="late", first_name="May", last_name="Final"))
    assert owners([name], "ch04", {"late": student}) == {name: ["late"]}


@pytest.mark.parametrize("name", ["ch04.ipynb", "week 3/ch04.ipynb", "submissions/ch04/work.ipynb"])
def test_a_file_named_after_the_assignment_is_not_given_to_a_student_with_that_id(name):
    assert owned([name], "ch04") == [""]
    assert owned([name.replace("ch04", "eve")], "ch04") == ["eve"]


def test_numbers_behind_ids_common_words_and_names_around_all_are_told_apart():
    assert owned(["ada-2.ipynb", "ada (2).ipynb", "eve 2.ipynb"], "ada2") == ["", "ada", "eve"]
    assert owned(["s 7654321.ipynb", "s_7654321/ch04.ipynb"], "s7654321") == ["s7654321"] * 2
    student = Person.read(Student(id="nb1", first_name="Note", last_name="Book"))
    assert owners(["my notebook.ipynb"], "ch04", {"nb1": student}) == {"my notebook.ipynb": []}
    assert owned(["Mechanics II/eve.ipynb", "Mechanics II/ben.ipynb"]) == ["eve", "ben"]
    assert owned(["Mechanics eve.ipynb", "Mechanics ben.ipynb"]) == ["eve", "ben"]
    notebooks = [f"{s}_notebook.ipynb" for s in ("ada", "eve", "ben")]
    assert owned(notebooks, *COMMON) == ["ada", "eve", "ben"]
    assert owned([f"submissions/{s}/work.ipynb" for s in ("eve", "ada")], *COMMON) == ["eve", "ada"]
    assert owned([f"Zoe Quinn{MOODLE}{s}.ipynb" for s in ("eve", "ben")]) == ["", ""]
    assert owned(["Ada Smith a.ipynb", "Ada Smith b.ipynb"]) == ["", ""]

"""Whose a file is by its name, as platforms name work; also work of people on no roster."""

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


HONEST = {
    "submissions/lovelaceada_4711_98765_ch04.ipynb": "ada",
    "lovelaceada_4711_98765_ch04-1.ipynb": "ada",
    f"Ben Müller-Lüdenscheidt{MOODLE}notebook.ipynb": "ben",
    f"Cléo de Mérode{MOODLE}work.ipynb": "cleo",
    "de Mérode, Cléo/ch04.ipynb": "cleo",
    "dan.ipynb": "dan",
    "ch04-ada.ipynb": "ada",
    "ada_notebook.ipynb": "ada",
    "submissions/eve/ch04.ipynb": "eve",
    "lovelaceada_LATE_4711_98765_ch04-1.ipynb": "ada",
    "müllerlüdenscheidtben_5_98765_ch04.ipynb": "ben",
    "Ann Lee_123_assignsubmission_file_ch04.ipynb": "s1234567",
    "Ann Lee s1234567_123_assignsubmission_file_/ch04.ipynb": "s1234567",
    "Lee, Ann(s1234567)/Submission attachment(s)/ch04.ipynb": "s1234567",
    "Homework 4_eve_attempt_2026-05-01-10-11-12_work.ipynb": "eve",
    "12345-67890 - Ann Lee - Oct 3, 2026 1122 PM/ch04.ipynb": "s1234567",
    "Ann Lee - ch04.ipynb": "s1234567",
    "eve_ch04_final.ipynb": "eve",
    "eve (1).ipynb": "eve",
    "4711_ch04.ipynb": "ada",
    "Homework 3/4711/ch04.ipynb": "ada",
    "2026-05-01 eve.ipynb": "eve",
    "daniel.g@uni.edu/ch04.ipynb": "dan",
    "submitted/eve/ch04/ch04.ipynb": "eve",
    "eve/homework/work.ipynb": "eve",
    "ada\\ch04.ipynb": "ada",
}


@pytest.mark.parametrize("ids", [(), COMMON], ids=["", "ids are common words"])
@pytest.mark.parametrize(("name", "student"), HONEST.items(), ids=HONEST)
def test_work_finds_its_owner_as_platforms_and_people_name_it(name, student, ids):
    assert owned([name], *ids) == [student]


STRANGERS = [
    f"Ada Smith{MOODLE}ch04.ipynb", f"Tom Ben{MOODLE}ch04.ipynb", f"Lee Ann Smith{MOODLE}a.ipynb",
    f"Eve-Marie Curie{MOODLE}ch04.ipynb", "Zoe Quinn_4711_assignsubmission_file_/ch04.ipynb",
    f"Zoe Quinn{MOODLE}Ada Lovelace_1_assignsubmission_file_ch04.ipynb", "Lee Ann Smith/ch04.ipynb",
    "quinnzoe_99_4711_ch04.ipynb", "quinnzoe_LATE_99_12_ada.ipynb", "lovelaceada_9999_12_ch04.ipynb",
    "ada_9999_12_ch04.ipynb", "annleee_1_2_ch04.ipynb", "zoe/ada/ch04.ipynb", "zoe\\ada.ipynb",
    "submitted/zoe/ch04/ada.ipynb", "daniel.g@other.edu/ch04.ipynb", "group 3 ada ben/ch04.ipynb",
    "ch04_zoe_attempt_2026-05-01-10-11-12_ada.ipynb", "adam/ch04.ipynb",
    "12-34 - Zoe Quinn - Oct 3, 2026 1122 PM/ada.ipynb", f"Zoe Quinn{MOODLE}ada.ipynb",
    f"Zoe Quinn{MOODLE}ada/ch04.ipynb", "quinnzoe_99_100_ch04_ada.ipynb", "quinnzoe_99_100_4711.ipynb",
    "zoe/ada.ipynb", "x_2_ch04_ben.ipynb",
    f"Eve Final{MOODLE}ch04.ipynb", "Late, Eve(zoe)/Submission attachment(s)/ch04.ipynb",
    "ch04_zoe_attempt_2026-05-01-10-11-12_lovelaceada_4711_2_ch04.ipynb",
]  # fmt: skip


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


def test_a_number_after_an_id_may_belong_to_the_id():
    assert owned(["ada-2.ipynb", "ada (2).ipynb", "eve 2.ipynb"], "ada2") == ["", "ada", "eve"]
    assert owned(["s 7654321.ipynb", "s_7654321/ch04.ipynb"], "s7654321") == ["s7654321"] * 2


def test_a_name_that_is_a_common_word_when_joined_claims_no_file():
    student = Person.read(Student(id="nb1", first_name="Note", last_name="Book"))
    assert owners(["my notebook.ipynb"], "ch04", {"nb1": student}) == {"my notebook.ipynb": []}


def test_a_title_in_all_names_and_a_folder_around_all_belong_to_nobody():
    assert owned(["Mechanics II/eve.ipynb", "Mechanics II/ben.ipynb"]) == ["eve", "ben"]
    assert owned(["Mechanics eve.ipynb", "Mechanics ben.ipynb"]) == ["eve", "ben"]
    notebooks = [f"{s}_notebook.ipynb" for s in ("ada", "eve", "ben")]
    assert owned(notebooks, *COMMON) == ["ada", "eve", "ben"]
    assert owned([f"submissions/{s}/work.ipynb" for s in ("eve", "ada")], *COMMON) == ["eve", "ada"]
    assert owned([f"Zoe Quinn{MOODLE}{s}.ipynb" for s in ("eve", "ben")]) == ["", ""]
    assert owned(["Ada Smith a.ipynb", "Ada Smith b.ipynb"]) == ["", ""]

"""Each student's own copy: their numbers and figures, no key, nothing of anyone else's."""

import os
import pwd
import re
import stat

import pytest

from grader.assignment import copy_to_exchange, make_personal_copies, problems_of
from grader.assignment import notebook as nb
from grader.assignment.fetch import personal_name
from grader.assignment.personal import warning
from grader.course import CourseError
from tests.grader.courses import append_config, command, ran, read, released_sheet
from tests.grader.keys import secrets_in

STUDENTS = ("ada", "ben", "cleo", "dan", "eve", "mallory")


@pytest.mark.parametrize("student", STUDENTS)
def test_what_a_student_fetches_holds_no_key_and_nobody_elses_numbers(course, student):
    assert secrets_in(course.personal_path("ch04", student).read_text(), course, student) == []
    cells_of = lambda name: read(course.personal_path("ch04", name))["cells"]
    givens = lambda cell: cell["metadata"]["newton_euler"].get("role") == "givens"
    others = {c["source"] for s in STUDENTS if s != student for c in cells_of(s) if givens(c)}
    sheet = problems_of(released_sheet(course))
    symbolic = {nb.givens(p, {}) for p in sheet if p.symbolic and not p.givens}
    assert {c["source"] for c in cells_of(student)} & others <= symbolic
    assert not any(c.get("outputs") for c in cells_of(student))


def test_the_released_notebook_and_the_source_hold_no_key(course):
    for path in (course.source("ch04"), course.released_path("ch04")):
        text = re.sub("### (BEGIN|END) SOLUTION", "", path.read_text())
        assert secrets_in(text, course, "nobody") == []


def test_figures_follow_the_numbers(course):
    def figures(student):
        return {
            c["id"]: c["attachments"]["figure.png"]["image/png"]
            for c in read(course.personal_path("ch04", student))["cells"]
            if "attachments" in c
        }

    ada, ben = figures("ada"), figures("ben")
    assert ada["statement-4-16"] != ben["statement-4-16"]
    assert ada["statement-4-2"] == ben["statement-4-2"]  # a formula is asked for: no numbers


def test_a_late_joiner_gets_a_copy_and_nobody_elses_changes(ungraded, tmp_path):
    before = ungraded.personal_path("ch04", "ada").read_text()
    outbound = tmp_path / "exchange/mechanics/outbound/ch04"
    outbound.mkdir(parents=True)
    append_config(ungraded, f"c.Exchange.root = {str(tmp_path / 'exchange')!r}")
    ungraded.enrol(["zoe"])
    ran(command("personal", "ch04", "--course", ungraded.path, "--student", "zoe", "--exchange"))
    place = outbound.parent / ".personal/ch04" / personal_name("mechanics", "ch04", "zoe")
    assert (place / "ch04.ipynb").exists()
    assert ungraded.personal_path("ch04", "ada").read_text() == before


def test_personal_copies_are_the_same_when_made_again(ungraded):
    before = ungraded.personal_path("ch04", "ada").read_text()
    make_personal_copies(ungraded, "ch04", ["ada"], workers=1)
    assert ungraded.personal_path("ch04", "ada").read_text() == before


def test_an_empty_roster_is_reported(ungraded):
    with ungraded.gradebook() as book:
        for s in ungraded.roster():
            book.remove_student(s)
    with pytest.raises(CourseError, match=r"nobody is on the roster; add students with"):
        make_personal_copies(ungraded, "ch04")
    with pytest.raises(CourseError, match=r"zoe: not on the roster; .*enrol roster.csv"):
        make_personal_copies(ungraded, "ch04", ["zoe"])


def test_a_copy_in_the_exchange_is_for_its_student_alone(course, tmp_path, monkeypatch):
    """By an access list; without a user of the machine, in a folder whose name is not listed."""
    (tmp_path / "setfacl").write_text(f'#!/bin/sh\necho "$@" >> {tmp_path}/calls\n')
    (tmp_path / "setfacl").chmod(0o755)
    monkeypatch.setenv("PATH", str(tmp_path), prepend=":")
    monkeypatch.setattr(os, "geteuid", lambda: 1000)
    outbound = tmp_path / "outbound/ch04"
    outbound.mkdir(parents=True)
    paths = {s: course.personal_path("ch04", "ada") for s in ("nobody", "no such user")}
    open_to_others = copy_to_exchange(course, "ch04", outbound, paths)
    assert open_to_others == ["no such user"]
    assert "of 1 students (no such user)" in warning(open_to_others)
    output = (tmp_path / "calls").read_text()
    own = personal_name(course.name, "ch04", "nobody")
    user = pwd.getpwnam("nobody").pw_uid
    assert output.startswith(f"--modify user:{user}:rX,group::---,other::---")
    assert output.count(own) == 2
    assert len(output.splitlines()) == 1
    folder = outbound.parent / ".personal/ch04"
    assert stat.S_IMODE(folder.stat().st_mode) == 0o711
    (tmp_path / "setfacl").write_text("#!/bin/sh\nexit 1\n")  # a file system without access lists
    assert copy_to_exchange(course, "ch04", outbound, paths) == list(paths)


def test_a_copy_that_root_hands_out_is_its_owners_alone(course, tmp_path, monkeypatch):
    if os.geteuid() != 0:
        pytest.skip("only root can give files away")
    outbound = tmp_path / "outbound/ch04"
    outbound.mkdir(parents=True)
    path = course.personal_path("ch04", "ada")
    assert copy_to_exchange(course, "ch04", outbound, {"nobody": path}) == []
    place = outbound.parent / ".personal/ch04" / personal_name(course.name, "ch04", "nobody")
    assert (place.stat().st_uid, stat.S_IMODE(place.stat().st_mode)) == (
        pwd.getpwnam("nobody").pw_uid, 0o700,
    )  # fmt: skip
    assert warning([]) == ""

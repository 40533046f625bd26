"""An update of a course loses nothing that an instructor has changed, and brings in the rest."""

import copy
import json

import pytest

from grader.assignment.cells import code_cell, markdown_cell
from grader.assignment.merge import merged
from grader.course import Course, load_json
from tests.grader.courses import command, ran, refused


def sheet(*problems, words="Find v.", picture="old", points=1.0):
    """A source notebook of these problems."""
    cells = [markdown_cell("introduction", "# Title", {"role": "introduction"})]
    for p in problems:
        text = markdown_cell(f"{p}-text", f"{p}: {words}", {"role": "statement", "problem": p})
        text["attachments"] = {"figure.png": {"image/png": picture}}
        own = {"role": "answer", "problem": p, "asked": {"v": "number, m/s"}}
        marks = {"grade_id": f"{p}-answer", "points": points, "checksum": words}
        cells += [text, code_cell(f"{p}-answer", "v = None", own, marks)]
    return {"nbformat": 4, "nbformat_minor": 5, "metadata": {}, "cells": cells}


def edited(notebook, change):
    """A copy, changed by the instructor."""
    changed = copy.deepcopy(notebook)
    change(changed["cells"])
    return changed


def texts(notebook):
    return ["".join(c["source"]) for c in notebook["cells"]]


def set_text(n, text):
    return lambda cells: cells[n].update(source=text)


def own_cell(cells):
    cells.insert(2, {"cell_type": "markdown", "id": "x", "metadata": {}, "source": "A hint."})


OLD, NEW = sheet("4/1", "4/2"), sheet("4/1", "4/2", words="Find the speed.", picture="new")


def test_what_nobody_changed_becomes_what_the_exercises_are_today_and_pictures_beside_own_texts():
    found = merged(OLD, OLD, NEW)
    assert texts(found.notebook) == texts(NEW)
    assert found.notebook["cells"][1]["attachments"] == NEW["cells"][1]["attachments"]
    assert [found.kept, found.conflicts, found.removed] == [[], [], []]
    found = merged(OLD, edited(OLD, set_text(1, "My words")), NEW)
    cell = found.notebook["cells"][1]
    assert (cell["source"], cell["attachments"]["figure.png"]["image/png"]) == ("My words", "new")


@pytest.mark.parametrize(("change", "kept", "conflicts"), [
    (set_text(0, "# My title"), ["introduction"], []),
    (set_text(1, "My words"), ["4/1 statement"], ["4/1 statement"]),
    (set_text(4, "v = None  # in km/h"), ["4/2 answer"], []),
    (lambda c: c[2]["metadata"]["nbgrader"].update(points=5.0), ["4/1 answer"], []),
    (lambda c: c[2]["metadata"]["newton_euler"].update(weights={"v": 2}), ["4/1 answer"], []),
    (lambda c: c[2]["metadata"]["nbgrader"].update(checksum="other"), [], []),
    (lambda c: c[1]["metadata"].update(tags=["x"], collapsed=True), [], []),
    (own_cell, [], []),
    (lambda c: c.reverse(), [], []),
    (lambda c: c.__delitem__(slice(3, 5)), [], []),
    (lambda c: c.clear(), [], []),
])  # fmt: skip
def test_a_change_of_the_instructor_stays(change, kept, conflicts):
    theirs = edited(OLD, change)
    found = merged(OLD, theirs, NEW)
    assert (found.kept, found.conflicts) == (kept, conflicts)
    was = dict(zip(texts(OLD), texts(NEW), strict=True))
    assert texts(found.notebook) == [was.get(text, text) for text in texts(theirs)]
    points = lambda marks: marks.get("nbgrader", {}).get("points")
    for cell, before in zip(found.notebook["cells"], theirs["cells"], strict=True):
        now, then = cell["metadata"], before["metadata"]
        assert {k: x for k, x in then.items() if k != "nbgrader"}.items() <= now.items()
        assert points(now) == points(then)


def test_new_problems_come_in_at_their_place_and_others_go_unless_they_were_changed():
    theirs = edited(OLD, set_text(3, "4/2: my words"))
    found = merged(OLD, theirs, sheet("4/0", "4/1", "4/3"))
    assert texts(found.notebook) == [
        "# Title", "4/0: Find v.", "v = None", "4/1: Find v.", "v = None", "4/3: Find v.", "v = None",
        "4/2: my words",
    ]  # fmt: skip
    assert found.removed == ["4/2 answer"]


def test_a_build_adds_to_a_course_and_loses_nothing(tmp_path):
    """The round trip: the program's own advice for a late student, a new date, one more problem."""
    place, roster = tmp_path / "c", tmp_path / "roster.csv"
    roster.write_text("id\nada\n")
    ran(command("build", "ch04", "--course", place, "--problem", "4/1", "--students", roster))
    course = Course(place)
    path = course.source("ch04")
    notebook = load_json(path.read_bytes())
    notebook["cells"][1]["source"] = "My own words."
    own_cell(notebook["cells"])
    path.write_text(json.dumps(notebook))
    mine = path.read_bytes()

    roster.write_text("id\nada\nben\n")
    assert "Enrolled 1 student (" in ran(command("enrol", roster, "--course", place))
    assert "Due: 2027-01-31 22:59 UTC" in ran(
        command("due", "ch04", "2027-01-31 23:59 Europe/Berlin", "--course", place)
    )
    assert path.read_bytes() == mine
    out = refused(command("due", "ch05", "2027-01-31 23:59 Europe/Berlin", "--course", place))
    assert "has no assignment ch05; it has ch04" in out

    update = lambda *given: ran(command("build", "ch04", "--course", place, "--update", *given))
    out = " ".join(update().split())
    assert texts(load_json(path.read_bytes())) == texts(notebook)
    assert "Kept as you changed it: " in out
    update("--problem", "4/1", "--problem", "4/2")
    now = texts(load_json(path.read_bytes()))
    assert now[: len(notebook["cells"])] == texts(notebook)
    assert any("## 4/2" in text for text in now)
    assert mine in [p.read_bytes() for p in (place / "backup").iterdir()]

    (place / "built/ch04.ipynb").unlink()  # a course built by an earlier version has none
    update("--problem", "4/1")
    assert "My own words." in texts(load_json(path.read_bytes()))

"""Hostile submissions between honest ones, in both routes, as root, as an ordinary user, and without
namespaces: none earns a point, changes or delays another, leaves anything behind, or reaches the
instructor.
"""

import json
import os
import re
import sys
from pathlib import Path

import pytest
from nbconvert.exporters import HTMLExporter

from tests.grader.attacks import arena as a
from tests.grader.attacks.tables.texts import EVIL
from tests.grader.courses import points
from tests.grader.keys import keys
from tests.grader.nbgrader_hooks.test_feedback_page import Page

pytestmark = [
    pytest.mark.integration,
    pytest.mark.skipif(sys.platform != "linux", reason="the cage needs Linux"),
]
GRACE = 15  # seconds that a busy machine may need to end a job
MODES = {  # the route and how it runs
    "grade": ("grade", {}),
    "autograde": ("autograde", {}),
    "grade, as a user": ("grade", {"ordinary": True}),
    "autograde, as a user": ("autograde", {"ordinary": True}),
    "grade, without a cage": ("grade", {"sandbox": False}),
}
FULL = {"answer-4-1": 2, "answer-4-16": 3, "test_square": 4}
FORMGRADER = {"index": 0, "total": 1, "base_url": "", "submission_id": "x", "notebook_id": "ch04",
              "assignment_id": "ch04", "student": "", "first_name": "", "last_name": "",
              "notebook_path": "", "mathjax_config": "", "keyword": ""}  # fmt: skip
CONTROL = re.compile("[\x00-\x08\x0b-\x1f\x7f-\x9f\u202a-\u202e\u2066-\u2069\udc80-\udcff]")


@pytest.fixture(scope="session")
def released():
    folder = a.temporary_folder()
    yield a.build(folder)
    a.remove(folder)


@pytest.fixture(
    scope="module",
    params=[pytest.param(m, marks=[pytest.mark.slow] if m != "grade" else []) for m in MODES],
)
def arena(request, released):
    """All attacks and the honest ones, graded in one mode."""
    route, options = MODES[request.param]
    if options.get("sandbox") is False and os.geteuid() != 0:
        pytest.skip("without a cage and without root, students' code has the instructor's rights")
    folder = a.temporary_folder()
    names = [n for n, x in a.ATTACKS.items() if options.get("sandbox", True) or not x.caged]
    found = a.run(a.prepare(released, folder, names), route, **options)
    found.names, found.scores = names, a.scores(found)
    found.as_user = {k: v for k, v in options.items() if k == "ordinary"}
    yield found
    found.host.close()
    a.remove(folder)


def test_the_honest_students_earn_every_point(arena):
    earned = {s: arena.scores.get(s, {}) for s in a.honest_students()}
    assert {s: {c: x.get(c) for c in FULL} for s, x in earned.items()} == dict.fromkeys(
        a.honest_students(), FULL
    ), arena.output[-3000:]


@pytest.mark.parametrize("name", a.ATTACKS)
def test_it_earns_nothing(arena, name):
    if name not in arena.names:
        pytest.skip("nothing but the cage stops it, or not even that")
    attack, student = a.ATTACKS[name], a.STUDENTS[name]
    earned = arena.scores.get(student, {})
    assert sum(p or 0 for p in earned.values()) == 0, (earned, points(arena.course)[student])
    if not attack.readable:
        assert not earned or set(earned.values()) <= {None, 0.0}
        assert re.search(rf"\b{student}\b", arena.output)
    elif student not in arena.scores:
        pytest.fail(f"it was not graded: {lines_of(arena, student)}")
    if attack.shown:
        comments = [c for _, _, c in points(arena.course)[student].values() if c]
        assert attack.shown in "\n".join(comments)
    attack.check(arena.scene(student))


def lines_of(arena, student):
    return [line for line in arena.output.splitlines() if student in line]


def test_no_job_takes_longer_than_its_own_deadline(arena):
    assert len(arena.jobs) > len(arena.names) / 2
    assert max(arena.jobs) < 2 * a.SECONDS + GRACE


def test_nothing_is_left_behind(arena):
    assert a.processes(arena.outside / "home") == []
    assert a.left_behind(arena.mark) == []
    assert sorted(p.name for p in arena.outside.iterdir()) == ["home"]
    assert not Path("/written").exists()
    assert not Path("/etc/written").exists()
    assert not Path("/tmp/configured").exists()


WRITTEN = re.compile(
    r"(scores|autograded|numbers)(/|$)|gradebook\.db|\.nbgrader\.log|submitted$|\.$"
)


def test_nothing_is_changed_but_what_grading_writes(arena):
    after = a.files(arena.course.path)
    changed = {p for p in {*arena.before, *after} if arena.before.get(p) != after.get(p)}
    assert {p for p in changed if not WRITTEN.match(p)} == set()
    students = {*a.honest_students(), *a.STUDENTS.values()}
    assert {p.stem for p in (arena.course.path / "scores/ch04").glob("*")} <= students
    assert {p.name for p in (arena.course.path / "autograded").glob("*")} <= students


def test_what_is_reported_has_no_terminal_codes_and_no_secret(arena):
    assert not CONTROL.search(arena.output), CONTROL.search(arena.output)
    for secret in (a.SECRET, a.TOKEN, "hidden words"):
        assert secret not in arena.output
    lines = arena.output.splitlines()
    assert not [x for x in lines if x.startswith(("ada 11", "Evil", "[AutogradeApp] done"))]


def test_what_students_may_read_holds_no_secret_and_nothing_of_a_neighbour(arena):
    theirs = json.loads(arena.scene("x").honest.read_text())["cells"]
    numbers = set(re.findall(r"\d\.\d{9,}", " ".join(map(str, (c["source"] for c in theirs)))))
    assert numbers
    book = points(arena.course)
    for name in arena.names:
        text = "\n".join(c for _, _, c in book.get(a.STUDENTS[name], {}).values() if c)
        for secret in (a.SECRET, a.TOKEN, "hidden words", *numbers):
            assert secret not in text, name
        assert not CONTROL.search(text), name


def test_the_secret_is_in_no_file_that_was_written(arena):
    for folder in ("autograded", "scores", "numbers"):
        for path in (arena.course.path / folder).rglob("*"):
            assert not path.is_symlink()
            if path.is_file():
                content = path.read_bytes()
                assert a.SECRET.encode() not in content, path
                assert a.TOKEN.encode() not in content, path


def test_nobody_has_left_the_cage_over_the_network(arena):
    assert arena.visitors == []


def test_no_html_of_a_student_is_in_an_output(arena):
    for path in (arena.course.path / "autograded").glob("*/ch04/ch04.ipynb"):
        for cell in json.loads(path.read_text())["cells"]:
            html = json.dumps([o.get("data", {}).get("text/html") for o in cell.get("outputs", [])])
            assert "<script" not in html
            assert EVIL[:20] not in html


def test_feedback_pages_hold_no_secret_and_nothing_that_runs(arena, request):
    quick = request.node.callspec.params["arena"] == "grade"
    students = "m15*" if quick else "*"  # the last ones, which write texts
    a.run(arena, "generate_feedback", students=students, **arena.as_user)
    assert arena.code == 0, arena.output[-3000:]
    assert not CONTROL.search(arena.output)
    pages = (arena.course.path / "feedback").glob("m*/ch04/ch04.html")
    paths = [p for p in pages if p.parents[1].name in a.STUDENTS.values()]
    assert len(paths) >= (9 if quick else len(arena.names) / 2)
    for path in paths:
        text = path.read_text()
        page = Page(text)
        assert not {tag for tag, _ in page.elements} & {"script", "svg", "iframe", "object"}, path
        assert len(page.all("h1")) == 1
        assert not [x for _, x in page.elements if any(k.startswith("on") for k in x)]
        assert all(x["href"].startswith(("#", "http")) for x in page.all("a"))
        assert all(x["src"].startswith("data:image/svg+xml;") for x in page.all("img"))
        for secret in (a.SECRET, a.TOKEN, "hidden words"):
            assert secret not in text
        assert not _keys_not_written(arena.course, path), path


def _keys_not_written(course, path):
    """The numbers of a student's key that are on the page and that the student did not hand in."""
    student = path.parents[1].name
    plain = re.sub(r"[A-Za-z0-9+/=]{200,}", "", path.read_text())  # without pictures
    numbers = {n for n in keys(course, student) if n in plain}
    if not numbers:
        return numbers
    handed_in = (course.path / "submitted" / student / "ch04/ch04.ipynb").read_text()
    own = {f"{float(n):.6g}" for n in re.findall(r"\d+\.?\d*(?:e[+-]\d+)?", handed_in)}
    return {n for n in numbers if n not in handed_in and n not in own}


@pytest.mark.parametrize("name", [
    "texts: a text of HTML", "texts: an essay of HTML", "metadata: a picture in many places",
])  # fmt: skip
def test_nothing_runs_on_the_page_on_which_a_person_grades(arena, name):
    path = arena.course.path / "autograded" / a.STUDENTS[name] / "ch04/ch04.ipynb"
    config = arena.course.config()
    config.HTMLExporter.template_name = "formgrade"
    text, _ = HTMLExporter(config=config).from_filename(str(path), resources=FORMGRADER)
    for x in ("<script>alert", "onerror=alert(1)>", "<svg onload", "<iframe", 'href="javascript'):
        assert x not in text
    assert len(text) < 10**8


@pytest.mark.slow  # half a minute
@pytest.mark.skipif(os.geteuid() != 0, reason="only root can give its rights up")
@pytest.mark.parametrize("route", ["grade", "autograde"])
def test_where_namespaces_are_refused_nothing_runs_and_nobody_is_graded(released, route):
    folder = a.temporary_folder()
    names = ["machine: files of the instructor", "answers: json", "folders: empty"]
    prepared = a.prepare(released, folder, names, honest=a.honest_students()[:2])
    found = a.run(prepared, route, before=a.REFUSED)
    try:
        assert found.code == 1, found.output[-3000:]
        assert "this machine refuses the cage for student code" in found.output
        assert {p for cells in a.scores(found).values() for p in cells.values()} <= {None}
        assert not list((found.course.path / "autograded").glob("*/ch04/ch04.ipynb"))
        assert a.processes(found.outside / "home") == []
        assert sorted(p.name for p in found.outside.iterdir()) == ["home"]
    finally:
        found.host.close()
        a.remove(folder)


def test_there_are_enough_attacks_and_their_names_are_theirs_alone():
    assert len(a.ATTACKS) == sum(map(len, a.FAMILIES.values())) >= 60

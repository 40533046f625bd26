"""nbgrader refuses to grade where the course's configuration did not run, and reads only regular
files.

Its own steps would run students' code without a cage, as the instructor: a submission writes a file
where that happens.
"""

import os
import shutil

import pytest

from tests.grader.attacks.attack import Scene
from tests.grader.attacks.tables import folders
from tests.grader.courses import (
    append_config,
    copy_of,
    forget,
    nbgrader,
    points,
    ran,
    refused,
    submit,
    total,
)
from tests.grader.submissions import work

pytestmark = pytest.mark.integration
NOWHERE = "/nowhere/checkout"


@pytest.fixture
def telltale(fresh, tmp_path):
    """A file that a submission of dan writes when it runs without a cage."""
    path = tmp_path / "written without a cage"
    submit(fresh, "dan", work(fresh, "dan", p4_1=f"open({str(path)!r}, 'w').close(); speed = 1"))
    return path


def appended(text):
    return lambda course, tmp_path: append_config(course, text) or {}


def without_a_package(course, tmp_path):
    broken = tmp_path / "broken"
    broken.mkdir()
    (broken / "numpy.py").write_text("raise ImportError('No module named numpy')\n")
    return {"PYTHONPATH": str(broken)}


def another_secret(course, tmp_path):
    (course.path / ".course_secret").write_text("ab" * 32)
    return {}


BROKEN = {
    "the checkout has moved": (
        lambda course, tmp_path: {"NEWTON_EULER": NOWHERE},
        "nbgrader stops here: the grader of this course was not found in /nowhere/checkout",
    ),
    "an error in the instructor's settings": (
        appended("c.Exchange.rooot = 1 / 0"),
        "nbgrader_config.py of this course did not run to its end (its error is above)",
    ),
    "settings that are not Python": (appended("c.Exchange.root = ("), "'(' was never closed"),
    "a missing package": (without_a_package, "No module named numpy"),
    "another secret": (another_secret, "is not the secret that the course was made with"),
}


@pytest.mark.parametrize("how", BROKEN)
def test_nbgrader_autograde_refuses_and_runs_nothing(fresh, telltale, tmp_path, how):
    change, words = BROKEN[how]
    before = points(fresh)
    kept = (fresh.path / "autograded").exists()
    variables = {"PYTHONPATH": "", **change(fresh, tmp_path)}
    done = nbgrader("autograde", "ch04", "--force", cwd=fresh.path, **variables)
    assert words in refused(done, None)
    assert not telltale.exists()
    assert points(fresh) == before
    assert (fresh.path / "autograded").exists() == kept


def test_the_telltale_works(fresh, telltale):
    """Plain nbgrader does run the submission without a cage."""
    (fresh.path / "nbgrader_config.py").write_text("c = get_config()\n")
    (fresh.path / "nbgrader_config.json").unlink()
    nbgrader("autograde", "ch04", "--student=dan", "--force", cwd=fresh.path, PYTHONPATH="")
    assert telltale.exists()


@pytest.mark.parametrize("step", ["collect", "generate_feedback", "release_feedback"])
def test_the_other_steps_refuse_too(fresh, step):
    done = nbgrader(step, "ch04", cwd=fresh.path, NEWTON_EULER=NOWHERE, PYTHONPATH="")
    assert "nbgrader stops here" in refused(done, None)


def test_a_course_in_a_folder_with_spaces_and_accents_is_graded_by_nbgrader(course, tmp_path):
    moved = copy_of(course, tmp_path / "Méca 2026")
    forget(moved, "ada")
    ran(nbgrader("autograde", "ch04", "--student=ada", cwd=moved.path, PYTHONPATH=""))
    assert total(points(moved)["ada"]) == 11


# nbformat would take 7 GB for the values
HOSTILE = {
    f"h{n}": folders.ATTACKS[name]
    for n, name in enumerate((
        "a link to the secret", "a pipe", "a link without end", "bytes", "more than is read",
        "twenty million values",
    ))
}  # fmt: skip


def test_a_notebook_that_is_not_a_regular_file_affects_its_student_alone(fresh, tmp_path):
    for student in ("ben", "cleo", "dan", "mallory"):
        shutil.rmtree(fresh.path / "submitted" / student)
    fresh.enrol(HOSTILE)
    for student, attack in HOSTILE.items():
        attack.make(Scene(fresh, student, tmp_path, "mark", 0))
    forget(fresh, "eve")
    limits = {"timeout": 60, "memory": 3 * 2**30}
    code, out = nbgrader("autograde", "ch04", "--force", cwd=fresh.path, **limits)
    assert code == 1, out
    graded = points(fresh)
    for student in HOSTILE:
        assert f"error processing assignment 'ch04' for student '{student}'" in out
        assert total(graded.get(student, {})) == 0
    assert (total(graded["ada"]), total(graded["eve"])) == (11, 9)


def test_links_and_pipes_beside_a_notebook_are_neither_followed_nor_waited_for(fresh):
    folder = fresh.path / "submitted/dan/ch04"
    (folder / "notes.html").symlink_to(fresh.path / ".course_secret")
    os.mkfifo(folder / "data.csv")
    (folder / "timestamp.txt").unlink()
    os.mkfifo(folder / "timestamp.txt")
    (folder / "table.txt").write_text("1 2 3")
    submit(fresh, "dan", work(fresh, "dan"))
    ran(nbgrader("autograde", "ch04", "--student=dan", "--force", cwd=fresh.path, timeout=60))
    kept = {p.name for p in (fresh.path / "autograded/dan/ch04").iterdir()}
    assert kept - {"submission_secret.txt"} == {"ch04.ipynb", "table.txt"}
    ran(nbgrader("generate_feedback", "ch04", "--student=dan", cwd=fresh.path, timeout=60))
    secret = (fresh.path / ".course_secret").read_text().strip()
    pages = [p for p in (fresh.path / "feedback").rglob("*") if p.is_file()]
    assert not [p for p in pages if secret.encode() in p.read_bytes()]


TIMES = {
    "a folder": lambda path: path.mkdir(),
    "a huge year": lambda path: path.write_text("99999-01-01 10:00:00 UTC"),
    "an early year": lambda path: path.write_text("0001-01-01 00:00:00 +14:00"),
    "nonsense": lambda path: path.write_text("soon"),
    "empty": lambda path: path.write_text(""),
    "bytes": lambda path: path.write_bytes(b"\xff\x00"),
    "long": lambda path: path.write_text("1" * 100_000),
    # from one student, it stopped the grading of a whole exam
    "a long zone": lambda path: path.write_text("2026-11-22 10:00:00 " + "A" * 300),
    "a zone that is a file": lambda path: path.write_text("2026-11-22 10:00:00 ../../etc/passwd"),
    "a zone that is a path": lambda path: path.write_text("2026-11-22 10:00:00 /etc/localtime"),
    "missing": lambda path: None,
}


@pytest.mark.parametrize("how", TIMES)
def test_an_unreadable_time_of_submission_is_disregarded(tmp_path, how):
    from grader.submission.timestamps import read_timestamp

    TIMES[how](tmp_path / "timestamp.txt")
    assert read_timestamp(tmp_path) is None


def test_nbgrader_itself_does_not_need_numpy(fresh, tmp_path):
    """Otherwise a missing package would say nothing about ours."""
    found = nbgrader("--version", cwd=tmp_path, **without_a_package(fresh, tmp_path))
    assert "nbgrader version" in ran(found)


@pytest.mark.parametrize("text", [
    "2026-11-22 10:00:00.123 UTC", "2026-11-22 11:00:00.123 CET", "20261122T100000.123Z",
    "2026-11-22 11:00:00.123 Europe/Berlin",
    "2026-11-22T11:00:00.123+01:00", "2026-11-22 10:00:00", "2026-11-22 11:00:00.123 3600",
])  # fmt: skip
def test_a_time_of_submission_is_read_in_utc(tmp_path, text):
    from grader.submission.timestamps import read_timestamp

    (tmp_path / "timestamp.txt").write_text(text)
    assert read_timestamp(tmp_path).isoformat(timespec="seconds") == "2026-11-22T10:00:00"


def test_a_file_in_the_place_of_the_page_keeps_nobody_from_feedback(fresh):
    folder = fresh.path / "submitted/dan/ch04"
    (folder / "ch04.html").mkdir()
    (folder / "ch04.html/x").write_text("x")
    (fresh.path / "submitted/eve/ch04/ch04.html").write_text("<script>alert(1)</script>")
    for student in ("dan", "eve"):
        ran(nbgrader("autograde", "ch04", f"--student={student}", cwd=fresh.path))
        ran(nbgrader("generate_feedback", "ch04", f"--student={student}", cwd=fresh.path))
        page = fresh.path / "feedback" / student / "ch04/ch04.html"
        assert "<script" not in page.read_text()
        assert {p.name for p in page.parent.iterdir()} <= {
            "ch04.html", "timestamp.txt", "submission_secret.txt",
        }  # fmt: skip


def test_names_of_files_give_the_terminal_no_commands_through_nbgraders_log():
    import logging

    from grader.nbgrader_hooks.guards import _one_line_each

    name = "a\x1b[2J\n[AutogradeApp] done\u202e\udcff"
    record = logging.LogRecord("x", 20, "", 1, "Copying %s: %d", (name, 3), None)
    assert _one_line_each(record)
    assert record.getMessage() == "Copying a\ufffd[2J\ufffd[AutogradeApp] done\ufffd\ufffd: 3"
    record = logging.LogRecord("x", 20, "", 1, f"Traceback\n\t{name}", (), None)
    assert _one_line_each(record)
    assert record.getMessage() == "Traceback\n\ta\ufffd[2J\n[AutogradeApp] done\ufffd\ufffd"

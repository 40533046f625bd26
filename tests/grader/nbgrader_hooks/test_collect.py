"""nbgrader collect copies only regular files of a submission, and releases only our pages."""

import os
import shutil
import stat

import pytest
from nbgrader.utils import notebook_hash

from tests.grader.courses import command, nbgrader, ran

pytestmark = pytest.mark.integration


@pytest.fixture
def inbound(ungraded):
    """The folder of the course's exchange to which students submit."""
    folder = ungraded.path / "exchange/mechanics/inbound"
    folder.mkdir(parents=True)
    (ungraded.path / "exchange").chmod(0o777)
    return folder


def submitted(inbound, student, time="2026-11-20 10:00:00.000000 UTC", **files):
    """A submission in the exchange, as nbgrader submit makes it."""
    folder = inbound / f"{student}+ch04+{time}+random"
    folder.mkdir()
    (folder / "timestamp.txt").write_text(time)
    (folder / "submission_secret.txt").write_text("the secret of " + student)
    for name, text in files.items():
        (folder / name.replace("__", ".")).write_text(text)
    return folder


def test_links_pipes_and_devices_are_left_out_and_reported(ungraded, inbound):
    hostile = submitted(inbound, "dan", notes__txt="mine")
    (hostile / "ch04.ipynb").symlink_to(ungraded.path / "personal/ch04/ada/ch04.ipynb")
    (hostile / "secret.html").symlink_to(ungraded.path / ".course_secret")
    (hostile / "everything").symlink_to(ungraded.path)
    os.mkfifo(hostile / "pipe")
    (hostile / "zero").symlink_to("/dev/zero")
    submitted(inbound, "eve", ch04__ipynb="{}")
    out = ran(nbgrader("collect", "ch04", cwd=ungraded.path, timeout=60))
    found = {p.name: p for p in (ungraded.path / "submitted/dan/ch04").iterdir()}
    assert set(found) == {"timestamp.txt", "submission_secret.txt", "notes.txt"}
    assert stat.S_IMODE(found["notes.txt"].stat().st_mode) == 0o600
    for name in ("ch04.ipynb", "secret.html", "everything", "pipe", "zero"):
        assert f"'{name}' of " in out
    assert (ungraded.path / "submitted/eve/ch04/ch04.ipynb").read_text() == "{}"


def test_a_folder_of_another_name_stops_nobody(ungraded, inbound):
    (inbound / "dan+ch04+whenever+x").mkdir()
    (inbound / "dan+ch04+99999-01-01 10:00:00 UTC+x").mkdir()
    (inbound / "\x1b[2J+ch04+\n").mkdir()
    for name in ("..", ".", "\x1b[2Jada", "-ada", "a*"):  # not ids: folders, terminal codes
        submitted(inbound, name, ch04__ipynb="{}")
    before = sorted(p.name for p in ungraded.path.iterdir())
    submitted(inbound, "eve", ch04__ipynb="{}")
    out = ran(nbgrader("collect", "ch04", cwd=ungraded.path))
    assert [p.name for p in (ungraded.path / "submitted").iterdir()] == ["eve"]
    assert sorted(p.name for p in ungraded.path.iterdir()) == sorted([*before, "submitted"])
    assert "\x1b[2J" not in out


@pytest.mark.skipif(os.geteuid() != 0, reason="only root can give files away")
def test_a_submission_in_the_name_of_a_neighbour_is_not_collected(ungraded, inbound):
    ungraded.enrol(["nobody"])  # a user of this machine
    submitted(inbound, "ada", ch04__ipynb="{}")
    forged = submitted(inbound, "ada", "2026-11-21 10:00:00.000000 UTC", ch04__ipynb="[]")
    shutil.chown(forged, "nobody")
    out = ran(nbgrader("collect", "ch04", cwd=ungraded.path))
    assert "says it is by ada but belongs to nobody" in out
    assert (ungraded.path / "submitted/ada/ch04/ch04.ipynb").read_text() == "{}"


def test_a_newer_submission_replaces_an_older_one(ungraded, inbound):
    submitted(inbound, "ada", ch04__ipynb="{}")
    assert nbgrader("collect", "ch04", cwd=ungraded.path)[0] == 0
    submitted(inbound, "ada", "2026-11-21 10:00:00.000000 UTC", ch04__ipynb="[]")
    assert nbgrader("collect", "ch04", "--update", cwd=ungraded.path)[0] == 0
    assert (ungraded.path / "submitted/ada/ch04/ch04.ipynb").read_text() == "[]"


def test_only_the_pages_of_the_assignment_are_released(fresh):
    exchange = fresh.path / "exchange"
    (exchange / "mechanics").mkdir(parents=True)
    exchange.chmod(0o777)
    for student in ("ada", "ben", "cleo"):
        folder = fresh.path / "feedback" / student / "ch04"
        folder.mkdir(parents=True)
        (folder / "ch04.html").write_text(f"the page of {student}")
        (folder / "timestamp.txt").write_text("2026-11-20 10:00:00 UTC")
        (folder / "submission_secret.txt").write_text(f"secret of {student}")
    (fresh.path / "feedback/ada/ch04/evil.html").symlink_to(fresh.path / ".course_secret")
    (fresh.path / "feedback/ben/ch04/ch04.html").unlink()
    (fresh.path / "feedback/ben/ch04/ch04.html").symlink_to(fresh.path / ".course_secret")
    (fresh.path / "feedback/cleo/ch04/submission_secret.txt").unlink()
    (fresh.path / "submitted/cleo/ch04/submission_secret.txt").unlink()
    out = ran(nbgrader("release_feedback", "ch04", cwd=fresh.path))
    released = [p.read_text() for p in (exchange / "mechanics/feedback").iterdir()]
    assert released == ["the page of ada"]
    assert "cleo did not hand in through the exchange; give them" in out
    assert "ch04.html of ben was not released" in out


def test_feedback_is_released_after_the_graders_own_route(fresh):
    """Timestamp and secret are where autograde would have put them, or where submitted."""
    (fresh.path / "exchange/mechanics").mkdir(parents=True)
    (fresh.path / "exchange").chmod(0o777)
    assert command("grade", "ch04", "--course", fresh.path, "--force")[0] == 0
    for step in ("generate_feedback", "release_feedback"):
        ran(nbgrader(step, "ch04", "--student=ada", cwd=fresh.path))
    (page,) = (fresh.path / "exchange/mechanics/feedback").iterdir()
    assert page.read_text() == (fresh.path / "feedback/ada/ch04/ch04.html").read_text()
    secret = (fresh.path / "submitted/ada/ch04/submission_secret.txt").read_text()
    assert page.stem == notebook_hash(secret=secret, notebook_id="ch04")

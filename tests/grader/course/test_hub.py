"""Two courses share a hub: one configuration, one exchange, students with accounts of their own."""

import os
import shutil
import subprocess
import sys

import pytest

from grader.course.hub import closed_to_others
from tests.grader.courses import environment, grader, nbgrader, ran, read

ADA, BOB = 61001, 61002  # users of this machine need no entry to run a process


def as_user(uid, *arguments, home):
    """The output of nbgrader's command line for the user of this number."""
    name = {ADA: "ada", BOB: "bob"}[uid]
    variables = environment(HOME=str(home), USER=name, LOGNAME=name, JUPYTERHUB_USER=name)
    del variables["JUPYTER_NO_CONFIG"]
    variables["PYTHONDONTWRITEBYTECODE"] = "1"
    done = subprocess.run(
        [sys.executable, "-m", "nbgrader", *arguments], user=uid, group=uid, extra_groups=[],
        cwd=home, env=variables, text=True, capture_output=True, timeout=300, check=False,
    )  # fmt: skip
    return done.returncode, done.stdout + done.stderr


@pytest.fixture
def hub(tmp_path_factory):
    """A folder that all users reach, with homes, an exchange and two courses."""
    if os.geteuid():
        pytest.skip("only root can become other users")
    top = tmp_path_factory.mktemp("hub")
    for folder in (top, *top.parents):
        if folder.owner() == "root" and "pytest" in str(folder):
            folder.chmod(folder.stat().st_mode | 0o011)
    if closed_to_others(top):
        pytest.skip(f"{closed_to_others(top)} cannot be entered by other users")
    return top


@pytest.mark.integration
def test_students_of_two_courses_fetch_and_submit_under_their_own_accounts(hub):
    roster = hub / "roster.csv"
    roster.write_text("Username\nada\nbob\n")
    for name, problem in (("statics", "3/1"), ("dynamics", "4/3")):
        build = "build", "hw1", problem, "--course", hub / name, "--students", roster
        ran(grader(*build, "--exchange", hub / "exchange"))
        for step in ("generate_assignment", "release_assignment"):
            ran(nbgrader(step, "hw1", cwd=hub / name))
    ran(grader("hub", hub / "statics", hub / "dynamics", "--to", hub / "etc"))
    for uid in (ADA, BOB):
        home = hub / f"home{uid}"
        shutil.copytree(hub / "etc", home / ".jupyter")
        for path in (home, *home.rglob("*")):
            os.chown(path, uid, uid)
        home.chmod(0o700)
        for course in ("statics", "dynamics"):
            for step in ("fetch_assignment", "submit"):
                ran(as_user(uid, step, "hw1", "--course", course, home=home))
        assert as_user(uid, "list", home=home)[1].count("hw1") >= 2
    for course, problem in (("statics", "3/1"), ("dynamics", "4/3")):
        sheets = [read(hub / f"home{uid}" / course / "hw1/hw1.ipynb") for uid in (ADA, BOB)]
        assert all(problem in str(sheet) for sheet in sheets)
        ran(nbgrader("collect", "hw1", cwd=hub / course))
        assert {p.name for p in (hub / course / "submitted").iterdir()} == {"ada", "bob"}
    assert subprocess.run(["ls", hub / "statics"], user=ADA, capture_output=True).returncode


def test_an_exchange_that_others_cannot_reach_is_named(tmp_path):
    home = tmp_path / "home"
    (home / "exchange").mkdir(parents=True)
    for folder in (tmp_path, home):
        folder.chmod(0o755)
    outside = closed_to_others(tmp_path)
    assert closed_to_others(home / "exchange") == outside
    home.chmod(0o700)
    assert closed_to_others(home / "exchange") == (outside or home)


@pytest.mark.integration
def test_courses_with_two_exchanges_or_one_name_are_refused(tmp_path):
    for folder, exchange in (("a/m", "x"), ("b/m", "x"), ("c", "y")):
        build = "build", "hw1", "4/3", "--course", tmp_path / folder
        ran(grader(*build, "--exchange", tmp_path / exchange))
    courses = [tmp_path / name for name in ("a/m", "b/m", "c")]
    assert "have the id m" in grader("hub", *courses[:2], "--to", tmp_path / "etc")[1]
    assert "one exchange" in grader("hub", *courses[1:], "--to", tmp_path / "etc")[1]

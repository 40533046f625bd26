"""Two courses share a hub: one configuration, one exchange, students with accounts of their own."""

import os
import shutil
import subprocess
import sys

import pytest

from grader.course.hub import closed_to_others
from tests.grader.courses import REPOSITORY, command, environment, grader, nbgrader, ran, read

# users of this machine need no entry to run a process
ADA, BOB, TEACHER, ASSISTANT, STAFF = range(61001, 61006)
NAMES = {ADA: "ada", BOB: "bob", TEACHER: "teacher", ASSISTANT: "assistant"}


def as_user(uid, module, *arguments, home, cwd=None, groups=()):
    """(exit code, output) of a module's command line for the user of this number."""
    name = NAMES[uid]
    variables = environment(HOME=str(home), USER=name, LOGNAME=name, JUPYTERHUB_USER=name)
    del variables["JUPYTER_NO_CONFIG"]
    variables["PYTHONDONTWRITEBYTECODE"] = "1"
    done = subprocess.run(
        [sys.executable, "-m", module, *map(str, arguments)], user=uid, group=uid,
        extra_groups=list(groups), cwd=cwd or home, env=variables, text=True, capture_output=True,
        timeout=300, check=False,
    )  # fmt: skip
    return done.returncode, done.stdout + done.stderr


def home_of(uid, hub):
    """A private home."""
    home = hub / f"home{uid}"
    home.mkdir()
    os.chown(home, uid, uid)
    home.chmod(0o700)
    return home


@pytest.fixture
def hub(tmp_path_factory):
    """A folder that all users reach, with homes, an exchange and two courses."""
    if os.geteuid():
        pytest.skip("only root can become other users")
    top = tmp_path_factory.mktemp("hub")
    for folder in (top, *top.parents):
        if folder.owner() == "root" and "pytest" in str(folder):
            folder.chmod(folder.stat().st_mode | 0o011)
    for needed in (top, sys.base_prefix, sys.prefix, REPOSITORY):
        if shut := closed_to_others(needed):
            pytest.skip(f"other users cannot enter {shut}, so they do not reach {needed}")
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
        home = home_of(uid, hub)
        shutil.copytree(hub / "etc", home / ".jupyter")
        for course in ("statics", "dynamics"):
            for step in ("fetch_assignment", "submit"):
                ran(as_user(uid, "nbgrader", step, "hw1", "--course", course, home=home))
        assert as_user(uid, "nbgrader", "list", home=home)[1].count("hw1") >= 2
    for course, problem in (("statics", "3/1"), ("dynamics", "4/3")):
        sheets = [read(hub / f"home{uid}" / course / "hw1/hw1.ipynb") for uid in (ADA, BOB)]
        assert all(problem in str(sheet) for sheet in sheets)
        ran(nbgrader("collect", "hw1", cwd=hub / course))
        assert {p.name for p in (hub / course / "submitted").iterdir()} == {"ada", "bob"}
    assert subprocess.run(["ls", hub / "statics"], user=ADA, capture_output=True).returncode


@pytest.mark.integration
def test_an_assistant_grades_under_an_account_of_their_own(hub):
    homes = {uid: home_of(uid, hub) for uid in (TEACHER, ASSISTANT)}
    place, roster = hub / "courses", hub / "roster.csv"
    roster.write_text("Username\nada\n")
    place.mkdir()
    os.chown(place, TEACHER, TEACHER)

    def by(uid, *arguments, module="grader", cwd=None):
        return as_user(uid, module, *arguments, home=homes[uid], cwd=cwd, groups=[STAFF])

    course = place / "mechanics"
    ran(by(TEACHER, "build", "hw1", "4/3", "--course", course, "--students", roster))
    ran(by(TEACHER, "generate_assignment", "hw1", module="nbgrader", cwd=course))
    ran(by(TEACHER, "personal", "hw1", "--course", course))
    work = course / "submitted/ada/hw1"
    work.mkdir(parents=True)
    shutil.copy(course / "personal/hw1/ada/hw1.ipynb", work)
    for path in (work, *work.parents[:2], work / "hw1.ipynb"):
        os.chown(path, TEACHER, TEACHER)
    grade = "grade", "hw1", "--course", course, "--unsandboxed", "--workers", 1
    assert by(ASSISTANT, *grade)[0] in (1, 2)  # the course is its owner's alone
    ran(by(TEACHER, "share", STAFF, "--course", course))
    for uid in (ASSISTANT, TEACHER, ASSISTANT):
        code, out = by(uid, *grade, "--force")
        assert code == 3, out
        ran(by(uid, "generate_feedback", "hw1", "--force", module="nbgrader", cwd=course))
    assert by(ASSISTANT, "stats", "hw1", "--course", course)[0] == 0
    assert subprocess.run(["ls", course], user=ADA, group=ADA, extra_groups=[]).returncode


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
        ran(command(*build, "--exchange", tmp_path / exchange))
    courses = [tmp_path / name for name in ("a/m", "b/m", "c")]
    assert "have the id m" in command("hub", *courses[:2], "--to", tmp_path / "etc")[1]
    assert "one exchange" in command("hub", *courses[1:], "--to", tmp_path / "etc")[1]

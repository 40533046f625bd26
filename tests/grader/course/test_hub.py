"""Two courses share a hub: one configuration, one exchange, an account for each student."""

import json
import os
import shlex
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from grader.course.hub import closed_to_others
from tests.grader.courses import REPOSITORY, command, environment, grader, nbgrader, ran, read

ADA, BOB, TEACHER, ASSISTANT, STAFF = range(61001, 61006)
NAMES = {ADA: "ada", BOB: "bob", TEACHER: "teacher", ASSISTANT: "assistant"}
NEEDED = sys.base_prefix, sys.prefix, REPOSITORY


def opened(paths):
    """Shell lines for a new mount namespace: folders that others cannot enter, such as root's home
    or a folder of mktemp, are covered by open ones that hold only the way to these paths.
    """
    leads = {}
    for path in (Path(p).resolve() for p in paths):
        for folder, child in zip([*path.parents, path], [path, *path.parents], strict=True):
            if not folder.stat().st_mode & 1:
                within = folder.iterdir() if folder == path else [child]
                leads.setdefault(folder, set()).update(within)
    yield "set -e; mount --make-rprivate /"
    for folder in sorted(leads):
        yield f'cd {shlex.quote(str(folder))}; mount -t tmpfs -o mode=755 none "$PWD"'
        for child in leads[folder]:
            at, make = shlex.quote(str(child)), "mkdir" if child.is_dir() else "touch"
            yield f"{make} {at}; mount -c --bind ./{shlex.quote(child.name)} {at}"


# runs command lines one by one, each in a fork of a process that has imported nbgrader once
EACH = """
import json, os, runpy, sys
import nbgrader.apps.nbgraderapp
codes = []
for module, *arguments in json.loads(sys.argv[1]):
    if not (child := os.fork()):
        sys.argv = [module, *arguments]
        runpy.run_module(module, run_name="__main__", alter_sys=True)
        sys.exit()
    codes.append(os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]))
print(json.dumps(codes))
"""


def as_user(uid, *commands, home, cwd=None, groups=()):
    """(exit codes, output) of modules' command lines, for the user of this number."""
    name = NAMES[uid]
    variables = environment(HOME=str(home), USER=name, LOGNAME=name, JUPYTERHUB_USER=name)
    del variables["JUPYTER_NO_CONFIG"]
    who = [f"--reuid={uid}", f"--regid={uid}"]
    who.append(f"--groups={','.join(map(str, groups))}" if groups else "--clear-groups")
    what = json.dumps([list(map(str, c)) for c in commands])
    program = shlex.join(["setpriv", *who, sys.executable, "-c", EACH, what])
    accounts = f"mount --bind {shlex.quote(str(home.parent / 'passwd'))} /etc/passwd"
    run = f"cd {shlex.quote(str(cwd or home))}; exec {program}"
    script = "\n".join([*opened([*NEEDED, home.parent]), accounts, run])
    done = subprocess.run(
        ["unshare", "--mount", "sh", "-c", script], env=variables, text=True, capture_output=True,
        timeout=300, check=False,
    )  # fmt: skip
    *out, codes = done.stdout.splitlines() or [""]
    assert done.returncode == 0, done.stderr
    return json.loads(codes), "\n".join([*out, done.stderr])


def home_of(uid, hub):
    """A private home."""
    home = hub / f"home{uid}"
    home.mkdir()
    os.chown(home, uid, uid)
    home.chmod(0o700)
    return home


@pytest.fixture
def hub(tmp_path_factory):
    """A folder that all users can reach, with homes, an exchange and two courses."""
    try:
        tried = subprocess.run(["unshare", "--mount", "true"], capture_output=True, check=False)
    except FileNotFoundError:
        tried = None
    if os.geteuid() or not tried or tried.returncode:
        pytest.skip("only root can become other users, in a mount namespace of their own")
    top = tmp_path_factory.mktemp("hub")
    top.chmod(0o755)
    rows = [f"{name}:x:{uid}:{uid}::/:/bin/sh\n" for uid, name in NAMES.items()]
    (top / "passwd").write_text("root:x:0:0::/root:/bin/sh\n" + "".join(rows))
    return top


@pytest.mark.slow
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
    steps = [
        ("nbgrader", step, "hw1", "--course", course)
        for course in ("statics", "dynamics")
        for step in ("fetch_assignment", "submit")
    ]
    for uid in (ADA, BOB):
        home = home_of(uid, hub)
        shutil.copytree(hub / "etc", home / ".jupyter")
        codes, out = as_user(uid, *steps, ("nbgrader", "list"), home=home)
        assert codes == [0] * 5, out
        assert out.partition("Released")[2].count("hw1") >= 2
    for course, problem in (("statics", "3/1"), ("dynamics", "4/3")):
        sheets = [read(hub / f"home{uid}" / course / "hw1/hw1.ipynb") for uid in (ADA, BOB)]
        assert all(problem in str(sheet) for sheet in sheets)
        ran(nbgrader("collect", "hw1", cwd=hub / course))
        assert {p.name for p in (hub / course / "submitted").iterdir()} == {"ada", "bob"}
    assert not (hub / "statics").stat().st_mode & 0o077


@pytest.mark.slow  # minutes
@pytest.mark.integration
def test_an_assistant_grades_under_an_account_of_their_own(hub):
    homes = {uid: home_of(uid, hub) for uid in (TEACHER, ASSISTANT)}
    place, roster = hub / "courses", hub / "roster.csv"
    roster.write_text("Username\nada\n")
    place.mkdir()
    os.chown(place, TEACHER, TEACHER)

    course = place / "mechanics"
    at = "--course", course

    def by(uid, *commands, codes, cwd=course):
        found, out = as_user(uid, *commands, home=homes[uid], cwd=cwd, groups=[STAFF])
        assert found == codes, out

    build = "grader", "build", "hw1", "4/3", *at, "--students", roster
    by(TEACHER, build, codes=[0], cwd=place)
    generate = "nbgrader", "generate_assignment", "hw1"
    by(TEACHER, generate, ("grader", "personal", "hw1", *at), codes=[0, 0])
    work = course / "submitted/ada/hw1"
    work.mkdir(parents=True)
    shutil.copy(course / "personal/hw1/ada/hw1.ipynb", work)
    for path in (work, *work.parents[:2], work / "hw1.ipynb"):
        os.chown(path, TEACHER, TEACHER)
    grade = "grader", "grade", "hw1", *at, "--unsandboxed", "--workers", 1, "--force"
    by(ASSISTANT, grade, codes=[2], cwd=place)  # the course is its owner's alone
    by(TEACHER, ("grader", "share", STAFF, *at), codes=[0])
    feedback = "nbgrader", "generate_feedback", "hw1", "--force"
    by(ASSISTANT, grade, feedback, ("grader", "stats", "hw1", *at), codes=[3, 0, 0])
    by(TEACHER, grade, feedback, codes=[3, 0])
    by(ASSISTANT, grade, codes=[3])
    assert not course.stat().st_mode & 0o007


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

"""The cage: what student code cannot reach, and that the worker survives whatever it does. As root,
without privileges, and without a cage.
"""

import os
import sys
import time
import tomllib
from pathlib import Path

import pytest

from tests.grader.courses import REPOSITORY
from tests.grader.sandbox.jobs import (
    REFUSED,
    answer,
    caged,
    descendants,
    elsewhere,
    job,
    still_serves,
    wait_until,
)

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="the cage is Linux")


# -- out of reach: each is a question to which the cage answers False

CELLS = tomllib.loads(Path(__file__).with_name("cells.toml").read_text())
REACH = {
    name: text.replace("$REPOSITORY", str(REPOSITORY)).replace("$HOME", str(Path.home()))
    for name, text in CELLS["reach"].items()
}
SETUP = """
import ctypes, os, socket
libc = ctypes.CDLL(None)
def works(f, *args):
    try:
        f(*args)
    except OSError:
        return False
    return True
"""


@pytest.fixture(scope="module")
def reached(harvester):
    """{what: its receipt}, each run in a cage of its own; the last one twice."""
    os.environ["SOME_SECRET_TOKEN"] = "x"
    out = {
        name: caged(harvester, cell, setup=SETUP)["receipts"]["0/1"]
        for name, cell in [*REACH.items(), *list(REACH.items())[-1:]]
    }
    del os.environ["SOME_SECRET_TOKEN"]
    return out


@pytest.mark.parametrize("what", REACH)
def test_student_code_does_not_reach(reached, what):
    given = reached[what]
    assert given["answers"].get("x") in (0.0, None) or "got False" in given["faults"]["x"], given
    assert given["error"] or given["answers"].get("x") == 0.0 or given["faults"], given
    assert "got True" not in str(given["faults"])


def test_a_worked_example_can_be_imported(harvester):
    text = "from newton_euler.chapters.examples.ch10 import rotor_moment\n"
    assert answer(harvester, text + "x = rotor_moment(1000.0, 0.5, 20.0, 100.0)") == 2000.0


def test_neither_course_nor_submissions_nor_key_nor_exchange_are_there(harvester, course):
    places = str(course.path), str(course.path.parent)
    assert answer(harvester, f"import os; x = sum(map(os.path.exists, {places}))") == 0.0
    cell = """
    import os
    x = 0
    for folder, _, files in os.walk("/"):
        x += sum(f in ("p16.yaml", ".course_secret", "p16.py") for f in files)
        x += folder.endswith("share/nbgrader/exchange")
    """
    assert answer(harvester, cell, seconds=40, cell_seconds=30) == 0.0


# -- what a submission may do to itself and nobody else

ENDINGS = CELLS["endings"]


# what stops the cells that do not end by themselves; the others have enough time
AT_THE_DEADLINE = {"endless loop that catches everything"}
AT_THE_LIMIT_OF_THE_CELL = {"no death with its parent", "endless loop", "endless in C", "sleeps"}
# signals that reach nobody, or whose effect the first process undoes
CONTINUED = {"signals pid 1", "stops itself", "stops its group"}
# the fork bomb: the first process may be stopped at the limit of the cell before its copies fill up
AT_EITHER = {"fork bomb", "recursion without end", "memory in pieces"}


@pytest.mark.parametrize("what", ENDINGS)
def test_the_worker_survives_and_leaves_nothing_running(harvester, what):
    before = descendants()
    seconds = 1 if what in AT_THE_DEADLINE | AT_EITHER else 30
    cell_seconds = 0.3 if what in AT_THE_DEADLINE | AT_THE_LIMIT_OF_THE_CELL | AT_EITHER else 10
    reply = caged(harvester, ENDINGS[what], seconds=seconds, cell_seconds=cell_seconds)
    if what in AT_THE_DEADLINE:
        assert (reply["ended"], reply["receipts"]) == ("stopped after 1 s", {})
    if what in AT_THE_LIMIT_OF_THE_CELL:
        assert reply["ended"] == "done"
        assert "ran longer than 0.3 s" in reply["receipts"]["0/1"]["error"]
    if what == "floods the receipts":
        assert reply["ended"] == "stopped after 1048576 bytes of output"
    if what in CONTINUED:
        assert (reply["ended"], reply["receipts"]["0/1"]["answers"]) == ("done", {"x": 1.0})
    assert still_serves(harvester)
    assert wait_until(lambda: descendants() <= before)


def test_after_a_deadline_of_a_cell_or_notebook_or_its_end_the_other_answers_count(harvester):
    reply = caged(harvester, "while True: pass", "x = 2", seconds=10, cell_seconds=0.5)
    assert "ran longer than 0.5 s" in reply["receipts"]["0/1"]["error"]
    assert reply["receipts"]["0/2"]["answers"] == {"x": 2.0}
    endless = ENDINGS["endless loop that catches everything"]
    reply = caged(harvester, "x = 1", endless, "x = 3", seconds=2, cell_seconds=0.5)
    assert reply["receipts"]["0/1"]["answers"] == {"x": 1.0}
    assert "0/3" not in reply["receipts"]
    assert reply["ended"] == "stopped after 2 s"
    assert set(caged(harvester, "x = 1", "import os; os._exit(0)", "x = 3")["receipts"]) == {"0/1"}


# -- without privileges, and without a cage


def test_without_privileges_the_cage_is_as_tight():
    jobs = [job(c, setup=SETUP) for c in REACH.values()]
    for what, reply in zip(REACH, elsewhere(jobs, ordinary=True), strict=True):
        if str(reply).startswith(REFUSED):
            pytest.skip(reply)
        given = reply["receipts"]["0/1"]
        assert given["answers"].get("x") in (0.0, None), (what, given)
        assert "got True" not in str(given["faults"]), (what, given)
    assert not (REPOSITORY / "newton_euler/probe").exists()


@pytest.mark.slow
def test_without_privileges_the_worker_survives_too():
    # no fork bomb where this user is root outside: the kernel then grants any number of
    # processes
    names = [
        "kills everybody", "kills its group", "stops its group", "signals pid 1",
        "no death with its parent", "daemon", "stops itself", "endless in C", "floods the receipts",
        "memory in pieces",
    ]  # fmt: skip
    assert after_each(names, ordinary=True) == ([{"x": 42.0}] * len(names), set())


def after_each(names, **options):
    """What a worker in another process answers after each of these cells, and what stays behind."""
    before = descendants()
    jobs = [job(x, setup="import os") for n in names for x in (ENDINGS[n], "x = 42")]
    replies = elsewhere(jobs, **options)
    wait_until(lambda: descendants() <= before)
    return [r["receipts"]["0/1"]["answers"] for r in replies[1::2]], descendants() - before


def test_without_a_cage_the_reply_says_so_and_why():
    (reply,) = elsewhere([job("x = 42")], sandbox=False)
    assert reply["sandbox"] == "unsandboxed: asked for"
    assert reply["receipts"]["0/1"]["answers"] == {"x": 42.0}


def test_where_the_kernel_refuses_nothing_is_run_and_the_error_names_its_reason():
    # root without CAP_SYS_ADMIN: what a container gives; no new privileges, so no user namespace
    if os.geteuid() != 0:
        pytest.skip("needs root to give something up")
    drop = "import ctypes; ctypes.CDLL(None).prctl(24, 21, 0, 0, 0); "
    drop += "d = (ctypes.c_uint32 * 6)(); ctypes.CDLL(None).capset((ctypes.c_uint32 * 2)(0x20080522, 0), d)"
    (error,) = elsewhere([job("open('/tmp/ran', 'w')")], before=drop)
    assert error.startswith(REFUSED + " ([Errno 1] Operation not permitted), so nothing was run.")
    assert not Path("/tmp/ran").exists()


def test_where_the_namespaces_run_out_in_the_middle_the_job_is_refused_too():
    """In a user namespace of its own, where the limit on nested namespaces can be set."""
    before = """
import ctypes, os
ids = os.getuid(), os.getgid()
if ctypes.CDLL(None).unshare(0x10000000):
    sys.exit("no user namespaces")
for name, text in (("setgroups", "deny"), ("uid_map", f"12345 {ids[0]} 1"), ("gid_map", f"12345 {ids[1]} 1")):
    open("/proc/self/" + name, "w").write(text)
"""
    between = "open('/proc/sys/user/max_user_namespaces', 'w').write('0')"
    first, second = elsewhere([job("x = 1"), job("x = 2")], before=before, between=between)
    assert first["receipts"]["0/1"]["answers"] == {"x": 1.0}
    assert second.startswith(REFUSED + " ([Errno 28] No space left on device), so nothing was run.")


@pytest.mark.slow
@pytest.mark.skipif(
    os.geteuid() != 0,
    reason="without a cage and without root, student code has the instructor's own rights",
)
def test_without_a_cage_the_worker_survives_and_nothing_is_left_running():
    names = [
        "daemon", "fork bomb", "no death with its parent", "kills everybody", "stops itself",
        "floods the receipts", "endless loop that catches everything",
    ]  # fmt: skip
    assert after_each(names, sandbox=False) == ([{"x": 42.0}] * len(names), set())
    time.sleep(0.1)
    found = [p.read_text(errors="replace") for p in Path("/proc").glob("[0-9]*/status")]
    assert not [text for text in found if "Uid:\t10" in text and "python" in text[:40]]


def test_a_place_that_is_shown_is_never_the_whole_of_usr_or_a_home():
    from grader.sandbox.cage.isolation import readable_places

    places, _ = readable_places()
    assert not {"/", "/usr", "/usr/local", str(Path.home()), str(REPOSITORY)} & set(places)

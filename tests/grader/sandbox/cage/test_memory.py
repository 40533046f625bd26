"""Control groups: where one is made, what is written, what is left. On folders that look like the
kernel's, since few machines let a test make one.
"""

import os
import re
import subprocess
import sys
from pathlib import Path

import pytest

from grader.sandbox.cage import memory
from grader.sandbox.cage.memory import PER_TEST, TOTAL, Group, MemoryWatch

WRITTEN = {"memory.swap.max": "0", "memory.oom.group": "1", "pids.max": "400", "cgroup.procs": "0"}
WRITTEN["memory.max"] = str(TOTAL + 2 * PER_TEST)


@pytest.fixture
def machine(tmp_path):
    """(the folder that stands for /proc/self, the root of the groups)."""
    process, root = tmp_path / "self", tmp_path / "groups"
    own = root / "user.slice/shell.scope"
    own.mkdir(parents=True)
    process.mkdir()
    (process / "mountinfo").write_text(f"30 23 0:26 / {root} rw shared:9 - cgroup2 cgroup2 rw\n")
    (process / "cgroup").write_text("4:memory:/old\n0::/user.slice/shell.scope\n")
    for folder in (root, own.parent, own):
        (folder / "cgroup.subtree_control").write_text("cpu memory pids\n")
    return process, root


def test_the_group_is_made_beside_that_of_the_grader_or_in_the_root(machine):
    process, root = machine
    group = Group.make(processes=str(process))
    assert group.path == str(root / f"user.slice/newton-euler-{os.getpid()}")
    group.enter()
    group.allow(tests=2)
    assert {name: (Path(group.path) / name).read_text() for name in WRITTEN} == WRITTEN
    process, root = machine
    (process / "cgroup").write_text("0::/\n")
    assert Group.make(processes=str(process)).path == str(root / f"newton-euler-{os.getpid()}")


REFUSED = {
    "no cgroup v2": lambda process, root: (process / "mountinfo").write_text(""),
    "memory is of cgroup v1": lambda process, root: (
        root / "user.slice/cgroup.subtree_control"
    ).write_text("cpu pids"),
    "no right to make one": lambda process, root: (process / "cgroup").unlink(),
}


@pytest.mark.parametrize("why", REFUSED)
def test_where_no_group_can_be_made_there_is_none(machine, why):
    REFUSED[why](*machine)
    assert Group.make(processes=str(machine[0])) is None


def test_groups_of_killed_workers_are_removed_and_others_stay(machine):
    process, root = machine
    dead, living = (root / "user.slice" / f"newton-euler-{n}" for n in (2**22 + 1, os.getppid()))
    dead.mkdir(), living.mkdir()
    Group.make(processes=str(process))
    assert not dead.exists()
    assert living.exists()


def test_kills_are_read_from_the_events(tmp_path):
    group = Group(str(tmp_path))
    assert group.kills() == 0
    (tmp_path / "memory.events").write_text("low 0\noom 2\noom_kill 3\n")
    assert group.kills() == 3


@pytest.mark.parametrize("tests", [0, 3])
def test_each_test_of_a_submission_may_hold_some_memory_of_its_own(monkeypatch, tests):
    held = TOTAL + tests * PER_TEST
    monkeypatch.setattr(memory, "used_by", lambda pids, enough: held)
    assert not MemoryWatch(tests).exceeded()
    held += 1
    assert MemoryWatch(tests).exceeded()


def test_private_memory_moves_into_large_pages():
    """A fork copies the page table: for a worker in large pages it takes half the time."""
    if sys.platform != "linux" or tuple(map(int, os.uname().release.split(".")[:2])) < (6, 1):
        pytest.skip("large pages are made by Linux 6.1 and later")
    code = (
        "import sys; sys.path.insert(0, sys.argv[1]); from cage.memory import use_large_pages\n"
        "held = bytearray(b'x') * 2**24\nuse_large_pages()\n"
        "print(open('/proc/self/smaps_rollup').read())"
    )
    folder = Path(memory.__file__).parents[1]
    done = subprocess.run(
        [sys.executable, "-c", code, folder], capture_output=True, text=True, check=True
    )
    assert int(re.search(r"AnonHugePages: +(\d+)", done.stdout)[1]) >= 2**13, done

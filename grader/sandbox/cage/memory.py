"""The memory of all processes of a submission together: limited by a cgroup where one can be made,
and watched from outside everywhere.
"""

import contextlib
import os
import re
import resource
import time

from . import watch

TOTAL = 3 * 2**30  # bytes, of all processes of a submission
PER_TEST = 2**25  # bytes on top, for what a copy does not share with the student's process
PROCESSES = 400  # far above their own limit, which counts by user
FIRST_LOOK, PAUSE = 0.1, 0.05  # seconds; most notebooks have ended before the first look


class Watch:
    """Looks now and then at the sum of the memory of all descendants of this process."""

    def __init__(self, tests=0):
        self.total = TOTAL + tests * PER_TEST
        self.next = time.monotonic() + FIRST_LOOK

    def exceeded(self):
        """True if the descendants hold more than the total; the pause until the next look grows
        with the cost of this one.
        """
        start = time.monotonic()
        over = used_by(watch.descendants(), self.total) > self.total
        self.next = time.monotonic() + max(PAUSE, 10 * (time.monotonic() - start))
        return over


def used_by(pids, enough):
    """Bytes that these processes hold. What they share counts once for each; only if that exceeds
    ``enough`` it is shared out, since that takes the kernel milliseconds for each process.
    """
    resident = sum(map(_resident, pids))
    return resident if resident <= enough else sum(map(_proportional, pids))


def _resident(pid):
    try:
        with open(f"/proc/{pid}/statm") as f:
            return int(f.read().split()[1]) * resource.getpagesize()
    except (OSError, IndexError):
        return 0


def _proportional(pid):
    try:
        with open(f"/proc/{pid}/smaps_rollup") as f:
            return 1024 * int(re.search(r"(?m)^Pss: +(\d+)", f.read())[1])
    except (OSError, TypeError):
        return _resident(pid)  # it has forbidden others to look


class Group:
    """A control group (cgroup v2) of a worker, for one submission after the other."""

    def __init__(self, path):
        self.path = path

    @classmethod
    def make(cls, processes="/proc/self"):
        """A new group beside the one of this process; None where none can be made, as in most
        containers and in cgroup v1.
        """
        try:
            parent = _parent(processes)
            _sweep(parent)
            group = cls(os.path.join(parent, f"newton-euler-{os.getpid()}"))
            os.mkdir(group.path)
        except OSError:
            return None
        try:
            group.allow(tests=0)
            group._write("pids.max", PROCESSES)
            group._write("memory.oom.group", 1)
        except OSError:
            group.remove()
            return None
        with contextlib.suppress(OSError):  # a machine without swap
            group._write("memory.swap.max", 0)
        return group

    def _write(self, name, value):
        with open(os.path.join(self.path, name), "w") as f:
            f.write(str(value))

    def allow(self, tests):
        """Set the limit for a submission with so many tests."""
        self._write("memory.max", TOTAL + tests * PER_TEST)

    def enter(self):
        """Put this process, and all that it will fork, into the group."""
        self._write("cgroup.procs", 0)

    def kills(self):
        """How many processes the kernel has killed for their memory, since the group was made."""
        with contextlib.suppress(OSError), open(os.path.join(self.path, "memory.events")) as f:
            return int(dict(line.split() for line in f).get("oom_kill", 0))
        return 0

    def kill(self):
        """Kill all processes in the group at once."""
        with contextlib.suppress(OSError):  # before Linux 5.14
            self._write("cgroup.kill", 1)

    def remove(self):
        """Remove the group, which must be empty."""
        with contextlib.suppress(OSError):
            os.rmdir(self.path)


def _parent(processes):
    """The folder in which a group with a limit of memory can be made: that of this process if it
    is the root, else the one above it, since a group with processes has no groups with limits.
    """
    with open(f"{processes}/mountinfo") as f:
        mounts = [line.split() for line in f if " - cgroup2 " in line]
    with open(f"{processes}/cgroup") as f:
        own = next((line[3:].strip() for line in f if line.startswith("0::")), None)
    if not mounts or own is None:
        raise OSError("no cgroup v2")
    folder = os.path.dirname(mounts[0][4] + own.rstrip("/")) if own != "/" else mounts[0][4]
    with open(os.path.join(folder, "cgroup.subtree_control")) as f:
        if not {"memory", "pids"} <= set(f.read().split()):
            raise OSError("no limits of memory below " + folder)
    return folder


def _sweep(parent):
    """Remove the groups of workers that were killed."""
    for name in os.listdir(parent):
        found = re.fullmatch(r"newton-euler-(\d+)", name)
        if found and not os.path.isdir(f"/proc/{found[1]}"):
            Group(os.path.join(parent, name)).remove()

"""The memory of all processes of a submission together: limited by a cgroup, and watched; and that
of the worker, in large pages.
"""

import contextlib
import ctypes
import os
import re
import resource
import time
from collections.abc import Collection

from . import watch

TOTAL = 3 * 2**30  # bytes, of all processes of a submission
PER_TEST = 2**25  # bytes more for each test, whose process shares the rest with the student's
PROCESSES = 400  # the most in a group; far above the limit for each user
LARGE_PAGE, MADV_COLLAPSE = 2**21, 25
FIRST_LOOK, PAUSE = 0.1, 0.05  # seconds; most notebooks have ended before the first look


def use_large_pages() -> None:
    """Move the private memory of this process into large pages, as far as the system can (Linux
    6.1): a fork then copies a tenth of the page table.
    """
    with contextlib.suppress(OSError), open("/proc/self/maps", "rb") as f:
        advise = ctypes.CDLL(None).madvise
        for line in f.read().splitlines():
            addresses, rights, *_, inode = line.split()[:5]
            if rights == b"rw-p" and inode == b"0":
                start, end = (int(x, 16) for x in addresses.split(b"-"))
                for page in range(-(-start // LARGE_PAGE), end // LARGE_PAGE):
                    advise(ctypes.c_void_p(page * LARGE_PAGE), LARGE_PAGE, MADV_COLLAPSE)


class MemoryWatch:
    """Checks at intervals the memory of all descendants of this process together."""

    def __init__(self, tests: int = 0) -> None:
        self.total = TOTAL + tests * PER_TEST
        self.next = time.monotonic() + FIRST_LOOK

    def exceeded(self) -> bool:
        """Whether the descendants hold too much; costly looks are made less often."""
        start = time.monotonic()
        over = used_by(watch.descendants(), self.total) > self.total
        self.next = time.monotonic() + max(PAUSE, 10 * (time.monotonic() - start))
        return over


def used_by(pids: Collection[int], enough: int) -> int:
    """Bytes that these processes hold. Shared memory counts fully for each process; only where that
    exceeds ``enough`` is it apportioned, which costs the kernel milliseconds for each process.
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
        return _resident(pid)  # the process is not readable by others


class Group:
    """A control group (cgroup v2) of a worker, for one submission after another."""

    def __init__(self, path: str) -> None:
        self.path = path

    @classmethod
    def make(cls, processes: str = "/proc/self") -> "Group | None":
        """A new group; None where none can be made: in most containers and in cgroup v1."""
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

    def allow(self, tests: int) -> None:
        """Set the limit for a submission with this number of tests."""
        self._write("memory.max", TOTAL + tests * PER_TEST)

    def enter(self) -> None:
        """Put this process, and all that it will fork, into the group."""
        self._write("cgroup.procs", 0)

    def kills(self) -> int:
        """The number of processes that the kernel has killed for lack of memory so far."""
        with contextlib.suppress(OSError), open(os.path.join(self.path, "memory.events")) as f:
            return int(dict(line.split() for line in f).get("oom_kill", 0))
        return 0

    def kill(self) -> None:
        """Kill all processes in the group at once."""
        with contextlib.suppress(OSError):  # before Linux 5.14
            self._write("cgroup.kill", 1)

    def remove(self) -> None:
        """Remove the group, which must be empty."""
        with contextlib.suppress(OSError):
            os.rmdir(self.path)


def _parent(processes):
    """The folder in which a group with a memory limit can be made: that of this process if it is
    the root, else its parent, since below a group with processes there are no limits.
    """
    with open(f"{processes}/mountinfo", errors="surrogateescape") as f:
        mounts = [line.split() for line in f if " - cgroup2 " in line]
    with open(f"{processes}/cgroup", errors="surrogateescape") as f:
        own = next((line[3:].strip() for line in f if line.startswith("0::")), None)
    if not mounts or own is None:
        raise OSError("no cgroup v2")
    folder = os.path.dirname(mounts[0][4] + own.rstrip("/")) if own != "/" else mounts[0][4]
    with open(os.path.join(folder, "cgroup.subtree_control")) as f:
        if not {"memory", "pids"} <= set(f.read().split()):
            raise OSError("no memory limits below " + folder)
    return folder


def _sweep(parent):
    """Remove the groups of workers that were killed."""
    for name in os.listdir(parent):
        found = re.fullmatch(r"newton-euler-(\d+)", name)
        if found and not os.path.isdir(f"/proc/{found[1]}"):
            Group(os.path.join(parent, name)).remove()

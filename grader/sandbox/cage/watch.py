"""Finds, freezes and kills the descendants of this process."""

import contextlib
import ctypes
import os
import signal
import sys

PR_SET_PDEATHSIG, PR_SET_CHILD_SUBREAPER = 1, 36


def adopt_orphans() -> None:
    """Make this process the new parent of every descendant whose parent ends, daemons included."""
    if sys.platform == "linux":
        ctypes.CDLL(None).prctl(PR_SET_CHILD_SUBREAPER, 1, 0, 0, 0)


def die_with(parent: int) -> None:
    """Have the kernel kill this process when ``parent``, which forked it, has ended."""
    if sys.platform == "linux":
        ctypes.CDLL(None).prctl(PR_SET_PDEATHSIG, signal.SIGKILL, 0, 0, 0)
        if os.getppid() not in (parent, 0):  # it ended before the call; 0 is in another namespace
            os._exit(1)


def end(pid: int) -> None:
    """Kill the child and all descendants of this process, and wait for them."""
    rounds = 0
    while True:
        if rounds == 5:
            _freeze()
        for child in (_children_of(os.getpid()) if rounds < 5 else descendants()) or [pid]:
            with contextlib.suppress(ProcessLookupError, PermissionError):
                os.kill(child, signal.SIGKILL)
        try:
            os.waitpid(-1, 0)
        except ChildProcessError:
            return
        rounds += 1


def _freeze():
    """Stop all descendants until none runs that could start another; killing the processes of a
    fork bomb one by one only makes room for more.
    """
    quiet = 0
    while quiet < 3:
        running = [p for p, state in descendants().items() if state not in "TtZX"]
        for p in running:
            with contextlib.suppress(ProcessLookupError, PermissionError):
                os.kill(p, signal.SIGSTOP)
        quiet = 0 if running else quiet + 1


def descendants() -> dict[int, str]:
    """{pid: state} of all descendants of this process."""
    if not os.path.isdir("/proc/self/task"):
        return {}
    below: dict[int, str] = {}
    level = _children_of(os.getpid())
    while level:
        below.update((pid, state) for pid in level if (state := _state(pid)))
        level = [pid for parent in level for pid in _children_of(parent) if pid not in below]
    return below


def _children_of(pid):
    found = []
    with contextlib.suppress(OSError):
        for thread in os.listdir(f"/proc/{pid}/task"):
            with open(f"/proc/{pid}/task/{thread}/children") as f:
                found += [int(x) for x in f.read().split()]
    return found


def _state(pid):
    try:
        with open(f"/proc/{pid}/stat", errors="replace") as f:  # a name may be any bytes
            return f.read().rpartition(")")[2].split()[0]
    except (OSError, IndexError):
        return ""

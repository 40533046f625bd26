"""Imports what student code may use, then waits for jobs. For each job it forks a chain of
processes, watches it, and ends it with all its descendants:

    this process   reads no job and no result: what one student wrote cannot be found in the
                   memory that the next one gets a copy of
    the first      pid 1 of the namespace: builds the root, keeps the time, runs no student code
    the student    unprivileged; reads the job, runs the cells, writes receipts into a pipe
    the copies     of the student, one for each test, wait for the text of the test

A job arrives as a line of JSON ({"seconds", "cell_seconds", "sandbox", "tests"}) with descriptors:
the job, the receipts, the state, and a socket for each test. The grader reads the pipes itself.
"""

import contextlib
import gc
import itertools
import json
import os
import select
import signal
import socket
import time

from . import calls, isolation, libraries, rehearsal, watch
from .cells import Submission
from .memory import TOTAL, Group, MemoryWatch, use_large_pages

GRACE = 5.0  # seconds beyond its limits after which a job is ended from outside
TOO_MUCH = f"stopped at {TOTAL / 2**30:g} GB of memory"
END = b"end\n"  # sent by the grader at the end of each job
SOME = 10  # jobs after which moving the memory into large pages pays off
MOST_TESTS = 200  # the most in one notebook; the kernel passes at most 253 descriptors at a time


def main(fd: int) -> None:
    """Serve jobs over the socket ``fd`` until the grader closes it."""
    libraries.load()
    rehearsal.rehearse()
    libraries.remember()
    watch.adopt_orphans()
    gc.collect()
    gc.freeze()
    calls.program()  # both are cached: made once, not after each fork
    isolation.readable_places()
    control, group = socket.socket(fileno=fd), Group.make()
    try:
        for count in itertools.count(1):
            request = _receive(control)
            if not request or not _serve(control, group, *request):
                break
            if count == SOME:
                use_large_pages()
    finally:
        if group:
            group.remove()
    os._exit(0)  # an orderly exit of the libraries would cost more than a notebook


def _receive(control):
    """(job, descriptors) of the next request; None after the last."""
    data, fds = b"", []
    with contextlib.suppress(OSError):  # the grader may have gone without reading the last reply
        while not data.endswith(b"\n"):
            part, more, _, _ = socket.recv_fds(control, 4096, MOST_TESTS + 10)
            fds += more
            if not part:
                return None
            data += part
        return json.loads(data), fds
    return None


def _serve(control, group, job, fds):
    """Run one job and reply how it ended; returns False if the grader is gone."""
    libraries.load_more(job["libraries"])
    worker = os.getpid()
    # a user of its own for each worker: limits that count by user do not affect other workers
    job = {**job, "uid": 2**20 + worker, "ids": (os.geteuid(), os.getegid())}
    kills, pid = group.kills() if group else 0, None
    try:
        if group:
            group.allow(job["tests"])
        pid = isolation.fork_into_namespaces() if job["sandbox"] else os.fork()
    except OSError as error:
        _say(fds[2], refused=str(error))
    if pid == 0:
        try:
            watch.die_with(worker)
            control.close()
            _first(job, group, *fds[:3], fds[3:])
        finally:
            os._exit(1)
    for fd in fds:
        os.close(fd)
    why = _wait(control, MemoryWatch(job["tests"]), time.monotonic() + 2 * job["seconds"] + GRACE)
    if group:
        group.kill()
        if group.kills() > kills:
            why = TOO_MUCH
    if pid is not None:
        watch.end(pid)
    with contextlib.suppress(OSError):  # the grader may be gone
        control.sendall(json.dumps({"ended": why}).encode() + b"\n")
        return control.recv(len(END)) == END  # also after a job that ended by itself
    return False


def _wait(control, memory, deadline):
    """Why a job has to be ended: "" if the grader asks for it, or is gone."""
    while (now := time.monotonic()) < deadline:
        if select.select([control], [], [], max(min(memory.next, deadline) - now, 0))[0]:
            return ""
        if time.monotonic() >= memory.next and memory.exceeded():
            return TOO_MUCH
    return "stopped from outside"


# -- in the chain


def _first(job, group, work, receipts, state, tests):
    """Isolate this process, fork the student's, keep its time, await its copies; never returns."""
    try:
        _isolate(job, group, (work, receipts, state, *tests))
    except OSError as error:
        _refuse(state, error)
    # pid 1 receives no signal for which it has no handler: Python installs one for SIGINT
    signal.signal(signal.SIGINT, signal.SIG_DFL)
    signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGCHLD})
    first = os.getpid()
    student = os.fork()
    if student == 0:
        try:
            signal.pthread_sigmask(signal.SIG_UNBLOCK, {signal.SIGCHLD})
            _student(job, work, receipts, state, tests, first)
        finally:
            os._exit(0)
    isolation.close_all_but(state)
    ended = _reaped(student, time.monotonic() + job["seconds"])
    if not ended:
        os.kill(student, signal.SIGKILL)
    _say(state, ended="done" if ended else f"stopped after {job['seconds']:g} s")
    if tests:
        with contextlib.suppress(ChildProcessError):
            while True:
                os.waitpid(-1, 0)
    os._exit(0)


def _isolate(job, group, files):
    """Put this process, and all that it will fork, into the cage."""
    if job["sandbox"]:
        isolation.claim_namespaces(*job["ids"])
    if group:
        group.enter()
    os.setsid()  # a signal to the student's process group reaches no other process
    isolation.join_keyring()
    _drop_files(*files)
    job["used"] = isolation.memory_in_use()
    if job["sandbox"]:
        isolation.forbid_shared_memory()
        job["proc"] = isolation.open_proc()
        isolation.build_root()
    else:
        watch.adopt_orphans()
        os.chdir("/tmp")  # where students may write


def _drop_files(*kept):
    null = os.open(os.devnull, os.O_RDWR)
    for fd in (0, 1, 2):
        os.dup2(null, fd)
    isolation.close_all_but(*kept)


def _say(state, **record):
    with contextlib.suppress(OSError):  # the grader may be gone
        os.write(state, json.dumps(record).encode() + b"\n")


def _refuse(state, error):
    _say(state, refused=str(error)[:300])
    os._exit(3)


def _child_or(seconds):
    """Wait until the state of a child changes, at most for ``seconds``."""
    if hasattr(signal, "sigtimedwait"):
        signal.sigtimedwait({signal.SIGCHLD}, seconds)
    else:  # macOS
        time.sleep(min(seconds, 0.01))


def _give_up_rights(job, tests, first):
    """Take every right from this process except to run the cells."""
    os.setsid()
    isolation.limit(job["seconds"], job["used"], tests)
    isolation.become(job["uid"])
    if job["sandbox"]:
        isolation.forbid_user_namespaces(job["proc"])
    isolation.drop_capabilities()
    calls.forbid()
    watch.die_with(first)


def _reaped(student, deadline):
    """Wait for the student's process, and reap all others that end; False at the deadline."""
    while (left := deadline - time.monotonic()) > 0:
        pid, status = os.waitpid(-1, os.WNOHANG | os.WUNTRACED)
        if pid and os.WIFSTOPPED(status):
            os.kill(pid, signal.SIGCONT)
        elif pid == student:
            return True
        elif not pid:
            _child_or(left)
    return False


def _student(job, work, receipts, state, tests, first):
    """Give up all rights and run the cells of the job."""
    try:
        _give_up_rights(job, len(tests), first)
    except OSError as error:
        _refuse(state, error)
    _say(state, sandbox="namespaces" if job["sandbox"] else "unsandboxed: asked for")
    os.close(state)
    with open(work, "rb") as f:
        cells = json.loads(f.read())
    Submission(job["cell_seconds"], lambda line: _write(receipts, line), tests).run(cells)


def _write(fd, data):
    while data:
        data = data[os.write(fd, data) :]

"""Each wall of the cage by itself, without those around it: in a fork of this process."""

import ctypes
import errno
import os
import resource
import signal
import socket
import sys
import threading
from pathlib import Path

import pytest

from grader.sandbox.cage import calls, isolation, serve
from tests.grader.sandbox.jobs import answer

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="the cage is Linux")
KEYCTL, ADD_KEY = {"x86_64": (250, 248), "aarch64": (219, 217)}.get(os.uname().machine, (0, 0))
SESSION, SEARCH = -3, 10


def in_a_fork(function):
    """The number that a function returns in a fork; 128 plus errno for a system error."""
    pid = os.fork()
    if pid == 0:
        try:
            os._exit(function())
        except OSError as error:
            os._exit(128 + (error.errno or 0))
        finally:
            os._exit(255)
    return os.waitstatus_to_exitcode(os.waitpid(pid, 0)[1])


def test_a_key_of_the_instructors_session_is_not_found_after_joining_another():
    libc = ctypes.CDLL(None)
    finds_key = lambda: libc.syscall(KEYCTL, SEARCH, SESSION, b"user", b"newton-euler", 0) > 0

    def search():
        isolation.join_keyring()  # this test's own, so that nothing is left in the user's
        if libc.syscall(ADD_KEY, b"user", b"newton-euler", b"secret", 6, SESSION) < 0:
            return 77
        before = finds_key()
        isolation.join_keyring()
        return 10 * before + finds_key()

    if (found := in_a_fork(search)) == 77:
        pytest.skip("this kernel has no keyrings")
    assert found == 10


def test_before_system_calls_are_filtered_neither_keys_nor_shared_memory_are_there():
    """In namespaces of its own, isolated as a submission is."""
    libc, ids = ctypes.CDLL(None), (os.geteuid(), os.getegid())

    def isolated():
        serve._isolate({"sandbox": True, "ids": ids}, None, ())
        key = libc.syscall(KEYCTL, SEARCH, SESSION, b"user", b"newton-euler", 0) > 0
        segment, queue = (f >= 0 for f in (libc.shmget(0, 4096, 0o1600), libc.msgget(0, 0o1600)))
        return key + 2 * segment + 4 * queue

    def first():
        isolation.join_keyring()
        libc.syscall(ADD_KEY, b"user", b"newton-euler", b"secret", 6, SESSION)
        if (pid := isolation.fork_into_namespaces()) == 0:
            os._exit(in_a_fork(isolated))
        return os.waitstatus_to_exitcode(os.waitpid(pid, 0)[1])

    if (found := in_a_fork(first)) == 128 + errno.EPERM:
        pytest.skip("this kernel refuses the cage")
    assert found == 0


def test_no_user_namespace_can_be_made_below_the_last():
    def nested():
        isolation.forbid_user_namespaces(isolation.open_proc())
        return 1 if ctypes.CDLL(None).unshare(isolation.CLONE["user"]) == 0 else 7

    assert in_a_fork(nested) in (7, 128 + errno.EPERM)  # EPERM: a machine that allows none at all


def test_a_worker_in_which_a_library_has_started_threads_forks_nothing():
    stop = threading.Event()
    thread = threading.Thread(target=stop.wait)
    thread.start()
    try:
        with pytest.raises(isolation.Refused, match=r"a library has started \d+ threads"):
            isolation.fork_into_namespaces()
    finally:
        stop.set()
        thread.join()


def test_forbidden_calls_fail_and_processes_and_threads_can_still_be_started():
    if calls.library() is None:
        pytest.skip("libseccomp is not installed")

    def tries():
        isolation.drop_capabilities()
        assert calls.forbid()
        if ctypes.CDLL(None).unshare(isolation.CLONE["user"]) == 0:
            return 1
        clone = isolation.SYSCALLS[os.uname().machine]["clone"]
        flags = isolation.CLONE["user"] | signal.SIGCHLD
        made = ctypes.CDLL(None).syscall(clone, flags, None, None, None, None)
        if made >= 0:
            return 5
        try:
            socket.socket(40, socket.SOCK_STREAM)  # AF_VSOCK, which leads to the host of a VM
            return 2
        except PermissionError:
            pass
        started = []
        thread = threading.Thread(target=lambda: started.append(1))
        thread.start()
        thread.join()
        socket.socketpair()
        pid = os.fork()
        if pid == 0:
            os._exit(3)
        return 42 if started and os.waitstatus_to_exitcode(os.waitpid(pid, 0)[1]) == 3 else 4

    assert in_a_fork(tries) == 42


def test_a_program_that_is_started_gets_no_new_privileges():
    """Without the filter of system calls, which sets the same flag but needs libseccomp."""

    def privileges():
        isolation.drop_capabilities()
        status = Path("/proc/self/status").read_text()
        return 2 * ("NoNewPrivs:\t1\n" not in status) + ("CapBnd:\t" + 16 * "0" not in status)

    assert in_a_fork(privileges) == (os.geteuid() != 0)  # only root has something to give up


LIMITS = {  # of a submission of 9 s with two tests, in a process that holds 1 GB
    "processor time in seconds": (resource.RLIMIT_CPU, 10),
    "address space": (resource.RLIMIT_AS, 4 * 2**30),
    "open files": (resource.RLIMIT_NOFILE, 66),
    "processes": (resource.RLIMIT_NPROC, 66),
    "dumps of its memory": (resource.RLIMIT_CORE, 0),
}


@pytest.mark.parametrize("what", LIMITS)
def test_a_submission_is_limited_in(what):
    kind, expected = LIMITS[what]

    def limited():
        isolation.limit(9, used=2**30, tests=2)
        return resource.getrlimit(kind) != (expected, expected)

    assert in_a_fork(limited) == 0


def test_a_file_may_have_16_mb_and_not_a_byte_more(tmp_path):
    def written():
        isolation.limit(9, used=2**32)
        with open(tmp_path / "file", "wb", buffering=0) as f:
            for _ in range(17):
                f.write(bytes(2**20))
        return 0

    assert in_a_fork(written) == 128 + errno.EFBIG
    assert (tmp_path / "file").stat().st_size == 16 * 2**20


def test_an_abstract_socket_of_the_machine_is_not_there_and_a_session_of_its_own_is(harvester):
    with socket.socket(socket.AF_UNIX) as listening:
        listening.bind("\0newton-euler-test")
        listening.listen()
        text = "import socket; socket.socket(socket.AF_UNIX).connect('\\0newton-euler-test'); x = 1"
        assert "ConnectionRefusedError" in answer(harvester, text)
    text = "import os; x = os.getsid(0) == os.getpid() == os.getpgrp() and 1"
    assert answer(harvester, text) == 1


CALLS = {  # what a submission tries: each answer must be False
    "keyrings": f"x = libc.syscall({KEYCTL}, 0, -3, 0) >= 0",
    "shared memory that belongs to no process": "x = libc.shmget(0, 2**20, 0o1600) >= 0",
    "files in memory": "os.memfd_create('x'); x = 1",
    # the scheduler shares the processor among sessions
    "sessions": "pid = os.fork()\nif pid == 0:\n    os._exit(libc.setsid() > 0)\nx = os.waitpid(pid, 0)[1]",
    "sockets to the host of a virtual machine": "import socket; socket.socket(40, 1); x = 1",
}


@pytest.mark.parametrize("what", CALLS)
def test_a_submission_has_no(harvester, what):
    if calls.library() is None:
        pytest.skip("libseccomp is not installed")
    text = "import ctypes, os\nlibc = ctypes.CDLL(None)\n" + CALLS[what]
    output = answer(harvester, text)
    assert output == 0 or "got False" in str(output) or "PermissionError" in str(output), output

"""One process that runs submissions (``cage/``), and the exchange with it.

The process forks the processes of a job, watches them and ends them. It passes on the descriptors
of jobs, receipts and tests but never reads them, so a submission finds nothing of another in its
memory.
"""

import contextlib
import fcntl
import json
import os
import secrets
import selectors
import socket
import struct
import subprocess
import sys
import tempfile
import time
from collections.abc import Sequence
from pathlib import Path
from typing import Any, TypedDict

from .receipts import OUTCOME_LIMIT, OUTPUT_LIMIT, Outcome, read_outcome

_SCRIPT = Path(__file__).parent / "cage" / "__main__.py"
_PASSED_ON = ("PATH", "LANG", "LC_ALL", "TZ", "HOME")
_SET = {
    "OPENBLAS_NUM_THREADS": "1",
    "OMP_NUM_THREADS": "1",
    "MPLBACKEND": "Agg",
    "MPLCONFIGDIR": "/tmp",
    "PYTHONDONTWRITEBYTECODE": "1",
}
_PAUSE = 0.05  # seconds between two reads of the receipts
GRACE = 5.0  # seconds on top of a limit, to start a process or to end a test
END_SECONDS = 60.0  # time to end a submission that has filled the machine with processes


Job = dict[str, Any]  # a cell to run, see Harvester.run


class Limits(TypedDict):
    """How a job is run; ``libraries``: those that a cell may need besides the usual ones."""

    seconds: float
    cell_seconds: float
    sandbox: bool
    libraries: list[str]


class HarvestError(RuntimeError):
    """The sandbox failed or was refused, through no fault of a student's code: no result counts."""


class Worker:
    """A started process; ``run`` is called by one thread at a time."""

    def __init__(self) -> None:
        environment = {k: os.environ[k] for k in _PASSED_ON if k in os.environ} | _SET
        self._owed = False  # the reply to the last job
        self._control, theirs = socket.socketpair()
        with theirs:
            # a session of its own: only the grader handles Ctrl-C
            self.process = subprocess.Popen(
                [sys.executable, "-I", str(_SCRIPT), str(theirs.fileno())],
                stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, pass_fds=[theirs.fileno()],
                env=environment, cwd="/", start_new_session=True,
            )  # fmt: skip

    def close(self) -> None:
        """Signal the process that no more jobs come."""
        self._control.close()

    def stop(self) -> None:
        """Let the process end by itself, or kill it."""
        self.close()
        try:
            self.process.wait(timeout=GRACE)
        except subprocess.TimeoutExpired:
            self.kill()

    def kill(self) -> None:
        """Kill the process and all that it started."""
        self._control.close()
        self.process.kill()
        self.process.wait()

    def run(
        self, cells: Sequence[Job], texts: Sequence[str], limits: Limits
    ) -> tuple[dict[str, str], bytes, list[Outcome]]:
        """Run a job; returns ({"sandbox", "ended"}, bytes of the receipts, outcomes of the tests,
        whose ``texts`` are not in ``cells``). The process may still be ending what the job has
        started; ``settle`` waits for that.
        """
        with _Files(cells, len(texts)) as files, self._or_gone():
            line = json.dumps({**limits, "tests": len(texts)}).encode() + b"\n"
            socket.send_fds(self._control, [line], files.theirs)
            files.close_theirs()
            self._owed = True
            state, data = self._listen(files, limits["seconds"] + GRACE)
            outcomes = _run_tests(files.tests, texts, limits) if "sandbox" in state else []
            self._control.sendall(b"end\n")
        # the first process reports how the cells ended, unless it was killed first
        if "ended" not in state:
            state["ended"] = self.settle() or "stopped from outside"
        return state, data, outcomes

    def settle(self) -> str:
        """Wait until all processes of the last job have ended; returns why they were stopped."""
        if not self._owed:
            return ""
        reply = b""
        with self._or_gone():
            self._control.settimeout(END_SECONDS)
            while not reply.endswith(b"\n"):
                if not (chunk := self._control.recv(4096)):
                    raise OSError("it has closed its socket")
                reply += chunk
            self._control.settimeout(None)
        self._owed = False
        return json.loads(reply)["ended"]

    @contextlib.contextmanager
    def _or_gone(self):
        try:
            yield
        except (OSError, ValueError) as error:
            raise HarvestError(
                f"the process that runs student code is gone ({error}); its messages are above. "
                f"Check that newton_euler is installed for {sys.executable}"
            ) from error

    def _listen(self, files, seconds):
        """(the state that the first process reported, the bytes of the receipts), read until the
        student's process has ended, sends too much, or is ended from outside.
        """
        reported, data, deadline = b"", b"", time.monotonic() + seconds
        with selectors.DefaultSelector() as ready:
            ready.register(files.state, selectors.EVENT_READ)
            ready.register(self._control, selectors.EVENT_READ)
            while "ended" not in _state(reported) and len(data) <= OUTPUT_LIMIT:
                # not woken by each receipt: that would take processor time from the scorer
                found = ready.select(_PAUSE)
                data += _rest(files.receipts, OUTPUT_LIMIT + 1 - len(data))
                if any(key.fd != files.state for key, _ in found) or time.monotonic() > deadline:
                    break
                if found:
                    reported += (chunk := os.read(files.state, 4096))
                    if not chunk:
                        break
        data += _rest(files.receipts, OUTPUT_LIMIT + 1 - len(data))
        state = _state(reported)
        if len(data) > OUTPUT_LIMIT:
            state["ended"] = f"stopped after {OUTPUT_LIMIT} bytes of output"
        return state, data


class _Files:
    """The descriptors of one job: our ends, and ``theirs`` in the order that the cage expects."""

    def __init__(self, cells, tests):
        self._stack = contextlib.ExitStack()
        job = self._stack.enter_context(_file_of(json.dumps(cells).encode()))
        self.receipts, receipts_end = self._pipe()
        os.set_blocking(self.receipts, False)
        with contextlib.suppress(OSError, AttributeError):  # not every system can
            fcntl.fcntl(receipts_end, fcntl.F_SETPIPE_SZ, OUTPUT_LIMIT)
        self.state, state_end = self._pipe()
        pairs = [socket.socketpair() for _ in range(tests)]
        self.tests = [self._stack.enter_context(ours) for ours, _ in pairs]
        self._theirs = [receipts_end, state_end, *(their.detach() for _, their in pairs)]
        self.theirs = [job.fileno(), *self._theirs]

    def _pipe(self):
        ours, theirs = os.pipe()
        self._stack.callback(os.close, ours)
        return ours, theirs

    def close_theirs(self):
        """Close the ends that were passed on: a pipe ends when the last copy of its other end is
        closed.
        """
        for fd in self._theirs:
            os.close(fd)
        self._theirs = []

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close_theirs()
        self._stack.close()


def _file_of(data):
    """An unnamed file with ``data``, positioned at its start."""
    if hasattr(os, "memfd_create"):
        file = os.fdopen(os.memfd_create("job"), "w+b", buffering=0)
    else:
        file = tempfile.TemporaryFile(buffering=0)  # noqa: SIM115  # the caller closes it
    file.write(data)
    file.seek(0)
    return file


def _state(reported: bytes) -> dict[str, str]:
    """{"sandbox" or "refused", "ended"} from the complete lines received."""
    state: dict[str, str] = {}
    for line in reported.split(b"\n")[:-1]:
        state.update(json.loads(line))
    return state


def _rest(fd, most):
    """The bytes waiting in a non-blocking pipe, at most ``most``."""
    data = b""
    with contextlib.suppress(BlockingIOError):
        while len(data) < most and (chunk := os.read(fd, 65536)):
            data += chunk
    return data


def _run_tests(sockets, texts, limits):
    """The outcomes of the tests in turn; together they may take no longer than the notebook."""
    deadline = time.monotonic() + limits["seconds"]
    outcomes = []
    for pair, text in zip(sockets, texts, strict=True):
        left = min(deadline - time.monotonic(), limits["cell_seconds"] + GRACE)
        token = secrets.token_hex()  # unknown to code that ran before the text was sent
        sent = json.dumps({"token": token, "text": text}).encode()
        outcomes.append(read_outcome(_ask(pair, sent, token, left), token))
    return outcomes


def _ask(pair, text, token, seconds):
    """The reply to the text of a test: up to the line with the token, the end, or a limit."""
    data, deadline = b"", time.monotonic() + seconds
    with contextlib.suppress(OSError):  # a timeout too
        pair.settimeout(max(seconds, 0.001))
        pair.sendall(struct.pack("<I", len(text)) + text)
        while len(data) < OUTCOME_LIMIT and not (token.encode() in data and data.endswith(b"\n")):
            pair.settimeout(max(deadline - time.monotonic(), 0.001))
            if not (chunk := pair.recv(OUTCOME_LIMIT)):
                break
            data += chunk
    return data

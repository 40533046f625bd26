"""Runs submissions in sandboxed processes and returns their receipts.

A :class:`Harvester` keeps one process (``cage.py``) per worker, with the libraries imported and no
key in it. A submission costs a fork of it, not the start of an interpreter.
"""

import contextlib
import json
import os
import struct
import subprocess
import sys
from pathlib import Path
from queue import Queue

CELL_SECONDS = 10.0
SECONDS = 60.0
_PASSED_ON = ("PATH", "LANG", "LC_ALL", "TZ", "HOME")
_SET = {
    "OPENBLAS_NUM_THREADS": "1",
    "OMP_NUM_THREADS": "1",
    "MPLBACKEND": "Agg",
    "MPLCONFIGDIR": "/tmp",
    "PYTHONDONTWRITEBYTECODE": "1",
}


class HarvestError(RuntimeError):
    """The sandbox itself failed, because of a bug or a broken installation and not because of a
    student's code.
    """


class Harvester:
    """Workers that run submissions: ``with Harvester(2) as h: h.run(setup, problems)``. ``run`` may
    be called from several threads.
    """

    def __init__(self, workers=None, sandbox=True):
        self.count = workers or os.cpu_count() or 1
        self.sandbox = sandbox
        self._idle, self._all = Queue(), []

    def __enter__(self):
        for _ in range(self.count):
            self._idle.put(self._start_worker())
        return self

    def _start_worker(self):
        environment = {k: os.environ[k] for k in _PASSED_ON if k in os.environ} | _SET
        process = subprocess.Popen(
            [sys.executable, "-I", str(Path(__file__).with_name("cage.py"))],
            stdin=subprocess.PIPE, stdout=subprocess.PIPE, env=environment, cwd="/",
        )  # fmt: skip
        self._all.append(process)
        return process

    def __exit__(self, *_):
        for process in self._all:
            with contextlib.suppress(OSError):
                process.stdin.close()
        for process in self._all:
            try:
                process.wait(timeout=5)
            except subprocess.TimeoutExpired:
                process.kill()
                process.wait()
            process.stdout.close()

    def run(self, setup, problems, seconds=SECONDS, cell_seconds=CELL_SECONDS):
        """Run the answer cells of one submission; returns {"receipts": {id: record}, "sandbox",
        "ended", "seconds"}.

        problems : [{"id", "givens", "cell", "forms", "symbols"}], the sources of the cells and the
            forms in which answers are read.
        "sandbox" is "namespaces" or the reason why there is none; "ended" is "done" or the reason
        why the run was stopped. Only ids of ``problems`` are returned, each with the first record
        that was sent for it.
        """
        job = {
            "setup": setup,
            "problems": problems,
            "seconds": seconds,
            "cell_seconds": cell_seconds,
            "sandbox": self.sandbox,
        }
        process = self._idle.get()
        try:
            reply = _exchange(process, job)
        except BaseException:
            # it has ended, or may still send a part of this reply; the next job gets a new one
            process.kill()
            process = self._start_worker()
            raise
        finally:
            self._idle.put(process)
        receipts, asked = {}, {p["id"] for p in problems}
        for entry in reply["receipts"]:
            if entry["id"] in asked:
                receipts.setdefault(entry["id"], entry)
        return {**reply, "receipts": receipts}


def _exchange(process, job):
    data = json.dumps(job).encode()
    try:
        process.stdin.write(struct.pack("<I", len(data)) + data)
        process.stdin.flush()
        (length,) = struct.unpack("<I", process.stdout.read(4))
        return json.loads(process.stdout.read(length))
    except (OSError, struct.error, ValueError) as error:
        raise HarvestError(
            f"the process that runs student code is gone ({error}); its messages are "
            f"above. Check that newton_euler is installed for {sys.executable}"
        ) from error

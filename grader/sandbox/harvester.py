"""Run submissions in cages and bring back their receipts.

A :class:`Harvester` keeps clean processes (``cage.py``) ready, one per worker, that have the libraries loaded and know no key. A submission
costs a fork, not an interpreter start.
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
_KEPT = ("PATH", "LANG", "LC_ALL", "TZ", "HOME")
_CALM = {"OPENBLAS_NUM_THREADS": "1", "OMP_NUM_THREADS": "1", "MPLBACKEND": "Agg", "MPLCONFIGDIR": "/tmp", "PYTHONDONTWRITEBYTECODE": "1"}


class HarvestError(RuntimeError):
    """The cage itself failed: a bug or a broken installation, not a student's mistake."""


class Harvester:
    """Workers that run submissions: ``with Harvester(2) as h: h.run(job)``. Safe to call from several threads."""

    def __init__(self, workers=None, sandbox=True):
        self.count = workers or os.cpu_count() or 1
        self.sandbox = sandbox
        self._idle, self._all = Queue(), []

    def __enter__(self):
        for _ in range(self.count):
            self._idle.put(self._started())
        return self

    def _started(self):
        environment = {k: os.environ[k] for k in _KEPT if k in os.environ} | _CALM
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
        """Run the answer cells of one submission.

        problems : [{"id", "givens", "cell", "forms", "symbols"}], texts of cells and the forms to read answers by
        Returns {"receipts": {id: record}, "sandbox": "namespaces" or why not, "ended": "done" or why it was stopped, "seconds"}.
        Only ids that were asked for come back, each once, the first that was sent.
        """
        job = {"setup": setup, "problems": problems, "seconds": seconds, "cell_seconds": cell_seconds, "sandbox": self.sandbox}
        process = self._idle.get()
        try:
            reply = _exchange(process, job)
        except BaseException:
            process.kill()  # gone, or in the middle of a reply: the next job gets a fresh one
            process = self._started()
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
            f"the process that runs student code is gone ({error}); its messages are above. Check that newton_euler is installed for {sys.executable}"
        ) from error

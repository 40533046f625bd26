"""Runs submissions in sandboxed processes. A :class:`Harvester` keeps one process per worker, with
the libraries imported and no key in it: a submission costs a fork of it.
"""

import contextlib
import os
import re
import threading
from collections.abc import Sequence
from functools import cached_property
from pathlib import Path
from queue import Queue
from typing import Self, TypedDict

from .receipts import NOT_REACHED, Outcome, RawReceipt, read_lines
from .worker import END_SECONDS, GRACE, HarvestError, Job, Limits, Worker

CAGED = "namespaces"  # the "sandbox" of a reply whose code ran in the cage
CELL_SECONDS = 10.0
SECONDS = 60.0
# the time within which a run ends: cells, tests, leftovers
RUN_SECONDS = 2 * (SECONDS + GRACE) + END_SECONDS
MOST_TESTS = 200  # the most in one notebook
MOST_TEXT = 2**20  # characters of all cells; a chapter worked out in full has 50 000
PER_CELL = 100  # characters added for each cell, which limits the number of cells too

# cells that may need a library: the worker imports it once, before it forks a student's process;
# a cell missed here imports it itself
_NEEDS = {
    "IPython": re.compile(r"IPython|^[ \t]*[%!?>]|\?$|=[ \t]*[%!]", re.MULTILINE),
    # our integrals and motions use it
    "scipy": re.compile(r"scipy|\b(integral|integrate|prepare|motion)\b"),
}
KERNEL = Path("/proc/sys")
SETTINGS = (  # (name, value that forbids user namespaces, value that allows them)
    ("kernel.apparmor_restrict_unprivileged_userns", "1", "0"),  # Ubuntu 24.04
    ("kernel.unprivileged_userns_clone", "0", "1"),  # Debian 10
    ("user.max_user_namespaces", "0", "15000"),  # Red Hat 7
)


class Reply(TypedDict):
    """The results of a run: receipts by problem, outcomes of tests and errors of other cells by
    name; ``sandbox``: CAGED or "unsandboxed: asked for"; ``ended``: "done", or why it was stopped.
    """

    receipts: dict[str, RawReceipt]
    tests: dict[str, Outcome]
    errors: dict[str, str]
    sandbox: str
    ended: str


class Harvester:
    """Workers that run submissions: ``with Harvester(2) as h: h.run(cells)``, also from several
    threads. Only ``sandbox=False`` runs code without isolation; where the machine refuses the cage,
    :class:`HarvestError` is raised.
    """

    def __init__(self, workers: int | None = None, sandbox: bool = True) -> None:
        self.count = workers or os.cpu_count() or 1
        self.sandbox = sandbox
        self._idle: Queue[Worker] = Queue()
        self._all: list[Worker] = []
        self._starting, self._started = threading.Lock(), False

    def __enter__(self) -> Self:
        self._start()
        return self

    def _start(self):
        """Start the workers, with the first job at the latest: an unchanged class needs none."""
        with self._starting:
            for _ in range(0 if self._started else self.count):
                self._all.append(Worker())
                self._idle.put(self._all[-1])
            self._started = True

    def __exit__(self, *_: object) -> None:
        for worker in self._all:
            worker.close()  # close all before waiting for any
        for worker in self._all:
            worker.stop()

    def abandon(self) -> None:
        """End the jobs that run now: their threads get a :class:`HarvestError`."""
        for worker in self._all:
            worker.process.kill()

    @cached_property
    def sandbox_state(self) -> str:
        """ "namespaces", or "unsandboxed: asked for"; raises :class:`HarvestError` where the
        machine refuses the cage. Asked once, with an empty job.
        """
        return self.run([])["sandbox"]

    def run(
        self, cells: Sequence[Job], seconds: float = SECONDS, cell_seconds: float = CELL_SECONDS
    ) -> Reply:
        """Run the cells of one submission; raises :class:`HarvestError` if it cannot be caged.

        cells : in the order in which they run, dicts by "role":
            "run": "name", "text";
            "givens": "problem", "text", "clear" (names that are removed before);
            "answer": "problem", "text";
            "harvest": "problem", "forms", "symbols": the answers are read here;
            "test": "name", "text" (what students see), "hidden" (the full text).
        seconds : for all cells, and again for all tests; cell_seconds : for each.
        The full text of a test reaches the cage only after all cells have run. It runs in a copy
        of the process, forked where the test stands.
        """
        tests = [c for c in cells if c["role"] == "test"]
        if len(tests) > MOST_TESTS:
            raise HarvestError(
                f"the notebook has {len(tests)} cells with tests; at most {MOST_TESTS} can be run. "
                "Put several tests into one cell"
            )
        cells = [c for c in cells if c["role"] != "run" or c["text"].strip()]
        if (size := sum(len(c.get("text", "")) + PER_CELL for c in cells)) > MOST_TEXT:
            return self._not_run(len(cells), size, tests)
        limits: Limits = {
            "seconds": seconds, "cell_seconds": cell_seconds, "sandbox": self.sandbox,
            "libraries": [
                name
                for name, needs in _NEEDS.items()
                if any(needs.search(c.get("text", "")) for c in cells)
            ],
        }  # fmt: skip
        visible = [{k: v for k, v in c.items() if k != "hidden"} for c in cells]
        state, data, outcomes = self._exchange(visible, [c["hidden"] for c in tests], limits)
        problems = {c["problem"] for c in cells if c["role"] == "harvest"}
        names = {c["name"] for c in cells if c["role"] == "run"}
        receipts, errors = read_lines(data, problems, names)
        return {
            "receipts": receipts,
            "tests": {c["name"]: o for c, o in zip(tests, outcomes, strict=True)},
            "errors": errors,
            "sandbox": state["sandbox"],
            "ended": state["ended"],
        }

    def _not_run(self, count, size, tests):
        return {
            "receipts": {},
            "tests": {c["name"]: NOT_REACHED.copy() for c in tests},
            "errors": {},
            "sandbox": self.sandbox_state,
            "ended": f"not run: its {count} cells hold {size / 1e6:.1f} million characters; the "
            f"limit is {MOST_TEXT / 1e6:.1f} million",
        }

    def _exchange(self, cells, texts, limits):
        self._start()
        worker = self._idle.get()
        try:
            worker = self._settled(worker)
            state, data, outcomes = worker.run(cells, texts, limits)
        except BaseException:
            # the worker has died or is still in this job; the next job gets a new one
            worker = self._replaced(worker)
            raise
        finally:
            self._idle.put(worker)
        if "sandbox" not in state:
            why = state.get("refused", state["ended"])
            raise HarvestError(
                f"this machine refuses the cage for student code ({why}), so nothing was run. "
                f"Grade on a machine that allows user namespaces{_how_to_allow()}, or run the code "
                "without a cage, at your own risk: python -m grader grade --unsandboxed"
            )
        return state, data, outcomes

    def _settled(self, worker):
        """The worker, or a new one if it has died or could not end its last job's processes."""
        with contextlib.suppress(HarvestError):
            worker.settle()
            if worker.process.poll() is None:
                return worker
        return self._replaced(worker)

    def _replaced(self, worker):
        worker.kill()
        self._all.remove(worker)
        self._all.append(Worker())
        return self._all[-1]


def _how_to_allow():
    """The command that allows user namespaces, where a setting of this machine forbids them."""
    for setting, forbidden, allowed in SETTINGS:
        with contextlib.suppress(OSError):
            if (KERNEL / setting.replace(".", "/")).read_text().strip() == forbidden:
                return f" (to allow them here: sudo sysctl {setting}={allowed})"
    return ""

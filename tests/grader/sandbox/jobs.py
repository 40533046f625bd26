"""Jobs for the sandbox, and what runs after them."""

import json
import os
import shutil
import subprocess
import sys
import textwrap
import time
from pathlib import Path

import pytest

from grader.sandbox import HarvestError
from tests.grader.courses import REPOSITORY, environment

FORMS = {"x": "number, 1"}
REFUSED = "this machine refuses the cage for student code"


def problem(number, text, givens=""):
    """The cells of a problem that asks for x."""
    return [
        {"role": "givens", "problem": number, "text": givens, "clear": list(FORMS)},
        {"role": "answer", "problem": number, "text": textwrap.dedent(text)},
        {"role": "harvest", "problem": number, "forms": FORMS, "symbols": {}},
    ]


def own(text, name="own"):
    """A cell that belongs to no problem."""
    return {"role": "run", "name": name, "text": textwrap.dedent(text)}


def job(*texts, setup=""):
    """Problems 0/1, 0/2, ... that ask for x, with these answers."""
    cells = [own(setup, "setup")] if setup else []
    return cells + [c for n, text in enumerate(texts, 1) for c in problem(f"0/{n}", text)]


def run_caged(harvester, cells, seconds=10, cell_seconds=5):
    """The reply to a job, where the kernel allows the cage."""
    try:
        return harvester.run(cells, seconds, cell_seconds)
    except HarvestError as error:
        if not str(error).startswith(REFUSED):
            raise
        pytest.skip(str(error))


def caged(harvester, *texts, setup="", **limits):
    """The reply to a job of answers, where the kernel allows the cage."""
    return run_caged(harvester, job(*texts, setup=setup), **limits)


def answer(harvester, text, **limits):
    """The x that one answer gives; its error, if there is one."""
    (receipt,) = caged(harvester, text, **limits)["receipts"].values()
    return receipt["error"] or receipt["answers"].get("x", receipt["faults"])


def still_serves(harvester):
    reply = harvester.run(job("x = 6 * 7"), 10, 5)
    return reply["receipts"]["0/1"]["answers"] == {"x": 42.0} and reply["ended"] == "done"


def wait_until(true, seconds=20):
    """The last value of ``true``: a worker ends what a job has started after the reply."""
    end = time.monotonic() + seconds
    while not true() and time.monotonic() < end:
        time.sleep(0.02)
    return true()


def descendants(of=None):
    """The ids of all processes that descend from this one, or that one: workers and what they run."""
    parents = {}
    for entry in Path("/proc").glob("[0-9]*"):
        try:
            text = (entry / "stat").read_text()
            parents[int(entry.name)] = int(text.rpartition(")")[2].split()[1])
        except OSError:
            continue
    found, level = set(), {of or os.getpid()}
    while level:
        level = {p for p, parent in parents.items() if parent in level} - found
        found |= level
    return found


def as_ordinary_user(command):
    """The command line of ``command`` run by a user without privileges; skips where there is no such user."""
    if os.geteuid() != 0:
        return command
    user = ["setpriv", "--reuid=54321", "--regid=54321", "--clear-groups"]
    mapped = ["unshare", "-U", "--map-user=65534", "--map-group=65534"]
    # the interpreter and the repository may be readable by their owner only
    test = f"import subprocess as s; s.run([{sys.executable!r}, {str(REPOSITORY / 'grader/__init__.py')!r}], check=True)"
    for way in (user, mapped):
        if shutil.which(way[0]):
            test_run = [*way, sys.executable, "-c", test]
            if not subprocess.run(test_run, capture_output=True, check=False, cwd="/").returncode:
                return [*way, *command]
    pytest.skip("this machine has no user without privileges")


def elsewhere(jobs, sandbox=True, ordinary=False, before="", between="", seconds=(3, 1)):
    """Replies or errors of a harvester in a process of its own; ``before`` and ``between`` run there."""
    script = CHILD.format(
        repository=str(REPOSITORY), jobs=jobs, sandbox=sandbox, before=before, between=between,
        seconds=seconds,
    )  # fmt: skip
    command = [sys.executable, "-c", script]
    done = subprocess.run(
        as_ordinary_user(command) if ordinary else command,
        env=environment(), cwd="/", capture_output=True, text=True, timeout=120, check=False,
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    return json.loads(done.stdout)


CHILD = """
import json, sys
sys.path.insert(0, {repository!r})
from grader.sandbox import Harvester, HarvestError
{before}
def reply(h, cells):
    try:
        return h.run(cells, *{seconds})
    except HarvestError as error:
        return str(error)
with Harvester(1, sandbox={sandbox}) as h:
    jobs = {jobs!r}
    out = [reply(h, cells) for cells in jobs[:1]]
    {between}
    out += [reply(h, cells) for cells in jobs[1:]]
print(json.dumps(out))
"""

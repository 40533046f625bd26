"""Jobs for the sandbox, and what runs after them."""

import os
import textwrap
from pathlib import Path

import pytest

FORMS = {"x": "number, 1"}


def job(*cells):
    return [
        {"id": f"0/{n}", "givens": "", "cell": textwrap.dedent(c), "forms": FORMS, "symbols": {}}
        for n, c in enumerate(cells, 1)
    ]


def caged(harvester, *cells, seconds=10, cell_seconds=5, setup=""):
    reply = harvester.run(setup, job(*cells), seconds, cell_seconds)
    if reply["sandbox"] != "namespaces":
        pytest.skip(f"this kernel refuses the cage: {reply['sandbox']}")
    return reply


def still_serves(harvester):
    reply = harvester.run("", job("x = 6 * 7"), 10, 5)
    return reply["receipts"]["0/1"]["answers"] == {"x": 42.0} and reply["ended"] == "done"


def descendants():
    """The ids of all processes that descend from this one: workers and what they run."""
    parents = {}
    for entry in Path("/proc").glob("[0-9]*"):
        try:
            parents[int(entry.name)] = int(
                (entry / "stat").read_text().rpartition(")")[2].split()[1]
            )
        except OSError:
            continue
    found, level = set(), {os.getpid()}
    while level:
        level = {p for p, parent in parents.items() if parent in level} - found
        found |= level
    return found

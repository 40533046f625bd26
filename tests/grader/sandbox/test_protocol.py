"""What a notebook that is run gives back: receipts, outcomes of tests, errors, in the order of its
cells.
"""

import json
import socket
import sys
from types import SimpleNamespace

import pytest

from grader.sandbox import worker
from tests.grader.sandbox.jobs import own, problem, run_caged
from tests.grader.sandbox.test_cage import ENDINGS

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="the cage is Linux")


GIVENS, ANSWER, HARVEST = problem("0/1", "x = 1")
IN_PLACE = {  # cells, and x of each problem
    "cells of the student": (
        [*problem("0/1", "x = a", "a = 1"), own("a = 10\ndef twice(y): return 2 * y"),
         *problem("0/2", "x = twice(a)")], [1.0, 20.0]
    ),
    "a cell between answer and harvest": ([GIVENS, ANSWER, own("x = x + 1"), HARVEST], [2.0]),
    "givens remove earlier answers": ([*problem("0/1", "x = 1"), *problem("0/2", "")], [1.0, None]),
    "givens that are repeated": (
        [*problem("0/1", "x = a", "a = 1"), *problem("0/2", "x = a", "a = 2"),
         *problem("0/3", "x = a", "a = 1")], [1.0, 2.0, 1.0]
    ),
}  # fmt: skip


@pytest.mark.parametrize("what", IN_PLACE)
def test_every_cell_runs_in_its_place(harvester, what):
    cells, expected = IN_PLACE[what]
    found = run_caged(harvester, cells)["receipts"].values()
    assert [r["error"] or r["answers"]["x"] for r in found] == expected


def test_the_first_error_since_the_givens_is_reported_with_the_answers(harvester):
    givens, answer, harvest = problem("0/1", "x = 3")
    cells = [
        own("first", "before"), givens, own("second"), answer, own("third"), harvest,
        *problem("0/2", "x = 4"),
    ]  # fmt: skip
    reply = run_caged(harvester, cells)
    assert reply["receipts"]["0/1"]["error"] == "NameError, line 1: name 'second' is not defined"
    assert reply["receipts"]["0/1"]["answers"] == {"x": 3.0}
    assert reply["receipts"]["0/2"]["error"] is None
    assert reply["errors"] == {
        "before": "NameError, line 1: name 'first' is not defined",
        "own": "NameError, line 1: name 'second' is not defined",
    }


OUTCOMES = {
    "assert f(2) == 4": (None, None),
    "assert f(2) == 5, 'f(2) is wrong'": ("AssertionError, line 1: f(2) is wrong", None),
    "0.5 * f(2)": (None, 2.0),
    "import numpy as np\nnp.float64(1.5)": (None, 1.5),
    "f(2);": (None, None),
    "'text'": (None, "other"),
    "True": (None, "other"),
    "float('nan')": (None, "other"),
    "undefined": ("NameError, line 1: name 'undefined' is not defined", None),
    "if": ("SyntaxError: invalid syntax, line 1: if", None),
    "assert state == 'then'": (None, None),  # as it was where the test is
    "import os; os._exit(0)": ("the test was not run: the notebook ended before it, or its process ended", None),
}  # fmt: skip


def a_notebook_with(texts):
    """Cells of a notebook, with tests of these texts in the middle."""
    test = {"role": "test", "text": "seen = 1"}
    tests = [{**test, "name": f"test-{n}", "hidden": text} for n, text in enumerate(texts)]
    before, after = own("def f(n): return n**2\nstate = 'then'"), own("state = 'later'\ndel f")
    return [before, *tests, after, *problem("0/1", "x = seen")]


def test_a_test_reports_its_error_and_the_value_of_its_last_expression(harvester):
    reply = run_caged(harvester, a_notebook_with(OUTCOMES))
    found = [(o["error"], o["value"]) for o in reply["tests"].values()]
    assert dict(zip(OUTCOMES, found, strict=True)) == OUTCOMES
    assert list(reply["tests"]) == [f"test-{n}" for n in range(len(OUTCOMES))]
    assert reply["receipts"]["0/1"]["answers"] == {"x": 1.0}  # its visible text ran
    assert reply["errors"] == {}


def test_a_test_has_the_time_limit_of_a_cell_and_the_next_one_runs(harvester):
    reply = run_caged(harvester, a_notebook_with(["while True: pass", "1"]), cell_seconds=0.5)
    assert "ran longer than 0.5 s" in reply["tests"]["test-0"]["error"]
    assert reply["tests"]["test-1"] == {"error": None, "value": 1.0}


@pytest.mark.parametrize("what", ["ends Python", "endless loop that catches everything"])
def test_a_test_that_was_reached_counts_even_where_the_notebook_ends_later(harvester, what):
    late = {"role": "test", "name": "late", "text": "", "hidden": "2"}
    cells = [*a_notebook_with(["1"]), own(ENDINGS[what]), late]
    reply = run_caged(harvester, cells, seconds=2, cell_seconds=1)
    assert reply["tests"]["test-0"] == {"error": None, "value": 1.0}
    assert "the notebook ended before it" in reply["tests"]["late"]["error"]


SEARCH = """
import gc
x = sum("hidden-" + "words" in str(o) for o in gc.get_objects() if isinstance(o, (dict, list)))
"""


def test_the_text_of_a_test_is_nowhere_while_the_cells_run(harvester):
    """Neither that of this notebook's test nor that of the one the worker ran before."""
    for _ in range(2):
        cells = [*a_notebook_with(["'hidden-words'"]), *problem("0/2", SEARCH)]
        reply = run_caged(harvester, cells)
        assert reply["tests"]["test-0"] == {"error": None, "value": "other"}
        assert reply["receipts"]["0/2"]["answers"] == {"x": 0.0}, reply


def test_a_token_that_an_earlier_test_has_shown_is_worth_nothing():
    """Each test has a token of its own, which comes with its text: too long to be guessed."""
    limits = {"seconds": 0.05, "cell_seconds": 0.05}
    pairs = [socket.socketpair() for _ in range(2)]
    (ours, cage), (ours_later, cage_later) = pairs
    worker._run_tests([ours], ["assert False"], limits)
    token = json.loads(cage.recv(2**16)[4:])["token"]
    cage_later.sendall(json.dumps({"token": token, "error": None, "value": 5}).encode() + b"\n")
    (outcome,) = worker._run_tests([ours_later], ["assert False"], limits)
    assert "the test was not run" in outcome["error"]
    assert len(token) >= 32
    for end in (end for pair in pairs for end in pair):
        end.close()


def test_all_tests_have_the_time_of_a_notebook_and_each_that_of_a_cell(monkeypatch):
    now, given = [0.0], []

    def ask(pair, text, token, seconds):
        given.append(seconds)
        now[0] += 8.0
        return b""

    monkeypatch.setattr(worker, "_ask", ask)
    monkeypatch.setattr(worker, "time", SimpleNamespace(monotonic=lambda: now[0]))
    worker._run_tests([None] * 3, [""] * 3, {"seconds": 20.0, "cell_seconds": 10.0})
    assert given == [10.0 + worker.GRACE, 12.0, 4.0]


PATCHES = {  # by a wrong answer; the test is right
    "import numpy.testing\nnumpy.testing.assert_allclose = lambda *_, **__: None": (
        "import numpy.testing\nnumpy.testing.assert_allclose(f(2), 5)"
    ),
    "import numpy as np\nnp.isclose = np.allclose = lambda *_, **__: True": (
        "import numpy as np\nassert np.isclose(f(2), 5)"
    ),
    "import builtins\nbuiltins.abs = lambda _: 0": "assert abs(f(2) - 5) < 1e-9",
    "import builtins\nbuiltins.AssertionError = Warning": "assert f(2) == 5",
    "import json\njson.dumps = lambda *_: '{}'": "assert f(2) == 5",
    "import os\nos.write = lambda *_: 5": "assert f(2) == 5",
    "import builtins\nbuiltins.eval = lambda *_: 5": "assert f(2) == 5",
    "import sys\nsys.modules['cage.cells']._plain = lambda _: 5": "assert f(2) == 5",
    "import sys\nsys.settrace(lambda *_: 1/0)": "assert f(2) == 5",
    "import math\nmath.isclose = lambda *_: True": "import math\nassert math.isclose(f(2), 5)",
    "import unittest\nunittest.TestCase.assertEqual = None\nunittest.TestCase = object": (
        "import unittest\nassert unittest.TestCase is not object\nassert f(2) == 5"
    ),
}


@pytest.mark.parametrize("patch", PATCHES)
def test_a_library_that_was_patched_is_put_back_for_a_test(harvester, patch):
    cells = a_notebook_with([PATCHES[patch]])
    reply = run_caged(harvester, [cells[0], own(patch, "patch"), *cells[1:]])
    assert "AssertionError" in reply["tests"]["test-0"]["error"]

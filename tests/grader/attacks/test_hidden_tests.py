"""An instructor's hidden tests against hostile code: what stands, and what a test that runs in the
student's own process cannot promise.
"""

import sys
import textwrap
import tomllib
from pathlib import Path

import pytest

from tests.grader.sandbox.jobs import caged, own, problem, run_caged

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="the cage is Linux")
HIDDEN = "assert square(-7) == 49, 'hidden words'"
WRONG = "def square(x): return 0"


def notebook(text, hidden=HIDDEN):
    """A student's cell, a test, a cell behind it, and a problem that reads ``x``."""
    return [
        own(text),
        {"role": "test", "name": "t", "text": "", "hidden": hidden},
        own("seen = globals().get('seen')"),
        *problem("0/1", "x = seen"),
    ]


def outcome(harvester, text, hidden=HIDDEN, **limits):
    return run_caged(harvester, notebook(text, hidden), **limits)["tests"]["t"]


CELLS = tomllib.loads(Path(__file__).with_name("hidden_tests.toml").read_text())
FORGED = CELLS["forged"]


@pytest.mark.parametrize("how", FORGED)
def test_a_forged_outcome_earns_nothing(harvester, how):
    found = outcome(harvester, FORGED[how].replace("$WRONG", WRONG), seconds=8, cell_seconds=1)
    assert found["error"] is not None, found


LEAKS = CELLS["leaks"]


@pytest.mark.parametrize("how", LEAKS)
def test_what_a_test_says_reaches_no_receipt_and_no_later_submission(harvester, how):
    spy = (
        "import os\nseen = open('/tmp/caught').read() if os.path.exists('/tmp/caught') else None\n"
        "def square(x):\n    import sys\n    caught = str(sys._getframe(1).f_code.co_consts)\n"
    )
    spy += textwrap.indent(LEAKS[how], "    ") + "\n    return 0"
    for _ in range(2):
        reply = run_caged(harvester, notebook(spy), seconds=8, cell_seconds=1)
        assert reply["tests"]["t"]["error"] is not None
        assert "hidden words" not in str(reply["receipts"]) + str(reply["errors"])
    after = caged(harvester, "import os\nx = os.path.exists('/tmp/caught')")
    assert "hidden words" not in str(after)
    assert after["receipts"]["0/1"]["answers"].get("x") in (None, 0.0)


DECEIVED = CELLS["deceived"]


@pytest.mark.parametrize("how", DECEIVED)
def test_what_a_test_in_the_students_process_cannot_promise(harvester, how):
    """Plain nbgrader is deceived too. If one of these ever fails, take it out of the README."""
    assert outcome(harvester, DECEIVED[how]) == {"error": None, "value": None}

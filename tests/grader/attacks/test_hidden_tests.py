"""An instructor's hidden tests against hostile code: what stands, and what a test that runs in the
student's own process cannot promise.
"""

import sys
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


FORGED = tomllib.loads(Path(__file__).with_name("forged.toml").read_text())["cells"]


@pytest.mark.parametrize("how", FORGED)
def test_a_forged_outcome_earns_nothing(harvester, how):
    found = outcome(harvester, FORGED[how].replace("$WRONG", WRONG), seconds=8, cell_seconds=1)
    assert found["error"] is not None, found


LEAKS = {  # how code called by the test tries to pass on what it sees; ``caught`` is the text
    "into a variable": "globals()['seen'] = caught",
    "into every file": "import os\n    for fd in range(1, 64):\n        try: os.write(fd, caught.encode())\n"
                       "        except OSError: pass",
    "into the receipts": "import os, json\n    line = json.dumps({'id': '0/1', 'answers': {'x': 1.0}, "
                         "'error': caught}).encode()\n    for fd in range(1, 64):\n        try: os.write(fd, b'\\n' "
                         "+ line + b'\\n')\n        except OSError: pass",
    "into a file": "open('/tmp/caught', 'w').write(caught)",
    "into another process": "import os, time\n    if os.fork() == 0:\n        time.sleep(30)",
    "into an error": "raise ValueError(caught)",
}  # fmt: skip


@pytest.mark.parametrize("how", LEAKS)
def test_what_a_test_says_reaches_no_receipt_and_no_later_submission(harvester, how):
    spy = (
        "import os\nseen = open('/tmp/caught').read() if os.path.exists('/tmp/caught') else None\n"
        "def square(x):\n    import sys\n"
        "    caught = str(sys._getframe(1).f_code.co_consts)\n    " + LEAKS[how] + "\n    return 0"
    )
    for _ in range(2):
        reply = run_caged(harvester, notebook(spy), seconds=8, cell_seconds=1)
        assert reply["tests"]["t"]["error"] is not None
        assert "hidden words" not in str(reply["receipts"]) + str(reply["errors"])
    after = caged(harvester, "import os\nx = os.path.exists('/tmp/caught')")
    assert "hidden words" not in str(after)
    assert after["receipts"]["0/1"]["answers"].get("x") in (None, 0.0)


DECEIVED = {  # ways to pass a test without an answer: known, and in the README
    "an object that is equal to all": (
        "class Any:\n    def __eq__(self, _): return True\n    __hash__ = None\n"
        "def square(x): return Any()"
    ),
    "the frame of the test": (
        "def square(x):\n    import sys\n    f = sys._getframe(1)\n"
        "    return next(c for c in f.f_code.co_consts if isinstance(c, int) and c > 7)"
    ),
}


@pytest.mark.parametrize("how", DECEIVED)
def test_what_a_test_in_the_students_process_cannot_promise(harvester, how):
    """Plain nbgrader is deceived too. If one of these ever fails, take it out of the README."""
    assert outcome(harvester, DECEIVED[how]) == {"error": None, "value": None}

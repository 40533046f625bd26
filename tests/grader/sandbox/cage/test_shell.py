"""What works in a notebook works in the cage: each cell as IPython runs it, and as we do."""

import sys
import tomllib
from pathlib import Path

import pytest

from grader.sandbox.cage import shell
from tests.grader.sandbox.jobs import answer, job, own, problem, run_caged

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="the cage is Linux")

WORKS = tomllib.loads(Path(__file__).with_name("cells.toml").read_text())["works"]


@pytest.mark.parametrize("what", WORKS)
def test_what_a_notebook_shows_as_working_works(harvester, what):
    assert answer(harvester, WORKS[what]) == 42.0


def test_these_cells_work_in_ipython_itself(tmp_path, monkeypatch):
    """The oracle: a real shell, without a kernel."""
    pytest.importorskip("IPython")
    from IPython.core.interactiveshell import InteractiveShell

    monkeypatch.delenv("VIRTUAL_ENV", raising=False)  # it warns if that is another Python's
    monkeypatch.setitem(sys.modules, "__main__", sys.modules["__main__"])  # which it replaces
    shell, failed = InteractiveShell(ipython_dir=str(tmp_path)), {}
    shell.display_pub.publish = lambda *_, **__: None
    shell.enable_matplotlib = lambda *_: ("inline", "inline")  # which needs a kernel
    for what, text in WORKS.items():
        if what in NOT_IN_A_BARE_SHELL:
            continue
        shell.user_ns.pop("x", None)
        result = shell.run_cell(text, silent=True)
        if not result.success or shell.user_ns.get("x") != 42:
            failed[what] = result.error_in_exec or result.error_before_exec
    assert failed == {}


NOT_IN_A_BARE_SHELL = {
    "a plot",  # needs a screen
    "a widget",  # needs a kernel
    "pylab",  # needs a screen
    "output of a shell command",  # here the folder is empty, and 42 is right only for that
    "pickle",  # the module __main__ is that of the tests
    "a dataclass",
    "main",
}


def test_a_module_of_a_cell_can_be_imported_and_the_next_submission_sees_nothing(harvester):
    cells = [
        own("%%writefile mine.py\ny = 40\n"),
        own("%%writefile -a mine.py\ny = y + 2\n"),
        *problem("0/1", "import mine\nx = mine.y"),
    ]
    assert run_caged(harvester, cells)["receipts"]["0/1"]["answers"] == {"x": 42.0}
    run_caged(harvester, job("import builtins; builtins.left = 1; x = 1"))
    assert "NameError" in answer(harvester, "x = left")


UNDERSCORE = {  # cells, and x after them
    "the last value": (["6 * 7", "x = _"], 42.0),
    "the last but one": (["1", "2", "x = 10 * __ + _"], 12.0),
    "not of an assignment": (["6 * 7", "y = 1", "x = _"], 42.0),
    "not with a semicolon": (["42", "43;", "x = _"], 42.0),
    "not None": (["42", "None", "x = _"], 42.0),
    "a name of the student": (["_ = 42", "43", "x = _"], 42.0),
    "a loop over it": (["for _ in range(43): pass", "7", "x = _"], 42.0),
    "of a timed line": (["%time 6 * 7", "x = _"], 42.0),
}


@pytest.mark.parametrize("what", UNDERSCORE)
def test_the_underscore_is_the_last_value_that_was_shown(harvester, what):
    (*before, last), expected = UNDERSCORE[what]
    cells = [*(own(text) for text in before), *problem("0/1", last)]
    receipt = run_caged(harvester, cells)["receipts"]["0/1"]
    assert (receipt["error"], receipt["answers"]) == (None, {"x": expected})


FAILS = {  # in a notebook too
    "x = 1 +": "SyntaxError: invalid syntax, line 1: x = 1 +",
    "%time undefined": "NameError, line 1: name 'undefined' is not defined",
    "%%time\n1/0": "ZeroDivisionError, line 2: division by zero",
    "e = KeyError('m')\ne.add_note('at 2 s')\nraise e": "KeyError, line 3: 'm'; at 2 s",
    "a = 1\n\nb = undefined\n": "NameError, line 3: name 'undefined' is not defined",
    "%timeit y = 3\nx = y": "NameError, line 2: name 'y' is not defined",
    "await 3": "TypeError, line 1: object int can't be used in 'await' expression",
    "return 3": "SyntaxError: 'return' outside function, line 1: return 3",
}


@pytest.mark.parametrize("text", FAILS)
def test_what_fails_in_a_notebook_fails_here_with_its_line(harvester, text):
    assert answer(harvester, text) == FAILS[text]


CUT = (  # where the last line might be mistaken for an expression
    "x = 3\nx", "'''a\nx = 3\n'''", "s = '''a\nx = ''' + '''b'''", "f(1,\nx=2)", "x = (1,\n2)\nx", "y = \\\n3",
    "if 1:\n  x = 3\nx", "x = 3\n x", " x = 3\nx", "x = 1; 2", "x = 3 # a; b", "x = 1;", "x = 3\nx == 3",
    "lambda x=3: x", "lambda x = 3: x", "a, b = 1, 2\na, b", "x = yield", "y = 3\nyield y", "return 3",
    "x = 1\rx", "x = 1\r\nx", "x = 1\n\n\ny = 1/0", "x = 1\n\n1/0", "try:\n  x = 1\nx = 2", "@f\nx = 3",
    "'doc'\nx = 3\n__doc__", "x = 3\nexec('(')", "x\x00", "x: int = 3", "x = 3\n# x", "\nx = 4\nx",
    "x = 3\n*x, 1", "x = 3\n-x",
)  # fmt: skip


@pytest.mark.filterwarnings("ignore::SyntaxWarning")
@pytest.mark.parametrize("text", CUT)
def test_a_cell_cut_before_its_last_line_does_what_the_whole_does(monkeypatch, text):
    ways = [_outcome(monkeypatch, text), _outcome(monkeypatch, text, lambda *_: None)]
    assert ways[0] == ways[1]


def _outcome(monkeypatch, text, in_two=shell._in_two):
    monkeypatch.setattr(shell, "_in_two", in_two)
    monkeypatch.setattr(sys, "path", [*sys.path])
    monkeypatch.setitem(sys.modules, "__main__", None)
    own = shell.Shell()
    own.names["f"] = lambda *_, **__: "f"
    value = error = None
    try:
        value = repr(own.run(text))
    except Exception as e:
        at = e.__traceback__
        while at.tb_next:
            at = at.tb_next
        error = type(e), str(e), shell.is_cell(at.tb_frame.f_code.co_filename) and at.tb_lineno
    names = [repr(own.names.get(n)) for n in ("x", "y", "a", "s", "_", "__doc__")]
    return [text and text.partition(" at 0x")[0] for text in (value, *names)], error

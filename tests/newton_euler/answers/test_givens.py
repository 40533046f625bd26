"""A receipt says when an answer was computed with numbers of another problem, and only then."""

import sys
import textwrap

import pytest
from traitlets.config import Config

from newton_euler.answers import givens
from newton_euler.answers.receipts import _expected

GIVENS = {
    "4/16": "omega = 0.6\nbeta = 30.0\ngiven('4/16', omega=omega, beta=beta)",
    "4/12": "omega = 0.3\ngiven('4/12', omega=omega)",
}
RECEIPTS = {
    "4/16": "expect('4/16', a_D='number, m/s^2')\nr = receipt('4/16', a_D=a_D)",
    "4/12": "expect('4/12', v_A='number, m/s')\nr = receipt('4/12', v_A=v_A)",
}


@pytest.fixture
def shell(monkeypatch):
    """An IPython shell in which cells are run, each with an id as in Jupyter."""
    interactive = pytest.importorskip("IPython.core.interactiveshell").InteractiveShell
    monkeypatch.setattr(givens, "_given", {})
    monkeypatch.setitem(sys.modules, "__main__", sys.modules["__main__"])  # the shell replaces it
    monkeypatch.delenv("VIRTUAL_ENV", raising=False)  # IPython warns if another Python owns it
    config = Config({"HistoryManager": {"enabled": False}})
    shell = interactive.instance(config=config)
    shell.user_ns.clear()
    shell.run_cell("from newton_euler.classroom import expect, given, receipt")
    yield shell
    for name, f in (("pre_run_cell", givens._watch.start), ("post_run_cell", givens._watch.end)):
        if f in shell.events.callbacks[name]:
            shell.events.unregister(name, f)
    interactive.clear_instance()
    givens._watch.__init__()
    for number in GIVENS:
        _expected.pop(number, None)


def run(shell, *cells):
    """Run cells: names of GIVENS and RECEIPTS, or (id, text); the warning of the last receipt."""
    for cell in cells:
        kind, text = cell.split(" ", 1)
        text = {"givens": GIVENS, "receipt": RECEIPTS}.get(kind, {}).get(text, text)
        result = shell.run_cell(textwrap.dedent(text), cell_id=kind if kind.isdigit() else cell)
        result.raise_error()
    return shell.user_ns["r"].warning if "r" in shell.user_ns else ""


ANSWER = "1 a_D = omega * 10"
STALE = (
    "a_D was computed when omega was 0.3; 4/16 gives 0.6: run the cell of its givens, then yours"
)


def test_in_order_there_is_no_warning_whatever_changes_after_the_answer(shell):
    assert run(shell, "givens 4/12", "givens 4/16", ANSWER, "receipt 4/16") == ""
    assert run(shell, "givens 4/16", ANSWER, "givens 4/12", "receipt 4/16") == ""


def test_numbers_of_another_problem_are_reported_with_both_values(shell):
    cells = "givens 4/16", ANSWER, "givens 4/12", "2 v_A = omega", "receipt 4/12"
    assert run(shell, *cells) == ""
    assert run(shell, ANSWER, "receipt 4/16") == STALE
    assert "look again: a_D was computed" in repr(shell.user_ns["r"])
    assert run(shell, "givens 4/16", "receipt 4/16") == STALE  # not yet computed again
    assert run(shell, ANSWER, "receipt 4/16") == ""


def test_a_number_converted_by_an_answer_or_another_cell_is_no_fault_and_twice_is_one(shell):
    answer = "1 from math import radians\nbeta = radians(beta)\na_D = omega * beta"
    assert run(shell, "givens 4/16", answer, "receipt 4/16") == ""
    cells = "givens 4/16", "7 beta = beta / 57.3", "1 a_D = omega * beta", "receipt 4/16"
    assert run(shell, *cells) == ""
    answer = "1 beta = beta / 57.3\na_D = omega * beta"
    warning = run(shell, "givens 4/16", answer, answer, "receipt 4/16")
    assert warning.startswith("a_D was computed when beta was 0.52")


def test_an_answer_of_another_problem_under_the_name_of_a_given_number_is_reported(shell):
    run(shell, "3 expect('4/13', omega='number, rad/s')", "givens 4/16", ANSWER, "receipt 4/16")
    warning = run(shell, "4 omega = 1.75", ANSWER, "receipt 4/16")
    assert warning.startswith("a_D was computed when omega was 1.75; 4/16 gives 0.6")
    _expected.pop("4/13")


def test_an_answer_that_is_an_equal_object_was_still_computed_again(shell):
    cells = "givens 4/12", "1 a_D = 3", "givens 4/16", "1 a_D = 3", "receipt 4/16"
    assert run(shell, *cells) == ""


SPEED = "expect('{0}', speed='number, m/s')\nr = receipt('{0}', globals())"
FAILED = "the cell that gives speed a value ended in an error"
OTHER = "speed has its value from 4/1: run your cell of 4/2"


@pytest.mark.parametrize(
    ("cell", "answer", "warning"),
    [
        ("speed = 7.0", 7.0, ""),
        ("speed = 5.0", 5.0, ""),
        ("speed = 3", 3, ""),
        ("speed = None", None, ""),
        ("speed = (7.0", None, FAILED),
        ("x = 1 / 0\nspeed = x", None, FAILED),
        ("speed = 7.0\nx = 1 / 0", 7.0, ""),
        ("# not written yet", None, OTHER),
    ],
)
def test_a_receipt_shows_no_answer_of_another_problem(shell, cell, answer, warning):
    run(shell, "givens 4/12", "1 speed = 5.0", f"8 {SPEED.format('4/1')}")
    shell.run_cell(cell, cell_id="2")
    run(shell, f"9 {SPEED.format('4/2')}")
    assert shell.user_ns["r"].answers == {"speed": answer}
    assert shell.user_ns["r"].warning == warning
    assert warning in repr(shell.user_ns["r"])
    run(shell, f"8 {SPEED.format('4/2')}")
    assert shell.user_ns["r"].answers == {"speed": answer}
    run(shell, "2 speed = 8.0", f"9 {SPEED.format('4/2')}")
    assert (shell.user_ns["r"].answers, shell.user_ns["r"].warning) == ({"speed": 8.0}, "")
    for number in ("4/1", "4/2"):
        _expected.pop(number)


def test_symbols_and_arrays_are_compared_too(shell):
    symbols = "5 import sympy, numpy\nomega = sympy.Symbol('omega')\nq = numpy.ones(3)\n"
    cells = f"{symbols}given('4/16', omega=omega, q=q)", "1 a_D = 2.0", "receipt 4/16"
    assert run(shell, *cells) == ""


def test_a_magic_in_the_answer_cell_is_followed(shell):
    answer = "1 %matplotlib --list\na_D = omega * 10"
    assert run(shell, "givens 4/12", "givens 4/16", answer, "receipt 4/16") == ""


def test_outside_ipython_nothing_is_watched():
    givens.given("0/1", omega=0.6)
    assert givens.stale("0/1", {"v": 1.0}, set()) == ""
    assert givens.watching().shell is None

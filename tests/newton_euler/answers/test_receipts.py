"""Receipts: what is read and shown, what is open, what Validate shows."""

import json

import pytest
from sympy import sin, symbols

from newton_euler.answers.forms import AnswerError, Form
from newton_euler.answers.receipts import expect, receipt, receipts, record
from tests.newton_euler.answers.one_answer import ground, omega, r


def test_one_fault_leaves_the_other_answers():
    forms = {
        "v": Form.read("vector, m/s"),
        "n": Form.read("number, 1"),
        "open": Form.read("number, 1"),
    }
    read, faults = record(forms, {}, {"v": [1, 2], "n": 3})
    assert read == {"n": 3.0, "open": None}
    assert list(faults) == ["v"]


# -- receipt


@pytest.fixture
def problem():
    expect("0/7", {"r": "m", "omega": "rad/s"}, v="vector, m/s", speed="expression, m/s")
    return "0/7"


def test_a_receipt_shows_what_was_read_wherever_names_are_and_what_is_open(problem, capsys):
    assert repr(receipt(problem, v=[1, 2.5, 0], speed=None)) == (
        "0/7: v = [1, 2.5, 0] m/s. Form checked only; the key is not here. Still open: speed."
    )
    assert repr(receipt(problem)) == "0/7: no answer yet."
    given = receipt(problem, {"v": [1, 2.5, 0], "other": print})
    assert given.answers == {"v": [1.0, 2.5, 0.0], "speed": None}
    assert "Still open: speed" in repr(given)
    assert receipt(problem, {"v": [1, 2.5, 0]}, v=None).answers["v"] is None
    assert repr(receipt(problem, {})) == "0/7: no answer yet."
    receipt(problem, v=[1, 2, 3])._ipython_display_()
    assert capsys.readouterr().out.startswith("0/7: v = [1, 2, 3] m/s.")


def test_a_receipt_is_a_json_record(problem):
    given = receipt(problem, v=ground.vector(1, 2, 0), speed=omega * r)
    assert json.loads(given.json) == {
        "problem": "0/7",
        "answers": {"v": [1.0, 2.0, 0.0], "speed": ["*", "omega", "r"]},
    }
    assert receipts["0/7"]["faults"] == {}


def test_what_cannot_be_read_or_is_unknown_is_named(problem):
    words = r"0/7, v: expected a vector(.|\n)*0/7, speed: expected a formula"
    with pytest.raises(AnswerError, match=words):
        receipt(problem, v=3, speed="r")
    words = r"problem '9/99' has not been announced; run the cells of the notebook from the top"
    with pytest.raises(AnswerError, match=words):
        receipt("9/99", v=1)
    with pytest.raises(AnswerError, match="problem 0/7 does not ask for 'w'; it asks for v, speed"):
        receipt(problem, w=1)


@pytest.mark.parametrize(
    ("answers", "words"),
    [
        ({}, "0/7: no answer yet for v, speed; an open answer earns no points"),
        ({"v": [1, 2, 3], "speed": None}, "0/7: no answer yet for speed; an open answer earns"),
        ({"v": "1", "speed": None}, "0/7, v: expected a vector"),
    ],
)
def test_validate_says_what_is_open_or_cannot_be_read(problem, monkeypatch, answers, words):
    monkeypatch.setenv("NBGRADER_EXECUTION", "validate")
    with pytest.raises(AnswerError, match=words):
        receipt(problem, answers)
    assert "Form checked only" in repr(receipt(problem, v=[1, 2, 3], speed=omega * r))


def test_a_notebook_shows_the_sentence_of_an_error_without_the_librarys_code(problem):
    with pytest.raises(AnswerError) as caught:
        receipt(problem, v=3, speed="r")
    shown = caught.value._render_traceback_()
    assert [x.partition(":")[0] for x in shown] == ["AnswerError", "0/7, speed"]
    assert all(len(line) <= 70 for x in shown for line in x.splitlines())


def test_plain_nbgrader_cannot_give_points_for_a_receipt(problem, monkeypatch):
    monkeypatch.setenv("NBGRADER_EXECUTION", "autograde")
    with pytest.raises(AnswerError, match=r"not graded here.*python -m grader grade"):
        receipt(problem, v=[1, 2, 3])


def test_a_receipt_prints_hints_with_the_component_and_words_as_the_code_does():
    expect("0/9", {"r": "m", "omega": "rad/s"}, v="vector_expression, m/s")
    assert "look again at v: component 2 is in m; m/s is asked for" in repr(
        receipt("0/9", v=[r * omega, r, 0])
    )
    expect("0/13", acc_mag="number, m/s^2", state="choice: stable | unstable")
    output = receipt("0/13", acc_mag=2.5, state="stable").markdown
    assert r"`acc_mag` $= 2.5\ \text{m/s}^2$" in output
    assert "`state`: stable" in output
    expect("0/12", {"r": "m", "omega_1": "rad/s"}, v="expression, m/s")
    output = receipt("0/12", v=symbols("r") * symbols("omega_1") ** 2).markdown
    assert "\n- look again at v: it is in" in output
    assert "look again" in repr(receipt("0/12", v=symbols("r")))
    assert "**0/12:**" in output
    assert receipt("0/12").markdown == "0/12: no answer yet."


def test_a_receipt_in_a_notebook_is_typeset(problem, monkeypatch):
    """Names appear as in the statement, formulas with fractions and roots, units with exponents."""
    expect("0/11", {"tilt": "rad", "d": "m"}, notation={"tilt": r"\gamma"},
           b_dot="expression, m", v_D="vector, mm/s")  # fmt: skip
    tilt, d = symbols("tilt d")
    given = receipt("0/11", b_dot=d * sin(tilt) / 2, v_D=[1, 2.5, 0])
    assert r"\dot{b} = \frac{" in given.markdown or r"\dot{b} = 0.5 d" in given.markdown
    assert r"\sin \gamma" in given.markdown
    assert r"$\mathbf{v}_D = \left[1,\ 2.5,\ 0\right]\ \text{mm/s}$" in given.markdown
    assert "Form checked only" in given.markdown
    shown = []
    monkeypatch.setattr("newton_euler.answers.receipts.in_notebook", lambda: True)
    monkeypatch.setattr("IPython.display.display", lambda data, raw: shown.append(data))
    given._ipython_display_()
    assert shown == [{"text/plain": repr(given), "text/markdown": given.markdown}]


def test_a_matrix_is_read_back_in_rows():
    rows = [[1, 0, 0], [0, 2, 0], [0, 0, 3.5]]
    expect("7/2", I="matrix, kg*m^2")
    assert "I = [[1, 0, 0], [0, 2, 0], [0, 0, 3.5]] kg*m^2" in repr(receipt("7/2", {"I": rows}))

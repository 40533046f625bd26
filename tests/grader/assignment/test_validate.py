"""nbgrader's Validate says one true sentence for each state of an answer cell, and nothing else."""

import json
import re

import pytest

from grader.assignment.cells import code_cell
from tests.grader.courses import nbgrader

pytestmark = pytest.mark.integration

GIVENS = "from newton_euler.classroom import expect, given, receipt\nomega = 0.6\ngiven('0/16', omega=omega)"
RECEIPT = 'expect("0/16", v_D="vector, mm/s", a_D="vector, mm/s^2")\nreceipt("0/16", globals())'
OPEN = "AnswerError: 0/16: no answer yet for {}; what stays open costs its points"
STATES = {
    "untouched": ("v_D = None\na_D = None", OPEN.format("v_D, a_D")),
    "blank": ("", OPEN.format("v_D, a_D")),
    "one of two": ("v_D = [1, 2, omega]\na_D = None", OPEN.format("a_D")),
    "unreadable": (
        "v_D = 3\na_D = 'text'",
        "AnswerError: 0/16, v_D: expected a vector, three numbers as in [1.0, 0, -2.5], in mm/s; got "
        "1 number: 3 0/16, a_D: expected a vector, three numbers as in [1.0, 0, -2.5], in mm/s^2; got "
        "the text 'text'; write it without quotation marks",
    ),
    "an error": ("v_D = 1 / 0", OPEN.format("v_D, a_D")),
    "right form": ("v_D = [1, 2, omega]\na_D = [1, 2, 3]", None),
}


# a trace that ipykernel 7 logs now and then, when it is ended while it flushes its output
AT_THE_END_OF_A_KERNEL = r'(?s)Traceback [^\n]*\n  File "[^"\n]*zmqstream.py".*?ZMQError: [^\n]*'


def notebook(answer):
    def cell(name, text, **nbgrader):
        return code_cell(name, text, {}, {"grade_id": name, **nbgrader} if nbgrader else None)

    cells = [
        cell("givens", GIVENS),
        cell("answer", answer, grade=True, solution=True, locked=False, points=2),
        cell("receipt", RECEIPT, grade=True, solution=False, locked=True, points=0),
    ]
    kernel = {"kernelspec": {"name": "python3", "display_name": "Python 3"}}
    return {"nbformat": 4, "nbformat_minor": 5, "metadata": kernel, "cells": cells}


@pytest.mark.parametrize("state", STATES)
def test_validate_says_a_true_sentence(tmp_path, state):
    answer, sentence = STATES[state]
    (tmp_path / "x.ipynb").write_text(json.dumps(notebook(answer)))
    _, said = nbgrader("validate", "x.ipynb", cwd=tmp_path)
    if sentence is None:
        assert "Success! Your notebook passes all the tests." in said
        assert "cannot be converted" not in said
    else:
        (error,) = re.findall(r"(?s)The error was:(.*?)(?=\[ValidateApp|\[IPK|$)", said)
        assert " ".join(error.split()) == sentence
        assert "..." not in error  # nbgrader cuts lines that are too long for it
    assert "Traceback" not in re.sub(AT_THE_END_OF_A_KERNEL, "", said)

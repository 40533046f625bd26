"""nbgrader's Validate says one true sentence for each state of an answer cell, and nothing else."""

import json
import re
import shutil

import pytest

from grader.assignment import validate
from grader.assignment.cells import code_cell
from grader.course.creation import ASSIGNMENT, FOR_STUDENTS, TEMPLATES
from grader.sandbox import CELL_SECONDS
from tests.grader.courses import nbgrader

pytestmark = pytest.mark.integration

GIVENS = "from newton_euler.classroom import expect, given, receipt\nomega = 0.6\ngiven('0/16', omega=omega)"
RECEIPT = 'expect("0/16", v_D="vector, mm/s", a_D="vector, mm/s^2")\nreceipt("0/16", globals())'
OPEN = "OpenAnswer: 0/16: no answer yet for {}; an open answer earns no points"
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


# a trace that ipykernel 7 logs now and then when it is stopped while flushing its output
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
def test_nbgraders_own_words_stay_true_where_nothing_is_replaced(tmp_path, state):
    answer, sentence = STATES[state]
    (tmp_path / "x.ipynb").write_text(json.dumps(notebook(answer)))
    _, output = nbgrader("validate", "x.ipynb", cwd=tmp_path)
    if sentence is None:
        assert "Success! Your notebook passes all the tests." in output
        assert "cannot be converted" not in output
    else:
        (error,) = re.findall(r"(?s)The error was:(.*?)(?=\[ValidateApp|\[IPK|$)", output)
        assert " ".join(error.split()) == sentence
        assert "..." not in error  # nbgrader cuts lines that are too long for it
    assert "Traceback" not in re.sub(AT_THE_END_OF_A_KERNEL, "", output)


UNTOUCHED = "v_D = None\na_D = None"
RIGHT = "v_D = [1, 2, omega]\na_D = [1, 2, 3]"
QUESTION = {"grade": True, "solution": False, "locked": True, "points": 1}


def sheet(answers, *more):
    """A sheet with a problem for each of these answers, and other cells."""
    cells = []
    for n, answer in enumerate(answers):
        for cell in notebook(answer)["cells"]:
            role, number = cell["id"], f"0/{n}"
            cell["metadata"]["newton_euler"] = {"role": role, "problem": number}
            if "nbgrader" in cell["metadata"]:
                cell["metadata"]["nbgrader"]["grade_id"] = f"{role}-{n}"
            cells.append(
                {**cell, "id": f"{role}-{n}", "source": cell["source"].replace("0/16", number)}
            )
    return {**notebook(""), "cells": [*cells, *more]}


SOME = sheet(
    [RIGHT, UNTOUCHED, "v_D = 1 / 0", "v_D = 'text'\na_D = None", "v_D = [1, 2, 3]", "v_D = [",
     RIGHT],
    code_cell("q", "assert v_D == 7", {}, {"grade_id": "q", **QUESTION}),
)  # fmt: skip
SOME["cells"] = [c for c in SOME["cells"] if c["id"] != "answer-6"]
SHEETS = {
    "untouched": (sheet([UNTOUCHED] * 3), ["Nothing is answered yet (3 open); an open answer earn"]),
    "some": (
        SOME,
        ["Of 8: 1 answered, 2 open, 5 to correct", "0/0: v_D = [1, 2, 0.6] mm/s; a_D = [1, 2, 3]",
         "0/1: no answer yet for v_D, a_D", "0/2: your cell ends in an error, ZeroDivisionError",
         "0/3: v_D: expected a vector", "0/4: no answer yet for a_D",
         "0/5: your cell ends in an error, SyntaxError",
         "0/6: the cell for its answer is gone, or pasted as a copy", "q: its test fails.",
         "Whether an answer is right is not checked"],
    ),
    "all": (sheet([RIGHT, RIGHT]), ["Success! All is answered, and can be read (2 of 2)."]),
    "marks lost": (
        {**notebook(""), "cells": [{**c, "metadata": {}} for c in notebook(RIGHT)["cells"]]},
        ["Nothing was checked: this notebook has no cell that is graded."],
    ),
}  # fmt: skip


def with_students_settings(folder):
    """A folder with what an instructor hands to students."""
    for name in FOR_STUDENTS:
        shutil.copy(ASSIGNMENT / f"{name}.py", folder / f"newton_euler_{name}.py")
    config = (TEMPLATES / "student_config.py.in").read_text().replace("{name}", "'mechanics'")
    (folder / "nbgrader_config.py").write_text(config)
    return folder


@pytest.mark.parametrize("state", SHEETS)
def test_validate_says_what_is_open_and_what_cannot_be_read(tmp_path, state):
    content, output = SHEETS[state]
    (tmp_path / "x.ipynb").write_text(json.dumps(content))
    _, out = nbgrader("validate", "x.ipynb", cwd=with_students_settings(tmp_path))
    lines = out.splitlines()
    for words in output:
        assert [line for line in lines if line.startswith(words)], out
    assert ("Success" in out) == (state == "all")
    assert "failed" not in out.lower().replace("assertionerror", "")


def test_the_button_gets_the_same_and_nothing_failed(tmp_path, monkeypatch):
    from nbgrader.validator import Validator

    for name in ("validate", "validate_and_print"):
        monkeypatch.setattr(Validator, name, getattr(Validator, name))
    assert validate.apply()
    assert validate.apply()  # a server reads its settings at every press
    path = tmp_path / "x.ipynb"
    for state, result in (("untouched", "Nothing is answered yet (3 open)"), ("all", None)):
        path.write_text(json.dumps(SHEETS[state][0]))
        found = Validator().validate(str(path))
        if result is None:
            assert found == {}
        else:
            assert found["failed"][0]["source"].startswith(result)
            assert validate.HEADING in found["failed"][0]["error"]  # "The following cell failed:"


def test_where_nbgrader_differs_its_words_stay(monkeypatch):
    from nbgrader.validator import Validator

    before = Validator.validate
    monkeypatch.setattr(Validator, "_preprocess", lambda self, nb, more: nb)
    assert not validate.apply()
    assert Validator.validate is before


def test_the_limit_is_that_of_the_grader():
    assert validate.CELL_SECONDS == CELL_SECONDS

"""Copies whose receipts say whether an answer is right."""

import pytest

from exercises.catalogue import problem
from grader.assignment.notebook import build_notebook, personal_notebook
from grader.assignment.seals import with_seals
from grader.demo.sample_students import cell_text, right_answers

ASKED = "4/2", "4/16", "2/18"


@pytest.fixture(scope="module")
def copy():
    problems = [problem(name) for name in ASKED]
    released = build_notebook(problems, "a title", 10, 100)
    values = {p.id: {n: 1.1 * x for n, x in p.book_values.items()} for p in problems}
    return with_seals(personal_notebook(released, "ada", values, {}), values), values


def run(notebook, answers):
    """The texts of the receipts for a student with these answers."""
    names, output = {}, {}
    for cell in notebook["cells"]:
        own = cell["metadata"]["newton_euler"]
        if cell["cell_type"] != "code":
            continue
        source = answers[own["problem"]] if own["role"] == "answer" else cell["source"]
        head, _, last = source.rpartition("\n")
        exec(head if own["role"] == "receipt" else source, names)
        if own["role"] == "receipt":
            output[own["problem"]] = repr(eval(last, names))
    return output


def test_right_answers_are_reported_right_and_others_not(copy):
    notebook, values = copy
    right = {name: right_answers(problem(name), values[name]) for name in ASKED}
    output = run(notebook, {n: cell_text(problem(n), x) for n, x in right.items()})
    for name in ASKED:
        for key in right[name]:
            assert f"{key} is right" in output[name], output[name]
    wrong = {**right, "4/16": {**right["4/16"], "a_D": "[1, 2, 3]"}}
    output = run(notebook, {n: cell_text(problem(n), x) for n, x in wrong.items()})
    assert "v_D is right; a_D is not right" in output["4/16"]


def test_without_its_form_or_unasked_nothing_is_sealed(copy):
    _, values = copy
    released = build_notebook([problem("4/16")], "a title", 10, 100)
    answer = next(c for c in released["cells"] if c["id"] == "answer-4-16")
    answer["metadata"]["newton_euler"]["asked"]["v_D"] = "vector, m/s"
    sealed = with_seals(released, {"4/16": values["4/16"]})
    source = next(c["source"] for c in sealed["cells"] if c["id"] == "givens-4-16")
    assert "'a_D'" in source
    assert "'v_D'" not in source
    assert "sealed" not in str(build_notebook([problem("4/16")], "a title", 10, 100))

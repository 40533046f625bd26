"""Sample students for the demo and the tests: their answers, and attacks of a hostile one."""

import copy
from collections.abc import Iterable, Mapping, Sequence
from typing import Any

from exercises.catalogue import Answer, Problem

from ..assignment.cells import Notebook, SheetValues, Values, own_metadata
from ..assignment.lines import in_brackets
from ..reports import as_json

STUDENTS = {
    "ada": "all right",
    "ben": "makes one mistake in every problem",
    "cleo": "answers half of the problems",
    "dan": "answers nothing",
    "eve": "has a syntax error in one cell",
    "mallory": "hostile: cell tags, forged outputs, a patched checker",
}


def right_answers(p: Problem, values: Values) -> dict[str, str]:
    """The right answers of a problem as Python literals: {key: literal}."""
    results = p.solve({**p.sympy_symbols(), **values})
    return {a.key: literal(a, results[a.key]) for a in p.answers}


def literal(a: Answer, value: Any) -> str:
    """The Python source of an answer."""
    found = as_json(a, value)
    return in_brackets(found) if a.kind.is_formula else repr(found)


def answers_with_a_mistake(p: Problem, values: Values) -> tuple[dict[str, str], list[str]]:
    """(answers, wrong keys) by the first listed mistake that changes a single answer; without one,
    the right answers.
    """
    right = right_answers(p, values)
    for wrong in p.wrong({**p.sympy_symbols(), **values}).values():
        made = {key: literal(p.answer(key), value) for key, value in wrong.items()}
        if len(made) == 1 and made.items().isdisjoint(right.items()):
            return {**right, **made}, list(made)
    return right, []


def cell_text(p: Problem, answers: Mapping[str, str]) -> str:
    """The text of an answer cell with these literals, and the functions that formulas need."""
    functions = "Abs, acos, asin, atan, atan2, cos, cosh, exp, log, pi, sin, sinh, sqrt, tan, tanh"
    head = f"from sympy import {functions}\n" if p.symbolic else ""
    return head + "\n".join(f"{key} = {text}" for key, text in answers.items())


def fill_in(notebook: Notebook, texts: Mapping[str, str]) -> Notebook:
    """A copy of a fetched notebook with these texts in the answer cells, by problem id."""
    notebook = copy.deepcopy(notebook)
    for c in notebook["cells"]:
        own = own_metadata(c)
        if own.get("role") == "answer" and own["problem"] in texts:
            c["source"] = texts[own["problem"]]
    return notebook


def submission(
    student: str, fetched: Notebook, problems: Sequence[Problem], values: SheetValues
) -> tuple[Notebook, int]:
    """(the notebook that one of :data:`STUDENTS` hands in, the points to expect)."""
    total = sum(len(p.answers) for p in problems)
    texts = {p.id: cell_text(p, right_answers(p, values[p.id])) for p in problems}
    if student == "ada":
        return fill_in(fetched, texts), total
    if student == "ben":
        for p in problems:
            answers, wrong = answers_with_a_mistake(p, values[p.id])
            texts[p.id] = cell_text(p, answers)
            total -= len(wrong)
        return fill_in(fetched, texts), total
    if student == "cleo":
        half = problems[: len(problems) // 2]
        answered = fill_in(fetched, {p.id: texts[p.id] for p in half})
        return answered, sum(len(p.answers) for p in half)
    if student == "eve":
        texts[problems[0].id] += "\nand the rest = (1"
        return fill_in(fetched, texts), total - len(problems[0].answers)
    return (fetched if student == "dan" else hostile(fetched, problems)), 0


HOSTILE = """\
import os, sys
import newton_euler.answers.receipts as answers
answers.record = lambda *a: ({key: "anything" for key in a[0]}, {})          # replace the form check
answers.receipt = receipt = lambda *a, **k: 1e9
for name in ("/", os.getcwd(), os.path.expanduser("~")):                      # search for keys
    try:
        found = os.listdir(name)
    except OSError:
        pass
try:
    from exercises import problem                                             # the solutions, if they can be imported
    key = problem("4/16").solve(problem("4/16").book_values)
except ImportError:
    pass
for fd in range(3, 64):                                                       # forge receipts and verdicts
    try:
        os.write(fd, b'{"id": "4/16", "points": 1e9, "answers": {"a_D": "right"}, "verdict": "right"}\\n')
    except OSError:
        pass
"""  # noqa: E501


FORGED_OUTPUT = {
    "output_type": "execute_result",
    "execution_count": 1,
    "metadata": {},
    "data": {"text/plain": "1000.0"},
}


def hostile(notebook: Notebook, problems: Iterable[Problem]) -> Notebook:
    """A notebook without answers that tries everything that earns full points in plain nbgrader:
    tags, forged outputs, points, copied and edited tests.
    """
    forged = fill_in(notebook, {p.id: HOSTILE for p in problems})
    copies = []
    for c in forged["cells"]:
        role, metadata = own_metadata(c).get("role"), c["metadata"]
        metadata["tags"] = ["skip-execution", "raises-exception"]
        if role in ("receipt", "answer"):
            metadata["nbgrader"] |= {"points": 1000, "locked": False}
            c["outputs"] = [copy.deepcopy(FORGED_OUTPUT)]
        if role == "receipt":
            c["source"] = "1000.0"
            copies.append(copy.deepcopy(c) | {"id": c["id"] + "-copy"})
    forged["cells"] += copies[:1]
    return forged

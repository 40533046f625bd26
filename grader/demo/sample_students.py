"""Sample students for the demo and the tests: the texts of their answer cells, and what a hostile
one changes in the notebook.
"""

import copy

from ..assignment.notebook import own_metadata
from ..reports import nested


def right_answers(p, values):
    """The right answers of a problem as Python literals: {key: literal}."""
    results = p.solve({**p.sympy_symbols(), **values})
    return {a.key: literal(a, results[a.key]) for a in p.answers}


def literal(a, value):
    """The Python source of an answer."""
    if a.kind.is_formula:
        return _source(nested(value, str))
    return repr(nested(value, lambda x: x if isinstance(x, (int, str)) else float(x)))


def _source(nested):
    return "[" + ", ".join(map(_source, nested)) + "]" if isinstance(nested, list) else nested


def answers_without_a_term(p, values):
    """(answers, wrong keys) of a student who makes the first listed mistake that leaves out a term;
    without one, the right answers.
    """
    name = next(
        (m for m, text in p.mistakes.items() if "leaves out" in text or "leaving out" in text), None
    )
    if name is None:
        return right_answers(p, values), []
    wrong = p.wrong({**p.sympy_symbols(), **values})[name]
    return {
        **right_answers(p, values),
        **{key: literal(p.answer(key), v) for key, v in wrong.items()},
    }, list(wrong)


def cell_text(p, answers):
    """The text of an answer cell with these literals, and for formulas the functions that they
    need.
    """
    functions = "Abs, acos, asin, atan, atan2, cos, cosh, exp, log, pi, sin, sinh, sqrt, tan, tanh"
    head = f"from sympy import {functions}\n" if p.symbolic else ""
    return head + "\n".join(f"{key} = {text}" for key, text in answers.items())


def fill_in(notebook, texts):
    """A copy of a fetched notebook with these texts in the answer cells, by problem id."""
    notebook = copy.deepcopy(notebook)
    for c in notebook["cells"]:
        own = own_metadata(c)
        if own.get("role") == "answer" and own["problem"] in texts:
            c["source"] = texts[own["problem"]]
    return notebook


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


def hostile(notebook, problems):
    """A notebook without an answer that tries all that earns full points in plain nbgrader: tags,
    forged outputs, points, copied and edited tests.
    """
    forged = fill_in(notebook, {p.id: HOSTILE for p in problems})
    copies = []
    for c in forged["cells"]:
        c["metadata"]["tags"] = ["skip-execution", "raises-exception"]
        if own_metadata(c).get("role") in ("receipt", "answer"):
            c["metadata"]["nbgrader"]["points"] = 1000
            c["outputs"] = [
                {
                    "output_type": "execute_result",
                    "execution_count": 1,
                    "metadata": {},
                    "data": {"text/plain": "1000.0"},
                }
            ]
            c["metadata"]["nbgrader"]["locked"] = False
        if own_metadata(c).get("role") == "receipt":
            c["source"] = "1000.0"
            copies.append(copy.deepcopy(c) | {"id": c["id"] + "-copy"})
    forged["cells"] += copies[:1]
    return forged

"""Sample students, for the demo and the tests: what they write into the answer cells, and what else they do to the notebook."""

import copy

from exercises.catalogue import SYMBOLIC

from ..reports import _nested


def right(p, values):
    """The right answers of a problem, as a student would hold them: {key: literal}."""
    results = p.solve({**p.sympy_symbols(), **values})
    return {a.key: literal(a, results[a.key]) for a in p.answers}


def literal(a, value):
    """An answer as Python source."""
    if a.kind in SYMBOLIC:
        return _source(_nested(value, str))
    return repr(_nested(value, lambda x: x if isinstance(x, (int, str)) else float(x)))


def _source(nested):
    return "[" + ", ".join(map(_source, nested)) + "]" if isinstance(nested, list) else nested


def leaves_out(p, values):
    """The answers of a student who leaves a term out wherever the problem knows of one: (answers, the keys that this spoils)."""
    name = next((m for m, text in p.mistakes.items() if "leaves out" in text or "leaving out" in text), None)
    if name is None:
        return right(p, values), []
    spoiled = p.in_units(p.code.mistakes(p.base({**p.sympy_symbols(), **values}))[name])
    return {**right(p, values), **{key: literal(p.answer(key), v) for key, v in spoiled.items()}}, list(spoiled)


def cell(p, answers):
    """The text of an answer cell with these literals; formulas find the functions they need."""
    head = "from sympy import Abs, cos, pi, sin, sqrt, tan\n" if p.symbolic else ""
    return head + "\n".join(f"{key} = {text}" for key, text in answers.items())


def filled(notebook, texts):
    """A copy of a fetched notebook with answer cells replaced: ``texts`` by problem id."""
    notebook = copy.deepcopy(notebook)
    for c in notebook["cells"]:
        ours = c["metadata"].get("newton_euler", {})
        if ours.get("role") == "answer" and ours["problem"] in texts:
            c["source"] = texts[ours["problem"]]
    return notebook


HOSTILE = """\
import os, sys
import newton_euler.answers as answers
answers.record = lambda *a: ({key: "anything" for key in a[0]}, {})          # patch the checker
answers.receipt = receipt = lambda *a, **k: 1e9
for name in ("/", os.getcwd(), os.path.expanduser("~")):                      # look for keys
    try:
        found = os.listdir(name)
    except OSError:
        pass
try:
    from exercises import problem                                             # the solutions, if they were there
    key = problem("4/16").solve(problem("4/16").book_values)
except ImportError:
    pass
for fd in range(3, 64):                                                       # forge receipts and verdicts
    try:
        os.write(fd, b'{"id": "4/16", "points": 1e9, "answers": {"a_D": "right"}, "verdict": "right"}\\n')
    except OSError:
        pass
"""


def hostile(notebook, problems):
    """Everything that earns full points in plain nbgrader: tags, forged outputs, changed points, copied test cells, a patched checker; no answer."""
    forged = filled(notebook, {p.id: HOSTILE for p in problems})
    copies = []
    for c in forged["cells"]:
        c["metadata"]["tags"] = ["skip-execution", "raises-exception"]
        if c["metadata"].get("newton_euler", {}).get("role") in ("receipt", "answer"):
            c["metadata"]["nbgrader"]["points"] = 1000
            c["outputs"] = [{"output_type": "execute_result", "execution_count": 1, "metadata": {}, "data": {"text/plain": "1000.0"}}]
            c["metadata"]["nbgrader"]["locked"] = False
        if c["metadata"].get("newton_euler", {}).get("role") == "receipt":
            c["source"] = "1000.0"
            copies.append(copy.deepcopy(c) | {"id": c["id"] + "-copy"})
    forged["cells"] += copies[:1]
    return forged

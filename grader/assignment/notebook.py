"""The assignment notebook: built from the catalogue, made personal, and taken apart again.

Notebooks are plain dicts here (the JSON of the format), because nbformat validates at every step and a class has hundreds. For each problem
there are four cells: the statement and the numbers (a student's own, without any nbgrader id), the answer (editable; the only text that is
believed when it comes back) and the receipt (locked, worth nothing, checks the form).
"""

import base64
import hashlib
import re
from dataclasses import dataclass

from exercises.catalogue import problem as find_problem
from newton_euler.answers import Form

GREEK = {
    "alpha": "α", "beta": "β", "gamma": "γ", "delta": "δ", "epsilon": "ε", "zeta": "ζ", "eta": "η", "theta": "θ", "kappa": "κ", "lambda": "λ",
    "mu": "μ", "nu": "ν", "xi": "ξ", "rho": "ρ", "sigma": "σ", "tau": "τ", "phi": "φ", "psi": "ψ", "omega": "ω",
    "Omega": "Ω", "Gamma": "Γ", "Delta": "Δ", "Theta": "Θ", "Phi": "Φ", "Psi": "Ψ",
}  # fmt: skip
SETUP = """\
from math import pi

import numpy as np
from sympy import symbols

from newton_euler import Frame, at, atan2, cos, cross, dot, moving, radians, sin, solve_rates, sqrt, tan
from newton_euler.answers import expect, receipt
"""
MASTER_COPY = (
    "> **This copy has the numbers of the book.** Yours has numbers of its own: "
    "fetch the assignment with nbgrader, set up for this course, or ask for your copy."
)
INTRODUCTION = """\
# {title}

{whose}

Each problem has a cell for your work. It begins with names set to `None`; give each its value, in the unit that is written behind it, and run the
cell below it: the **receipt** says whether your answer can be read (kind, shape, unit of a formula). It does not know the right answer; that is
compared after you hand in, part by part, with a hint where a common slip explains the difference.

- Vectors are written `[x, y, z]`, in the frame named in the problem; a `Vector` of `newton_euler` is taken too. Angles go into `sin` and `cos` in
  radians.
- The numbers of the problem are in the cell above yours; they are your own. Where a formula is asked for, the symbols are there instead.
- Everything that your answer needs belongs into the answer cells: other cells are not read. The cells run from top to bottom, within {seconds:g} s
  each.
- A problem left at `None` costs nothing but its points.
"""


def pretty(name):
    """A variable name for a reader: ``omega_1`` as an italic omega with an index."""
    base, *indices = name.split("_")
    dots = {"dot": "\u0307", "ddot": "\u0308"}
    mark = "".join(dots[i] for i in indices if i in dots)
    index = ",".join(GREEK.get(i, i) for i in indices if i not in dots)
    return f"<i>{GREEK.get(base, base)}{mark}</i>" + (f"<sub>{index}</sub>" if index else "")


def number(x):
    """A given as a textbook prints it."""
    return f"{x:.6g}" if isinstance(x, float) else str(x)


def statement(p, values, figure=True):
    """The text of a problem with the student's numbers, as Markdown; the figure is the attachment ``figure.png``."""
    said = set()

    def put(match):
        name = match[1]
        if name not in p.units:
            return match[0]
        if name in p.symbols or name in said:
            return pretty(name)
        said.add(name)
        return f"{pretty(name)} = {number(values[name])}{_unit(p.givens[name].unit)}"

    lines = [f"## {p.id} {p.title}", "", re.sub(r"\{(\w+)\}", put, p.text)]
    unsaid = [n for n in p.givens if n not in said]
    if unsaid:
        lines += [
            "",
            "Given: " + ", ".join(f"{pretty(n)} = {number(values[n])}{_unit(p.givens[n].unit)} ({p.givens[n].means})" for n in unsaid) + ".",
        ]
    if figure:
        lines += ["", f"![Figure: {_alt(p.figure)}](attachment:figure.png)"]
    if p.frame:
        lines += ["", f"*Components:* {p.frame}"]
    lines += ["", "*Find*", ""]
    lines += [f"- `{a.key}`: {a.means}{_unit(a.unit, ', in')}" for a in p.answers]
    return "\n".join(lines)


def _unit(text, before=""):
    return "" if text == "1" else f"{before} {text}"


def _alt(text):
    return re.sub(r"[\[\]()\n]", " ", text).strip()


def givens(p, values):
    """The cell with a student's numbers, or with the symbols of a formula."""
    lines = [f"# {p.id}: what is given"]
    width = max((len(f"{n} = {number(values[n])}") for n in p.givens), default=0)
    lines += [f"{f'{n} = {number(values[n])}':<{width}}  # {g.unit if g.unit != '1' else 'a ratio'}: {g.means}" for n, g in p.givens.items()]
    if p.symbols:
        names = list(p.symbols)
        lines.append(f'{", ".join(names)} = symbols("{" ".join(names)}", real=True)  # {", ".join(s.unit for s in p.symbols.values())}')
    return "\n".join(lines)


def starter(p):
    """The answer cell as it is handed out."""
    width = max(len(a.key) for a in p.answers)
    lines = [f"# {p.id}: your work; then a value for each name"]
    lines += [f"{a.key:<{width}} = None  # {form(a)}: {a.means}" for a in p.answers]
    return "\n".join(lines)


def form(a):
    """The form of an answer, as the notebook announces it: "vector, mm/s"."""
    return str(Form(a.kind, a.unit, a.of))


def receipt_cell(p):
    """The locked cell that checks the form."""
    forms = ", ".join(f'{a.key}="{form(a)}"' for a in p.answers)
    symbols = f"symbols={ {n: s.unit for n, s in p.symbols.items()}!r}, " if p.symbols else ""
    answers = ", ".join(f"{a.key}={a.key}" for a in p.answers)
    return f'expect("{p.id}", {symbols}{forms})\nreceipt("{p.id}", {answers})'


def slug(problem_id):
    """The number of a problem as part of a cell id: 4/16 as 4-16."""
    return problem_id.replace("/", "-")


# -- building


def build(problems, title, seconds, values=None, figures=None):
    """The source notebook of an assignment with the numbers of the book (or ``values``: {id: {name: number}})."""
    cells = [
        _markdown("introduction", INTRODUCTION.format(title=title, seconds=seconds, whose=MASTER_COPY), {"role": "introduction"}),
        _code("setup", SETUP.strip(), {"role": "setup"}, {"grade": False, "solution": False, "locked": True, "grade_id": "setup"}),
    ]
    for p in problems:
        own = (values or {}).get(p.id, p.book_values)
        cells += _problem_cells(p, own, (figures or {}).get(p.id))
    return {
        "nbformat": 4,
        "nbformat_minor": 5,
        "metadata": {
            "kernelspec": {"name": "python3", "display_name": "Python 3", "language": "python"},
            "language_info": {"name": "python"},
            "newton_euler": {"problems": [p.id for p in problems]},
        },
        "cells": cells,
    }


def _problem_cells(p, values, figure):
    n, points = slug(p.id), len(p.answers)
    # generate_assignment replaces the (empty) solution region by ClearSolutions.code_stub; a cell without one would lose its text
    answer = starter(p).replace("\n", "\n### BEGIN SOLUTION\n### END SOLUTION\n", 1)
    theirs = {"grade": True, "solution": True, "locked": False, "grade_id": f"answer-{n}", "points": points}
    ours = {"grade": True, "solution": False, "locked": True, "grade_id": f"receipt-{n}", "points": 0}
    return [
        _statement_cell(p, values, figure),
        _code(f"givens-{n}", givens(p, values), {"role": "givens", "problem": p.id}),
        _code(f"answer-{n}", answer, {"role": "answer", "problem": p.id}, theirs),
        _code(f"receipt-{n}", receipt_cell(p), {"role": "receipt", "problem": p.id}, ours),
    ]


def _statement_cell(p, values, figure):
    cell = _markdown(f"statement-{slug(p.id)}", statement(p, values, figure is not None), {"role": "statement", "problem": p.id})
    if figure is not None:
        cell["attachments"] = {"figure.png": {"image/png": base64.b64encode(figure).decode()}}
    return cell


def _markdown(cell_id, text, ours):
    return {"cell_type": "markdown", "id": cell_id, "metadata": {"newton_euler": ours}, "source": text}


def _code(cell_id, text, ours, nbgrader=None):
    metadata = {"newton_euler": ours}
    if nbgrader:
        metadata["nbgrader"] = {"schema_version": 3, "task": False, "cell_type": "code", **nbgrader}
    return {"cell_type": "code", "id": cell_id, "metadata": metadata, "source": text, "outputs": [], "execution_count": None}


def personal(released, student, values, figures):
    """The released notebook with a student's own numbers and figures; ``values`` and ``figures`` by problem."""
    cells = []
    for cell in released["cells"]:
        role, number_of = _ours(cell).get("role"), _ours(cell).get("problem")
        if role == "statement":
            cell = {**_statement_cell(find_problem(number_of), values[number_of], figures.get(number_of)), "metadata": cell["metadata"]}
        elif role == "introduction":
            cell = {**cell, "source": cell["source"].replace(MASTER_COPY, f"The copy of **{student}**.")}
        elif role == "givens":
            cell = {**cell, "source": givens(find_problem(number_of), values[number_of])}
        cells.append(cell)
    return {**released, "cells": cells}


def shows_other_numbers(notebook, values):
    """The first problem whose numbers in a personal notebook are not ``values``, or None."""
    for cell in notebook["cells"]:
        ours = _ours(cell)
        if ours.get("role") == "givens" and cell["source"] != givens(find_problem(ours["problem"]), values[ours["problem"]]):
            return ours["problem"]
    return None


def _ours(cell):
    ours = cell.get("metadata", {}).get("newton_euler")
    return ours if isinstance(ours, dict) else {}


def problems_of(notebook):
    """The problems of an assignment notebook, in order."""
    return [find_problem(i) for i in notebook["metadata"]["newton_euler"]["problems"]]


# -- taking apart


@dataclass(frozen=True)
class Answer:
    """What came back for one problem: the text of the answer cell, and what was odd about it."""

    text: str
    note: str = ""


def answers(submitted, problems):
    """{problem id: Answer} from a submitted notebook, which is not trusted: only the text of answer cells is read."""
    found = {}
    for cell in submitted.get("cells", []):
        if not isinstance(cell, dict):
            continue
        grade_id, text = _grade_id(cell), _text(cell)
        if grade_id.startswith("answer-"):
            found.setdefault(grade_id, []).append(text)
    return {p.id: _answer(p, found.get(f"answer-{slug(p.id)}", [])) for p in problems}


def _answer(p, texts):
    if not texts:
        return Answer("", f"the answer cell of {p.id} is missing from the notebook; fetch the assignment again and paste your work into it")
    changed = [t for t in dict.fromkeys(texts) if _stripped(t) != _stripped(starter(p))]
    chosen = changed[0] if changed else texts[0]
    if len(texts) > 1:
        which = "the first one that was filled in" if changed else "the first one"
        return Answer(chosen, f"the notebook holds {len(texts)} copies of the answer cell; {which} was graded")
    return Answer(chosen)


def _stripped(text):
    return re.sub(r"\s+|#[^\n]*", "", text)


def is_untouched(p, text):
    """True if the answer cell holds nothing but what was handed out."""
    return _stripped(text) in ("", _stripped(starter(p)))


def _grade_id(cell):
    try:
        return str(cell["metadata"]["nbgrader"]["grade_id"])
    except (KeyError, TypeError):
        return ""


def _text(cell):
    source = cell.get("source", "")
    text = "".join(map(str, source)) if isinstance(source, list) else str(source)
    return text.encode("utf-8", "replace").decode()  # JSON can hold halves of characters, which no file can


def rebuilt(master, given_answers):
    """The master notebook (released, with this student's numbers) with the texts of the answers put in, and nothing else of the submission."""
    cells = []
    for cell in master["cells"]:
        ours = _ours(cell)
        if ours.get("role") == "answer":
            cell = {**cell, "source": given_answers[ours["problem"]].text, "outputs": [], "execution_count": None}
        elif cell["cell_type"] == "code":
            cell = {**cell, "outputs": [], "execution_count": None}
        cells.append(cell)
    return {**master, "cells": cells}


def fingerprint(*contents):
    """A short name for content (texts or bytes), to see whether anything changed."""
    name = hashlib.sha256()
    for content in contents:
        name.update(content.encode() if isinstance(content, str) else content)
        name.update(b"\0")
    return name.hexdigest()[:20]

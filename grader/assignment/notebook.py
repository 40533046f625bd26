"""Builds the notebook of an assignment from the catalogue, and a student's copy of it with other
numbers.

Notebooks are plain dicts here (the JSON of the format), because nbformat validates at every step
and a class has hundreds. Each problem has four
cells: the statement and the givens (with a student's own numbers, without an nbgrader id), the
    answer (editable; of a submission, the only text
that is used) and the receipt (locked, no points, checks the form of the answer).

Courses keep what is written here: a change of cell ids, of grade ids, of MASTER_COPY or of the
numbers and units in :func:`givens` makes assignments that are already handed out impossible to
grade.
"""

import base64
import re

from exercises.catalogue import problem as find_problem
from newton_euler.classroom.forms import Form

GREEK = {
    "alpha": "α", "beta": "β", "gamma": "γ", "delta": "δ", "epsilon": "ε", "zeta": "ζ",
    "eta": "η", "theta": "θ", "kappa": "κ", "lambda": "λ", "mu": "μ", "nu": "ν", "xi": "ξ",
    "rho": "ρ", "sigma": "σ", "tau": "τ", "phi": "φ", "psi": "ψ", "omega": "ω",
    "Omega": "Ω", "Gamma": "Γ", "Delta": "Δ", "Theta": "Θ", "Phi": "Φ", "Psi": "Ψ",
}  # fmt: skip
SETUP = """\
from math import pi

import numpy as np
from sympy import symbols

from newton_euler import Frame, at, atan2, cos, cross, dot, moving, radians, sin, solve_rates, sqrt, tan
from newton_euler.classroom import expect, receipt
"""  # noqa: E501  # a text that students have
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
"""  # noqa: E501  # a text that students have


def pretty(name):
    """A variable name as HTML: ``omega_1`` as an italic omega with an index."""
    base, *indices = name.split("_")
    dots = {"dot": "\u0307", "ddot": "\u0308"}
    mark = "".join(dots[i] for i in indices if i in dots)
    index = ",".join(GREEK.get(i, i) for i in indices if i not in dots)
    return f"<i>{GREEK.get(base, base)}{mark}</i>" + (f"<sub>{index}</sub>" if index else "")


def number(x):
    """The text of a number, floats with six significant digits."""
    return f"{x:.6g}" if isinstance(x, float) else str(x)


def statement(p, values, figure=True):
    """The text of a problem with the student's numbers, as Markdown; the figure is the attachment
    ``figure.png``.
    """
    mentioned = set()

    def substitute(match):
        name = match[1]
        if name not in p.units:
            return match[0]
        if name in p.symbols or name in mentioned:
            return pretty(name)
        mentioned.add(name)
        return f"{pretty(name)} = {number(values[name])}{_unit(p.givens[name].unit)}"

    lines = [f"## {p.id} {p.title}", "", re.sub(r"\{(\w+)\}", substitute, p.text)]
    others = [n for n in p.givens if n not in mentioned]
    if others:
        lines += [
            "",
            "Given: "
            + ", ".join(
                f"{pretty(n)} = {number(values[n])}{_unit(p.givens[n].unit)} ({p.givens[n].means})"
                for n in others
            )
            + ".",
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
    """The source of the cell that defines a student's numbers, and the symbols of a formula."""
    lines = [f"# {p.id}: what is given"]
    width = max((len(f"{n} = {number(values[n])}") for n in p.givens), default=0)
    lines += [
        f"{f'{n} = {number(values[n])}':<{width}}  # {g.unit if g.unit != '1' else 'a ratio'}: "
        f"{g.means}"
        for n, g in p.givens.items()
    ]
    if p.symbols:
        names = list(p.symbols)
        lines.append(
            f'{", ".join(names)} = symbols("{" ".join(names)}", real=True)  # '
            f"{', '.join(s.unit for s in p.symbols.values())}"
        )
    return "\n".join(lines)


def starter(p):
    """The source of the answer cell as it is handed out."""
    width = max(len(a.key) for a in p.answers)
    lines = [f"# {p.id}: your work; then a value for each name"]
    lines += [f"{a.key:<{width}} = None  # {form(a)}: {a.means}" for a in p.answers]
    return "\n".join(lines)


def form(a):
    """The form of an answer as the notebook states it: "vector, mm/s"."""
    return str(Form(a.kind, a.unit, a.of))


def receipt_cell(p):
    """The source of the locked cell that checks the form of the answers."""
    forms = ", ".join(f'{a.key}="{form(a)}"' for a in p.answers)
    symbols = f"symbols={ {n: s.unit for n, s in p.symbols.items()}!r}, " if p.symbols else ""
    answers = ", ".join(f"{a.key}={a.key}" for a in p.answers)
    return f'expect("{p.id}", {symbols}{forms})\nreceipt("{p.id}", {answers})'


def slug(problem_id):
    """The number of a problem as part of a cell id: "4-16" for "4/16"."""
    return problem_id.replace("/", "-")


def answer_id(problem_id):
    """The id of an answer cell, also in nbgrader's gradebook: "answer-4-16"."""
    return f"answer-{slug(problem_id)}"


# -- the whole notebook


def build_notebook(problems, title, seconds, figures=None):
    """The source notebook of an assignment with the numbers of the book; ``figures``: {problem id:
    PNG}; ``seconds``: the time limit of a cell.
    """
    cells = [
        _markdown(
            "introduction",
            INTRODUCTION.format(title=title, seconds=seconds, whose=MASTER_COPY),
            {"role": "introduction"},
        ),
        _code(
            "setup",
            SETUP.strip(),
            {"role": "setup"},
            {"grade": False, "solution": False, "locked": True, "grade_id": "setup"},
        ),
    ]
    for p in problems:
        cells += _problem_cells(p, p.book_values, (figures or {}).get(p.id))
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
    # generate_assignment replaces the (empty) solution region by ClearSolutions.code_stub; a cell
    # without one would lose its text
    answer = starter(p).replace("\n", "\n### BEGIN SOLUTION\n### END SOLUTION\n", 1)
    graded = {
        "grade": True,
        "solution": True,
        "locked": False,
        "grade_id": answer_id(p.id),
        "points": points,
    }
    locked = {
        "grade": True,
        "solution": False,
        "locked": True,
        "grade_id": f"receipt-{n}",
        "points": 0,
    }
    return [
        _statement_cell(p, values, figure),
        _code(f"givens-{n}", givens(p, values), {"role": "givens", "problem": p.id}),
        _code(answer_id(p.id), answer, {"role": "answer", "problem": p.id}, graded),
        _code(f"receipt-{n}", receipt_cell(p), {"role": "receipt", "problem": p.id}, locked),
    ]


def _statement_cell(p, values, figure):
    cell = _markdown(
        f"statement-{slug(p.id)}",
        statement(p, values, figure is not None),
        {"role": "statement", "problem": p.id},
    )
    if figure is not None:
        cell["attachments"] = {"figure.png": {"image/png": base64.b64encode(figure).decode()}}
    return cell


def _markdown(cell_id, text, own):
    return {
        "cell_type": "markdown",
        "id": cell_id,
        "metadata": {"newton_euler": own},
        "source": text,
    }


def _code(cell_id, text, own, nbgrader=None):
    metadata = {"newton_euler": own}
    if nbgrader:
        metadata["nbgrader"] = {"schema_version": 3, "task": False, "cell_type": "code", **nbgrader}
    return {
        "cell_type": "code",
        "id": cell_id,
        "metadata": metadata,
        "source": text,
        "outputs": [],
        "execution_count": None,
    }


def personal_notebook(released, student, values, figures):
    """The released notebook with a student's own numbers and figures; ``values`` and ``figures`` by
    problem.
    """
    cells = []
    for cell in released["cells"]:
        own = own_metadata(cell)
        role, number_of = own.get("role"), own.get("problem")
        if role == "statement":
            cell = {
                **_statement_cell(
                    find_problem(number_of), values[number_of], figures.get(number_of)
                ),
                "metadata": cell["metadata"],
            }
        elif role == "introduction":
            cell = {
                **cell,
                "source": cell["source"].replace(MASTER_COPY, f"The copy of **{student}**."),
            }
        elif role == "givens":
            cell = {**cell, "source": givens(find_problem(number_of), values[number_of])}
        cells.append(cell)
    return {**released, "cells": cells}


def first_differing_problem(notebook, values):
    """The first problem whose numbers or units in a personal notebook are not those of ``values``,
    or None.
    """
    for cell in notebook["cells"]:
        own = own_metadata(cell)
        if own.get("role") == "givens":
            now = givens(find_problem(own["problem"]), values[own["problem"]])
            if _without_meanings(cell["source"]) != _without_meanings(now):
                return own["problem"]
    return None


def _without_meanings(source):
    """A givens cell without the explanation behind each unit, which may be reworded while a course
    runs.
    """
    return re.sub(r"(#[^:\n]*):.*", r"\1", source)


def own_metadata(cell):
    """The metadata that this package wrote into a cell, {"role", "problem"}; {} for other cells."""
    own = cell.get("metadata", {}).get("newton_euler")
    return own if isinstance(own, dict) else {}


def problems_of(notebook):
    """The problems of an assignment notebook, in order."""
    return [find_problem(i) for i in notebook["metadata"]["newton_euler"]["problems"]]

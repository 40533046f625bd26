"""Builds the notebook of an assignment from the catalogue, and a student's copy of it with other
numbers.

Notebooks are plain dicts here (the JSON of the format), because nbformat validates at every step
and a class has hundreds. Each problem has four cells: the statement; the givens, with a student's
own numbers and without an nbgrader id; the answer, which is editable and the only text of a
submission that is used; and the receipt, locked and without points, which checks the form of the
answer.

Courses store what is written here: a change of cell ids, of grade ids, of MASTER_COPY or of the
numbers and units in :func:`givens` makes assignments ungradable that have been handed out.
"""

import base64
import re
from collections.abc import Callable, Iterable, Mapping
from functools import cache, lru_cache

from exercises.catalogue import Problem
from exercises.catalogue import problem as find_problem
from exercises.catalogue.sanity import sane_answers
from exercises.catalogue.sections import section_line
from newton_euler.algebra.language import ENGLISH, Words, _, language
from newton_euler.answers.notation import (
    GREEK,
    bare_unit,
    is_word,
    number_symbol,
    typeset_names,
    unit_symbol,
)

from .cells import (
    NbgraderMetadata,
    Notebook,
    OwnMetadata,
    SheetValues,
    Values,
    code_cell,
    markdown_cell,
    own_metadata,
)
from .spec import Item

SETUP = """\
from math import pi

import numpy as np
from sympy import symbols

from newton_euler import Frame, at, atan2, cos, cross, dot, moving, radians, sin, solve_rates, sqrt, tan
from newton_euler.classroom import expect, given, receipt
"""  # noqa: E501  # a text that students have
MASTER_COPY = Words(
    "> **This copy has the numbers of the book.** Yours has numbers of its own: "
    "fetch the assignment with nbgrader, set up for this course, or ask for your copy."
)
OWN_COPY = Words("The copy of **{student}**.")
INTRODUCTION = Words("""\
Each problem has a cell for your work. It begins with names set to `None`; give each its value, in the unit that is written behind it, and run the
cell below it: the **receipt** says whether your answer can be read (kind, shape, unit of a formula). {notices}

- Vectors are written `[x, y, z]`, in the frame named in the problem; a `Vector` of `newton_euler` is taken too. Angles go into `sin` and `cos` in
  radians.
- The numbers of the problem are in the cell above yours; they are your own. Where a formula is asked for, the symbols are there instead.
- The cells are run once more for grading, from top to bottom, also those that you add; each within {seconds} s, and all of them within {total} s.
  An answer is what its name holds where the receipt stands.
- A problem left at `None` costs nothing but its points.
""")  # noqa: E501  # a text that students have
COMPARED = Words("""\
It does not know the right answer; that is
compared after you hand in, part by part.""")
HINTED = Words("""\
It does not know the right answer; that is
compared after you hand in, part by part, with a hint where a common slip explains the difference.""")  # noqa: E501
SEALED = Words("Where your copy lets it, it also says at once whether an answer is right.")
EXAM = Words("""\
**This is an exam**: it does not say whether an answer is right.
Hand in once, within the window of the exam: the first work counts, and a later one does not replace it. Feedback comes when the exam has closed for
everybody.
""")  # noqa: E501  # a text that students have
GIVEN, WORK = Words("what is given"), Words("your work; then a value for each name")
SPEAKING = """\

from newton_euler.algebra.language import choose_language
choose_language("{language}")
"""


def short_number(x: float) -> str:
    """A number as text, floats with six significant digits."""
    return f"{x:.6g}" if isinstance(x, float) else str(x)


def statement(
    p: Problem, values: Values, figure: bool = True, chapters: str = "", code: bool = True
) -> str:
    """The text of a problem with the student's numbers, as Markdown with formulas of LaTeX between
    dollar signs; the figure is the attachment ``figure.png``. For ``chapters`` see
    :func:`~exercises.catalogue.sections.section_line`. ``code=False`` leaves out names in code and
    the list of those asked for.
    """
    mentioned = set()

    def quantity_or_symbol(match):
        name = match[1]
        if name not in p.units:
            return match[0]
        if name in mentioned:
            return f"${p.notation[name]}$"
        mentioned.add(name)
        return _quantity(p, name, values, code)

    lines = [f"## {p.id} {p.title}", "", typeset(p.text, p, quantity_or_symbol)]
    others = [n for n in p.givens if n not in mentioned]
    if others:
        listed = (
            f"{_quantity(p, n, values, code)}, {typeset(p.givens[n].means, p)}" for n in others
        )
        lines += ["", _("Given: {quantities}.", quantities="; ".join(listed))]
    if figure:
        words = re.sub(r"[\[\]]", r"\\\g<0>", " ".join(p.figure.split()))
        lines += ["", f"![{_('Figure: {words}', words=words)}](attachment:figure.png)"]
    if p.frame:
        lines += ["", f"*{frame_heading(p)}:* {typeset(p.frame, p)}"]
    if code:
        lines += ["", f"*{_('Find')}*", "", *(_asked(p, a) for a in p.answers)]
    lines += ["", section_line(p, chapters)] if p.section else []
    return "\n".join(lines)


def frame_heading(p: Problem) -> str:
    """The heading of ``p.frame``: components, or a note in a problem without vectors."""
    along_axes = any(a.kind.is_along_axes for a in p.answers)
    return _("Components") if along_axes else _("Note")


def _asked(p, a):
    symbol = "" if is_word(a.key) and not a.latex else f" ${p.notation[a.key]}$"
    words = _(": {others} or {last}", others=", ".join(a.of[:-1]), last=a.of[-1]) if a.of else ""
    unit = "" if a.unit == "1" else f"{_(', in ')}${bare_unit(a.unit)}$"
    return f"- `{a.key}`:{symbol and symbol + ','} {typeset(a.means, p)}{unit}{words}"


def typeset(text: str, p: Problem, replaced: Callable[[re.Match[str]], str] | None = None) -> str:
    """A text of the catalogue in LaTeX: each ``{name}`` is replaced by ``replaced(match)``, in a
    formula between dollar signs by its symbol; names of Greek letters by letters.
    """
    parts = re.split(r"(\$[^$]*\$)", text)
    for n, part in enumerate(parts):
        if n % 2:  # a formula, in which {r} may be an argument
            parts[n] = _NAMED.sub(lambda m: f"{{{p.notation.get(m[1], m[1])}}}", part)
        else:
            part = typeset_names(part, p.notation)
            parts[n] = _NAMED.sub(replaced, part) if replaced else part
    return "".join(parts).replace("$ = $", " = ")  # beta = {beta_1} is one formula


_NAMED = re.compile(r"\{(\w+)\}")


def givens(p: Problem, values: Values) -> str:
    """The source of the cell that defines a student's numbers, and the symbols of a formula."""
    lines = definitions(p, values)
    if p.givens:  # so that a receipt can check whether these numbers were used
        lines.append(f'given("{p.id}", {", ".join(f"{n}={n}" for n in p.givens)})')
    return "\n".join(lines)


def definitions(p: Problem, values: Values) -> list[str]:
    """The lines that define a student's numbers, and the symbols of a formula."""
    lines = [f"# {p.id}: {_(GIVEN)}", *givens_lines(p, values)]
    if p.symbols:
        names = list(p.symbols)
        lines.append(
            f'{", ".join(names)} = symbols("{" ".join(names)}", real=True)  # '
            f"{', '.join(s.unit for s in p.symbols.values())}"
        )
    return lines


def givens_lines(p: Problem, values: Values) -> list[str]:
    """The line of each given: its name, number, unit and meaning."""
    width = max((len(f"{n} = {short_number(values[n])}") for n in p.givens), default=0)
    return [
        f"{f'{n} = {short_number(values[n])}':<{width}}  # "
        f"{g.unit if g.unit != '1' else _('a ratio')}: {g.means}"
        for n, g in p.givens.items()
    ]


def starter(p: Problem) -> str:
    """The initial source of the answer cell."""
    width = max(len(a.key) for a in p.answers)
    lines = [f"# {p.id}: {_(WORK)}"]
    lines += [f"{a.key:<{width}} = None  # {a.form.stated}: {a.means}" for a in p.answers]
    return "\n".join(lines)


def receipt_cell(p: Problem, exam: bool = False) -> str:
    """The source of the locked receipt; in an exam it checks only the form of the answers."""
    forms = ", ".join(f'{a.key}="{a.form}"' for a in p.answers)
    symbols = f"symbols={ {n: s.unit for n, s in p.symbols.items()}!r}, " if p.symbols else ""
    own = {q: x.latex for q, x in ({a.key: a for a in p.answers} | p.symbols).items() if x.latex}
    notation = f"notation={own!r}, " if own else ""
    known = False if exam else sane_answers(p)
    sane = f"sane={known!r}, " if exam or known else ""
    return f'expect("{p.id}", {symbols}{notation}{sane}{forms})\nreceipt("{p.id}", globals())'


def slug(problem_id: str) -> str:
    """The number of a problem as part of a cell id: "4-16" for "4/16"."""
    return problem_id.replace("/", "-")


def answer_id(problem_id: str) -> str:
    """The id of an answer cell, also in nbgrader's gradebook: "answer-4-16"."""
    return f"answer-{slug(problem_id)}"


# -- the whole notebook


def build_notebook(
    items: Iterable[Item | Problem],
    title: str,
    seconds: float,
    total: float,
    figures: Mapping[str, bytes | None] | None = None,
    chapters: str = "",
    exam: bool = False,
) -> Notebook:
    """A source notebook of problems and texts with the book's numbers; ``seconds``: per cell,
    ``total``: of all; ``chapters``: where its links lead, see
    :func:`~exercises.catalogue.sections.section_line`; ``exam``: its receipts say nothing of an
    answer but whether it can be read.
    """
    listed = [x if isinstance(x, Item) else Item(x) for x in items]
    levels = {x.options.get("help") for x in listed if x.problem}
    notices = [EXAM if exam else COMPARED if levels == {"none"} else HINTED]
    notices += [SEALED] * bool(levels - {None, "none"})
    limits = {"seconds": f"{seconds:g}", "total": f"{total:g}"}
    text = _(INTRODUCTION, notices="\n".join(_(x).strip() for x in notices), **limits)
    text = f"# {title}\n\n{_(MASTER_COPY)}\n\n{text}"
    setup = SETUP if language() == ENGLISH else SETUP + SPEAKING.format(language=language())
    locked: NbgraderMetadata = {
        "grade": False, "solution": False, "locked": True, "grade_id": "setup",
    }  # fmt: skip
    cells = [
        markdown_cell("introduction", text, {"role": "introduction"}),
        code_cell("setup", setup.strip(), {"role": "setup"}, locked),
    ]
    for n, item in enumerate(listed):
        if p := item.problem:
            figure = (figures or {}).get(p.id)
            cells += _problem_cells(p, p.book_values, figure, chapters, item.options, exam)
        else:
            cells.append(markdown_cell(f"text-{n}", item.text, {"role": f"text-{n}"}))
    return {
        "nbformat": 4,
        "nbformat_minor": 5,
        "metadata": {
            "kernelspec": {"name": "python3", "display_name": "Python 3", "language": "python"},
            "language_info": {"name": "python"},
        },
        "cells": cells,
    }


def _problem_cells(p, values, figure, chapters, options, exam):
    n = slug(p.id)
    # an empty solution region for generate_assignment, which would clear a cell without one
    answer = starter(p).replace("\n", "\n### BEGIN SOLUTION\n### END SOLUTION\n", 1)
    asked = {a.key: str(a.form) for a in p.answers}
    own: OwnMetadata = {"role": "answer", "problem": p.id, "asked": asked}
    own |= {key: options[key] for key in options.keys() - {"points"}}  # type: ignore[typeddict-item]
    marks: NbgraderMetadata = {
        "grade": True, "solution": True, "locked": False, "grade_id": answer_id(p.id),
        "points": options.get("points", len(asked)),
    }  # fmt: skip
    locked: NbgraderMetadata = {
        "grade": True, "solution": False, "locked": True, "grade_id": f"receipt-{n}", "points": 0,
    }  # fmt: skip
    return [
        _statement_cell(p, values, figure, chapters, options.get("tolerance")),
        code_cell(f"givens-{n}", givens(p, values), {"role": "givens", "problem": p.id}),
        code_cell(answer_id(p.id), answer, own, marks),
        code_cell(
            f"receipt-{n}", receipt_cell(p, exam), {"role": "receipt", "problem": p.id}, locked
        ),
    ]


def _statement_cell(p, values, figure, chapters, tolerance):
    right = f"\n\n*{_('Tolerance')}:* {100 * tolerance:g} %" if tolerance else ""
    cell = markdown_cell(
        f"statement-{slug(p.id)}",
        statement(p, values, figure is not None, chapters) + right,
        {"role": "statement", "problem": p.id},
    )
    if figure is not None:
        cell["attachments"] = _attached(figure)
    return cell


def _attached(figure):
    return {"figure.png": {"image/png": base64.b64encode(figure).decode()}}


def personal_notebook(
    released: Notebook, student: str, values: SheetValues, figures: Mapping[str, bytes | None]
) -> Notebook:
    """The released notebook with a student's own numbers and figures; ``values`` and ``figures`` by
    problem.

    An instructor's changes of our cells are kept: only numbers are replaced.
    """
    cells = []
    for cell in released["cells"]:
        own = own_metadata(cell)
        role, number_of = own.get("role"), own.get("problem")
        if role in ("statement", "givens") and number_of in values:
            p = find_problem(number_of)
            change = statement_with if role == "statement" else _givens_with
            cell = {**cell, "source": change(p, cell["source"], values[number_of])}
            if "figure.png" in cell.get("attachments", {}) and figures.get(number_of):
                cell["attachments"] = {**cell["attachments"], **_attached(figures[number_of])}
        elif role == "introduction":
            text = cell["source"].replace(_(MASTER_COPY), _(OWN_COPY, student=student))
            cell = {**cell, "source": text}
        cells.append(cell)
    return {**released, "cells": cells}


def statement_with(p: Problem, text: str, values: Values) -> str:
    """The text of a problem with a student's numbers in place of those of its givens."""
    pieces, numbers = _around_numbers(p, text)
    own = [written(values[name]) for name, written in numbers]
    return "".join(x for pair in zip(pieces, [*own, ""], strict=True) for x in pair)


@lru_cache(maxsize=1000)
def _around_numbers(p, text):
    """A text split at the numbers of its givens: (the pieces around them, [(name, function that
    writes the number)]).
    """
    if not p.givens:
        return [text], []
    now, earlier = _givens_in(p)
    by_latex = {p.notation[name]: name for name in p.givens}
    by_markup = {_earlier_markup(name): name for name in p.givens}
    found = [(m, by_latex[m[1]], number_symbol) for m in now.finditer(text) if m[1]]
    found += [(m, by_markup[m[1]], short_number) for m in earlier.finditer(text)]
    found.sort(key=lambda f: f[0].start())
    pieces, at = [], 0
    for m, *_names in found:
        pieces.append(f"{text[at : m.end(1)]} = ")
        at = m.end()
    return [*pieces, text[at:]], [(name, written) for _, name, written in found]


@cache
def _givens_in(p):
    """Patterns of "symbol = number" for the givens of ``p``, as written now and by earlier
    releases; group 1 is the symbol, empty in ``\\bar b = 8``, which is another symbol.
    """
    digits = r"[-+]?\d[\d.]*(?: \\times 10\^\{-?\d+\}|e[-+]?\d+)?"
    symbols = "|".join(re.escape(p.notation[name]) for name in p.givens)
    start = r"(?<![\w\\{}^|])"
    now = rf"\\[a-z]+ {start}(?:{symbols}) = {digits}|{start}({symbols}) = {digits}"
    earlier = "|".join(re.escape(_earlier_markup(name)) for name in p.givens)
    return re.compile(now), re.compile(rf"({earlier}) = [-+]?\d[\d.]*(?:e[-+]?\d+)?")


def _earlier_markup(name):
    """A name as in statements of earlier releases: an italic omega with an index for omega_1."""
    base, *indices = name.split("_")
    dots = {"dot": "\u0307", "ddot": "\u0308"}
    mark = "".join(dots[i] for i in indices if i in dots)
    index = ",".join(GREEK.get(i, i) for i in indices if i not in dots)
    return f"<i>{GREEK.get(base, base)}{mark}</i>" + (f"<sub>{index}</sub>" if index else "")


def _quantity(p, name, values, code):
    """A given with its number, and its name in the code where that differs from the symbol."""
    in_code = f" (`{name}`)" if code and p.quantities[name].latex else ""
    if name in p.symbols:
        return f"${p.notation[name]}${in_code}"
    stated = number_symbol(values[name]) + unit_symbol(p.givens[name].unit)
    return f"${p.notation[name]} = {stated}${in_code}"


def _givens_with(p, source, values):
    """A cell of givens with a student's numbers in place of the book's."""
    for name, book, own in zip(p.givens, _book_lines(p), givens_lines(p, values), strict=True):
        if book in source:
            source = source.replace(book, own)
        else:  # a line changed by the instructor
            line = f"{name} = {short_number(values[name])}"
            source = re.sub(rf"(?m)^{name} = [-+.\w]+", line, source)
    return source


@cache
def _book_lines(p):
    return givens_lines(p, p.book_values)

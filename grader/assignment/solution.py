"""The worked solution of a problem in Markdown: text, steps, terms of each sum, answers."""

import re
from typing import Any

from exercises.catalogue import Problem
from exercises.catalogue.steps import steps
from exercises.catalogue.wording import term_text
from newton_euler.algebra.scalars import is_numeric, to_plain
from newton_euler.algebra.vectors import Vector
from newton_euler.answers.notation import (  # fmt: skip
    is_word,
    list_symbol,
    matrix_symbol,
    number_symbol,
    symbol,
    unit_symbol,
)

from .cells import Values
from .notebook import statement, typeset


def worked_solution(p: Problem, values: Values, text: bool = True) -> str:
    """The worked solution as Markdown, for ``values`` in the units of the text, with SymPy symbols
    for quantities without a number; ``text``: with the text of the problem before it.
    """
    answers, notation = p.solve(values), p.notation
    lines = [statement(p, values, figure=False), "", "*Solution*", ""] if text else []
    found = steps(p, values)
    shown = tuple(f"{key}_" for key, answer in answers.items() if _is_sum(answer))
    listed = [s for s in found if not (s.term and s.key.startswith(shown))]
    for n, s in enumerate(listed, 1):
        latex = symbol(s.key, s.is_vector)
        equation = _equation(latex, s.value, s.unit, notation)
        lines.append(f"{n}. {_sentence(_means(s, p))}{_where(s)}: {equation}")
    lines += ["", *(line for a in p.answers for line in _answer(p, a, answers[a.key], found))]
    return "\n".join(lines)


def _is_sum(answer):
    """True if an answer is shown with a table of its terms, which are then not listed as steps."""
    return isinstance(answer, Vector) and len(answer.terms) > 1


def _means(step, p):
    """The description of a step, with formulas in LaTeX."""
    if not step.term:
        return typeset(step.means, p)
    of = step.means.rpartition(", in ")[-1]  # the sum
    words = _words(*step.term, p)
    return f"{words}, in ${symbol(of, step.is_vector)}$"


def _words(name, equation, p):
    """A term in words; its formula is LaTeX of the engine, in which {a} is not a given."""
    parts = re.split(r"(\$[^$]*\$)", term_text(name, equation, p, latex=True))
    return "".join(x if n % 2 else typeset(x, p) for n, x in enumerate(parts))


def _sentence(means):
    """With a capital letter, but "x component of ..." as it is."""
    return means if means[1:2] in (" ", "") else means[:1].upper() + means[1:]


def _where(s):
    places = [f"section {s.section}"] * bool(s.section) + [f"({s.equation})"] * bool(s.equation)
    return f", {', '.join(places)}" if places else ""


def _equation(latex, value, unit, notation):
    stated = _latex(value, notation) + unit_symbol(unit)
    return f"${latex} = {stated}$" if latex else f"${stated}$"


def _latex(value, notation):
    """An answer in LaTeX, numbers with six significant digits."""
    if isinstance(value, Vector):
        value = _without_noise(value)
    if isinstance(value, (tuple, list)) and all(isinstance(x, (tuple, list)) for x in value):
        return matrix_symbol([[_latex(x, notation) for x in row] for row in value])
    if isinstance(value, (Vector, tuple, list)):
        inside = list_symbol(_latex(v, notation) for v in value)
        return rf"\left[{inside}\right]"
    if isinstance(value, str):
        return rf"\text{{{value}}}"
    if is_numeric(value):
        return number_symbol(value if isinstance(value, int) else float(value))
    import sympy

    return sympy.latex(value, symbol_names={x: notation.get(x.name) or symbol(x.name)
                                            for x in value.free_symbols})  # fmt: skip


def _without_noise(vector):
    """The vector without components that are round-off, such as cos(60 deg) - 1/2."""
    numbers = [abs(x) for x in vector.components() if is_numeric(x)]
    return vector.rounded(1e-12 * float(max(numbers))) if numbers else vector


def formatted(value: Any) -> str:
    """An answer as text, numbers with six significant digits."""
    if isinstance(value, (Vector, tuple, list)):
        return "[" + ", ".join(formatted(v) for v in value) + "]"
    return (
        f"{float(value):.6g}"
        if is_numeric(value) and not isinstance(value, (int, str))
        else str(value)
    )


def _answer(p, a, value, found):
    latex = "" if is_word(a.key) and not a.latex else p.notation[a.key]
    equation = _equation(latex, value, a.unit, p.notation)
    yield f"**{_sentence(typeset(a.means, p))}:** {equation}"
    yield ""
    if _is_sum(value):
        # in chapter 2 the equations have other numbers than in the engine
        own = [s.equation for s in found if s.term and s.key.startswith(f"{a.key}_")]
        yield from _ledger(value.explain(), a.unit, p, own[0] if own else "")
        yield ""


def _ledger(explained, unit, p, number):
    """The terms of an answer as a table, each in words and with its value. A zero term is left out
    if it comes from a frame or a force, and listed if it belongs to an equation of relative motion.
    """
    equation = explained.equation
    yield f"*By equation ({number or equation.number}) the sum of*"
    yield ""
    yield "| term | value |"
    yield "| --- | --- |"
    for name, term in explained.terms.items():
        if name in equation.terms or any(x != 0 for x in map(to_plain, term.c)):
            cells = _words(name, equation, p), f"${_latex(term, p.notation)}{unit_symbol(unit)}$"
            cells = (c.replace("|", r"\vert ") for c in cells)  # a bar would end the cell
            yield f"| {' | '.join(cells)} |"

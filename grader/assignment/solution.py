"""The worked solution of a problem in a student's own numbers: the text, the steps one after the
other, the terms of each sum, the answers. Markdown.
"""

from exercises.steps import steps
from newton_euler.algebra.scalars import is_numeric
from newton_euler.algebra.vectors import Vector
from newton_euler.classroom.notation import is_word, list_symbol, number_symbol, symbol, unit_symbol

from .notebook import statement, typeset


def worked_solution(p, values, text=True):
    """The worked solution as Markdown, for ``values`` in the units of the text, with SymPy symbols
    for quantities without a number; ``text``: with the text of the problem before it.
    """
    answers, notation = p.solve(values), p.notation
    lines = [statement(p, values, figure=False), "", "*Solution*", ""] if text else []
    found = steps(p, values)
    for n, s in enumerate(found, 1):
        latex = symbol(s.key, s.is_vector)
        equation = _equation(latex, s.value, s.unit, notation)
        lines.append(f"{n}. {_sentence(typeset(s.means, p))}{_where(s)}: {equation}")
    lines += ["", *(line for a in p.answers for line in _answer(p, a, answers[a.key], found))]
    return "\n".join(lines)


def _sentence(means):
    return means[:1].upper() + means[1:]


def _where(s):
    places = [f"section {s.section}"] * bool(s.section) + [f"({s.equation})"] * bool(s.equation)
    return f", {', '.join(places)}" if places else ""


def _equation(latex, value, unit, notation):
    stated = _latex(value, notation) + unit_symbol(unit)
    return f"${latex} = {stated}$" if latex else f"${stated}$"


def _latex(value, notation):
    """An answer in LaTeX, numbers with six significant digits."""
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


def formatted(value):
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
    if isinstance(value, Vector) and len(value.terms) > 1:
        # in chapter 2 the equations have other numbers than in the engine
        own = [s.equation for s in found if s.term and s.key.startswith(f"{a.key}_")]
        yield from _ledger(value.explain(), a.unit, p.notation, own[0] if own else "")
        yield ""


# v_B would be taken for the velocity of a point B of the problem
_ORIGIN = {
    ("velocity", "origin"): r"\mathbf{v}_{\text{origin}}",
    ("acceleration", "origin"): r"\mathbf{a}_{\text{origin}}",
}


def _ledger(explained, unit, notation, number):
    """The terms of a sum as a table: name, formula and value of each."""
    where, number = explained.vector.frame.name, number or explained.equation.number
    about = f"{explained.equation.kind} {explained.ledger.subject}"
    yield f"*{_sentence(about)}, equation ({number}), components in {where}:*"
    yield ""
    yield "| term | formula | value |"
    yield "| --- | --- | --- |"
    for name, term in (*explained.terms.items(), ("sum", explained.vector)):
        formula = explained.equation.terms.get(name, ("", ""))[1]
        formula = _ORIGIN.get((explained.equation.kind, name), formula)
        value = _latex(term, notation) + unit_symbol(unit)
        cells = name, f"${formula}$" if formula else "", f"${value}$"
        # a bar would end the cell
        yield f"| {' | '.join(c.replace('|', chr(92) + 'vert ') for c in cells)} |"

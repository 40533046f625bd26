"""The worked solution of a problem in Markdown: text, steps, terms of each sum, answers."""

import re

from exercises.catalogue import Problem
from exercises.catalogue.book_equations import book_equations, own_number
from exercises.catalogue.steps import is_sum
from exercises.catalogue.wording import term_text
from newton_euler.algebra.language import _, spoken
from newton_euler.algebra.scalars import to_plain
from newton_euler.answers.notation import symbol, unit_symbol

from .cells import Values
from .lines import latex_of, lines
from .notebook import statement, typeset
from .spelled import typeset_formulas


def worked_solution(p: Problem, values: Values, text: bool = True, formulas: bool = True) -> str:
    """The worked solution as Markdown; ``text``: preceded by the text of the problem; ``formulas``:
    with the formula of each value.
    """
    out = [statement(p, values, figure=False), "", f"*{_('Solution')}*", ""] if text else []
    found = {line.step.key: line for line in lines(p, values, formulas=formulas)}
    answers = {a.key: found[a.key].step.value for a in p.answers}
    shown = {
        *answers,
        *(key for key, line in found.items() if is_sum(answers.get(line.step.of), p)),
    }
    n = 0
    for key, line in found.items():
        if key in answers:
            out += _answer(p.answer(key), line, p, found.values())
        elif key not in shown:
            n += 1
            means = _not_twice(_means(line.step, p), line.equal[0])
            out += [f"{n}. {_sentence(means)}{_where(line.step)}: {_chain(line)}"]
    return "\n".join(out)


def _chain(line):
    """A quantity and its equal forms, in pieces between which lines can break."""
    first, *others = line.equal
    begin = f"{line.name} = {first}" if line.name else first
    pieces = [f"${begin}$", *(f"$= {x}$" for x in others)]
    begin = _equations(line) or (_("from the equations above") if line.above else "")
    end = f" ({_('its formula is too long for a page')})" * line.too_long
    return f"{begin}: {' '.join(pieces)}{end}" if begin else f"{' '.join(pieces)}{end}"


def _equations(line):
    """The equations to be solved first, or ""."""
    rows = "; ".join(f"${row}$" for row in line.together)
    numbers = "; ".join(f"${row}$" for row in line.with_numbers)
    found = _("from {equations}", equations=rows) if rows else ""
    return found + (_(", with numbers {numbers}", numbers=numbers) if numbers else "")


def _means(step, p):
    """The description of a step, with formulas in LaTeX."""
    if not step.term:
        return _typeset(step.means, p)
    return f"{_words(*step.term, p)}{_(', in ')}${symbol(step.of, step.is_vector)}$"


def _not_twice(means, formula):
    """A description without a formula at its end that is written after it anyway."""
    shown = _names_in(formula.partition(r"\ \text")[0])  # the unit left out
    return _BEHIND_COMMA.sub(lambda m: "" if _names_in(m[1]) == shown else m[0], means)


def _names_in(formula):
    return {*re.findall(r"\\[A-Za-z]+|[A-Za-z]+|\d+", formula)} - _LAYOUT


_LAYOUT = {"0", r"\frac", r"\left", r"\right", r"\cdot", r"\text", r"\mathbf", r"\hat"}
_BEHIND_COMMA = re.compile(r"[,:] \$([^$=]*)\$(?=$|[,;:])")


def _typeset(means, p):
    return typeset_formulas(means, p.notation, lambda text: typeset(text, p))


def _words(name, equation, p):
    """A term in words; braces in its LaTeX, from the engine, are not givens."""
    parts = re.split(r"(\$[^$]*\$)", spoken(term_text(name, equation, p, latex=True)))
    return "".join(x if n % 2 else typeset(x, p) for n, x in enumerate(parts))


def _sentence(means):
    """The text with a capital letter, except "x component of ..."."""
    is_name = means[1:2] in (" ", "") and means[:1] != "a"
    return means if is_name else means[:1].upper() + means[1:]


def _where(s):
    """The section and equation of a quantity; the equation in full unless for a term of a sum."""
    places = [
        _("section {number}", number=s.section) if s.section != "A" else _("appendix A")
    ] * bool(s.section)
    if s.equation:
        stated = book_equations().get(s.equation)
        places.append(f"({s.equation})" + f" ${stated}$" * bool(stated and not s.term))
    return f", {', '.join(places)}" if places else ""


def _answer(a, line, p, found):
    """An answer, after a table of its terms if it is a sum."""
    yield ""
    if is_sum(line.step.value, p):
        terms = {x.step.term[0]: x for x in found if x.step.of == a.key}
        yield from _ledger(a, line.step.value, p, terms)
    because = f". {_typeset(a.because, p)}" * bool(a.because)
    yield from (f"**{_sentence(_typeset(a.means, p))}:** {_chain(line)}{because}", "")


def _ledger(a, value, p, found):
    """The terms of an answer as a table: words, formula and value. Zero terms are listed if they
    belong to an equation of relative motion, and omitted if they come from a frame or a force.

    found : the lines of terms by their names
    """
    explained = value.explain()
    equation = explained.equation
    # chapter 2 numbers equations differently from the engine
    cited_by = next((x.step.equation for x in found.values()), equation.number)
    number = own_number(cited_by, p)
    stated = book_equations()["of_sum"].get(equation.kind) or book_equations().get(number)
    for x in found.values():
        if x.together:
            yield from (f"{_sentence(_equations(x))}:", "")
    formula = f", ${stated}$," * bool(stated)
    yield (
        _("By equation ({number}){formula} the sum of", number=number, formula=formula)
        if number
        else _("The sum of")
    )
    yield ""
    yield f"| {_('term')} | {_('value')} |"
    yield "| --- | --- |"
    for name, term in explained.terms.items():
        if name in equation.terms or any(x != 0 for x in map(to_plain, term.c)):
            equal = [f"{latex_of(term, p.notation)}{unit_symbol(a.unit)}"]
            equal = found[name].equal if name in found else equal
            cells = _words(name, equation, p), " = ".join(equal)
            words, how = (c.replace("|", r"\vert ") for c in cells)  # a bar ends a cell
            yield f"| {words} | ${how}$ |"
    yield ""

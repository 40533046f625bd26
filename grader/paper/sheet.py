"""A student's sheet and its key, as Typst."""

import base64
import hmac
import json
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from exercises.catalogue import Problem, problem
from newton_euler.answers.notation import is_word, list_symbol, number_symbol, unit_symbol

from ..assignment.cells import SheetValues, Values
from ..assignment.chosen import as_asked
from ..assignment.figures import figure_svg
from ..assignment.lines import lines
from ..assignment.notebook import slug, statement, statement_with, typeset
from ..assignment.solution import worked_solution
from ..practice.plain import plain
from ..scoring.margins import margins
from ..scoring.numbers import numbers_of
from .markup import BLANK, formula, in_line, string, typst

LOOK = Path(__file__).with_name("paper.typ").read_bytes()
ROOM = 4.0, 1.5  # cm of room for a problem, and for each of its answers
OWN_ROOM, YOURS = 6.0, "*Your answer*"  # room and heading of an instructor's own question
Files = dict[str, bytes]  # what Typst compiles: {name: content}


@dataclass(frozen=True)
class PaperItem:
    """A problem of a sheet, with its text if the instructor has changed it, and its options; a
    text; or an instructor's own ``question`` with its ``key``.
    """

    problem: str = ""
    text: str = ""
    points: float = 0
    options: Mapping[str, Any] = field(default_factory=dict)
    question: str = ""
    key: str = ""

    @property
    def asked(self) -> Problem:
        """The problem with the options of the sheet."""
        return as_asked(problem(self.problem), self.options)


@dataclass(frozen=True)
class Student:
    """The owner of a sheet: login, name, the code of the variant, the numbers of each problem."""

    login: str
    name: str
    code: str
    values: SheetValues


def sheet(title: str, entries: Iterable[PaperItem], student: Student) -> Files:
    """The files of one student's sheet."""
    entries, files = list(entries), Files()
    out = [_written(e, student, files) for e in entries]
    return files | _page(title, student, entries, out)


def _written(e, student, files):
    """An entry of a sheet; its figure is added to the files."""
    if e.question:
        return f"#problem({_points(e.points)}, [{typst(e.text or YOURS)}], room: {OWN_ROOM}cm)\n\n"
    if not e.problem:
        return typst(e.text)
    p, values = e.asked, student.values[e.problem]
    text = statement(p, values, figure=False, code=False)
    text = statement_with(p, e.text, values) if e.text else text
    parts = [_points(e.points), f"[{typst(text)}]"]
    if svg := figure_svg(p, values):
        files[name := f"{slug(p.id)}.svg"] = svg
        parts.append(f"drawing: {string(name)}, words: {string(plain(p.figure, p.units))}")
    rows = ", ".join(f"{_means(p, a)}, [{_to_fill_in(p, a)}]" for a in p.answers)
    parts += [f"asked: answers({rows})", f"room: {ROOM[0] + ROOM[1] * len(p.answers)}cm"]
    return f"#problem({', '.join(parts)})\n\n"


def key(title: str, entries: Iterable[PaperItem], student: Student) -> Files:
    """The files of the key of one student's sheet: numbers, answers with tolerance, derivations."""
    entries, out = list(entries), []
    for e in entries:
        if e.question:
            out.append(f"#problem({_points(e.points)}, [{typst(f'## {e.question}')}])\n")
            out.append(typst(e.key))
        elif e.problem:
            p, values = e.asked, student.values[e.problem]
            stated = [number_symbol(values[n]) + unit_symbol(g.unit) for n, g in p.givens.items()]
            given = zip(p.givens, stated, strict=True)
            heading = f"#problem({_points(e.points)}, [{typst(f'## {p.id} {p.title}')}])\n"
            numbers = typst("; ".join(f"${p.notation[n]} = {x}$" for n, x in given))
            share = e.points / sum(a.weight for a in p.answers)
            rows = (
                f"{_means(p, a)}, [{right}], [{off}], {string(f'{a.weight * share:.3g}')}"
                for a, right, off in answers(p, values)
            )
            cells = ", ".join(["[Answer], [Right], [Tolerance], [Points]", *rows])
            table = f"#terms-table((2fr, 2fr, 1fr, auto), {cells})"
            out.append(f"#block(breakable: false)[{heading}{numbers}{table}]\n\n")
            out.append(typst(worked_solution(p, {**p.sympy_symbols(), **values}, text=False)))
    return _page(title, student, entries, out, key=True)


def overview(title: str, entries: Iterable[PaperItem], students: Iterable[Student]) -> Files:
    """The files of a table of all students' right answers, problem by problem."""
    students, out = list(students), [typst(f"# {title}: all answers")]
    for p in (e.asked for e in entries if e.problem):
        out.append(typst(f"## {p.id} {p.title}"))
        names = (f"[{name}]" if (name := _name(p, a)) else _means(p, a) for a in p.answers)
        head = ["[Student]", "[Variant]", *names]
        known = [(s.login, s.code, s.values[p.id]) for s in students]
        known = known if p.givens else [("all", "", {})]
        rows = (
            [string(login), string(code), *(f"[{x}]" for _, x, _ in answers(p, values))]
            for login, code, values in known
        )
        cells = ", ".join([*head, *(cell for row in rows for cell in row)])
        out.append(f"#terms-table((auto, auto) + (1fr,) * {len(p.answers)}, {cells})\n\n")
    whose = f"{len(students)} student{'s' * (len(students) != 1)}"
    return _files(title, whose, "", out, "key: true, flipped: true")


def answers(p: Problem, values: Values) -> list[tuple[Any, str, str]]:
    """[(answer, its right value, its tolerance)] in Typst."""
    found = {x.step.key: x for x in lines(p, {**p.sympy_symbols(), **values}, formulas=False)}
    right = numbers_of(p, values).key
    return [
        (a, in_line(found[a.key].equal[-1], "5cm"), _tolerance(a, right[a.key][0]))
        for a in p.answers
    ]


def _tolerance(a, point):
    if a.kind.is_word:
        return "as it is"
    if a.kind.is_formula:
        return "any equal formula"
    off = margins(a, point)
    if off is None:
        return f"{a.rtol:.1%}, any length and sense"
    errors = list_symbol(dict.fromkeys(number_symbol(float(f"{x:.2g}")) for x in off))
    limits = formula(rf"\pm {errors}{unit_symbol(a.unit)}")
    return f"${limits}$"


def _means(p, a):
    means = typeset(a.means, p)
    return f"[{typst(means[:1].upper() + means[1:])}]"


def _to_fill_in(p, a):
    if a.of:
        return " #h(1em) ".join(f"#box[#tick #{string(word)}]" for word in a.of)
    name = _name(p, a)
    places = a.kind.typeset([BLANK] * a.kind.length)
    return f"{name}{' = ' * bool(name)}${formula(places + unit_symbol(a.unit))}$"


def _name(p, a):
    """The symbol of an answer, "" for a word."""
    return "" if is_word(a.key) and not a.latex else f"${formula(p.notation[a.key])}$"


def _points(points):
    return string(f"{points:g} point{'s' * (points != 1)}")


# -- the page


def _page(title, student, entries, body, key=False):
    points = f"{sum(e.points for e in entries):g}"
    parts = map(string, (title, student.name, student.login, student.code, points))
    which = f"key: {str(key).lower()}"
    front = f"#front({', '.join(parts)}, {which})\n\n"
    return _files(title, student.name, student.code, [front, *body], which)


def _files(title, name, code, body, options):
    head = ", ".join(map(string, (title, name, code)))
    preamble = f'#import "paper.typ": *\n#show: body => paper({head}, body, {options})\n'
    return {"main.typ": (preamble + "".join(body)).encode(), "paper.typ": LOOK}


def variant_code(digest: bytes, values: Mapping[str, Any]) -> str:
    """A short code for these numbers, as "K7QF-2M3P"; ``digest`` is secret."""
    text = json.dumps(values, sort_keys=True).encode()
    made = base64.b32encode(hmac.digest(digest, text, "sha256"))[:8].decode()
    return f"{made[:4]}-{made[4:]}"

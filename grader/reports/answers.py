"""Answers of problems as text and JSON."""

from collections.abc import Mapping
from typing import Any

from exercises.catalogue import Answer, Problem, variants
from newton_euler.algebra.scalars import to_plain
from newton_euler.algebra.vectors import Vector

from ..assignment.cells import Values
from ..assignment.lines import formatted
from ..assignment.lines import lines as solution_lines

Results = Mapping[str, Any]  # the answers of a problem, by key


def given_values(p: Problem, seed: int | None, changes: Mapping[str, float]) -> Values:
    """The numbers of the book, or of a variant by ``seed``, updated with ``changes``."""
    values = p.book_values if seed is None else variants.draw(p, f"seed {seed}".encode())
    return {**values, **changes}


def solve_problem(p: Problem, seed: int | None, changes: Mapping[str, float]) -> Results:
    """The answers of a problem, with SymPy symbols for quantities without a number."""
    return p.solve({**p.sympy_symbols(), **given_values(p, seed, changes)})


def answers_json(p: Problem, results: Results) -> dict[str, Any]:
    """{key: {"kind", "value" or "expr", "unit"}} for JSON; formulas as SymPy reads them."""
    return {
        a.key: {
            "kind": a.kind.name,
            "expr" if a.kind.is_formula else "value": as_json(a, results[a.key]),
            "unit": a.unit,
        }
        for a in p.answers
    }


def as_json(a: Answer, value: Any) -> Any:
    """An answer as a number, a word, a formula as text, or nested lists of these."""
    if isinstance(value, (Vector, tuple, list)):
        return [as_json(a, x) for x in value]
    x = to_plain(value)
    if a.kind.is_formula:
        return str(x)
    return x if isinstance(x, (int, str)) else float(x)


def answers_text(p: Problem, results: Results) -> str:
    """The answers of a problem as text with rich's markup, one line each."""
    lines = [f"[bold]{p.id}[/] {p.title}"]
    for a in p.answers:
        unit = "" if a.unit == "1" else f" {a.unit}"
        lines.append(f"  {a.key} = {formatted(results[a.key])}{unit}   ({a.means})")
    return "\n".join(line.replace("[", r"\[") if line.startswith("  ") else line for line in lines)


def solution_text(p: Problem, values: Values) -> str:
    """The steps and answers of a problem, as text with rich's markup: meaning, section and equation
    of the book, formula in symbols and in numbers, and value.
    """
    out = []
    for line in solution_lines(p, {**p.sympy_symbols(), **values}, latex=False):
        s = line.step
        cited = [f"section {s.section}"] * bool(s.section) + [f"({s.equation})"] * bool(s.equation)
        out.append(", ".join([s.means, *cited]))
        out += [f"    {row}" for row in (*line.together, *line.with_numbers)]
        out.append(f"  {' = '.join([line.name, *line.equal])}")
    return "\n".join(out).replace("[", r"\[")

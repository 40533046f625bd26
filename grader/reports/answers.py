"""Answers of problems as text and JSON."""

from exercises.catalogue import variants
from newton_euler.algebra.scalars import to_plain
from newton_euler.algebra.vectors import Vector

from ..assignment.solution import formatted


def given_values(p, seed, changes):
    """The numbers of the book, or with a ``seed`` those of a drawn variant, with some replaced by
    ``changes``.
    """
    values = p.book_values if seed is None else variants.draw(p, f"seed {seed}".encode())
    return {**values, **changes}


def solve_problem(p, seed, changes):
    """The answers of a problem, with SymPy symbols for quantities without a number."""
    return p.solve({**p.sympy_symbols(), **given_values(p, seed, changes)})


def answers_json(p, results):
    """The answers for JSON: {key: {"kind", "value" or "expr", "unit"}}; formulas as text that SymPy
    can read.
    """
    out = {}
    for a in p.answers:
        value = results[a.key]
        if a.kind.is_formula:
            out[a.key] = {"kind": a.kind.name, "expr": nested(value, str), "unit": a.unit}
        else:
            out[a.key] = {
                "kind": a.kind.name,
                "value": nested(value, _plain),
                "unit": a.unit,
            }
    return out


def nested(value, convert):
    """An answer as a number or as nested lists, with ``convert`` applied to each entry."""
    if isinstance(value, (Vector, tuple, list)):
        return [nested(v, convert) for v in value]
    return convert(to_plain(value))


def _plain(x):
    return x if isinstance(x, (int, str)) else float(x)


def answers_text(p, results):
    """The answers of a problem as text with rich's markup, one line each."""
    lines = [f"[bold]{p.id}[/] {p.title}"]
    for a in p.answers:
        unit = "" if a.unit == "1" else f" {a.unit}"
        lines.append(f"  {a.key} = {formatted(results[a.key])}{unit}   ({a.means})")
    return "\n".join(line.replace("[", r"\[") if line.startswith("  ") else line for line in lines)


def terms_text(p, results):
    """The terms of the answers that are sums of named terms, as text with rich's markup."""
    texts = [
        str(results[a.key].explain(a.unit))
        for a in p.answers
        if isinstance(results[a.key], Vector) and results[a.key].terms
    ]
    return "\n".join(text.replace("[", r"\[") for text in texts)

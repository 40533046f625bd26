"""Answers for the command line: solved, as JSON, in words."""

from exercises import variants
from exercises.catalogue import SYMBOLIC
from newton_euler.scalars import is_numeric, plain
from newton_euler.vectors import Vector


def given_values(p, seed, changes):
    """The numbers of the book, or of a drawn variant, with some replaced."""
    values = p.book_values if seed is None else variants.draw(p, f"seed {seed}".encode())
    return {**values, **changes}


def solved(p, seed, changes):
    """The answers, with SymPy symbols for what has no number."""
    return p.solve({**p.sympy_symbols(), **given_values(p, seed, changes)})


def answers_json(p, results):
    """{key: {"kind", "value" or "expr", "unit"}} for JSON; formulas as text that SymPy reads."""
    out = {}
    for a in p.answers:
        value = results[a.key]
        if a.kind in SYMBOLIC:
            out[a.key] = {"kind": a.kind, "expr": _nested(value, str), "unit": a.unit}
        else:
            out[a.key] = {"kind": a.kind, "value": _nested(value, _number if a.kind != "choice" else str), "unit": a.unit}
    return out


def _nested(value, each):
    if isinstance(value, (Vector, tuple, list)):
        return [_nested(v, each) for v in value]
    return each(plain(value))


def _number(x):
    return x if isinstance(x, int) else float(x)


def in_words(p, results):
    """The answers for a reader."""
    lines = [f"[bold]{p.id}[/] {p.title}"]
    for a in p.answers:
        unit = "" if a.unit == "1" else f" {a.unit}"
        lines.append(f"  {a.key} = {_shown(results[a.key])}{unit}   ({a.means})")
    return "\n".join(line.replace("[", r"\[") if line.startswith("  ") else line for line in lines)


def _shown(value):
    if isinstance(value, (Vector, tuple, list)):
        return "[" + ", ".join(_shown(v) for v in value) + "]"
    return f"{float(value):.6g}" if is_numeric(value) and not isinstance(value, (int, str)) else str(value)


def explained(p, results):
    """The terms of the answers that are named sums."""
    texts = [str(results[a.key].explain(a.unit)) for a in p.answers if isinstance(results[a.key], Vector) and results[a.key].terms]
    return "\n".join(text.replace("[", r"\[") for text in texts)

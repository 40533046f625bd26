"""Answers of problems and results of grading as text, JSON and tables for the terminal."""

from collections import Counter

from rich.markup import escape
from rich.table import Table

from exercises import variants
from exercises.catalogue import SYMBOLIC
from newton_euler.algebra.scalars import is_numeric, to_plain
from newton_euler.algebra.vectors import Vector

# -- answers


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
        if a.kind in SYMBOLIC:
            out[a.key] = {"kind": a.kind, "expr": nested(value, str), "unit": a.unit}
        else:
            out[a.key] = {
                "kind": a.kind,
                "value": nested(value, _number if a.kind != "choice" else str),
                "unit": a.unit,
            }
    return out


def nested(value, convert):
    """An answer as a number or as nested lists, with ``convert`` applied to each entry."""
    if isinstance(value, (Vector, tuple, list)):
        return [nested(v, convert) for v in value]
    return convert(to_plain(value))


def _number(x):
    return x if isinstance(x, int) else float(x)


def answers_text(p, results):
    """The answers of a problem as text with rich's markup, one line each."""
    lines = [f"[bold]{p.id}[/] {p.title}"]
    for a in p.answers:
        unit = "" if a.unit == "1" else f" {a.unit}"
        lines.append(f"  {a.key} = {_formatted(results[a.key])}{unit}   ({a.means})")
    return "\n".join(line.replace("[", r"\[") if line.startswith("  ") else line for line in lines)


def _formatted(value):
    if isinstance(value, (Vector, tuple, list)):
        return "[" + ", ".join(_formatted(v) for v in value) + "]"
    return (
        f"{float(value):.6g}"
        if is_numeric(value) and not isinstance(value, (int, str))
        else str(value)
    )


def terms_text(p, results):
    """The terms of the answers that are sums of named terms, as text with rich's markup."""
    texts = [
        str(results[a.key].explain(a.unit))
        for a in p.answers
        if isinstance(results[a.key], Vector) and results[a.key].terms
    ]
    return "\n".join(text.replace("[", r"\[") for text in texts)


# -- results of grading


def gradebook_table(results):
    """A table with one row per student: points, number of answers by verdict, and the most frequent
    diagnosis.
    """
    table = Table(title="Gradebook", title_justify="left")
    for name, justify in (
        ("student", "left"),
        ("points", "right"),
        ("%", "right"),
        ("right", "right"),
        ("wrong", "right"),
        ("not read", "right"),
        ("blank", "right"),
        ("most frequent diagnosis", "left"),
    ):
        table.add_column(name, justify=justify, overflow="fold")
    for r in results:
        if r.problem:
            table.add_row(
                escape(r.student), "–", "–", "", "", "", "", "[red]not graded, see below[/]"
            )
            continue
        verdicts = Counter(p.verdict for s in r.scores.values() for p in s.parts)
        share = f"{100 * r.points / r.out_of:.0f}" if r.out_of else "–"
        table.add_row(
            escape(r.student),
            f"{r.points:g}/{r.out_of:g}",
            share,
            *(str(verdicts[v]) for v in ("right", "wrong", "unreadable", "blank")),
            escape(_most_frequent(r)),  # it may quote a message from the student's code
        )
    return table


def _most_frequent(result):
    """The most frequent diagnosis of a result; without any, its most frequent note."""
    diagnoses = Counter(text for _, _, text in result.diagnoses())
    if diagnoses:
        (text, count) = diagnoses.most_common(1)[0]
        others = sum(diagnoses.values()) - count
        return f"{text} ({count}×)" + (f", and {others} more" if others else "")
    notes = Counter(s.note.split(",")[0] for s in result.scores.values() if s.note)
    return notes.most_common(1)[0][0] if notes else result.note


def diagnosis_table(results, most=None):
    """A table of the diagnoses by student and problem: all, or the first ``most``."""
    rows = [(r.student, *entry) for r in results for entry in r.diagnoses()]
    left_out = f" (the first {most} of {len(rows)})" if most and len(rows) > most else ""
    table = Table(title=f"Diagnoses{left_out}", title_justify="left")
    for name in ("student", "problem", "answer", "diagnosis"):
        table.add_column(name, overflow="fold")
    for row in rows[:most]:
        table.add_row(*map(escape, row))
    return table

"""Results as tables for the terminal."""

from collections import Counter

from rich.markup import escape
from rich.table import Table


def gradebook_table(results):
    """One row per student: points, how the parts were judged, and the diagnosis told most."""
    table = Table(title="Gradebook", title_justify="left")
    for name, justify in (
        ("student", "left"),
        ("points", "right"),
        ("%", "right"),
        ("right", "right"),
        ("wrong", "right"),
        ("not read", "right"),
        ("blank", "right"),
        ("told most often", "left"),
    ):
        table.add_column(name, justify=justify, overflow="fold")
    for r in results:
        if r.problem:
            table.add_row(escape(r.student), "–", "–", "", "", "", "", "[red]not graded, see below[/]")
            continue
        verdicts = Counter(p.verdict for s in r.scores.values() for p in s.parts)
        share = f"{100 * r.points / r.out_of:.0f}" if r.out_of else "–"
        table.add_row(
            escape(r.student),
            f"{r.points:g}/{r.out_of:g}",
            share,
            *(str(verdicts[v]) for v in ("right", "wrong", "unreadable", "blank")),
            escape(_most_told(r)),  # may quote what the student's code said
        )
    return table


def _most_told(result):
    told = Counter(text for _, _, text in result.diagnoses())
    if told:
        (text, count) = told.most_common(1)[0]
        others = sum(told.values()) - count
        return f"{text} ({count}×)" + (f", and {others} more" if others else "")
    notes = Counter(s.note.split(",")[0] for s in result.scores.values() if s.note)
    return notes.most_common(1)[0][0] if notes else result.note


def diagnoses(results, most=None):
    """The diagnoses by student and problem: all, or the first ``most``."""
    told = [(r.student, *entry) for r in results for entry in r.diagnoses()]
    left_out = f" (the first {most} of {len(told)})" if most and len(told) > most else ""
    table = Table(title=f"Diagnoses{left_out}", title_justify="left")
    for name in ("student", "problem", "answer", "what the answer says"):
        table.add_column(name, overflow="fold")
    for row in told[:most]:
        table.add_row(*map(escape, row))
    return table

"""Tables of results for the terminal, in 80 columns; students' texts are shown without control
characters.
"""

from collections import Counter
from collections.abc import Iterable, Sequence
from statistics import mean, median

from rich import box
from rich.markup import escape
from rich.table import Table

from ..course.take_in import TakeInResult
from ..grading import Result
from ..sandbox import CAGED
from ..submission.pipeline import MARK

MOST = 600  # characters of a text in a table


def plain_table(title: str, *columns: str) -> Table:
    """A table without vertical lines; ``columns`` are names, with a leading ``>`` for numbers."""
    table = Table(title=title, title_justify="left", box=box.SIMPLE_HEAD, pad_edge=False)
    for name in columns:
        if name.startswith(">"):
            table.add_column(name[1:], justify="right", no_wrap=True, overflow="fold")
        else:
            table.add_column(name, overflow="fold")
    return table


def in_cell(text: object) -> str:
    """A text for a cell of a table: without markup and control characters; of a very long one, as
    a student may call a file, the two ends.
    """
    line = str(text)
    if len(line) > MOST:
        line = f"{line[: MOST // 2]} … {line[-MOST // 2 :]}"
    return escape("".join(c if c.isprintable() else "\ufffd" for c in line))


def gradebook_table(results: Sequence[Result]) -> Table:
    """A row for each student (points, answers by verdict, remark), and a summary."""
    columns = ("student", ">points", ">%", *(f">{m}" for m in MARK.values()), "remark")
    table = plain_table("Gradebook  (✓ right, ✗ wrong, ? not read, – blank)", *columns)
    # unsandboxed code may have changed the others' results
    uncaged = any(r.sandbox != CAGED for r in results)
    for r in results:
        if r.problem:
            table.add_row(in_cell(r.student), "–", "–", *[""] * 4, "[red]not graded, see below[/]")
            continue
        found = Counter(p.verdict for s in r.scores.values() for p in s.parts)
        remark = "; ".join([*(["unsandboxed"] if uncaged else []), *_remarks(r)])
        points, verdicts = f"{r.points:.4g}/{r.out_of:g}", (str(found[v]) for v in MARK)
        percent = f"{100 * r.points / r.out_of:.0f}" if r.out_of else "–"
        table.add_row(in_cell(r.student), points, percent, *verdicts, in_cell(remark))
    _add_summary(table, results)
    return table


def _remarks(r):
    """Remarks on a result: cells to grade, penalty, extra points, the most frequent diagnosis."""
    if r.waiting:
        yield f"{r.waiting} to grade by hand"
    if r.penalty:
        yield f"{r.penalty:g} off for lateness"
    if r.extra:
        yield f"{r.extra:g} extra"
    if text := _most_frequent(r):
        yield text


def _most_frequent(result):
    """The most frequent diagnosis of a result, or else note."""
    diagnoses = Counter(text for _, _, text in result.diagnoses())
    if diagnoses:
        (text, count) = diagnoses.most_common(1)[0]
        others = sum(diagnoses.values()) - count
        return f"{text} ({count}×)" + (f", and {others} more" if others else "")
    notes = Counter(s.note.split(",")[0] for s in result.scores.values() if s.note)
    if notes:
        return notes.most_common(1)[0][0]
    return "" if result.note == result.sandbox else result.note  # the row shows it anyway


def _add_summary(table, results):
    graded = [r for r in results if not r.problem]
    if len(graded) < 2:
        return
    table.add_section()
    for name, middle in (("mean", mean), ("median", median)):
        shares = [r.points / r.out_of for r in graded if r.out_of]
        points = middle([r.points for r in graded])
        table.add_row(
            name, f"{points:.4g}", f"{100 * middle(shares):.0f}" if shares else "–", *[""] * 5
        )
    found = Counter(p.verdict for r in graded for s in r.scores.values() for p in s.parts)
    waiting = sum(r.waiting for r in graded)
    remarks = [f"{len(graded)} graded"]
    remarks += [f"{len(results) - len(graded)} not"] if len(results) > len(graded) else []
    remarks += [f"{waiting} cells wait for a person"] if waiting else []
    table.add_row("all", "", "", *(str(found[v]) for v in MARK), ", ".join(remarks))


def diagnosis_table(results: Iterable[Result], most: int | None = None) -> Table:
    """A table of the diagnoses by student and problem: all, or the first ``most``."""
    rows = [(r.student, *entry) for r in results for entry in r.diagnoses()]
    left_out = f" (the first {most} of {len(rows)})" if most and len(rows) > most else ""
    table = plain_table(f"Diagnoses{left_out}", "student", "problem", "answer", "diagnosis")
    for row in rows[:most]:
        table.add_row(*map(in_cell, row))
    return table


def taken_in_table(taken: TakeInResult) -> Table:
    """The outcome for the files of an archive."""
    table = plain_table("Work in the archive", "student", "file", "what became of it")
    for student, name in taken.taken.items():
        table.add_row(in_cell(student), in_cell(name), "[green]taken in[/]")
    for student, name in taken.kept:
        table.add_row(
            in_cell(student), in_cell(name), "had handed in before; --replace takes this one"
        )
    for name, why in taken.refused:
        table.add_row("–", in_cell(name), f"[red]left out:[/] {in_cell(why)}")
    return table

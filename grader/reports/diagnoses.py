"""How often the grader recognises listed mistakes."""

from collections import Counter
from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import Any

from rich.table import Table

from exercises.catalogue import Problem
from exercises.catalogue.variants import draw
from newton_euler.answers.receipts import record

from ..scoring import score_receipt
from .tables import plain_table

OUTCOMES = ("named", "misnamed", "unnamed", "passed")


def diagnosis_shares(
    problems: Iterable[Problem], draws: int, progress: Callable[[], object] = lambda: None
) -> dict[str, Counter[str]]:
    """{problem id: Counter of :data:`OUTCOMES`} over the book's numbers and ``draws`` - 1 drawn
    sets: each listed mistake is made, written down as by a student, and scored.

    named: recognised, perhaps with others that give the same answer; misnamed: taken for another
    mistake; unnamed: not explained; passed: taken for right.
    """
    found: dict[str, Counter[str]] = {}
    for p in problems:
        found[p.id] = Counter()
        for n in range(draws if p.givens else 1):
            values = p.book_values if n == 0 else draw(p, f"diagnose {n}".encode())
            found[p.id].update(_outcomes(p, values))
        progress()
    return found


def _outcomes(p, values):
    right = p.solve({**p.sympy_symbols(), **values})
    for name, answers in p.wrong({**p.sympy_symbols(), **values}).items():
        if name in p.same_in_book and values == p.book_values:
            continue
        # a mistake in a word may give the right one
        made = {k: x for k, x in answers.items() if not p.answer(k).kind.is_word or x != right[k]}
        for key, tree in handed_in(p, made).items():
            part = next(
                x for x in score_receipt(p, values, {"answers": {key: tree}}).parts if x.key == key
            )
            yield _outcome(part, name)


def handed_in(p: Problem, answers: Mapping[str, Any]) -> dict[str, Any]:
    """Answers, right or wrong, in the form of a student's receipt."""
    forms = {a.key: a.form for a in p.answers if a.key in answers}
    read, faults = record(forms, {n: s.unit for n, s in p.symbols.items()}, answers)
    if faults:
        raise ValueError(f"a listed mistake of {p.id} cannot be handed in: {faults}")
    return read


def _outcome(part, mistake):
    if part.verdict == "right":
        return "passed"
    named = any((c.group, c.name) == ("listed", mistake) for c in part.causes)
    return "named" if named else "misnamed" if part.causes else "unnamed"


def shares_table(
    found: Mapping[str, Counter[str]],
    title: str = "Listed mistakes",
    of: str = "problem",
    outcomes: Sequence[str] = OUTCOMES,
) -> Table:
    """The shares as a table for the terminal, with totals."""
    table = plain_table(title, of, ">made", *(f">{name} %" for name in outcomes))
    for name, counts in found.items():
        table.add_row(name, *_row(counts, outcomes))
    table.add_section()
    table.add_row("all", *_row(sum(found.values(), Counter()), outcomes))
    return table


def _row(counts, outcomes):
    made = sum(counts.values())
    return str(made), *(f"{100 * counts[o] / made:.1f}" if made else "–" for o in outcomes)

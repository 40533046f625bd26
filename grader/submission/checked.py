"""How many wrong answers a student checked, as the receipts of the submitted notebook recorded it,
in copies that tell right from wrong. Students can edit the notebook: a count may be too low.
"""

from collections.abc import Iterator, Mapping
from typing import Any

from newton_euler.algebra.language import _

from ..assignment.cells import Notebook, own_metadata

MOST = 10**6


def checked_notes(master: Notebook, submitted: Mapping[str, Any]) -> dict[str, str]:
    """{problem: a note that counts the wrong answers that were checked, by answer}."""
    counts: dict[str, dict[str, int]] = {}
    for cell in submitted["cells"]:
        for key, n in _counts(cell) if isinstance(cell, dict) else ():
            own = own_metadata(cell)
            problem = own.get("problem")
            if own.get("role") == "receipt" and isinstance(problem, str):
                of_problem = counts.setdefault(problem, {})
                of_problem[key] = max(n, of_problem.get(key, 0))
    notes = {}
    for own in map(own_metadata, master["cells"] if counts else ()):
        found = counts.get(own.get("problem", ""), {})
        texts = [f"{key} {found[key]}" for key in own.get("asked", ()) if key in found]
        if texts:
            notes[own["problem"]] = _(
                "wrong answers checked before it was handed in: {counts}", counts=", ".join(texts)
            )
    return notes


def _counts(cell: Mapping[str, Any]) -> Iterator[tuple[str, int]]:
    outputs = cell.get("outputs")
    for output in outputs if isinstance(outputs, list) else ():
        found = own_metadata(output) if isinstance(output, dict) else {}
        wrong: Any = found.get("wrong")
        for key, n in wrong.items() if isinstance(wrong, dict) else ():
            if type(n) is int and 0 < n < MOST:
                yield key, n

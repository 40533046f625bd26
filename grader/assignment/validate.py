"""The report of nbgrader's Validate on a sheet: open problems, unreadable answers, or that nothing
was checked. nbgrader itself reports an untouched problem as a failure, and a sheet without checks
as a success.

This file is copied into COURSE/student/ and runs on the students' side, where grader and exercises
are not installed. If nbgrader's internals differ, Validate is left as it is.
"""

import contextlib
import html
import inspect
import os
from collections.abc import Callable, Iterator
from datetime import datetime
from typing import Any

OPEN = "OpenAnswer"  # the class of a receipt's error for open answers
CELL_SECONDS = 10.0  # limit of a cell in grading
# methods of nbgrader's Validator used here, with their arguments
INTERNALS = {
    "validate": "self filename", "validate_and_print": "self filename", "_preprocess": "self nb",
    "_get_type_changed_cells": "self nb", "_get_changed_cells": "self nb",
    "_extract_error": "self cell",
}  # fmt: skip
HEADING = "#validation-message > div > p"  # the dialog's own "The following cell failed:"
WORDS = {"read": "answered", "open": "open", "wrong": "to correct, or without points"}
READ = "Whether an answer is right is not checked here: that is graded once it is handed in."


def apply() -> bool:
    """Patch Validate to report problems; returns False, without a change, if nbgrader differs."""
    try:
        from nbgrader.validator import Validator
    except ImportError:
        return False
    if getattr(
        Validator.validate, "of_problems", False
    ):  # patched before: a server may reread its settings
        return True
    if any(_arguments(Validator, name) != given for name, given in INTERNALS.items()):
        return False
    Validator.validate = _validate(Validator.validate)
    Validator.validate_and_print = _validate_and_print(Validator.validate_and_print)
    return True


def _arguments(owner, name):
    found = getattr(owner, name, None)
    return " ".join(inspect.signature(found).parameters) if found else ""


def _validate(original: Callable) -> Callable:
    """A replacement of ``Validator.validate``, whose result the button's dialog shows."""

    def validate(self: Any, filename: str) -> dict[str, list[dict[str, str]]]:
        report = _report(self, filename)
        if report is None:
            return original(self, filename)
        good, first, lines = report
        if good:
            return {}
        text = "\n".join(lines)
        plain = f"<style>{HEADING} {{ display: none }}</style>{html.escape(text)}"
        return {"failed": [{"source": first, "error": plain, "raw_error": text}]}

    validate.of_problems = True  # type: ignore[attr-defined]
    return validate


def _validate_and_print(original: Callable) -> Callable:
    """A replacement of ``Validator.validate_and_print`` of the command line."""

    def validate_and_print(self: Any, filename: str) -> None:
        report = _report(self, filename)
        if report is None:
            original(self, filename)
        else:
            _, first, lines = report
            self.stream.write("\n".join([first, *lines]) + "\n")

    return validate_and_print


def _report(validator, filename):
    """(whether all is answered and readable, the first sentence, lines), or None to leave the
    report to nbgrader.
    """
    from nbformat import current_nbformat, read

    notebook = read(filename, as_version=current_nbformat)
    if validator.invert or validator._get_type_changed_cells(notebook):
        return None
    with contextlib.chdir(os.path.dirname(filename) or "."):
        notebook = validator._preprocess(notebook)
    changed = validator._get_changed_cells(notebook)
    found = [*_problems(notebook), *_questions(notebook, validator)]
    lines = [f"{name}: {text}" for name, _, text in found]
    for cell in changed:
        name = _own(cell).get("problem") or cell.metadata.nbgrader.grade_id
        lines.append(f"{name}: a cell of the sheet was changed; it is graded as it was handed out")
    if not found:
        return False, NOTHING, lines
    states = [state for _, state, _ in found]
    good = all(state == "read" for state in states)
    return good, _first(states), [*lines, READ] if "read" in states else lines


NOTHING = (
    "Nothing was checked: this notebook has no cell that is graded. If it is a sheet, its cells "
    "have lost their marks, as copied cells do: fetch it again, and paste your answers into it."
)


def _first(states):
    if set(states) == {"read"}:
        return f"Success! All is answered, and can be read ({len(states)} of {len(states)})."
    if set(states) == {"open"}:
        return f"Nothing is answered yet ({len(states)} open); an open answer earns no points."
    counts = {what: states.count(s) for s, what in WORDS.items() if s in states}
    return f"Of {len(states)}: {', '.join(f'{n} {what}' for what, n in counts.items())}."


def _own(cell: Any) -> dict[str, Any]:
    return cell.metadata.get("newton_euler", {})


def _problems(notebook: Any) -> Iterator[tuple[str, str, str]]:
    """(number, "read", "open" or "wrong", words) of each problem of the catalogue."""
    cells: dict[str, dict[str, Any]] = {}
    for cell in notebook.cells:
        number: str = _own(cell).get("problem", "")
        if number and cell.cell_type == "code":
            cells.setdefault(number, {})[_own(cell).get("role", "")] = cell
    for number, by_role in cells.items():
        state, text = _state(by_role.get("answer"), by_role.get("receipt"))
        lines = (line.removeprefix(number).lstrip(",: ") for line in text.splitlines())
        yield number, state, _line("; ".join(lines))


def _state(answer, receipt):
    if answer is None:
        return "wrong", (
            "the cell for its answer is gone, or pasted as a copy, so that the grader may not find "
            "it: fetch the sheet again, and paste your answer into its cell"
        )
    if error := _error(answer):
        return "wrong", f"your cell ends in an error, {error.ename}: {error.evalue}"
    if (seconds := _seconds(answer)) > CELL_SECONDS:
        return (
            "wrong",
            f"your cell took {seconds:.0f} s; the grader stops it after {CELL_SECONDS:g} s",
        )
    if receipt is None:
        return "open", "not checked: the cell with its receipt is gone. It is graded all the same"
    if error := _error(receipt):
        return "open" if error.ename == OPEN else "wrong", error.evalue
    return "read", "\n".join(o.data.get("text/plain", "") for o in receipt.outputs if "data" in o)


def _questions(notebook: Any, validator: Any) -> Iterator[tuple[str, str, str]]:
    """The same for each question of the instructor's own."""
    from nbgrader import utils

    for cell in notebook.cells:
        if _own(cell).get("role") or not utils.is_grade(cell):
            continue
        name, (score, most) = cell.metadata.nbgrader.grade_id, utils.determine_grade(cell)
        if score is None:
            yield name, "read", "answered; a person grades it"
        elif utils.is_solution(cell):
            yield name, "open", "no answer yet"
        elif score < most:
            yield name, "wrong", f"its test fails. {_line(validator._extract_error(cell))[-300:]}"
        else:
            yield name, "read", "its test passes"


def _error(cell):
    return next((o for o in cell.outputs if o.output_type == "error"), None)


def _line(text):
    return " ".join(text.split())


def _seconds(cell):
    """The run time of a cell."""
    times = cell.metadata.get("execution", {})
    with contextlib.suppress(KeyError, ValueError):
        start, end = (times[n] for n in ("iopub.execute_input", "shell.execute_reply"))
        return (datetime.fromisoformat(end) - datetime.fromisoformat(start)).total_seconds()
    return 0.0

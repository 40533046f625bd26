"""Reads the output of the cage as data: bytes up to a limit, lines of JSON of a known form."""

import json
from collections.abc import Collection
from typing import Any, TypedDict


class RawReceipt(TypedDict):
    """The answers to one problem as the cage has read and sent them: they may be anything."""

    id: Any
    answers: Any
    faults: Any
    error: Any


class Outcome(TypedDict):
    """An error as a sentence, and the value of the last expression: a number, "other", None."""

    error: str | None
    value: Any


OUTPUT_LIMIT = 2**20  # bytes of the receipts of one submission
LINE_LIMIT = 2**16  # bytes of one line; the cage sends none longer
MOST_LINES = 10_000  # lines that are read; a notebook has one for each problem and each error
OUTCOME_LIMIT = 2**13  # bytes of the outcome of one test
ERROR_LIMIT = 500  # characters of an error
# levels of nested lists in a receipt: writing deeper JSON would exceed the recursion limit
DEPTH = 400
NOT_REACHED: Outcome = {
    "error": "the test was not run: the notebook ended before it, or its process ended",
    "value": None,
}


def read_lines(
    data: bytes, problems: Collection[str], names: Collection[str]
) -> tuple[dict[str, RawReceipt], dict[str, str]]:
    """({problem id: receipt}, {name: error}): the lines of ``data`` that are receipts of these
    problems or errors of these cells; the first of each.
    """
    receipts: dict[str, RawReceipt] = {}
    errors: dict[str, str] = {}
    for line in data.split(b"\n", MOST_LINES)[:MOST_LINES]:
        entry = _entry(line)
        number, name = entry.get("id"), entry.get("name")
        if isinstance(number, str) and number in problems:
            receipts.setdefault(number, _receipt(number, entry))
        elif isinstance(name, str) and name in names and isinstance(entry.get("error"), str):
            errors.setdefault(name, entry["error"][:ERROR_LIMIT])
    return receipts, errors


def _receipt(number: str, entry: dict[str, Any]) -> RawReceipt:
    answers, faults = entry.get("answers"), entry.get("faults")
    return {"id": number, "answers": answers, "faults": faults, "error": entry.get("error")}


def read_outcome(data: bytes, token: str) -> Outcome:
    """The first outcome in ``data`` with this token; else :data:`NOT_REACHED`."""
    for line in data.split(b"\n"):
        entry = _entry(line)
        if entry.get("token") == token:
            return _outcome(entry.get("error", ""), entry.get("value"))
    return NOT_REACHED.copy()


def _outcome(error, value):
    if isinstance(error, str) and error:
        return {"error": error[:ERROR_LIMIT], "value": None}
    if error is None and (value is None or value == "other" or _is_finite(value)):
        return {"error": None, "value": value}
    return NOT_REACHED.copy()


def _is_finite(value):
    return isinstance(value, int | float) and not isinstance(value, bool) and value - value == 0


def _entry(line):
    if len(line) > LINE_LIMIT:
        return {}
    try:
        entry = json.loads(line)
        if b"\\ud" in line.lower():  # lone surrogates, which no file or database takes
            entry = json.loads(json.dumps(entry, ensure_ascii=False).encode("utf-8", "replace"))
    except (ValueError, RecursionError):
        return {}
    deep = line.count(b"[") + line.count(b"{") > DEPTH and not _is_shallow(entry)
    return entry if isinstance(entry, dict) and not deep else {}


def _is_shallow(value):
    level = [value]
    for _ in range(DEPTH):
        level = [
            x
            for v in level
            if isinstance(v, (list, dict))
            for x in (v.values() if isinstance(v, dict) else v)
        ]
        if not level:
            return True
    return False

"""Merges a source notebook that an instructor has changed with the present exercises.

Each part of a cell (text, pictures, metadata of nbgrader and of this package) is compared with the
last build: changes of the instructor stay, changes of the exercises come in, and where both
changed, the instructor's stays and is reported. An instructor's own cells, order and deletions are
kept.
"""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from typing import Any

from .cells import Cell, Notebook, own_metadata

PARTS = ("source", "attachments", "nbgrader", "newton_euler")
_VOLATILE = ("checksum", "schema_version", "cell_type")  # which nbgrader rewrites at any time


@dataclass(frozen=True)
class MergeResult:
    """The merged notebook, and the names of cells that differ from the present exercises.

    kept : cells changed by the instructor; conflicts : those whose changed part the exercises have
    changed, too. removed : cells of problems no longer selected
    """

    notebook: Notebook
    kept: list[str] = field(default_factory=list)
    conflicts: list[str] = field(default_factory=list)
    removed: list[str] = field(default_factory=list)


def merged(base: Notebook, theirs: Notebook, ours: Notebook) -> MergeResult:
    """The instructor's notebook ``theirs`` with the changes from ``base``, the last build, to
    ``ours``, the present one.
    """
    before, now = _by_name(base["cells"]), _by_name(ours["cells"])
    result = MergeResult({**theirs, "cells": []})
    cells = result.notebook["cells"]
    for cell in theirs["cells"]:
        name = _name(cell)
        if name in now:
            cells.append(_merged_cell(before.get(name), cell, now[name], result))
        elif name in before and _changed(before[name], cell) == []:
            result.removed.append(name)
        else:
            cells.append(cell)
    _insert(cells, (c for n, c in now.items() if n not in before), list(now))
    return result


def _by_name(cells: Iterable[Cell]) -> dict[str, Cell]:
    return {name: cell for cell in cells if (name := _name(cell))}


def _name(cell):
    """The name of a cell of ours, its problem and role; "" for an instructor's."""
    own = own_metadata(cell)
    return " ".join(filter(None, (own.get("problem"), own.get("role"))))


def _part(cell: Mapping[str, Any], part: str) -> Any:
    if part == "source":
        return "".join(cell["source"])
    if part == "attachments":
        return cell.get("attachments") or {}
    marks = cell["metadata"].get(part, {})
    return {key: x for key, x in marks.items() if key not in _VOLATILE}


def _changed(cell, other):
    return [part for part in PARTS if _part(cell, part) != _part(other, part)]


def _merged_cell(base, theirs, ours, result):
    """The instructor's cell with the parts that only the exercises have changed."""
    mine = [p for p in _changed(theirs, ours) if base is None or _part(theirs, p) != _part(base, p)]
    if mine:
        result.kept.append(_name(theirs))
    if base is not None and any(_part(ours, p) != _part(base, p) for p in mine):
        result.conflicts.append(_name(theirs))
    cell = {**theirs, "metadata": dict(theirs["metadata"])}
    for part in (p for p in _changed(theirs, ours) if p not in mine):
        place, new = (ours, cell) if part in PARTS[:2] else (ours["metadata"], cell["metadata"])
        if part in place:
            new[part] = place[part]
        else:
            new.pop(part, None)
    return cell


def _insert(cells, new, order):
    """Insert new cells after those that precede them in ``order``."""
    for cell in new:
        earlier = set(order[: order.index(_name(cell))])
        place = max((n for n, c in enumerate(cells) if _name(c) in earlier), default=-1)
        cells.insert(place + 1, cell)

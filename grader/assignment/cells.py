"""The cells of a notebook, as JSON: the metadata of this package and of nbgrader, and a cell's role
in grading.

Courses store these names: renaming a key or a role makes notebooks ungradable that have been handed
out.
"""

from collections.abc import Mapping
from typing import Any, NotRequired, TypedDict

Values = dict[str, Any]  # the numbers of one problem, by the names of its givens
SheetValues = dict[str, Values]  # the numbers of a sheet, by problem
Hashable = tuple[tuple[str, Any], ...]
Sources = dict[str, tuple[str, str]]  # (text, checksum) of cells in the gradebook, by grade id


class OwnMetadata(TypedDict, total=False):
    """The metadata of this package, under "newton_euler".

    role : see :func:`kind`. problem : its number, as "4/16". asked : {key: form} of an answer cell.
    weights, follow_through, tolerance, help : may be added to an answer cell by the instructor, see
        :class:`~grader.assignment.sheet.Task`
    """

    role: str
    problem: str
    asked: dict[str, str]
    weights: dict[str, float]
    follow_through: float
    tolerance: float
    help: str


class NbgraderMetadata(TypedDict, total=False):
    """The metadata of nbgrader, under "nbgrader"."""

    schema_version: int
    cell_type: str
    grade_id: str
    grade: bool
    solution: bool
    locked: bool
    task: bool
    points: float
    checksum: str


class Cell(TypedDict):
    """A cell with its source as one string; ``outputs`` and ``execution_count`` of code only."""

    cell_type: str
    id: str
    metadata: dict[str, Any]
    source: str
    outputs: NotRequired[list[Any]]
    execution_count: NotRequired[int | None]
    attachments: NotRequired[dict[str, Any]]


class Notebook(TypedDict):
    """A notebook of format 4."""

    nbformat: int
    nbformat_minor: int
    metadata: dict[str, Any]
    cells: list[Cell]


def markdown_cell(cell_id: str, text: str, own: OwnMetadata) -> Cell:
    """A cell of text."""
    metadata = {"newton_euler": own}
    return {"cell_type": "markdown", "id": cell_id, "metadata": metadata, "source": text}


def code_cell(
    cell_id: str, text: str, own: OwnMetadata, nbgrader: NbgraderMetadata | None = None
) -> Cell:
    """A cell of code that has not been run."""
    metadata: dict[str, Any] = {"newton_euler": own}
    if nbgrader:
        metadata["nbgrader"] = {"schema_version": 3, "task": False, "cell_type": "code", **nbgrader}
    return {
        "cell_type": "code", "id": cell_id, "metadata": metadata, "source": text, "outputs": [],
        "execution_count": None,
    }  # fmt: skip


def own_metadata(cell: Mapping[str, Any]) -> OwnMetadata:
    """The metadata of this package in a cell, or {}."""
    return _metadata(cell, "newton_euler")


def nbgrader_metadata(cell: Mapping[str, Any]) -> NbgraderMetadata:
    """The metadata of nbgrader in a cell, or {}."""
    return _metadata(cell, "nbgrader")


def hashable(values: Values) -> Hashable:
    """The numbers of a problem in an order of their own, for sets and keys."""
    return tuple(sorted(values.items()))


def _metadata(cell: Mapping[str, Any], who: str) -> Any:
    """A part of a cell's metadata; {} if it is missing or malformed."""
    metadata = cell.get("metadata")
    part = metadata.get(who) if isinstance(metadata, dict) else None
    return part if isinstance(part, dict) else {}


def kind(cell: Mapping[str, Any]) -> str:
    """The role of a trusted cell in grading. Ours are "introduction", "setup", "statement",
    "givens", "answer" and "receipt"; an instructor's "test" (autograder tests), "hand" (an answer
    that a person grades), "task" (one without a place for the answer), "solution" (an answer that
    tests of other cells grade), "locked", and "plain" for all without nbgrader's marks.
    """
    role = own_metadata(cell).get("role")
    if role:
        return role
    marks = nbgrader_metadata(cell)
    if marks.get("task"):
        return "task"
    if marks.get("solution"):
        return "hand" if marks.get("grade") else "solution"
    if marks.get("grade"):
        return "test" if cell["cell_type"] == "code" else "hand"
    return "locked" if marks.get("locked") else "plain"

"""Reads the notebook of a submission: a regular file in its own folder, of limited size."""

from pathlib import Path
from typing import Any

from ..course.files import NotTaken, load_json, read_regular

# nbgrader's own files next to the notebook; its release_feedback reads them
BESIDE = ("timestamp.txt", "submission_secret.txt")
MAX_BYTES = 64 * 2**20  # the largest submitted notebook
MAX_VALUES = 4_000_000  # brackets, commas and colons in its JSON: up to 64 bytes of memory each


class UnreadableError(ValueError):
    """The notebook of a submission is missing or cannot be read."""


def read_notebook(path: Path) -> bytes:
    """The bytes of a submitted notebook; raises :class:`UnreadableError`."""
    for folder in (path.parent, path.parent.parent):  # folders of the assignment and of the student
        if folder.is_symlink():
            raise UnreadableError(f"{folder.name} is a link, not a folder of the student's own")
    try:
        return read_regular(path, MAX_BYTES)
    except NotTaken as error:
        raise UnreadableError(f"{path.name}: {error}") from error


def parse_notebook(name: str, content: bytes) -> dict[str, Any]:
    """The submitted notebook as a dict with a list of cells; raises :class:`UnreadableError`."""
    # most outputs are text: no student's own work has this many values
    if len(content) > MAX_VALUES and sum(map(content.count, (b"[", b"{", b",", b":"))) > MAX_VALUES:
        raise UnreadableError(
            f"{name} holds more than {MAX_VALUES} values; have its outputs cleared"
        )
    try:
        submitted = load_json(content)
    except (ValueError, RecursionError) as error:
        damage = f"is damaged and cannot be read as a notebook ({error})"
        what = damage if content.strip() else "is empty"
        raise UnreadableError(f"{name} {what}") from error
    if not isinstance(submitted, dict) or not isinstance(submitted.get("cells"), list):
        raise UnreadableError(f"{name} is not a notebook of format 4: it has no list of cells")
    return submitted

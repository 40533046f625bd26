"""The notebooks of the course, in the order of the book."""

import hashlib
import json
import re
from collections.abc import Collection, Mapping
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any

from .kept import ROOT

FOLDER = ROOT / "chapters"


@dataclass(frozen=True)
class Chapter:
    """A notebook of the course."""

    path: Path

    @property
    def stem(self) -> str:
        """The name of its page: "ch04_relative_motion"."""
        return self.path.stem

    @property
    def name(self) -> str:
        """The name of its problems' folder: "ch04"; without one its own, "speed_and_accuracy"."""
        return re.sub(r"^(ch\d+|app[A-Z])_.*", r"\1", self.stem)

    @cached_property
    def cells(self) -> list[dict[str, Any]]:
        """Its cells as they are stored."""
        return json.loads(self.path.read_text(encoding="utf-8"))["cells"]

    @cached_property
    def opening(self) -> tuple[str, str]:
        """(title, first paragraph), in Markdown."""
        text = "".join(self.cells[0]["source"])
        title, _, rest = text.partition("\n")
        paragraphs = [p for p in re.split(r"\n\s*\n", rest) if p.strip()]
        return title.lstrip("# ").strip(), paragraphs[0].strip() if paragraphs else ""


def chapters(names: Collection[str] = (), folder: Path = FOLDER) -> list[Chapter]:
    """All chapters, or the named ones ("ch04"), in the order of the book, then notebooks without a
    number, then the appendices.
    """
    found = [Chapter(path) for path in folder.glob("*.ipynb")]
    found = [c for c in found if not names or {c.name, c.stem} & {*names}]
    return sorted(found, key=lambda c: sort_key(c.stem))


def translation(chapter: Chapter, name: str) -> Chapter | None:
    """The chapter in the named language, or None."""
    path = chapter.path.parent / name / chapter.path.name
    return Chapter(path) if path.exists() else None


def is_cell_current(source: Mapping[str, Any], cell: Mapping[str, Any]) -> bool:
    """True if ``cell`` was translated from the present ``source``."""
    return cell["metadata"].get("source") == _hash(source)


def mark_cells_current(notebook: Any, source: Any) -> None:
    """Store in each text cell a hash of the cell that it translates."""
    for cell, other in zip(notebook.cells, source.cells, strict=True):
        if cell.cell_type == "markdown":
            cell.metadata["source"] = _hash(other)


def _hash(cell):
    return hashlib.sha256("".join(cell["source"]).encode()).hexdigest()[:12]


def sort_key(name: str) -> tuple[int, str]:
    """For sorting: chapters, other notebooks, appendices."""
    return 0 if re.match(r"ch\d", name) else 2 if re.match(r"app[A-Z]", name) else 1, name

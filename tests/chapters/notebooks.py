"""The notebooks of the chapters, for the tests that read them."""

import re
import tomllib
from pathlib import Path

import nbformat
import pytest

ROOT = Path(__file__).parents[2]
CHAPTERS = sorted((ROOT / "chapters").glob("*.ipynb"))
CONTENTS = tomllib.loads((Path(__file__).parent / "contents.toml").read_text(encoding="utf-8"))
COMPANION = "speed_and_accuracy"

each_chapter = pytest.mark.parametrize(
    "path", [path for path in CHAPTERS if path.stem != COMPANION], ids=lambda path: path.stem
)


def read(path):
    return nbformat.read(path, as_version=nbformat.NO_CONVERT)


def number(path):
    """Of ch04_relative_motion: "ch04"."""
    return path.stem.partition("_")[0]


def code(notebook):
    return [cell for cell in notebook.cells if cell.cell_type == "code"]


def prose(notebook):
    return "\n".join(cell.source for cell in notebook.cells if cell.cell_type == "markdown")


def sections_of(path):
    """{number of a section: its cells}, in the order of the notebook."""
    found, current = {}, None
    for cell in read(path).cells:
        if cell.cell_type == "markdown":
            for part in re.split(r"^(?=#+ )", cell.source, flags=re.M):
                if level_two := re.match(r"## (.+)", part):
                    numbered = re.match(r"((?:\d+|[AB])\.\d+) ", level_two[1])
                    current = found.setdefault(numbered[1], []) if numbered else None
                if current is not None:
                    current.append(part)
        elif current is not None:
            current.append(cell)
    return found

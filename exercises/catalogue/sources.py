"""Whether a translation is up to date: its ``source`` is a hash of the English texts."""

import hashlib
import json
import random
import re
from pathlib import Path
from typing import Any

import yaml

from newton_euler.algebra.language import ENGLISH, speaking

from .loading import load
from .reading import problem
from .steps import listed_steps
from .translations import MEANINGS, file_of, texts_of
from .variants import symbol_values


def english(problem_id: str) -> dict[str, Any]:
    """The English texts of a problem, with those of steps that are in its code."""
    with speaking(ENGLISH):
        p = problem(problem_id)
        numbers = p.book_values | symbol_values(p, random.Random(p.id))
        made = {s.key: s.means for s in listed_steps(p, p.base(numbers)) if not s.term}
    texts = texts_of(p)
    return {**texts, "steps": {**texts["steps"], **made}}


def source_of(problem_id: str) -> str:
    """A hash of the texts of a problem."""
    return hashlib.sha256(json.dumps(english(problem_id), sort_keys=True).encode()).hexdigest()[:12]


def is_current(problem_id: str, name: str) -> bool | None:
    """True if the texts in this language are complete and up to date; None without any."""
    path = file_of(problem_id, name)
    if not path.exists():
        return None
    texts, own = english(problem_id), load(path.read_text("utf-8"))
    lacks = any(set(texts[part]) - set(own.get(part, {})) for part in MEANINGS)
    return own.get("source") == source_of(problem_id) and not lacks


def begin(problem_id: str, name: str) -> Path:
    """Write the English texts to the file of a translation, unless it exists; return its path."""
    path = file_of(problem_id, name)
    if not path.exists():
        path.parent.mkdir(exist_ok=True)
        texts = yaml.safe_dump(english(problem_id), sort_keys=False, allow_unicode=True, width=100)
        path.write_text(texts, "utf-8")
    return path


def mark_current(path: Path) -> None:
    """Write the hash of the present English texts into a translation."""
    name = path.parents[1].name.removeprefix("ch").lstrip("0").removeprefix("app")
    source = source_of(f"{name}/{int(path.stem[1:])}")
    text = re.sub(r"(?m)^source:.*\n", "", path.read_text("utf-8"))
    path.write_text(f'source: "{source}"\n{text}', "utf-8")

"""The equations that steps and answers cite, as the book writes and numbers them."""

import tomllib
from collections.abc import Mapping, Sequence
from functools import cache
from pathlib import Path
from typing import Any

from .model import Problem


@cache
def book_equations() -> Mapping[str, Any]:
    """The cited equations, as the book writes them: {number: LaTeX}."""
    return tomllib.loads(Path(__file__).with_suffix(".toml").read_text())


def own_number(number: str, p: Problem) -> str:
    """The number of an engine's equation in the chapter of ``p``; "" if it comes later."""
    order = ("A", *map(str, range(2, 12)))
    chapter = p.id.partition("/")[0]
    if chapter not in order:  # a course's own
        return number
    if order.index(number.partition(".")[0]) <= order.index(chapter):
        return number
    return book_equations()["own"].get(chapter, {}).get(number, "")


def own_term(number: str, name: str, p: Problem | None) -> Sequence[str]:
    """A term as the chapter of ``p`` writes it, as text and in LaTeX; empty if like the engine."""
    chapter = p.id.partition("/")[0] if p else ""
    return book_equations()["own_terms"].get(chapter, {}).get(number, {}).get(name, ())

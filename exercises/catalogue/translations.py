"""The texts of a problem in another language: ``ch09/de/p01.yaml`` for ``ch09/p01.yaml``, with
title, text, figure and frame, and by name the texts of givens, answers, steps and mistakes. Its
``source`` is a hash of the English texts, see :mod:`~.sources`.
"""

from dataclasses import replace
from functools import cache
from pathlib import Path
from typing import Any

from newton_euler.algebra.language import ENGLISH, language

from .loading import load
from .model import CatalogueError, Chapter, Problem
from .places import folder_and_file, home

TEXTS = "title", "text", "figure", "frame"
MEANINGS = "givens", "answers", "because", "steps", "mistakes"


def file_of(problem_id: str, name: str) -> Path:
    """The file of a problem's texts in the named language."""
    chapter, stem = folder_and_file(problem_id)
    return home(chapter) / name / f"{stem}.yaml"


def has_own_texts(problem_id: str, name: str) -> bool:
    """True if a problem has texts in the named language."""
    return name == ENGLISH or file_of(problem_id, name).exists()


def translated(p: Problem) -> Problem:
    """The problem in the reader's language, as far as it is translated."""
    return p if language() == ENGLISH else _translated(p, language())


@cache
def _translated(p, name):
    path = file_of(p.id, name)
    if not path.exists():
        return p
    own = _read(path)
    unknown = [f"{part}: {name}" for part in MEANINGS for name in own.get(part, {})
               if part != "steps" and name not in texts_of(p)[part]]  # fmt: skip
    if unknown:
        raise CatalogueError(f"{path.parent.parent.name}/{path.parent.name}/{path.name}: the "
                             f"problem has no {unknown[0]}")  # fmt: skip

    def means(part, name, otherwise):
        return own.get(part, {}).get(name, otherwise)

    texts: dict[str, Any] = {name: " ".join(own[name].split()) for name in TEXTS if name in own}
    return replace(
        p,
        **texts,
        givens={n: replace(g, means=means("givens", n, g.means)) for n, g in p.givens.items()},
        answers=tuple(
            replace(
                a,
                means=means("answers", a.key, a.means),
                because=means("because", a.key, a.because),
            )
            for a in p.answers
        ),
        steps={n: {**s, "means": means("steps", n, s["means"])} for n, s in p.steps.items()},
        mistakes={n: means("mistakes", n, text) for n, text in p.mistakes.items()},
        step_texts=own.get("steps", {}),
    )


def translated_chapter(c: Chapter) -> Chapter:
    """The chapter with its title in the reader's language, if translated."""
    path = home(c.name) / language() / "chapter.yaml"
    return replace(c, **_read(path)) if language() != ENGLISH and path.exists() else c


def texts_of(p: Problem) -> dict[str, Any]:
    """The texts of a problem, nested as in such a file."""
    return {
        **{name: getattr(p, name) for name in TEXTS},
        "givens": {n: g.means for n, g in p.givens.items()},
        "answers": {a.key: a.means for a in p.answers},
        "because": {a.key: a.because for a in p.answers if a.because},
        "steps": {n: s["means"] for n, s in p.steps.items()},
        "mistakes": dict(p.mistakes),
    }


def _read(path):
    return load(path.read_text("utf-8"))

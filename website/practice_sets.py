"""The practice files of the problem pages, one per chapter, and the titles of all problems."""

import json
import tempfile
from collections.abc import Collection
from pathlib import Path

from exercises.catalogue import problems
from exercises.catalogue.places import files_of
from exercises.catalogue.translations import file_of, has_own_texts
from grader.practice import write_public
from newton_euler.algebra.language import ENGLISH, language, speaking

from .kept import CACHE, Start, fingerprint, kept_name, store


def sets(names: Collection[str], start: Start, course: Path | None = None) -> dict[str, bytes]:
    """{file name: contents} for these chapters, cached; "index.json" has {problem: [title,
    section]}.

    course : the folder of a course; practice stays away from its graded numbers and is not cached
    """
    titles = {p.id: [p.title, p.section] for name in names for p in problems(name)}
    found, done = {}, start(len(titles))
    for name in names:
        own = any(has_own_texts(p.id, language()) for p in problems(name))
        with speaking(language() if own else ENGLISH):
            found[f"{name}.practice"] = _set(name, course, done)
    return {**found, "index.json": json.dumps(titles).encode()}


def _set(name, course, done):
    """The practice file of a chapter in the current language."""
    kept = CACHE / "practice" / _kept(name)
    if kept.exists() and not course:
        done(len(problems(name)))
        return kept.read_bytes()
    with tempfile.TemporaryDirectory() as folder:
        write_public(Path(folder), [name], course, done)
        data = (Path(folder) / f"{name}.practice").read_bytes()
    if not course:
        store(kept, data)
    return data


def _kept(name):
    files = [f for p in problems(name) for f in (*files_of(p.id), file_of(p.id, language()))]
    texts = [language(), *(f.read_text("utf-8") for f in files if f.exists())]
    own = fingerprint("exercises/catalogue", "exercises/devices", "grader")
    stem = name if language() == ENGLISH else f"{language()}-{name}"
    return kept_name(stem, ".practice", *texts, own)

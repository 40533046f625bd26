"""The practice files of the problem pages, one per chapter, and the titles of all problems."""

import json
import tempfile
from collections.abc import Callable, Collection
from pathlib import Path

from exercises.catalogue import problems
from exercises.catalogue.places import files_of
from exercises.catalogue.translations import file_of, has_own_texts
from grader.practice import write_public
from newton_euler.algebra.language import ENGLISH, language, speaking

from .kept import fingerprint, kept_name, store


def sets(
    names: Collection[str], cache: Path, done: Callable[[], object], course: Path | None = None
) -> dict[str, bytes]:
    """{file name: contents} for these chapters, cached; "index.json" has {problem: [title,
    section]}.

    done : called after each problem
    course : the folder of a course; practice stays away from its graded numbers and is not cached
    """
    found = {}
    for name in names:
        own = any(has_own_texts(p.id, language()) for p in problems(name))
        with speaking(language() if own else ENGLISH):
            found[f"{name}.practice"] = _set(name, cache, course, done)
    titles = {p.id: [p.title, p.section] for name in names for p in problems(name)}
    return {**found, "index.json": json.dumps(titles).encode()}


def _set(name, cache, course, done):
    """The practice file of a chapter in the current language."""
    kept = cache / _kept(name)
    if course or not kept.exists():
        data = _written(name, course, done)
        if not course:
            store(kept, data)
        return data
    for _problem in problems(name):
        done()
    return kept.read_bytes()


def _kept(name):
    files = [f for p in problems(name) for f in (*files_of(p.id), file_of(p.id, language()))]
    texts = [language(), *(f.read_text("utf-8") for f in files if f.exists())]
    own = fingerprint("exercises/catalogue", "exercises/devices", "grader")
    stem = name if language() == ENGLISH else f"{language()}-{name}"
    return kept_name(stem, ".practice", *texts, own)


def _written(name, course, done):
    with tempfile.TemporaryDirectory() as folder:
        write_public(Path(folder), [name], course, done)
        return (Path(folder) / f"{name}.practice").read_bytes()

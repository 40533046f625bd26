"""The practice of the problem pages: a file for each chapter, and the titles of all problems."""

import json
import tempfile
from collections.abc import Callable, Collection
from pathlib import Path

from exercises.catalogue import problems
from exercises.catalogue.places import files_of
from grader.practice import write_public

from .kept import fingerprint, kept_name, store


def sets(
    names: Collection[str],
    cache: Path,
    done: Callable[[], object],
    course: Path | None = None,
) -> dict[str, bytes]:
    """{file name: contents} for these chapters, kept in ``cache``; "index.json" has {problem:
    [title, section]}.

    done : called after each problem
    course : the folder of a course, near whose graded numbers nobody practises; then nothing is
        kept
    """
    found = {}
    for name in names:
        kept = cache / _kept(name)
        if course or not kept.exists():
            data = _written(name, course, done)
            if not course:
                store(kept, data)
        else:
            data = kept.read_bytes()
            for _ in problems(name):
                done()
        found[f"{name}.practice"] = data
    titles = {p.id: [p.title, p.section] for name in names for p in problems(name)}
    return {**found, "index.json": json.dumps(titles).encode()}


def _kept(name):
    texts = [f.read_text("utf-8") for p in problems(name) for f in files_of(p.id)]
    own = fingerprint("exercises/catalogue", "exercises/devices", "grader")
    return kept_name(name, ".practice", *texts, own)


def _written(name, course, done):
    with tempfile.TemporaryDirectory() as folder:
        write_public(Path(folder), [name], course, done)
        return (Path(folder) / f"{name}.practice").read_bytes()

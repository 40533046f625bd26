"""Chapters and problems, read from ``chNN/chapter.yaml`` and ``chNN/pMM.yaml``."""

import contextlib
import importlib
import re
import sys
from collections.abc import Iterable, Iterator
from contextvars import ContextVar
from functools import cache
from pathlib import Path

import yaml

from .errors import meant
from .format import read_chapter, read_problem
from .loading import load, not_yaml
from .model import CatalogueError, Chapter, Problem, folder_and_file
from .places import EXERCISES, changes, files_at, home, homes, of_the_book
from .translations import translated, translated_chapter


def chapters() -> tuple[str, ...]:
    """The names of the chapters that have problems, those of the book first."""
    return tuple(homes())


def chapter(name: str) -> Chapter:
    """The chapter of this name, in the reader's language: ``chapter("ch04").title``."""
    return translated_chapter(_chapter(name))


@cache
def _chapter(name):
    path = home(name) / "chapter.yaml"
    if not path.exists():
        raise CatalogueError(
            f"{name}/chapter.yaml is missing; write it with the title of the chapter, as in "
            'title: "Chapter 4: relative motion"'
        )
    return _read(path, read_chapter)


def problems(name: str) -> tuple[Problem, ...]:
    """All problems of the chapter of this name, in the order of the book: ``problems("ch04")``."""
    if name not in chapters():
        raise CatalogueError(f"there is no chapter {name!r}; there are {', '.join(chapters())}")
    paths = [path for path in home(name).glob("[!.]*.y*ml") if path.name != "chapter.yaml"]
    for path in paths:
        if not re.fullmatch(r"p\d+\.yaml", path.name):
            raise CatalogueError(
                f"{name}/{path.name} is not named like a problem: rename it as in p01.yaml, or "
                "move it out of the folder"
            )
    stems = sorted((path.stem for path in paths), key=lambda stem: int(stem[1:]))
    return tuple(translated(_problem_at(name, stem)) for stem in stems)


def problem(problem_id: str) -> Problem:
    """The problem ``problem("4/16")``, in the reader's language; only its own file is read. It is
    the same object until one of its files changes, so what is computed of it is kept by the object.
    """
    known, number = _known.get({}), str(problem_id)
    if number not in known:
        known[number] = _found(number)
    return translated(known[number])


_known: ContextVar[dict[str, Problem]] = ContextVar("problems read so far")


@contextlib.contextmanager
def read_once() -> Iterator[None]:
    """Within it, and in its thread, a change of a problem's files is not noticed: all that is done
    is by the files of one moment, and they are looked at once.
    """
    token = _known.set({})
    try:
        yield
    finally:
        _known.reset(token)


def _found(problem_id):
    name, stem = folder_and_file(problem_id)
    if (home(name) / f"{stem}.yaml").exists():
        return _problem_at(name, stem)
    if name in chapters():
        raise CatalogueError(
            f"there is no problem {problem_id}; {name} has {problems(name)[0].id} to "
            f"{problems(name)[-1].id}"
        )
    raise CatalogueError(
        f"there is no problem {problem_id}: the chapters with problems are {', '.join(chapters())}"
    )


def select(names: Iterable[str]) -> list[Problem]:
    """The problems selected by ``names``: "4/3", "11/1-11/6", "11/1 – 6", "ch04", or "all"."""
    found: dict[Problem, None] = {}
    for name in names:
        try:
            found |= dict.fromkeys(_selected(name))
        except CatalogueError as error:
            raise CatalogueError(f"{error}{_likely(name)}") from error
    return list(found)


def _likely(name):
    """ "; did you mean 4/16?" of "4.16", and likewise the chapter of a similar name."""
    if numbers := re.fullmatch(r"(?:ch0?)?(\w+)[.,:_-](\d+)", name):
        likely = "/".join(numbers.groups())
        with contextlib.suppress(CatalogueError):
            problem(likely)
            return f"; did you mean {likely}?"
    return "" if name in chapters() else meant(name, chapters())


def _selected(name):
    if name == "all":
        return [p for c in chapters() for p in problems(c)]
    text = re.sub(r"\s*[-–]\s*", "-", name.strip())
    if "/" not in text:
        return problems(text)
    first, _, last = text.partition("-")
    if not last:
        return [problem(text)]
    begin, end = problem(first), problem(last if "/" in last else f"{first.split('/')[0]}/{last}")
    of_chapter = list(problems(begin.chapter))
    if end.chapter != begin.chapter or of_chapter.index(end) < of_chapter.index(begin):
        raise CatalogueError(f"{name}: expected a range within a chapter, as in 11/1-11/6")
    return of_chapter[of_chapter.index(begin) : of_chapter.index(end) + 1]


def forget() -> None:
    """Clear the caches, so that files are read again."""
    for kept in (of_the_book, homes, _chapter, _read_problem):
        kept.cache_clear()


# -- files


_imported: dict[tuple[str, str], tuple] = {}  # {problem: its files when its code was imported}


def _problem_at(name, stem):
    """The problem in this place, read and its code imported again once a file of it changes."""
    files = changes(files_at(name, stem))
    if _imported.setdefault((name, stem), files) != files:
        _forget_code(name, stem)
        _imported[name, stem] = files
    return _read_problem(home(name) / f"{stem}.yaml", files)


@cache
def _read_problem(path: Path, files: tuple) -> Problem:
    return _read(path, read_problem)


def _forget_code(name, stem):
    """Let the code of a problem be imported again, and what the chapter of a course shares."""
    chapter = f"exercises.{name}"
    of_a_course = home(name).parent != EXERCISES
    importlib.invalidate_caches()
    for module in list(sys.modules):
        if module == f"{chapter}.{stem}" or (
            of_a_course and f"{module}.".startswith(f"{chapter}.")
        ):
            del sys.modules[module]


def _read(path, build):
    """``build(entry, path)`` of the file's content; errors begin with the name of the file."""
    name = f"{path.parent.name}/{path.name}"
    try:
        return build(load(path.read_bytes().decode("utf-8")), path)
    except UnicodeDecodeError as error:
        line = error.object.count(b"\n", 0, error.start) + 1
        message = (
            f"{name} is not in UTF-8: line {line} has the byte "
            f"{error.object[error.start]:#04x}; save the file as UTF-8"
        )
        raise CatalogueError(message) from error
    except yaml.YAMLError as error:
        raise CatalogueError(f"{name} {not_yaml(error)}") from error
    except ValueError as error:
        raise CatalogueError(f"{name}: {error}") from error

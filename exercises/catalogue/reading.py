"""Finds and reads chapters and problems: ``chNN/chapter.yaml`` and ``chNN/pMM.yaml``."""

import re
from collections.abc import Iterable
from functools import cache
from pathlib import Path
from typing import Any

import yaml

from .format import read_chapter, read_problem
from .model import CatalogueError, Chapter, Problem, place
from .places import home, homes


def chapters() -> tuple[str, ...]:
    """The names of the chapters that have problems, those of the book first."""
    return tuple(homes())


@cache
def chapter(name: str) -> Chapter:
    """The chapter of this name: ``chapter("ch04").title``."""
    path = home(name) / "chapter.yaml"
    if not path.exists():
        raise CatalogueError(
            f"{name}/chapter.yaml is missing; write it with the title of the chapter, as in "
            'title: "Chapter 4: relative motion"'
        )
    return _read(path, read_chapter)


@cache
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
    return tuple(_problem_at(path) for path in sorted(paths, key=lambda path: int(path.stem[1:])))


@cache
def problem(problem_id: str) -> Problem:
    """The problem with this number: ``problem("4/16")``. Only its own file is read."""
    name, stem = place(problem_id)
    path = home(name) / f"{stem}.yaml"
    if path.exists():
        return _problem_at(path)
    if name in chapters():
        raise CatalogueError(
            f"there is no problem {problem_id}; {name} has {problems(name)[0].id} to "
            f"{problems(name)[-1].id}"
        )
    raise CatalogueError(
        f"there is no problem {problem_id}: the chapters with problems are {', '.join(chapters())}"
    )


def select(names: Iterable[str]) -> list[Problem]:
    """The problems that ``names`` stand for: problem numbers, chapter names, or "all"."""
    chosen = []
    for name in names:
        if name == "all":
            chosen += [p for c in chapters() for p in problems(c)]
        elif "/" in name:
            chosen.append(problem(name))
        else:
            chosen += problems(name)
    return list(dict.fromkeys(chosen))


def forget() -> None:
    """Read all anew when it is asked for again."""
    for kept in (homes, chapter, problems, problem, _problem_at):
        kept.cache_clear()


# -- files


# the C parser reads a chapter 10 times faster
class _Loader(getattr(yaml, "CSafeLoader", yaml.SafeLoader)):  # type: ignore[misc]
    """The safe loader, which also refuses a repeated key: YAML would drop the first."""

    def construct_mapping(self, node, deep=False):
        keys = [key.value for key, _ in node.value]
        for key, _ in node.value:
            if keys.count(key.value) > 1:
                raise yaml.constructor.ConstructorError(
                    None, None, f"the key {key.value} is there twice", key.start_mark
                )
        return super().construct_mapping(node, deep)


# 1e-3 is a number too; YAML 1.1 wants 1.0e-3
_Loader.add_implicit_resolver(
    "tag:yaml.org,2002:float", re.compile(r"[-+]?[0-9]+[eE][-+]?[0-9]+$"), list("-+0123456789")
)


def load(text: str) -> Any:
    """What a text of YAML holds."""
    return yaml.load(text, _Loader)


@cache
def _problem_at(path: Path) -> Problem:
    return _read(path, read_problem)


def _read(path, build):
    """``build(entry, path)`` of what the file holds; errors begin with the name of the file."""
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
        reason = " ".join(str(error).replace('"<unicode string>", ', "").split())
        raise CatalogueError(
            f"{name} is not YAML: {reason}; a text with a colon, a # or quotation marks in it "
            "wants quotes around it"
        ) from error
    except ValueError as error:
        raise CatalogueError(f"{name}: {error}") from error

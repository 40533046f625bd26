"""Where problems are: the book's here, a course's in folders of its own.

Such a folder has chapters like this one: ``bridge/chapter.yaml``, with ``bridge/p03.yaml`` and
``p03.py`` for the problem bridge/3. Folders are added by :func:`use`, for this process and its
children, and by packages under the entry point GROUP.
"""

import contextlib
import os
import re
import sys
from collections.abc import Iterable
from functools import cache
from importlib.metadata import entry_points
from importlib.util import find_spec
from pathlib import Path

EXERCISES = Path(__file__).parents[1]
GROUP = "newton_euler.problems"
VARIABLE = "NEWTON_EULER_PROBLEMS"


class CatalogueError(ValueError):
    """A problem that does not exist, or whose text, data and code do not fit together."""


def folder_and_file(problem_id: str) -> tuple[str, str]:
    """Folder and file of a problem: ("ch04", "p16") of "4/16", ("bridge", "p03") of "bridge/3"."""
    found = re.fullmatch(r"([1-9]\d*|[AB]|[a-z][a-z0-9_]*)/([1-9]\d*)", str(problem_id), re.A)
    if not found or re.match(r"(ch\d+|app[a-z])/", str(problem_id)):
        raise CatalogueError(
            f"{problem_id!r} is not a problem number; write chapter and problem, as in 4/16"
        )
    chapter, number = found.groups()
    if chapter.isdigit():
        chapter = f"ch{int(chapter):02d}"
    return f"app{chapter}" if chapter.isupper() else chapter, f"p{int(number):02d}"


def use(folder: str | Path) -> list[str]:
    """Add the problems in a folder of a course; returns the names of its chapters."""
    path = Path(folder).resolve()
    if path not in _used():
        os.environ[VARIABLE] = os.pathsep.join(map(str, [*_used(), path]))
        homes.cache_clear()
    try:
        homes()
    except CatalogueError:
        os.environ[VARIABLE] = os.pathsep.join(str(p) for p in _used() if p != path)
        homes.cache_clear()
        raise
    return [name for name, home in homes().items() if home.parent == path]


@cache
def homes() -> dict[str, Path]:
    """{chapter: its folder}: those of the book, then those of courses by name and number."""
    found = dict(of_the_book())
    own = [home for folder in [*_used(), *_of_packages()] for home in _of_a_course(folder)]
    for home in sorted(own, key=lambda home: natural_order(home.name)):
        ours = {path.stem for path in EXERCISES.iterdir()}  # folders, and modules as tools.py
        if home.name in ours or re.fullmatch(r"ch\d+|app[A-Za-z]|all", home.name):
            raise CatalogueError(
                f"{home}: the name {home.name} is taken by the book; give your chapter another, "
                "as in bridge/p01.yaml for the problem bridge/1"
            )
        if home.name in found:
            raise CatalogueError(
                f"there are two chapters {home.name}, {found[home.name]} and {home}; rename one, "
                "and the numbers in it"
            )
        found[home.name] = home
    _importable({home.parent for home in own})
    return found


def home(chapter: str) -> Path:
    """The folder of a chapter, which need not exist."""
    return of_the_book().get(chapter) or homes().get(chapter, EXERCISES / chapter)


@cache
def of_the_book() -> dict[str, Path]:
    """:func:`homes` of the book's chapters alone."""
    return {folder.name: folder for folder in sorted(_with_problems(EXERCISES))}


def files_of(problem_id: str) -> list[Path]:
    """The two files of a problem, and the code shared by those of a course's own chapter."""
    return files_at(*folder_and_file(problem_id))


def files_at(chapter: str, name: str) -> list[Path]:
    """:func:`files_of` the problem in this place."""
    folder = home(chapter)
    shared = [] if folder.parent == EXERCISES else sorted(folder.rglob("*.py"))
    others = [f for f in shared if not re.fullmatch(r"p\d+", f.stem)]
    return [folder / f"{name}.py", folder / f"{name}.yaml", *others]


def changes(files: Iterable[Path]) -> tuple[tuple[str, int], ...]:
    """The files that exist, with the times of their last change."""
    found = list[tuple[str, int]]()
    for f in files:
        with contextlib.suppress(FileNotFoundError):
            found.append((str(f), os.stat(f).st_mtime_ns))
    return tuple(found)


def _used():
    return [Path(p) for p in os.environ.get(VARIABLE, "").split(os.pathsep) if p]


def _of_packages():
    """The folders of the packages that the entry points name."""
    for point in entry_points(group=GROUP):
        spec = find_spec(point.value)
        if not (spec and spec.submodule_search_locations):
            raise CatalogueError(
                f"the entry point {point.name} of {GROUP} must name a package, not {point.value}"
            )
        path = Path(next(iter(spec.submodule_search_locations))).resolve()
        if {"site-packages", "dist-packages"} & set(path.parts):
            raise CatalogueError(
                f"{path} is among the libraries, where students' code can read it: "
                "install the package from its own folder, by pip install -e"
            )
        yield path


def _of_a_course(folder):
    found = _with_problems(folder) if folder.is_dir() else []
    if not found:
        raise CatalogueError(
            f"{folder} {'has no problems' if folder.is_dir() else 'is not a folder'}: put them in "
            "chapters, as bridge/p01.yaml for bridge/1"
        )
    for home in found:
        if not re.fullmatch(r"[a-z][a-z0-9_]*", home.name):
            raise CatalogueError(
                f"{home}: the name of a chapter has small letters, digits and _, as in bridge"
            )
    return found


def _with_problems(folder: Path) -> list[Path]:
    return [home for home in folder.iterdir() if any(home.glob("p*.yaml"))]


def natural_order(name: str) -> list[str | int]:
    """A key for sorting: week2 before week10."""
    return [int(x) if x.isdigit() else x for x in re.split(r"(\d+)", name)]


def _importable(folders: Iterable[Path]) -> None:
    """Let ``exercises.bridge.p03`` be the code of bridge/3."""
    path = sys.modules["exercises"].__path__
    path += [str(p) for p in folders if str(p) not in path]

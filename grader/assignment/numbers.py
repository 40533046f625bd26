"""The numbers of each student's sheet: drawn once, kept in COURSE/numbers, and used from then on,
even if the ranges of an exercise change.
"""

import json
import re
from collections.abc import Iterable
from functools import cache, lru_cache
from pathlib import Path
from typing import Any

from exercises.catalogue import Problem
from exercises.catalogue.variants import draw, practice_seed
from newton_euler.algebra.units import unit

from ..course import Course, CourseError, write_json
from ..course.exam import is_exam
from .cells import SheetValues, hashable, own_metadata
from .sheet import tasks

# a file of numbers: {problem: {name: [number, unit]}}
KeptNumbers = dict[str, dict[str, list[Any]]]
TRIES = 50  # draws for numbers that no other sheet has
PRACTISED = 20  # sets of numbers of a practice file: twice as many as it has by default


def kept_numbers(
    course: Course, assignment: str, student: str, problems: Iterable[Problem]
) -> SheetValues:
    """A student's numbers in today's units; missing ones are drawn and kept."""
    path = numbers_path(course, assignment, student)
    kept = _read(path)
    missing = [p for p in problems if p.id not in kept]
    if missing:
        handed_out = _handed_out(course, assignment, student)
        drawn = _drawn(course, assignment, student, missing)
        values = {p.id: {**drawn[p.id], **handed_out.get(p.id, {})} for p in missing}
        kept = keep_numbers(course, assignment, student, missing, values)
    return {p.id: _today(p, kept[p.id], path) for p in problems}


def _drawn(course, assignment, student, problems):
    """New numbers for a sheet; in an exam, if the ranges allow, different from those of the book,
    of other sheets of the course and of practice files of the usual size.
    """
    drawn = course.values(assignment, student, problems)
    if not is_exam(course, assignment):
        return drawn
    folders = sorted(p for p in (course.path / "numbers").glob("*/") if p.name != assignment)
    taken = _taken(tuple((p, p.stat().st_mtime_ns) for p in folders))
    for p in problems:
        others = _practised(p) | taken.get(p.id, set())
        for n in range(TRIES):
            if hashable(drawn[p.id]) not in others:
                break
            # no student has this name, since ids hold no line breaks
            drawn |= course.values(assignment, f"{student}\n{n}", [p])
    return drawn


@cache
def _practised(p: Problem) -> set:
    """The numbers of the book and the first ones of practice files."""
    return {hashable(p.book_values)} | {
        hashable(draw(p, practice_seed(p, n))) for n in range(PRACTISED)
    }


@lru_cache(maxsize=2)
def _taken(folders: tuple[tuple[Path, int], ...]) -> dict[str, set]:
    """{problem: the numbers of all sheets in these folders}; the times are for the cache."""
    found: dict[str, set] = {}
    for path in (path for folder, _ in folders for path in folder.glob("*.json")):
        for number, given in _read(path).items():
            values = {name: x for name, (x, _) in given.items()}
            found.setdefault(number, set()).add(hashable(values))
    return found


def numbers_in(path: Path, problems: Iterable[Problem]) -> SheetValues:
    """The numbers in a file, in today's units, for problems whose givens it covers."""
    kept, found = _read(path), {}
    for p in problems:
        if p.id in kept and kept[p.id].keys() >= p.givens.keys():
            found[p.id] = _today(p, kept[p.id], path)
    return found


def keep_numbers(
    course: Course, assignment: str, student: str, problems: Iterable[Problem], values: SheetValues
) -> KeptNumbers:
    """Add the numbers of these problems to a student's file; returns all in it."""
    path = numbers_path(course, assignment, student)
    kept = _read(path)
    for p in problems:
        given = ((n, x) for n, x in values[p.id].items() if n in p.givens)
        kept[p.id] = {n: [x, p.givens[n].unit] for n, x in given}
    write_json(path, kept)
    return kept


def numbers_path(course: Course, assignment: str, student: str) -> Path:
    """The file that keeps the numbers of a student's sheet."""
    return course.path / "numbers" / assignment / f"{student}.json"


def _read(path: Path) -> KeptNumbers:
    try:
        return json.loads(path.read_text(encoding="utf-8"))
    except FileNotFoundError:
        return {}
    except ValueError as error:
        raise CourseError(
            f"{path} is damaged ({error}); put it back from a backup, or delete it, and the "
            "numbers are drawn again from the course's secret"
        ) from error


def _today(p, kept, path):
    values = {}
    for name, given in p.givens.items():
        if name not in kept:
            raise CourseError(
                f"{p.id} has a given {name} now, which the sheets do not have ({path}). Grade with "
                "the version of the exercises that they were made with, or hand out new sheets "
                f"after deleting {p.id} from that file"
            )
        number, text = kept[name]
        values[name] = number if text == given.unit else _converted(p, name, number, text)
    return values


def _converted(p, name, number, text):
    there, here = unit(text), unit(p.givens[name].unit)
    if there.dimension != here.dimension:
        raise CourseError(
            f"{p.id} gives {name} in {p.givens[name].unit} now, and in {text} on the sheets; grade "
            "with the version of the exercises that they were made with"
        )
    return here.from_base(there.to_base(number))


def _handed_out(course, assignment, student):
    """The numbers in a copy from a version that did not keep them."""
    path = course.personal_path(assignment, student)
    if not path.exists():
        return {}
    found = {}
    notebook = json.loads(path.read_text(encoding="utf-8"))
    for cell in notebook["cells"]:
        own = own_metadata(cell)
        if own.get("role") == "givens":
            lines = re.findall(r"(?m)^(\w+) = (-?[\d.]+(?:e[-+]?\d+)?)\b", "".join(cell["source"]))
            found[own["problem"]] = {
                name: float(text) if re.search("[.e]", text) else int(text) for name, text in lines
            }
    return {i: values for i, values in found.items() if i in tasks(notebook)}

"""The assignment named in a command: from a course, a file, or a choice of problems."""

from collections.abc import Iterable, Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

from exercises.catalogue import Problem, chapters, select

from ..course import Course
from .sheet import with_tolerance
from .spec import Item, Spec, read_spec, spec_of
from .written import spec_of_course


def chosen(
    assignment: str,
    only: Iterable[str] = (),
    points: Iterable[str] = (),
    course: Course | None = None,
) -> Spec:
    """The assignment of this name: from the ``course``, from ``hw3.yaml``, of the problems
    ``only``, or of the chapter of that name. A problem whose text the instructor has changed is an
    item with that text, with the book's numbers and without the figure.
    """
    only, points, path = tuple(only), tuple(points), Path(assignment)
    if course and not only and course.source(path.stem).exists():
        return spec_of_course(course, path.stem)
    if path.suffix not in (".yaml", ".yml"):
        path = Path(f"{assignment}.yaml")
    if not only and (path.exists() or path.name == assignment):
        return read_spec(path)
    if course and not only and path.stem not in chapters():
        return spec_of_course(course, path.stem)  # raises an error that lists the assignments
    return spec_of(Path(assignment).stem, only, points)


def named(names: Iterable[str], course: Course | None = None) -> dict[Problem, Mapping[str, Any]]:
    """{problem: its options on the sheet} for ``names``: problem numbers, ranges, chapters, "all",
    files of assignments, and assignments of the ``course``.
    """
    found: dict[Problem, Mapping[str, Any]] = {}
    for name in names:
        file = Path(name if Path(name).suffix in (".yaml", ".yml") else f"{name}.yaml")
        if course and "/" not in name and course.source(name).exists():
            items = spec_of_course(course, name).items
        elif file.exists() or file.name == name:
            items = read_spec(file).items
        else:
            items = tuple(map(Item, select([name])))
        for item in items:
            if item.problem:
                found.setdefault(item.problem, item.options)
    return found


def as_asked(p: Problem, options: Mapping[str, Any]) -> Problem:
    """The problem with the tolerance and the weights of its sheet."""
    p, weights = with_tolerance(p, options.get("tolerance")), options.get("weights") or {}
    answers = (replace(a, weight=weights.get(a.key, a.weight)) for a in p.answers)
    return replace(p, answers=tuple(answers)) if weights else p

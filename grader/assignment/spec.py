"""What an assignment consists of: problems of any chapters, with their points, and texts between.

An instructor writes it as a file, hw3.yaml::

    title: Homework 3
    due: 2027-01-31 23:59 Europe/Berlin
    problems:
      - 4/3: {points: 10, weights: {a: 2}, follow_through: 0.5}
      - text: "Friction is neglected from here on."
      - 4/16
      - 11/1-11/6
"""

import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import yaml

from exercises.catalogue import Problem, chapter, chapters, problem, problems

from ..course import CourseError

OPTIONS = {"points", "weights", "follow_through"}


@dataclass(frozen=True)
class Item:
    """A problem with what its answer cell is worth, or a ``text`` between problems."""

    problem: Problem | None = None
    text: str = ""
    options: Mapping[str, Any] = field(default_factory=dict)


@dataclass(frozen=True)
class Spec:
    """An assignment: its name, its title, its items; ``due`` is the text of the due date."""

    name: str
    title: str
    items: tuple[Item, ...]
    due: str = ""

    @property
    def problems(self) -> list[Problem]:
        """The problems, in order."""
        return [i.problem for i in self.items if i.problem]

    @property
    def as_yaml(self) -> str:
        """The file that :func:`read_spec` reads."""
        entries: list[Any] = []
        for i in self.items:
            if not i.problem:
                entries.append({"text": i.text})
            else:
                number = i.problem.id
                entries.append({number: dict(i.options)} if i.options else number)
        due = {"due": self.due} if self.due else {}
        content = {"title": self.title, **due, "problems": entries}
        return yaml.safe_dump(content, sort_keys=False, allow_unicode=True)


def spec_of(
    name: str, chosen: Iterable[str] = (), points: Iterable[str] = (), title: str = ""
) -> Spec:
    """The assignment ``name`` of the problems ``chosen``, as "4/3", "11/1-11/6" or "ch04"; of none,
    all of the chapter of that name. ``points``: texts as "4/3=10".
    """
    if not re.fullmatch(r"[A-Za-z0-9]\w*(-\w+)*", name):
        raise CourseError(
            f"the assignment {name!r}: a name has letters, digits, _ and -, as in hw3"
        )
    whole = name in chapters()
    if not whole and not (chosen := tuple(chosen)):
        raise CourseError(
            f"there is no chapter {name!r}, and no problems are named; there are "
            f"{', '.join(chapters())}. Name them: build {name} --problems 4/3 4/16 11/1-11/6"
        )
    found = list(dict.fromkeys(p for text in chosen or (name,) for p in in_range(text)))
    worth = dict(_points(text) for text in points)
    if unknown := worth.keys() - {p.id for p in found}:
        raise CourseError(f"--points {min(unknown)}: it is not among the problems of {name}")
    items = tuple(Item(p, options={"points": worth[p.id]} if p.id in worth else {}) for p in found)
    return Spec(name, title or (chapter(name).title if whole else name), items)


def in_range(text: str) -> list[Problem]:
    """The problems that "4/3", "11/1-11/6", "11/1-6" or "ch04" stands for."""
    if "/" not in text:
        return list(problems(text))
    first, _, last = text.partition("-")
    if not last:
        return [problem(text)]
    begin, end = problem(first), problem(last if "/" in last else f"{first.split('/')[0]}/{last}")
    of_chapter = list(problems(begin.chapter))
    if end.chapter != begin.chapter or of_chapter.index(end) < of_chapter.index(begin):
        raise CourseError(f"{text}: expected a range within a chapter, as in 11/1-11/6")
    return of_chapter[of_chapter.index(begin) : of_chapter.index(end) + 1]


def _points(text):
    number, equals, points = text.partition("=")
    try:
        return problem(number).id, _number(points if equals else "", 0.0)
    except ValueError:
        raise CourseError(
            f"--points {text!r}: expected a problem and points, as in 4/3=10"
        ) from None


def _number(x, least):
    value = float(x)
    if not least <= value < 1e6:
        raise ValueError(x)
    return int(value) if value.is_integer() else value


def read_spec(path: Path) -> Spec:
    """The assignment that a file describes; its name is that of the file."""
    try:
        content = yaml.safe_load(path.read_text(encoding="utf-8"))
    except (OSError, UnicodeDecodeError, yaml.YAMLError) as error:
        raise CourseError(f"{path} cannot be read: {error}") from error
    known = {"title", "due", "problems"}
    if not isinstance(content, dict) or not isinstance(content.get("problems"), list):
        raise CourseError(f"{path}: expected title, due and a list of problems")
    if unknown := content.keys() - known:
        raise CourseError(f"{path}: {min(unknown, key=str)!r} is not one of {', '.join(known)}")
    items = [item for entry in content["problems"] for item in _items(path, entry)]
    numbers = [i.problem.id for i in items if i.problem]
    if twice := [n for n in numbers if numbers.count(n) > 1]:
        raise CourseError(f"{path}: {twice[0]} is there twice")
    title = str(content.get("title") or path.stem)
    return Spec(
        spec_of(path.stem, numbers).name, title, tuple(items), str(content.get("due") or "")
    )


def _items(path, entry):
    if isinstance(entry, str):
        return [Item(p) for p in in_range(entry)]
    if not isinstance(entry, dict) or len(entry) != 1:
        raise CourseError(f"{path}: {entry!r} is neither a problem nor a text")
    ((name, value),) = entry.items()
    if name == "text":
        return [Item(text=str(value))]
    options = value if isinstance(value, dict) else {"points": value}
    if unknown := options.keys() - OPTIONS:
        raise CourseError(
            f"{path}, {name}: {min(unknown, key=str)!r} is not one of {', '.join(sorted(OPTIONS))}"
        )
    try:
        if "points" in options:
            options = {**options, "points": _number(options["points"], 0.0)}
    except (TypeError, ValueError):
        raise CourseError(f"{path}, {name}: {options['points']!r} is no number of points") from None
    return [Item(p, options=options) for p in in_range(str(name))]

"""The contents of an assignment: problems of any chapters, their points, and texts between them. An
instructor writes it as a file; ``python -m grader build --help`` prints a complete example.
"""

import re
from collections import Counter
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any

import yaml

from exercises.catalogue import CatalogueError, Problem, chapter, chapters, problem, select
from exercises.catalogue.loading import not_yaml
from exercises.catalogue.variants import sheets
from newton_euler.answers.tolerance import SEPARATION

from ..course import CourseError
from ..course.due import due_date
from ..course.exam import LATE
from .options import BY_SHEET, OPTIONS, read_option, unknown


@dataclass(frozen=True)
class Item:
    """A problem with its options, a ``text`` between problems, or an instructor's own ``question``,
    named by its cell, with its ``text`` and its ``key`` for manual grading.
    """

    problem: Problem | None = None
    text: str = ""
    options: Mapping[str, Any] = field(default_factory=dict)
    question: str = ""
    key: str = ""


@dataclass(frozen=True)
class Spec:
    """An assignment: its name, its title, its items. ``due`` and ``opens`` are texts of dates;
    ``late``, one of :data:`~grader.course.exam.LATE`, is empty for homework; ``left_out``: the
    cells of a notebook that are not items.
    """

    name: str
    title: str
    items: tuple[Item, ...]
    due: str = ""
    opens: str = ""
    late: str = ""
    left_out: tuple[str, ...] = ()

    def __post_init__(self) -> None:
        if self.late and any(i.options.get("help", "none") != "none" for i in self.items):
            raise CourseError(f"{self.name} is an exam, in which there is no help: leave it out")
        if self.opens and self.due and due_date(self.opens) >= due_date(self.due):
            raise CourseError(
                f"{self.name} closes at {self.due}, and must open before; it opens at {self.opens}"
            )

    @property
    def problems(self) -> list[Problem]:
        """The problems, in order."""
        return [i.problem for i in self.items if i.problem]

    @property
    def warnings(self) -> list[str]:
        """Possible surprises of the sheet for an instructor, as sentences."""
        wide = [i.problem.id for i in self.items if i.problem and _takes_mistakes(i)]
        same = [p.id for p in self.problems if self.late and sheets(p) == 1]
        found = [
            f"{', '.join(wide)}: so wide a tolerance may take a listed mistake for right; those "
            f"differ from the right answer by {SEPARATION:.0%} or more"
        ] * bool(wide)
        return found + [
            f"{', '.join(same)}: the same for everybody and everywhere, since nothing in it varies"
        ] * bool(same)

    @property
    def as_yaml(self) -> str:
        """The file that :func:`read_spec` reads."""
        dates = {"mode": "exam", "opens": self.opens, "closes": self.due, "late": self.late}
        head = dates if self.late else {"due": self.due}
        asked = [i.options for i in self.items if i.problem]
        common = {
            key: Counter(o[key] for o in asked).most_common(1)[0][0]
            for key in BY_SHEET
            if len(asked) > 1 and all(key in o for o in asked)
        }
        content = {"title": self.title, **{k: x for k, x in head.items() if x}, **common}
        content["problems"] = [_entry(i, common) for i in self.items if not i.question]
        return yaml.safe_dump(content, sort_keys=False, allow_unicode=True)


def _takes_mistakes(item):
    return item.options.get("tolerance", 0) > SEPARATION


def _entry(item, common):
    if not item.problem:
        return {"text": item.text}
    own = {key: x for key, x in item.options.items() if x != common.get(key)}
    return {item.problem.id: own} if own else item.problem.id


def spec_of(name: str, chosen: Iterable[str] = (), points: Iterable[str] = ()) -> Spec:
    """The assignment ``name`` of the problems ``chosen``, as "4/3", "11/1-11/6" or "ch04"; by
    default all of the chapter of that name. ``points``: texts as "4/3=10".
    """
    if not re.fullmatch(r"[A-Za-z0-9]\w*(-\w+)*", name):
        raise CourseError(
            f"the assignment {name!r}: a name has letters, digits, _ and -, as in hw3"
        )
    whole = name in chapters()
    if not whole and not (chosen := tuple(chosen)):
        raise CourseError(
            f"there is no chapter {name!r}, and no problems are named; there are "
            f"{', '.join(chapters())}. Name them with --problems 4/3 4/16 11/1-11/6"
        )
    found = select(chosen or (name,))
    worth = dict(_points(text) for text in points)
    if missing := worth.keys() - {p.id for p in found}:
        raise CourseError(f"--points {min(missing)}: it is not among the problems of {name}")
    items = tuple(Item(p, options={"points": worth[p.id]} if p.id in worth else {}) for p in found)
    return Spec(name, chapter(name).title if whole else name, items)


def _points(text):
    number, equals, points = text.partition("=")
    try:
        return problem(number).id, read_option("points", float(points if equals else ""))
    except ValueError:
        raise CourseError(
            f"--points {text!r}: expected a problem and its points, 0 or more, as in 4/3=10"
        ) from None


# -- the file


class _Loader(yaml.SafeLoader):
    """The safe loader, with the lines of keys and entries."""


class _Map(dict[Any, Any]):
    """A mapping with the line of each key."""

    def __init__(self, **entries: Any) -> None:
        super().__init__(entries)
        self.lines: dict[Any, int] = {}


class _List(list):
    """A list with the line of each entry."""


def _mapping(loader, node):
    found = _Map()
    for key, value in node.value:
        name = loader.construct_object(key, deep=True)
        if not isinstance(name, str | int | float):
            raise yaml.constructor.ConstructorError(None, None, "no name", key.start_mark)
        if name in found:
            words = f"the key {name!r} occurs twice"
            raise yaml.constructor.ConstructorError(None, None, words, key.start_mark)
        found[name] = loader.construct_object(value, deep=True)
        found.lines[name] = key.start_mark.line + 1
    return found


def _sequence(loader, node):
    found = _List(loader.construct_object(entry, deep=True) for entry in node.value)
    found.lines = [entry.start_mark.line + 1 for entry in node.value]
    return found


_Loader.add_constructor("tag:yaml.org,2002:map", _mapping)
_Loader.add_constructor("tag:yaml.org,2002:seq", _sequence)
HEAD = {"title", "due", "mode", "opens", "closes", "late", "problems", *BY_SHEET}


def read_spec(path: Path) -> Spec:
    """The assignment that a file describes; its name is that of the file."""
    try:
        content: Any = yaml.load(path.read_text(encoding="utf-8"), _Loader)
    except yaml.YAMLError as error:
        raise CourseError(f"{path} {not_yaml(error)}") from error
    except OSError as error:
        raise CourseError(f"{path} cannot be read: {error.strerror}") from error
    except (ValueError, RecursionError) as error:  # ValueError: of dates
        raise CourseError(f"{path} cannot be read: {error}") from error
    for key in content if isinstance(content, _Map) else ():
        if key not in HEAD:
            raise _error(path, content.lines[key], unknown(key, HEAD))
    if not isinstance(content, _Map) or not isinstance(content.get("problems"), list):
        raise CourseError(
            f"{path}: expected title, due and a list of problems, as python -m grader build --help "
            "shows"
        )
    common = {key: _option(path, content, key, None) for key in BY_SHEET if key in content}
    entries = content["problems"]
    items = [
        replace(item, options=common | dict(item.options)) if item.problem else item
        for entry, line in zip(entries, entries.lines, strict=True)
        for item in _items(path, entry, line)
    ]
    numbers = [i.problem.id for i in items if i.problem]
    if twice := [n for n in numbers if numbers.count(n) > 1]:
        raise CourseError(f"{path}: {twice[0]} occurs twice")
    if not numbers:
        raise _error(path, content.lines["problems"], "no problem is named")
    if not isinstance(title := content.get("title", ""), str | int | float):
        raise _error(path, content.lines["title"], f"{title!r} is not a title: expected a text")
    name = spec_of(path.stem, numbers).name
    return Spec(name, str(title or name), tuple(items), **_dates(path, content))


def _dates(path, content):
    """The due date, or the window of an exam."""

    def wrong(key, words):
        return _error(path, content.lines[key], words)

    if (mode := content.get("mode", "homework")) not in ("homework", "exam"):
        raise wrong("mode", unknown(mode, ("homework", "exam")))
    if mode == "homework":
        for key in ("opens", "closes", "late"):
            if key in content:
                raise wrong(key, f"{key!r} is for exams: add mode: exam, or write due")
        return {"due": _date(path, content, "due")}
    if "due" in content:
        raise wrong("due", "an exam has a closing time: write closes in place of due")
    if not content.get("closes"):
        raise wrong("mode", "an exam ends: add a line as closes: 2027-01-31 11:00 Europe/Berlin")
    if (late := content.get("late", LATE[0])) not in LATE:
        raise wrong("late", unknown(late, LATE))
    closes, opens = (_date(path, content, key) for key in ("closes", "opens"))
    return {"due": closes, "opens": opens, "late": late}


def _date(path, content, key):
    """The text of a valid date, or ""."""
    try:
        if content.get(key):
            due_date(str(content[key]))
    except CourseError as error:
        raise _error(path, content.lines[key], str(error)) from error
    return str(content.get(key) or "")


def _items(path, entry, line):
    if isinstance(entry, dict) and len(entry) == 1:
        ((name, value),) = entry.items()
        if name == "text":
            return [Item(text=str(value))]
        found = _found(path, name, line)
        own = value
        if not isinstance(value, dict):
            own = _Map(points=value)
            own.lines = {"points": line}
        for key in own:
            if key not in OPTIONS:
                raise _error(path, own.lines[key], f"{name}: {unknown(key, OPTIONS)}")
        return [
            Item(p, options={key: _option(path, own, key, p, f"{name}: ") for key in own})
            for p in found
        ]
    if not isinstance(entry, str | float):  # 4.16 is meant for 4/16
        raise _error(path, line, f"{entry!r} is neither a problem nor a text")
    return [Item(p) for p in _found(path, entry, line)]


def _found(path, name, line):
    """The problems that a name in the file selects."""
    try:
        return select([str(name)])
    except CatalogueError as error:
        raise _error(path, line, f"{name!r}: {error}") from error


def _option(path, own, key, p, where=""):
    try:
        return read_option(key, own[key], p)
    except ValueError as error:
        raise _error(path, own.lines[key], f"{where}{key}: {error}") from error


def _error(path, line, words):
    return CourseError(f"{path}, line {line}: {words}")

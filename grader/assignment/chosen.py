"""The assignment that a command names: of a course, of a file, or of chosen problems."""

import re
from collections.abc import Iterable
from dataclasses import replace
from pathlib import Path

from ..course import Course, load_json, read_json
from .cells import own_metadata
from .sheet import tasks
from .spec import Item, Spec, read_spec, spec_of


def chosen(
    assignment: str,
    only: Iterable[str] = (),
    points: Iterable[str] = (),
    course: Course | None = None,
) -> Spec:
    """The assignment of this name: as the ``course`` has it, as ``hw3.yaml`` says, of the problems
    ``only``, or of the chapter of that name. An item that is a problem has a text where the
    instructor has changed the problem's: with the book's numbers, and without the figure.
    """
    only, points, path = tuple(only), tuple(points), Path(assignment)
    if course and not only and course.source(path.stem).exists():
        return _of_course(course, path.stem)
    if path.suffix not in (".yaml", ".yml"):
        path = Path(f"{assignment}.yaml")
    if not only and path.exists():
        return read_spec(path)
    return spec_of(Path(assignment).stem, only, points)


_FIGURE = re.compile(r"!\[(?:\\.|[^\]])*\]\(attachment:[^)]*\)")


def _of_course(course, name):
    notebook, base = read_json(course.source(name)), course.built(name)
    built = {c.get("id"): "".join(c["source"]) for c in load_json(base.read_bytes())["cells"]}
    worth, items = tasks(notebook), []
    for cell in notebook["cells"]:
        own, text = own_metadata(cell), cell["source"]
        role, number = own.get("role", ""), own.get("problem", "")
        if role == "statement" and number in worth:
            task = worth[number]
            changed = "" if text == built.get(cell.get("id")) else _FIGURE.sub("", text)
            items.append(Item(task.exercise, changed, {"points": task.points}))
        elif cell["cell_type"] == "markdown" and role not in ("statement", "introduction"):
            items.append(Item(text=text))
    kept = base.with_suffix(".yaml")
    spec = read_spec(kept) if kept.exists() else Spec(name, name, ())
    return replace(spec, name=name, items=tuple(items))

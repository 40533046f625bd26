"""The file of an assignment, written from the source notebook that is in a course."""

from datetime import datetime

from exercises.catalogue import CatalogueError
from exercises.catalogue import problem as find_problem

from ..course import Course, CourseError, read_json
from .cells import Notebook, kind, nbgrader_metadata, own_metadata
from .options import OPTIONS
from .spec import Item, Spec


def spec_of_course(course: Course, name: str) -> tuple[Spec, list[str]]:
    """(the assignment as its source notebook is now, the cells that a file cannot say: questions
    of the instructor's own, problems that are no longer there).
    """
    path = course.source(name)
    if not path.exists():
        known = ", ".join(sorted(p.name for p in (course.path / "source").glob("*/")))
        raise CourseError(f"{course.path} has no assignment {name}; it has {known or 'none'}")
    notebook = read_json(path)
    items, left = _items(notebook)
    with course.gradebook() as book:
        due = next((a.duedate for a in book.assignments if a.name == name), None)
    exam = course.settings.get("exams", {}).get(name, {})
    opens = datetime.fromisoformat(exam["opens"]) if exam.get("opens") else None
    late = exam.get("late", "")
    spec = Spec(name, _title(notebook) or name, tuple(items), _text(due), _text(opens), late)
    return spec, left


def _text(when):
    return f"{when:%Y-%m-%d %H:%M} UTC" if when else ""


def _title(notebook: Notebook) -> str:
    for cell in notebook["cells"]:
        if own_metadata(cell).get("role") == "introduction":
            return cell["source"].partition("\n")[0].removeprefix("# ")
    return ""


def _items(notebook):
    items, left = [], []
    for cell in notebook["cells"]:
        role = kind(cell)
        if role == "answer":
            try:
                items.append(_problem(cell))
            except CatalogueError as error:
                left.append(str(error))
        elif cell["cell_type"] == "markdown" and (role == "plain" or role.startswith("text-")):
            items.append(Item(text=cell["source"]))
        elif role in ("test", "hand", "task", "solution", "locked", "plain"):
            left.append(nbgrader_metadata(cell).get("grade_id") or "a cell of code")
    return items, left


def _problem(cell):
    own, p = own_metadata(cell), find_problem(own_metadata(cell)["problem"])
    options = {key: own[key] for key in OPTIONS if key in own}  # type: ignore[literal-required]
    points = nbgrader_metadata(cell).get("points", 0)
    worth = {} if points == len(own.get("asked", p.answers)) else {"points": points}
    return Item(p, options=worth | options)

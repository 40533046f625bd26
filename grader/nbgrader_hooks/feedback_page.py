"""The content of the feedback page: a section for each problem and for each question of the
instructor's own. No text of a student reaches the template as HTML.
"""

import re
from dataclasses import dataclass, field
from typing import Any

import bleach
from nbformat import NotebookNode
from nbgrader import utils
from nbgrader.preprocessors import NbGraderPreprocessor

from exercises.catalogue import CatalogueError
from exercises.catalogue import problem as find_problem
from newton_euler.algebra.language import _, language

from ..assignment.cells import own_metadata
from .grading_page import LONGEST, html_with_mathml, student_html
from .shared import Processed

TAGS = {
    "a", "b", "blockquote", "br", "code", "dd", "div", "dl", "dt", "em", "h3", "h4", "h5", "h6",
    "hr", "i", "li", "ol", "p", "pre", "span", "strong", "sub", "sup", "table", "tbody", "td",
    "th", "thead", "tr", "ul",
}  # fmt: skip
ATTRIBUTES = {"a": ["href", "title"], "th": ["scope"]}

# a link to a chapter's notebook, relative to the student's folder
_LINK_BESIDE = re.compile(r'<a href="(?!#|https?:)[^"]*">(.*?)</a>')


def sanitized(markdown: str | None) -> str:
    """Markdown of a student or a grader as HTML, without scripts and external resources."""
    page = student_html(markdown or "")
    # long texts have no HTML after student_html, and would take bleach minutes
    long = len(markdown or "") > LONGEST
    return page if long else bleach.clean(page, TAGS, ATTRIBUTES, strip=True)


@dataclass
class Section:
    """A problem or an instructor's question, in HTML except for the code in numbers and answer."""

    id: str
    name: str
    title: str
    where: str = ""  # the section of the book
    statement: str = ""
    numbers: str = ""
    answer: str | None = None
    text: str | None = None  # a text as answer
    outputs: list[str] = field(default_factory=list)
    comments: list[str] = field(default_factory=list)
    score: float | None = None
    points: float | None = None
    solution: str = ""


class Sections(NbGraderPreprocessor):
    """Gathers the sections in ``resources["newton_euler"]``, once the grades are in the cells."""

    def preprocess(self, notebook: NotebookNode, resources: dict[str, Any]) -> Processed:
        sections: dict[tuple[str, str], Section] = {}  # sections in the order of the notebook
        for cell in notebook.cells:
            own = own_metadata(cell)
            if number := own.get("problem"):
                section = sections.setdefault(("problem", number), _of_problem(number))
                _add_cell(section, own.get("role"), cell)
            elif utils.is_grade(cell) or utils.is_solution(cell) or utils.is_task(cell):
                section = _of_question(cell)
                sections["question", section.name] = section
        first = notebook.cells[0].source if notebook.cells else ""
        resources["newton_euler"] = {
            "language": language(),
            "say": _,
            "sections": list(sections.values()),
            "note": first.partition("\n")[0][2:] if first.startswith("> ") else "",
        }
        return notebook, resources


def _of_problem(number: str) -> Section:
    """An empty section, with the section of the book if the catalogue still has the problem."""
    try:
        where = find_problem(number).section
    except CatalogueError:
        where = ""
    return Section("problem-" + number.replace("/", "-"), number, number, where)


def _add_cell(section: Section, role: str | None, cell: NotebookNode) -> None:
    """Put a cell of ours into the section of its problem."""
    if role == "statement":
        title, _, text = cell.source.partition("\n")
        section.title = title.removeprefix("## ")
        # the catalogue's text and figure, rebuilt by the grader
        section.statement = _LINK_BESIDE.sub(r"\1", html_with_mathml(text))
    elif role == "givens":
        section.numbers = cell.source
    elif role == "answer":
        section.answer = cell.source
        _add_grade(section, cell)
    elif role == "receipt":
        # HTML of our annotation, with everything escaped
        section.outputs += [
            o.data["text/html"] for o in cell.outputs if "text/html" in o.get("data", {})
        ]


def _of_question(cell: NotebookNode) -> Section:
    """The section of a question, with the student's text but never that of a test."""
    name = cell.metadata.nbgrader.grade_id
    section = Section(f"question-{name}", name, re.sub("[-_]", " ", name))
    if utils.is_solution(cell) or utils.is_task(cell):
        if cell.cell_type == "markdown":
            section.text = sanitized(cell.source)
        else:
            section.answer = cell.source
    _add_grade(section, cell)
    return section


def _add_grade(section: Section, cell: NotebookNode) -> None:
    grade = cell.metadata.nbgrader
    section.score, section.points = grade.get("score"), grade.get("points")
    if comment := grade.get("manual_comment"):
        section.comments.append(sanitized(comment))

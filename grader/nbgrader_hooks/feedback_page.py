"""What the feedback page shows: a section for each problem of ours and for each question of the
instructor's own, with plain texts or sanitized HTML.

The template lays it out; nothing that a student wrote reaches the page as HTML.
"""

import re

import bleach
from nbgrader import utils
from nbgrader.preprocessors import NbGraderPreprocessor

from exercises.catalogue import CatalogueError
from exercises.catalogue import problem as find_problem

from ..assignment.notebook import own_metadata
from .grading_page import LONGEST, html_with_mathml, student_html

TAGS = {
    "a", "b", "blockquote", "br", "code", "dd", "div", "dl", "dt", "em", "h3", "h4", "h5", "h6",
    "hr", "i", "li", "ol", "p", "pre", "span", "strong", "sub", "sup", "table", "tbody", "td",
    "th", "thead", "tr", "ul",
}  # fmt: skip
ATTRIBUTES = {"a": ["href", "title"], "th": ["scope"]}

# a link to a chapter leads to a notebook beside the student's own, which the page is not
_BESIDE = re.compile(r'<a href="(?!#|https?:)[^"]*">(.*?)</a>')


def sanitized(markdown):
    """Markdown of a student or a grader as HTML, without anything that runs or is fetched."""
    page = student_html(markdown or "")
    # what is long is text without any HTML, and bleach would take minutes for it
    long = len(markdown or "") > LONGEST
    return page if long else bleach.clean(page, TAGS, ATTRIBUTES, strip=True)


class Sections(NbGraderPreprocessor):
    """Gathers the sections of the page in ``resources["newton_euler"]``; runs after the grades are
    in the cells.
    """

    def preprocess(self, notebook, resources):
        problems, questions = {}, []
        for cell in notebook.cells:
            own = own_metadata(cell)
            if number := own.get("problem"):
                section = problems.setdefault(number, _section(number))
                _add_cell(section, own.get("role"), cell)
                if section not in questions:
                    questions.append(section)
            elif _is_graded(cell):
                questions.append(_question(cell))
        first = notebook.cells[0].source if notebook.cells else ""
        resources["newton_euler"] = {
            "sections": questions,
            "note": first.partition("\n")[0][2:] if first.startswith("> ") else "",
        }
        return notebook, resources


def _is_graded(cell):
    return utils.is_grade(cell) or utils.is_solution(cell) or utils.is_task(cell)


def _section(number):
    """An empty section; the book's section is named where the catalogue still has the problem."""
    try:
        where = find_problem(number).section
    except CatalogueError:
        where = ""
    return {
        "id": "problem-" + number.replace("/", "-"), "name": number, "title": number,
        "where": where, "statement": "", "numbers": "", "answer": None, "outputs": [],
        "comments": [], "score": None, "points": None, "text": None,
    }  # fmt: skip


def _add_cell(section, role, cell):
    """Put a cell of ours into the section of its problem."""
    if role == "statement":
        title, _, text = cell.source.partition("\n")
        # the catalogue's text and figure, rebuilt by the grader: not the student's
        html = _BESIDE.sub(r"\1", html_with_mathml(text))
        section.update(title=title.removeprefix("## "), statement=html)
    elif role == "givens":
        section["numbers"] = cell.source
    elif role == "answer":
        section["answer"] = cell.source
        _add_grade(section, cell)
    elif role == "receipt":
        # from our own annotation, in which everything is escaped
        section["outputs"] += [
            o.data["text/html"] for o in cell.outputs if "text/html" in o.get("data", {})
        ]


def _question(cell):
    """The section of a graded cell of the instructor's own: the student's text, never the text of a
    test.
    """
    grade_id = cell.metadata.nbgrader.grade_id
    section = _section(grade_id) | {
        "id": f"question-{grade_id}", "title": grade_id.replace("-", " ").replace("_", " "),
    }  # fmt: skip
    if utils.is_solution(cell) or utils.is_task(cell):
        if cell.cell_type == "markdown":
            section["text"] = sanitized(cell.source)
        else:
            section["answer"] = cell.source
    _add_grade(section, cell)
    return section


def _add_grade(section, cell):
    grade = cell.metadata.nbgrader
    section.update(score=grade.get("score"), points=grade.get("points"))
    said = grade.get("manual_comment")
    section["comments"] += [sanitized(said)] if said else []

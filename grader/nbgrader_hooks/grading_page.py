"""The page of nbgrader's formgrader for manual grading: without the student's name, and without
students' code running in the grader's browser.
"""

import html
import re
from typing import Any

from jinja2 import pass_context
from jinja2.runtime import Context
from nbconvert.filters.markdown_mistune import IPythonRenderer, MarkdownWithMath
from nbconvert.preprocessors import Preprocessor
from nbformat import NotebookNode

from newton_euler.algebra.language import in_all

from ..assignment.cells import kind, own_metadata
from ..assignment.notebook import OWN_COPY
from ..submission.mathml import mathml
from ..submission.rebuild import PICTURES
from .shared import Processed

Attachments = dict[str, dict[str, str]]  # attachments of a cell: {name: {MIME type: data}}
BY_STUDENTS = ("own", "hand", "plain")  # kinds of cells whose text is the student's
MOST_PICTURES = 2**26  # characters of all pictures in one text
# Markdown can take quadratic time: hours for 1 MB
LONGEST = 20_000  # characters to read as Markdown, about 3000 words
# MathJax commands that make links or set attributes
COMMANDS = re.compile(
    r"(?:\\|&#92;|&#x5c;|&bsol;)(?=(?:bbox|class|cssId|data|href|mmlToken|require|style)\b)",
    re.IGNORECASE,
)


class WithoutName(Preprocessor):
    """Removes the student's name from the introduction of a notebook."""

    def preprocess_cell(
        self, cell: NotebookNode, resources: dict[str, Any], index: int
    ) -> Processed:
        if own_metadata(cell).get("role") == "introduction":
            for text in in_all(OWN_COPY):
                whose = re.escape(text).replace(re.escape("{student}"), ".*?")
                cell.source = re.sub(whose, "", cell.source)
        return cell, resources


@pass_context
def markdown2html(context: Context, source: str) -> str:
    """A replacement of nbconvert's filter, which lets scripts in students' texts through."""
    cell = context.get("cell", {})
    attachments = cell.get("attachments", {})
    if kind(cell) in BY_STUDENTS:
        return student_html(source, attachments)
    return html_with_mathml(source, attachments)


def html_with_mathml(text: str, attachments: Attachments | None = None) -> str:
    """Markdown of the course as HTML with formulas in MathML: the formgrader needs a network for
    MathJax, and the feedback page runs no scripts.
    """
    renderer = _Renderer(escape=False, attachments=attachments or {})
    return MarkdownWithMath(renderer=renderer).render(text)


class _Renderer(IPythonRenderer):
    def inline_math(self, body):
        return mathml(body)

    def block_math(self, body):
        return mathml(body, "block")


def student_html(text: str, attachments: Attachments | None = None) -> str:
    """Markdown of a student as HTML: HTML in it is shown as text, links run no scripts, and only
    attached pictures are shown. Long texts are shown verbatim.
    """
    if len(text) > LONGEST:
        page = f"<pre>{html.escape(text)}</pre>"
    else:
        page = MarkdownWithMath(renderer=_StudentRenderer(attachments or {})).render(text)
    return COMMANDS.sub(r"\g<0> ", page)


class _StudentRenderer(IPythonRenderer):
    def __init__(self, attachments):
        # no anchors, whose ids could clash with those of the page's fields
        super().__init__(
            escape=True, allow_harmful_protocols=False, attachments=attachments,
            exclude_anchor_links=True,
        )  # fmt: skip
        self._left = MOST_PICTURES

    def image(self, text, url, title=None):
        kinds = self.attachments.get(url.removeprefix("attachment:"), {})
        found = next(((k, kinds[k]) for k in PICTURES if k in kinds), None)
        alt = self.escape_html(text)
        # limited, since a picture may be referenced many times
        if found is None or not url.startswith("attachment:") or len(found[1]) > self._left:
            return f"<em>[{alt}]</em>"
        self._left -= len(found[1])
        alt = alt.replace('"', "&quot;")
        return f'<img src="data:{found[0]};base64,{found[1]}" alt="{alt}">'

    def block_mermaidjs(self, code):
        return self.block_code(code)

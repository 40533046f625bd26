"""An executed notebook, prepared for Sphinx: folded code and answers, alternative texts, no
widgets, which need a kernel.
"""

import re
from html import escape
from pathlib import Path

from nbformat import NotebookNode

from exercises.catalogue.sections import section_anchor
from newton_euler.algebra.language import Words, _
from newton_euler.classroom.predicting.page import STATIC, inline

from . import moving

HEADING = re.compile(r"(?m)^#+ ((?:\d+|[AB])\.\d+) .+$")
# a displayed formula in a list item, which MyST wants as a paragraph of the item
IN_ITEM = re.compile(r"(?m)^(( *)(\d+\.|-) .+)\n(\$\$.+\$\$)$")
SUMMARY = re.compile(r"(?s)<summary>(.*?)</summary>")
WIDGET = "application/vnd.jupyter.widget-view+json"
TRIED = re.compile(r'try_problem\("([^"]+)"\)')
TRY = Words(
    "**Try problem {number}.** [Its page](../problems/{page}.md) checks answers and every step."
)
NO_OUTPUTS = Words("*The cells of this page have not been run.*")


def page(notebook: NotebookNode, ran: bool = True, pictures: Path | None = None) -> NotebookNode:
    """The notebook as input of Sphinx.

    pictures : folder for the pictures along sliders; None makes figures static
    """
    notebook.metadata.pop("widgets", None)
    cells = notebook.cells
    for cell, after in zip(cells, [*cells[1:], {}], strict=True):
        if cell.cell_type == "markdown":
            cell.source = _markdown(cell.source)
        elif tried := TRIED.fullmatch(cell.source.strip()):
            _say_where(cell, tried[1])
        elif cell.cell_type == "code":
            hidden = cell.metadata.get("jupyter", {}).get("source_hidden", False)
            tags = cell.metadata.setdefault("tags", [])
            if hidden and "hide-input" not in tags:
                tags.append("hide-input")
            cell.outputs = [x for x in cell.outputs if WIDGET not in x.get("data", {})]
            _without_kernel(cell)
            moving.mark(cell, pictures)
            _describe(cell, _caption(after.get("source", "")))
    if not ran:
        cells[0].source += f"\n\n{_(NO_OUTPUTS)}"
    return notebook


def _markdown(text):
    """The text of a cell with anchors at numbered sections, with <details> on lines of their own,
    so that Markdown continues inside, and with formulas in summaries and list items.
    """
    text = IN_ITEM.sub(lambda m: f"{m[1]}\n\n{m[2]}{' ' * len(m[3])} {m[4]}\n", text)
    text = HEADING.sub(lambda m: f"({section_anchor(m[1])})=\n{m[0]}", text)
    text = SUMMARY.sub(lambda m: f"\n\n<summary>{inline(m[1].strip())}</summary>\n\n", text)
    return re.sub(r"[ \t]*(</?details\b[^>]*>)[ \t]*", r"\n\n\1\n\n", text)


def _say_where(cell, number):
    """Replace a cell that checks an answer by a link to the problem."""
    page = number.replace("/", "-")
    cell.cell_type, cell.source = "markdown", _(TRY, number=number, page=page)
    cell.pop("outputs", None)
    cell.pop("execution_count", None)


def _without_kernel(cell):
    """Replace predictions by their static form. Their code, which has the answers, is hidden; the
    engine in the page reads it, since other cells use its names.
    """
    for data in (x.data for x in cell.outputs if STATIC in x.get("data", {})):
        source = escape(cell.source, quote=False)
        data["text/html"] = f'{data.pop(STATIC)}<pre class="source" hidden>{source}</pre>'
        cell.metadata.tags.append("remove-input")


def _caption(text):
    """The text of a caption, "*Figure 3. A bead on a rod.*", in plain words."""
    found = re.match(r"\s*\*((?:Figure|Bild|Film)\b.+?)\*(?:\s|$)", text, re.S)
    return " ".join(re.sub(r"[*`$]|\\(?=[a-z])", "", found[1]).split()) if found else ""


def _describe(cell, words):
    """Give the pictures of a cell an alternative text: their own, or else the caption."""
    own = (x.get("metadata", {}).get("image/png", {}).get("alt") for x in cell.outputs)
    if alt := next(filter(None, own), words):
        cell.metadata["mystnb"] = {"image": {"alt": alt}}

"""The section that a problem practises, with a link into the notebook of its chapter."""

import json
import re
from functools import cache
from pathlib import Path
from urllib.parse import quote

from newton_euler import chapters
from newton_euler.algebra.language import _, language

from .model import Problem


def section_line(p: Problem, chapters: str = "") -> str:
    """The line of a statement: "*Section* 4.10 Summary of the method", or "*Appendix* A".

    chapters : the target of the link: the address of the site ("https://…"), or the folder of the
    notebooks as seen from an assignment ("../chapters")
    """
    if not p.section:
        return ""
    what = _("Appendix") if p.section[0].isalpha() else _("Section")
    found = headings().get(p.section)
    if found is None:
        return f"*{what}* {p.section}"
    notebook, heading = found
    if not chapters:
        return f"*{what}* {heading}"
    # JupyterLab's anchors: the heading with hyphens for spaces
    at = f"{notebook}#{quote(heading.replace(' ', '-'))}"
    if "://" in chapters:
        at = f"chapters/{notebook.removesuffix('.ipynb')}.html#{section_anchor(p.section)}"
    return f"*{what}* [{heading}]({chapters.rstrip('/')}/{at})"


def section_anchor(number: str) -> str:
    """The anchor of a section on its page of the site: "section-4-10"."""
    return f"section-{number.replace('.', '-')}"


def headings() -> dict[str, tuple[str, str]]:
    """{section: (notebook, heading)} of all chapters, in the reader's language if translated."""
    return _headings(language())


@cache
def _headings(spoken):
    found, folder = {}, Path(chapters.__path__[0])
    for path in (*sorted(folder.glob("ch*.ipynb")), *sorted((folder / spoken).glob("ch*.ipynb"))):
        for cell in json.loads(path.read_text(encoding="utf-8"))["cells"]:
            if cell["cell_type"] == "markdown":
                for heading in re.findall(r"(?m)^#+ (\d+\.\d+ .+)$", "".join(cell["source"])):
                    found[heading.split()[0]] = path.name, heading.strip()
    return found

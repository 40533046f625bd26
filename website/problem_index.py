"""The page for choosing a problem: one table, which its script filters, with the data of ``python
-m grader problems``: no answers, steps or mistakes.
"""

import re
from collections.abc import Iterable

from exercises.catalogue import Problem, problems
from exercises.catalogue.survey import entry
from grader.assignment.notebook import slug

from .rendering import rendered


def page(names: Iterable[str]) -> str:
    """The text of the page, for the problems of these chapters."""
    found = [(p, entry(p), _words(p)) for name in names for p in problems(name)]
    kinds = sorted({kind for _, e, _ in found for kind in e.kinds}, key=str)
    return rendered("choose.md", found=found, kinds=kinds, slug=slug)


def _words(p: Problem) -> str:
    """The text that is searched."""
    return " ".join(re.sub(r"[{}$\\]", " ", f"{p.id} {p.title} {p.text}").lower().split())

"""The first page: introduction, chapters, how to run and build them."""

import re
from collections.abc import Collection, Iterable, Mapping
from html import escape

from exercises.catalogue import chapter, problems
from newton_euler import __version__
from newton_euler.algebra.language import Words, _
from newton_euler.drawing.page.letters import letters

from . import landing
from .notebooks import Chapter
from .problem_pages import heading
from .rendering import rendered

TITLE = Words("Newton-Euler dynamics")


def page(
    chapters: Iterable[Chapter],
    problem_names: Collection[str],
    reference: Mapping[str, str],
    question: str = "",
) -> str:
    """The text of the first page; ``question`` is HTML, about its figure."""
    choose = _("Choose a problem")
    trees = {
        _("Chapters"): [f"chapters/{c.stem}" for c in chapters],
        _("Problems"): [
            f"{choose} <problems/index>",
            *(f"{_short(name)} <problems/{name}>" for name in problem_names),
        ],
        _("Reference"): [f"reference/{name}" for name in reference],
    }
    count = sum(len(problems(name)) for name in problem_names)
    return rendered(
        "index.md", title=_(TITLE), count=count, moving=landing.moving_figure(), question=question,
        chapters=map(_chapter, chapters), problems=map(_problems, problem_names),
        reference=reference, version=__version__, trees=trees,
    )  # fmt: skip


def _chapter(c):
    title, words = c.opening
    words = re.sub(r"\$[^$]+\$", _as_letters, words)  # MathJax is ten times the size of this page
    return f"- **[{title}](chapters/{c.stem}.ipynb)**\n\n  {words.replace(chr(10), chr(10) + '  ')}"


def _as_letters(formula):
    found = ""
    for run in letters(formula[0]).runs:
        tags = ("i", run.italic), ("b", run.bold), ("sup", run.level > 0), ("sub", run.level < 0)
        text = escape(run.text)
        for tag in (tag for tag, is_so in tags if is_so):
            text = f"<{tag}>{text}</{tag}>"
        found += text
    return found


def _problems(name):
    title = heading(chapter(name).title)
    return f"- [{title}](problems/{name}.md) ({len(problems(name))})"


def _short(name):
    """ "Chapter 4", for the sidebar."""
    return chapter(name).title.partition(":")[0]

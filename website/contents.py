"""The first page: what this is, the chapters, how to run and to build them."""

import re
from collections.abc import Collection, Iterable, Mapping
from html import escape

from exercises.catalogue import chapter, problems
from newton_euler import __version__
from newton_euler.algebra.language import Words, _, spoken
from newton_euler.drawing.page.letters import letters

from . import landing
from .notebooks import Chapter
from .problem_pages import heading

WHAT = """\
# {title}

{what}

```{{raw}} html
{moving}{question}
```

- {students}
- {instructors}
- {developers}

"""
TITLE = Words("Newton-Euler dynamics")
ANSWERS_BACK = Words(
    "Dynamics in three dimensions that answers back: chapters whose figures move, {count} problems "
    "that say which mistake an answer holds, and the engine behind both. All of it works in this "
    "page: no install, no account, nothing is sent."
)
STUDENTS = Words(
    "**Students:** [choose a problem](problems/index.md) and work it on its page, or read [a "
    "chapter](#chapters)."
)
INSTRUCTORS = Words(
    "**Instructors:** assignments with numbers for each student, graded in a sandbox, with "
    "feedback that names the mistake: [run the notebooks](#run-the-notebooks), then `python -m "
    "grader demo`."
)
DEVELOPERS = Words(
    "**Developers:** the [reference](#reference) of the engine; every formula runs on floats, "
    "arrays and symbols."
)
RUN = """
(run-the-notebooks)=
## {run}

{with_python}

```
pip install './newton_euler-VERSION-py3-none-any.whl[student]'
python -m newton_euler chapters DIR
jupyter lab DIR
```

{second_line}

## {build}

{checkout}

```
pip install -e '.[fast,course,site]'
python -m website
```

"""
RUN_TEXTS = {
    "run": Words("Run the notebooks"),
    "with_python": Words(
        "With Python 3.11 or newer, and the wheel that your instructor gives you:"
    ),
    "second_line": Words(
        "The second line copies the notebooks to the folder DIR and leaves alone what is there "
        "already."
    ),
    "build": Words("Build these pages"),
    "checkout": Words("In a checkout of the course:"),
}
TREE = """\
```{{toctree}}
:hidden:
:caption: {caption}
:maxdepth: 1

{pages}
```
"""


def page(
    chapters: Iterable[Chapter],
    problem_names: Collection[str],
    reference: Mapping[str, str],
    question: str = "",
) -> str:
    """The text of the first page, with a ``question`` about its figure, as HTML."""
    count = sum(len(problems(name)) for name in problem_names)
    what = WHAT.format(
        title=_(TITLE), what=_(ANSWERS_BACK, count=count), moving=landing.moving(),
        question=question, students=_(STUDENTS),
        instructors=_(INSTRUCTORS),
        developers=_(DEVELOPERS),
    )  # fmt: skip
    choose = _("Choose a problem")
    lines = [what, "(chapters)=", f"## {_('Chapters')}", "", *map(_chapter, chapters), ""]
    lines += [f"## {_('Problems')}", ""]
    lines += [f"- **[{choose}](problems/index.md)**", *map(_problems, problem_names), ""]
    lines += ["(reference)=", f"## {_('Reference')}", ""]
    lines += [f"- [{title}](reference/{name}.rst)" for name, title in reference.items()]
    trees = {
        _("Chapters"): [f"chapters/{c.stem}" for c in chapters],
        _("Problems"): [
            f"{choose} <problems/index>",
            *(f"{_short(name)} <problems/{name}>" for name in problem_names),
        ],
        _("Reference"): [f"reference/{name}" for name in reference],
    }
    texts = {name: spoken(text) for name, text in RUN_TEXTS.items()}
    run = RUN.format(**texts).replace("VERSION", __version__)
    return "\n".join([*lines, run, *(_tree(c, p) for c, p in trees.items())])


def _chapter(c):
    title, words = c.opening
    words = re.sub(r"\$[^$]+\$", _as_letters, words)  # MathJax weighs ten times this page
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
    """ "Chapter 4", for the margin."""
    return chapter(name).title.partition(":")[0]


def _tree(caption, pages):
    return TREE.format(caption=caption, pages="\n".join(pages))

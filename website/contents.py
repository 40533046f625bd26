"""The first page: what this is, the chapters, how to run and to build them."""

import re
from collections.abc import Collection, Iterable, Mapping
from html import escape

from exercises.catalogue import chapter, problems
from newton_euler import __version__
from newton_euler.drawing.page.letters import letters

from . import landing
from .notebooks import Chapter
from .problem_pages import heading

WHAT = """\
# Newton-Euler dynamics

Dynamics in three dimensions that answers back: chapters whose figures move, {count} problems that say which mistake
an answer holds, and the engine behind both. All of it works in this page: no install, no account, nothing is sent.

```{{raw}} html
{moving}{question}<script defer src="_static/landing.js"></script>
```

- **Students:** [choose a problem](problems/index.md) and work it on its page, or read [a chapter](#chapters).
- **Instructors:** assignments with numbers for each student, graded in a sandbox, with feedback that names the
  mistake: [run the notebooks](#run-the-notebooks), then `python -m grader demo`.
- **Developers:** the [reference](#reference) of the engine; every formula runs on floats, arrays and symbols.

"""  # noqa: E501  # a text for readers
RUN = """
## Run the notebooks

With Python 3.11 or newer, and the wheel that your instructor gives you:

```
pip install './newton_euler-VERSION-py3-none-any.whl[student]'
python -m newton_euler chapters DIR
jupyter lab DIR
```

The second line copies the notebooks to the folder DIR and leaves alone what is there already.

## Build these pages

In a checkout of the course:

```
pip install -e '.[fast,course,site]'
python -m website
```

"""
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
    what = WHAT.format(count=count, moving=landing.moving(), question=question)
    lines = [what, "## Chapters", "", *map(_chapter, chapters), "", "## Problems", ""]
    lines += ["- **[Choose a problem](problems/index.md)**", *map(_problems, problem_names), ""]
    lines += ["## Reference", ""]
    lines += [f"- [{title}](reference/{name}.rst)" for name, title in reference.items()]
    trees = {
        "Chapters": [f"chapters/{c.stem}" for c in chapters],
        "Problems": [
            "Choose a problem <problems/index>",
            *(f"{_short(name)} <problems/{name}>" for name in problem_names),
        ],
        "Reference": [f"reference/{name}" for name in reference],
    }
    run = RUN.replace("VERSION", __version__)
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

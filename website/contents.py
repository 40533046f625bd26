"""The first page: what this is, the chapters, how to run and to build them."""

from collections.abc import Iterable, Mapping

from exercises.catalogue import chapter, problems
from newton_euler import __version__

from .notebooks import Chapter
from .problem_pages import heading

WHAT = """\
# Newton-Euler dynamics

Courseware for the dynamics of particles and rigid bodies in three dimensions: a notebook for each chapter, problems of the
book, and an engine in Python that computes and says how each number comes about. These pages hold the notebooks with all that they
print and draw. They need no network; films play here, and sliders and cells work from any web server.

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
    chapters: Iterable[Chapter], problem_names: Iterable[str], reference: Mapping[str, str]
) -> str:
    """The text of the first page."""
    lines = [WHAT, "## Chapters", "", *map(_chapter, chapters), "", "## Problems", ""]
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
    return f"- **[{title}](chapters/{c.stem}.ipynb)**\n\n  {words.replace(chr(10), chr(10) + '  ')}"


def _problems(name):
    title = heading(chapter(name).title)
    return f"- [{title}](problems/{name}.md) ({len(problems(name))})"


def _short(name):
    """ "Chapter 4", for the margin."""
    return chapter(name).title.partition(":")[0]


def _tree(caption, pages):
    return TREE.format(caption=caption, pages="\n".join(pages))

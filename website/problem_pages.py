"""The statements of the problems as pages, one for each chapter and one for each problem, with
figures. Nothing here calls ``solve``, ``prove`` or ``mistakes``.
"""

import os
import re
from collections.abc import Callable, Collection, Iterable
from concurrent.futures import ProcessPoolExecutor
from pathlib import Path

from exercises.catalogue import chapter, chapters, problem, problems
from exercises.catalogue.places import files_of
from exercises.catalogue.sections import section_anchor
from grader.assignment.figures import figure_png
from grader.assignment.notebook import definitions, slug, statement, typeset

from .kept import fingerprint, kept_name, store
from .notebooks import place

NUMBERS = """\
<details>
<summary>The numbers, to copy into a cell</summary>

```python
{lines}
```

</details>
"""
OWN = """\
---
orphan: true
nosearch: true
---
# {title}

`````{{container}} statement
{text}
`````

{data}

```{{raw}} html
<div class="practice" data-problem="{id}" data-file="{chapter}" data-engine hidden></div>
<script defer src="../_static/practice.js"></script>
```

[All problems of this chapter]({chapter}.md) · [Choose a problem](index.md)
"""


def names(wanted: Collection[str] = ()) -> list[str]:
    """The chapters that have problems, in the order of the book."""
    found = [c for c in chapters() if not wanted or c in wanted]
    return sorted(found, key=lambda c: place(c)[0])


def anchor(number: str) -> str:
    """Where a problem stands on its page: "p4-16", "pa-3"."""
    return f"p{slug(number)}".lower()


def page(name: str, notebook: str = "") -> str:
    """The text of the page of a chapter's problems; ``notebook``: the file name of its chapter."""
    found = chapter(name)
    lines = [f"# {heading(found.title)}", ""]
    if notebook:
        lines += [f"The problems practise [this chapter](../chapters/{notebook}).", ""]
    lines += [typeset(found.preamble, problems(name)[0]), ""] if found.preamble else []
    return "\n".join([*lines, *map(_text, problems(name))])


def heading(title: str) -> str:
    """ "Chapter 4: relative motion" as the title of its problems."""
    if not re.match(r"(Chapter|Appendix) ", title):
        return title  # of a course's own problems
    return f"Problems of {title[:1].lower()}{title[1:]}"


def _text(p):
    work = f"**[Work problem {p.id}]({slug(p.id)}.md)**"
    return f"({anchor(p.id)})=\n{_statement(p)}\n\n{work}\n\n{_data(p)}"


def _statement(p):
    text = statement(p, p.book_values, bool(p.figure), chapters="../chapters")
    text = text.replace("(attachment:figure.png)", f"(figures/{slug(p.id)}.png)")
    return re.sub(r"\(\S+?\.ipynb#.*\)$", f"(#{section_anchor(p.section)})", text)


def _data(p):
    lines = "\n".join(definitions(p, p.book_values)[1:])
    return NUMBERS.format(lines=lines) if p.givens or p.symbols else ""


def own_pages(name: str) -> dict[str, str]:
    """{file name: text} of the pages of a chapter's problems, on which they are worked."""
    found = {}
    for p in problems(name):
        head, _, text = _statement(p).partition("\n")
        found[f"{slug(p.id)}.md"] = OWN.format(
            title=head.lstrip("# "), text=text.strip(), data=_data(p), id=p.id, chapter=name
        )
    return found


def figures(wanted: Iterable[str], cache: Path, done: Callable[[int], object]) -> dict[str, bytes]:
    """{file name: PNG} of the problems of these chapters that have a figure, kept in ``cache``."""
    ids = [p.id for name in wanted for p in problems(name) if p.figure]
    found = {number: cache / _kept(problem(number)) for number in ids}
    missing = [number for number in ids if not found[number].exists()]
    done(len(ids) - len(missing))
    with ProcessPoolExecutor(os.cpu_count() or 1) as pool:
        for number, png in zip(missing, pool.map(_drawn, missing, chunksize=4), strict=True):
            store(found[number], png)
            done(1)
    return {f"{slug(number)}.png": path.read_bytes() for number, path in found.items()}


def _kept(p):
    texts = [f.read_text("utf-8") for f in files_of(p.id)]
    return kept_name(slug(p.id), ".png", *texts, fingerprint("exercises/devices"))


def _drawn(number):
    p = problem(number)
    return figure_png(p, p.book_values)

"""Everything that a sketch can draw, with the lines that draw it, as a page."""

import html
import re
from functools import cache
from itertools import groupby
from pathlib import Path
from string import Template
from typing import Any, NamedTuple

from .page.paper import AnyAxes
from .page.svg import svg_of
from .sketch import Sketch

HERE = Path(__file__).parent


class Entry(NamedTuple):
    """One picture of the page: its section, what it shows, the lines that draw it."""

    section: str
    shows: str
    code: str


@cache
def _entries():
    """The lines that come before every entry, and the entries."""
    text = (HERE / "vocabulary.txt").read_text(encoding="utf-8")
    preamble, *sections = re.split(r"^== ", text, flags=re.MULTILINE)
    found = []
    for section in sections:
        title, *items = re.split(r"^-- ", section, flags=re.MULTILINE)
        for item in items:
            shows, view, code = re.fullmatch(r"(.*) \[(.*)\]\n((?s:.*))", item).groups()
            lines = f"s = Sketch(ax, ground, {view})\n{code.strip()}"
            found.append(Entry(title.strip(), shows, lines))
    return re.sub(r"^#.*\n", "", preamble, flags=re.MULTILINE).strip(), tuple(found)


def entries() -> tuple[Entry, ...]:
    """All entries, in the order of the page."""
    return _entries()[1]


def draw(entry: Entry, ax: AnyAxes) -> Sketch:
    """Draw an entry on ``ax``; returns the sketch."""
    names: dict[str, Any] = {"ax": ax}
    exec(f"{_entries()[0]}\n{entry.code}", names)  # our own text
    return names["s"]


def page() -> str:
    """The page as HTML that needs no other file."""
    preamble, found = _entries()
    parts = [
        f"<h2>{title}</h2>\n" + "".join(map(_figure, own))
        for title, own in groupby(found, lambda entry: entry.section)
    ]
    template = Template((HERE / "vocabulary.html").read_text(encoding="utf-8"))
    return template.substitute(preamble=html.escape(preamble), parts="\n".join(parts))


def _figure(entry):
    picture = svg_of(draw, entry, size=(2.8, 2.1), alt=f"Drawing: {entry.shows}.")
    return (
        f"<figure>{picture}"
        f"<figcaption>{html.escape(entry.shows)}</figcaption>"
        f"<pre>{html.escape(entry.code)}</pre></figure>\n"
    )

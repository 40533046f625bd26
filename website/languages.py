"""The pages that are in the language of the site, and links to the same pages in others."""

import json
from collections.abc import Collection, Iterable, Mapping
from pathlib import Path
from typing import Any

from exercises.catalogue import problems
from exercises.catalogue.translations import has_own_texts
from grader.assignment.notebook import slug
from newton_euler.algebra.language import ENGLISH, _, language

from .contents import TITLE
from .notebooks import FOLDER, Chapter
from .translations import catalogue, sentences

NAMES = {"en": "English", "de": "Deutsch"}  # names of the languages, each in its own


def settings(
    found: Iterable[Chapter], wanted: Iterable[str], beside: Mapping[str, str]
) -> dict[str, Any]:
    """Settings for Sphinx: the language, the pages that are in it, and {other language: (its site,
    the pages that are in both)}.

    beside : {language: address of its site from the root of this one}
    """
    other = {n: [root, _pages(n, found, wanted)] for n, root in beside.items() if n != ENGLISH}
    own = _pages(language(), found, wanted)
    if ENGLISH in beside:
        other[ENGLISH] = [beside[ENGLISH], own]
    title = {} if language() == ENGLISH else {"html_title": _(TITLE)}
    return {"language": language(), "own_pages": own, "beside": other, **title}


def _pages(name: str, found: Iterable[Chapter], wanted: Iterable[str]) -> list[str]:
    """The pages that exist in the named language."""
    own = ["index", "problems/index", "problems/own"]
    for c in found:
        if name == ENGLISH or (FOLDER / name / c.path.name).exists():
            own.append(f"chapters/{c.stem}")
    for chapter in wanted:
        there = [slug(p.id) for p in problems(chapter) if has_own_texts(p.id, name)]
        own += [f"problems/{x}" for x in (*there, *[chapter] * bool(there))]
    return own


def write_words(pages: Path) -> None:
    """Write the translated sentences of the scripts into a site."""
    if language() == ENGLISH:
        return
    script = pages / "_static" / "words.js"
    known = catalogue(language())
    translated = {text: known[text]["msgstr"] for text in sentences([".js"]) if text in known}
    words = json.dumps(translated, ensure_ascii=False)
    script.write_text(f"const WORDS = {words};\n{script.read_text('utf-8')}", "utf-8")


def links(page: str, beside: Mapping[str, tuple[str, Collection[str]]]) -> str:
    """The links of a page to itself in other languages, as HTML."""
    up = "../" * page.count("/")
    found = [
        f'<a href="{up}{root}{page}.html" hreflang="{n}" lang="{n}">{NAMES.get(n, n)}</a>'
        for n, (root, all) in beside.items()
        if page in all
    ]
    return f'<p class="languages">{" ".join(found)}</p>' if found else ""

"""Pages with the statements and figures of the problems, one per chapter and one per problem.
Nothing here calls ``solve``, ``prove`` or ``mistakes``.
"""

import re
from collections.abc import Collection, Iterable, Iterator

from exercises.catalogue import chapter, chapters, problem, problems
from exercises.catalogue.places import files_of
from exercises.catalogue.sections import section_anchor
from grader.assignment.figures import figure_for_page
from grader.assignment.notebook import definitions, slug, statement, typeset
from newton_euler.algebra.language import _, language

from .kept import CACHE, Start, complete, fingerprint, kept_name
from .notebooks import sort_key
from .rendering import rendered

IMAGE = re.compile(r"!\[(?:[^\\\]]|\\.)*\]\(attachment:figure\.png\)")
# inline, so that it follows the page's theme; it has its own alternative text
FIGURE = """```{{raw}} html
:file: figures/{name}.svg
```"""


def names(wanted: Collection[str] = ()) -> list[str]:
    """The chapters that have problems, in the order of the book."""
    found = [c for c in chapters() if not wanted or c in wanted]
    return sorted(found, key=lambda c: sort_key(c)[0])


def page(name: str, notebook: str = "") -> str:
    """The text of a chapter's page of problems; ``notebook``: the file name of the chapter."""
    found = chapter(name)
    lines = [f"# {heading(found.title)}", ""]
    if notebook:
        line = _("The problems practise [this chapter](../chapters/{notebook}).", notebook=notebook)
        lines += [line, ""]
    lines += [typeset(found.preamble, problems(name)[0]), ""] if found.preamble else []
    return "\n".join([*lines, *map(_text, problems(name))])


def heading(title: str) -> str:
    """ "Chapter 4: relative motion" as the title of its problems."""
    if not re.match(r"(Chapter|Appendix|Kapitel|Anhang) ", title):
        return title  # a chapter of a course
    if language() != "de":  # German keeps capital letters in a sentence
        title = title[:1].lower() + title[1:]
    return _("Problems of {chapter}", chapter=title)


def _text(p):
    work = f"**[{_('Work problem {number}', number=p.id)}]({slug(p.id)}.md)**"
    return f"(p{slug(p.id).lower()})=\n{_statement(p)}\n\n{work}\n\n{_data(p)}"


def _statement(p):
    text = statement(p, p.book_values, bool(p.figure), chapters="../chapters")
    text = IMAGE.sub(FIGURE.format(name=slug(p.id)), text)
    return re.sub(r"\(\S+?\.ipynb#.*\)$", f"(#{section_anchor(p.section)})", text)


def _data(p):
    lines = "\n".join(definitions(p, p.book_values)[1:])
    return rendered("numbers.md", lines=lines) if p.givens or p.symbols else ""


def own_pages(name: str) -> Iterator[tuple[str, str]]:
    """(file name, text) of the pages on which the problems of a chapter are worked."""
    for p in problems(name):
        head, _newline, text = _statement(p).partition("\n")
        title, text = head.lstrip("# "), text.strip()
        given = {"title": title, "text": text, "data": _data(p), "id": p.id, "chapter": name}
        yield f"{slug(p.id)}.md", rendered("own.md", **given)


def figures(wanted: Iterable[str], start: Start) -> dict[str, str]:
    """{file name: SVG} of the figures of these chapters' problems, cached."""
    files = {p.id: _kept(p) for name in wanted for p in problems(name) if p.figure}
    complete(files, _drawn, start)
    return {f"{slug(number)}.svg": path.read_text("utf-8") for number, path in files.items()}


def _kept(p):
    texts = [f.read_text("utf-8") for f in files_of(p.id)]
    name = kept_name(slug(p.id), ".svg", *texts, fingerprint("exercises/devices"))
    return CACHE / "figures" / name


def _drawn(number):
    p = problem(number)
    return figure_for_page(p, p.book_values)

"""Transforms of pages in Sphinx: docstrings, formulas, links from problem numbers."""

import re
from typing import Any

from docutils import nodes

DESCRIBED = re.compile(r"([\w*][^:`]{0,60}?) : (.*)")
IDENTIFIER = re.compile(r"\*{0,2}\w+")
NUMBER = re.compile(r"(?<![\w/.])(\d+|[AB])/(\d+)(?![\w/]|\.\d)")
UNTOUCHED = (nodes.reference, nodes.literal, nodes.literal_block, nodes.math, nodes.math_block)


def slug(heading: str) -> str:
    """JupyterLab's anchor of a heading, so that links work in both."""
    return heading.strip().replace(" ", "-")


def docstring(app: Any, what: str, name: str, obj: object, options: Any, lines: list[str]) -> None:
    """Turn lines "name : text" into a definition list, and escape | and **."""
    made, inside, example, last = [], False, False, ""
    for line in lines:
        example = line.startswith(">>>") or (example and line != "")
        if example:
            made.append(line)
            continue
        text = _escaped(line.strip())
        if found := DESCRIBED.fullmatch(line):
            made += ["", _names(found[1]), f"    {_escaped(found[2])}"]
            inside = True
        elif inside and line.startswith(" "):
            made.append(f"    {text}")
        elif line.startswith("    ") and last and not last.startswith(("-", "..")):
            made.append(text)  # a continuation line
        else:
            made += ["", text] if inside and line else [_escaped(line)]
            inside = False
        last = line.strip()
    lines[:] = made


def _names(text):
    return ", ".join(f"``{n}``" if IDENTIFIER.fullmatch(n) else n for n in text.split(", "))


def _escaped(line):
    parts = line.split("``")
    parts[::2] = (part.replace("|", r"\|").replace("**", r"\*\*") for part in parts[::2])
    return "``".join(parts)


def formulas(app: Any, doctree: nodes.document) -> None:
    """Leave displayed formulas to MathJax like JupyterLab: Sphinx would use "split", which does not
    allow \\tag.
    """
    for node in doctree.findall(nodes.math_block):
        if not node.get("no-wrap") and not node.get("nowrap"):
            node["no-wrap"] = node["nowrap"] = True
            formula = nodes.Text(rf"\[{node.astext()}\]")
            node.clear()
            node += formula


def problem_links(app: Any, doctree: nodes.document) -> None:
    """Link problem numbers in a chapter, "4/16", to their statements: those of the same chapter,
    and others after the word problem.
    """
    folder, _, stem = app.env.docname.partition("/")
    if folder != "chapters":
        return
    for node in list(doctree.findall(nodes.Text)):
        if not any(isinstance(up, UNTOUCHED) for up in _above(node)):
            made = list(_pieces(str(node), _own(stem), app))
            if len(made) > 1:
                node.parent.replace(node, made)


def _above(node):
    while node.parent is not None:
        node = node.parent
        yield node


def _own(stem):
    """The chapter in problem numbers: "4" for ch04_relative_motion, "A" for appA_..."""
    name = stem.partition("_")[0]
    return name[3:] if name.startswith("app") else name[2:].lstrip("0")


def _pieces(text, own, app):
    end = 0
    for found in NUMBER.finditer(text):
        meant = found[1] == own or re.search(r"[Pp]roblems?\s[\d/,\sand]*$", text[: found.start()])
        target = _target(found[1], found[2], app) if meant else None
        if target:
            yield nodes.Text(text[end : found.start()])
            yield nodes.reference("", found[0], refuri=target, internal=True)
            end = found.end()
    yield nodes.Text(text[end:])


def _target(chapter, number, app):
    """The address of a problem, or None if the site does not have it."""
    name = f"app{chapter}" if chapter.isalpha() else f"ch{int(chapter):02d}"
    file = app.srcdir / "problems" / f"{name}.md"
    mark = f"p{chapter}-{number}".lower()
    if file.exists() and f"({mark})=" in file.read_text(encoding="utf-8"):
        return f"../problems/{name}.html#{mark}"
    return None

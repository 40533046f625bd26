"""Markdown with LaTeX formulas as Typst."""

import json
import re
from functools import lru_cache
from typing import Any

from ..course import CourseError


class PaperError(CourseError):
    """A PDF cannot be written; the message says what to do."""


BLANK = r"\text{BLANK}"  # a blank to fill in, in a formula


def typst(markdown: str) -> str:
    """A text in Markdown as Typst, with LaTeX formulas between dollar signs.

    >>> typst(r"A **rod** of $\\frac{1}{2}$ m")
    '#"A ";#strong[#"rod";]#" of ";$1/2$#" m";\\n\\n'
    """
    return _all(_parser()(markdown))


def formula(latex: str) -> str:
    """A LaTeX formula in Typst, without dollar signs."""
    return _formula(re.sub(r"\s+", " ", latex).strip())


@lru_cache
def _parser():
    import mistune

    return mistune.create_markdown(renderer=None, plugins=["table", "math"])


@lru_cache(4096)
def _formula(latex):
    from tex2typst import tex2typst

    try:  # Typst puts limits beside the integral sign anyway
        made = tex2typst(latex.replace(r"\limits", "")).replace('"BLANK"', "blank")
    except ValueError as error:
        reason = str(error).partition("\n")[0].removeprefix("Conversion failed: ")
        raise PaperError(f"${latex}$ is not a formula of LaTeX ({reason})") from None
    return re.sub(r'\s+"/', '"/', made)  # no space before the stroke of a unit


def string(text: str) -> str:
    """A text as a string literal of Typst.

    >>> string('5 $ for "a_1"')
    '"5 $ for \\\\"a_1\\\\""'
    """
    return json.dumps("".join(x for x in text if x.isprintable() or x == "\n"), ensure_ascii=False)


def _text(text):
    return f"#{string(text)};"


def _all(tokens):
    return "".join(_WRITERS.get(t["type"], _other)(t) for t in tokens)


def _other(token: dict[str, Any]) -> str:
    """A token without markup of its own: its children, or its text."""
    return _all(token["children"]) if "children" in token else _text(token.get("raw", ""))


def _around(function):
    return lambda token: f"#{function}[{_all(token['children'])}]"


def _list(token):
    function = "enum" if token["attrs"]["ordered"] else "list"
    items = (f"[{_all(item['children'])}]" for item in token["children"])
    return f"#{function}({','.join(items)})\n\n"


def _table(token):
    head, body = token["children"]
    rows = [head["children"], *(row["children"] for row in body["children"])]
    cells = ",".join(f"[{_all(cell['children'])}]" for row in rows for cell in row)
    widths = "(2fr, 3fr)" if len(rows[0]) == 2 else f"(1fr,) * {len(rows[0])}"
    return f"#terms-table({widths}, {cells})\n\n"


def in_line(latex: str, most: str = "15cm") -> str:
    """A LaTeX formula in a line of text; in an equation of matrices each side has its full height,
    and is at most ``most`` wide.
    """
    sides = re.split(r" (?== )", latex) if r"\begin" in latex else [latex]
    return " ".join(
        f"#side($ {formula(x)} $, {most})" if r"\begin" in x else f"${formula(x)}$" for x in sides
    )


_WRITERS = {
    "text": lambda t: _text(t["raw"]),
    "codespan": lambda t: f"#raw({string(t['raw'])});",
    "block_code": lambda t: f"#raw(block: true, {string(t['raw'])})\n\n",
    "inline_math": lambda t: in_line(t["raw"]),
    "block_math": lambda t: f"$ {formula(t['raw'])} $\n\n",
    "softbreak": lambda t: " ",
    "linebreak": lambda t: "#linebreak();",
    "blank_line": lambda t: "",
    "paragraph": lambda t: f"{_all(t['children'])}\n\n",
    "emphasis": _around("emph"),
    "strong": _around("strong"),
    "heading": lambda t: (
        f"#heading(level: {t['attrs']['level']})[{_all(t['children'])}]\n\n"
    ),
    "list": _list,
    "table": _table,
    "link": lambda t: f"#link({string(t['attrs']['url'])})[{_all(t['children'])}]",
    "image": _around("emph"),  # the alternative text: only figures of problems are printed
    "thematic_break": lambda t: "#line(length: 100%)\n\n",
}  # fmt: skip

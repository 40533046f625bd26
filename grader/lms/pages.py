"""Markdown as HTML, with formulas for MathJax, which every platform has."""

import re
from functools import lru_cache

from .questions import QuestionPart

DIGITS = 10


def html(markdown: str) -> str:
    """A text as XHTML, formulas between \\( and \\).

    >>> html("A *rod* of $\\\\frac12$ m")
    '<p>A <em>rod</em> of \\\\(\\\\frac12\\\\) m</p>'
    """
    made = _converter()(markdown).strip()
    return re.sub(r'<span class="math">(.*?)</span>', r"\1", made, flags=re.S)


@lru_cache
def _converter():
    import mistune

    return mistune.create_markdown(plugins=["table", "math"])


def inline(markdown: str) -> str:
    """:func:`html` without the paragraph around it."""
    return re.sub(r"^<p>(.*)</p>$", r"\1", html(markdown), flags=re.S)


def asked(part: QuestionPart, places: list[str] | None = None) -> str:
    """The request for an answer, as an HTML paragraph: its text, symbol, ``places`` for its
    numbers, and unit.
    """
    words, name, unit = (
        inline(x) for x in (part.means, _formula(part.symbol), _formula(part.unit))
    )
    if places is None:
        return f"<p>{words}{f', {name}' * bool(name)}{f', in {unit}' * bool(unit)}</p>"
    inside = _rows(part.kind.nested(places))
    return f"<p>{words}: {f'{name} = ' * bool(name)}{inside} {unit}</p>"


def _rows(places):
    """Places in parentheses, nested for the rows of a matrix."""
    return f"({', '.join(map(_rows, places))})" if isinstance(places, list) else places


def _formula(latex):
    return f"${latex}$" if latex else ""


def platform_number(x: float) -> str:
    """A number in a form that all platforms read.

    >>> platform_number(-0.1), platform_number(3.0), platform_number(2.5e-7)
    ('-0.1', '3', '2.5e-07')
    """
    return f"{x + 0.0:.{DIGITS}g}"

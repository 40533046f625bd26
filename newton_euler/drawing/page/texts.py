"""Texts of SVG."""

from html import escape

from .letters import HIGHER, LOWER, SMALL, letters
from .primitives import BLACK


def text_at(
    text: str,
    x: float,
    y: float,
    size: float,
    colour: str = BLACK,
    bold: bool = False,
    more: str = "",
) -> str:
    """A text with its middle at (x, y) in points, and ``more`` attributes."""
    found = letters(text, bold)
    base = y + size * (found.above - found.below) / 2
    return (
        f'<text x="{x:.1f}" y="{base:.1f}" font-size="{size:g}" fill="{colour}"{more}>'
        f"{''.join(_spans(found.runs, size))}</text>"
    )


def _spans(runs, size):
    """The runs of a text, each with its look where that is not the usual."""
    height, last = 0.0, None
    for run in runs:
        level = (0, HIGHER, -LOWER)[run.level]
        look = f' dy="{size * (height - level):.1f}"' if level != height else ""
        if run.over:
            look += f' dx="{-size * min(last.width(), run.width()):.1f}"'
        if run.level:
            look += f' font-size="{SMALL * size:.1f}"'
        look += ' font-style="italic"' * run.italic + ' font-weight="bold"' * run.bold
        words = escape(run.text, quote=False)
        yield f"<tspan{look}>{words}</tspan>" if look else words
        height, last = level, run

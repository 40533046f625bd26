"""Texts and formulas as outlines of SVG: their letters need no font where they are shown."""

from functools import cache
from typing import Any, NamedTuple

# letters of the commands of SVG by the codes of matplotlib's paths, and their numbers of points
_COMMANDS = {1: ("M", 1), 2: ("L", 1), 3: ("Q", 2), 4: ("C", 3)}


class Outline(NamedTuple):
    """The ``d`` of a <path>, y upwards from the base line, and the box of the line in points."""

    d: str
    width: float
    above: float
    below: float


@cache
def outline(text: str, size: float, weight: Any) -> Outline:
    """The :class:`Outline` of a text with formulas between dollars, ``size`` in points."""
    from matplotlib.font_manager import FontProperties
    from matplotlib.textpath import TextPath, text_to_path

    font = FontProperties(size=size, weight=weight)
    math = text.count("$") > 1
    width, height, below = text_to_path.get_text_width_height_descent(text, font, math)
    _, least, least_below = text_to_path.get_text_width_height_descent("lp", font, False)
    below, height = max(below, least_below), max(height, least)
    return Outline(_d(TextPath((0, 0), text, prop=font)), width, height - below, below)


def _d(path):
    """A path of matplotlib as the d of SVG."""
    parts, n = [], 0
    while n < len(path.codes):
        if path.codes[n] == path.CLOSEPOLY:
            parts.append("Z")
            n += 1
            continue
        letter, count = _COMMANDS[path.codes[n]]
        numbers = (f"{x:.2f} {y:.2f}" for x, y in path.vertices[n : n + count])
        parts.append(letter + " ".join(numbers))
        n += count
    return "".join(parts)

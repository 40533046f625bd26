"""Moodle's XML: numerical questions and choices, and cloze questions for several answers."""

import base64
import math
import re
from collections.abc import Iterable
from fractions import Fraction
from html import escape
from itertools import groupby
from operator import attrgetter

from .package import xml
from .pages import asked, html, platform_number
from .questions import Question

RIGHT = "Right."


def write(name: str, questions: Iterable[Question]) -> bytes:
    """The bank as one file; each problem is a category from which a quiz draws at random."""
    return xml(
        "moodle", name=name, categories=groupby(questions, attrgetter("title")), kind_of=_kind,
        text_of=_text, number=platform_number, base64=base64.b64encode, right=RIGHT,
    )  # fmt: skip


def _kind(q):
    if len(q.parts) > 1 or q.parts[0].count > 1:
        return "cloze"
    return "multichoice" if q.parts[0].options else "numerical"


def _text(q, kind):
    figure = f'<p><img src="@@PLUGINFILE@@/figure.png" alt="{escape(q.words)}"/></p>'
    return html(q.text) + figure * bool(q.figure) + _asked(q, kind)


def _asked(q, kind):
    if kind != "cloze":
        return asked(q.parts[0])
    weights = _weights(q)
    return "".join(asked(p, _embedded(p, w)) for p, w in zip(q.parts, weights, strict=True))


def _weights(q):
    """The weight of each number of each part, as integers for Moodle."""
    each = [Fraction(p.weight).limit_denominator(100) / p.count for p in q.parts]
    whole = math.lcm(*(x.denominator for x in each))
    return [int(x * whole) for x in each]


def _embedded(part, weight):
    if part.options:
        words = (
            f"{'=' * (w == part.key)}{_escaped(w)}#{_escaped(part.says(w))}" for w in part.options
        )
        return [f"{{{weight}:MULTICHOICE_S:{'~'.join(words)}}}"]
    return [f"{{{weight}:NUMERICAL:{'~'.join(_alternatives(b))}}}" for b in part.blanks]


def _alternatives(blank):
    yield f"={platform_number(blank.key)}:{platform_number(blank.off)}#{RIGHT}"
    for w in blank.wrong:
        yield f"%0%{platform_number(w.point[0])}:{platform_number(w.off[0])}#{_escaped(w.text)}"


def _escaped(text):
    """A text in a cloze field: HTML escaped twice, as Moodle resolves entities once more, without
    characters that end an alternative.
    """
    twice = escape(escape(text, quote=False), quote=False)
    return re.sub(r"[\\}#~]", lambda m: f"&#{ord(m[0])};", twice)

"""Moodle's XML: numerical questions and choices, and cloze questions for several answers."""

import base64
import math
import re
import xml.etree.ElementTree as ET
from collections.abc import Iterable
from fractions import Fraction
from html import escape

from .pages import asked, html, number
from .questions import Question

RIGHT = "Right."


def write(name: str, questions: Iterable[Question]) -> bytes:
    """The bank as one file; each problem is a category, from which a quiz draws at random."""
    quiz, category = ET.Element("quiz"), None
    for q in questions:
        if q.title != category:
            category = q.title
            top = ET.SubElement(quiz, "question", type="category")
            shown = category.replace("/", "//")  # a stroke begins a category below
            _text(top, "category", f"$course$/top/{name.replace('/', '//')}/{shown}")
        _question(quiz, q)
    ET.indent(quiz, " ")
    return ET.tostring(quiz, encoding="utf-8", xml_declaration=True)


def _question(quiz, q):
    alone = len(q.parts) == 1
    part = q.parts[0]
    kind = "cloze"
    if alone and part.options:
        kind = "multichoice"
    elif alone and len(part.key) == 1:
        kind = "numerical"
    item = ET.SubElement(quiz, "question", type=kind)
    _text(item, "name", f"{q.title} ({q.ident})")
    body = _html(item, "questiontext", _body(q) + _asked(q, kind))
    if q.figure:
        file = ET.SubElement(body, "file", name="figure.png", path="/", encoding="base64")
        file.text = base64.b64encode(q.figure).decode()
    _html(item, "generalfeedback", "")
    if kind != "cloze":
        ET.SubElement(item, "defaultgrade").text = number(q.points)
    ET.SubElement(item, "penalty").text = "0.3333333"
    ET.SubElement(item, "hidden").text = "0"
    ET.SubElement(item, "idnumber").text = q.ident
    if kind == "multichoice":
        for tag, value in (
            ("single", "true"),
            ("shuffleanswers", "true"),
            ("answernumbering", "none"),
        ):
            ET.SubElement(item, tag).text = value
        for word in part.options:
            _answer(item, word, 100 * (word == part.key), part.says(word))
    elif kind == "numerical":
        (blank,) = part.blanks
        _answer(item, number(blank.key), 100, RIGHT, blank.off)
        for w in blank.wrong:
            _answer(item, number(w.point[0]), 0, w.text, w.off[0])
        ET.SubElement(item, "showunits").text = "3"  # no field for a unit


def _body(q):
    figure = '<p><img src="@@PLUGINFILE@@/figure.png" alt="{}"/></p>'
    return html(q.text) + (figure.format(escape(q.words)) if q.figure else "")


def _asked(q, kind):
    if kind != "cloze":
        return asked(q.parts[0])
    weights = _weights(q)
    return "".join(asked(p, _embedded(p, w)) for p, w in zip(q.parts, weights, strict=True))


def _weights(q):
    """The weight of each number of each part: whole numbers, as Moodle wants them."""
    each = [Fraction(p.weight).limit_denominator(100) / len(_numbers(p)) for p in q.parts]
    whole = math.lcm(*(x.denominator for x in each))
    return [int(x * whole) for x in each]


def _numbers(part):
    return (part.key,) if part.options else part.key


def _embedded(part, weight):
    if part.options:
        words = (
            f"{'=' * (w == part.key)}{_escaped(w)}#{_escaped(part.says(w))}" for w in part.options
        )
        return [f"{{{weight}:MULTICHOICE_S:{'~'.join(words)}}}"]
    return [f"{{{weight}:NUMERICAL:{'~'.join(_alternatives(b))}}}" for b in part.blanks]


def _alternatives(blank):
    yield f"={number(blank.key)}:{number(blank.off)}#{RIGHT}"
    for w in blank.wrong:
        yield f"%0%{number(w.point[0])}:{number(w.off[0])}#{_escaped(w.text)}"


def _escaped(text):
    """A text within a cloze field: HTML whose entities Moodle resolves once more, without the signs
    that end an alternative.
    """
    shown = escape(escape(text, quote=False), quote=False)
    return re.sub(r"[\\}#~]", lambda m: f"&#{ord(m[0])};", shown)


def _answer(item, text, fraction, feedback, off=None):
    answer = ET.SubElement(item, "answer", fraction=str(fraction), format="moodle_auto_format")
    ET.SubElement(answer, "text").text = text
    _html(answer, "feedback", escape(feedback))
    if off is not None:
        ET.SubElement(answer, "tolerance").text = number(off)


def _text(parent, tag, text):
    ET.SubElement(ET.SubElement(parent, tag), "text").text = text


def _html(parent, tag, text):
    element = ET.SubElement(parent, tag, format="html")
    ET.SubElement(element, "text").text = text
    return element

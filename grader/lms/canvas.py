"""Canvas' package of QTI 1.2: one number or choice a question, a group of variants for each.

Canvas takes every number that a numerical question's conditions name for a right answer. So a wrong
one stands in the comment on wrong answers, with its diagnosis, and in no condition.
"""

import xml.etree.ElementTree as ET
from collections.abc import Iterable
from html import escape

from .package import packed
from .pages import asked, axis, html, number
from .questions import Question

NAMESPACE = "http://www.imsglobal.org/xsd/ims_qtiasiv1p2"
FIGURE = '<p><img src="$IMS-CC-FILEBASE$/figures/{}.png" alt="{}"/></p>'


def write(name: str, questions: Iterable[Question]) -> bytes:
    """The bank as a quiz: of each number that is asked for, Canvas draws one variant."""
    root = ET.Element("questestinterop", xmlns=NAMESPACE)
    quiz = ET.SubElement(root, "assessment", ident=f"bank-{name}", title=name)
    whole = ET.SubElement(quiz, "section", ident="root_section")
    figures: dict[str, bytes] = {}
    groups: dict[str, ET.Element] = {}
    for q in questions:
        if q.figure:
            figures[f"figures/{q.ident}.png"] = q.figure
        total = sum(p.weight for p in q.parts)
        for n, part in enumerate(q.parts):
            count = 1 if part.options else len(part.key)
            for m in range(count):
                points = q.points * part.weight / total / count
                title = ", ".join(x for x in (q.title, part.means, axis(part, m)) if x)
                place = f"{q.ident.rpartition('-')[0]}-{n}-{m}"
                if place not in groups:
                    groups[place] = _group(whole, place, title, points)
                _item(groups[place], f"{q.ident}-{n}-{m}", title, points, q, part, m)
    path = f"bank-{name}/bank-{name}.xml"
    ET.indent(root, " ")
    files = {path: ET.tostring(root, encoding="utf-8", xml_declaration=True), **figures}
    resources = [("quiz", "imsqti_xmlv1p2", [path])]
    resources += [(f"figure-{n}", "webcontent", [f]) for n, f in enumerate(figures)]
    return packed(name, files, resources, "IMS Content", "1.1.3")


def _group(whole, ident, title, points):
    section = ET.SubElement(whole, "section", ident=f"g-{ident}", title=title)
    choice = ET.SubElement(ET.SubElement(section, "selection_ordering"), "selection")
    ET.SubElement(choice, "selection_number").text = "1"
    more = ET.SubElement(choice, "selection_extension")
    ET.SubElement(more, "points_per_item").text = number(points)
    return section


def _item(section, ident, title, points, q, part, n):
    item = ET.SubElement(section, "item", ident=f"q-{ident}", title=title)
    kind = "multiple_choice_question" if part.options else "numerical_question"
    fields = ET.SubElement(ET.SubElement(item, "itemmetadata"), "qtimetadata")
    for label, entry in (("question_type", kind), ("points_possible", number(points))):
        field = ET.SubElement(fields, "qtimetadatafield")
        ET.SubElement(field, "fieldlabel").text = label
        ET.SubElement(field, "fieldentry").text = entry
    figure = FIGURE.format(q.ident, escape(q.words)) if q.figure else ""
    which = f"<p><strong>{axis(part, n)}</strong></p>" if axis(part, n) else ""
    shown = ET.SubElement(item, "presentation")
    _material(shown, html(q.text) + figure + asked(part) + which)
    judged = ET.SubElement(item, "resprocessing")
    score = {"maxvalue": "100", "minvalue": "0", "varname": "SCORE", "vartype": "Decimal"}
    ET.SubElement(ET.SubElement(judged, "outcomes"), "decvar", score)
    (_choice if part.options else _number)(item, shown, judged, part, n)


def _choice(item, shown, judged, part, n):
    field = ET.SubElement(shown, "response_lid", ident="response1", rcardinality="Single")
    words = ET.SubElement(field, "render_choice")
    for m, word in enumerate(part.options):
        _material(ET.SubElement(words, "response_label", ident=f"w{m}"), escape(word))
        if text := part.says(word):
            condition = _condition(judged, "Yes", feedback=f"w{m}_fb")
            ET.SubElement(condition, "varequal", respident="response1").text = f"w{m}"
            _feedback(item, f"w{m}_fb", text)
    condition = _condition(judged, "No", right=True)
    right = f"w{part.options.index(part.key)}"
    ET.SubElement(condition, "varequal", respident="response1").text = right


def _number(item, shown, judged, part, n):
    blank = part.blanks[n]
    field = ET.SubElement(shown, "response_str", ident="response1", rcardinality="Single")
    ET.SubElement(
        ET.SubElement(field, "render_fib", fibtype="Decimal"), "response_label", ident="answer1"
    )
    either = ET.SubElement(_condition(judged, "No", right=True), "or")
    ET.SubElement(either, "varequal", respident="response1").text = number(blank.key)
    both = ET.SubElement(either, "and")
    for tag, x in (("vargte", blank.key - blank.off), ("varlte", blank.key + blank.off)):
        ET.SubElement(both, tag, respident="response1").text = number(x)
    if blank.wrong:
        ET.SubElement(_condition(judged, "Yes", feedback="general_incorrect_fb"), "other")
        rows = (
            f"<li>{number(float(f'{w.point[0]:.3g}'))}: {escape(w.text)}</li>" for w in blank.wrong
        )
        _feedback(
            item, "general_incorrect_fb", f"<p>If you found about</p><ul>{''.join(rows)}</ul>"
        )


def _condition(judged, goes_on, right=False, feedback=""):
    condition = ET.SubElement(judged, "respcondition", {"continue": goes_on})
    found = ET.SubElement(condition, "conditionvar")
    if right:
        ET.SubElement(condition, "setvar", action="Set", varname="SCORE").text = "100"
    if feedback:
        shown = {"feedbacktype": "Response", "linkrefid": feedback}
        ET.SubElement(condition, "displayfeedback", shown)
    return found


def _feedback(item, ident, text):
    feedback = ET.SubElement(item, "itemfeedback", ident=ident)
    _material(ET.SubElement(feedback, "flow_mat"), text)


def _material(parent, text):
    ET.SubElement(ET.SubElement(parent, "material"), "mattext", texttype="text/html").text = text

"""QTI 2.1: a package of items, in which a vector is judged as a whole."""

import xml.etree.ElementTree as ET
from collections.abc import Iterable
from html import escape

from .package import packed
from .pages import asked, html, number
from .questions import Question

NAMESPACE = "http://www.imsglobal.org/xsd/imsqti_v2p1"
SCHEMA = f"{NAMESPACE} http://www.imsglobal.org/xsd/qti/qtiv2p1/imsqti_v2p1.xsd"
INSTANCE = "http://www.w3.org/2001/XMLSchema-instance"
DIAGNOSES = "DIAGNOSES"


def write(name: str, questions: Iterable[Question]) -> bytes:
    """The bank as a package: one item for each variant of each problem."""
    files, resources = {}, []
    for q in questions:
        path = f"items/{q.ident}.xml"
        files[path] = _item(q)
        used = [path]
        if q.figure:
            files[f"items/{q.ident}.png"] = q.figure
            used.append(f"items/{q.ident}.png")
        resources.append((q.ident, "imsqti_item_xmlv2p1", used))
    return packed(name, files, resources, "QTIv2.1 Package", "1.0.0")


def _item(q):
    about = {"xmlns": NAMESPACE, "xmlns:xsi": INSTANCE, "xsi:schemaLocation": SCHEMA}
    about |= {"identifier": f"q-{q.ident}", "title": q.title}
    root = ET.Element("assessmentItem", about, adaptive="false", timeDependent="false")
    for n, part in enumerate(q.parts):
        _declared(root, n, part)
    total = sum(p.weight for p in q.parts)
    for name, kind, many in (("SCORE", "float", "single"), (DIAGNOSES, "identifier", "multiple")):
        declared = {"identifier": name, "cardinality": many, "baseType": kind}
        outcome = ET.SubElement(root, "outcomeDeclaration", declared)
        if name == "SCORE":
            outcome.set("normalMaximum", number(q.points))
            ET.SubElement(ET.SubElement(outcome, "defaultValue"), "value").text = "0"
    root.append(_body(q))
    judging = ET.SubElement(root, "responseProcessing")
    for n, part in enumerate(q.parts):
        _judged(judging, n, part, q.points * part.weight / total)
    for n, part in enumerate(q.parts):
        for m, wrong in enumerate(part.wholes):
            shown = {"outcomeIdentifier": DIAGNOSES, "showHide": "show", "identifier": f"D{n}-{m}"}
            ET.SubElement(root, "modalFeedback", shown).text = wrong.text
    ET.indent(root, " ")
    return ET.tostring(root, encoding="utf-8", xml_declaration=True)


def _names(n, part):
    """The variables of a part's answers."""
    return [f"R{n}"] if part.options else [f"R{n}-{m}" for m in range(len(part.key))]


def _declared(root, n, part):
    kind = "identifier" if part.options else "float"
    keys = [f"C{part.options.index(part.key)}"] if part.options else [number(x) for x in part.key]
    for name, key in zip(_names(n, part), keys, strict=True):
        declared = {"identifier": name, "cardinality": "single", "baseType": kind}
        response = ET.SubElement(root, "responseDeclaration", declared)
        ET.SubElement(ET.SubElement(response, "correctResponse"), "value").text = key


def _body(q):
    shown = html(q.text)
    if q.figure:
        shown += f'<p><img src="{q.ident}.png" alt="{escape(q.words)}"/></p>'
    shown += "".join(_asked(n, part) for n, part in enumerate(q.parts))
    return ET.fromstring(f"<itemBody>{shown}</itemBody>")


def _asked(n, part):
    if part.options:
        words = (f'<simpleChoice identifier="C{m}">{escape(w)}</simpleChoice>'
                 for m, w in enumerate(part.options))  # fmt: skip
        return (f'{asked(part)}<choiceInteraction responseIdentifier="R{n}" shuffle="true" '
                f'maxChoices="1">{"".join(words)}</choiceInteraction>')  # fmt: skip
    fields = [f'<textEntryInteraction responseIdentifier="{name}" expectedLength="12"/>'
              for name in _names(n, part)]  # fmt: skip
    return asked(part, fields)


def _judged(parent, n, part, points):
    """The key first, so that what is right is never called a mistake."""
    condition = ET.SubElement(parent, "responseCondition")
    branch = ET.SubElement(condition, "responseIf")
    _equals(branch, n, part, part.key, part.off)
    added = ET.SubElement(ET.SubElement(branch, "setOutcomeValue", identifier="SCORE"), "sum")
    ET.SubElement(added, "variable", identifier="SCORE")
    ET.SubElement(added, "baseValue", baseType="float").text = number(points)
    for m, wrong in enumerate(part.wholes):
        branch = ET.SubElement(condition, "responseElseIf")
        _equals(branch, n, part, wrong.point, wrong.off)
        found = ET.SubElement(branch, "setOutcomeValue", identifier=DIAGNOSES)
        found = ET.SubElement(found, "multiple")
        ET.SubElement(found, "variable", identifier=DIAGNOSES)
        ET.SubElement(found, "baseValue", baseType="identifier").text = f"D{n}-{m}"


def _equals(parent, n, part, point, off):
    if part.options:
        match = ET.SubElement(parent, "match")
        ET.SubElement(match, "variable", identifier=f"R{n}")
        chosen = ET.SubElement(match, "baseValue", baseType="identifier")
        chosen.text = f"C{part.options.index(point)}"
        return
    every = ET.SubElement(parent, "and") if len(point) > 1 else parent
    for name, x, margin in zip(_names(n, part), point, off, strict=True):
        room = {"toleranceMode": "absolute", "tolerance": f"{number(margin)} {number(margin)}"}
        equal = ET.SubElement(every, "equal", room)
        ET.SubElement(equal, "variable", identifier=name)
        ET.SubElement(equal, "baseValue", baseType="float").text = number(x)

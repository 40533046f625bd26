"""QTI 2.1: a package of items, with vectors judged as a whole."""

from collections.abc import Iterable
from html import escape

from .package import archive_of, xml
from .pages import asked, html, platform_number
from .questions import Question

NAMESPACE = "http://www.imsglobal.org/xsd/imsqti_v2p1"
SCHEMA = f"{NAMESPACE} http://www.imsglobal.org/xsd/qti/qtiv2p1/imsqti_v2p1.xsd"
INSTANCE = "http://www.w3.org/2001/XMLSchema-instance"


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
    return archive_of(name, files, resources, "QTIv2.1 Package", "1.0.0")


def _item(q):
    places = {"namespace": NAMESPACE, "instance": INSTANCE, "schema": SCHEMA}
    body = html(q.text)
    if q.figure:
        body += f'<p><img src="{q.ident}.png" alt="{escape(q.words)}"/></p>'
    body += "".join(_asked(n, part) for n, part in enumerate(q.parts))
    return xml("qti", q=q, body=body, names=_names, number=platform_number, **places)


def _names(n, part):
    """The variables of a part's answers."""
    return [f"R{n}"] if part.options else [f"R{n}-{m}" for m in range(len(part.key))]


def _asked(n, part):
    if part.options:
        words = (f'<simpleChoice identifier="C{m}">{escape(w)}</simpleChoice>'
                 for m, w in enumerate(part.options))  # fmt: skip
        return (f'{asked(part)}<choiceInteraction responseIdentifier="R{n}" shuffle="true" '
                f'maxChoices="1">{"".join(words)}</choiceInteraction>')  # fmt: skip
    fields = [f'<textEntryInteraction responseIdentifier="{name}" expectedLength="12"/>'
              for name in _names(n, part)]  # fmt: skip
    return asked(part, fields)

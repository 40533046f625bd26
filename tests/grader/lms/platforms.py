"""How platforms judge what they import, by the rules of the formats: readers that share no code with
the writers. Each gives {question: judge}, and a judge of responses gives (share of the points, the
feedback). A response is a list of the numbers or words of each part.
"""

import html
import io
import re
import xml.etree.ElementTree as ET
import zipfile

NUMBER = r"-?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?"  # what Moodle takes for a number


def moodle(content):
    quiz = ET.fromstring(content)
    found = {}
    for q in quiz.iterfind("question"):
        if q.get("type") != "category":
            found[q.findtext("idnumber")] = _MOODLE[q.get("type")](q)
    return found


def _chosen(alternatives, response):
    """The first alternative that a response meets: (text, tolerance, fraction, feedback)."""
    for text, off, fraction, output in alternatives:
        if off is None and text == response:
            return fraction, output
        if off is not None and abs(float(text) - response) <= off * (1 + 1e-12):
            return fraction, output
    return 0.0, ""


def _answers(q):
    alternatives = []
    for a in q.iterfind("answer"):
        off = a.findtext("tolerance")
        output = html.unescape(a.findtext("feedback/text") or "")
        alternatives.append(
            (a.findtext("text"), off and float(off), float(a.get("fraction")) / 100, output)
        )

    def judge(response):
        ((answer,),) = response
        fraction, output = _chosen(alternatives, answer)
        return fraction, [output]

    return judge


def _cloze(q):
    fields = []
    for weight, kind, inside in re.findall(
        r"\{(\d*):(NUMERICAL|MULTICHOICE_S):(.*?)(?<!\\)\}", q.findtext("questiontext/text"), re.S
    ):
        alternatives = []
        for one in re.split(r"(?<!\\)~", inside):
            parts = re.fullmatch(r"(=|%-?\d+%)?((?:&#|[^#])+)#?(.*)", one, re.S)
            fraction, answer, output = parts.groups()
            share = float({"=": "100", None: "0"}.get(fraction, fraction).strip("%")) / 100
            output = html.unescape(html.unescape(output))
            if kind == "NUMERICAL":
                x, off = re.fullmatch(rf"({NUMBER}):({NUMBER})", answer).groups()
                alternatives.append((x, float(off), share, output))
            else:
                alternatives.append((html.unescape(html.unescape(answer)), None, share, output))
        fields.append((int(weight or 1), alternatives))

    def judge(response):
        flat = [x for part in response for x in part]
        judged = [(w, *_chosen(a, x)) for (w, a), x in zip(fields, flat, strict=True)]
        total = sum(w for w, *_ in judged)
        return sum(w * f for w, f, _ in judged) / total, [output for *_, output in judged]

    return judge


_MOODLE = {"numerical": _answers, "multichoice": _answers, "cloze": _cloze}

Q = "{http://www.imsglobal.org/xsd/imsqti_v2p1}"


def qti(content):
    archive = zipfile.ZipFile(io.BytesIO(content))
    names = set(archive.namelist())
    manifest = ET.fromstring(archive.read("imsmanifest.xml"))
    files = {f.get("href") for f in manifest.iter("{http://www.imsglobal.org/xsd/imscp_v1p1}file")}
    assert files | {"imsmanifest.xml"} == names
    found = {}
    for name in sorted(names):
        if name.endswith(".xml") and name != "imsmanifest.xml":
            item = ET.fromstring(archive.read(name))
            for image in item.iter(f"{Q}img"):
                assert f"items/{image.get('src')}" in names
            found[item.get("identifier").removeprefix("q-")] = _qti_item(item)
    return found


def _qti_item(item):
    # the order that the schema requires
    order = ["responseDeclaration", "outcomeDeclaration", "itemBody"]
    order += ["responseProcessing", "modalFeedback"]
    places = [order.index(child.tag.removeprefix(Q)) for child in item]
    assert places == sorted(places)
    kinds = {
        d.get("identifier"): d.get("baseType") for d in item.iterfind(f"{Q}responseDeclaration")
    }
    asked = [e.get("responseIdentifier") for e in item.iter() if e.get("responseIdentifier")]
    assert asked == list(kinds)
    correct = {
        d.get("identifier"): d.findtext(f"{Q}correctResponse/{Q}value")
        for d in item.iterfind(f"{Q}responseDeclaration")
    }
    words = {c.text: c.get("identifier") for c in item.iter(f"{Q}simpleChoice")}
    output = {
        m.get("identifier"): "".join(m.itertext()).strip()
        for m in item.iterfind(f"{Q}modalFeedback")
    }
    total = float(item.find(f"{Q}outcomeDeclaration").get("normalMaximum"))

    def judge(response):
        flat = [words.get(x, x) for part in response for x in part]
        given = dict(zip(asked, flat, strict=True))
        score, shown = 0.0, []
        for condition in item.find(f"{Q}responseProcessing"):
            for branch in condition:
                test, *outcomes = branch
                if _holds(test, given):
                    for outcome in outcomes:
                        value = outcome.findtext(f".//{Q}baseValue")
                        if outcome.get("identifier") == "SCORE":
                            score += float(value)
                        else:
                            shown.append(output[value])
                    break
        return score / total, shown

    right = [x if kinds[n] == "identifier" else float(x) for n, x in correct.items()]
    assert abs(judge([right])[0] - 1) < 1e-9
    return judge


def _holds(test, given):
    tag = test.tag.removeprefix(Q)
    if tag == "and":
        return all(_holds(t, given) for t in test)
    name, value = test.find(f"{Q}variable").get("identifier"), test.findtext(f"{Q}baseValue")
    if tag == "match":
        return given[name] == value
    assert (tag, test.get("toleranceMode")) == ("equal", "absolute")
    low, high = map(float, test.get("tolerance").split())
    return float(value) - low * (1 + 1e-12) <= given[name] <= float(value) + high * (1 + 1e-12)


C = "{http://www.imsglobal.org/xsd/ims_qtiasiv1p2}"


def canvas(content):
    """Items judge one number or word each, here by {question: {(part, component): judge}}. What
    Canvas' importer makes of a numerical question: each condition with numbers is a right answer.
    """
    archive = zipfile.ZipFile(io.BytesIO(content))
    (path,) = [n for n in archive.namelist() if n.endswith(".xml") and n != "imsmanifest.xml"]
    quiz = ET.fromstring(archive.read(path))
    found = {}
    for group in quiz.iter(f"{C}section"):
        for item in group.iterfind(f"{C}item"):
            assert group.findtext(f".//{C}selection_number") == "1"
            for image in re.findall(
                r'src="\$IMS-CC-FILEBASE\$/([^"]*)"', item.findtext(f".//{C}mattext")
            ):
                assert image in archive.namelist()
            ident, part, n = item.get("ident").removeprefix("q-").rsplit("-", 2)
            found.setdefault(ident, {})[int(part), int(n)] = _canvas_item(item)

    def whole(judges):
        def judge(response):
            judged = [j([[response[part][n]]]) for (part, n), j in judges.items()]
            return sum(p * f for p, f, _ in judged) / sum(p for p, *_ in judged), [
                s for *_, output in judged for s in output
            ]

        return judge

    return {ident: whole(judges) for ident, judges in found.items()}


def _canvas_item(item):
    fields = {
        f.findtext(f"{C}fieldlabel"): f.findtext(f"{C}fieldentry")
        for f in item.iter(f"{C}qtimetadatafield")
    }
    output = {
        f.get("ident"): html.unescape(re.sub("<[^>]*>", " ", f.findtext(f".//{C}mattext")))
        for f in item.iterfind(f"{C}itemfeedback")
    }
    words = {
        html.unescape(w.findtext(f".//{C}mattext")): w.get("ident")
        for w in item.iter(f"{C}response_label")
        if len(w)
    }
    points = float(fields["points_possible"])
    if fields["question_type"] == "numerical_question":
        margins = [
            (float(c.findtext(f".//{C}vargte")), float(c.findtext(f".//{C}varlte")))
            for c in item.iter(f"{C}respcondition")
            if c.find(f".//{C}varequal") is not None
        ]

        def judge(response):
            ((x,),) = response
            right = any(a - 1e-9 * abs(a) <= x <= b + 1e-9 * abs(b) for a, b in margins)
            return points, float(right), [] if right else [output.get("general_incorrect_fb", "")]

        return judge

    def choose(response):
        ((word,),) = response
        score, shown = 0.0, []
        for c in item.iter(f"{C}respcondition"):
            if c.findtext(f".//{C}varequal") == words[word]:
                score = max(score, float(c.findtext(f"{C}setvar") or 0))
                shown += [output[d.get("linkrefid")] for d in c.iterfind(f"{C}displayfeedback")]
        return points, score / 100, shown

    return choose


PLATFORMS = {"moodle": moodle, "qti": qti, "canvas": canvas}

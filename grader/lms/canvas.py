"""Canvas' package of QTI 1.2: one number or choice per question, with a group of variants.

Canvas takes every number in a numerical question's conditions for a right answer. So wrong ones are
listed, with their diagnoses, in the comment on wrong answers.
"""

from collections.abc import Iterable
from dataclasses import dataclass
from html import escape

from .package import archive_of, xml
from .pages import asked, html, platform_number
from .questions import Blank, Question, QuestionPart

NAMESPACE = "http://www.imsglobal.org/xsd/ims_qtiasiv1p2"
FIGURE = '<p><img src="$IMS-CC-FILEBASE$/figures/{}.png" alt="{}"/></p>'


def write(name: str, questions: Iterable[Question]) -> bytes:
    """The bank as a quiz: Canvas draws one variant of each number asked for."""
    figures: dict[str, bytes] = {}
    groups: dict[str, list[_Item]] = {}
    for q in questions:
        if q.figure:
            figures[f"figures/{q.ident}.png"] = q.figure
        for n, part in enumerate(q.parts):
            for m in range(part.count):
                place = f"{q.ident.rpartition('-')[0]}-{n}-{m}"
                groups.setdefault(place, []).append(_Item(q, part, n, m))
    path = f"bank-{name}/bank-{name}.xml"
    quiz = xml("canvas", namespace=NAMESPACE, name=name, groups=groups, number=platform_number)
    resources = [("quiz", "imsqti_xmlv1p2", [path])]
    resources += [(f"figure-{n}", "webcontent", [f]) for n, f in enumerate(figures)]
    return archive_of(name, {path: quiz, **figures}, resources, "IMS Content", "1.1.3")


@dataclass(frozen=True)
class _Item:
    """Number ``m``, or the choice, of part ``n`` of a question; texts are HTML."""

    question: Question
    part: QuestionPart
    n: int
    m: int

    @property
    def ident(self) -> str:
        return f"{self.question.ident}-{self.n}-{self.m}"

    @property
    def title(self) -> str:
        words = self.question.title, self.part.means, self.part.kind.places()[self.m]
        return ", ".join(x for x in words if x)

    @property
    def points(self) -> float:
        return self.question.points_of(self.part) / self.part.count

    @property
    def text(self) -> str:
        q, which = self.question, self.part.kind.places()[self.m]
        figure = FIGURE.format(q.ident, escape(q.words)) if q.figure else ""
        which = f"<p><strong>{which}</strong></p>" if which else ""
        return html(q.text) + figure + asked(self.part) + which

    @property
    def blank(self) -> Blank:
        return self.part.blanks[self.m]

    @property
    def wrong(self) -> str:
        rows = (
            f"<li>{platform_number(float(f'{w.point[0]:.3g}'))}: {escape(w.text)}</li>"
            for w in self.blank.wrong
        )
        return f"<p>If you found about</p><ul>{''.join(rows)}</ul>"

"""An instructor's preview of a problem: text, figure, key, numbers of three students, steps, listed
mistakes with their feedback.
"""

import base64
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any, NamedTuple

from exercises.catalogue import Problem
from exercises.catalogue.survey import entry
from exercises.catalogue.variants import draw

from ..assignment.cells import Values
from ..assignment.figures import figure_png
from ..assignment.lines import formatted
from ..assignment.notebook import short_number, statement
from ..assignment.sheet import with_tolerance
from ..assignment.solution import worked_solution
from ..practice.build import plain_text
from ..scoring import score_receipt
from .answers import solution_text
from .diagnoses import handed_in

STUDENTS = 3
TEMPLATE = Path(__file__).parent / "templates" / "preview.html.j2"


class Mistake(NamedTuple):
    """A listed mistake in one part: its answer, and the message to the student."""

    name: str
    key: str
    answer: str
    message: str


class Variant(NamedTuple):
    """One set of numbers, with the answers."""

    name: str
    values: Values
    answers: Mapping[str, str]


@dataclass(frozen=True)
class Preview:
    """A problem with its ``options`` on a sheet."""

    problem: Problem
    options: Mapping[str, Any]
    sheets: tuple[Variant, ...]
    mistakes: tuple[Mistake, ...]

    @property
    def id(self) -> str:
        """The number of the problem."""
        return self.problem.id

    @property
    def title(self) -> str:
        """Its title."""
        return self.problem.title

    @property
    def facts(self) -> list[str]:
        """Its entry in the catalogue, tolerance and options."""
        e = entry(self.problem)
        cited = [f"equations {', '.join(e.equations)}"] if e.equations else []
        kinds = ", ".join(kind.title for kind in e.kinds)
        rtol = self.problem.answers[0].rtol
        own = [f"{name}: {x}" for name, x in self.options.items() if name != "tolerance"]
        return [
            f"section {e.section}", kinds, f"{e.steps + e.terms} steps", *cited,
            f"difficulty {e.difficulty} of 5", f"{e.minutes} min",
            f"{e.sheets:.3g} sheet{'s' * (e.sheets != 1)}",
            f"tolerance {100 * rtol:g} % of numbers, formulas exact", *own,
        ]  # fmt: skip

    @property
    def rows(self) -> list[list[str]]:
        """The numbers and answers of the sheets: name with unit, and a column for each."""
        given = [
            [_named(n, g.unit), *(short_number(s.values[n]) for s in self.sheets)]
            for n, g in self.problem.givens.items()
        ]
        key = [
            [_named(a.key, a.unit), *(s.answers[a.key] for s in self.sheets)]
            for a in self.problem.answers
        ]
        return given + key

    @property
    def statement(self) -> str:
        """The text with the figure, as HTML, without the title."""
        p, pictures = self.problem, {}
        if png := figure_png(p, p.book_values):
            pictures["figure.png"] = {"image/png": base64.b64encode(png).decode()}
        return _html(statement(p, p.book_values, bool(pictures)).partition("\n")[2], pictures)

    @property
    def solution(self) -> str:
        """The worked solution, as HTML."""
        known = {**self.problem.book_values, **self.problem.sympy_symbols()}
        return _html(worked_solution(self.problem, known, text=False))


def _named(name, unit):
    return name if unit == "1" else f"{name} ({unit})"


def _html(markdown, pictures=None):
    from ..nbgrader_hooks.grading_page import html_with_mathml

    return html_with_mathml(markdown, pictures)


def preview(p: Problem, options: Mapping[str, Any] | None = None) -> Preview:
    """The :class:`Preview` of a problem."""
    own = dict(options or {})
    p = with_tolerance(p, own.get("tolerance"))
    drawn = {f"student {n + 1}": draw(p, f"preview {n}".encode()) for n in range(STUDENTS)}
    sheets = []
    for name, values in {"book": p.book_values, **drawn}.items():
        answers = p.solve({**p.sympy_symbols(), **values})
        sheets.append(Variant(name, values, {key: formatted(x) for key, x in answers.items()}))
    return Preview(p, own, tuple(sheets), tuple(_mistakes(p, own.get("help"))))


def _mistakes(p, help):
    values = p.book_values
    for name, answers in p.wrong({**p.sympy_symbols(), **values}).items():
        for key, tree in handed_in(p, answers).items():
            score = score_receipt(p, values, {"answers": {key: tree}})
            shown = score.without_reasons if help == "none" else score
            message = next(x.message for x in shown.parts if x.key == key)
            yield Mistake(name, key, formatted(answers[key]), message)


def preview_page(found: Iterable[Preview]) -> str:
    """The previews as one self-contained page."""
    from jinja2 import Environment

    template = Environment(autoescape=True).from_string(TEMPLATE.read_text(encoding="utf-8"))
    return template.render(found=list(found))


def preview_text(found: Preview) -> str:
    """The preview as text with rich's markup."""
    p = found.problem
    blocks = [
        plain_text(p, p.book_values),
        "\n".join(found.facts),
        "Numbers and key: the book's, and three students'",
        "\n".join("  " + "  ".join(row) for row in found.rows),
        "Listed mistakes, with the book's numbers",
        "\n".join(f"  {m.name}, {m.key} = {m.answer}\n    {m.message}" for m in found.mistakes),
    ]
    shown = [block.replace("[", r"\[") for block in blocks]
    steps = ["Steps, with the book's numbers", solution_text(p, p.book_values)]
    return "\n\n".join([f"[bold]{p.id}[/] {p.title}", *shown[:4], *steps, *shown[4:]])

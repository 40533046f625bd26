"""A page of feedback on one problem, without a course, in the current language."""

from pathlib import Path

from jinja2 import Environment

from exercises import problem
from grader.assignment.cells import code_cell
from grader.assignment.notebook import givens, statement
from grader.assignment.solution import worked_solution
from grader.nbgrader_hooks import feedback_page
from grader.nbgrader_hooks.feedback_page import Section
from grader.nbgrader_hooks.grading_page import html_with_mathml
from grader.scoring import score_receipt
from grader.submission import NotebookGrade, annotate
from newton_euler.algebra.language import _, language


def verdicts(score):
    """What is shown of a score: {kind of output: text}."""
    cell = code_cell("receipt", "", {"role": "receipt", "problem": score.problem})
    shown = annotate({"cells": [cell]}, NotebookGrade({score.problem: score}), {})
    return shown["cells"][0]["outputs"][0]["data"]


def page(number, answers):
    """The page, as HTML."""
    p = problem(number)
    score = score_receipt(p, p.book_values, {"answers": answers, "error": "x"})
    worked = Section(
        "problem", number, p.title, p.section,
        html_with_mathml(statement(p, p.book_values, figure=False)), givens(p, p.book_values),
        "H_O = None", outputs=[verdicts(score)["text/html"]], score=1, points=4,
        solution=html_with_mathml(worked_solution(p, p.book_values, text=False)),
    )  # fmt: skip
    sections = worked, Section("question", "1", "1", text="1", comments=["1"])
    own = {"sections": sections, "say": _, "language": language(), "note": "1"}
    nbgrader = {"notebook": "hw1", "score": 1, "max_score": 2, "late_penalty": 1}
    template = Path(feedback_page.__file__).parent / "templates/feedback/index.html.j2"
    resources = {"nbgrader": nbgrader, "newton_euler": own}
    return Environment().from_string(template.read_text("utf-8")).render(resources=resources)

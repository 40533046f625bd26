"""The page on which a person grades: without names, and with nothing from a student that runs."""

import re

import pytest
from nbconvert.exporters import HTMLExporter
from nbformat import from_dict

from exercises.catalogue import problem, select
from grader.assignment.notebook import build_notebook, personal_notebook, statement
from grader.assignment.solution import worked_solution
from grader.course import Course
from grader.course.creation import new_course
from grader.nbgrader_hooks import feedback_page
from grader.nbgrader_hooks.feedback_page import sanitized
from grader.nbgrader_hooks.grading_page import (
    LONGEST,
    MOST_PICTURES,
    WithoutName,
    html_with_mathml,
    student_html,
)
from grader.submission.recognition import places_by_name, places_of
from newton_euler.algebra.language import language, speaking
from tests.grader.courses import read

EVIL = {
    "<script>alert(1)</script>": "<script",
    "<img src=x onerror=alert(1)>": "<img",
    "<b onclick=alert(1)>": "<b",
    "[x](javascript:alert(1))": "javascript:",
    "[x](data:text/html;base64,AAAA)": "data:text",
    "[a]: javascript:alert(1)\n\n[a]": "javascript:",
    '![x"onerror="alert(1)](http://e.vil/x.png)': "<img",
    "![x](attachment:missing.png)": "<img",
    "```mermaid\ngraph TD; A-->B\n```": "mermaid",
    "$\\href{javascript:alert(1)}{x}$": "\\href",
    "\\\\\\href{javascript:alert(1)}{x}": "\\href",
    '$\\mmlToken{mi}[href="javascript:alert(1)"]{x}$': "\\mmlToken",
    "$\\bbox[background-image: url(http://e.vil/x.png)]{x}$": "\\bbox",
    "$$<script>alert(1)</script>$$": "<script",
    "\\begin{<script>}x\\end{<script>}": "<script",
    "# essay-comment": "id=",
}


@pytest.mark.parametrize("text", EVIL)
def test_nothing_of_a_student_runs_or_is_fetched(text):
    for page in (student_html(text), sanitized(text)):
        assert EVIL[text] not in page
        assert "onerror=alert" not in re.sub(r"&lt;.*?&gt;", "", page)


def test_formulas_of_the_course_are_typeset_without_a_script():
    """The formgrader loads MathJax from the network, and the feedback page runs no scripts."""
    for p in select(["all"]):
        page = html_with_mathml(statement(p, p.book_values, figure=False))
        assert "<math" in page or not p.units
        assert "$" not in page
        assert "\\" not in page
    assert "<mtext>mm/s²</mtext>" in html_with_mathml(r"$\text{mm/s}^2$")
    assert "<mfrac>" in html_with_mathml(r"so $$\frac{a}{b}$$")


def test_what_is_no_formula_or_is_formatted_is_shown_so():
    assert html_with_mathml(r"an $a_b_<c$ and `x`").startswith(r"<p>an $a_b_&lt;c$ and <code>")
    page = student_html("*so* $x^2 < 3$\n\n> quoted\n\n![mine](attachment:p.png)",
                        {"p.png": {"image/png": "AAAA"}})  # fmt: skip
    for part in ("<em>so</em>", "$x^2 &lt; 3$", "<blockquote>",
                 '<img src="data:image/png;base64,AAAA" alt="mine">'):  # fmt: skip
        assert part in page


def test_worked_solutions_are_typeset():
    for number in ("4/2", "4/16", "4/30"):
        p = problem(number)
        text = worked_solution(p, {**p.book_values, **p.sympy_symbols()}, text=False)
        page = html_with_mathml(text)
        assert "$" not in page
        assert page.count("<math") >= len(p.answers)
        assert page.count("<table>") == sum(len(v.terms) > 1 for v in p.formulas().values()
                                            if hasattr(v, "terms"))  # fmt: skip
        assert "**" not in page
        assert "omega" not in re.sub("<code>.*?</code>", "", page)
    assert r"\sin {\gamma}" in worked_solution(
        problem("4/2"), problem("4/2").sympy_symbols(), text=False
    )


def test_pictures_and_long_texts_fill_neither_time_nor_memory(monkeypatch):
    data = "A" * 10**6
    page = student_html("![](attachment:p)\n" * 1000, {"p": {"image/png": data}})
    assert MOST_PICTURES - len(data) < len(page) < 1.1 * MOST_PICTURES
    # reading it would take quadratic time, hours for 1 MB, and bleach minutes
    short, long = ("*a* " * (LONGEST // 4 + n) for n in (0, 1))
    assert sanitized(short).startswith("<p><em>a</em> <em>a</em>")
    monkeypatch.setattr(feedback_page.bleach, "clean", lambda *_, **__: pytest.fail("it is read"))
    assert sanitized(long) == f"<pre>{long}</pre>"


def test_feedback_does_not_copy_a_picture_into_what_it_does_not_show(monkeypatch):
    """A text of 1 MB that names an attachment of 50 MB would have become one of 5 TB."""
    from grader.nbgrader_hooks import preprocessors as p

    monkeypatch.setattr(p.GetGrades, "preprocess_cell", lambda _, cell, resources, index: cell)
    step = p.GradesAndFigures()
    step._released_texts = step._tasks = {}
    cells = [
        {"cell_type": "markdown", "source": "![](attachment:a.png)" * 3,
         "metadata": {"newton_euler": {"role": role}},
         "attachments": {"a.png": {"image/png": "A" * 1000}}}
        for role in ("statement", "own")
    ]  # fmt: skip
    ours, theirs = (step.preprocess_cell(from_dict(c), {}, 0) for c in cells)
    assert [ours.source, theirs.source] == [c["source"] for c in cells]


def graded_page(course, notebook):
    """What the formgrader makes of a notebook."""
    config = course.config()
    config.HTMLExporter.template_name = "classic"
    return HTMLExporter(config=config).from_notebook_node(from_dict(notebook))[0]


def test_it_does_not_begin_with_the_name(course):
    path = course.path / "autograded/ada/ch04/ch04.ipynb"
    assert "The copy of **ada**" in str(read(path))
    page = graded_page(course, read(path))
    assert "The copy of" not in page
    assert "Each problem has a cell for your work" in page


def test_the_configuration_of_a_course_uses_it(course):
    notebook = read(course.path / "autograded/ada/ch04/ch04.ipynb")
    own = {"newton_euler": {"role": "own"}}
    notebook["cells"].append(
        {"cell_type": "markdown", "id": "own-9", "metadata": own,
         "source": "<script>alert('mine')</script>\n\n![x](attachment:missing.png)"}
    )  # fmt: skip
    page = graded_page(course, notebook)
    assert "<script>alert" not in page
    assert "&lt;script&gt;alert" in page
    assert "data:image/png;base64" in page  # our own figures


def test_a_course_made_in_a_language_speaks_it_wherever_it_is_opened(tmp_path):
    with speaking("de"), new_course(tmp_path / "kurs"):
        pass
    with speaking("en"):
        assert Course(tmp_path / "kurs").settings["language"] == "de"
        assert language() == "de"
        made = build_notebook([problem("9/4")], "hw1", 10, 60)
        own = personal_notebook(made, "ada", {"9/4": problem("9/4").book_values}, {})
        texts = {c["id"]: c["source"] for c in own["cells"]}
        assert "Das Exemplar von **ada**." in texts["introduction"]
        assert "Schräge Platte" in texts["statement-9-4"]
        assert texts["setup"].endswith('choose_language("de")')
        bare = [{"cell_type": c["cell_type"], "source": c["source"]} for c in own["cells"]]
    found = places_of(bare, own, places_by_name(own))
    assert found[1:] == [1, 2, 3, 4, 5]  # by their first lines, in any language
    cell = from_dict({"source": texts["introduction"], "metadata": own["cells"][0]["metadata"]})
    assert "ada" not in WithoutName().preprocess_cell(cell, {}, 0)[0].source

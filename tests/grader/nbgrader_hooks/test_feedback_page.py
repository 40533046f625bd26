"""The feedback page: what it shows, that all can read it, and that no student's HTML is on it."""

import re

import pytest
from nbformat import from_dict

from exercises.catalogue import problem
from grader.grading import grade
from grader.nbgrader_hooks.feedback_page import Sections, sanitized
from tests.grader.courses import nbgrader, ran, read, submit
from tests.grader.submissions import work
from tests.jupyterlab import chromium
from tests.markup import Page


@pytest.fixture(scope="module")
def page(course):
    return Page((course.path / "feedback/ben/ch04/ch04.html").read_text())


def test_the_page_shows_the_value_read_and_names_the_section(page, course):
    text = " ".join(page.text.split())
    assert f"Section {problem('4/16').section}" in text
    receipt = next(
        c for c in read(course.path / "autograded/ben/ch04/ch04.ipynb")["cells"]
        if c["id"] == "receipt-4-16"
    )  # fmt: skip
    table = "".join(receipt["outputs"][0]["data"]["text/html"])
    values = re.findall(r"<td>(\[[^<]*\] mm/s)<sup>2</sup></td>", table)
    assert values
    assert all(f"{value}2" in text for value in values)


def test_the_page_prints_symbols_as_the_statement_does_without_a_script(page, course):
    """MathML in statements, and beside the names of answers; no LaTeX is left."""
    written = (course.path / "feedback/ben/ch04/ch04.html").read_text()
    assert len(page.all("math")) > 20
    assert not page.all("script")
    assert "$" not in re.sub(r"(?s)<(style|pre)\b.*?</\1>|base64,[^)\"]*", "", written)
    name = re.search(r'<th scope="row">(.*?)<code>alpha_CD</code></th>', written)[1]
    assert "&#x003B1;" in name or "α" in name


def test_the_page_has_landmarks_headers_of_tables_focus_and_alternative_texts(page, course):
    for tag in ("header", "nav", "main", "h1", "section", "caption", "thead"):
        assert page.all(tag), tag
    assert len(page.all("main")) == len(page.all("h1")) == 1
    assert page.all("html") == [{"lang": "en"}]
    assert all(a.get("scope") in ("row", "col") for a in page.all("th"))
    assert page.all("img")
    assert all(a["src"].startswith("data:image/svg+xml;base64,") for a in page.all("img"))
    assert all(len(a["alt"]) > 20 for a in page.all("img"))
    ids = {a["id"] for _, a in page.elements if "id" in a}
    assert all(a["href"].removeprefix("#") in ids for a in page.all("a"))
    assert all(a["aria-labelledby"] in ids for a in page.all("section"))
    assert all(a.get("tabindex") == "0" for a in page.all("pre"))  # they scroll
    style = (course.path / "feedback/ben/ch04/ch04.html").read_text().partition("</style>")[0]
    assert ":focus-visible" in style


def contrast(a, b):
    def light(colour):
        parts = [int(colour[n : n + 2], 16) / 255 for n in (1, 3, 5)]
        linear = [x / 12.92 if x <= 0.04045 else ((x + 0.055) / 1.055) ** 2.4 for x in parts]
        return sum(w * x for w, x in zip((0.2126, 0.7152, 0.0722), linear, strict=True))

    high, low = sorted((light(a), light(b)), reverse=True)
    return (high + 0.05) / (low + 0.05)


@pytest.mark.parametrize("colour", ["#00603f", "#9b2c00", "#6a4a00", "#555555", "#0b4f8a"])
def test_texts_are_dark_enough_on_white(colour):
    assert contrast(colour, "#ffffff") >= 7


INJECTIONS = ["<script>alert(1)</script>", "<img src=x onerror=alert(1)>", "{{ 7 * 7 }}"]
INJECTIONS += ["</pre></section><h1>100 / 100</h1>", '"><svg onload=alert(1)>', "&lt;b&gt;"]


@pytest.mark.integration
def test_what_students_write_is_text_wherever_it_appears(fresh):
    texts = "".join(INJECTIONS)
    notebook = work(
        fresh, "dan",
        p4_1=f"speed = {texts!r}\nacc_mag = 1  # {texts}",
        p4_16=f"raise ValueError({texts!r})",
    )  # fmt: skip
    submit(fresh, "dan", notebook)
    grade(fresh, "ch04", ["dan"])
    ran(nbgrader("generate_feedback", "ch04", "--student=dan", cwd=fresh.path))
    text = (fresh.path / "feedback/dan/ch04/ch04.html").read_text()
    page = Page(text)
    assert not page.all("script")
    assert not page.all("svg")
    assert len(page.all("h1")) == 1
    assert not [a for _, a in page.elements if any(k.startswith("on") for k in a)]
    assert "{{ 7 * 7 }}" in page.text
    assert "Content-Security-Policy" in text


@pytest.mark.parametrize("text", [*INJECTIONS, "[x](javascript:alert(1))", "![x](http://e.vil/x)"])
def test_markdown_of_a_student_is_sanitized(text):
    page = Page(sanitized(text))
    assert not {t for t, _ in page.elements} & {"script", "img", "svg", "iframe", "style", "h1"}
    assert not [a for a in page.all("a") if not a.get("href", "#").startswith(("#", "http"))]
    assert not [a for _, a in page.elements if any(k.startswith("on") for k in a)]


def cell(kind, grade_id, source, **metadata):
    own = {"grade_id": grade_id, "schema_version": 3, "locked": False, "task": False, **metadata}
    return {"cell_type": kind, "metadata": {"nbgrader": own}, "source": source, "outputs": []}


def test_questions_of_the_instructors_own_have_sections_and_no_test_is_shown():
    cells = [
        cell("markdown", "essay", "my *view* <script>x</script>", grade=True, solution=True,
             score=2, points=5, manual_comment="good **work**"),
        cell("code", "sort_it", "def f(): ...", grade=False, solution=True),
        cell("code", "test_sort", "assert f() == 'the key'", grade=True, solution=False, score=0,
             points=1),
        cell("markdown", "draw", "draw it", grade=False, solution=False, task=True, score=None,
             points=3),
        {"cell_type": "markdown", "metadata": {}, "source": "a text"},
    ]  # fmt: skip
    _, resources = Sections().preprocess(from_dict({"cells": cells, "metadata": {}}), {})
    sections = {s.name: s for s in resources["newton_euler"]["sections"]}
    assert list(sections) == ["essay", "sort_it", "test_sort", "draw"]
    assert "<em>view</em>" in sections["essay"].text
    assert "<strong>work</strong>" in sections["essay"].comments[0]
    assert sections["sort_it"].answer == "def f(): ..."
    assert (sections["test_sort"].answer, sections["test_sort"].text) == (None, None)
    assert sections["test_sort"].points == 1
    assert "the key" not in str(sections)
    assert sections["draw"].score is None


WIDE = (
    "<section><p>$y$ <math><mrow>" + "<mi>x</mi><mo>+</mo>" * 60 + "</mrow></math></p>"
    "<p>" + "long" * 60 + "</p><pre>" + "code " * 60 + "</pre><code>" + "x_" * 80 + "</code>"
    "<table><tbody><tr><th>a</th><td><math><mrow>" + "<mn>12.345</mn><mo>,</mo>" * 20 + "</mrow>"
    "</math></td><td>0 / 1</td><td>" + "word " * 30 + "</td></tr></tbody></table>"
    "<div><table><tbody><tr>" + "<td>cell</td>" * 30 + "</tr></tbody></table></div></section>"
)


def test_a_phone_shows_the_page_without_scrolling_sideways(course, tmp_path):
    text = (course.path / "feedback/ben/ch04/ch04.html").read_text()
    (tmp_path / "page.html").write_text(text.replace("</main>", f"{WIDE}</main>"))
    with chromium(tmp_path / "profile") as driver:
        phone = {"width": 390, "height": 844, "deviceScaleFactor": 1, "mobile": True}
        driver.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", phone)
        driver.get((tmp_path / "page.html").as_uri())
        driver.execute_script("document.querySelectorAll('details').forEach(d => d.open = true)")
        assert driver.execute_script("return document.documentElement.scrollWidth") == 390

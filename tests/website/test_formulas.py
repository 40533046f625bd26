"""Formulas that are drawn when the site is built."""

import re

import pytest

from website.execution import WebsiteError
from website.formulas import FILES, MATHJAX, typeset

PAGE = """<html><body><p>Is <span class="math notranslate nohighlight">\\({inline}\\)</span>?</p>
<div class="output text_latex math notranslate nohighlight">
\\[\\begin{{aligned}} \\mathbf a &amp;= b \\end{{aligned}} \\tag{{4.18}}\\]</div>
<pre>\\(code\\)</pre><script>window.MathJax = {{"tex": {{}}}}</script>
<script defer="defer" src="../_static/tex-svg-full.js?v=1"></script></body></html>"""


@pytest.fixture
def pages(tmp_path):
    if not MATHJAX.files(*FILES):
        pytest.skip("npm does not reach MathJax")
    (tmp_path / "a").mkdir()
    for name, inline in (("a/one.html", "b &lt; \\frac12"), ("two.html", "c")):
        (tmp_path / name).write_text(PAGE.format(inline=inline))
    return tmp_path


def test_a_page_has_its_formulas_as_outlines_and_mathml_and_no_script_for_them(pages):
    assert typeset(pages)
    one, two = ((pages / name).read_text() for name in ("a/one.html", "two.html"))
    assert one.count("<mjx-container") == two.count("<mjx-container") == 2
    assert "MathJax =" not in one
    assert "tex-svg" not in one
    assert "<pre>\\(code\\)</pre>" in one
    assert "<mo>&lt;</mo>" in one
    assert "(4.18)" in one
    assert '<mi mathvariant="bold">a</mi>' in one
    assert not re.search(r"<mrow><(m\w+)[^>]*>[^<]*</\1></mrow>", one)  # a row of one sign
    # the style sheet turns this group upside up
    assert re.search(r'<svg[^>]*><g><use href="#_\d+"/></g></svg>', two)
    for text in (one, two):  # each page has the outlines that it uses, and no others
        used = set(re.findall(r'<use[^>]* href="#([^"]+)"', text))
        assert set(re.findall(r'<path id="([^"]+)"', text)) == used


def test_what_is_not_a_formula_ends_the_build_with_its_page(pages):
    (pages / "two.html").write_text(PAGE.format(inline="\\frac{1"))
    with pytest.raises(WebsiteError, match=r"two.html: not a formula: \\frac\{1"):
        typeset(pages)


def test_without_node_pages_stay_as_they_are(pages, monkeypatch):
    monkeypatch.setenv("PATH", "")
    before = (pages / "two.html").read_text()
    assert not typeset(pages)
    assert (pages / "two.html").read_text() == before

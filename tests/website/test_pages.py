"""The files of the site: links, anchors, and what they must and must not contain."""

import os
import re
from functools import cache
from html import unescape
from html.parser import HTMLParser
from urllib.parse import unquote, urlsplit

import pytest

from exercises.catalogue import chapters, problems
from exercises.catalogue.variants import flat
from grader.assignment.notebook import slug
from website.notebooks import chapters as notebooks
from website.reference import public, rooms

pytestmark = pytest.mark.integration
FORMULA = re.compile("(?s)<mjx-container.*?</mjx-container>")  # half of a page, without links


class Page(HTMLParser):
    """The addresses that a page refers to, its anchors and its text without formulas."""

    def __init__(self, path):
        super().__init__()
        self.links, self.ids, self.loads, self.words = [], {""}, [], []
        self.feed(FORMULA.sub("", path.read_text(encoding="utf-8")))

    def handle_starttag(self, tag, attributes):
        found = dict(attributes)
        self.ids |= {found[k] for k in ("id", "name") if k in found}
        if tag == "a" and "href" in found:
            self.links.append(found["href"])
        self.loads += [found["src"]] if "src" in found else []
        self.loads += [found["href"]] if tag == "link" and "href" in found else []

    def handle_data(self, data):
        self.words.append(data)


@cache
def read(path):
    return Page(path)


def pages(site):
    return sorted(site.rglob("*.html"))


def goes_nowhere(path, link):
    """True for an address within the site whose file or anchor is missing."""
    parts = urlsplit(link)
    if parts.scheme in ("http", "https", "data", "mailto"):
        return False
    target = (path.parent / unquote(parts.path)).resolve() if parts.path else path
    if not target.is_file():
        return True
    anchor = unquote(parts.fragment)
    return target.suffix == ".html" and bool(anchor) and anchor not in read(target).ids


def test_the_build_writes_into_its_folder_only(site):
    if "SITE" not in os.environ:
        assert [path.name for path in site.parent.iterdir()] == [site.name]
    assert not list(site.rglob("*.ipynb"))


def test_no_link_is_dead(site):
    links = ((path, link) for path in pages(site) for link in read(path).links + read(path).loads)
    assert [(path.name, link) for path, link in links if goes_nowhere(path, link)] == []


def test_nothing_is_loaded_from_elsewhere(site):
    is_away = lambda link: urlsplit(link).scheme in ("http", "https") or link.startswith("//")
    loads = ((path.name, link[:80]) for path in pages(site) for link in read(path).loads)
    assert [x for x in loads if is_away(x[1])] == []
    for style in site.rglob("*.css"):
        assert not re.search(r"url\(['\"]?(https?:)?//|@import", style.read_text("utf-8")), style


def test_every_problem_has_its_anchor_and_every_chapter_its_page(site):
    for name in chapters():
        ids = read(site / "problems" / f"{name}.html").ids
        assert {anchor(p) for p in problems(name)} <= ids
    for c in notebooks():
        assert (site / "chapters" / f"{c.stem}.html").exists()


def anchor(p):
    return f"p{slug(p.id)}".lower()


def test_numbers_of_problems_and_cells_that_check_answers_are_links_and_fractions_are_not(site):
    sample = read(site / "chapters" / "sample.html")
    numbers = "ch04.html#p4-16", "ch03.html#p3-27", "ch03.html#p3-25"
    tried = "ch04.html#p4-12", "4-12.html"
    assert {f"../problems/{name}" for name in (*numbers, *tried)} <= {*sample.links}
    assert "../problems/ch03.html#p3-4" not in sample.links
    assert "No practice file" not in "".join(sample.words)
    back = read(site / "problems" / "ch04.html").links
    assert "../chapters/ch04_relative_motion.html#section-4-10" in back


def test_pieces_of_an_output_are_one_and_only_code_with_a_colour_has_marks(site):
    text = (site / "chapters" / "sample.html").read_text("utf-8")
    assert "<span></span>one\ntwo\n</pre>" in text
    assert 'Frame(<span class="s2">"ground"</span>)<span class="o">.</span>vector(' in text


def test_every_public_name_of_the_engine_is_described(site):
    for room in rooms():
        ids = read(site / "reference" / f"{room}.html").ids
        for name in (n for names in public(room).values() for n in names):
            assert f"newton_euler.{room}.{name}" in ids, name


def test_no_page_holds_the_code_of_a_problem(site):
    for path in (*pages(site), *site.rglob("*.js")):
        text = path.read_text(encoding="utf-8")
        bare = unescape(re.sub(r"<[^>]+>", "", text)) if path.suffix == ".html" else text
        for trace in ("def solve(g", "def prove(g", "def mistakes(g", "exercises.catalogue.proofs"):
            assert trace not in bare, (path.name, trace)


def test_no_problem_page_names_a_mistake(site):
    for name in chapters():
        shown = " ".join(" ".join(read(site / "problems" / f"{name}.html").words).split())
        for p in problems(name):
            for words in p.mistakes.values():
                text = getattr(words, "text", words)
                assert len(text) < 25 or text not in shown, (p.id, text)


def keys(p):
    """The numbers of the answers too long to match by chance: four digits and more."""
    answers = {} if p.symbols else p.solve(p.book_values)
    numbers = [x for value in answers.values() for x in flat(value) if isinstance(x, float)]
    found = {f"{abs(x):.5g}" for x in numbers}
    return {x for x in found if "e" not in x and len(x.strip("0.").replace(".", "")) >= 4}


def section(text, p):
    """The part of a page that is about one problem."""
    start = text.index(f'id="{anchor(p)}"')
    end = text.find("<section", start + 200)
    return text[start : end if end > 0 else None]


@pytest.mark.parametrize("name", chapters())
def test_no_problem_page_holds_a_key(site, name):
    text = (site / "problems" / f"{name}.html").read_text(encoding="utf-8")
    compared = 0
    for p in problems(name):
        given = {f"{abs(x):.5g}" for x in p.book_values.values()}
        words = re.sub(r"<[^>]+>", " ", section(text, p))
        for key in keys(p) - given:
            compared += 1
            assert not re.search(rf"(?<![\d.]){re.escape(key)}", words), (p.id, key)
    assert compared >= 5


def test_the_search_knows_no_answers(site):
    index = (site / "searchindex.js").read_text(encoding="utf-8")
    assert "coriolis" in index
    for word in ("no_coriolis", "beta_the_other_way", "newton_euler.exercises"):
        assert word not in index


def test_every_problem_can_be_chosen_by_data_that_give_away_no_mistake_and_no_answer(site):
    text = (site / "problems/index.html").read_text(encoding="utf-8")
    found = re.findall("(?s)<tr data.*?</tr>", re.sub(r' data-sheets="\d+"', "", text))
    rows = {re.search('href="(.*?)"', row)[1]: unescape(row) for row in found}
    for name in chapters():
        for p in problems(name):
            row = rows.pop(f"{slug(p.id)}.html")
            assert not any(getattr(m, "text", m) in row for m in p.mistakes.values()), p.id
            assert not any(number in row for number in keys(p)), p.id
    assert rows == {}


def test_without_javascript_a_problem_page_is_complete(site):
    text = (site / "problems" / "4-16.html").read_text("utf-8")
    assert "Elbow arm on a turning shaft" in text
    assert re.search(r'<svg[^>]* class="sketch[^>]* aria-label="A vertical shaft', text)
    assert text.count("<mjx-container") > 10
    assert '<div class="practice" data-problem="4/16" data-file="ch04" data-engine hidden>' in text

"""Each statement names the section that it practises, and links to it where a notebook has it."""

from dataclasses import replace
from pathlib import Path

import pytest

from exercises.catalogue import problem
from exercises.catalogue.sections import headings, section_line
from grader.assignment.notebook import statement
from newton_euler import chapters
from tests.by_chapter import by_chapter

NAMED = "*Section* 4.10 Summary of the method"
LINKED = "*Section* [4.10 Summary of the method]"


@pytest.mark.parametrize(("chapters", "line"), [
    ("", NAMED),
    ("../chapters", f"{LINKED}(../chapters/ch04_relative_motion.ipynb#4.10-Summary-of-the-method)"),
    ("https://uni.edu/ne/", f"{LINKED}(https://uni.edu/ne/chapters/ch04_relative_motion.html#section-4-10)"),
], ids=["nowhere", "notebooks", "site"])  # fmt: skip
def test_a_section_is_named_and_links_to_where_the_course_has_the_chapters(chapters, line):
    assert section_line(problem("4/16"), chapters) == line


def test_a_section_without_a_notebook_and_an_appendix_are_named():
    assert section_line(replace(problem("4/16"), section="99.1")) == "*Section* 99.1"
    assert section_line(problem("A/7")) == "*Appendix* A"


def test_the_notebooks_of_the_links_are_there():
    folder = Path(chapters.__path__[0])
    assert all((folder / name).exists() for name, _ in headings().values())


@by_chapter
def test_every_statement_ends_with_its_section(p):
    assert statement(p, p.book_values).endswith(section_line(p))
    assert p.section in section_line(p)


def test_the_words_of_a_choice_are_in_the_statement():
    p = problem("2/18")
    assert "line of sight: away, toward or across" in statement(p, p.book_values)

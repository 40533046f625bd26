"""What the prose of the chapters refers to is there, and has one name."""

import re

import pytest

from tests.chapters.notebooks import CHAPTERS, each_chapter, prose, read, sections_of

# words that say nothing about what is found there
EMPTY = "a all at it its one subject that them these those three two"
REFERENCE = re.compile(
    r"([\w'-]+) (?:of|from|in) (?:section|chapter|appendix) (\d+\.\d+|[AB]\.\d|\d+|[AB])\b"
)
FIGURE = re.compile(r"[Ff]igures? ((?:\d+|[AB])\.\d+)")


def texts():
    """{number of a section: its text, prose and code}."""
    return {
        section: "\n".join(part if isinstance(part, str) else part.source for part in parts).lower()
        for path in CHAPTERS
        for section, parts in sections_of(path).items()
    }


def unfound(text, sections):
    """The references of a text to something that the section or chapter does not mention."""
    bare = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", text)
    for word, place in REFERENCE.findall(bare):
        there = " ".join(text for n, text in sections.items() if place in (n, n.partition(".")[0]))
        stem = re.sub(r"(ing|es|ed|s|e)$", "", word.lower())
        if word.lower() not in EMPTY.split() and stem not in there:
            yield f"{word} of {place}"


@pytest.fixture(scope="module")
def sections():
    return texts()


@each_chapter
def test_what_is_said_to_be_in_a_section_is_there(path, sections):
    assert list(unfound(prose(read(path)), sections)) == []


def test_a_reference_to_something_missing_is_found():
    sections = {"6.8": "gravity and weight", "11.2": "a potential"}
    fine = "the weight of section 6.8, potentials of chapter 11, those of section 6.8"
    assert list(unfound(fine, sections)) == []
    assert list(unfound("the [orbit](x) of chapter 11", sections)) == ["orbit of 11"]


@each_chapter
def test_every_figure_that_is_named_has_its_caption(path):
    everywhere = "\n".join(prose(read(p)) for p in CHAPTERS)
    captions = set(re.findall(r"^\*Figure ((?:\d+|[AB])\.\d+)\.", everywhere, re.M))
    assert set(FIGURE.findall(prose(read(path)))) <= captions


@each_chapter
def test_the_centre_of_mass_has_one_name(path):
    assert not re.findall(r"(?i)mass cent(?:re|er)|cent(?:re|er) of gravity", prose(read(path)))

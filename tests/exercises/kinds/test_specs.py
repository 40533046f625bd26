"""A chapter's spec becomes the files of its problems."""

import ast
from pathlib import Path

import pytest
import yaml

from exercises.catalogue import CatalogueError
from exercises.catalogue.format import read_problem
from exercises.catalogue.places import home
from exercises.catalogue.reading import load
from exercises.catalogue.specs import mistake_names, problem_yaml, write_chapter
from tests.by_chapter import by_chapter

SPEC = Path(__file__).with_name("spec.yaml").read_text(encoding="utf-8")


@pytest.fixture
def spec(tmp_path):
    path = tmp_path / "ch02.yaml"
    path.write_text(SPEC)
    return path


def written(spec, *only):
    return write_chapter("ch02", spec, only, spec.parent / "to")


def test_each_problem_has_a_text_that_can_be_read_and_a_code_to_be_written(spec):
    paths = written(spec)
    assert [p.name for p in paths] == ["p01.yaml", "p01.py", "p02.yaml", "p02.py"]
    p = read_problem(yaml.safe_load(paths[0].read_text()), paths[0])
    assert p.title == "Collar, sliding"
    assert p.text == 'A collar moves with {v}. Which way does it go: "up"?'
    assert p.answers[0].of == ("yes", "no")
    assert p.answers[1].means == "rate, positive upward"
    assert list(p.mistakes.values()) == [
        "leaves out the rate of v, so that a = 0", "leaves out the rate of v",
    ]  # fmt: skip
    assert "scan" not in paths[0].read_text()
    functions = [x.name for x in ast.parse(paths[1].read_text()).body[1:]]
    assert functions == ["solve", "steps", "prove", "mistakes", "draw"]


def test_a_problem_that_needs_no_figure_has_none(spec):
    text, code = written(spec, "2/2")
    p = read_problem(yaml.safe_load(text.read_text()), text)
    assert (p.figure, p.symbols["omega"].unit) == ("", "rad/s")
    assert "def draw" not in code.read_text()


def test_the_chapter_has_its_title(spec):
    written(spec)
    home = spec.parent / "to" / "ch02"
    assert (home / "chapter.yaml").read_text() == "title: 'Chapter 2: planar kinematics'\n"
    assert (home / "__init__.py").exists()


def test_nothing_is_overwritten(spec):
    _, code = written(spec, "2/2")
    code.write_text("mine")
    assert len(written(spec)) == 2
    assert code.read_text() == "mine"
    with pytest.raises(CatalogueError, match="none is overwritten: delete those to be"):
        written(spec)


@pytest.mark.parametrize(("chapter", "only", "message"), [
    ("ch02", ["2/9"], "has no problem 2/9; of ch02 it has 2/1, 2/2"),
    ("ch03", [], "has no problem of ch03; of ch03 it has none"),
])  # fmt: skip
def test_what_is_not_in_the_spec_is_refused(spec, chapter, only, message):
    with pytest.raises(CatalogueError, match=message):
        write_chapter(chapter, spec, only, spec.parent)


def test_a_problem_that_does_not_fit_the_format_is_reported_and_nothing_is_written(spec):
    spec.write_text(SPEC.replace("kind: number", "kind: nmber"))
    with pytest.raises(CatalogueError, match=r"problem 2/1: a: kind 'nmber' is not one of"):
        written(spec)
    assert not (spec.parent / "to").exists()


@by_chapter
def test_a_spec_loses_nothing_that_a_problem_has(p):
    """Each problem of the book, as an entry of a spec, is written and read back unchanged."""
    path = home(p.chapter) / f"{p.name}.yaml"
    entry = load(path.read_text())
    assert vars(read_problem(load(problem_yaml(entry)), path)) == vars(read_problem(entry, path))


@pytest.mark.parametrize(("right", "wrong", "message"), [
    ("  title: Gradient", "  titel: Gradient", "unknown key 'titel'.*; did you mean title"),
    ("  mistakes: []", "  mistake: []", "unknown key 'mistake'.*; did you mean mistakes"),
    ("kind: expression", "kin: expression", "unknown key 'kin'.*; did you mean kind"),
    ("  answers: [{key: g", "  answer: [{key: g", "unknown key 'answer'.*; did you mean answers"),
])  # fmt: skip
def test_an_unknown_key_of_a_spec_is_refused(spec, right, wrong, message):
    assert SPEC.count(right) == 1
    spec.write_text(SPEC.replace(right, wrong))
    with pytest.raises(CatalogueError, match=message):
        written(spec)


def test_a_chapter_of_a_course_wants_its_folder(tmp_path):
    spec = tmp_path / "bridge.yaml"
    spec.write_text(
        SPEC.replace('"2/', '"bridge/').replace("# Chapter 2: planar", "# Bridges: planar")
    )
    words = "a chapter of your own: name the folder for it with --to"
    with pytest.raises(CatalogueError, match=words):
        write_chapter("bridge", spec)
    write_chapter("bridge", spec, folder=tmp_path / "own")
    assert "Bridges: planar kinematics" in (tmp_path / "own/bridge/chapter.yaml").read_text()


def test_names_of_mistakes_are_identifiers_and_differ():
    names = mistake_names(["takes 2*omega x v the other way", "takes 2*omega x v", "2 for 3"])
    assert list(names) == ["takes_omega_x_v", "takes_omega_x_v_2", "mistake"]

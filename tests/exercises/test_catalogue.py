"""The catalogue: texts, data and code of the problems are read and fit together; what is wrong is told in words."""

import re
from types import SimpleNamespace

import pytest
import sympy

from exercises import problem
from exercises.catalogue import CatalogueError, model, problems, reading, select
from newton_euler import Dimension, Frame

PROBLEMS = problems("ch04")
by_id = pytest.mark.parametrize("p", PROBLEMS, ids=lambda p: p.id.replace("/", "_"))

ENTRY = """
- id: "77/1"
  title: A wheel
  section: "4.8"
  text: A wheel of radius {r}.
  figure: A wheel.
  givens: {r: {value: 2, unit: m, means: radius, vary: [1, 3]}}
  answers: [{key: v, kind: number, unit: m/s, means: speed}]
"""


@pytest.fixture
def chapter(tmp_path, monkeypatch):
    """A function that makes chapter 77 of the catalogue, alone, from the text of its problems.yaml."""

    def forget():
        reading.chapters.cache_clear()
        reading.problems.cache_clear()

    def write(text):
        (tmp_path / "ch77").mkdir()
        (tmp_path / "ch77" / "problems.yaml").write_text(text, encoding="utf-8")
        monkeypatch.setattr(reading, "HERE", tmp_path)
        forget()
        return problems("ch77")

    yield write
    monkeypatch.undo()
    forget()


def test_chapter_4_has_its_43_problems_in_order():
    assert [p.id for p in PROBLEMS] == [f"4/{n}" for n in range(1, 44)]


@by_id
def test_text_names_only_what_the_problem_gives(p):
    named = set(re.findall(r"{(\w+)}", p.text))
    assert named <= set(p.units)
    assert set(p.symbols) <= named
    assert {a.key for a in p.answers}.isdisjoint(p.givens)


@by_id
def test_problem_says_where_components_belong_if_it_asks_for_vectors(p):
    assert bool(p.frame) or not any("vector" in a.kind for a in p.answers)


@by_id
def test_mistakes_are_told_in_words(p):
    assert len(p.mistakes) >= 3
    for text in p.mistakes.values():
        assert re.match(r"[a-z]+s ", text), f"{text!r} does not go on from 'The answer ...'"
        assert not text.endswith(".")


@by_id
def test_a_problem_without_any_number_asks_for_formulas(p):
    assert p.symbolic == bool(p.symbols)
    assert p.symbolic != bool(p.givens)


# -- numbers go in and out in the units of the text


def test_numbers_reach_the_code_in_base_units_and_leave_it_in_those_of_the_text():
    p = problem("4/18")
    g = p.base(p.book_values)
    assert g.b == pytest.approx(0.16)
    assert g.stated("b") == pytest.approx(160)
    assert p.in_units({"v_A": Frame("ground").vector(0, 0.25, 0)})["v_A"].y == pytest.approx(250)


def test_changed_givens_leave_the_others_alone():
    g = problem("4/16").base(problem("4/16").book_values)
    assert g.but(b_dot=-g.b_dot).omega == g.omega
    with pytest.raises(CatalogueError, match="no given 'beta_dot'; there are omega, b_dot"):
        g.but(beta_dot=1.0)


def test_formulas_contain_exactly_the_symbols_of_the_text():
    found = problem("4/42").formulas()["a_C"]
    assert {str(s) for x in found for s in sympy.sympify(x).free_symbols} == {"omega_1", "omega_2", "omega_3", "r"}


def test_dimensions_pass_through_base():
    p = problem("4/2")
    assert p.base({n: Dimension(0, 1, 0) for n in p.units}).d == Dimension(0, 1, 0)


# -- errors


@pytest.mark.parametrize(
    ("asked", "answered"),
    [
        ("4/99", "there is no problem 4/99; ch04 has 4/1 to 4/43"),
        ("99/1", "there is no problem 99/1: the chapters with problems are .*ch04"),
        ("4.16", "'4.16' is not a problem number; write chapter and problem, as in 4/16"),
        ("C/1", "'C/1' is not a problem number"),
        ("4/", "'4/' is not a problem number"),
    ],
)
def test_unknown_problem_is_told_in_words(asked, answered):
    with pytest.raises(CatalogueError, match=answered):
        problem(asked)


def test_unknown_chapter_is_told_with_those_that_are():
    with pytest.raises(CatalogueError, match=r"there is no chapter 'ch99'; there are .*ch04"):
        problems("ch99")


def test_select_takes_numbers_chapters_and_all_and_each_problem_once():
    assert [p.id for p in select(["4/2", "4/1", "4/2"])] == ["4/2", "4/1"]
    assert select(["ch04"]) == list(PROBLEMS)
    assert set(select(["all"])) >= set(PROBLEMS)
    assert select([]) == []


def test_missing_and_unknown_givens_are_named():
    with pytest.raises(CatalogueError, match="problem 4/16 lacks omega, b_dot"):
        problem("4/16").base({"beta_1": 120, "b": 8, "L": 16})
    with pytest.raises(CatalogueError, match="problem 4/16 has no speed; it has omega, b_dot, beta_1, b, L"):
        problem("4/16").base({**problem("4/16").book_values, "speed": 1})


def test_unknown_answer_is_named():
    with pytest.raises(CatalogueError, match="problem 4/16 asks for alpha_CD, v_D, a_D, not for 'a_C'"):
        problem("4/16").answer("a_C")


@pytest.mark.parametrize(
    ("right", "wrong", "told"),
    [
        ("title: A wheel", "name: A wheel", "title"),
        ("unit: m,", "unit: furlong,", "unknown unit 'furlong'"),
        ("unit: m/s,", "unit: m/s/,", "cannot read the unit 'm/s/'"),
        ("kind: number", "kind: numbr", "kind 'numbr' is none of"),
        ("vary: [1, 3]", "vary: [3, 1]", r"r: vary must be \[low, high\]"),
        ("answers: [", "answer: [", "answers"),
        ("means: radius, ", "", "means"),
    ],
)
def test_bad_entry_is_told_with_its_place(chapter, right, wrong, told):
    assert ENTRY.count(right) == 1
    with pytest.raises(CatalogueError, match=f"ch77/problems.yaml, problem 77/1: .*{told}"):
        chapter(ENTRY.replace(right, wrong))


def test_broken_yaml_is_told_with_file_and_line(chapter):
    with pytest.raises(CatalogueError, match=r"(?s)ch77/problems.yaml is not YAML: .*line 4"):
        chapter(ENTRY.replace('"4.8"', '"4.8'))


def test_the_same_problem_twice_is_told(chapter):
    with pytest.raises(CatalogueError, match=r"ch77/problems.yaml has the same problem twice: 77/1"):
        chapter(ENTRY + ENTRY)


def test_a_text_without_code_is_told(chapter):
    (p,) = chapter(ENTRY)
    with pytest.raises(CatalogueError, match=re.escape("problem 77/1 has a text but no code: write exercises/ch77/p01.py")):
        p.code.solve(None)


def test_code_without_a_function_is_told(chapter, monkeypatch):
    (p,) = chapter(ENTRY)
    half = SimpleNamespace(solve=print, draw=print)
    monkeypatch.setattr(model.importlib, "import_module", lambda name: half)
    with pytest.raises(CatalogueError, match=r"exercises/ch77/p01.py does not define prove, mistakes"):
        p.code.solve(None)


def test_an_answer_that_is_not_asked_for_is_told(chapter, monkeypatch):
    (p,) = chapter(ENTRY)
    code = SimpleNamespace(solve=lambda g: {"speed": g.r}, prove=print, mistakes=print, draw=print)
    monkeypatch.setattr(model.importlib, "import_module", lambda name: code)
    with pytest.raises(CatalogueError, match="solve of 77/1 returns speed; the problem asks for v"):
        p.solve({"r": 2.0})

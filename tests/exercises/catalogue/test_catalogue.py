"""The catalogue: texts, data and code of the problems are read and fit together; what is wrong is
reported in words.
"""

import re
from pathlib import Path
from types import SimpleNamespace

import pytest
import sympy
import yaml

from exercises import problem
from exercises.catalogue import (
    CatalogueError,
    chapter,
    chapters,
    model,
    places,
    problems,
    reading,
    select,
)
from newton_euler import Dimension, Frame
from tests.by_chapter import by_chapter

SLIPS = yaml.safe_load(Path(__file__).with_name("slips_in_a_file.yaml").read_text(encoding="utf-8"))
ENTRY = """
id: "77/1"
title: A wheel
section: "4.8"
text: A wheel of radius {r}.
figure: A wheel.
givens: {r: {value: 2, unit: m, means: radius, vary: [1, 3]}}
symbols: {h: m}
answers: [{key: v, kind: number, unit: m/s, means: speed}]
steps: {turn: {unit: rad, means: angle}}
mistakes: {twice: doubles it}
checked: {v: 2*pi}
"""


@pytest.fixture
def write(tmp_path, monkeypatch):
    """A function that puts a file into chapter 77, the only chapter of a separate catalogue."""

    home = tmp_path / "exercises"

    def put(name, text):
        (home / "ch77").mkdir(parents=True, exist_ok=True)
        (home / "ch77" / name).write_bytes(text if isinstance(text, bytes) else text.encode())
        reading.forget()

    monkeypatch.setattr(places, "EXERCISES", home)
    yield put
    monkeypatch.undo()
    reading.forget()


@pytest.mark.parametrize("name", chapters())
def test_chapter_has_a_title(name):
    assert chapter(name).name == name
    assert re.match(r"(Chapter|Appendix) \w+: \w", chapter(name).title)


@by_chapter
def test_a_problem_is_the_same_whether_asked_for_alone_or_with_its_chapter(p):
    assert problem(p.id) in problems(p.chapter)
    assert problem(p.id) is problem(p.id)


@by_chapter
def test_a_text_names_what_the_problem_gives_and_all_that_its_answers_need(p):
    named = set(re.findall(r"{(\w+)}", p.text))
    assert set(p.symbols) <= named <= set(p.units)
    assert {a.key for a in p.answers}.isdisjoint(p.givens)
    assert p.frame or not any(a.kind.is_vector for a in p.answers)  # where components belong
    assert p.symbols or not p.symbolic


@by_chapter
def test_mistakes_are_named_in_words(p):
    assert len(p.mistakes) >= 2
    for text in p.mistakes.values():
        assert re.match(r"[a-z]+s ", text), f"{text!r} does not go on from 'The answer ...'"
        assert not text.endswith(".")


def test_numbers_reach_the_code_in_base_units_and_may_be_changed_one_by_one():
    p = problem("4/18")
    g = p.base(p.book_values)
    assert g.b == pytest.approx(0.16)
    assert g.stated("b") == pytest.approx(160)
    assert p.in_units({"v_A": Frame("ground").vector(0, 0.25, 0)})["v_A"].y == pytest.approx(250)
    g = problem("4/16").base(problem("4/16").book_values)
    assert g.but(b_dot=-g.b_dot).omega == g.omega
    with pytest.raises(CatalogueError, match="no given 'beta_dot'; there are omega, b_dot"):
        g.but(beta_dot=1.0)
    p = problem("4/2")
    assert p.base({n: Dimension(0, 1, 0) for n in p.units}).d == Dimension(0, 1, 0)


def test_formulas_contain_exactly_the_symbols_of_the_text():
    found = problem("4/42").formulas()["a_C"]
    free = {str(s) for x in found for s in sympy.sympify(x).free_symbols}
    assert free == {"omega_1", "omega_2", "omega_3", "r"}


LACKING = {"beta_1": 120, "b": 8, "L": 16}


@pytest.mark.parametrize(("ask", "message"), [
    (lambda: problem("4/99"), "there is no problem 4/99; ch04 has 4/1 to 4/43"),
    (lambda: problem("99/1"), "there is no problem 99/1: the chapters with problems are .*ch04"),
    (lambda: problem("4.16"), "'4.16' is not a problem number; write chapter and problem, as in 4/16"),
    (lambda: problem("C/1"), "'C/1' is not a problem number"),
    (lambda: problem("4/"), "'4/' is not a problem number"),
    (lambda: problems("ch99"), r"there is no chapter 'ch99'; there are .*ch04"),
    (lambda: problem("4/16").base(LACKING), "problem 4/16 needs omega, b_dot"),
    (lambda: problem("4/16").base({**problem("4/16").book_values, "speed": 1}),
     "problem 4/16 has no speed; it has omega, b_dot, beta_1, b, L"),
    (lambda: problem("4/16").answer("a_C"), "problem 4/16 asks for alpha_CD, v_D, a_D, not for 'a_C'"),
])  # fmt: skip
def test_what_is_not_there_is_named_with_what_is(ask, message):
    with pytest.raises(CatalogueError, match=message):
        ask()


def test_select_takes_numbers_chapters_and_all_and_each_problem_once():
    assert [p.id for p in select(["4/2", "4/1", "4/2"])] == ["4/2", "4/1"]
    assert select(["ch04"]) == list(problems("ch04"))
    assert select(["all"]) == [p for name in chapters() for p in problems(name)]
    assert select([]) == []


def changed(right, wrong):
    assert ENTRY.count(right) == 1
    return ENTRY.replace(right, wrong)


def refused(ask, name):
    """The sentence with which ``ask(name)`` is refused."""
    with pytest.raises(CatalogueError) as caught:
        ask(name)
    return str(caught.value)


@pytest.mark.parametrize(("right", "wrong", "message"), SLIPS)
def test_what_does_not_fit_is_refused_with_its_file(write, right, wrong, message):
    write("p01.yaml", changed(right, wrong))
    assert refused(problem, "77/1").startswith(f"ch77/p01.yaml: {message}")


@pytest.mark.parametrize(
    "value", ["3", "2.5", "true", "a word", "[1, 2]", "{a: 1}", "", "2020-01-02", "[[1], {}]"]
)
@pytest.mark.parametrize("line", range(1, len(ENTRY.splitlines())))
def test_whatever_is_under_a_key_is_read_or_refused_in_words(write, line, value):
    lines = ENTRY.splitlines()
    lines[line] = f"{lines[line].partition(':')[0]}: {value}"
    write("p01.yaml", "\n".join(lines))
    try:
        message = f"read {problem('77/1').id}"
    except CatalogueError as error:
        message = str(error)
    assert re.match(r"read 77/1$|ch77/p01.yaml: .* (must be|has|needs|is not|belongs)", message)


@pytest.mark.parametrize("text", ["", "- " + ENTRY.strip().replace("\n", "\n  "), "a wheel"])
def test_a_file_that_holds_no_problem_is_reported(write, text):
    write("p01.yaml", text)
    assert refused(problem, "77/1").startswith(
        "ch77/p01.yaml: a problem must be written as key: value, not "
    )


def test_numbers_and_weights_of_a_file_are_read(write):
    text = changed("value: 2", "value: 1e-3").replace("[1, 3]", "[1.0e-4, 2e3]")
    write("p01.yaml", text.replace("means: speed", "means: speed, atol: 1e-9"))
    r, v = problem("77/1").givens["r"], problem("77/1").answer("v")
    assert (r.value, r.vary, v.atol) == (1e-3, (1e-4, 2e3), 1e-9)
    write("p01.yaml", ENTRY)
    assert problem("77/1").answer("v").weight == 1
    write("p01.yaml", changed("means: speed", "means: speed, weight: 2.5"))
    assert problem("77/1").answer("v").weight == 2.5


BROKEN_YAML = (
    "ch77/p01.yaml is not YAML: while scanning a quoted scalar in line 4, column 10 .*"
    "; a text with a colon, a # or quotation marks must be quoted"
)


@pytest.mark.parametrize(("text", "message"), [
    (changed('"4.8"', '"4.8'), BROKEN_YAML),
    (changed("doubles it", "doubles it, once: does it, twice: doubles it too"),
     "ch77/p01.yaml is not YAML: the key twice occurs twice in line 11, column 12;.*"),
    (changed("title: A wheel", "title: Une roue qui s'arrête").encode("latin-1"),
     "ch77/p01.yaml is not in UTF-8: line 3 has the byte 0xea; save the file as UTF-8"),
], ids=["broken", "key twice", "encoding"])  # fmt: skip
def test_what_cannot_be_read_is_refused_with_file_and_line(write, text, message):
    write("p01.yaml", text)
    assert re.fullmatch(message, refused(problem, "77/1"), re.DOTALL)


def test_the_same_problem_twice_is_reported(write):
    write("p01.yaml", ENTRY)
    write("p02.yaml", ENTRY)
    assert refused(problems, "ch77") == (
        "ch77/p02.yaml: the id 77/1 is also that of ch77/p01.yaml; give one of them the id that "
        "its name says, or delete it"
    )
    assert problem("77/1").id == "77/1"


NO_NUMBER = "is not named like a problem: rename it as in p01.yaml, or move it out of the folder"
DIGITS = ": the id 77/1 belongs in ch77/p01.yaml; rename this file, or correct the id"


@pytest.mark.parametrize(
    ("name", "message"),
    [(name, DIGITS) for name in ("p1.yaml", "p001.yaml")]
    + [(name, f" {NO_NUMBER}") for name in ("problems.yaml", "16.yaml", "p02.yml", "p2 copy.yaml")],
)
def test_a_file_that_is_not_named_after_its_problem_is_refused(write, name, message):
    if message != DIGITS:
        write("p01.yaml", ENTRY)
    write(name, ENTRY)
    assert refused(problems, "ch77") == f"ch77/{name}{message}"


def test_a_chapter_without_its_file_or_its_title_is_reported(write):
    write("p01.yaml", ENTRY)
    assert refused(chapter, "ch77").startswith(
        "ch77/chapter.yaml is missing; write it with the title of the chapter, as in title: "
    )
    write("chapter.yaml", "titel: Wheels")
    assert refused(chapter, "ch77") == (
        "ch77/chapter.yaml: a chapter has the unknown key 'titel'; its keys are title and optionally "
        "preamble; did you mean title?"
    )


def test_a_chapter_has_a_title_and_its_problems_in_the_order_of_their_numbers(write):
    write("chapter.yaml", "title: Wheels\npreamble: >\n  All wheels\n  are round.\n")
    assert chapter("ch77") == model.Chapter("ch77", "Wheels", "All wheels are round.")
    for n in (12, 2, 100):
        write(f"p{n:02d}.yaml", changed('"77/1"', f'"77/{n}"'))
    write(".#p02.yaml", "")
    assert [p.id for p in problems("ch77")] == ["77/2", "77/12", "77/100"]


def test_code_that_is_missing_or_does_not_fit_is_reported(write, monkeypatch):
    write("p01.yaml", ENTRY)
    message = "problem 77/1 has a text but no code: write exercises/ch77/p01.py"
    assert refused(lambda name: problem(name).code, "77/1") == message
    write("p01.yaml", ENTRY)
    half = SimpleNamespace(solve=print, draw=print)
    monkeypatch.setattr(model.importlib, "import_module", lambda name: half)
    with pytest.raises(CatalogueError, match=r"ch77/p01.py does not define prove, mistakes"):
        problem("77/1").code.solve(None)
    write("p01.yaml", ENTRY)
    code = SimpleNamespace(solve=lambda g: {"speed": g.r}, prove=print, mistakes=print, draw=print)
    monkeypatch.setattr(model.importlib, "import_module", lambda name: code)
    with pytest.raises(CatalogueError, match="solve of 77/1 returns speed; the problem asks for v"):
        problem("77/1").solve({"r": 2.0, "h": 1.0})

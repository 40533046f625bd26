"""How the quantities of problems are printed: one symbol each, the same in statement and figure."""

import re
from collections import Counter

import pytest
import yaml
from matplotlib.figure import Figure

from exercises.catalogue import CatalogueError, problem, select
from exercises.catalogue.format import read_problem
from grader.assignment.figures import drawing_values
from grader.assignment.notebook import statement
from newton_euler.answers.notation import is_word
from newton_euler.drawing.page.recorder import sketches_on
from tests.by_chapter import by_chapter
from tests.grader.courses import REPOSITORY


@by_chapter
def test_no_given_is_printed_as_a_word_and_no_two_alike(p):
    """ "The lead lead", and a rate of beta that is printed as that of a length b."""
    quantities = p.givens | p.symbols
    assert [n for n, q in quantities.items() if is_word(n) and not q.latex] == []
    assert [n for n, k in Counter(p.notation[n] for n in quantities).items() if k > 1] == []


@by_chapter
def test_a_dot_stands_over_a_letter_that_the_problem_has(p):
    """b_dot is the rate of beta in a problem that speaks of beta."""
    for name in p.givens | p.symbols:
        if dotted := re.match(r"\|?\\d?dot\{?(\\?[A-Za-z]+)", p.notation[name]):
            letter = dotted[1].lstrip("\\")
            assert re.search(rf"(?<![A-Za-z]){letter}(?![A-Za-z])", f"{p.text} {p.frame}") or any(
                re.match(rf"{letter}(_|$)", n) for n in p.notation
            )


@by_chapter
def test_a_statement_writes_out_no_greek_letter_and_no_power(p):
    text = re.sub(r"\$[^$]*\$|`[^`]*`|!\[.*\]\(.*\)|\]\(\S+\)", " ", statement(p, p.book_values))
    assert re.findall(r"\b(?:alpha|beta|gamma|theta|phi|psi|[oO]mega)\w*|\w+[_^*]\w+|\{\w+\}",
                      text) == []  # fmt: skip


def labels(p):
    axes = Figure(figsize=(5.2, 4.0), dpi=100).add_axes((0, 0, 1, 1))
    p.code.draw(p.base(drawing_values(p, p.book_values)), axes)
    for sketch in sketches_on(axes):
        sketch.finish()
    return {t.get_text() for t in axes.texts if t.get_text()}


AXES = {"x", "y", "z", "v"}  # and a velocity that the text names in words


def plain(latex):
    """A symbol without braces and spaces: \\dot{\\beta} is \\dot\\beta."""
    return re.sub(r"[{}\s]", "", latex)


@pytest.mark.one_in(4)
@pytest.mark.parametrize(
    "p", [p for p in select(["all"]) if hasattr(p.code, "draw")], ids=lambda p: p.id
)
def test_figures_print_the_symbols_of_the_statement(p):
    stated = {plain(x) for x in p.notation.values()}
    text = f"{p.text} {p.figure} {p.frame}"
    printed = labels(p)
    for label in printed:
        for math in re.findall(r"\$([^$]+)\$", label):
            letters = re.findall(r"[A-Za-z]+", re.sub(r"\\(d?dot|mathbf|text)\b", "", math))
            assert plain(math) in stated or all(
                x in AXES or re.search(rf"(?<![A-Za-z]){x}(?![A-Za-z])", text) for x in letters
            ), (label, stated)
    for name, q in (p.givens | p.symbols).items():
        assert not q.latex or name not in printed, f"the figure has {name}, not {q.latex}"


def test_a_symbol_is_written_once_beside_the_name():
    p = problem("4/16")
    assert p.notation["b_dot"] == r"\dot\beta"
    text = statement(p, p.book_values)
    assert r"$\dot\beta = 0.45\ \text{rad/s}$ (`b_dot`)" in text
    assert text.count("`b_dot`") == 1


@pytest.mark.parametrize("symbol", ["$b$", r"\dot{b", "b = 3"])
def test_a_symbol_that_cannot_be_printed_is_refused(symbol):
    path = REPOSITORY / "exercises/ch04/p16.yaml"
    entry = yaml.safe_load(path.read_text())
    entry["givens"]["b"]["symbol"] = symbol
    with pytest.raises(CatalogueError, match="b: symbol must be the LaTeX of one symbol without"):
        read_problem(entry, path)

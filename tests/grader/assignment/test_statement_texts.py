"""What a student reads in the statement of every problem: whole formulas, numbers where they are
promised, nothing that leans on another problem.
"""

import re

import pytest

from exercises.catalogue import problem
from grader.assignment.notebook import statement, typeset
from newton_euler.answers.notation import typeset_names
from tests.by_chapter import by_chapter

FORMULA = r"\$[^$]*\$"


def printed(p):
    return statement(p, p.book_values)


def texts(p):
    return [p.text, p.figure, p.frame, *p.mistakes.values(), *(a.means for a in p.answers)]


@by_chapter
def test_no_formula_is_half_typeset(p):
    """As in "$I_x$' of", "$I_{yy}$/2", "k = $i x j$" and "($i x i$) x j"."""
    text = re.sub(r"`[^`]*`|!\[.*\]\(.*\)|\]\(\S+\)", " ", printed(p))
    text = re.sub(FORMULA, "§", text)
    assert re.findall(r"§['/*^]|[/*^]§|§ [-+=<>x/] |\s[-+=<>/] §|\) x \b|(?<!\w)[-+]§", text) == []
    assert re.findall(r"\b[A-Za-z]\d\b(?! = )", re.sub(r"\b[A-Z]\d\b", " ", text)) == []


@by_chapter
def test_no_number_is_inside_a_sum_or_a_chain(p):
    """ "to h_b + h_w = 3.5 in" says that the sum is 3.5 in, "g = g = 32.2" says nothing."""
    for formula in re.findall(FORMULA, printed(p)):
        left, equals, right = formula.rpartition(" = ")
        if equals and re.match(r"-?[\d.]+(?: \\times 10\^\{-?\d+\})?(\\ |\^\\circ|\$$)", right):
            assert not re.search(r" [-+<>] |/", left), formula
            sides = left.strip("$").split(" = ")
            assert len(set(sides)) == len(sides), formula


@by_chapter
def test_a_sentence_that_promises_numbers_has_them(p):
    """ "where R and d." in a problem that asks for formulas in R and d."""
    one = r"\$[^$=<>-]*\$(?: \(`\w+`\))?"
    assert re.findall(rf"\b(?:where|with) {one}(?:(?:, {one})*,? and {one})?[.;]", printed(p)) == []


@by_chapter
def test_a_text_stands_alone(p):
    output = " ".join(texts(p))
    assert re.findall(r"[Pp]roblems? (?:A|\d+)/\d+|(?:previous|preceding) problem", output) == []


@by_chapter
def test_the_alternative_text_is_what_the_catalogue_says_of_the_figure(p):
    shown = re.search(r"!\[Figure: (.*)\]\(attachment:figure.png\)", printed(p))
    output = " ".join(p.figure.split())
    assert shown[1].replace(r"\[", "[").replace(r"\]", "]") == output
    assert "{" not in output


@by_chapter
def test_only_what_has_components_speaks_of_them(p):
    if "*Components:*" in printed(p):
        assert any(a.kind.length > 2 for a in p.answers)


@by_chapter
def test_a_slanted_fraction_has_one_reading(p):
    formulas = " ".join(re.findall(FORMULA, " ".join(texts(p))))
    assert re.findall(r"/\d+ ?\\pi|/\{\w+\} ?[\\{\w]", formulas) == []


@pytest.mark.parametrize(("text", "latex"), [
    ("(i x i) x j", r"$(\mathbf{i} \times \mathbf{i}) \times \mathbf{j}$"),
    ("k = i x j", r"$\mathbf{k} = \mathbf{i} \times \mathbf{j}$"),
    ("e_b = e_t cross e_n", r"$e_b = e_t \times e_n$"),
    ("z = x cross y", r"$z = x \times y$"),
    ("theta = 90 degrees - beta", r"$\theta = 90^\circ - \beta$"),
    ("beta = pi/2, then", r"$\beta = \pi/2$, then"),
    ("I_yy - I_xx/2 alone", r"$I_{yy} - I_{xx}/2$ alone"),
    ("the radii r1 and r2", "the radii $r_1$ and $r_2$"),
    ("a pin of A and a disk", "a pin of A and a disk"),
    ("the x-y plane, 2 x 4 m", "the x-y plane, 2 x 4 m"),
])  # fmt: skip
def test_a_formula_of_names_is_one_formula(text, latex):
    assert typeset_names(text, {}) == latex


def test_a_given_that_equals_a_coordinate_is_one_formula():
    p = problem("5/3")
    assert "through $x = x_c = " in printed(p)
    assert typeset("the length {b}", p) == "the length {b}"

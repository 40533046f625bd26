"""Problems that give numbers and name symbols: drawn and judged over the points at which formulas
are compared, even where a formula is not real at some of them.
"""

from dataclasses import replace

import pytest
import sympy

from exercises.catalogue import Answer, CatalogueError, Given, Symbol
from exercises.catalogue.checks import check
from exercises.catalogue.format import read_problem
from exercises.catalogue.variants import apart, at_points, draw, objection
from newton_euler import sin, sqrt

HEIGHT = Answer("h", "expression", "m", "height at the time t")
DATA = {
    "givens": {"a": Given("a", 2.0, "m/s^2", "acceleration", (1.0, 3.0))},
    "symbols": {"t": Symbol("t", "s", (0.6, 1.9))},
    "answers": (HEIGHT,),
    "mistakes": {"no_half": "leaves out the factor 1/2"},
}


@pytest.fixture
def falling(made):
    """A function that makes a problem of this code."""
    return lambda solve, wrong, **data: made(solve, wrong=wrong, **{**DATA, **data})


def solve(g):
    return {"h": g.a * g.t**2 / 2}


def no_half(g):
    return {"no_half": {"h": g.a * g.t**2}}


def test_givens_are_drawn_beside_symbols(falling):
    p = falling(solve, no_half)
    drawn = {draw(p, bytes([n]))["a"] for n in range(20)}
    assert len(drawn) > 5
    assert all(1 <= a <= 3 for a in drawn)
    assert check(p, seeds=5) == []


def test_a_mistake_is_judged_over_all_points_and_caught_where_it_is_near_at_most(falling):
    """t^2 for t is right at t = 1, and 2 % off close to it."""
    p = falling(
        lambda g: {"h": g.a * g.t * g.s},
        lambda g: {"no_half": {"h": g.a * g.t**2}},
        symbols={n: Symbol(n, "s", (0.9, 1.3)) for n in "ts"},
    )
    assert check(p, seeds=20) == []
    assert objection(p, p.book_values) is None
    p = falling(solve, lambda g: {"no_half": {"h": 1.01 * g.a * g.t**2 / 2}})
    (fault,) = check(p)
    assert fault.startswith("the mistake no_half gives nearly the right h")
    assert "write same_in_book: true" in fault
    with pytest.raises(CatalogueError, match=r"no good numbers .* hides the mistake no_half"):
        draw(p, b"any")


def test_points_where_mistake_or_key_are_not_real_count_for_nothing(falling):
    p = falling(
        solve,
        lambda g: {"no_half": {"h": g.a * sqrt(g.t**2 - g.s**2) * g.s}},
        symbols={n: Symbol(n, "s", (0.6, 1.9)) for n in "ts"},
    )
    wrong = [x for (x,) in at_points(p, p.book_values)[1]["no_half"]["h"]]
    assert 0 < sum(x != x for x in wrong) < len(wrong)
    assert check(p, seeds=4) == []
    draw(p, b"any")
    p = falling(
        lambda g: {"h": g.a * g.s * sqrt(g.t**2 - g.s**2)},
        lambda g: {},
        symbols={"t": Symbol("t", "s", (0.6, 1.9)), "s": Symbol("s", "s", (0.6, 1.5))},
    )
    assert check(replace_mistakes(p), seeds=6) == []
    p = replace_mistakes(falling(lambda g: {"h": g.a * g.t * sqrt(-(g.t**2))}, lambda g: {}))
    (fault,) = check(p)
    assert fault.startswith("solve and prove are nowhere both real; tried a = 2, t = ")


def replace_mistakes(p):
    """The same problem and code without mistakes."""
    q = replace(p, mistakes={})
    vars(q)["code"] = p.code
    return q


def test_answers_are_apart_if_half_of_their_real_points_are():
    nan, right = float("nan"), ((1.0,),) * 4
    assert apart(((2.0,), (2.0,), (1.0,), (1.0,)), right)
    assert not apart(((2.0,), (1.0,), (1.0,), (1.0,)), right)
    assert apart(((nan,), (nan,), (2.0,), (1.0,)), right)
    assert apart(((nan,),) * 4, right)


def at_thirty(falling, same):
    """The sine of 30 degrees is a half, so the book's numbers do not tell the two apart."""
    length = Given("L", 2.0, "m", "length", (1.0, 3.0))
    slope = Given("beta", 30, "deg", "slope", (20, 70))
    return falling(
        lambda g: {"h": g.L * sin(g.beta)}, lambda g: {"no_half": {"h": g.L / 2}},
        givens={"L": length, "beta": slope}, symbols={},
        answers=(replace(HEIGHT, kind="number"),), same_in_book=frozenset(same),
    )  # fmt: skip


def test_a_mistake_may_be_exempt_at_the_numbers_of_the_book(falling):
    assert "gives nearly the right h" in check(at_thirty(falling, []), seeds=3)[0]
    p = at_thirty(falling, ["no_half"])
    assert check(p, seeds=5) == []
    assert "hides the mistake no_half" in objection(p, {**p.book_values, "beta": 30.2})


ENTRY = {
    "id": "3/1", "title": "A slope", "section": "3.2", "text": "Find h.",
    "answers": [{"key": "h", "kind": "number", "unit": "m", "means": "height"}],
}  # fmt: skip


def test_a_word_in_the_yaml_exempts_it(tmp_path):
    path = tmp_path / "ch03" / "p01.yaml"
    exempt = {"text": "takes half of L", "same_in_book": True}
    p = read_problem({**ENTRY, "mistakes": {"half": exempt, "whole": "takes L"}}, path)
    assert p.mistakes == {"half": "takes half of L", "whole": "takes L"}
    assert p.same_in_book == {"half"}
    assert p.figure == ""
    with pytest.raises(CatalogueError, match="same_in_book must be true or false, not 'book'"):
        read_problem({**ENTRY, "mistakes": {"x": {**exempt, "same_in_book": "book"}}}, path)
    with pytest.raises(CatalogueError, match="the mistake x has the unknown key 'exempt'"):
        read_problem({**ENTRY, "mistakes": {"x": {"text": "", "exempt": True}}}, path)


def test_formulas_have_the_numbers_of_the_book_exactly(falling):
    p = falling(solve, no_half, givens={"a": Given("a", 1.5, "m/s^2", "acceleration", (1.0, 3.0))})
    assert p.formulas()["h"] == sympy.Rational(3, 4) * p.sympy_symbols()["t"] ** 2

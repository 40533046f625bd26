"""Sums with named terms: no term is lost through its name; amounts compare like their values."""

import pickle
from operator import eq, ge, gt, le, lt, ne

import numpy as np
import pytest
import sympy
from hypothesis import given
from hypothesis import strategies as st

from newton_euler import Frame, Inertia
from newton_euler.algebra.ledger import (
    Amount,
    TermError,
    Terms,
    distinct,
    latex_number,
    latex_text,
    summed,
)
from newton_euler.algebra.vectors import named_sum
from tests.kinds import close, numbers
from tests.named_sums import NAMES, check_terms

ground = Frame("ground")

named = st.lists(st.tuples(NAMES, st.integers(-9, 9)), max_size=7)


def total(pairs):
    return sum(x for _, x in pairs)


def along_x(pairs):
    """The sum of named forces along x, from pairs (name, size)."""
    forces = [(name, ground.vector(float(x), 0, 0)) for name, x in pairs]
    return named_sum("resultant", "", forces, ground)


@given(named)
def test_no_term_is_lost_whatever_its_name_is(pairs):
    U, F, names = summed(pairs), along_x(pairs), [name for name, _ in pairs]
    check_terms(U, [np.array(float(x)) for _, x in pairs], names)
    check_terms(F, [np.array([x, 0.0, 0.0]) for _, x in pairs], names)
    assert F.explain().latex.count("&&") == len(pairs) + 1
    named = latex_text("rod_1 & rope #2, 50 %")
    assert named == r"\text{rod\_1 \& rope \#2, 50 \%}"


@given(named)
def test_each_term_can_be_asked_for_and_left_out_by_its_distinct_name(pairs):
    U = summed(pairs)
    for (_, x), name in zip(pairs, U.terms, strict=True):
        assert U.terms[name] == x
        assert U.without(name) == total(pairs) - x
    assert U.without(*U.terms) == 0


@given(named)
def test_changed_and_pickled_terms_keep_the_names_that_were_given(pairs):
    F = along_x(pairs)
    turned = F.expressed_in(ground.rotate("turned", "z", 0.5))
    for same in (F, -2 * turned / -2, pickle.loads(pickle.dumps(turned))):
        assert list(same.terms) == list(F.terms)
        for name in {name for name, _ in pairs}:
            assert close(same.without(name).norm(), F.without(name).norm(), 1e-13)
    U = summed(pairs)
    for name in {name for name, _ in pairs}:
        assert summed(U.terms).without(name) == U.without(name)


@given(st.lists(NAMES))
def test_distinct_names_differ_and_a_name_given_once_stays(names):
    found = distinct(names)
    assert len(set(found)) == len(found) == len(names)
    for old, new in zip(names, found, strict=True):
        assert (new == old) is (names.count(old) == 1)
        assert new.startswith(old)


def test_a_name_that_several_terms_have_is_refused_with_their_distinct_names():
    terms = Terms([("arm", 1.0), ("rod", 2.0), ("arm", 3.0)])
    with pytest.raises(TermError, match=r"2 terms are named 'arm'; ask for one of \['arm 1', 'ar"):
        terms["arm"]
    with pytest.raises(TermError, match="no term 'leg'; the terms are arm 1, rod, arm 2"):
        terms["leg"]
    with pytest.raises(TermError, match="2 terms are named 'arm'"):
        terms.get("arm")
    assert "arm" not in terms
    assert (terms.get("rod"), terms.get("leg", 0)) == (2.0, 0)


def test_terms_of_one_name_are_kept_and_weighted_apart():
    terms = Terms([("arm", 1.0), ("arm", 2.0)])
    for both in (terms | {"arm": 4.0}, {"arm": 4.0} | terms):
        assert sorted(both.values()) == [1.0, 2.0, 4.0]
    terms |= {"arm 1": 4.0}
    terms |= {"arm 1": 8.0}
    updated = terms.copy()
    updated.update(terms)
    assert sum(updated.values()) == 2 * sum(terms.values())
    assert (terms.copy().shared, len(updated)) == (terms.shared, 2 * len(terms))
    assert sum(terms.values()) == 15.0
    assert summed(Terms([("arm", 1.0), ("arm", 2.0)]) | {"rod": 4.0}).without("arm") == 4.0
    U = summed([("arm", 1.0), ("arm", 10.0)])
    assert U.reweighted(arm=2) == 22.0
    assert U.reweighted(arm=2, **{"arm 1": 3}) == 23.0


def test_what_is_no_sum_stays_as_it_is_without_no_term():
    v, U = ground.vector(1.0, 2.0, 3.0), Amount(3.0)
    I = Inertia(ground, (2.0, 3.0, 4.0))
    assert (v.without().c, U.without(), I.without().moments) == (v.c, 3.0, I.moments)


def test_amounts_and_vectors_are_explained_in_units_of_their_own():
    assert summed([("a", 2.0)], "power").explain().endswith("2 W")
    assert Amount(2.0).explain("ft*lb").endswith("2 ft*lb")
    with pytest.raises(TermError, match="this is the work, in J: it cannot be explained in 'W'"):
        Amount(2.0).explain("W")
    arm = ground.rotate("arm", "z", rate=2.0)
    v = arm.point("P", 1.0, 0, 0).velocity(ground)
    assert "m/s" in str(v.explain("m/s"))
    with pytest.raises(TermError, match="in m/s: it cannot be explained in 'N'"):
        v.explain("N")
    for p in (2.0 * v, (2.0 * v).expressed_in(ground)):  # of a mass of 2 kg: in kg*m/s
        assert "N*s" in str(p.explain("N*s"))
    assert "m/s" in str(arm.i.rate(ground).explain("m/s"))  # a rate of any vector has no unit


def test_what_a_sum_takes_away_is_printed_as_minus_below_names_of_one_width():
    terms = {"inertia": ground.vector(1.0, 0, 0), "weight": ground.vector(0, 2.0, 0)}
    rows = str(named_sum("reaction", "B", terms, ground).explain()).splitlines()[1:]
    assert [row.partition("[")[0] for row in rows] == [
        "  inertia  m a      ", "  minus weight  -F  ", "  sum               "
    ]  # fmt: skip


def test_a_term_called_sum_is_not_taken_for_the_sum():
    rows = summed({"sum": 1.0, "sum of all": 2.0}).explain().splitlines()[1:]
    assert [" ".join(r.split()) for r in rows] == [
        "sum 1 J", "sum of all 2 J", "sum of all of all 3 J"
    ]  # fmt: skip
    arm = ground.rotate("sum", "z", rate=2.0)
    explained = arm.angular_velocity(ground).explain()
    assert [r.split("  ")[1] for r in str(explained).splitlines()[1:]] == ["sum", "sum of all"]
    assert r"&& \text{sum of all}" in explained.latex


@pytest.mark.parametrize(("x", "latex"), [
    (0.5, "0.5"), (-1.25e-7, r"-1.25\times10^{-7}"), (sympy.Symbol("x"), "x"),
    (sympy.Symbol("alpha"), r"\alpha"), (sympy.Symbol("x") + 1, r"\left(x + 1\right)"),
])  # fmt: skip
def test_a_component_in_latex_has_brackets_where_it_is_more_than_a_name(x, latex):
    assert latex_number(x, 5) == latex


def test_amounts_add_and_subtract_as_numbers_do():
    T, V = Amount(5.0), Amount(2.0)
    assert (T + V, T + 1, 1 + T, T - V, T - 1, 1 - T, 2 * T, T / V, -T) == (
        7.0, 6.0, 6.0, 3.0, 4.0, -4.0, 10.0, 2.5, -5.0
    )  # fmt: skip


@pytest.mark.parametrize("kind", ["float", "mpmath", "sympy"])
def test_an_amount_compares_as_its_value_does(kind):
    two, five = numbers(kind, 2, 5)
    T, V = summed({"translation": five, "rotation": two}), Amount(two)
    for holds, operation, a, b in (
        (True, eq, T, two + five), (False, ne, T, 7), (False, eq, T, V), (True, eq, V, Amount(two)),
        (True, gt, T, V), (True, lt, V, 5), (True, ge, T, 7), (True, le, 7, T), (False, lt, T, two),
    ):  # fmt: skip
        assert bool(operation(a, b)) is holds
    many = Amount(np.array([1.0, 3.0]))
    assert (many > 2.0).tolist() == (np.array([2.0, 2.0]) < many).tolist() == [False, True]
    assert (Amount(3.0) == many).tolist() == [False, True]
    assert not eq(Amount(3.0), "3.0")  # equal to nothing but numbers and amounts
    assert eq(Amount(0), 0.0)
    with pytest.raises(TypeError):
        lt(Amount(3.0), "4")

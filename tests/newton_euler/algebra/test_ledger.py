"""Sums with named terms: amounts compare as their values do."""

from operator import eq, ge, gt, le, lt, ne

import numpy as np
import pytest

from newton_euler.algebra.ledger import Amount, summed
from tests.kinds import numbers


@pytest.mark.parametrize("kind", ["float", "mpmath", "sympy"])
def test_an_amount_compares_as_its_value_does(kind):
    two, five = numbers(kind, 2, 5)
    T, V = summed({"translation": five, "rotation": two}), Amount(two)
    for holds, operation, a, b in (
        (True, eq, T, two + five), (False, ne, T, 7), (False, eq, T, V), (True, eq, V, Amount(two)),
        (True, gt, T, V), (True, lt, V, 5), (True, ge, T, 7), (True, le, 7, T), (False, lt, T, two),
    ):  # fmt: skip
        assert bool(operation(a, b)) is holds


def test_amounts_of_many_instants_compare_instant_by_instant():
    U = Amount(np.array([1.0, 3.0]))
    assert (U > 2.0).tolist() == [False, True]
    assert (np.array([2.0, 2.0]) < U).tolist() == [False, True]
    assert (Amount(3.0) == U).tolist() == [False, True]


def test_an_amount_equals_nothing_but_numbers_and_amounts():
    assert not eq(Amount(3.0), "3.0")
    assert eq(Amount(0), 0.0)
    with pytest.raises(TypeError):
        lt(Amount(3.0), "4")

"""Dimensions are compared within ``where``, and nowhere else."""

import pytest

from newton_euler import Dimension, where
from newton_euler.algebra.units import DimensionError

LENGTH, TIME = Dimension(0, 1, 0), Dimension(0, 0, 1)


def test_a_choice_between_like_quantities_has_their_dimension():
    assert where(LENGTH > 2 * LENGTH, LENGTH, 3 * LENGTH) == LENGTH
    assert where(LENGTH > 0, TIME, 0) == TIME
    assert where(LENGTH >= 0, 0, TIME) == TIME
    assert where(Dimension() < 1.5, 1.0, 2.0) == 1.0


def test_a_choice_of_words_is_one_of_them():
    assert where(LENGTH < LENGTH, "rises", "falls") in ("rises", "falls")


def test_unlike_quantities_are_not_compared():
    with pytest.raises(DimensionError, match=r"cannot compare Dimension\(L\^1\) with Dimension\(T"):
        where(LENGTH > TIME, LENGTH, LENGTH)
    with pytest.raises(DimensionError, match=r"cannot compare .* with 1\.0"):
        where(LENGTH > 1.0, LENGTH, LENGTH)


def test_a_choice_between_unlike_quantities_is_refused():
    with pytest.raises(DimensionError, match="cannot add"):
        where(LENGTH > 0, LENGTH, TIME)


def test_a_branch_on_dimensions_is_told_to_use_where():
    with pytest.raises(DimensionError, match=r"choose by where\(x < y, a, b\), or in a function"):
        max(LENGTH, 2 * LENGTH)

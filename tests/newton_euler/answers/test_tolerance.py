"""How near to the key an answer must be: numbers, vectors, intervals, matrices, formulas."""

import math

import pytest

from newton_euler.answers.fit import CLOSE, EXACT, Fit
from newton_euler.answers.forms import Form
from newton_euler.answers.kinds import KINDS
from newton_euler.answers.tolerance import distance, formula_is_near, is_apart
from newton_euler.answers.trees import TreeError

NINE = tuple(map(float, range(1, 10)))


def verdict(kind, tree, right, atol=1e-6):
    """The verdict on a tree for an answer whose key is ``right``."""
    try:
        (given,) = KINDS[kind].readings(tree, Form(KINDS[kind]), {}, [100])
    except TreeError:
        return "unreadable"
    return "right" if KINDS[kind].is_right(given, (right,), atol) else "wrong"


@pytest.mark.parametrize("right", [2.5, -0.003, 4e7])
@pytest.mark.parametrize(
    ("off", "expected"),
    [(0.00499, "right"), (-0.00499, "right"), (0.00501, "wrong"), (-0.00501, "wrong")],
)
def test_a_number_may_be_half_a_percent_off_and_no_more(right, off, expected):
    assert verdict("number", right * (1 + off), (right,), atol=1e-9) == expected


@pytest.mark.parametrize(("off", "expected"), [(0.00499, "right"), (0.00501, "wrong")])
@pytest.mark.parametrize("direction", [(1, 0, 0), (0, 1, 0), (0, 0, 1), (0.6, 0, -0.8)])
def test_a_vector_may_be_off_by_half_a_percent_in_any_direction(off, expected, direction):
    key = (-7482.459, -7380.0, -2805.922)
    moved = [x + off * math.hypot(*key) * e for x, e in zip(key, direction, strict=True)]
    assert verdict("vector", moved, key) == expected


def test_limits_are_right_and_of_a_zero_key_the_absolute_tolerance():
    """The limits of the size that counts as zero and of components that count as round-off."""
    assert verdict("number", 0.0, (1e-3,), atol=1e-3) == "right"
    assert verdict("number", 2e-3, (1e-3,), atol=1e-3) == "right"
    assert verdict("vector", [1.5, 1000.0, 0], (1.0, 1000.0, 0.0)) == "right"
    assert verdict("number", 1005.0, (1000.0,)) == "right"
    assert formula_is_near(((2e-3,),), ((1e-3,),), 1e-3)
    assert verdict("number", 0.09, (0.0,), atol=0.1) == "right"
    assert verdict("number", 0.11, (0.0,), atol=0.1) == "wrong"
    assert verdict("number", 5.09, (5.0,), atol=0.1) == "wrong"
    assert KINDS["expression"].is_right(((0.9e-6,),), ((0.0,),), 1e-6)
    assert not KINDS["expression"].is_right(((1.1e-6,),), ((0.0,),), 1e-6)


@pytest.mark.parametrize(
    ("kind", "right", "tree", "expected"),
    [
        *(("number", (0.0,), x, "right") for x in (0, 0.9e-6, -0.9e-6, 1e-300)),
        *(("number", (0.0,), x, "wrong") for x in (1.1e-6, 1)),
        ("vector", (1000.0, 0.0, 0.0), [1000.0, 4.9, 0], "right"),  # relative to the whole vector
        ("vector", (1000.0, 0.0, 0.0), [1000.0, 5.1, 0], "wrong"),
        ("vector", (1.0, 1e-12, -1e-17), [1.0, 0, 0], "right"),  # components that are round-off
        ("vector", (1000.0, 5e-7, 0.0), [1000.0, 0, 0], "right"),
        ("vector", (1000.0, 2e-6, 0.0), [1000.0, 0, 0], "wrong"),
        ("interval", (0.1, 100.0), [0.1004, 100.4], "right"),  # each bound by itself
        ("interval", (0.1, 100.0), [0.4, 100.0], "wrong"),
        ("number", (math.inf,), 1e308, "wrong"),
        ("matrix", NINE, [1, 2, 3, 4, 5, 6, 7, 8, 9], "right"),
        ("matrix", NINE, [1, 4, 7, 2, 5, 8, 3, 6, 9], "wrong"),
        ("matrix", NINE, [1, 2, 3], "unreadable"),
        ("matrix", NINE, [[1, 2, 3], [4, 5, 6], [7, 8, 9]], "unreadable"),
    ],
)
def test_zeros_bounds_and_matrices(kind, right, tree, expected):
    assert verdict(kind, tree, right) == expected


@pytest.mark.parametrize(("n", "small"), [(0, 0.5), (1, 0.5), (1, -0.5)])
@pytest.mark.parametrize(
    ("share", "expected"), [(0.6, "right"), (0.4, "wrong"), (0, "wrong"), (-1, "wrong")]
)
def test_a_small_component_may_be_off_by_half_of_itself_and_no_more(n, small, share, expected):
    """Rounding the terms of a small difference is fine; losing it or its sign is not."""
    key = [1000.0, 1000.0]
    key[n] = small
    tree = [*key, 0]
    tree[n] *= share
    assert verdict("vector", tree, (*key, 0.0)) == expected


X = (0.4, 0.7, 1.1, 1.9)


@pytest.mark.parametrize(
    ("given", "expected"),
    [
        (lambda x: (x, x**2), True),
        (lambda x: (x, 1.0001 * x**2), False),
        (lambda x: (x, (1.01 if x == 1.9 else 1) * x**2), False),  # at one point
        (lambda x: (1.0001 * x, x**2), False),
        (lambda x: (x, 0.0), False),
        (lambda x: (x * 3.1416 / math.pi, x**2), True),
        (lambda x: (3 * 0.33333 * x, x**2), True),
        (lambda x: (x * 6.283 / (2 * math.pi), x**2), True),
        (lambda x: (x * 0.866 / math.sqrt(0.75), x**2), True),
        (lambda x: (x * 3.142 / math.pi, x**2), False),
        (lambda x: (x, x**2 + 1e-12), True),
        (lambda x: (x, math.nan), False),
        (lambda x: (math.inf, x**2), False),
    ],
)
def test_each_component_of_a_formula_counts_by_itself(given, expected):
    right = tuple((x, x**2) for x in X)
    assert KINDS["vector_expression"].is_right(tuple(map(given, X)), right, 1e-6) == expected


def test_small_components_are_seen_and_points_without_a_value_left_out():
    right, wrong = (tuple((1000.0 * x, f * x) for x in X) for f in (1.0, 1.0001))
    assert not KINDS["vector_expression"].is_right(wrong, right, 1e-6)
    right = ((math.nan,), (1.0,), (math.inf,))
    assert KINDS["expression"].is_right(((2.0,), (1.0,), (3.0,)), right, 1e-6)
    assert not KINDS["expression"].is_right(((1.0,),), ((math.nan,),), 1e-6)


def test_a_right_component_of_few_digits_does_not_make_the_others_coarse():
    """3.3 counts as 3.3000; one of two models of the last component agrees to the digits given."""
    fit = Fit(((4.0825, 3.3, 1.3519),), ((4.08251, 3.3, 1.9),), 0.01)
    assert fit(((4.08251, 3.3, 1.35188),)) == CLOSE
    assert fit(((4.08251, 3.3, 1.3819),)) == 0


@pytest.mark.parametrize(("off", "level"), [(0.9e-6, EXACT), (1.1e-6, CLOSE)])
def test_a_model_is_exact_to_a_millionth(off, level):
    assert Fit(((2.0,),), ((1.0,),), 0.01)(((2.0 * (1 + off),),)) == level


def test_a_distance_is_relative_to_the_size_of_the_second_point():
    assert distance((2.2,), (2.0,)) == pytest.approx(0.1)
    assert distance((3.0, 4.0), (0.0, 0.0)) == 5.0


@pytest.mark.parametrize(("model", "key", "apart"), [
    (((1.021,),), ((1.0,),), True), (((1.019,),), ((1.0,),), False),
    (((51.0,),), ((50.0,),), True),
    (((1e-9,),), ((0.0,),), True),  # from zero any number is far
    (((2.0,), (1.0,)), ((1.0,), (1.0,)), True),  # at half of the points
    (((2.0,), (1.0,), (1.0,)), ((1.0,), (1.0,), (1.0,)), False),
    (((2.0,), (1.0,), (math.inf,)), ((1.0,), (math.nan,), (1.0,)), True),  # of those with a value
    ((("up",),), (("up",),), False), ((("up",),), (("down",),), True), (((1.0,),), (("up",),), True),
])  # fmt: skip
def test_a_model_is_apart_that_is_far_from_the_key_at_half_of_the_points(model, key, apart):
    assert is_apart(model, key) is apart


def test_a_formula_is_measured_by_its_mean_and_a_zero_component_by_the_others():
    key = (1.0,), (0.001,)  # near a zero of its own
    assert formula_is_near(((1.0,), (0.00101,)), key, 0.0)
    assert not formula_is_near(((1.0,), (0.00102,)), key, 0.0)
    # the absolute tolerance is not that of a zero component, but its round-off
    assert not formula_is_near(((5.0, 0.0005),), ((5.0, 0.0),), 0.001)
    assert formula_is_near(((1000.0, 5e-7),), ((1000.0, 0.0),), 0.0)
    assert not formula_is_near(((1000.0, 2e-6),), ((1000.0, 0.0),), 0.0)

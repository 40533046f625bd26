"""Which wrong model explains a wrong answer: causes are compared by identity, not by words."""

import itertools
import math
from dataclasses import replace

import numpy as np
import pytest

from newton_euler.algebra.units import Dimension
from newton_euler.answers import causes
from newton_euler.answers.by_component import of_each_component
from newton_euler.answers.diagnosis import OtherPart, OtherParts, diagnose
from newton_euler.answers.fit import EXACT, LOOSE, Fit
from newton_euler.answers.kinds import KINDS
from newton_euler.answers.slips import factors
from newton_euler.answers.tolerance import FORMULA_RTOL
from newton_euler.answers.usual import of_a_number, of_one_term, of_other_bodies, of_other_powers

KEY = ((3.0, 4.0, 0.0),)
MODEL = ((3.0, -4.0, 0.0),)
TURNS, MIRRORS = causes.listed("turns", "turns y"), causes.listed("mirrors", "mirrors it")


def test_all_models_that_give_the_same_numbers_are_named_up_to_three():
    assert diagnose(MODEL, KEY, [(TURNS, MODEL)]) == (TURNS,)
    two = diagnose(MODEL, KEY, [(TURNS, MODEL), (MIRRORS, MODEL)])
    assert two == (TURNS, MIRRORS)
    assert causes.sentence(two) == "turns y; or one that mirrors it"
    for count, named in ((3, 3), (4, 0)):
        models = [(causes.listed(f"m{n}", f"model {n}"), MODEL) for n in range(count)]
        assert len(diagnose(MODEL, KEY, models)) == named


def test_causes_are_the_same_by_group_and_name_however_they_are_worded():
    assert causes.listed("a", "once") == causes.listed("a", "reworded")
    assert causes.listed("a", "same") != causes.listed("b", "same")
    assert causes.Cause("term", "a", "same") != causes.listed("a", "same")
    twice = [(causes.listed("a", "once"), MODEL), (causes.listed("a", "reworded"), MODEL)]
    assert len(diagnose(MODEL, KEY, twice)) == 1
    assert causes.sentence(diagnose(MODEL, KEY, twice)) == "once"
    odd = causes.listed("odd", "takes x; or one that takes y")  # the separator of two
    assert diagnose(MODEL, KEY, [(odd, MODEL)]) == (odd,)
    remark = causes.right_but([1, 2], (1, 2, 3))
    assert remark.text == "its second and third components are not right; the rest is"


def test_the_model_that_fits_all_digits_is_named_and_none_that_is_near_the_key():
    near = [(MIRRORS, ((3.0, -4.01, 0.0),)), (TURNS, MODEL)]
    assert diagnose(MODEL, KEY, near) == (TURNS,)
    assert len(diagnose(((3.0, -4.0051, 0.0),), KEY, near)) == 2
    near = ((3.0, 4.06, 0.0),)
    assert diagnose(((3.0, 4.05, 0.0),), KEY, [(TURNS, near)]) == ()
    arm, rod = causes.other_axes(1, "the arm"), causes.other_axes(2, "the arm")
    assert arm != rod  # two frames of one name
    assert diagnose(MODEL, KEY, [(arm, MODEL), (rod, MODEL)]) == (arm,)


def test_a_term_with_the_numbers_of_a_listed_mistake_is_named_after_it():
    """A term left out is the exception: it is the same mistake in other words."""
    term = causes.term_reversed("y", "the term y")
    assert diagnose(MODEL, KEY, [(term, MODEL), (TURNS, MODEL)]) == (TURNS, term)
    left_out = causes.term_left_out("y", "the term y")
    assert diagnose(MODEL, KEY, [(left_out, MODEL), (TURNS, MODEL)]) == (TURNS,)
    other = ((3.0, -4.0 + 1e-7, 0.0),)
    assert diagnose(MODEL, KEY, [(term, other), (TURNS, MODEL)]) == (TURNS,)


def test_a_model_is_compared_where_it_has_a_value_and_by_the_size_of_each_component():
    key, model = ((45.76, 27.91, 0.0),), ((45.76, 5.547, 0.0),)
    assert diagnose(((45.76, 5.633, 0.0),), key, [(TURNS, model)]) == ()
    assert diagnose(((45.76, 5.57, 0.0),), key, [(TURNS, model)]) == (TURNS,)
    nothing = ((1e-16, 0.0, 0.0),)
    assert diagnose(((0.0, 0.0, 0.0),), key, [(TURNS, nothing)]) == (TURNS,)
    key, given = ((1.0,), (2.0,), (3.0,)), ((2.0,), (9.0,), (7.0,))
    formula = KINDS["expression"]
    assert diagnose(given, key, [(TURNS, ((2.0,), (math.nan,), (7.0,)))], formula) == (TURNS,)
    assert diagnose(given, key, [(TURNS, ((math.nan,),) * 3)], formula) == ()


def test_a_pair_is_named_only_if_no_other_pair_and_no_single_mistake_gives_the_same():
    key, a, b = ((1.23, 2.0, 3.0),), ((1.23, 0.0, 3.0),), ((1.23, 2.0, 0.0),)
    given = ((1.23, 0.0, 0.0),)
    A, B, C = (causes.listed(name, name.upper()) for name in "abc")
    found = diagnose(given, key, [(A, a), (B, b)])
    assert found == (causes.both(A, B),)
    assert causes.sentence(found) == "A, and also B: both count"
    twin = [(A, a), (B, b), (causes.listed("a too", "A too"), a)]
    assert diagnose(given, key, twin) == ()
    assert diagnose(given, key, [*twin, (C, given)]) == (C,)


def test_what_is_listed_is_named_beside_others_with_the_same_numbers_however_many():
    """This includes a vector with round-off in place of zero."""
    contradicted = OtherParts(lambda: [part(True, KEY, [(TURNS, MODEL)])])
    general = [(causes.answer_to(name), MODEL) for name in "abc"]
    found = diagnose(MODEL, KEY, [*general, (TURNS, MODEL)], elsewhere=contradicted)
    assert TURNS in found
    assert len(found) == 3
    nothing = [(causes.term_left_out("y", "y"), ((0.0, 0.0, 0.0),)), (TURNS, ((1e-16, 0.0, 0.0),))]
    elsewhere = OtherParts(lambda: [part(True, KEY, [(TURNS, MODEL)])])
    assert TURNS in diagnose(((0.0, 0.0, 0.0),), KEY, nothing, elsewhere=elsewhere)


VECTORS = KINDS["vector_expression"]
INERTIA = ((4.0, -1.0, 0.5, -1.0, 5.0, 2.0, 0.5, 2.0, 6.0),)
TURN = ((0.8, -0.6, 0.0, 0.6, 0.8, 0.0, 0.0, 0.0, 1.0),)


@pytest.mark.parametrize(("kind", "given", "key", "cause"), [
    ("matrix", ((0.8, 0.6, 0.0, -0.6, 0.8, 0.0, 0.0, 0.0, 1.0),), TURN, causes.TRANSPOSED),
    ("matrix", ((4, 1, -0.5, 1, 5, -2, -0.5, -2, 6),), INERTIA, causes.OFF_DIAGONAL),
    ("matrix", ((4, -1, 0, -1, 5, 2, 0, 2, 6),), INERTIA, causes.entry_left_out(0, 2)),
    ("matrix", ((7.5, -1, 0.5, -1, 7.5, 2, 0.5, 2, 7.5),), INERTIA, causes.POLAR),
    ("matrix", ((3.5, -1, 0.5, -1, 2.5, 2, 0.5, 2, 1.5),), INERTIA, causes.PLANAR),
    ("matrix", ((4, -1, 0.5, -1, 5, -2, 0.5, -2, 6),), INERTIA, causes.entry_reversed(1, 2)),
    ("matrix", ((4, -1, 0.5, -1, 6, 2, 0.5, 2, 5),), INERTIA,
     causes.exchanged_entries((1, 1), (2, 2))),
    ("matrix", ((4, 0.5, -1, 0.5, 5, 2, -1, 2, 6),), INERTIA,
     causes.exchanged_entries((1, 0), (2, 0))),
    ("matrix", ((4, 0, 0, 0, 5, 0, 0, 0, 6),), INERTIA, causes.DIAGONAL_ONLY),
    ("matrix", ((4, -1, 0.5, -1, 5, 2, 0.5, 2, 0),), INERTIA, causes.entry_left_out(2, 2)),
    ("number", ((79.13,),), ((7.913,),), causes.multiplied("one decimal place", 10.0, True)),
    ("interval", ((3.0, 1.0),), ((1.0, 3.0),), causes.BOUNDS),
    ("number", ((62.41,),), ((7.9,),), causes.SQUARED),
    ("number", ((2.811,),), ((7.9,),), causes.ROOT),
    ("number", ((0.1266,),), ((7.9,),), causes.INVERTED),
    ("vector", ((7.9, 0.0, 0.0),), ((7.9, 2.0, 3.0),), causes.left_out_components([1, 2])),
])  # fmt: skip
def test_slips_that_need_no_list_are_named_by_kind(kind, given, key, cause):
    assert cause in diagnose(given, key, [], KINDS[kind], slips=lambda *_: ())


@pytest.mark.parametrize(
    ("kind", "key", "models", "groups"),
    [
        ("vector", ((6.0, -8.0, 0.0),), [], ["factor", "computed"]),
        ("vector_expression", ((9.0, 9.0, 0.0),), [(causes.BOOK, MODEL)], ["book", "computed"]),
        ("vector", ((9.0, 9.0, 0.0),), [(causes.BOOK, MODEL)], ["book"]),
        ("vector", ((6.0, -8.0, 0.0),), [(TURNS, MODEL)], ["listed"]),
    ],
)
def test_a_factor_and_a_formula_of_the_book_do_not_hide_a_slip(kind, key, models, groups):
    near = lambda *_: [(1, causes.computed("half", "leaves out the hole"), MODEL)]
    two = {"a factor of 2": 2.0}
    found = diagnose(MODEL, key, models, KINDS[kind], two, slips=near)
    assert [c.group for c in found] == groups


@pytest.mark.parametrize(
    ("unit", "there", "absent"),
    [
        ("mm/s", "m against mm", "weight against mass (g = 9.81)"),
        ("rad/s", "revolutions against radians", "m against mm"),
        ("N", "weight against mass (g = 9.81)", None),
        ("lb", "N against lb", None),
    ],
)
def test_factors_are_those_of_the_unit_of_the_answer(unit, there, absent):
    assert there in factors(unit)
    assert absent not in factors(unit)
    assert factors("kg*m^2")["m against mm"] == 1e6
    assert list(KINDS["expression"].factors(unit)) == [
        "a factor of 2",
        "revolutions against radians",
    ]


def part(right, given, wrong):
    return OtherPart(right, KINDS["vector"], given, KEY, wrong)


def test_a_cause_that_a_right_part_contradicts_is_named_last_and_in_this_part():
    """The cause would show there too; but a term can be left out of one part alone."""
    reworded = causes.listed("turns", "turns y, as they say here")
    other = OtherParts(lambda: [part(True, KEY, [(reworded, MODEL)])])
    found = diagnose(MODEL, KEY, [(TURNS, MODEL), (MIRRORS, MODEL)], elsewhere=other)
    assert found == (MIRRORS, TURNS)
    assert causes.sentence(found) == f"{MIRRORS.text}; or one that in this part {TURNS.text}"
    twice, nearly = ((6.5123, 9.0, 0.0),), ((6.5123, 9.0151, 0.0),)
    other = OtherParts(lambda: [part(True, KEY, [(TURNS, twice)])])
    assert diagnose(twice, KEY, [(TURNS, twice)], elsewhere=other) == (TURNS,)
    assert diagnose(nearly, KEY, [(TURNS, twice)]) == (TURNS,)
    assert diagnose(nearly, KEY, [(TURNS, twice)], elsewhere=other) == ()
    term = causes.term_reversed("y", "the term y")
    other = OtherParts(lambda: [part(True, KEY, [(term, MODEL)])])
    assert diagnose(MODEL, KEY, [(term, MODEL)], elsewhere=other) == (term,)


def test_other_parts_contradict_what_would_show_there_and_prefer_what_explains_them():
    near = ((3.0, 4.01, 0.0),)
    other = OtherParts(lambda: [part(True, KEY, [(TURNS, near)])])
    assert diagnose(MODEL, KEY, [(TURNS, MODEL)], elsewhere=other) == (TURNS,)
    other = OtherParts(
        lambda: [part(False, MODEL, [(causes.listed("mirrors", "reworded"), MODEL)])]
    )
    assert diagnose(MODEL, KEY, [(TURNS, MODEL), (MIRRORS, MODEL)], elsewhere=other) == (MIRRORS,)
    size = OtherPart(False, KINDS["number"], ((7.0,),), ((5.0,),), [(TURNS, ((7.0,),))])
    models = [(TURNS, MODEL), (causes.CORIOLIS_HALVED, MODEL)]
    assert causes.CORIOLIS_HALVED in diagnose(
        MODEL, KEY, models, elsewhere=OtherParts(lambda: [size])
    )


@pytest.mark.parametrize(("name", "is_named"), [("u", False), ("x", True), ("u x", True)])
def test_nothing_is_taken_for_another_answer_that_is_right(name, is_named):
    """Unlike other slips, this cannot be made in one part only."""
    wrong = ((6.5123, 9.0, 0.0),)
    slip = replace(causes.computed("law", "takes a for u"), answers=tuple(name.split()))
    other = OtherParts(lambda: [part(True, KEY, [(slip, wrong)])._replace(name="u")])
    found = diagnose(wrong, KEY, [], elsewhere=other, slips=lambda fit, kind: [(2, slip, wrong)])
    assert (slip in found) == is_named


def test_small_terms_are_named_and_near_is_the_distance_of_the_rule():
    slip = causes.computed("term", "leaves out the small term")
    near = lambda fit, kind: [(2, slip, ((5.0432,),))]
    assert diagnose(((5.043,),), ((5.0,),), [], KINDS["number"], slips=near) == (slip,)
    # it is 3 % in both the words and the comparison
    vector = KINDS["vector"]
    assert "within 3 % of" in causes.NEAR.text
    assert vector.observed(((3.0 * 1.029, 4.0 * 1.029, 0.0),), KEY) == causes.NEAR
    assert vector.observed(((3.0, 4.1, 0.0),), KEY) == causes.NEAR_IN_FEW_DIGITS
    assert vector.observed(((3.0 * 1.031, 4.0 * 1.031, 0.0),), KEY) is None


def test_three_figures_are_what_is_asked_for_and_fewer_are_called_rounded():
    key = ((101.49, 1.49, 1.49),)
    assert causes.ROUNDED not in diagnose(((101.0, 1.0, 1.0),), key, [])
    assert diagnose(((100.0, 1.0, 1.0),), key, []) == (causes.ROUNDED,)
    assert diagnose(((2.5, 1.3, 0.0),), ((2.53, 1.27, 0.0),), []) == (causes.ROUNDED,)
    # and a zero vector does not leave out one component
    assert diagnose(((0.0, 0.0, 0.0),), ((3.0, 0.0, 0.0),), []) == (causes.GIVES_ZERO,)


@pytest.mark.parametrize(("given", "named"), [(27.96, True), (28.0, True), (27.9, False)])
def test_a_number_in_few_digits_meets_a_model_as_if_it_had_three(given, named):
    key, doubled = ((13.98,),), ((27.96,),)
    found = diagnose(((given,),), key, [(TURNS, doubled)], KINDS["number"])
    assert found == ((TURNS,) if named else ())
    assert not diagnose(((30.0,),), ((15.06,),), [(TURNS, ((30.12,),))], KINDS["number"])


@pytest.mark.parametrize("x", [2.5, 2.0, 250.0])
def test_a_number_that_may_have_lost_its_zeros_is_not_accused_of_rounding(x):
    """2.50 is read as 2.5."""
    given, key = ((x,),), ((1.012 * x,),)
    assert diagnose(given, key, [], KINDS["number"]) == ()
    assert KINDS["number"].observed(given, key) == causes.FIRST_DIGITS


def test_a_formula_fits_as_loosely_as_at_its_worst_point():
    """Loose at one point, exact at the next: a model that fits exactly comes first."""
    key, given = ((1.0,), (2.0,)), ((3.0,), (5.0,))
    loose = ((3.0 * (1 + 2e-5),), (5.0,))
    for points, level in ((given, EXACT), (loose, LOOSE), (loose[::-1], 0)):
        assert Fit(given, key, FORMULA_RTOL)(points) == level


@pytest.mark.parametrize(("kind", "given", "key", "remark"), [
    ("vector", ((3.0, 4.0, 9.0),), ((3.0, 4.0, 1.0),), causes.right_but([2], (1, 2, 3))),
    ("vector", ((3.0, 4.0, 1.0),), ((0.0, 0.0, 1.5),), None),
    ("vector", ((1.40012, 4.80031, 0.0),), KEY, causes.DIRECTION),
    ("vector", ((1.40012, 4.8021, 0.0),), KEY, None),
    ("vector", ((3.0, 7.0, 9.0),), ((3.0, 4.0, 1.0),), causes.right_but([1, 2], (1, 2, 3))),
    ("matrix", ((4, -1, 0.5, -1, 5, 2, 0.5, 2, 1),), INERTIA, causes.right_but([8], INERTIA[0], True)),
    ("matrix", ((4, 1, 1, 1, 1, 1, 1, 1, 1),), INERTIA, None),  # in more places than are read
    ("vector_expression", ((1.0, 2.0, 3.0), (2.0, 5.0, 7.0)),
     ((1.0, 2.0, 4.0), (2.0, 5.0, 6.0)), causes.right_but([2], (1, 2, 3))),
    ("expression", ((1.1,), (2.2,), (3.3,)), ((1.0,), (2.0,), (3.0,)), causes.NUMBERS),
    ("expression", ((1.1,), (2.2,), (3.4,)), ((1.0,), (2.0,), (3.0,)), None),
    ("expression", ((0.0,), (0.0,)), ((1.0,), (2.0,)), None),
    ("vector_expression", ((0.0, 2.0, 1.0),), ((1.0, 0.0, 0.0),), None),
])  # fmt: skip
def test_the_right_part_of_a_wrong_answer_is_named(kind, given, key, remark):
    assert KINDS[kind].observed(given, key) == remark


m, h = np.array([1.0, 2.0, 3.0, 5.0]), np.array([0.3, 1.5, 0.7, 2.0])


def rows(*columns):
    """The points of a formula with these components."""
    return tuple(zip(*(x.tolist() for x in columns), strict=True))


def test_of_a_formula_with_the_number_of_another_body_that_body_is_named():
    """A moment of inertia m h^2/18, and the centre of half a disk; what is no such formula."""

    def found(given, key, of, place=False, points=4):
        kind = (
            VECTORS if place else KINDS["matrix_expression" if len(key[0]) == 9 else "expression"]
        )
        fit = Fit(given[:points], key[:points], FORMULA_RTOL)
        symbols = {"m": m[:points], "h": h[:points]}
        return [cause.name for cause, _ in of_other_bodies(fit, of, symbols, kind)]

    inertia, plate = Dimension(1, 2), rows(m * h**2 / 18)
    assert found(rows(m * h**2 / 12), plate, inertia) == ["1/12"]
    assert found(rows(m * h**2 / 13), plate, inertia) == []
    # at fewer points than unknown powers and a number every formula is a product of powers
    assert [found(rows(m * h**2 / 12), plate, inertia, points=n) for n in (1, 3)] == [[], []]
    diagonal = lambda a, b, c: rows(a, *[0 * h] * 3, b, *[0 * h] * 3, c)
    one, other = m * h**2 / 18, m * h**2 / 12
    for wrong in itertools.product((one, other), repeat=3):
        off = [4 * n for n, x in enumerate(wrong) if x is other]
        where = f" in {off}" if len(off) < 3 else ""
        names = found(diagonal(*wrong), diagonal(one, one, one), inertia)
        assert names == [f"1/12{where}"] * bool(off)
    assert found(rows(m * h**3 / 12), rows(m * h**3 / 18), inertia) == []
    assert found(rows(m * h**2 / 12), rows(m * h**2 / 18 + h), inertia) == []
    centre, solid = (rows(0 * h, x * h) for x in (4 / (3 * np.pi), 3 / 8))
    assert found(solid, centre, Dimension(0, 1), True) == ["3/8"]
    assert found(centre, solid, Dimension(0, 1), True) == ["4/(3*pi)"]
    assert found(rows(0 * h, h), solid, Dimension(0, 1), True) == []
    # beside another mistake the one component is judged with the right ones
    fit = Fit(rows(3 / 8 * h, h + 1), rows(4 / (3 * np.pi) * h, h), FORMULA_RTOL)
    ((cause, points),) = of_other_bodies(fit, Dimension(0, 1), {"m": m, "h": h}, VECTORS)
    assert (cause.name, points) == ("3/8 in [0]", rows(3 / 8 * h, h))


def test_what_explains_each_wrong_component_is_named():
    """A listed mistake in one component alone; in a formula, a slip in each of two."""
    key, model, given = ((3.0, 4.0, 5.0),), ((9.1, 7.3124, 6.2),), ((3.00002, 7.3124, 5.0),)
    none = lambda fit, kind: ()
    (cause,) = diagnose(given, key, [(TURNS, model)], slips=none)
    assert cause.text == "in its second component turns y"
    assert not diagnose(((3.0, 7.4124, 5.0),), key, [(TURNS, model)], slips=none)
    alone = {(6.1, 4.0, 5.0): TURNS, (3.0, 4.0, 1.3): MIRRORS}

    def each(fit, kind):
        return [(1, alone[fit.given[0]], fit.given)] if fit.given[0] in alone else []

    formula, key, there = KINDS["vector_expression"], ((3.0, 4.0, 5.0),), (1.0, 2.0, 2.0)
    (cause,) = diagnose(((6.1, 4.0, 1.3), there), (*key, (2.0, 2.0, 2.0)), [], formula, slips=each)
    assert cause.name == "turns + mirrors"
    assert not diagnose(((6.1, 4.7, 1.3), there), (*key, (2.0, 2.1, 2.0)), [], formula, slips=each)
    # of a number times each right component, some slip is met by chance
    assert not diagnose(2 * ((6.1, 4.0, 1.3),), 2 * key, [], formula, slips=each)
    assert not diagnose(((6.1, 4.0, 1.3),), key[:1], [], slips=each)


@pytest.mark.parametrize(("more", "wrong", "named"), [
    (0.0, (7.0, 2.0, 5.0), True), (0.0, (7.0, 2.0, 8.0), True), (0.0, (7.0, -1.0, 5.0), False),
    (-3.0, (7.0, 2.0, 5.0), False), (3.0, (7.0, 2.0, 5.0), False),
])  # fmt: skip
def test_a_slip_in_each_entry_is_named_once_and_the_third_moment_of_a_plate_follows(
    more, wrong, named
):
    """An entry and its mirror image are one; I_zz of a plate is I_xx + I_yy."""
    matrix = lambda xx, xy, yy: (xx, xy, 0.0, xy, yy, 0.0, 0.0, 0.0, xx + yy + more)
    key, wrong = (matrix(4.0, -1.0, 5.0), matrix(2, 1, 3)), (matrix(*wrong), matrix(2, 1, 3))
    causes_of = {(0,): TURNS, (1, 3): MIRRORS, (4,): TURNS}

    def slips(fit, kind):
        pairs = enumerate(zip(fit.given[0], fit.key[0], strict=True))
        off = tuple(n for n, (x, k) in pairs if x != k)
        return [(1, causes_of[off], fit.given)] if off in causes_of else []

    fit = Fit(wrong, key, FORMULA_RTOL)
    found = of_each_component(fit, KINDS["matrix_expression"], [], slips)
    assert [cause.name for cause in found] == ["turns + mirrors"] * named


def test_the_symbols_that_have_other_powers_are_named():
    found = lambda given, key: [
        cause.text
        for cause in of_other_powers(Fit(given, key, FORMULA_RTOL), {"m": m, "h": h}, VECTORS)
    ]
    (other,) = found(rows(m + h, m * h), rows(m + h, m / h))
    assert other.startswith("in its second component has another power of h than")
    assert not found(rows(m + h), rows(m))
    assert not found(rows(2 * m), rows(m))


def test_a_formula_is_off_by_a_number_or_by_a_term_where_the_rest_of_it_is_right():
    fit = lambda given, key: Fit(rows(given), rows(key), 1e-6)
    numbers = lambda *pair: [c.what for c in of_a_number(fit(*pair), VECTORS)]
    terms = lambda *pair: [c.what for c in of_one_term(fit(*pair), {"m": m, "h": h}, VECTORS)]
    assert numbers(0.8 * (m + h), m + h) == ["has 4/5 times the right number"]
    assert numbers(0.8137 * (m + h), m + h) == numbers(m + 2 * h, m + h) == []
    assert terms(m + h - 0.3 * m * h, m + h) == ["is off by one term, in m and h"]
    assert terms(2 * m, m) == terms(m + h, 2 * m) == []

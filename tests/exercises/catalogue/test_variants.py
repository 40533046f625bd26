"""Each student's own numbers: the same for the same seed, different for another student, within
range, round, and fit to grade.
"""

import re
from functools import cache
from types import SimpleNamespace

import numpy as np
import pytest

from exercises import problem
from exercises.catalogue import CatalogueError, select, variants
from exercises.catalogue.variants import apart, as_points, draw, evaluate, objection, seed

VARYING = [p for p in select(["all"]) if any(g.vary for g in p.givens.values())]
by_id = pytest.mark.parametrize("p", VARYING, ids=lambda p: p.id.replace("/", "_"))


def numbers_of(student, p):
    return draw(p, seed(b"course secret", "week 7", student, p.id))


@cache
def adas_numbers(p):
    return numbers_of("ada", p)


@by_id
def test_drawn_numbers_are_in_range_and_round(p):
    for name, x in adas_numbers(p).items():
        g = p.givens[name]
        if g.vary is None:
            assert x == g.value
            continue
        assert g.vary[0] <= x <= g.vary[1]
        assert re.fullmatch(
            r"-?[0-9]\.?[0-9]{0,2}0?|-?[0-9]{2}\.?[0-9]?|-?[0-9]{2}\.[0-9]{2}|-?[0-9]{3}\.[0-9]|-?[0-9]{3,4}|-?[0-9]{3}0+|-?0\.[0-9]{1,4}",
            f"{x:.12g}",
        )


@pytest.mark.parametrize("p", VARYING[::12], ids=lambda p: p.id.replace("/", "_"))
def test_the_same_student_gets_the_same_numbers_and_another_one_others(p):
    assert numbers_of("ada", p) == adas_numbers(p)
    assert numbers_of("emmy", p) != adas_numbers(p)


def test_students_keep_their_numbers_and_rarely_share_them():
    """Students keep their numbers from version to version and on every machine."""
    kept = {"omega": 0.9, "b_dot": 0.7, "beta_1": 136.0, "b": 5.2, "L": 24.8}
    assert numbers_of("ada", problem("4/16")) == kept
    drawn = [tuple(numbers_of(f"student {n}", problem("4/16")).values()) for n in range(40)]
    assert len(set(drawn)) == 40


def test_seed_depends_on_secret_assignment_student_and_problem():
    words = ("week 7", "ada", "4/16")
    others = [seed(b"secret", *words[:n], "other", *words[n + 1 :]) for n in range(3)]
    assert len({seed(b"secret", *words), seed(b"Secret", *words), *others}) == 5
    assert seed(b"secret", "week", "7ada", "4/16") != seed(b"secret", "week7", "ada", "4/16")


def test_a_problem_of_symbols_only_has_nothing_to_draw():
    assert draw(problem("4/42"), b"any") == {}


def test_objections_to_numbers_that_hide_a_mistake_or_are_ill_conditioned():
    """At 45 degrees sine and cosine may be exchanged unseen."""
    p = problem("4/21")
    found = objection(p, {**p.book_values, "gamma_1": 45})
    assert "hides the mistake gamma_from_horizontal: its omega_A is within 2%" in found
    assert objection(p, p.book_values) is None
    # where the lower end nears the end of the ellipse's axis, its speed grows without bound
    p = problem("4/9")
    found = objection(p, {**p.book_values, "z_1": 3.98})
    assert re.match(r"is ill-conditioned: 0.1 % of z_1 changes v_mid by [0-9]+%", found)
    assert objection(p, p.book_values) is None
    p = problem("4/28")
    values = {"omega": 0.94, "theta_dot": 0.1, "theta_1": 15, "L": 12, "d": 1}
    assert re.match(r"gives v_A with a component of 2.3e-03", objection(p, values))


def test_a_range_without_good_numbers_is_reported(monkeypatch):
    monkeypatch.setattr(variants, "objection", lambda p, values: "gives v = (nan,)")
    monkeypatch.setattr(variants, "DRAWS", 3)
    message = "for problem 4/16 in 3 draws: narrow its vary ranges; the last draw gives v"
    with pytest.raises(CatalogueError, match=f"no good numbers {message}"):
        draw(problem("4/16"), b"any")


def test_a_step_of_the_grid_is_round_and_components_become_points():
    assert [variants._round_step(x) for x in (0.0225, 0.05, 1.9, 7.5)] == [0.02, 0.05, 1, 5]
    assert as_points((1, "up")) == ((1, "up"),)
    assert as_points(("up", np.array([1, 2]))) == (("up", 1.0), ("up", 2.0))
    assert as_points((1.5,), 2) == ((1.5,), (1.5,))


@pytest.mark.parametrize(("vary", "count"), [
    ((0.85, 0.95), 51), ((-2.3, -0.8), 76), ((0.07, 0.27), 41), ((1, 4.8), 77), ((2, 43), 42),
])  # fmt: skip
def test_both_ends_of_a_range_may_be_drawn_as_they_are_written(vary, count):
    """0.95/0.002 is a little less than 475, and 0.07/0.005 a little more than 14."""
    given = SimpleNamespace(vary=vary, value=3.14)
    drawn = [variants.drawn_value(given, SimpleNamespace(randint=end)) for end in (min, max)]
    assert drawn == list(vary)
    fixed = SimpleNamespace(vary=None, value=3.14)
    assert variants.drawn_value(fixed, None) == 3.14
    one, two, none = (
        SimpleNamespace(givens=dict(enumerate(g))) for g in ([given], [given] * 2, [fixed])
    )
    assert [variants.sheets(p) for p in (one, two, none)] == [count, count**2, 1]


@pytest.mark.parametrize(("wrong", "right", "expected"), [
    (((1.021,),), ((1.0,),), True), (((1.019,),), ((1.0,),), False),
    (((0.021,),), ((0.0,),), True), (((0.019,),), ((0.0,),), False),  # absolute, where it is zero
    (((2.0,), (1.0,)), ((1.0,), (1.0,)), True),  # at half of the points
    (((2.0,), (1.0,), (1.0,)), ((1.0,), (1.0,), (1.0,)), False),
    (((2.0,), (np.nan,), (1.0,)), ((1.0,), (1.0,), (np.inf,)), True),  # no value: not counted
    (((np.nan,),), ((1.0,),), True),
])  # fmt: skip
def test_a_mistake_is_apart_that_is_far_from_the_key_at_half_of_the_points(wrong, right, expected):
    assert apart(wrong, right) is expected


def test_evaluate_is_the_solution_and_its_mistakes_as_numbers():
    p = problem("4/16")
    right, wrong = evaluate(p, p.book_values)
    assert right["alpha_CD"] == pytest.approx((0, -0.27, 0))
    assert wrong["no_cross_product"]["alpha_CD"] == pytest.approx((0, 0, 0))
    assert set(wrong) == set(p.mistakes)

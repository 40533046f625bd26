"""Checks of unusual problems: without numbers, with a key that is zero, with a proof that stops at
the digits of its numbers, with mistakes that cannot be distinguished.
"""

from dataclasses import replace

import pytest
import sympy
from mpmath import findroot, mp, mpf

from exercises import problem
from exercises.catalogue import Answer, Given
from exercises.catalogue.checks import alike, check
from newton_euler import atan, pi, sin, sqrt

LENGTH = Answer("x", "number", "m", "a length")
RADIUS = Given("r", 0.3, "m", "radius", (0.2, 0.4))


def cone(solve, prove, made):
    answers = (Answer("alpha", "number", "deg", "half angle of the cone"),)
    return made(lambda g: {"alpha": solve(g)}, lambda g: {"alpha": prove(g)}, answers=answers)


def by_search(g):
    return findroot(lambda x: 4 * mp.sin(x) ** 2 - mp.cos(x) ** 2, mpf("0.5"))


def test_an_angle_in_pure_numbers_is_solved_in_fifty_digits_and_a_float_among_them_caught(made):
    p = cone(lambda g: atan(sqrt(g.one) / 2), by_search, made)
    assert check(p, seeds=3) == []
    assert p.formulas()["alpha"] == sympy.atan(sympy.Rational(1, 2)) * 180 / sympy.pi
    (fault,) = check(cone(lambda g: atan(0.5), by_search, made))
    assert fault.startswith("alpha: solve in 50 digits and prove differ")


def test_one_has_the_kind_of_the_givens_and_stays_when_they_change():
    p = replace(problem("4/16"), givens={"r": RADIUS}, symbols={})
    with mp.workdps(40):
        assert sqrt(3 * p.base({"r": mpf("0.3")}).but(r=mpf(2)).one) ** 2 - 3 < mpf(10) ** -38
    assert p.base({"r": 0.3}).one == 1.0
    assert isinstance(p.base({"r": sympy.Symbol("r")}).one, sympy.Integer)


def test_what_does_not_vary_is_proved_once(made):
    proofs = []

    def prove(g):
        proofs.append(g)
        return by_search(g)

    p = cone(lambda g: atan(g.one / 2), prove, made)
    check(p, seeds=1)
    once = len(proofs)
    check(p, seeds=50)
    assert len(proofs) == 2 * once


def test_a_proof_that_stops_at_the_digits_of_its_numbers_has_fifty(made):
    digits = []

    def prove(g):
        digits.append(mp.dps)
        return {"x": g.r}

    check(made(lambda g: {"x": g.r}, prove, givens={"r": RADIUS}, answers=(LENGTH,)))
    assert set(digits) == {50}


def nothing(offset, made):
    """A problem whose key is zero up to round-off in ``solve``, and ``offset`` in ``prove``."""
    solve, prove = lambda g: {"x": g.r * sin(pi(g.r))}, lambda g: {"x": mpf(offset)}
    return made(solve, prove, givens={"r": RADIUS}, answers=(LENGTH,))


@pytest.mark.parametrize("proved", ["1e-30", "0"])
def test_a_key_of_zero_holds_up_to_its_absolute_tolerance(proved, made):
    assert check(nothing(proved, made), seeds=2) == []


def test_a_key_of_zero_that_the_proof_denies_is_caught(made):
    faults = check(nothing("1e-7", made))
    assert faults[0].startswith("x: solve in floats and prove differ by 1.0e+00 of its size")


def radius(made, **wrong):
    """A problem that asks for its radius, and has these mistakes."""
    right = lambda g: {"x": g.r}
    mistakes = lambda g: {name: {"x": f(g)} for name, f in wrong.items()}
    given = {"givens": {"r": RADIUS}, "answers": (LENGTH,), "mistakes": dict.fromkeys(wrong, "")}
    return made(right, right, mistakes, **given)


def test_two_mistakes_with_the_same_wrong_answer_give_a_warning_unless_by_chance(made):
    diameter = {"twice": lambda g: 2 * g.r, "diameter": lambda g: g.r + g.r}
    p = radius(made, **diameter, half=lambda g: g.r / 2)
    assert check(p, seeds=3) == []
    (warning,) = alike(p, seeds=3)
    assert warning.startswith("the mistakes twice and diameter give the same wrong x")
    # 0.3 in the book, so that both are 3 there
    p = radius(made, tenfold=lambda g: 10 * g.r, three=lambda g: 0 * g.r + 3)
    assert alike(p) != []
    assert alike(p, seeds=3) == []

"""Every problem of every chapter holds for numbers of every kind, and gives what was found by hand
where its YAML has it under ``checked``.
"""

import random
from functools import cache

import mpmath
import numpy as np
import pytest
import sympy

from exercises.catalogue import chapters, problem, problems, select
from exercises.catalogue.checks import check, values
from exercises.catalogue.overlooked import missing_in_figure
from exercises.catalogue.places import home
from exercises.catalogue.variants import flat, symbol_values
from newton_euler import Frame, Vector
from tests.by_chapter import by_chapter

PROBLEMS = select(["all"])


def named(p):
    return p.id.replace("/", "_")


by_id = pytest.mark.parametrize("p", PROBLEMS, ids=named)


@pytest.mark.parametrize("name", chapters())
def test_every_code_has_its_text_and_every_text_its_code(name):
    assert {p.name for p in problems(name)} == {code.stem for code in home(name).glob("p*.py")}


def without_the_engine(prove):
    """The proof, which fails if it uses a frame or a vector of the engine."""

    def forbidden(*_, **__):
        raise AssertionError("the proof makes a frame or a vector of the engine")

    def alone(g):
        with pytest.MonkeyPatch.context() as patch:
            patch.setattr(Frame, "__init__", forbidden)
            patch.setattr(Vector, "__init__", forbidden)
            return prove(g)

    return alone


@pytest.mark.parametrize("seeds", [1, pytest.param(3, marks=pytest.mark.slow)])
@pytest.mark.parametrize("p", PROBLEMS, ids=lambda p: f"{named(p)}_holds")
def test_problem(p, seeds, monkeypatch):
    """In floats and in 50 digits, without the engine; right in its units, mistakes off the key;
    its figure complete; on one set of numbers, and with -m slow on three.
    """
    # import the code first: a module may make its axes on import
    monkeypatch.setattr(p.code, "prove", without_the_engine(p.code.prove))
    assert check(p, seeds) + missing_in_figure(p) == []


def test_a_proof_by_the_engine_is_refused(monkeypatch):
    p = problem("4/16")
    monkeypatch.setattr(p.code, "prove", without_the_engine(p.code.solve))
    assert "the proof makes a frame" in check(p)[0]


@cache
def formulas(p):
    return p.formulas()


@pytest.mark.one_in(3)
@by_id
def test_solve_runs_on_arrays_of_instants(p):
    students = [values(p, seed) for seed in range(3)]
    together = p.solve({n: np.array([float(v[n]) for v in students]) for n in p.units})
    for n, alone in enumerate(map(p.solve, students)):
        for key in alone:
            if p.answer(key).kind.is_word:
                assert np.broadcast_to(together[key], 3)[n] == alone[key]
                continue
            at_n = [np.broadcast_to(x, 3)[n] for x in flat(together[key])]
            assert at_n == pytest.approx([float(x) for x in flat(alone[key])], rel=1e-12, abs=1e-9)


@pytest.mark.one_in(3)
@by_id
def test_solve_keeps_the_digits_of_mpmath_numbers(p):
    with mpmath.mp.workdps(40):
        given = {n: mpmath.mpf(repr(float(v))) for n, v in values(p, 0).items()}
        precise = p.solve(given, mpmath.mpf(1))
        numbers = [answer for key, answer in precise.items() if not p.answer(key).kind.is_word]
        assert all(isinstance(x, (int, mpmath.mpf)) or x == 0 for x in flat(numbers))


@pytest.mark.one_in(3)
@pytest.mark.parametrize("p", [p for p in PROBLEMS if p.symbolic], ids=named)
def test_formulas_are_exact_and_short(p):
    for key, answer in formulas(p).items():
        if not p.answer(key).kind.is_formula:
            continue
        for x in map(sympy.sympify, flat(answer)):
            assert not x.atoms(sympy.Float)
            assert sympy.count_ops(x) <= 64  # 3/24, by a matrix


def is_the_same(p, x, y):
    """Equal; or, for roots that SymPy cannot simplify, equal in their squares and numerically."""
    if sympy.simplify(sympy.expand_trig(x - y)) == 0:
        return True
    numbers = symbol_values(p, random.Random(1))
    difference = sympy.sympify(x - y).subs({s: numbers[s.name] for s in (x - y).free_symbols})
    return sympy.simplify(x**2 - y**2) == 0 and abs(sympy.N(difference)) < 1e-12


@by_chapter
def test_answers_are_those_found_by_hand(p):
    """For the numbers of the book, or as formulas in the symbols of the text."""
    for key in p.checked:
        check_by_hand(p, key)


def check_by_hand(p, key):
    kind, found, by_hand = p.answer(key).kind, flat(formulas(p)[key]), flat(p.checked[key])
    if kind.is_word:
        assert found == by_hand
        return
    by_hand = [sympy.sympify(x, p.sympy_symbols()) for x in by_hand]
    if kind.is_formula:
        for x, y in zip(found, by_hand, strict=True):
            assert is_the_same(p, x, y), f"{x} is not {y}"
    else:
        assert [float(x) for x in found] == pytest.approx(
            [float(x) for x in by_hand], rel=1e-12, abs=1e-9
        )


@by_chapter
def test_a_mistake_is_worded_in_a_sentence_that_is_read(p):
    for text in p.mistakes.values():
        assert len(text.split()) <= 27  # 30 with "in this part"

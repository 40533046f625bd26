"""Components in the formulas of worked solutions, told apart by their places, in all problems."""

import random
from functools import cache
from itertools import permutations

import pytest
import sympy

from exercises.catalogue import problem
from exercises.catalogue.variants import draw, flat, symbol_values
from grader.assignment.derivations import component, derivations
from grader.assignment.lines import lines
from newton_euler.algebra.scalars import to_plain
from tests.grader.assignment.test_solution import ALL, EACH


@cache
def derived(number):
    """The derivations and {vector: {component: formula}}, without sums of terms."""
    p = problem(number)
    numbers = {**draw(p, b"one"), **p.sympy_symbols()}
    of = {line.step.of for line in lines(p, numbers, formulas=False)}
    found = {k: x.formulas for k, x in derivations(p, numbers).items() if k not in of}
    whole = {k: x for k, x in found.items() if len(x) == 3 and None not in x}
    return found, {k: {component(k, n, 3): f for n, f in enumerate(x)} for k, x in whole.items()}


@pytest.mark.parametrize("p", EACH, ids=lambda p: p.id)
def test_a_component_that_is_a_given_has_its_own_name_beside_another_in_the_same_role(p):
    """As m (v_x^2 + v_y^2)/2 and omega_y r_z - omega_z r_y, where v_x and r_y are given."""
    found, vectors = derived(p.id)
    for key, formulas in found.items():
        formulas = [f for f in formulas if f is not None]
        sums = [x.args for f in formulas for x in f.atoms(sympy.Add)]
        for terms in (*sums, [x for f in formulas for x in sympy.Add.make_args(f)]):
            for one, other in permutations(terms, 2):
                above, below = (abs(x).as_base_exp() for x in sympy.fraction(one / other))
                for own in (x for k, x in vectors.items() if k != key and str(below[0]) in x):
                    given = {
                        str(abs(f)) for n, f in own.items() if n not in (str(f), str(below[0]))
                    }
                    mixed = str(above[0]) in given & {*p.units}
                    assert not mixed or above[1] != below[1], (key, one, other)


@pytest.mark.parametrize("p", EACH, ids=lambda p: p.id)
def test_a_product_of_two_vectors_has_the_axes_of_a_cross_product_if_it_can(p):
    """2 Omega_z v_x along y, and not -2 Omega_z v_y, where v_y = -v_x."""
    _, vectors = derived(p.id)
    places = {name: (v, n) for v, own in vectors.items() for n, name in enumerate(own)}
    for own in vectors.values():
        for axis, term in (
            (n, x) for n, f in enumerate(own.values()) for x in f.as_ordered_terms()
        ):
            factors = [places[str(x)] for x in sympy.Mul.make_args(term) if str(x) in places]
            if len({v for v, _ in factors}) == len(factors) == 2:
                for (v, n), (_, fixed) in permutations(factors):
                    parts, free = [*vectors[v].values()], {0, 1, 2} - {axis, fixed}
                    equal = any(parts[k] in (parts[n], -parts[n]) for k in free)
                    assert len({axis, n, fixed}) == 3 or len(free) > 1 or not equal, term


SYMBOLIC = [p for p in ALL if p.symbols and not p.givens]  # which need no units


@pytest.mark.one_in(4)
@pytest.mark.parametrize("p", SYMBOLIC, ids=lambda p: p.id)
def test_a_formula_of_symbols_is_the_result(p):
    """At random numbers; unknowns that are not quantities of the problem have no value."""
    numbers = {**draw(p, b"one"), **p.sympy_symbols()}
    known = dict(numbers)
    for s in (line.step for line in lines(p, numbers, formulas=False)):
        parts = [] if isinstance(s.value, str) or callable(s.value) else flat(s.value)
        known |= {component(s.key, n, len(parts)): x for n, x in enumerate(parts)}
    point = symbol_values(p, random.Random(1))
    known = {n: at(sympy.sympify(to_plain(x)), point) for n, x in known.items()}
    for key, x in derivations(p, numbers).items():
        for n, f in enumerate(x.formulas):
            name = component(key, n, len(x.formulas))
            names = {name, *(y.name for y in f.free_symbols)} if f is not None else {""}
            if names <= known.keys():  # not of a term that is zero, which is not shown
                assert at(f, known) == pytest.approx(known[name], rel=1e-9, abs=1e-9), (key, f)


def at(formula, numbers):
    return float(formula.subs({x: numbers[x.name] for x in formula.free_symbols}).evalf())

"""Chebyshev polynomials against NumPy's, and the zero of a function in a bracket."""

import math

import numpy as np
import pytest
from numpy.polynomial import chebyshev as numpys

from newton_euler.motion import chebyshev as ours

CHANCE = np.random.default_rng(3)
POLYNOMIALS = CHANCE.normal(size=(5, ours.DEGREE + 1))
PLACES = CHANCE.uniform(-1.0, 1.0, 5)


def test_values_and_slopes_of_polynomials_are_those_of_numpy():
    exact = [numpys.chebval(x, c) for x, c in zip(PLACES, POLYNOMIALS, strict=True)]
    assert ours.values_at(POLYNOMIALS, PLACES) == pytest.approx(exact)
    assert [ours.value_at(c, x) for x, c in zip(PLACES, POLYNOMIALS, strict=True)] == pytest.approx(
        exact
    )
    slopes = [
        numpys.chebval(x, numpys.chebder(c)) for x, c in zip(PLACES, POLYNOMIALS, strict=True)
    ]
    assert ours.derivatives_at(POLYNOMIALS, PLACES) == pytest.approx(slopes)
    # the checks follow the coefficients
    longer = np.hstack([POLYNOMIALS, np.ones((5, 3))])
    assert ours.derivatives_at(longer, PLACES) == pytest.approx(slopes)


def all_extrema(*polynomials):
    c = np.zeros((len(polynomials), ours.DEGREE + 1))
    for row, p in zip(c, polynomials, strict=True):
        row[: len(p)] = p
    rows, x = ours.extrema(c)
    return [x[rows == n].tolist() for n in range(len(c))]


def test_the_extrema_of_many_polynomials_are_found_in_order():
    line, fifth, parabola = [3.0, -2.0], [0, 0, 0, 0, 0, 1.0], [0.5, 0.8, 1.0]
    exact = [[], [math.cos(k * math.pi / 5) for k in (4, 3, 2, 1)], [-0.2]]
    assert all_extrema(line, fifth, parabola) == [pytest.approx(x) for x in exact]
    assert all_extrema(parabola, line) == [pytest.approx([-0.2]), []]
    assert all_extrema([1.0]) == [[]]
    assert all_extrema([0.0], [0.0, 5.0]) == [[], []]


@pytest.mark.parametrize("factor", [1e-150, 1.0, 1e150])
def test_a_leading_coefficient_that_is_round_off_does_no_harm(factor):
    small = [factor * c for c in (0.5, 0.8, 1.0, *[1e-17] * 10)]
    assert all_extrema(small) == [pytest.approx([-0.2])]
    # also beside a polynomial of high degree
    high = [0.0] * ours.DEGREE + [1.0]
    found = all_extrema(small, high)
    assert found[0] == pytest.approx([-0.2], abs=1e-8)
    assert len(found[1]) == ours.DEGREE - 1


def test_extrema_of_random_polynomials_are_where_their_slope_is_zero():
    for found, c in zip(all_extrema(*POLYNOMIALS), POLYNOMIALS, strict=True):
        exact = numpys.chebroots(numpys.chebder(c))
        exact = sorted(z.real for z in exact if abs(z.imag) < 1e-9 and abs(z.real) < 1)
        assert [x for x in found if any(abs(x - y) < 1e-6 for y in exact)] == pytest.approx(exact)


# -- one zero


class Counted:
    """A function that counts its calls."""

    def __init__(self, f):
        self.f, self.count = f, 0

    def __call__(self, x):
        self.count += 1
        return self.f(x)


@pytest.mark.parametrize(("f", "exact", "calls"), [
    (lambda x: x - 0.3, 0.3, 6),
    (lambda x: math.cos(x) - x, 0.7390851332151607, 14),
    (lambda x: x**9 - 1e-3, 1e-3 ** (1 / 9), 45),
    (lambda x: math.exp(30 * x) - math.exp(3), 0.1, 45),
    (lambda x: 1.0 if x > 0.7 else -1e-9, 0.7, 140),
], ids=["line", "cosine", "flat", "steep", "jump"])  # fmt: skip
@pytest.mark.parametrize("swapped", [False, True])
@pytest.mark.parametrize("sign", [1, -1])
def test_a_root_is_found_to_round_off_in_few_steps(f, exact, calls, swapped, sign):
    g = Counted(lambda x: sign * f(x))
    found = ours.root(g, 2.0, -1.0) if swapped else ours.root(g, -1.0, 2.0)
    assert found == pytest.approx(exact, rel=4 * ours.EPS, abs=0.0)
    assert g.count <= calls


def test_a_root_at_an_end_is_that_end_and_others_as_inaccurate_as_asked():
    for end in (1.0, 2.0):
        g = Counted(lambda x, end=end: x - end)
        assert ours.root(g, 1.0, 2.0) == end
        assert g.count == 2
    g = Counted(lambda x: math.cos(x) - x)
    assert ours.root(g, 0.0, 2.0, 1e-2) == pytest.approx(0.739, abs=1e-2)
    assert g.count <= 8

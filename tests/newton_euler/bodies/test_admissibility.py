"""How far moments, products and masses may miss those of a real body: by rounding, no further."""

from itertools import permutations
from types import SimpleNamespace

import pytest
import sympy

from newton_euler import Frame
from newton_euler.algebra.scalars import epsilon
from newton_euler.bodies import Inertia, MassError, composite, disk
from newton_euler.bodies.admissibility import check, positive, round_off

TOLERANCE, SLACK = 1e-3, 0.01


def refused(moments, products=(0.0, 0.0, 0.0), tolerance=0.0, slack=0.0):
    """The words in which these moments and products are refused, "" if they are accepted."""
    I = SimpleNamespace(moments=moments, products=products, mass=None, matrix="M")
    try:
        check(I, tolerance, slack)
    except MassError as error:
        return str(error)
    return ""


def test_a_flat_body_is_admissible_without_any_tolerance():
    assert not refused((1.0, 1.0, 2.0))
    assert not refused((0.0, 0.0, 0.0))
    assert not refused((1.0, 1.0, 1.0), (0.5, 0.0, 0.0))
    assert "triangle inequality" in refused((1.0, 1.0, 2.0 + 1e-15))


@pytest.mark.parametrize("order", [*permutations(range(3))])
@pytest.mark.parametrize("size", [1e-9, 1.0, 1e9])
def test_the_triangle_inequality_holds_to_the_tolerance_of_the_largest_moment(order, size):
    """(I_1 + I_2 - I_3)/2 is the integral of a square; here it is -miss."""
    for miss, fits in ((0.99, True), (1.01, False)):
        miss *= TOLERANCE * 2.0
        sorted_ = (0.7, 1.3, 2.0 + 2 * miss)
        moments = tuple(size * sorted_[n] for n in order)
        found = refused(moments, tolerance=TOLERANCE / (1 + miss))
        assert (not found) == fits
        if found:
            assert f"I_{'xyz'[order.index(2)] * 2} = " in found


def test_the_slack_is_added_to_the_tolerance():
    for miss, fits in ((0.99, True), (1.01, False)):
        assert (not refused((1.0, 1.0, 2.0 + 2 * miss * SLACK), slack=SLACK)) == fits
        both = miss * (SLACK + 2 * TOLERANCE / (1 - 2 * TOLERANCE))
        assert (not refused((1.0, 1.0, 2.0 + 2 * both), tolerance=TOLERANCE, slack=SLACK)) == fits


@pytest.mark.parametrize("place", range(3))
@pytest.mark.parametrize("sign", [1, -1])
@pytest.mark.parametrize(
    ("tolerance", "slack", "small"), [(TOLERANCE, 0.0, 2 * TOLERANCE), (0.0, SLACK, SLACK)]
)
def test_schwarz_bounds_each_product_to_the_tolerance(place, sign, tolerance, slack, small):
    """Integrals of x^2, y^2, z^2 are 1: a product is at most 1, its square less by 4 small * 2."""
    for part, fits in ((0.98, True), (1.02, False)):
        products = [0.0, 0.0, 0.0]
        products[place] = sign * (1 + part * 8 * small) ** 0.5
        found = refused((2.0, 2.0, 2.0), tuple(products), tolerance, slack)
        assert (not found) == fits
        if found:
            assert f"no body has the product I_{('xy', 'yz', 'zx')[place]} = " in found
            assert "at most 1.0" in found


def test_each_product_has_the_bound_of_its_own_axes():
    """Integrals of x^2, y^2, z^2: 4, 1 and 1/4."""
    moments = (1.25, 4.25, 5.0)
    for place, bound in enumerate((2.0, 0.5, 1.0)):
        for part in (0.999, 1.001):
            products = [0.0, 0.0, 0.0]
            products[place] = part * bound
            assert bool(refused(moments, tuple(products))) == (part > 1)


@pytest.mark.parametrize("signs", [(1, 1, -1), (1, -1, 1), (-1, 1, 1), (-1, -1, -1)])
@pytest.mark.parametrize(
    ("tolerance", "slack", "small"), [(TOLERANCE, 0.0, 2 * TOLERANCE), (0.0, SLACK, SLACK)]
)
def test_the_determinant_may_miss_by_rounding_too(signs, tolerance, slack, small):
    """1 - 2 q^3 - 3 q^2, with products q: zero at 1/2; at the least -8 small * 2 * 2."""
    q = sympy.Symbol("q")
    for part, fits in ((0.98, True), (1.02, False)):
        root = sympy.nsolve(1 - 2 * q**3 - 3 * q**2 + part * 32 * small, q, 0.5)
        products = tuple(s * float(root) for s in signs)
        found = refused((2.0, 2.0, 2.0), products, tolerance, slack)
        assert (not found) == fits
        if found:
            assert "its principal moments break" in found


def test_the_determinant_counts_every_moment_and_product():
    """If no body has such a matrix, its smallest eigenvalue is negative."""
    import numpy as np

    rng = np.random.default_rng(5)
    for _ in range(200):
        A = rng.normal(size=(3, 3))
        values = rng.uniform(0.5, 2.0, 3) * (1, 1, 0)
        V, _ = np.linalg.qr(A)
        for least in (0.02, -0.02):
            J = V @ np.diag(values + (0, 0, least)) @ V.T
            squares = np.diag(J)
            moments = tuple((squares.sum() - squares).tolist())
            products = float(J[0, 1]), float(J[1, 2]), float(J[2, 0])
            assert bool(refused(moments, products)) == (least < 0)


def test_after_a_subtraction_that_leaves_nothing_its_round_off_is_not_a_product():
    assert not refused((0.0, 0.0, 0.0), (1e-3, -1e-3, 1e-3), slack=1e-3)
    assert "product" in refused((0.0, 0.0, 0.0), (1e-3, 0.0, 0.0), slack=1e-4)


def about_origin(miss, tolerance, distance=1.0, mass=1.0):
    """A particle at a distance, with moments too small by the fraction ``miss``."""
    body = Frame("body")
    own = mass * distance * distance * (1 - miss)
    Q = body.point("Q", distance, 0.0, 0.0)
    return Inertia(body, (0.0, own, own), mass=mass, centre=Q, tolerance=tolerance)


@pytest.mark.parametrize("size", [1e-6, 1.0, 1e6])
def test_about_the_centre_of_mass_the_tolerance_is_relative_to_the_moments_given(size):
    assert about_origin(0.99 * TOLERANCE, TOLERANCE, size)
    with pytest.raises(MassError, match="moments are smaller than mass and distance of Q alone"):
        about_origin(1.02 * TOLERANCE, TOLERANCE, size)


@pytest.mark.parametrize("mass", [1e-3, 1.0, 1e3])
@pytest.mark.parametrize("distance", [1e-3, 1.0, 1e3])
def test_what_is_round_off_of_the_distance_is_not_refused(distance, mass):
    assert about_origin(90 * epsilon(), 0.0, distance, mass)
    with pytest.raises(MassError, match="smaller than mass and distance"):
        about_origin(120 * epsilon(), 0.0, distance, mass)


@pytest.mark.parametrize("x", [0.0, -1.0, float("inf"), float("nan")])
def test_what_must_be_positive_is_positive_and_finite(x):
    positive(1e-300, "the mass")
    with pytest.raises(MassError, match="the mass must be positive, got"):
        positive(x, "the mass")


@pytest.mark.parametrize("mass", [0.0, -2.0])
def test_the_mass_of_an_inertia_is_positive_and_its_moments_are_finite(mass):
    body = Frame("body")
    with pytest.raises(MassError, match=r"the mass must be positive"):
        Inertia(body, (1.0, 1.0, 1.0), mass=mass)
    for place in range(3):
        moments = [1.0, 1.0, 1.0]
        moments[place] = float("inf")
        with pytest.raises(MassError, match="not finite"):
            Inertia(body, tuple(moments))


def test_the_round_off_of_a_mass_at_points_is_that_of_its_moments():
    body = Frame("body")
    points = body.point("P", 3.0, 0.0, -4.0), body.point("Q", 0.0, 2.0, 0.0)
    assert round_off(7.0, points, body) == pytest.approx(100 * epsilon() * 7.0 * 29.0)
    assert round_off(-7.0, points, body) == round_off(7.0, points, body)
    assert round_off(sympy.Symbol("m"), points, body) == 0.0
    x = body.point("X", sympy.Symbol("x"), 2.0, 0.0)
    assert round_off(1.0, (x,), body) == pytest.approx(100 * epsilon() * 4.0)


@pytest.mark.parametrize("far", [0.0, 1e3, 1e6])
def test_a_body_of_which_nearly_all_is_cut_out_has_the_slack_of_what_was_subtracted(far):
    """A ring as thin as 1e-9 of its radius, near and far from the point its moments refer to."""
    sheet = Frame("sheet")
    O = sheet.point("O", far, far, 0.0)
    whole, hole = (
        disk(r, O, "z", mass=r * r, name=f"disk {n}") for n, r in enumerate((1.0, 1.0 - 1e-9))
    )
    assert composite("ring", [whole], removed=[hole]).mass == pytest.approx(2e-9, rel=1e-6)


def test_a_hole_that_is_a_little_too_large_is_not_excused_as_round_off():
    """Its moments exceed those of the sheet, while its mass is less."""
    sheet = Frame("sheet")
    whole = disk(1.0, sheet, "z", mass=1.0)
    hole = disk(1.01, sheet, "z", mass=0.99, name="hole")
    with pytest.raises(MassError, match="do the removed parts lie inside of it"):
        composite("part", [whole], removed=[hole])
    almost = disk(1.0, sheet, "z", mass=1.0 - 1e-7, name="almost")
    wide = disk(1.0 + 1e-6, sheet, "z", mass=1.0 - 1e-7, name="wide")
    assert composite("part", [whole], removed=[almost])
    with pytest.raises(MassError, match="do the removed parts lie inside of it"):
        composite("part", [whole], removed=[wide])


@pytest.mark.parametrize("size", [1e-280, 1e-150, 1e-120, 1e-95, 1.0, 1e95, 1e120, 1e160, 1e290])
def test_an_inertia_is_judged_the_same_at_all_sizes(size):
    def of(moments, products):
        return Inertia(body, *([size * x for x in row] for row in (moments, products)))

    body = Frame("body")
    I = of((2.0, 3.0, 4.0), (0.5, 0.2, 0.1))
    assert I.moment(body.vector(3.0 * size, 0, 4.0 * size)) == pytest.approx(
        size * (0.36 * 2.0 + 0.64 * 4.0 - 2 * 0.48 * 0.1), rel=1e-12
    )
    for moments, products in (
        ((2.0, 3.0, 4.0), (5.0, 0, 0)),
        ((1.0, 1.0, 4.0), (0, 0, 0)),
        ((2.0, 3.0, 4.0), (1.0, 1.0, 1.2)),
    ):
        with pytest.raises(MassError, match="no body has"):
            of(moments, products)

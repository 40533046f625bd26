"""A body by integration over every kind of number: one formula gives numbers, a class at once, fifty
digits, dimensions, a traced text and formulas.
"""

import mpmath
import numpy as np
import pytest
import sympy

from newton_euler import Dimension, Frame, compiled, cos, moving, pi, sin, sqrt
from newton_euler.algebra import DimensionError
from newton_euler.bodies import MassError, integrated

MASS, LENGTH = Dimension(1, 0, 0), Dimension(0, 1, 0)


def summary(position, *limits, **matter):
    """Mass, centre, moments and products about the origin, as one tuple."""
    body = integrated(position, *limits, frame=Frame("O"), **matter)
    about = body.about(body.frame)
    return (body.mass, *body.centre.position(body.frame), *about.moments, *about.products)


def half_disk(R, m):
    return summary(lambda r, a: (r * cos(a), r * sin(a), 0), (0, R), (0, pi(R)), mass=m)


def half_disk_by_hand(R, m):
    moment = m * R * R / 4
    return m, 0 * R, 4 * R / (3 * pi(R)), 0 * R, moment, moment, 2 * moment, *[0 * moment] * 3


def plate(b, h, rho):
    """The right triangle with legs b and h, with a density that grows along x."""
    legs = (0, b), (0, lambda x: h * (1 - x / b))
    return summary(lambda x, y: (x, y, 0), *legs, density=lambda x, y, z: rho * (1 + x / b))


def plate_by_hand(b, h, rho):
    """Integrals of x^p y^q over the triangle are p! q!/(p + q + 2)! b^(p+1) h^(q+1)."""
    m = rho * b * h * 2 / 3
    x, y = rho * b * b * h / 4 / m, rho * b * h * h * 5 / 24 / m
    xx, yy, xy = rho * b**3 * h * 2 / 15, rho * b * h**3 / 10, rho * b * b * h * h * 7 / 120
    return m, x, y, 0 * x, yy, xx, xx + yy, xy, 0 * xy, 0 * xy


def wire(R):
    """A quarter of a circle of mass 1 per length."""
    return summary(lambda a: (R * cos(a), R * sin(a), 0), (0, pi(R) / 2), density=1.0)


def cone(R, h, m):
    limits = (0, h), (0, lambda z: R * z / h), (0, 2 * pi(R))
    return summary(lambda z, r, a: (r * cos(a), r * sin(a), z), *limits, mass=m)


def cone_by_hand(R, h, m):
    across = 3 * m * (R * R + 4 * h * h) / 20
    return m, 0 * R, 0 * R, 3 * h / 4, across, across, 3 * m * R * R / 10, *[0 * across] * 3


CASES = {
    "half disk": (half_disk, half_disk_by_hand, (2.0, 5.0)),
    "plate": (plate, plate_by_hand, (0.6, 0.9, 30.0)),
    "cone": (cone, cone_by_hand, (0.5, 1.5, 4.0)),
}
every_case = pytest.mark.parametrize("case", CASES)


def close(found, expected, rtol):
    return all(
        np.all(abs(x - y) <= rtol * (1 + abs(y))) for x, y in zip(found, expected, strict=True)
    )


@every_case
def test_floats_arrays_and_traced_numbers(case):
    body, by_hand, given = CASES[case]
    expected = by_hand(*given)
    assert close(body(*given), expected, 1e-11)
    run = compiled(body)
    assert close(run(*given), expected, 1e-13)
    for many in ([np.array([x, 2 * x, x / 3]) for x in given], [np.array([0.6, 0.7]), *given[1:]]):
        assert close(body(*many), by_hand(*many), 1e-13)
        assert close(run(*many), by_hand(*many), 1e-13)


def test_beside_a_mass_a_density_is_relative():
    def wire(**matter):
        density = lambda x, y, z: 1 + x
        return summary(lambda x: (x, 0, 0), (0.0, 2.0), density=density, **matter)

    assert close(wire(), (4, 7 / 6, 0, 0, 0, 20 / 3, 20 / 3, 0, 0, 0), 1e-12)
    assert close(wire(mass=3.0), (3, 7 / 6, 0, 0, 0, 5, 5, 0, 0, 0), 1e-12)


@pytest.mark.parametrize("case", [pytest.param("half disk", marks=pytest.mark.slow), "plate"])
def test_fifty_digits(case):
    body, by_hand, given = CASES[case]
    with mpmath.mp.workdps(50):
        given = [mpmath.mpf(repr(x)) for x in given]
        assert close(body(*given), by_hand(*given), mpmath.mpf(10) ** -47)


@every_case
def test_dimensions(case):
    body, _, given = CASES[case]
    density = MASS / LENGTH**2 if case == "plate" else MASS
    mass, x, y, z, *inertia = body(*[LENGTH] * (len(given) - 1), density)
    assert mass == MASS
    assert {c for c in (x, y, z) if c != 0} == {LENGTH}
    assert {c for c in inertia if c != 0} == {MASS * LENGTH**2}


def test_what_has_unlike_dimensions_moves_or_does_not_converge_is_no_body():
    with pytest.raises(DimensionError, match="cannot add"):
        cone(LENGTH, MASS, MASS)
    kinked, ends = lambda x, y, z: sqrt(abs(x - 0.3)) + 1, np.array([1.0, 2.0])
    with pytest.raises(MassError, match=r"does not converge.*Divide it where they are not"):
        summary(lambda x: (x, 0, 0), (0, ends), density=kinked)
    with pytest.raises(MassError, match="the points of body move"):
        wire(moving(2.0, rate=1.0))


@pytest.mark.parametrize("case", ["half disk", "plate"])
def test_symbols_give_formulas_without_being_asked(case):
    body, by_hand, given = CASES[case]
    symbols = sympy.symbols(f"a:{len(given)}", positive=True)
    found, expected = body(*symbols), by_hand(*symbols)
    assert [sympy.simplify(x - y) for x, y in zip(found, expected, strict=True)] == [0] * 10

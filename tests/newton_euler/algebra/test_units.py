"""Exact factors, against the definitions, pint where it is installed, and back again."""

import math
from fractions import Fraction

import mpmath
import pytest
import sympy
from hypothesis import given
from hypothesis import strategies as st

from newton_euler import Dimension, Frame
from newton_euler.algebra.units import UNITS, Unit, UnitError, pint_name, unit
from tests.kinds import KINDS, close, numbers

SOME = [
    "1", "mm", "rev/min", "deg/s^2", "slug*ft^2", "lb/in^2", "kg*m^2/s", "N*m/rad", "mi/h", "1/s",
    "m^-1", "in^4", "oz*in*s^2", "kN/m",
]  # fmt: skip


@pytest.mark.parametrize("name", UNITS)
def test_factors_agree_with_pint(name):
    registry = pytest.importorskip("pint").UnitRegistry()
    expected = registry.Quantity(1.0, pint_name(name)).to_base_units()
    got = Unit(name)
    base = dict(zip(("[mass]", "[length]", "[time]"), got.dimension.powers, strict=True))
    assert {k: v for k, v in base.items() if v} == dict(expected.dimensionality)
    assert got.to_base(1.0) == pytest.approx(expected.magnitude, rel=1e-12)


def test_definitions_are_exact():
    assert Unit("in").factor == Fraction(254, 10000)
    assert Unit("ft").factor == Fraction(3048, 10000)
    assert Unit("mi").factor == Fraction("1609.344")
    assert Unit("lb").factor == Fraction("4.4482216152605")
    assert Unit("slug").factor == Unit("lb").factor / Unit("ft").factor
    assert Unit("slug*ft/s^2").factor == Unit("lb").factor
    assert Unit("slug*ft/s^2").dimension == Unit("lb").dimension == Unit("N").dimension


@pytest.mark.parametrize(("text", "x", "expected"), [
    ("mm", 250.0, 0.25), ("deg", 180.0, math.pi), ("m", 3.0, 3.0), ("in", 10.0, 0.254),
    ("rev/min", 60.0, 2 * math.pi), ("rpm", 60.0, 2 * math.pi), ("km/h", 36.0, 10.0),
])  # fmt: skip
def test_round_numbers_come_out_round(text, x, expected):
    assert Unit(text).to_base(x) == expected
    assert Unit(text).from_base(expected) == x


@given(st.sampled_from(SOME), st.floats(-1e6, 1e6))
def test_converting_there_and_back_changes_nothing(text, x):
    assert Unit(text).from_base(Unit(text).to_base(x)) == pytest.approx(x, rel=1e-15, abs=1e-300)


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("text", SOME)
def test_every_kind_of_number_is_converted(kind, text):
    x = numbers(kind, "12.5")
    u = Unit(text)
    with mpmath.workdps(40):
        factor = mpmath.mpf(u.factor.numerator) / u.factor.denominator * mpmath.pi**u.pi_power
    expected = x * float(factor) if kind in ("float", "array") else mpmath.mpf("12.5") * factor
    small = 1e-15 if kind in ("float", "array") else 1e-28
    assert close(u.to_base(x), expected, small * abs(float(factor)) * 20)


def test_thirty_digits_and_symbols_stay_exact():
    assert abs(Unit("rev/min").to_base(mpmath.mpf(1)) - mpmath.pi / 30) < 1e-30
    assert Unit("rev/min").to_base(sympy.Integer(1)) == sympy.pi / 30
    assert Unit("in").to_base(sympy.Symbol("x")) == sympy.Rational(127, 5000) * sympy.Symbol("x")
    assert Unit("deg").to_base(Dimension()) == Dimension()


def test_vectors_are_converted_with_their_terms_and_digits():
    ground = Frame("ground")
    arm = ground.rotate("arm", "z", rate=Unit("rev/min").to_base(30.0))
    a = Unit("mm/s^2").from_base(arm.point("P", 2.0, 0, 0).acceleration(ground))
    assert a.x == pytest.approx(-2000 * math.pi**2)
    assert a.terms["centripetal"].x == a.x
    omega = Unit("rev/min").to_base(Frame("ground").vector(0, 0, mpmath.mpf(30)))
    assert abs(omega.z - mpmath.pi) < 1e-29


def test_dimensions_follow_the_text():
    for text in ("kg*m^2/s^2", "J", "N*m"):
        assert Unit(text).dimension == Dimension(1, 2, -2)
    assert Unit("kg/m/s").dimension == Dimension(1, -1, -1)
    assert Unit("kg / m * s").dimension == Dimension(1, -1, 1)
    assert Unit("m^-2").dimension == Dimension(0, -2, 0)
    assert Unit("rad").dimension == Unit("%").dimension == Unit("1").dimension == Dimension()
    assert unit("N*m") is unit("N*m")
    assert repr(unit("N*m")) == "Unit('N*m')"


@pytest.mark.parametrize(
    "text",
    ["", "m//s", "m*", "/s", "m^", "m^2.5", "m^x", "m^2^2", "mm^999999999", "2*m", "m s^", "m-s", "(m)", "µm",
     None, 3],
)  # fmt: skip
def test_what_cannot_be_read_is_quoted(text):
    with pytest.raises(UnitError, match=r"cannot read the unit|unknown unit") as error:
        Unit(text)
    assert repr(text) in str(error.value)


def test_an_unknown_unit_lists_the_known_ones():
    words = r"unknown unit 'furlong' in 'furlong/s'; known are 1, %, rad, deg, rev, m, mm"
    with pytest.raises(UnitError, match=words):
        Unit("furlong/s")
    with pytest.raises(UnitError, match="unknown unit 'kgm'"):
        Unit("kg m")


@pytest.mark.parametrize(("text", "turning", "angle", "feet"), [
    ("deg", True, True, False), ("rad", False, True, False), ("rpm", True, False, False),
    ("rev/min", True, False, False), ("rad/s", False, False, False), ("%", False, False, False),
    ("ft/s^2", False, False, True), ("km/h", False, False, False), ("1", False, False, False),
])  # fmt: skip
def test_a_unit_says_what_it_measures(text, turning, angle, feet):
    found = unit(text)
    assert (found.is_of_turning, found.is_of_angle, found.is_of_feet) == (turning, angle, feet)

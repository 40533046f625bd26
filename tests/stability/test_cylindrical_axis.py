"""The axis of cylindrical (and polar) coordinates, where the azimuth does not exist (3.18)-(3.23)."""

import mpmath
import pytest

from newton_euler import Frame, at
from newton_euler.algebra.scalars import SingularError, cos, sin
from newton_euler.kinematics.coordinates import cylindrical_coordinates, polar_coordinates
from newton_euler.kinematics.curvilinear_systems import curvilinear

ground = Frame("ground")


def test_past_the_axis_at_a_micrometre_the_rate_of_the_azimuth_is_1e6_rad_per_s():
    found = cylindrical_coordinates(ground.vector(0.0, 1e-6, 0), ground.vector(-1.0, 0, 0))[1].rate
    assert abs(found - 1e6) < 1e-9


@pytest.mark.parametrize("eps", ["1e-3", "1e-8", "1e-150"])
def test_rates_near_the_axis_are_right_to_1e_minus_14_of_their_size(eps):
    def rates(number):
        r, v, a = (
            (number(x) for x in c)
            for c in ((eps, "0", "0"), ("0.25", "1", "0.5"), ("0.1", "-0.3", "0.2"))
        )
        return cylindrical_coordinates(ground.vector(*r), ground.vector(*v), ground.vector(*a))

    for found, exact in zip(rates(float), rates(mpmath.mpf), strict=True):
        assert abs(found.rate - exact.rate) <= 1e-14 * abs(exact.rate)
        assert abs(found.acceleration - exact.acceleration) <= 1e-14 * abs(exact.acceleration)


@pytest.mark.parametrize("coordinates", [cylindrical_coordinates, polar_coordinates])
def test_on_the_axis_there_is_no_azimuth(coordinates):
    with pytest.raises(SingularError, match="on the z axis"):
        coordinates(ground.vector(0.0, 0.0, 0), ground.vector(1.0, 0, 0))


def test_a_point_that_is_on_the_axis_but_for_rounding_is_refused_too():
    x = 0.1 + 0.2 - 0.3  # 5.6e-17 m, at a height of 1 m
    with pytest.raises(SingularError, match=r"distance 5\.55e-17"):
        cylindrical_coordinates(ground.vector(x, 0, 1.0))
    assert cylindrical_coordinates(ground.vector(1e-14, 0, 1.0))[0] == 1e-14


def test_a_user_defined_system_finds_its_own_axis():
    def position(r, theta, z):
        return r * cos(theta), r * sin(theta), z

    with pytest.raises(SingularError, match="coordinate 2 is singular"):
        curvilinear(ground, "P", position, 0.0, 0.3, 1.0)
    P = curvilinear(ground, "P", position, 1e-9, at(lambda t: 0.3 + 2 * t, 0.0), 1.0)
    assert abs(P.velocity(ground).y - 2e-9) < 1e-24  # m/s

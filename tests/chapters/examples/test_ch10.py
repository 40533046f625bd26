"""The worked examples of 10.8, 10.10 and 10.11."""

import math

import pytest

from newton_euler import Frame
from newton_euler.applications import free_precession, normal_moment, steady_precession, steady_spin
from newton_euler.chapters.examples import ch10
from newton_euler.scenes.spatial import top


def test_section_10_8_football_and_space_station():
    theta, spin = 0.5, 10.0
    assert ch10.football(theta, spin).rate == pytest.approx(spin / (2 * math.cos(theta)), rel=1e-14)
    assert ch10.football(theta, spin).sense == "direct"
    I0, I = ch10.station_moments(3.0, 30.0, Frame("station").origin)
    assert pytest.approx((3 * 9 / 12 + 900 / 12, 4.5), rel=1e-15) == (I0, I)
    tilt = math.radians(40.0)
    spin = (I0 - I) / I * math.cos(tilt)
    assert steady_spin(I0, I, tilt, 1.0, mgr=0) == pytest.approx(spin, rel=1e-14)


def test_section_10_8_the_wobble_of_the_earth_by_integration():
    """At (I - I0) omega_z/I0; the book's 26 000 years are not those of a free precession."""
    e = 0.003285
    I0, I, wz = 1.0, 1.0 + e, 2 * math.pi
    rate = free_precession(I0, I, 1e-6, -e * wz).rate
    # about K nearly a day, whatever the wobble
    assert rate == pytest.approx(wz * (1 + e), rel=1e-11)
    assert ch10.wobble_period(e, 1.0) == pytest.approx(304.4, abs=0.1)
    model = top.free(I0, I, wz)
    t = ch10.wobble_period(e, 1.0)
    w_x, w_y = model.solution(t, (1.0, 0, 0, 0, 1e-6, 0))[4:]
    spun = wz * t  # from the frame that does not spin into the body
    c, s = math.cos(spun), math.sin(spun)
    in_body = w_x * c + w_y * s, w_y * c - w_x * s
    assert in_body == pytest.approx((1e-6, 0), abs=1e-16 * spun)


def test_section_10_10_rotor_of_the_car():
    W, W_R, h, K, v, g = 3000.0, 300.0, 4.0, 2.0, 100.0, 32.2
    spin = ch10.rotor_spin(W, h, v, W_R, K)
    assert spin == 1000.0
    # the book rounds to 10 000 rpm
    assert spin * 60 / (2 * math.pi) == pytest.approx(9549.3, abs=0.05)
    m, I = W / g, W_R / g * K * K
    for r in (200.0, 1000.0):  # at every radius
        assert I * spin * v / r == pytest.approx(ch10.rotor_moment(m, h, v, r), rel=1e-14)
        inner, outer = ch10.wheel_loads(m, h, v, r, 5.0, g, rotor=I * spin)
        assert inner == pytest.approx(W / 2, rel=1e-14)
        assert outer == pytest.approx(W / 2, rel=1e-14)


def test_section_10_10_the_rotor_turns_against_the_wheels():
    """The car drives along y and turns left, to -x; (10.38) moves the rotor, the car reacts."""
    f = Frame("car")
    wheels, turning = f.vector(-1.0, 0, 0), f.vector(0, 0, 0.2)
    on_car = -normal_moment(turning, -50.0 * wheels, 2.0)
    # at the road, a height 1 below G, towards the centre
    assert on_car.y * f.vector(0, 0, -1.0).cross(f.vector(-300.0, 0, 0)).y < 0


def test_section_10_11_instruments():
    assert ch10.uprighting_moment(0.1, 5.0, 0.25, 0.5) == pytest.approx(1.0)
    assert ch10.sensed_tilt(0.001, 1000.0, 0.02, 0.5) == pytest.approx(0.04)
    slow = steady_precession(0.002, 0.001, math.pi / 2, spin=1000.0, moment=1e-6).slow
    assert ch10.platform_drift(1e-6, 0.001, 1000.0) == pytest.approx(slow, rel=1e-12)

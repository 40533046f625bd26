"""The worked examples of chapter 2, over every kind of number."""

import math

import mpmath as mp
import numpy as np
import pytest

from newton_euler import Frame, cos, moving, sin, tan
from newton_euler.algebra import SingularError
from newton_euler.chapters.examples import ch02
from tests.kinds import close, every_kind, number, numbers, small

ground = Frame("ground")


@every_kind
def test_example_2_2_water_from_a_nozzle(kind):
    v0, theta, g, t = numbers(kind, 25, "0.6", "32.2", "0.31")
    jet = ch02.Nozzle(v0, theta, g)
    assert close(jet.water(ground, t).acceleration(ground), (0, -g, 0), small(kind, 0.2))
    top, landed = jet.path(jet.time_to_top), jet.path(jet.time_of_flight)
    assert close(top[1], jet.height, small(kind, 0.2))
    assert close(jet.water(ground, jet.time_to_top).velocity(ground).y, 0, small(kind, 0.2))
    assert close(landed, (jet.range, 0, 0), small(kind, 0.6))
    x, y, _ = jet.path(t)
    assert close(jet.height_at(x), y, small(kind, 0.2))
    assert close(y, x * tan(theta) - g * x**2 / (2 * v0**2 * cos(theta) ** 2), small(kind, 0.2))


@every_kind
def test_example_2_4_curvature_of_the_jet(kind):
    v0, theta, g = numbers(kind, 25, "0.6", "32.2")
    jet = ch02.Nozzle(v0, theta, g)
    exit_, top = jet.intrinsic(0 * v0, ground), jet.intrinsic(jet.time_to_top, ground)
    assert close(exit_.speed_rate, -g * sin(theta), small(kind, 0.2))
    assert close(exit_.radius, v0**2 / (g * cos(theta)), small(kind, 0.2))
    assert close(top.speed_rate, 0, small(kind, 0.2))
    assert close(top.radius, (v0 * cos(theta)) ** 2 / g, small(kind, 0.2))
    assert close(top.e_n.components(ground), (0, -1, 0), small(kind, 0.02))


def test_example_2_4_printed_numbers():
    jet = ch02.Nozzle(25.0, math.radians(35), 32.2)
    assert close((jet.radius(0.0), jet.radius(jet.time_to_top)), (23.7, 13.02), 0.005)


@every_kind
def test_example_2_5_car_in_a_curve(kind):
    rho, rate, total = numbers(kind, 250, 2, 3)
    v = ch02.speed_in_curve(rho, rate, total)
    assert close(v**4, rho**2 * (total**2 - rate**2), 1e-8 if kind in ("float", "array") else 1e-20)
    assert close(ch02.acceleration_in_curve(ground, rho, v, rate).norm(), total, small(kind, 0.2))
    if kind != "array":
        assert close(number(v), mp.mpf("23.64"), 0.005)
    with pytest.raises(SingularError, match="less than its tangential component"):
        ch02.speed_in_curve(250.0, 3.0, 2.0)


@every_kind
def test_examples_2_7_and_2_11_telescoping_boom(kind):
    ell, rate, theta, w = numbers(kind, 20, "0.5", "0.5235987755982988", "-0.075")
    boom = ch02.TelescopingBoom(moving(ell, rate), moving(theta, w))
    B, A = boom.end(ground), boom.end_in_boom_frame(ground)
    known = (rate, ell * w, 0), (-ell * w**2, 2 * rate * w, 0)
    if kind != "array":
        known = (0.5, -1.5, 0), (-0.1125, -0.075, 0)
    assert close((tuple(B.velocity(ground)), tuple(B.acceleration(ground))), known, 1e-15)
    # 2.11: the same by (2.24), (2.25)
    assert close(A.velocity(ground).components(), B.velocity(ground).components(), 0)
    assert close(A.acceleration(ground).components(), B.acceleration(ground).components(), 0)
    if kind == "float":
        sizes = B.velocity(ground).norm(), B.acceleration(ground).norm()
        assert close(sizes, (1.581, 0.135), 0.0005)


@every_kind
def test_example_2_12_a_car_seen_from_another(kind):
    cars = ch02.TwoCars(*numbers(kind, 30, 200, 25, 2, 20, -4))
    v, a = cars.A_seen_from_B()
    if kind == "array":
        v, a = ([c[0] if np.ndim(c) else c for c in x] for x in (v, a))
    assert close(v, (25, -17, 0), small(kind, 0.02))
    assert close(a, (mp.mpf("0.3"), mp.mpf("-1.6"), 0), small(kind, 0.2))


def test_example_2_12_A_does_not_see_B_with_the_opposite_velocity():
    _, B, A = ch02.TwoCars(30.0, 200.0, 25.0, 2.0, 20.0, -4.0).scene()
    not_turning = B.parent.translate("car A", A)
    assert close(B.origin.velocity(not_turning), (-25.0, 20.0, 0), 1e-14)
    assert not close(B.origin.velocity(not_turning), -A.velocity(B).expressed_in(B), 1)

"""Problems with numbers for which the answer is known without a calculation."""

import math

import pytest

from exercises import problem


def test_4_11_equal_cones_turn_the_third_about_its_own_axis():
    """With beta_A = beta_B the axis of C is y, and C rolls on A at -omega*tan(beta)."""
    x, y, z = problem("4/11").solve({"omega": 2.0, "beta_A": 0.7, "beta_B": 0.7})["omega_C"]
    assert (x, y, z) == pytest.approx((0, -2 * math.tan(0.7), 0), abs=1e-12)


def test_4_10_a_car_going_straight_turns_its_differential_as_one_body():
    answers = problem("4/10").solve({"omega_1": 3.0, "omega_2": 3.0, "R": 1.0, "r": 0.4})
    assert (answers["Omega"], answers["omega_A"]) == pytest.approx((3, 0))


def test_4_33_gear_that_turns_with_the_arm_does_not_turn_the_other():
    answers = problem("4/33").solve({"n": 60.0, "n_C": 60.0, "tan_gamma": 1.5})
    assert tuple(answers["omega_B"]) == pytest.approx((0, 0, 2 * math.pi), abs=1e-12)
    assert answers["alpha_B"].norm() == pytest.approx(0, abs=1e-12)


def test_4_9_can_be_built_with_every_number_that_can_be_drawn():
    """The rod reaches the ellipse, keeps its length, and slides along the tangent."""
    p = problem("4/9")
    low, high = p.givens["z_1"].vary
    for n in range(51):
        values = {**p.book_values, "z_1": round(low + (high - low) * n / 50, 2)}
        g = p.base(values)
        _, A, B, M = p.code.rod(g)
        AB, ground = B - A, A.frame
        v_A, v_B = A.velocity(ground), B.velocity(ground)
        x, y, z = B.position(ground)
        assert x > 0
        assert y > 0
        assert z == 0
        assert AB.norm() == pytest.approx(g.L)
        assert (x / g.a) ** 2 + (y / g.b) ** 2 == pytest.approx(1)
        assert AB.dot(v_B - v_A) == pytest.approx(0, abs=1e-12)
        assert v_B.x * x / g.a**2 + v_B.y * y / g.b**2 == pytest.approx(0, abs=1e-9)
        assert tuple(M.velocity(ground)) == pytest.approx(tuple((v_A + v_B) / 2))

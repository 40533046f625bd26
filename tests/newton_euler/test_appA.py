"""Appendix A: every numbered equation over every kind of number, and the worked examples."""

import math

import mpmath as mp
import numpy as np
import pytest
import sympy

from newton_euler import Frame, at, cos, cross, dot, sin
from newton_euler.algebra import FrameError
from newton_euler.kinematics import gradient
from tests.kinds import KINDS, close, number, numbers

every_kind = pytest.mark.parametrize("kind", KINDS)
ground = Frame("ground")


def tolerance(kind):
    return 1e-14 if kind in ("float", "array") else mp.mpf(10) ** -27


def vectors(kind):
    return (
        ground.vector(*numbers(kind, "1.5", "-0.7", "0.4")),
        ground.vector(*numbers(kind, "-0.3", "1.2", "0.9")),
        ground.vector(*numbers(kind, "0.8", "0.6", "-1.1")),
    )


def functions(kind):
    """P(t), Q(t) as lists of functions, u(t), and the instant."""
    a, b = numbers(kind, "0.4", "1.7")
    P = [lambda t: a * t**2, lambda t: sin(b * t), lambda t: 1 + a * t]
    Q = [lambda t: cos(t), lambda t: b * t**3, lambda t: a - t]
    return P, Q, (lambda t: 2 + sin(a * t)), numbers(kind, "0.6")


def vector_at(components, t):
    return ground.vector(*(at(f, t) for f in components))


# -- algebra


@every_kind
def test_eqn_A_1_a_vector_is_its_magnitude_times_its_direction(kind):
    P, _, _ = vectors(kind)
    assert close(P.norm() * P.direction(), P, tolerance(kind))
    assert close(P.direction().norm(), 1, tolerance(kind))
    with pytest.raises(FrameError, match="zero vector has no direction"):
        (P - P).direction()


@every_kind
def test_eqn_A_2_dot_product_is_magnitudes_times_cosine(kind):
    P, Q, _ = vectors(kind)
    assert close(dot(P, Q), P.norm() * Q.norm() * cos(P.angle_to(Q)), 10 * tolerance(kind))


@every_kind
def test_eqn_A_3_and_A_5_products_of_the_unit_vectors(kind):
    one = numbers(kind, 1) if kind != "array" else np.ones(3)
    i, j, k = ground.vector(one, 0, 0), ground.vector(0, one, 0), ground.vector(0, 0, one)
    assert close([[e.dot(f) for f in (i, j, k)] for e in (i, j, k)], ((1, 0, 0), (0, 1, 0), (0, 0, 1)), 0)
    for e, f, g in ((i, j, k), (j, k, i), (k, i, j)):
        assert close(e.cross(f), g, 0)
        assert close(f.cross(e), -g, 0)
        assert close(e.cross(e), (0, 0, 0), 0)


@every_kind
def test_eqn_A_4_cross_product_is_normal_to_both_and_measures_the_area(kind):
    P, Q, _ = vectors(kind)
    product = cross(P, Q)
    assert close((product.dot(P), product.dot(Q)), (0, 0), tolerance(kind))
    assert close(product.norm(), P.norm() * Q.norm() * sin(P.angle_to(Q)), 10 * tolerance(kind))
    assert close(product, -cross(Q, P), 0)


@every_kind
def test_eqn_A_6_to_A_10_components_are_projections_and_add(kind):
    P, Q, _ = vectors(kind)
    i, j, k = ground.i, ground.j, ground.k
    assert close((P.dot(i), P.dot(j), P.dot(k)), P.components(), 0)  # A.7
    assert close(P.x * i + P.y * j + P.z * k, P, 0)  # A.6, A.8
    assert close(P + Q, (P.x + Q.x, P.y + Q.y, P.z + Q.z), 0)  # A.9, A.10


@every_kind
def test_eqn_A_11_and_A_12_dot_product_and_magnitude_in_components(kind):
    P, Q, _ = vectors(kind)
    tilted = ground.rotate("tilted", numbers(kind, 1, 2, 2), numbers(kind, "0.8"))  # the same in any frame
    assert close(P.dot(Q), sum(p * q for p, q in zip(P.components(tilted), Q.components(tilted), strict=True)), tolerance(kind))
    assert close(P.dot(P), P.norm() ** 2, tolerance(kind))


@every_kind
def test_eqn_A_13_and_A_14_cross_product_is_the_determinant(kind):
    P, Q, _ = vectors(kind)
    (a, b, c), (d, e, f) = P, Q
    assert close(P.cross(Q), (b * f - c * e, -(a * f - c * d), a * e - b * d), 0)
    tilted = ground.rotate("tilted 2", "y", numbers(kind, "0.8"))
    assert close(P.expressed_in(tilted).cross(Q.expressed_in(tilted)), P.cross(Q).expressed_in(tilted), tolerance(kind))


@every_kind
def test_eqn_A_15_triple_scalar_product_is_cyclic(kind):
    P, Q, R = vectors(kind)
    assert close(P.dot(Q.cross(R)), Q.dot(R.cross(P)), tolerance(kind))
    assert close(P.dot(Q.cross(R)), R.dot(P.cross(Q)), tolerance(kind))


@every_kind
def test_eqn_A_16_triple_vector_product(kind):
    P, Q, R = vectors(kind)
    assert close(P.cross(Q).cross(R), R.dot(P) * Q - R.dot(Q) * P, tolerance(kind))
    assert not close(P.cross(Q).cross(R), P.cross(Q.cross(R)), 1e-3)


# -- derivatives


@every_kind
def test_eqn_A_17_rate_is_the_limit_of_differences(kind):
    P, _, _, t = functions(kind)
    rate = vector_at(P, t).rate(ground)
    errors = []
    for dt in (mp.mpf(10) ** -4, mp.mpf(10) ** -4 / 2):
        dt = float(dt) if kind in ("float", "array") else dt if kind == "mpmath" else sympy.Rational(str(float(dt)))
        difference = (vector_at(P, t + dt) - vector_at(P, t)) / dt
        errors.append(number((difference - rate).norm()))
    ratio = errors[0] / errors[1]
    assert close(ratio, 2 + 0 * ratio, 1e-3)  # first order in dt


@every_kind
def test_eqn_A_18_to_A_21_product_rules(kind):
    P, Q, u, t = functions(kind)
    p, q, v = vector_at(P, t), vector_at(Q, t), at(u, t)
    dp, dq = p.rate(ground), q.rate(ground)

    def written_out(components):
        return tuple(at(f, t).rate for f in components)

    assert close((p + q).rate(ground), written_out([lambda s, n=n: P[n](s) + Q[n](s) for n in range(3)]), tolerance(kind))
    assert close((v * p).rate(ground), written_out([lambda s, n=n: u(s) * P[n](s) for n in range(3)]), tolerance(kind))
    assert close((v * p).rate(ground), v.value * dp + v.rate * p, tolerance(kind))
    product = at(lambda s: P[0](s) * Q[0](s) + P[1](s) * Q[1](s) + P[2](s) * Q[2](s), t)
    assert close(p.dot(dq) + q.dot(dp), product.rate, tolerance(kind))
    crossed = [lambda s, n=n, m=(n + 1) % 3, k=(n + 2) % 3: P[m](s) * Q[k](s) - P[k](s) * Q[m](s) for n in range(3)]
    assert close(p.cross(q).rate(ground), written_out(crossed), tolerance(kind))
    assert close(p.cross(q).rate(ground), p.cross(dq) + dp.cross(q), tolerance(kind))


@every_kind
def test_eqn_A_22_gradient_of_the_examples_of_the_problems(kind):
    x, y, z = numbers(kind, 1, -1, 2)
    at_point = gradient(lambda x, y, z: -(x * y * y + y * z * z + z * x * x), ground.point("P", x, y, z))
    assert close(at_point, (-(y * y + 2 * z * x), -(2 * x * y + z * z), -(2 * y * z + x * x)), tolerance(kind))


def test_angle_between_nearly_parallel_vectors_keeps_its_digits():
    small = 1e-9
    P, Q = ground.vector(1.0, 0, 0), ground.vector(math.cos(small), math.sin(small), 0)
    assert abs(P.angle_to(Q) / small - 1) < 1e-15
    assert math.acos(P.dot(Q)) == 0.0  # the textbook formula loses it

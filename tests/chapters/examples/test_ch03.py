"""The worked examples of chapter 3, over every kind of number."""

import pytest

from newton_euler import Frame, at, cos, exp, pi, sin, sqrt
from newton_euler.algebra import SingularError
from newton_euler.chapters.examples import ch03
from newton_euler.kinematics import T_theta, apply, frenet_along, transpose
from tests.kinds import close, every_kind, numbers, small

ground = Frame("ground")


@every_kind
def test_example_3_1_exponential_curve_at_constant_speed(kind):
    q, speed = numbers(kind, "0.4", 3)
    P = ch03.point_on_exponential_curve(ground, q, speed)
    length = sqrt(exp(2 * q) + cos(q) ** 2 + 4 * q**2)
    along = [speed * x / length for x in (exp(q), cos(q), 2 * q)]
    assert close(P.velocity(ground), along, small(kind, 0.02))
    assert close(P.velocity(ground).dot(P.acceleration(ground)), 0, small(kind, 0.2))


@every_kind
def test_example_3_2_spring_drawn_out_keeps_a_finite_torsion(kind):
    """The book's is infinite when straight; it goes to 1/wire, and straight there is none."""
    R, c, theta = numbers(kind, "1.2", "0.5", "0.7")
    spring = ch03.Spring(R, c)
    here = spring.intrinsic(theta, ground)
    assert close((here.flexure, here.torsion), (spring.flexure, spring.torsion), small(kind, 0.02))
    assert close(here.speed, spring.wire, small(kind, 0.02))
    drawn = ch03.Spring.drawn_out(
        numbers(kind, 5), numbers("mpmath" if kind == "mpmath" else "float", "1.5707963")
    )
    assert close(drawn.torsion, -1 / drawn.wire, 1e-7)
    assert close(drawn.flexure, 0, 1e-7)
    flat = ch03.Spring.drawn_out(numbers(kind, 5), 0)
    assert close((flat.flexure, flat.torsion), (1 / flat.wire, 0), small(kind, 0.02))
    with pytest.raises(SingularError, match="straight here"):
        ch03.Spring(0.0, 5.0).intrinsic(0.7, ground)


@every_kind
def test_example_3_3_cable_at_rest_in_a_horizontal_plane(kind):
    """The load found balances -d(T e_t)/ds, differentiated in rectangular components."""
    q = numbers(kind, "0.6")
    path = lambda q: (q, q * q / 2, 0)
    tension = lambda q: 5 + q**3
    load = ch03.cable_load(path, tension, q, ground)
    pull = [at(lambda s, n=n: tension(s) * (1, s)[n] / sqrt(1 + s * s), q).rate for n in (0, 1)]
    ds = sqrt(1 + q * q)
    assert close(load.components(ground), (-pull[0] / ds, -pull[1] / ds, 0), small(kind, 0.02))
    flexure = frenet_along(path, q, ground).flexure
    left = ch03.cable_residuals(tension(q), 3 * q**2 / ds, flexure, load.components())
    assert close(left, (0, 0, 0), small(kind, 0.02))


def jack_after_one_turn(kind):
    """Arm, lead and K, the time of one turn from rest, and the point A then."""
    a, lead, K = numbers(kind, "0.4", "0.05", 2)
    t = ch03.screw_jack_time(1, K)
    return a, lead, K, t, ch03.screw_jack_ball(ground, a, K, lead, t)


@every_kind
def test_example_3_6_screw_jack(kind):
    a, lead, K, t, A = jack_after_one_turn(kind)
    p, angle, tiny = pi(K), A.coordinates[1], small(kind, 0.02)
    turned = 2 * sqrt(p / K), 2 * p, 2 * sqrt(p * K)
    assert close((t, angle.value, angle.rate), turned, tiny)
    v, acc = A.velocity(ground), A.acceleration(ground)
    assert close(v, (0, 2 * a * sqrt(p * K), lead * sqrt(K / p)), tiny)
    assert close(v.norm(), sqrt(K / p) * sqrt(4 * p**2 * a**2 + lead**2), tiny)
    assert close(acc, (-4 * p * a * K, a * K, lead * K / (2 * p)), small(kind, 0.2))
    size = a * K * sqrt(1 + 16 * p**2 + lead**2 / (4 * p**2 * a**2))
    assert close(acc.norm(), size, small(kind, 0.2))


@every_kind
def test_example_3_9_1_screw_jack_in_rectangular_components(kind):
    """The book keeps the angle general, as here, though its values belong to one turn, as there."""
    a, lead, K, _, A = jack_after_one_turn(kind)
    p, angle = pi(K), numbers(kind, "0.7")
    c, s, back = cos(angle), sin(angle), transpose(T_theta(angle))
    v, acc = A.velocity(ground), A.acceleration(ground)
    across, up, up_rate = 2 * a * sqrt(p * K), lead * sqrt(K / p), lead * K / (2 * p)
    assert close(apply(back, v), (-across * s, across * c, up), small(kind, 0.02))
    turned = a * K * (-4 * p * c - s), a * K * (-4 * p * s + c), up_rate
    assert close(apply(back, acc), turned, small(kind, 0.2))
    assert close(v.components(ground), (0, across, up), small(kind, 0.2))
    assert close(acc.components(ground), (-4 * p * a * K, a * K, up_rate), small(kind, 0.6))


@every_kind
def test_example_3_9_2_a_velocity_in_three_systems(kind):
    nu, theta, phi = numbers(kind, 5, "0.7", "0.4")
    _, cylindrical_, spherical_ = ch03.three_systems((nu, 0, 0), theta, phi)
    r, theta = nu * cos(theta), -nu * sin(theta)
    assert close(cylindrical_, (r, theta, 0), small(kind, 0.02))
    assert close(spherical_, (r * cos(phi), theta, -r * sin(phi)), small(kind, 0.02))

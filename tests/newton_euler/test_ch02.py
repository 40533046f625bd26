"""Chapters 1 and 2: every numbered equation over every kind of number."""

import mpmath as mp
import pytest
import sympy

from newton_euler import Frame, at, cos, frenet, moving, polar, sin
from newton_euler.kinematics import along, frenet_along
from tests.explicit import explicit, polar_position
from tests.kinds import KINDS, close, numbers

every_kind = pytest.mark.parametrize("kind", KINDS)
ground = Frame("ground")


def tolerance(kind):
    return 2e-14 if kind in ("float", "array") else mp.mpf(10) ** -26


def curve(kind):
    """A plane curve with its first and second derivative written out by hand, and the instant."""
    a, t = numbers(kind, "0.3", "0.7")
    return (
        lambda t: (t * t, a * t**3 + t, 0), lambda t: (2 * t, 3 * a * t**2 + 1, 0), lambda t: (2, 6 * a * t, 0), t,
    )  # fmt: skip


# -- chapter 1


@every_kind
def test_eqn_1_1_to_1_3_position_velocity_acceleration_by_successive_differentiation(kind):
    r, v, a, t = curve(kind)
    P = ground.point("P", *along(r, t))
    assert close(P.position(ground), r(t), tolerance(kind))
    assert close(P.velocity(ground), v(t), tolerance(kind))
    assert close(P.acceleration(ground), a(t), tolerance(kind))
    assert close(P.position(ground).rate(ground), P.velocity(ground), 0)
    assert close(P.velocity(ground).rate(ground), P.acceleration(ground), 0)


@every_kind
def test_eqn_1_2_velocity_is_tangent_to_the_path_and_the_limit_of_differences(kind):
    r, _, _, t = curve(kind)
    P = ground.point("P", *along(r, t))
    dt = numbers("mpmath" if kind == "mpmath" else "float", "1e-6") if kind != "sympy" else sympy.Rational(1, 10**6)
    chord = ground.vector(*(x - y for x, y in zip(r(t + dt), r(t), strict=True)))
    assert close(chord.angle_to(P.velocity(ground)), 0, 1e-5)
    assert close(chord / dt, P.velocity(ground), 1e-5)


def test_section_1_2_a_merry_go_round_horse_moves_differently_for_each_observer():
    platform = ground.rotate("platform", "z", 0.4, 0.5)
    rider = platform.translate("rider", platform.point("saddle", 3.0, 0, moving(1.0, 0.2, -0.7)))
    nose = rider.point("nose", 0, 0.5, 0.3)
    assert nose.velocity(rider).norm() == 0
    assert close(nose.velocity(platform), (0, 0, 0.2), 0)
    assert close(nose.velocity(ground).components(platform), (-0.25, 1.5, 0.2), 1e-15)


# -- rectangular and tangential-normal components


@every_kind
def test_eqn_2_1_to_2_3_rectangular_components_are_differentiated_one_by_one(kind):
    q, d, e = numbers(kind, "1.3", "0.7"), numbers(kind, "0.5", "-0.9"), numbers(kind, "0.3", "0.8")
    P = ground.point("P", *(moving(*x) for x in zip(q, d, e, strict=True)), 0)
    assert close(P.position(ground), (*q, 0), 0)
    assert close(P.velocity(ground), (*d, 0), 0)
    assert close(P.acceleration(ground), (*e, 0), 0)


@every_kind
def test_eqn_2_4_2_5_2_14_velocity_along_the_tangent_and_its_rate(kind):
    r, v, a, t = curve(kind)
    P = ground.point("P", *along(r, t))
    here = frenet(P.velocity(ground), P.acceleration(ground))
    assert close(here.velocity, (here.speed, 0, 0), 0)
    assert close((here.speed * here.e_t).components(ground), v(t), tolerance(kind))
    assert close(here.acceleration.components(ground), a(t), tolerance(kind))
    with_jerk = frenet_along(r, t, ground)  # then e_t' is known, and (2.5) is the product rule
    assert close(with_jerk.velocity.rate(ground), with_jerk.acceleration, tolerance(kind))
    assert close(with_jerk.acceleration, with_jerk.speed_rate * with_jerk.e_t + with_jerk.speed * with_jerk.e_t.rate(ground), tolerance(kind))


@every_kind
@pytest.mark.parametrize("sense", [1, -1])
def test_eqn_2_6_to_2_11_the_triad_turns_with_the_direction_of_travel(kind, sense):
    """theta(t), the angle of e_t: e_n is its normal on the concave side, for either sense of turning, and e_t' = |theta'| e_n."""
    c, t = numbers(kind, "0.8", "0.6")

    def theta(t):
        return sense * c * t * t

    def speed(t):
        return 2 + sin(t)

    v = ground.vector(at(lambda s: speed(s) * cos(theta(s)), t), at(lambda s: speed(s) * sin(theta(s)), t), 0)
    here = frenet(v, v.rate(ground), v.rate(ground).rate(ground))
    angle, turning = theta(t), sense * 2 * c * t
    assert close(here.e_t.components(ground), (cos(angle), sin(angle), 0), tolerance(kind))
    assert close(here.e_n.components(ground), (-sense * sin(angle), sense * cos(angle), 0), tolerance(kind))  # 2.6, 2.8
    assert close(here.e_t.rate(ground).components(), (0, sense * turning, 0), tolerance(kind))  # 2.7, 2.9, 2.10
    assert close(here.acceleration, (at(speed, t).rate, speed(t) * sense * turning, 0), tolerance(kind))  # 2.11
    assert close(here.radius, speed(t) / (sense * turning), 10 * tolerance(kind))  # 2.12


@every_kind
def test_eqn_2_12_radius_of_curvature_is_that_of_the_circle(kind):
    R, w, t = numbers(kind, "2.5", "-0.8", "0.3")
    here = frenet_along(lambda t: (R * cos(w * t), R * sin(w * t), 0), t, ground)
    assert close(here.radius, R, tolerance(kind))
    assert close(here.acceleration.terms["normal"].norm(), here.speed**2 / R, tolerance(kind))


@every_kind
def test_eqn_2_13_radius_of_curvature_of_a_graph(kind):
    x = numbers(kind, "0.7")
    here = frenet_along(lambda x: (x, x**3 - 2 * x, 0), x, ground)
    assert close(here.radius**2, (1 + (3 * x**2 - 2) ** 2) ** 3 / (6 * x) ** 2, 10 * tolerance(kind))


# -- polar components


@every_kind
def test_eqn_2_15_to_2_18_polar_components(kind):
    (r, theta), (dr, w), (ddr, al) = numbers(kind, "1.3", "0.7"), numbers(kind, "0.5", "-0.9"), numbers(kind, "0.3", "0.8")
    P = polar(ground, "P", moving(r, dr, ddr), moving(theta, w, al))
    e_r, e_theta = P.local.i, P.local.j
    assert close(P.position(ground), (r * e_r).expressed_in(ground), tolerance(kind))  # 2.15
    assert close(e_r.rate(ground), w * e_theta, 0)  # 2.16
    assert close(e_theta.rate(ground), -w * e_r, 0)
    assert close(P.velocity(ground), (dr, r * w, 0), tolerance(kind))  # 2.17
    assert close(P.acceleration(ground), (ddr - r * w**2, 2 * dr * w + r * al, 0), tolerance(kind))  # 2.18
    zero = 0 * r
    for order, vector in ((1, P.velocity(ground)), (2, P.acceleration(ground))):
        known = explicit(polar_position, order)(kind, (r, theta, zero), (dr, w, zero), (ddr, al, zero))
        assert close(vector.components(ground), known, tolerance(kind))


# -- frames in relative motion


@every_kind
def test_eqn_2_19_to_2_22_basic_kinematic_equation_in_the_plane(kind):
    theta, w, al = numbers(kind, "0.7", "-0.9", "0.4")
    moved = ground.rotate("moved", "z", theta, w, al)
    omega = moved.angular_velocity(ground)
    assert close(omega.components(ground), (0, 0, w), 0)  # 2.19
    for e in (moved.i, moved.j, moved.k):  # 2.20, 2.21
        assert close(e.rate(ground), omega.cross(e), 0)
    turned = [at(lambda s, f=f: f(theta + w * s), 0 * w).rate for f in (cos, sin)]  # of cos theta I + sin theta J, written out
    assert close(moved.i.rate(ground).components(ground), (*turned, 0), tolerance(kind))
    x, y, dx, dy = numbers(kind, "1.5", "-0.3", "0.2", "0.6")
    Q = moved.vector(moving(x, dx), moving(y, dy), 0)
    assert close(Q.rate(ground), Q.rate(moved) + omega.cross(Q), tolerance(kind))  # 2.22
    assert close(omega.rate(ground), moved.angular_acceleration(ground), 0)  # 2.26
    assert close(omega.rate(moved), omega.rate(ground), 0)


def test_section_2_8_plane_rotations_commute_and_angular_velocities_add():
    first, second = ground.rotate("a", "z", 0.3, 0.5), ground.rotate("b", "z", 1.1, -0.2)
    both, other = first.rotate("ab", "z", 1.1, -0.2), second.rotate("ba", "z", 0.3, 0.5)
    assert close(both.rotation(ground), other.rotation(ground), 1e-15)
    assert close(both.angular_velocity(ground).components(ground), (0, 0, 0.3), 1e-15)


@every_kind
def test_eqn_2_23_to_2_26_relative_velocity_and_acceleration(kind):
    """Against the position of A written out in the ground."""
    b, d, e, f = numbers(kind, "1.3", "0.5", "0.7", "-0.4")

    def theta(t):
        return b * t + e * t * t

    def origin(t):
        return d * t * t, sin(t), 0

    def place(t):
        return 1 + f * t, b * t**3, 0

    def written_out(t):
        (X, Y, _), (x, y, _) = origin(t), place(t)
        return X + cos(theta(t)) * x - sin(theta(t)) * y, Y + sin(theta(t)) * x + cos(theta(t)) * y, 0

    t = numbers(kind, "0.6")
    B = ground.point("B", *along(origin, t))
    body = ground.rotate("body", "z", at(theta, t), origin=B)
    A, known = body.point("A", *along(place, t)), ground.point("A", *along(written_out, t))
    omega, r = body.angular_velocity(ground), A.position(body)
    v_r, a_r = A.velocity(body), A.acceleration(body)
    assert close(A.position(ground), known.position(ground), tolerance(kind))
    assert close(A.velocity(ground), known.velocity(ground), 10 * tolerance(kind))
    assert close(A.velocity(ground), v_r + B.velocity(ground) + omega.cross(r), 10 * tolerance(kind))
    assert close(omega.rate(ground), omega.rate(body), tolerance(kind))  # (2.26)
    assert close(omega.rate(body), (0, 0, 2 * e), tolerance(kind))
    assert close(A.acceleration(ground), known.acceleration(ground), 10 * tolerance(kind))
    terms = a_r, omega.rate(ground).cross(r), 2 * omega.cross(v_r), omega.cross(omega.cross(r)), B.acceleration(ground)
    assert close(A.acceleration(ground), sum(terms), 10 * tolerance(kind))

"""Euler's equations (8.12)-(8.19): the moment for a motion, and the motion under a moment."""

import pytest

from newton_euler import Frame, Inertia, at, moving
from newton_euler.bodies import MassError, box, cylinder, rod
from newton_euler.dynamics import (
    angular_acceleration,
    angular_momentum,
    euler_moment,
    euler_moments,
    fixed_line_moment,
    fixed_line_momentum,
    planar_moment,
    resultant_force,
    resultant_moment,
)
from tests.kinds import every_kind, numbers, within
from tests.tumbling import close, free_body, turns

small = within(1e-12, 20)


@every_kind
def test_eqn_8_12_rate_of_h_by_way_of_the_body_and_of_a_frame_that_turns_otherwise(kind):
    ground, carrier, body, _, _ = free_body(kind)
    H, M, tiny = angular_momentum(body, ground), resultant_moment(body, ground), 10 * small(kind)
    for via in (body.frame, carrier):
        seen, Omega = H.expressed_in(via).rate(via), via.angular_velocity(ground)
        total = seen + Omega.cross(H)
        assert close(total.components(ground), M.components(ground), tiny)
        by_way = resultant_moment(body, ground, via=via)
        assert close(by_way.terms["relative"], seen, tiny)
        assert close(by_way.terms["rotation"], Omega.cross(H), tiny)
    omega, alpha = body.frame.angular_velocity(ground), body.frame.angular_acceleration(ground)
    assert close(euler_moment(body.inertia, omega, alpha), M, tiny)


def spinning_brick(kind):
    """A brick that turns in three ways about its centre of mass, in principal axes."""
    a, b, c, t = numbers(kind, "0.4", "-0.7", "1.1", "0.5")
    ground = frame = Frame("ground")
    for n, (axis, f) in enumerate(zip("zxy", turns(a, b, c), strict=True)):
        frame = frame.rotate(f"turn {n}", axis, at(f, t))
    return ground, box(*numbers(kind, 1, 2, 3), frame, mass=numbers(kind, 5))


@every_kind
def test_eqn_8_13_8_14_euler_s_equations(kind):
    ground, brick = spinning_brick(kind)
    omega, alpha = brick.frame.angular_velocity(ground), brick.frame.angular_acceleration(ground)
    M = euler_moments(brick.inertia, omega, alpha)
    assert close(M, resultant_moment(brick, ground), 10 * small(kind))
    (Ix, Iy, Iz), w, a = brick.inertia.moments, omega.components(), alpha.components()
    assert close(M.x, Ix * a[0] - (Iy - Iz) * w[1] * w[2], 10 * small(kind))
    assert close(M.y, Iy * a[1] - (Iz - Ix) * w[2] * w[0], 10 * small(kind))
    assert close(M.z, Iz * a[2] - (Ix - Iy) * w[0] * w[1], 10 * small(kind))
    assert close(M.terms["relative"] + M.terms["rotation"], M, small(kind))
    assert "equation (8.13)" in str(M.explain()) or kind == "array"


@every_kind
def test_eqn_8_12_solved_for_the_angular_acceleration(kind):
    """The moment for a motion gives alpha back, in principal axes and in others."""
    ground, brick = spinning_brick(kind)
    for body in (brick, free_body(kind)[2]):
        top = body.frame.tree[0] if body is not brick else ground
        omega, alpha = body.frame.angular_velocity(top), body.frame.angular_acceleration(top)
        found = angular_acceleration(body.inertia, omega, resultant_moment(body, top))
        assert close(found, alpha, 10 * small(kind))
        assert close(found.terms["moment"] + found.terms["gyroscopic"], found, small(kind))


@every_kind
def test_a_symmetric_body_in_the_frame_that_precesses_without_spinning(kind):
    """Here Omega != omega, and the formulas contain no spin angle."""
    psi, theta, spin, rate, nutation = numbers(kind, "0.3", "1.1", 7, "0.9", "-0.4")
    ground, tiny = Frame("ground"), 10 * small(kind)
    frame = ground.rotate("precessing", "z", psi, rate).rotate("nodes", "x", theta, nutation)
    spun = frame.rotate("spinning", "z", moving(psi, spin, rate))
    body = cylinder(*numbers(kind, 1, 3), spun, "z", mass=numbers(kind, 2))
    G = frame.point("G", 0, 0, 0)
    I = Inertia(frame, tuple(body.inertia.moments), mass=body.mass, centre=G)
    omega, alpha = spun.angular_velocity(ground), spun.angular_acceleration(ground)
    Omega = frame.angular_velocity(ground)
    M = euler_moment(I, omega, alpha, turning=Omega)
    assert close(M, resultant_moment(body, ground, via=frame), tiny)
    assert close(M, resultant_moment(body, ground).components(frame), tiny)
    back = angular_acceleration(I, omega, M, turning=Omega)
    assert close(back, alpha.components(frame), tiny)
    assert list(back.terms) == ["moment", "gyroscopic", "turning"]


@every_kind
def test_eqn_8_15_force_and_moment_of_a_body_are_those_of_its_particles(kind):
    ground, _, body, _, _ = free_body(kind)
    F = resultant_force(body.mass, body.centre.acceleration(ground))
    parts = [p.centre.acceleration(ground).expressed_in(ground) * p.mass for p in body.parts]
    assert close(F.components(ground), sum(parts[1:], parts[0]), 10 * small(kind))
    L = body.momentum(ground)
    assert close(L.rate(ground).components(ground), F.components(ground), 10 * small(kind))


@every_kind
def test_eqn_8_16_8_17_angular_momentum_of_a_rotation_about_a_fixed_line(kind):
    rate, acceleration = numbers(kind, "1.3", "-0.6")
    _, _, still, _, _ = free_body(kind)
    for axis in ("x", "y", "z", "-z"):
        ground = Frame("ground")
        frame = ground.rotate("shaft", axis, numbers(kind, "0.3"), rate, acceleration)
        I = Inertia(frame, still.inertia.moments, still.inertia.products)
        H = fixed_line_momentum(I, rate, axis)
        assert close(H, I.times(frame.angular_velocity(ground)), small(kind))
        M = fixed_line_moment(I, rate, acceleration, axis)
        assert close(M, I.times(frame.angular_velocity(ground)).rate(ground), small(kind))
        assert close(M.terms["relative"], I.times(frame.angular_acceleration(ground)), small(kind))
    (_, yz, zx), zz = I.products, I.moments[2]
    # (8.17) as printed
    assert close(fixed_line_momentum(I, rate), (-zx * rate, -yz * rate, zz * rate), small(kind))


@every_kind
def test_eqn_8_18_8_19_planar_motion(kind):
    w, a = numbers(kind, "1.3", "-0.6")
    ground = Frame("ground")
    frame = ground.rotate("link", "z", numbers(kind, "0.3"), w, a)
    G = frame.point("G", *numbers(kind, 1, "1/2", "1/3"))
    tilted = frame.rotate("tilted", (0 * w, 3 + 0 * w, 4 + 0 * w), numbers(kind, "0.7"))
    block = box(
        *numbers(kind, 1, 2, 3), tilted.point("G", *G.position(tilted)), mass=numbers(kind, 5)
    )
    I = block.about(G, frame)
    (_, yz, zx), zz = I.products, I.moments[2]
    M = fixed_line_moment(I, w, a)
    assert close(M, (-zx * a + yz * w * w, -yz * a - zx * w * w, zz * a), 10 * small(kind))
    assert close(M, resultant_moment(block, ground, via=frame), 10 * small(kind))
    flat = box(*numbers(kind, 1, 2, 3), frame, mass=numbers(kind, 5)).inertia
    assert close(planar_moment(flat, a), flat.moments[2] * a, small(kind))
    assert close(fixed_line_moment(flat, w, a), (0, 0, planar_moment(flat, a)), small(kind))


def test_bodies_without_a_moment_about_an_axis_are_refused_by_the_inverse():
    frame = Frame("rod")
    for inertia in (rod(1.0, frame, "x", mass=2.0).inertia, Inertia(frame, (0.0, 1.0, 1.0))):
        words = "has no inverse: about some axis the body has no moment of inertia"
        with pytest.raises(MassError, match=words):
            angular_acceleration(inertia, frame.vector(1.0, 0, 0), frame.vector(1.0, 2.0, 0))


def test_the_planar_equation_is_refused_where_products_are_left():
    I = Inertia(Frame("body"), (3.0, 3.0, 4.0), (0, 0.5, 1.0))
    words = (
        r"\(8\.19\) needs a principal axis along z, but .* I_yz = 0\.5, .*; take fixed_line_moment"
    )
    with pytest.raises(MassError, match=words):
        planar_moment(I, 2.0)
    assert planar_moment(Inertia(Frame("body"), (3.0, 3.0, 4.0), (1.0, 0, 1e-15)), 2.0) == 8.0

"""Chapter 8, (8.1)-(8.21) and its examples. The oracle is a body of mass points in explicit motion, differentiated numerically at 30 digits."""

from itertools import product as choices

import mpmath as mp
import numpy as np
import pytest
import sympy
from hypothesis import given, settings
from hypothesis import strategies as st

from newton_euler import Dimension, Frame, at, compiled, cos, moving, sin
from newton_euler.algebra.linear import solve_linear
from newton_euler.bodies.admissibility import MassError
from newton_euler.bodies.body import composite, particle
from newton_euler.bodies.inertia import Inertia
from newton_euler.bodies.solids import box, cylinder, disk, rod, sphere
from newton_euler.dynamics.angular_momentum import angular_momentum, equations_of_motion, resultant_moment
from newton_euler.dynamics.euler import angular_acceleration, euler_moment, euler_moments, fixed_line_moment, fixed_line_momentum, planar_moment
from newton_euler.dynamics.force_systems import ForceSystem
from newton_euler.dynamics.newton import resultant_force
from newton_euler.kinematics.rotations import rotation_matrix
from newton_euler.scenes.planar import rolling_contact, sliding_sphere
from tests import kinds
from tests.kinds import KINDS, number, numbers

every_kind = pytest.mark.parametrize("kind", KINDS)
MASSES = [(2, (1, "1/2", 0)), (1, (-1, 0, "1/3")), (3, (0, "-2/3", 1)), ("1/2", ("1/4", 1, -1)), (1, ("1/5", "1/5", "1/7"))]


def tolerance(kind):
    """Absolute, for quantities of order 10 to 100: some round-offs, or what numerical differentiation leaves of 50 digits."""
    return 1e-12 if kind in ("float", "array") else mp.mpf(10) ** -20


def close(a, b, tolerance):
    """As in tests.kinds, with SymPy's numbers evaluated from the inside out to 60 digits: evalf takes forever on nested sums."""
    if hasattr(a, "frame") and hasattr(b, "frame"):
        b = b.expressed_in(a.frame)
    return kinds.close(valued(a), valued(b), tolerance)


def valued(x):
    if hasattr(x, "frame") or isinstance(x, (tuple, list)):
        return tuple(valued(part) for part in x)
    return mp.mpf(sympy.Float(inside_out(x, {}), 40)._mpf_) if isinstance(x, sympy.Basic) else x


def inside_out(x, known):
    if x not in known:
        value = x.func(*(inside_out(a, known) for a in x.args)) if x.args else x
        known[x] = value if value.is_Integer or value.is_Rational else value.evalf(60)
    return known[x]


# -- a body of five particles in a motion without any special feature, by the engine and by the oracle


def turns(a, b, c):
    """The three angles of the body as functions of time."""
    return lambda t: a + b * t, lambda t: c + a * t * t, lambda t: b + c * t + t * t


def path(a, b, c):
    """Where the body's origin is: with an acceleration in all three components."""
    return lambda t: a * t * t + sin(b * t), lambda t: c * t + cos(a * t), lambda t: b * t * t * t


def free_body(kind):
    """ground, body, points to take moments about by name, and the numbers (a, b, c, t) of the motion."""
    a, b, c, t = q = numbers(kind, "0.4", "-0.7", "1.1", "0.5")
    ground = Frame("ground")
    frame = ground.rotate("1", "z", at(turns(a, b, c)[0], t), origin=ground.point("O", *(at(f, t) for f in path(a, b, c))))
    frame = frame.rotate("2", "x", at(turns(a, b, c)[1], t))
    carrier = frame
    frame = frame.rotate("body", (0, 3 + 0 * t, 4 + 0 * t), at(turns(a, b, c)[2], t))
    parts = [particle(numbers(kind, m), frame.point(f"P{n}", *numbers(kind, *x)), f"P{n}") for n, (m, x) in enumerate(MASSES)]
    body = composite("body", parts, frame=frame)
    points = {
        "body": frame.point("B", *numbers(kind, "1/2", -1, "1/3")),
        "rest": ground.point("C", *numbers(kind, 1, 2, -1)),
        "drift": ground.point("D", *(moving(x, x) for x in numbers(kind, 2, "1/3", -1))),
        "any": carrier.point("E", at(lambda s: b + s * s, t), at(lambda s: c * s * s * s, t), at(lambda s: sin(a * s), t)),
    }
    return ground, carrier, body, points, q


def instants(q):
    """The numbers of the motion as 30 digits, for each instant of an array."""
    if isinstance(q[0], np.ndarray):
        return [tuple(mp.mpf(x[n]) for x in q) for n in range(len(q[0]))]
    return [tuple(number(x) for x in q)]


def matrix_vector(R, x):
    return [sum(r * c for r, c in zip(row, x, strict=True)) for row in R]


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def scaled(s):
    """The numbers of the particles and points of instant ``s``: an array holds them times 1, 1.0625 and 0.875."""
    return lambda *values: [mp.mpf(sympy.Rational(str(v)).p) / sympy.Rational(str(v)).q * s for v in values]


class Oracle:
    """Explicit places of all particles and points as functions of time, at 50 digits."""

    def __init__(self, q, factor):
        self.q, self.make = q, scaled(factor)

    def place(self, x):
        """A point of the body at the time s: the origin's path plus three Rodrigues matrices."""
        a, b, c, _ = self.q
        x = self.make(*x)

        def where(s):
            v = x
            for axis, f in reversed(list(zip(((0, 0, 1), (1, 0, 0), (0, 3, 4)), turns(a, b, c), strict=True))):
                v = matrix_vector(rotation_matrix(tuple(mp.mpf(e) for e in axis), f(s)), v)
            return [p(s) + d for p, d in zip(path(a, b, c), v, strict=True)]

        return where

    def reference(self, name):
        a, b, c, t = self.q
        if name == "G":
            total = sum(m for (m,) in (self.make(m) for m, _ in MASSES))
            return lambda s: [sum(self.make(m)[0] * self.place(x)(s)[n] for m, x in MASSES) / total for n in range(3)]
        if name == "body":
            return self.place(("1/2", -1, "1/3"))
        if name == "rest":
            return lambda s: self.make(1, 2, -1)
        if name == "drift":
            return lambda s: [x + x * (s - t) for x in self.make(2, "1/3", -1)]

        def carried(s):
            v = [b + s * s, c * s * s * s, mp.sin(a * s)]
            for axis, f in reversed(list(zip(((0, 0, 1), (1, 0, 0)), turns(a, b, c)[:2], strict=True))):
                v = matrix_vector(rotation_matrix(tuple(mp.mpf(e) for e in axis), f(s)), v)
            return [p(s) + d for p, d in zip(path(a, b, c), v, strict=True)]

        return carried

    def derivative(self, f, order):
        with mp.workdps(60):
            return [mp.diff(lambda s, n=n: f(s)[n], self.q[3], order) for n in range(3)]

    def summed(self, about, order, differences):
        """The sum of d_i x m_i times the derivative of d_i (``differences``) or of the place of the particle."""
        B, total = self.reference(about), [mp.mpf(0)] * 3
        for m, x in MASSES:
            P = self.place(x)
            d = [p - b for p, b in zip(P(self.q[3]), B(self.q[3]), strict=True)]
            relative = lambda s, P=P: [p - b for p, b in zip(P(s), B(s), strict=True)]  # noqa: E731
            rate = self.derivative(relative if differences else P, order)
            (mass,) = self.make(m)
            total = [h + mass * y for h, y in zip(total, cross(d, rate), strict=True)]
        return total


def expected(kind, q, about, order, differences):
    """The oracle at every instant, in components of the ground: three scalars or arrays."""
    factors = [1, mp.mpf("1.0625"), mp.mpf("0.875")] if kind == "array" else [1]
    with mp.workdps(50):
        found = [Oracle(now, s).summed(about, order, differences) for now, s in zip(instants(q), factors, strict=True)]
    return tuple(np.array([float(x) for x in row]) for row in zip(*found, strict=True)) if kind == "array" else found[0]


@every_kind
@pytest.mark.parametrize("about", ["G", "body", "rest", "any"])
def test_eqn_7_6_relative_angular_momentum_about_any_point_is_that_of_its_particles(kind, about):
    ground, _, body, points, q = free_body(kind)
    H = angular_momentum(body, ground, points.get(about))
    assert close(H.components(ground), expected(kind, q, about, 1, True), 10 * tolerance(kind))


@every_kind
@pytest.mark.parametrize("about", ["G", "body", "rest", "drift", "any"])
def test_eqn_8_8_8_9_8_10_8_11_moment_of_motion_about_any_point_is_that_of_the_particles(kind, about):
    """M_B = sum of d_i x m_i a_i (8.8), by differentiating the places twice, against DH/Dt + d x m a_B (8.9)."""
    ground, carrier, body, points, q = free_body(kind)
    by_particles = expected(kind, q, about, 2, False)
    for via in (None, carrier, ground):
        M = resultant_moment(body, ground, points.get(about), via)
        assert close(M.components(ground), by_particles, 10 * tolerance(kind))
        if kind == "sympy":
            continue  # the formula of H differentiated term by term is long; the other kinds show that it agrees
        H, via = angular_momentum(body, ground, points.get(about)), via or body.frame
        assert close(M.terms["relative"], H.expressed_in(via).rate(via), 10 * tolerance(kind))
        assert close(M.terms["rotation"], via.angular_velocity(ground).cross(H), 10 * tolerance(kind))
        assert close(sum(list(M.terms.values())[1:], M.terms["relative"]), M, 10 * tolerance(kind))
        assert list(M.terms) == (["relative", "rotation"] if about == "G" else ["relative", "rotation", "reference"])


def test_the_reference_term_matters_except_in_the_three_cases_of_the_book():
    ground, _, body, points, _ = free_body("float")
    for name, point in points.items():
        reference = resultant_moment(body, ground, point).terms["reference"]
        assert (reference.norm() > 1) == (name in ("body", "any"))
    G, toward = body.centre, ground.point("on the line of a_G", *(moving(0.0, 0.0, 2 * x) for x in (1.0, 2.0, 3.0)))
    shifted = ground.point("G", *(moving(x, 0.1, 0.2) for x in (0.5, 1.0, 1.5)))
    ball = sphere(1.0, shifted, mass=2.0)
    along = resultant_moment(ball, ground, toward).terms["reference"]  # d parallel to a_B
    assert along.norm() < 1e-12
    assert G is not shifted


@every_kind
def test_eqn_8_1_to_8_3_places_and_rates_relative_to_b(kind):
    ground, _, body, points, _ = free_body(kind)
    B, G = points["any"], body.centre
    for part in body.parts:
        P = part.centre
        d, d_G, rho = (v.expressed_in(ground) for v in (P - B, G - B, P - G))
        assert close(d, d_G + rho, tolerance(kind))
        assert close((P - B).rate(ground).components(ground), (P.velocity(ground).expressed_in(ground) - B.velocity(ground)), 10 * tolerance(kind))
        second = (P - B).rate(ground).rate(ground)
        assert close(second.components(ground), P.acceleration(ground).expressed_in(ground) - B.acceleration(ground), 10 * tolerance(kind))


@every_kind
def test_eqn_8_12_rate_of_h_by_way_of_the_body_and_of_a_frame_that_turns_otherwise(kind):
    ground, carrier, body, _, _ = free_body(kind)
    H = angular_momentum(body, ground)
    for via in (body.frame, carrier):
        seen, Omega = H.expressed_in(via).rate(via), via.angular_velocity(ground)
        total = seen + Omega.cross(H)
        assert close(total.components(ground), resultant_moment(body, ground).components(ground), 10 * tolerance(kind))
        M = resultant_moment(body, ground, via=via)
        assert close(M.terms["relative"], seen, 10 * tolerance(kind))
        assert close(M.terms["rotation"], Omega.cross(H), 10 * tolerance(kind))
    omega, alpha = body.frame.angular_velocity(ground), body.frame.angular_acceleration(ground)
    assert close(euler_moment(body.inertia, omega, alpha), resultant_moment(body, ground), 10 * tolerance(kind))


def spinning_brick(kind):
    """A brick that turns in three ways about its mass centre, in principal axes."""
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
    assert close(M, resultant_moment(brick, ground), 10 * tolerance(kind))
    (Ix, Iy, Iz), w, a = brick.inertia.moments, omega.components(), alpha.components()
    assert close(M.x, Ix * a[0] - (Iy - Iz) * w[1] * w[2], 10 * tolerance(kind))
    assert close(M.y, Iy * a[1] - (Iz - Ix) * w[2] * w[0], 10 * tolerance(kind))
    assert close(M.z, Iz * a[2] - (Ix - Iy) * w[0] * w[1], 10 * tolerance(kind))
    assert close(M.terms["relative"] + M.terms["rotation"], M, tolerance(kind))
    assert "equation (8.13)" in str(M.explain()) or kind == "array"


@every_kind
def test_eqn_8_12_solved_for_the_angular_acceleration(kind):
    """Both directions: the moment of a motion gives its angular acceleration back, in principal axes and others."""
    ground, brick = spinning_brick(kind)
    for body in (brick, free_body(kind)[2]):
        top = body.frame.tree[0] if body is not brick else ground
        omega, alpha = body.frame.angular_velocity(top), body.frame.angular_acceleration(top)
        found = angular_acceleration(body.inertia, omega, resultant_moment(body, top))
        assert close(found, alpha, 10 * tolerance(kind))
        assert close(found.terms["moment"] + found.terms["gyroscopic"], found, tolerance(kind))


@every_kind
def test_a_symmetric_body_in_the_frame_that_precesses_without_spinning(kind):
    """Omega != omega: the matrix stays the same in that frame, where the formulas have no spin angle."""
    psi, theta, spin, rate, nutation = numbers(kind, "0.3", "1.1", 7, "0.9", "-0.4")
    ground = Frame("ground")
    frame = ground.rotate("precessing", "z", psi, rate).rotate("nodes", "x", theta, nutation)
    body = cylinder(*numbers(kind, 1, 3), frame.rotate("spinning", "z", moving(psi, spin, rate)), "z", mass=numbers(kind, 2))
    I = Inertia(frame, tuple(body.inertia.moments), mass=body.mass, centre=frame.point("G", 0, 0, 0))
    omega, alpha, Omega = body.frame.angular_velocity(ground), body.frame.angular_acceleration(ground), frame.angular_velocity(ground)
    M = euler_moment(I, omega, alpha, turning=Omega)
    assert close(M, resultant_moment(body, ground, via=frame), 10 * tolerance(kind))
    assert close(M, resultant_moment(body, ground).components(frame), 10 * tolerance(kind))
    back = angular_acceleration(I, omega, M, turning=Omega)
    assert close(back, alpha.components(frame), 10 * tolerance(kind))
    assert list(back.terms) == ["moment", "gyroscopic", "turning"]


@every_kind
def test_eqn_8_15_force_and_moment_of_a_body_are_those_of_its_particles(kind):
    ground, _, body, _, _ = free_body(kind)
    F = resultant_force(body.mass, body.centre.acceleration(ground))
    parts = [part.centre.acceleration(ground).expressed_in(ground) * part.mass for part in body.parts]
    assert close(F.components(ground), sum(parts[1:], parts[0]), 10 * tolerance(kind))
    L = body.momentum(ground)
    assert close(L.rate(ground).components(ground), F.components(ground), 10 * tolerance(kind))


@every_kind
def test_eqn_8_16_8_17_angular_momentum_of_a_rotation_about_a_fixed_line(kind):
    rate, acceleration = numbers(kind, "1.3", "-0.6")
    _, _, still, _, _ = free_body(kind)
    for axis in ("x", "y", "z", "-z"):
        ground = Frame("ground")
        frame = ground.rotate("shaft", axis, numbers(kind, "0.3"), rate, acceleration)
        I = Inertia(frame, still.inertia.moments, still.inertia.products)
        H = fixed_line_momentum(I, rate, axis)
        assert close(H, I.times(frame.angular_velocity(ground)), tolerance(kind))
        M = fixed_line_moment(I, rate, acceleration, axis)
        assert close(M, I.times(frame.angular_velocity(ground)).rate(ground), tolerance(kind))
        assert close(M.terms["relative"], I.times(frame.angular_acceleration(ground)), tolerance(kind))
    (_, yz, zx), zz = I.products, I.moments[2]
    assert close(fixed_line_momentum(I, rate), (-zx * rate, -yz * rate, zz * rate), tolerance(kind))  # (8.17) as printed


@every_kind
def test_eqn_8_18_8_19_planar_motion(kind):
    w, a = numbers(kind, "1.3", "-0.6")
    ground = Frame("ground")
    frame = ground.rotate("link", "z", numbers(kind, "0.3"), w, a)
    G = frame.point("G", *numbers(kind, 1, "1/2", "1/3"))
    tilted = frame.rotate("tilted", (0 * w, 3 + 0 * w, 4 + 0 * w), numbers(kind, "0.7"))
    block = box(*numbers(kind, 1, 2, 3), tilted.point("G", *G.position(tilted)), mass=numbers(kind, 5))
    I = block.about(G, frame)
    (_, yz, zx), zz = I.products, I.moments[2]
    M = fixed_line_moment(I, w, a)
    assert close(M, (-zx * a + yz * w * w, -yz * a - zx * w * w, zz * a), 10 * tolerance(kind))
    assert close(M, resultant_moment(block, ground, via=frame), 10 * tolerance(kind))
    flat = box(*numbers(kind, 1, 2, 3), frame, mass=numbers(kind, 5)).inertia
    assert close(planar_moment(flat, a), flat.moments[2] * a, tolerance(kind))
    assert close(fixed_line_moment(flat, w, a), (0, 0, planar_moment(flat, a)), tolerance(kind))


@every_kind
def test_eqn_8_21_newton_euler_equations_vanish_for_the_forces_of_the_motion(kind):
    """Each particle is carried by its own force m_i a_i: their system gives the motion of the body, about any point."""
    ground, _, body, points, _ = free_body(kind)
    forces = ForceSystem({p.name: (p.centre.acceleration(ground) * p.mass, p.centre) for p in body.parts}, ground)
    for about in (None, *points.values()):
        for v in equations_of_motion(body, forces, ground, about).values():
            assert close(v, (0, 0, 0), 10 * tolerance(kind))
    names = list(equations_of_motion(body, forces, ground, points["rest"]))
    assert names == ["force on body", "moment on body about C"]


@settings(max_examples=15, deadline=None)
@given(st.lists(st.floats(-3, 3), min_size=9, max_size=9))
def test_moments_about_two_points_differ_by_the_force_at_the_one(values):
    """M_B - M_C = CB x F for any motion: (8.20) and (8.9) together, whatever the two points do."""
    ground, _, body, points, _ = free_body("float")
    x = [moving(*values[n : n + 3]) for n in (0, 3, 6)]
    B, C = ground.point("B", *x), points["any"]
    F = resultant_force(body.mass, body.centre.acceleration(ground)).expressed_in(ground)
    difference = resultant_moment(body, ground, B).expressed_in(ground) - resultant_moment(body, ground, C)
    assert close(difference, (C - B).expressed_in(ground).cross(F), 1e-9)


def test_momentum_and_moments_have_their_units_and_can_be_compiled():
    def moments(m, length, w, a):
        ground = Frame("ground")
        frame = ground.rotate("bar", "z", 0.3, w, a)
        bar = rod(length, frame.point("G", length, 0, 0), "x", mass=m)
        B = frame.point("B", length, length, length)
        return angular_momentum(bar, ground, B), resultant_moment(bar, ground, B), resultant_moment(bar, ground)

    M, L, T = Dimension(1), Dimension(0, 1), Dimension(0, 0, 1)
    units = (M * L * L / T, M * L * L / (T * T), M * L * L / (T * T))
    for vector, unit in zip(moments(M, L, 1 / T, 1 / (T * T)), units, strict=True):
        assert all(x in (0, unit) for x in vector)
    numbers_ = (2.0, 0.5, 3.0, -1.0)
    assert close(compiled(moments)(*numbers_), [tuple(v) for v in moments(*numbers_)], 1e-13)


# -- 8.6: from sliding to rolling


@every_kind
def test_example_8_6_sphere_from_sliding_to_rolling(kind):
    v0, mu, g, r = numbers(kind, 7, "1/5", "9.81", "1/8")
    begins = sliding_sphere.rolling_begins(v0, mu, g, r)
    assert close(begins.t, 2 * v0 / (7 * mu * g), tolerance(kind))
    assert close(begins.v, 5 * v0 / 7, tolerance(kind))
    assert close(begins.omega, -5 * v0 / (7 * r), 100 * tolerance(kind))
    assert close(begins.x, v0 * begins.t - mu * g * begins.t * begins.t / 2, 10 * tolerance(kind))
    model = sliding_sphere.sliding(mu, g, r)
    start = (0 * v0, v0, 0 * v0)
    x, v, omega = model.solution(begins.t, start)
    assert close((x, v, omega), (begins.x, begins.v, begins.omega), 100 * tolerance(kind))
    (name,) = model.invariants
    assert close(model.invariant(name, (x, v, omega)), model.invariant(name, start), 10 * tolerance(kind))
    rolled = sliding_sphere.rolling(r)
    for name in rolled.invariants:
        assert close(rolled.invariant(name, rolled.solution(v0, (x, v, omega))), rolled.invariant(name, (x, v, omega)), 10 * tolerance(kind))
    assert close(rolled.invariant("slip", (x, v, omega)), 0, 100 * tolerance(kind))


def test_example_8_6_derives_its_accelerations_from_the_newton_euler_equations():
    m, r, mu, g, v = 3.0, 0.125, 0.2, 9.81, 4.0
    ground = Frame("ground")

    def laws(N, a, alpha):
        ball_frame = ground.rotate("ball", "z", rate=-2.0, acceleration=alpha, origin=ground.point("G", moving(1.0, v, a), r, 0))
        ball = sphere(r, ball_frame, mass=m)
        contact = ground.point("contact", 1.0, 0, 0)
        forces = {"weight": (ground.vector(0, -m * g, 0), ball.centre), "surface": (ground.vector(-mu * N, N, 0), contact)}
        return equations_of_motion(ball, forces, ground)

    s = solve_linear(laws)
    _, a, alpha = sliding_sphere.sliding(mu, g, r).derivative((1.0, v, -2.0))
    assert close((s.N, s.a, s.alpha), (m * g, a, alpha), 1e-12)


def test_the_exact_solution_agrees_with_an_integration_that_stops_at_the_event():
    from scipy.integrate import solve_ivp

    v0, mu, g, r, omega0 = 3.0, 0.3, 9.81, 0.2, 20.0  # with back spin
    rhs = sliding_sphere.sliding(mu, g, r).compiled_rhs()

    def slip(t, y):
        return y[1] + y[2] * r

    slip.terminal = True
    run = solve_ivp(lambda t, y: rhs(t, *y.tolist()), (0, 10), (0.0, v0, omega0), events=slip, rtol=1e-10, atol=1e-12)
    begins = sliding_sphere.rolling_begins(v0, mu, g, r, omega0)
    assert close((run.t[-1], *run.y[:, -1].tolist()), (begins.t, begins.x, begins.v, begins.omega), 1e-8)
    times = np.array([0.0, begins.t / 2, begins.t, begins.t + 1])
    x, v, omega = sliding_sphere.sphere_at(times, v0, mu, g, r, omega0)
    assert close((x[3] - x[2], v[3], omega[3]), (begins.v, begins.v, begins.omega), 1e-12)
    assert x[0] == 0
    assert v[0] == v0


def test_a_sphere_with_too_much_forward_spin_speeds_up():
    b = sliding_sphere.rolling_begins(1.0, 0.3, 9.81, 0.2, omega0=-30.0, sense=-1)
    assert b.t > 0
    assert b.v > 1.0
    assert sliding_sphere.rolling_begins(1.0, 0.3, 9.81, 0.2, omega0=-30.0).t < 0  # the wrong sense shows


# -- rolling with and without slip


@every_kind
def test_a_cylinder_on_an_accelerated_slab_rolls_if_the_friction_suffices(kind):
    """Problem 8/8: mu N >= m n g/3 lets it roll, with alpha = 2 n g/(3 r); the needed friction is a third of m n g."""
    m, r, g, n = numbers(kind, 2, "1/2", "9.81", 2)
    s = rolling_contact.rolling(m, r, m * r * r / 2, surface=n * g)
    assert close((s.a, s.alpha, s.friction), (n * g / 3, 2 * n * g / (3 * r), m * n * g / 3), 100 * tolerance(kind))
    low, high = numbers(kind, "1/2", "3/4")
    for mu, rolls in ((low, False), (high, True)):
        c = rolling_contact.contact(m, r, m * r * r / 2, m * g, mu, surface=n * g)
        if kind == "array":
            continue  # there the three slabs differ
        assert bool(c.rolls) is rolls
        assert close(c.alpha, 2 * n * g / (3 * r) if rolls else 2 * mu * g / r, 100 * tolerance(kind))


def test_many_contacts_at_once_choose_their_regime_one_by_one():
    mu = np.array([0.05, 0.5, 0.05])
    force = np.array([6.0, 6.0, -6.0])
    c = rolling_contact.contact(2.0, 0.5, 0.25, 19.62, mu, force=force)
    for n in range(3):
        one = rolling_contact.contact(2.0, 0.5, 0.25, 19.62, float(mu[n]), force=float(force[n]))
        assert bool(c.rolls[n]) == one.rolls
        assert close((c.a[n], c.alpha[n], c.friction[n]), (one.a, one.alpha, one.friction), 1e-13)
    assert c.rolls.tolist() == [False, True, False]
    assert np.all(c.friction * force < 0)


@settings(max_examples=60, deadline=None)
@given(st.floats(-20, 20), st.floats(-5, 5), st.floats(-3, 3), st.floats(0.01, 1.5), st.floats(0.5, 1.0))
def test_friction_obeys_coulomb_and_the_laws_of_motion_in_both_regimes(force, moment, surface, mu, ratio):
    m, r, I, N = 2.0, 0.5, 0.25, 19.62
    c = rolling_contact.contact(m, r, I, N, mu, mu * ratio, force, moment, surface)
    assert abs(m * c.a - force - c.friction) < 1e-12
    assert abs(I * c.alpha - moment - r * c.friction) < 1e-12
    starts = c.a + r * c.alpha - surface
    if c.rolls:
        assert abs(starts) < 1e-11
        assert abs(c.friction) <= mu * N
    else:
        assert abs(c.friction) == pytest.approx(mu * ratio * N)
        assert starts * c.friction <= 0  # the friction opposes the slip that begins


def test_a_body_that_slips_goes_on_slipping():
    for slip, sign in ((2.0, -1), (-2.0, 1)):
        c = rolling_contact.contact(2.0, 0.5, 0.25, 19.62, mu=0.5, mu_kinetic=0.4, slip=slip)
        assert not c.rolls
        assert c.friction == pytest.approx(sign * 0.4 * 19.62)


def test_what_a_contact_cannot_tell_is_said_in_words():
    with pytest.raises(rolling_contact.ContactError, match="the surface would have to pull, so the body has left it"):
        rolling_contact.contact(2.0, 0.5, 0.25, -1.0, 0.5)
    mu = sympy.Symbol("mu")
    with pytest.raises(rolling_contact.ContactError, match="which regime holds depends on values"):
        rolling_contact.contact(2.0, 0.5, 0.25, 19.62, mu)


# -- unknown accelerations and reactions


@every_kind
def test_problem_8_1_beam_whose_cable_breaks(kind):
    """Known in closed form: with the pin at k L, a_B = g (1/2 - k)(1 - k)/(1/12 + (1/2 - k)^2)."""
    W, g, L, k = numbers(kind, 10, "9.81", 2, "1/4")
    ground = Frame("ground")

    def laws(C_x, C_y, alpha):
        frame = ground.rotate("beam", "z", acceleration=alpha)
        beam = rod(L, frame.point("G", L / 2 - k * L, 0, 0), "x", mass=W / g, name="beam")
        return equations_of_motion(beam, {"weight": (ground.vector(0, -W, 0), beam.centre), "pin": (ground.vector(C_x, C_y, 0), frame)}, ground)

    s = solve_linear(laws)
    arm = L / 2 - k * L
    turning = W * arm / (W / g * (L * L / 12 + arm * arm))
    assert close((s.C_x, s.C_y, s.alpha), (0, W - W / g * turning * arm, -turning), 10 * tolerance(kind))


@every_kind
def test_problem_8_3_a_rod_on_two_guides_about_three_points(kind):
    """(8.9) about G, about the moving end A, and about the fixed corner O: one answer; the moment about A needs d x m a_A."""
    W, g, L = numbers(kind, 8, "32.2", 4)
    c, s_ = (numbers(kind, "4/5", "3/5")) if kind != "array" else (0.8, 0.6)
    ground = Frame("ground")
    O = ground.point("O", 0, 0, 0)

    def laws(about):
        def conditions(F_A, F_B, alpha):
            """The angle from the vertical grows by theta'' = alpha: A = (0, L cos), B = (L sin, 0) from rest."""
            A = ground.point("A", 0, moving(L * c, 0, -L * s_ * alpha), 0)
            B = ground.point("B", moving(L * s_, 0, L * c * alpha), 0, 0)
            G = ground.point("G", moving(L * s_ / 2, 0, L * c / 2 * alpha), moving(L * c / 2, 0, -L * s_ / 2 * alpha), 0)
            frame = ground.rotate("rod", "z", acceleration=alpha, origin=G)
            bar = box_like_rod(L, frame, W / g, c, s_)
            forces = {"weight": (ground.vector(0, -W, 0), G), "A": (ground.vector(F_A, 0, 0), A), "B": (ground.vector(0, F_B, 0), B)}
            return equations_of_motion(bar, forces, ground, {"G": None, "A": A, "O": O}[about])

        return solve_linear(conditions)

    expected_alpha = 3 * g * s_ / (2 * L)
    for about in ("G", "A", "O"):
        s = laws(about)
        assert close(s.alpha, expected_alpha, 10 * tolerance(kind))
        assert close(s.F_A, W / g * L * c / 2 * expected_alpha, 10 * tolerance(kind))
        assert close(s.F_B, W - W / g * L * s_ / 2 * expected_alpha, 10 * tolerance(kind))


def box_like_rod(L, frame, m, c, s):
    """A thin rod along (sin, -cos) of the frame, by its matrix about G."""
    from newton_euler.bodies.body import Body

    k = m * L * L / 12
    G = frame.point("G", 0, 0, 0)
    return Body("rod", m, G, Inertia(G, (k * c * c, k * s * s, k), (-k * s * c, 0, 0), tolerance=None))


def test_two_bars_hinged_together_are_solved_as_one_system():
    """A double pendulum let go from rest, 2 rods: 6 unknowns against Lagrange's equations worked out for this place."""
    m, L, g = 2.0, 1.5, 9.81
    ground = Frame("ground")

    def laws(O_x, O_y, A_x, A_y, alpha_1, alpha_2):
        first = ground.rotate("first", "z", angle=0.3, acceleration=alpha_1)
        hinge = first.point("A", L, 0, 0)
        second = ground.rotate("second", "z", angle=0, origin=ground.point("A", *hinged(hinge, ground))).rotate("rod", "z", -0.4, 0, alpha_2)
        one, two = rod(L, first.point("G1", L / 2, 0, 0), "x", mass=m, name="one"), rod(L, second.point("G2", L / 2, 0, 0), "x", mass=m, name="two")
        F_O, F_A = ground.vector(O_x, O_y, 0), ground.vector(A_x, A_y, 0)
        down = ground.vector(0, -m * g, 0)
        return {
            **equations_of_motion(one, {"weight": (down, one.centre), "O": (F_O, ground), "A": (-F_A, hinge)}, ground),
            **equations_of_motion(two, {"weight": (down, two.centre), "A": (F_A, hinge)}, ground, about=hinge),
        }

    s = solve_linear(laws)
    p, q = 0.3, -0.4
    mass = np.array([[m * L**2 / 3 + m * L**2, m * L**2 / 2 * np.cos(p - q)], [m * L**2 / 2 * np.cos(p - q), m * L**2 / 3]])
    right = [-m * g * L / 2 * np.cos(p) - m * g * L * np.cos(p), -m * g * L / 2 * np.cos(q)]
    assert close((s.alpha_1, s.alpha_2), np.linalg.solve(mass, right).tolist(), 1e-11)
    assert not s.undetermined


def hinged(point, ground):
    """The coordinates of a point of a body in the ground, with the rates that they have at rest."""
    x, a = point.position(ground).components(), point.acceleration(ground).components(ground)
    return [moving(v, 0, w) for v, w in zip(x, a, strict=True)]


# -- errors in words


def test_bodies_without_a_moment_about_an_axis_are_refused_by_the_inverse():
    frame = Frame("rod")
    for inertia in (rod(1.0, frame, "x", mass=2.0).inertia, Inertia(frame, (0.0, 1.0, 1.0))):
        with pytest.raises(MassError, match="has no inverse: about some axis the body has no moment of inertia"):
            angular_acceleration(inertia, frame.vector(1.0, 0, 0), frame.vector(1.0, 2.0, 0))


def test_the_planar_equation_is_refused_where_products_are_left():
    I = Inertia(Frame("body"), (3.0, 3.0, 4.0), (0, 0.5, 1.0))
    with pytest.raises(MassError, match=r"\(8\.19\) needs a principal axis along z, but .* I_yz = 0\.5, I_zx = 1\.0; take fixed_line_moment"):
        planar_moment(I, 2.0)
    assert planar_moment(Inertia(Frame("body"), (3.0, 3.0, 4.0), (1.0, 0, 1e-15)), 2.0) == 8.0


def test_explanations_name_the_equation_and_its_terms():
    ground, _, body, points, _ = free_body("float")
    text = str(resultant_moment(body, ground, points["any"]).explain("N m"))
    assert text.startswith("moment of body about E, seen from ground, by way of body, equation (8.9), components in body")
    assert "reference  d x m a_B" in text
    assert r"\tag{8.10}" in resultant_moment(body, ground).explain().latex
    wrong = resultant_moment(body, ground, points["any"]).without("reference")
    assert wrong.norm() != resultant_moment(body, ground, points["any"]).norm()


def test_a_disk_about_its_diameter_has_three_ways_to_one_moment():
    """Momentum differentiated, Euler's equations, and the line: all give one moment."""
    for w, a in choices((2.0, -1.0), (3.0, 0.5)):
        ground = Frame("ground")
        frame = ground.rotate("disk", "x", 0.3, w, a)
        d = disk(0.5, frame, "z", mass=2.0)
        I = d.inertia
        both = frame.angular_velocity(ground), frame.angular_acceleration(ground)
        assert close(resultant_moment(d, ground), euler_moments(I, *both), 1e-14)
        assert close(fixed_line_moment(I, w, a, "x"), euler_moments(I, *both), 1e-14)

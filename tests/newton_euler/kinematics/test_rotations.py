"""Chapter 4, (4.1)-(4.14) and the example of 4.5; (10.1)-(10.12); quaternions; the accuracy of
reading a rotation.
"""

import itertools
import math

import mpmath as mp
import numpy as np
import pytest
import sympy
from hypothesis import given, settings
from hypothesis import strategies as st

from newton_euler import (
    Dimension,
    Frame,
    at,
    atan2,
    compiled,
    cos,
    moving,
    pi,
    sin,
    solve_rates,
    sqrt,
)
from newton_euler.algebra import ScalarError
from newton_euler.kinematics.rotations import (
    RotationError,
    apply,
    axis_angle,
    checked_rotation,
    determinant,
    direction_cosines,
    euler_angles,
    euler_body_rates,
    euler_frame,
    euler_from_quaternion,
    euler_matrix,
    euler_rates,
    in_sequence,
    matrix_from_quaternion,
    normalised,
    product,
    quaternion,
    quaternion_from_euler,
    quaternion_from_matrix,
    quaternion_product,
    quaternion_rate,
    rotation_matrix,
    transpose,
)
from tests.kinds import close, every_kind, number, numbers, within

ground = Frame("ground")
EPS = 2.0**-52
UNIT = ((1, 0, 0), (0, 1, 0), (0, 0, 1))
I, J, K = UNIT
small = within(1e-14, 27)


def spinning(kind, origin=None):
    """Ground, a body turned three ways and moving in all of them, and its matrix as a function of
    time, with the instant t.

    The matrix comes from Rodrigues' formula and the product rule alone: no composition of rates, no
    omega x r.
    origin : velocity of the body's origin in the ground; default: at rest
    """
    a, b, c, t = numbers(kind, "0.4", "-0.7", "1.1", "0.5")
    axes = K, I, tuple(x + 0 * t for x in (0, 3, 4))
    angles = (lambda t: a + b * t), (lambda t: c + a * t * t), (lambda t: b + c * t + t * t)
    ground = frame = Frame("ground")
    place = origin and ground.point("B", *(moving(0 * v, v) for v in origin))
    for name, axis, angle in zip("zxs", ("z", "x", axes[2]), angles, strict=True):
        frame = frame.rotate(name, axis, at(angle, t), origin=place)
        place = None

    def matrix(t):
        turns = (rotation_matrix(e, f(t)) for e, f in zip(axes, angles, strict=True))
        return product(*turns)

    return ground, frame, matrix, t


def with_rates(matrix, t):
    """The entries of the matrix at t, their rates, and their second rates, by the product rule."""
    entry = lambda n, m: at(lambda time: matrix(time)[n][m], t)
    entries = [[entry(n, m) for m in range(3)] for n in range(3)]
    parts = "value", "rate", "acceleration"
    return ([[getattr(x, part) for x in row] for row in entries] for part in parts)


def axial(W):
    """The vector of an antisymmetric matrix."""
    return (W[2][1] - W[1][2]) / 2, (W[0][2] - W[2][0]) / 2, (W[1][0] - W[0][1]) / 2


# -- direction cosines (4.1)-(4.8)


@every_kind
def test_eqn_4_1_direction_cosines_have_the_moving_axes_as_rows(kind):
    ground, body, _, _ = spinning(kind)
    A = direction_cosines(body, ground)
    for row, moved in zip(A, (body.i, body.j, body.k), strict=True):
        for entry, fixed in zip(row, (ground.i, ground.j, ground.k), strict=True):
            assert close(entry, moved.dot(fixed), small(kind))
    assert close(A, transpose(body.rotation(ground)), 0)


@every_kind
def test_eqn_4_2_to_4_4_the_transpose_is_the_inverse_on_both_sides_and_the_determinant_is_1(kind):
    A = euler_matrix(*numbers(kind, "0.3", "1.2", "-2.5"))
    assert close(product(transpose(A), A), UNIT, small(kind))
    assert close(product(A, transpose(A)), UNIT, small(kind))
    R = rotation_matrix(numbers(kind, 1, -2, 3), numbers(kind, "0.8"))
    assert close(determinant(R), 1, small(kind))


@every_kind
def test_eqn_4_5_to_4_7_components_before_and_after_the_rotation(kind):
    ground, body, _, _ = spinning(kind)
    r, tiny = numbers(kind, "0.5", "-1.5", 2), small(kind, 10)
    before = ground.rotate("before", numbers(kind, 1, 2, 2), numbers(kind, 0))
    assert close(ground.vector(*r), before.vector(*r), tiny)  # 4.5
    turned = ground.vector(*apply(body.rotation(ground), r))
    assert close(turned.components(body), r, tiny)  # 4.6
    assert close(turned, r[0] * body.i + r[1] * body.j + r[2] * body.k, tiny)
    assert close(apply(direction_cosines(body, ground), turned.components()), r, tiny)  # 4.7


@every_kind
def test_eqn_4_8_eulers_theorem_every_rotation_keeps_one_line(kind):
    """A r = r along the axis, and |A - 1| = 0, for three rotations about different axes."""
    ground, body, _, _ = spinning(kind)
    A = [[number(x) for x in row] for row in direction_cosines(body, ground)]
    axis, angle = axis_angle(transpose(A))
    assert close(apply(A, axis), axis, 10 * small(kind))
    without_1 = [[x - int(n == m) for m, x in enumerate(row)] for n, row in enumerate(A)]
    assert close(determinant(without_1), 0, small(kind))
    assert close(rotation_matrix(axis, angle), transpose(A), 10 * small(kind))


# -- finite rotations (4.2, 4.3)


@every_kind
@pytest.mark.parametrize(("order", "columns", "axis"), [
    ("IJ", ((0, 0, -1), (1, 0, 0), (0, -1, 0)), (1, 1, -1)),
    ("JI", ((0, 1, 0), (0, 0, 1), (1, 0, 0)), (1, 1, 1)),
])  # fmt: skip
def test_section_4_3_quarter_turns_about_two_fixed_axes_do_not_commute(kind, order, columns, axis):
    """Each order is one turn of 120 degrees."""
    tiny, one = small(kind), numbers(kind, 1)
    quarter = pi(one) / 2 + 0 * one
    R = in_sequence(*(rotation_matrix({"I": I, "J": J}[name], quarter) for name in order))
    assert close(transpose(R), columns, tiny)
    found, angle = axis_angle(R)
    assert close(found, tuple(x / sqrt(3 * one / one) for x in axis), tiny)
    assert close(angle, 4 * quarter / 3, tiny)


# -- infinitesimal rotations, angular velocity and acceleration (4.9)-(4.14)


@every_kind
def test_eqn_4_9_angular_velocity_is_the_limit_of_small_rotations(kind):
    """The rotation during dt, axis times angle over dt, differs from omega in proportion to dt."""
    ground, body, matrix, t = spinning(kind)
    omega = [number(x) for x in body.angular_velocity(ground).components(ground)]
    error = []
    for dt in (1e-4, 5e-5):
        before, after = (
            [[number(x) for x in row] for row in matrix(s)] for s in (t, t + numbers(kind, dt))
        )
        axis, angle = axis_angle(product(after, transpose(before)))
        mean = angle / number(numbers(kind, dt))
        error.append(max(np.max(abs(e * mean - w)) for e, w in zip(axis, omega, strict=True)))
    assert error[0] < 1e-3  # rad/s
    assert 1.99 < error[0] / error[1] < 2.01


@every_kind
def test_eqn_4_10_and_4_11_velocity_of_a_point_of_a_moving_body(kind):
    """v_B + omega x r against the product rule on r_B(t) + R(t) r; also with B fixed."""
    v_B, r = numbers(kind, 2, 3, "-1"), numbers(kind, 1, "-0.5", "0.25")
    for v_origin in (v_B, None):
        ground, body, matrix, t = spinning(kind, v_origin)
        _, rate, _ = with_rates(matrix, t)
        A, carried = body.point("A", *r), ground.vector(*(v_origin or (0, 0, 0)))
        v, tiny = A.velocity(ground), 20 * small(kind)
        assert close(
            (carried + ground.vector(*apply(rate, r))).components(), v.components(ground), tiny
        )
        assert close(carried + body.angular_velocity(ground).cross(body.vector(*r)), v, tiny)
        assert close((A - body.origin).components(body), r, tiny)


@every_kind
def test_eqn_4_12_angular_acceleration_is_the_rate_of_the_angular_velocity(kind):
    """Against the antisymmetric part of d(R' R^T)/dt."""
    ground, body, matrix, t = spinning(kind)
    value, rate, second = with_rates(matrix, t)
    one, two = product(second, transpose(value)), product(rate, transpose(rate))
    known = [a + b for a, b in zip(axial(one), axial(two), strict=True)]
    omega, alpha = body.angular_velocity(ground), body.angular_acceleration(ground)
    tiny = 20 * small(kind)
    assert close(omega.components(ground), axial(product(rate, transpose(value))), tiny)
    assert close(alpha.components(ground), known, tiny)
    assert close(omega.rate(ground), alpha, tiny)


def rolling_cone(h, r, nu):
    """Ground, cone, highest point P of the base, rate of the line of contact (along I)."""

    def placed(line_rate, spin):
        line = ground.rotate("line of contact", "z", rate=line_rate)
        return line.rotate("axis", "-y", atan2(r, h)).rotate("cone", "x", rate=spin)

    def conditions(line_rate, spin):
        cone = placed(line_rate, spin)
        contact, B = cone.point("contact", h, 0, -r), cone.point("B", h, 0, 0)
        return contact.velocity(ground), B.velocity(ground).dot(ground.j) + nu

    rates = solve_rates(conditions, 2)
    cone = placed(*rates)
    return ground, cone, cone.point("P", h, 0, r), rates[0]


@every_kind
def test_example_4_5_cone_rolling(kind):
    h, r, nu = numbers(kind, 3, "1.25", "0.8")
    ground, cone, P, line_rate = rolling_cone(h, r, nu)
    slant = sqrt(h * h + r * r)
    on_line = cone.point("on the line of contact", h / 2, 0, -r / 2)
    for found, known in (
        (cone.k, (-r / slant, 0, h / slant)),
        (cone.angular_velocity(ground), (nu * sqrt(1 / r**2 + 1 / h**2), 0, 0)),
        (P.velocity(ground), (0, -2 * nu, 0)),
        (cone.angular_acceleration(ground), (0, -(nu**2) / h**2 * (h / r + r / h), 0)),
        (on_line.velocity(ground), (0, 0, 0)),
    ):
        assert close(found.components(ground), known, 20 * small(kind))
    assert close(line_rate, -nu * slant / h**2, 20 * small(kind))


def test_example_4_5_cone_rolling_as_a_formula():
    """With symbols the engine gives the book's three formulas."""
    h, r, nu = sympy.symbols("h r nu", positive=True)
    ground, cone, P, _ = rolling_cone(h, r, nu)
    omega = cone.angular_velocity(ground).components(ground)
    alpha = cone.angular_acceleration(ground).components(ground)
    wanted = (nu * sympy.sqrt(1 / r**2 + 1 / h**2), -2 * nu, -(nu**2) * (h**2 + r**2) / (r * h**3))
    for found, formula in zip(
        (omega[0], P.velocity(ground).components(ground)[1], alpha[1]), wanted, strict=True
    ):
        assert sympy.simplify(found - formula) == 0


# -- reading axis and angle


def true_matrix(axis, angle):
    """The matrix to 60 digits by the exponential series: no formula is shared with the engine."""
    x, y, z = axis
    with mp.workdps(60):
        spin = mp.matrix([[0, -z, y], [z, 0, -x], [-y, x, 0]]) * (
            angle / mp.sqrt(x * x + y * y + z * z)
        )
        return mp.expm(spin, method="taylor")


AXES = [(1, 2, 3), (-2, 1, 0.5), (0.1, -3, 0.2), (1e-3, 1, -1), (0, 0, 1), (3, -0.01, 0)]


@pytest.mark.parametrize("distance", [1, 1e-1, 1e-3, 1e-6, 1e-8, 1e-10, 1e-13, 4e-15])
@pytest.mark.parametrize("end", [0, 1], ids=["near 0", "near pi"])
def test_axis_and_angle_are_accurate_to_round_off_near_0_and_pi(end, distance):
    """Read from a rounded matrix: the angle to 4 of its round-offs, the axis to 4 of those of 1."""
    for axis in AXES:
        with mp.workdps(60):
            angle = end * mp.pi + (-1) ** end * mp.mpf(distance)
            true = true_matrix([mp.mpf(x) for x in axis], angle)
            R = [[float(true[n, m]) for m in range(3)] for n in range(3)]
            unit = [mp.mpf(x) / mp.sqrt(sum(mp.mpf(y) ** 2 for y in axis)) for x in axis]
            found, turned = axis_angle(R)
            assert abs(turned - angle) < 4 * EPS * angle  # rad
            assert max(abs(x - y) for x, y in zip(found, unit, strict=True)) < 4 * EPS


def test_thirty_digits_and_tiny_angles_keep_their_axis():
    for angle in (mp.mpf("1e-12"), mp.mpf("0.7"), mp.pi - mp.mpf("1e-14")):
        axis, found = axis_angle(rotation_matrix((mp.mpf(2), mp.mpf(-1), mp.mpf(2)), angle))
        assert abs(found - angle) < 1e-28
        assert close(axis, (mp.mpf(2) / 3, -mp.mpf(1) / 3, mp.mpf(2) / 3), mp.mpf(10) ** -28)
    for angle in (1e-30, 1e-200, 1e-300):
        axis, found = axis_angle(rotation_matrix((0.0, 0.6, -0.8), angle))
        assert close(axis, (0, 0.6, -0.8), 2 * EPS)
        assert abs(found - angle) <= 4 * EPS * angle
    assert axis_angle(UNIT) == ((0, 0, 1), 0)
    assert axis_angle(rotation_matrix((1.0, 1.0, 0.0), 0.0)) == ((0, 0, 1), 0)


@pytest.mark.parametrize("axis", [v for v in itertools.product((-1, 0, 1), repeat=3) if any(v)])
def test_at_pi_the_first_component_of_the_axis_is_positive(axis):
    """This holds whatever round-off does to the matrix."""
    first = next(x for x in axis if x)
    wanted = [x * first / math.sqrt(sum(map(abs, axis))) for x in axis]
    noise = np.random.default_rng(7).uniform(-2 * EPS, 2 * EPS, (20, 3, 3))
    for matrix in np.array(rotation_matrix(axis, math.pi)) + noise:
        found, angle = axis_angle(matrix)
        assert close(found, wanted, 8 * EPS)
        assert abs(angle - math.pi) < 8 * EPS


def test_arrays_are_read_instant_by_instant():
    """All four branches of the quaternion, both signs, and no rotation at all."""
    rng = np.random.default_rng(1)
    angle = np.concatenate([[0.0, math.pi, 1e-9, math.pi - 1e-9], rng.uniform(0, 2 * math.pi, 200)])
    axis = rng.normal(size=(3, angle.size))
    R = rotation_matrix(axis, angle)
    found, turned = axis_angle(R)
    for n in range(angle.size):
        one, alone = axis_angle([[x[n] for x in row] for row in R])
        assert close([x[n] for x in found], one, 2 * EPS)
        assert close(turned[n], alone, 4 * EPS)
    assert (found[0][0], found[1][0], found[2][0], turned[0]) == (0, 0, 1, 0)


@pytest.mark.parametrize(("matrix", "error", "words"), [
    (3.0, RotationError, "three rows of three entries.*got 3.0"),
    ([[1, 2], [3, 4]], RotationError, r"rows of lengths \[2, 2\]"),
    (np.zeros((5, 3, 3)), RotationError, r"shows the shape \(3, 3, N\); got shape \(5, 3, 3\)"),
    (np.diag([1, 1, -1]), RotationError, "a reflection, determinant -1: exchange two axes"),
    (np.diag([1, 1, 1.1]), RotationError, "differs from the unit matrix by 0.21, and 1e-09 is allowed.*tolerance="),
    (np.full((3, 3), np.nan), RotationError, "differs from the unit matrix by nan"),
    (rotation_matrix((1, 2, 3), sympy.Symbol("q")), ScalarError, "entries must have values.*cos.*Put in numbers first"),
    (rotation_matrix((1.0, 2.0, 3.0), Dimension()), ScalarError, "entries must have values.*Dimension"),
])  # fmt: skip
def test_what_is_not_a_rotation_is_refused_in_words(matrix, error, words):
    for read in (axis_angle, quaternion_from_matrix, euler_angles):
        with pytest.raises(error, match=words):
            read(matrix)


def test_one_bad_instant_is_refused_and_rounded_entries_within_the_tolerance_accepted():
    R = np.array(rotation_matrix((1.0, 2.0, 3.0), np.linspace(0, 3, 7)))
    R[:, 0, 4] *= -1
    with pytest.raises(RotationError, match="a reflection"):
        axis_angle(R)
    R = [[round(x, 3) for x in row] for row in rotation_matrix((1.0, 2.0, 3.0), 0.8)]
    with pytest.raises(RotationError, match="tolerance="):
        axis_angle(R)
    _, angle = axis_angle(R, tolerance=5e-3)
    assert abs(angle - 0.8) < 1e-3  # rad
    assert checked_rotation(R, 5e-3) == tuple(map(tuple, R))


@pytest.mark.parametrize("size", [5e-324, 1e-200, 1e-160, 1e160, 1e200])
def test_an_axis_and_a_quaternion_may_have_any_length(size):
    for make in (rotation_matrix, quaternion):
        assert np.allclose(make((0, 0, -size), 1.0), make((0, 0, -1), 1.0), atol=1e-15)
    assert normalised((0, size, 0, 0)) == (0, 1, 0, 0)
    quarter = ((0, -1, 0), (1, 0, 0), (0, 0, 1))
    assert np.allclose(matrix_from_quaternion((size, 0, 0, size)), quarter, atol=1e-15)
    both = np.array([size, 1.0])
    assert np.allclose(matrix_from_quaternion((both, 0, 0, both))[0][1], -1, rtol=1e-15)


def test_an_axis_without_direction_is_refused():
    for make in (rotation_matrix, quaternion):
        with pytest.raises(RotationError, match=r"no direction: its length is 0.0"):
            make((0, 0, 0), 1.0)
        with pytest.raises(RotationError, match="no direction"):
            make((np.array([1.0, 0.0]), 0, 0), 1.0)
        for bad in ("z", (1j, 0, 1), np.array([1j, 0, 1])):
            with pytest.raises(RotationError, match=r"three numbers.*got"):
                make(bad, 1.0)


# -- laws

angles = st.floats(-10, 10)
triples = st.tuples(*[st.floats(-1, 1)] * 3).filter(lambda v: sum(x * x for x in v) > 1e-6)
matrices = st.builds(rotation_matrix, triples, angles)
laws = settings(max_examples=100)


@laws
@given(triples, angles)
def test_a_rotation_matrix_is_orthogonal_turns_right_handed_and_keeps_its_axis(axis, angle):
    R = rotation_matrix(axis, angle)
    assert close(product(transpose(R), R), UNIT, 12 * EPS)
    assert abs(determinant(R) - 1) < 12 * EPS  # at most 9 were found
    assert close(apply(R, axis), axis, 12 * EPS)
    assert close(R, ground.rotate("body", axis, angle).rotation(ground), 12 * EPS)


@laws
@given(matrices)
def test_what_is_read_from_a_matrix_rebuilds_it(R):
    axis, angle = axis_angle(R)
    assert 0 <= angle <= math.pi
    assert abs(math.hypot(*axis) - 1) < 4 * EPS
    assert close(rotation_matrix(axis, angle), R, 16 * EPS)
    q = quaternion_from_matrix(R)
    assert q[0] >= -4 * EPS
    assert close(matrix_from_quaternion(q), R, 16 * EPS)
    psi, theta, phi = euler_angles(R)
    assert -math.pi <= psi <= math.pi
    assert 0 <= theta <= math.pi
    assert -math.pi <= phi <= math.pi
    assert close(euler_matrix(psi, theta, phi), R, 32 * EPS)


@laws
@given(triples, angles, triples, angles)
def test_quaternions_compose_as_matrices_do(e, a, f, b):
    p, q = quaternion(e, a), quaternion(f, b)
    product_matrix = product(rotation_matrix(e, a), rotation_matrix(f, b))
    assert close(matrix_from_quaternion(quaternion_product(p, q)), product_matrix, 16 * EPS)
    assert abs(math.hypot(*quaternion_product(p, q)) - 1) < 8 * EPS


# -- quaternions


@every_kind
def test_quaternion_rate_takes_body_components_of_omega(kind):
    """q' = q omega/2 against the derivative of the quaternion of three successive moving turns."""
    a, b, t = numbers(kind, "0.4", "-0.7", "0.5")
    turns = (K, lambda s: a + b * s), (I, lambda s: b + s), ((0, 3, 4), lambda s: a * s * s)

    def q(time):
        first, second, third = (quaternion(axis, angle(time)) for axis, angle in turns)
        return quaternion_product(quaternion_product(first, second), third)

    moved = [at(lambda time, n=n: q(time)[n], t) for n in range(4)]
    now, tiny = [x.value for x in moved], 20 * small(kind)
    ground = body = Frame("ground")
    for axis, angle in turns:
        body = body.rotate("turned", tuple(x + 0 * t for x in axis), at(angle, t))
    rate = quaternion_rate(now, body.angular_velocity(ground))
    assert close(rate, [x.rate for x in moved], tiny)
    assert close(sum(x * y for x, y in zip(now, rate, strict=True)), 0, tiny)  # the length stays
    assert close(matrix_from_quaternion(now), body.rotation(ground), tiny)


@pytest.mark.parametrize(("read", "q", "words"), [
    (normalised, (0.0, 0.0, 0.0, 0.0), "length must be finite and not zero"),
    (matrix_from_quaternion, (np.array([1.0, 0.0]), 0, 0, 0), "length must be finite and not zero"),
    (normalised, (math.nan, 0.0, 0.0, 1.0), "length must be finite"),
    (normalised, (1.0, 0.0, 0.0), r"four components, the scalar part first; got \(1"),
])  # fmt: skip
def test_quaternions_that_are_not_rotations_are_refused(read, q, words):
    with pytest.raises(RotationError, match=words):
        read(q)


# -- Euler angles 3-1-3 (10.1)-(10.12)


@every_kind
def test_eqn_10_3_and_10_4_angular_velocity_of_the_precessing_frame_and_of_the_body(kind):
    psi, theta, phi, dpsi, dtheta, dphi = numbers(kind, "0.3", "1.1", "-0.8", 2, "-0.5", 7)
    body = euler_frame(ground, "top", moving(psi, dpsi), moving(theta, dtheta), moving(phi, dphi))
    nodal, tiny = body.parent, 20 * small(kind)
    across, along = dpsi * sin(theta), dpsi * cos(theta)
    assert close(nodal.angular_velocity(ground), (dtheta, across, along), tiny)
    whole = body.angular_velocity(ground).components(nodal)
    assert close(whole, (dtheta, across, dphi + along), tiny)


@every_kind
def test_eqn_10_5_to_10_10_the_matrix_of_the_angles_is_that_of_the_frames(kind):
    angles = numbers(kind, "0.3", "1.1", "-0.8")
    body = euler_frame(ground, "body", *angles)
    R = euler_matrix(*angles)
    assert close(R, body.rotation(ground), small(kind))
    psi, theta, phi = angles
    turns = [rotation_matrix(K, psi), rotation_matrix(I, theta), rotation_matrix(K, phi)]
    assert close(R, product(*turns), small(kind))
    q = ground.vector(*numbers(kind, 1, 2, 3))
    assert close(apply(transpose(R), q), q.components(body), 10 * small(kind))
    assert close(matrix_from_quaternion(quaternion_from_euler(*angles)), R, small(kind))


@every_kind
def test_eqn_10_12_body_rates_from_the_rates_of_the_angles_and_back(kind):
    *angles, a, b, c = numbers(kind, "0.3", "1.1", "-0.8", 2, "-0.5", 7)
    body = euler_frame(ground, "body", *map(moving, angles, (a, b, c)))
    omega = euler_body_rates(*angles, (a, b, c))
    assert close(omega, body.angular_velocity(ground), 20 * small(kind))
    assert close(euler_rates(*angles, omega), (a, b, c), 50 * small(kind))


@every_kind
def test_euler_angles_come_back(kind):
    angles = numbers(kind, "2.9", "1.1", "-0.8")
    R = euler_matrix(*angles)
    if kind == "sympy":
        R = [[number(x) for x in row] for row in R]
    found = euler_angles(R)
    assert np.min(found[1]) >= 0
    # the array holds an angle beyond pi, which is read back in (-pi, pi]
    whole = 2 * math.pi if kind == "array" else 2 * mp.pi
    turns = [(f - number(a)) / whole for f, a in zip(found, angles, strict=True)]
    nearest = np.round if kind == "array" else mp.nint
    assert all(np.max(abs(x - nearest(x))) <= small(kind) for x in turns)


@pytest.mark.parametrize(
    ("end", "sign"), [(0.0, 1), (math.pi, -1)], ids=["theta = 0", "theta = pi"]
)
def test_at_the_poles_psi_has_all_and_phi_is_zero(end, sign):
    for psi, phi in [(0.3, 0.4), (-2.0, 1.1), (3.0, 0.1), (1.0, -1.0)]:
        found = euler_angles(euler_matrix(psi, end, phi))
        assert close(found, (psi + sign * phi, end, 0), 8 * EPS)
        assert close(euler_from_quaternion(quaternion_from_euler(psi, end, phi)), found, 8 * EPS)
    theta, same = np.array([end, 1.0]), np.ones(2)
    many = euler_angles(euler_matrix(0.3 * same, theta, 0.4 * same))
    known = np.array([0.3 + sign * 0.4, 0.3]), theta, np.array([0.0, 0.4])
    assert close(many, known, 8 * EPS)


@pytest.mark.parametrize("theta", [1e-3, 1e-6, 1e-9, 1e-12])
@pytest.mark.parametrize("end", [0, 1], ids=["near 0", "near pi"])
def test_near_the_poles_theta_and_the_sum_of_the_angles_stay_accurate(theta, end):
    """Theta is right to 4 of its round-offs, psi +- phi to 8 round-offs of 1 rad."""
    for psi, phi in [(0.3, 0.4), (-1.0, 2.5), (1.7, 0.1)]:
        with mp.workdps(60):
            true = end * mp.pi + (-1) ** end * mp.mpf(theta)
            R = [[float(x) for x in row] for row in euler_matrix(mp.mpf(psi), true, mp.mpf(phi))]
            found = euler_angles(R)
            assert abs(found[1] - true) < 4 * EPS * true
            sense = 1 - 2 * end
            assert abs(found[0] + sense * found[2] - psi - sense * phi) < 8 * EPS


@pytest.mark.parametrize("theta", [
    0.0, math.pi, sympy.pi, np.array([1.0, 0.0, 2.0]),
], ids=["0", "pi", "exact pi", "one instant"])  # fmt: skip
def test_euler_rates_are_refused_at_the_poles(theta):
    words = r"theta = .*axes of precession and spin coincide.*use quaternion_rate"
    with pytest.raises(RotationError, match=words):
        euler_rates(0.3, theta, 0.4, (1.0, 2.0, 3.0))


def test_euler_frame_may_have_its_origin_anywhere():
    pivot = ground.point("O", 1.0, 2.0, 3.0)
    tip = euler_frame(ground, "top", 0.4, math.pi / 2, 0.0, origin=pivot).point("tip", 0, 0, 2.0)
    assert close(tip.position(ground), (1 + 2 * math.sin(0.4), 2 - 2 * math.cos(0.4), 3))


# -- the other kinds of number


@pytest.mark.parametrize("f", [
    lambda a, b, c: rotation_matrix((a, b, 2 + c), a),
    lambda a, b, c: matrix_from_quaternion(quaternion((a, b, c), b)),
    lambda a, b, c: (euler_matrix(a, b, c),),
    lambda a, b, c: euler_rates(a, b, c, euler_body_rates(a, b, c, (b, c, a))),
    lambda a, b, c: quaternion_rate(quaternion_from_euler(a, b, c), (c, a, b)),
])  # fmt: skip
def test_what_builds_rotations_can_be_compiled_and_has_pure_dimension(f):
    x, rate = (0.3, 0.2, 0.1), Dimension(time=-1)
    assert close(compiled(f)(*x), f(*x), 8 * EPS)
    assert set(np.array(f(*[Dimension()] * 3), dtype=object).ravel()) == {Dimension()}
    assert euler_rates(*[Dimension()] * 3, (rate, rate, rate)) == (rate, rate, rate)


def test_symbols_and_exact_numbers_stay_exact():
    q, third = sympy.Symbol("q"), sympy.pi / 3
    c, s = sympy.cos(q), sympy.sin(q)
    assert rotation_matrix((0, 0, 1), q) == ((c, -s, 0), (s, c, 0), (0, 0, 1))
    assert not any(x.has(sympy.Float) for row in rotation_matrix((1, 2, 3), q) for x in row)
    axis = tuple(n / sympy.sqrt(14) for n in (1, 2, 3))
    assert axis_angle(rotation_matrix((1, 2, 3), third)) == (axis, third)

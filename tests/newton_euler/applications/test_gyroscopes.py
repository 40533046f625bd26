"""Chapter 10: one point fixed; gyroscopic motion. (10.1)-(10.38), mostly against mass points,
Lagrange's equations and integration.

The matrices (10.5)-(10.12) have more tests in test_rotations.py.
"""

import math

import mpmath as mp
import numpy as np
import pytest
import sympy
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from newton_euler import Dimension, Frame, compiled, cos, cross, moving, pi, sin, sqrt
from newton_euler.algebra import FrameError
from newton_euler.algebra.errors import ArgumentError
from newton_euler.applications.gyroscopes import (
    GyroError,
    fast_spin,
    free_precession,
    gyro_moment,
    gyro_momentum,
    instantaneous_axis,
    least_spin,
    normal_moment,
    nutation_stiffness,
    sleeping_top,
    steady_moment,
    steady_precession,
    steady_spin,
)
from newton_euler.applications.nutation import nutation
from newton_euler.bodies.inertia import Inertia
from newton_euler.kinematics.rotations import euler_frame
from tests.kinds import close, every_kind, numbers, within

small = within(1e-13, 26)


# a motion with everything in it: value, rate and second rate of psi, theta, phi
MOTION = {"psi": ("0.4", "1.2", "-0.7"), "theta": ("0.9", "0.5", "0.3")}
MOTION["phi"] = "1.3", "2.5", "0.8"


def top_of(kind):
    """Ground, the frame of the body, its angles as triples (value, rate, second rate), and I0, I."""
    angles = {name: numbers(kind, *values) for name, values in MOTION.items()}
    ground = Frame("ground")
    body = euler_frame(ground, "body", *(moving(*v) for v in angles.values()))
    return ground, body, angles, numbers(kind, "0.6"), numbers(kind, "0.25")


# -- instantaneous axis, Euler's angles (10.1)-(10.12)


@every_kind
def test_section_10_1_without_a_point_at_rest_the_axis_is_that_of_the_screw(kind):
    ground = body = Frame("ground")
    v, w = numbers(kind, 1, -2, "0.5"), numbers(kind, "0.8", "0.3", "1.5")
    body = ground.translate("moved", ground.point("B", *(moving(0 * x, x) for x in v)))
    for axis, rate in zip("xyz", w, strict=True):
        body = body.rotate(axis, axis, rate=rate)
    axis = instantaneous_axis(body, ground)
    here = axis.point.velocity(ground)
    assert close(here.cross(axis.direction), (0, 0, 0), small(kind))
    assert close(here, axis.direction * axis.slide, small(kind))


@every_kind
def test_eqn_10_1_and_10_2_the_precessing_frame_turns_about_vertical_and_line_of_nodes(kind):
    ground, body, angles, _, _ = top_of(kind)
    (_, dpsi, _), (theta, dtheta, _), nodal = angles["psi"], angles["theta"], body.parent
    assert close(nodal.angular_velocity(ground), dpsi * ground.k + dtheta * nodal.i, small(kind))
    assert close(ground.k.expressed_in(nodal), (0, sin(theta), cos(theta)), small(kind))


# -- gyroscopic motion (10.17)-(10.27)


@every_kind
def test_eqn_10_17_to_10_19_and_10_21_angular_momentum(kind):
    ground, body, angles, I0, I = top_of(kind)
    (_, dpsi, _), (theta, dtheta, _), (_, dphi, _) = angles.values()
    expected = (I0 * dtheta, I0 * dpsi * sin(theta), I * (dphi + dpsi * cos(theta)))
    H = gyro_momentum(body, ground, I0, I)
    assert close(H, expected, small(kind))
    assert H.frame is body.parent
    fixed_in_body = Inertia(ground.origin, (I0, I0, I), frame=body)
    # (10.17) holds in both frames
    assert close(H, fixed_in_body.times(body.angular_velocity(ground)), small(kind))


@every_kind
def test_eqn_10_20_the_rate_of_momentum_is_taken_with_the_rate_of_the_axes(kind):
    ground, body, _, I0, I = top_of(kind)
    H = gyro_momentum(body, ground, I0, I)
    by_nodal = H.rate(body.parent) + body.parent.angular_velocity(ground).cross(H)
    by_body = H.rate(body) + body.angular_velocity(ground).cross(H)
    assert close(gyro_moment(body, ground, I0, I), by_nodal, small(kind))
    assert close(by_nodal, by_body, 10 * small(kind))


@every_kind
def test_eqn_10_22_10_23_and_10_27_moment_by_its_terms(kind):
    ground, body, angles, I0, I = top_of(kind)
    (x, y, z), dphi = body.parent.angular_velocity(ground), angles["phi"][1]
    terms = gyro_moment(body, ground, I0, I).terms
    (dx, dy, dz), ddphi = body.parent.angular_acceleration(ground), angles["phi"][2]
    assert close(terms["acceleration"], (I0 * dx, I0 * dy, I * (dz + ddphi)), small(kind))
    assert close(terms["precession"], ((I - I0) * y * z, (I0 - I) * x * z, 0), small(kind))
    assert close(terms["gyroscopic"], (I * dphi * y, -I * dphi * x, 0), small(kind))


def spun(angles):
    """The variables of (10.24) to (10.26): theta, its rates, psi', psi'', omega_z and its rate."""
    (_, dpsi, ddpsi), (theta, dtheta, ddtheta), (_, dphi, ddphi) = angles.values()
    wz, dwz = dphi + dpsi * cos(theta), ddphi + ddpsi * cos(theta) - dpsi * dtheta * sin(theta)
    return theta, dtheta, ddtheta, dpsi, ddpsi, wz, dwz


@every_kind
def test_eqn_10_24_10_25_10_26_moment_in_euler_angles_and_in_its_shortest_form(kind):
    ground, body, angles, I0, I = top_of(kind)
    theta, dtheta, ddtheta, dpsi, ddpsi, wz, dwz = spun(angles)
    s, c = sin(theta), cos(theta)
    spin, M = wz - dpsi * c, gyro_moment(body, ground, I0, I)
    x = I0 * ddtheta - (I0 - I) * dpsi * dpsi * s * c + I * spin * dpsi * s
    y = I0 * (ddpsi * s + dpsi * dtheta * c) - (I - I0) * dpsi * dtheta * c - I * spin * dtheta
    assert close(M, (x, y, I * dwz), small(kind))
    x = I0 * (ddtheta - dpsi * dpsi * s * c) + I * wz * dpsi * s
    y = I0 / s * (ddpsi * s * s + 2 * dpsi * dtheta * s * c) - I * dtheta * wz
    assert close(M, (x, y, I * dwz), small(kind))  # the shortest form
    assert close(body.angular_velocity(ground).components(body.parent)[2], wz, small(kind))


def test_eqn_10_25_against_lagranges_equations():
    t, I0, I = sympy.symbols("t I0 I", positive=True)
    psi, theta, phi = q = [sympy.Function(n)(t) for n in ("psi", "theta", "phi")]
    across = theta.diff(t) ** 2 + psi.diff(t) ** 2 * sympy.sin(theta) ** 2
    axial = phi.diff(t) + psi.diff(t) * sympy.cos(theta)
    T = I0 * across / 2 + I * axial**2 / 2
    Q_psi, Q_theta, Q_phi = (T.diff(x.diff(t)).diff(t) - T.diff(x) for x in q)
    ground = Frame("ground")
    M = gyro_moment(euler_frame(ground, "body", *(moving(x) for x in q)), ground, I0, I)
    assert sympy.simplify(M.x - Q_theta) == 0  # work of the moment per angle: M.i, M.k, M.K
    assert sympy.simplify(M.z - Q_phi) == 0
    assert sympy.simplify(M.y * sympy.sin(theta) + M.z * sympy.cos(theta) - Q_psi) == 0


def test_a_frame_not_made_of_euler_angles_is_refused():
    ground = Frame("ground")
    with pytest.raises(FrameError, match="make wheel by euler_frame"):
        gyro_moment(ground.rotate("wheel", "x", rate=1.0), ground, 1.0, 1.0)


# -- steady precession (10.28)-(10.34), (10.37), (10.38)


def steady_data(kind):
    return numbers(kind, "0.6", "0.25", "0.9", "1.2", "2.5")  # I0, I, theta, psi', phi'


@every_kind
def test_eqn_10_28_and_10_29_steady_precession_needs_a_moment_about_the_line_of_nodes_only(kind):
    I0, I, theta, dpsi, dphi = steady_data(kind)
    ground = Frame("ground")
    body = euler_frame(ground, "body", moving(0 * dpsi, dpsi), theta, moving(0 * dphi, dphi))
    wz = dphi + dpsi * cos(theta)
    M = gyro_moment(body, ground, I0, I)
    assert close(M, (dpsi * sin(theta) * (I * wz - I0 * dpsi * cos(theta)), 0, 0), small(kind))
    assert close(M.x, steady_moment(I0, I, theta, dpsi, dphi), small(kind))


@every_kind
def test_eqn_10_30_moment_of_gravity(kind):
    theta, r, weight = numbers(kind, "0.9", "0.2", 5)
    nodal = euler_frame(Frame("ground"), "body", 0 * theta, theta, 0 * theta).parent
    moment = (r * nodal.k).cross(-weight * nodal.parent.k)
    assert close(moment, (r * weight * sin(theta), 0, 0), small(kind))


@every_kind
def test_eqn_10_31_both_rates_with_the_whole_axial_rate(kind):
    I0, I, theta, wz, mgr = numbers(kind, "0.6", "0.25", "0.9", 12, "1.5")
    found = steady_precession(I0, I, theta, omega_z=wz, mgr=mgr)
    for dpsi in (found.slow, found.fast):
        assert close(dpsi * (I * wz - I0 * dpsi * cos(theta)), mgr, 10 * small(kind))
        spin = steady_spin(I0, I, theta, dpsi, mgr=mgr)
        assert close(spin + dpsi * cos(theta), wz, 100 * small(kind))


@every_kind
def test_eqn_10_32_moment_and_spin_of_a_steady_precession(kind):
    I0, I, theta, dpsi, dphi = steady_data(kind)
    M, s = steady_moment(I0, I, theta, dpsi, dphi), sin(theta)
    assert close(M, dpsi * dpsi * s * cos(theta) * (I - I0) + dpsi * dphi * I * s, small(kind))
    assert close(steady_spin(I0, I, theta, dpsi, moment=M), dphi, small(kind))


@every_kind
@pytest.mark.parametrize("sense", [1, -1])
def test_eqn_10_33_both_roots(kind, sense):
    I0, I, theta, dphi, M = numbers(kind, "0.6", "0.25", "0.9", 12 * sense, "1.5")
    found, a = steady_precession(I0, I, theta, spin=dphi, moment=M), (I0 - I) * cos(theta)
    root = sqrt(dphi * dphi - 4 * M * a / (I * I * sin(theta)))
    printed = [I * (dphi + s * sense * root) / (2 * a) for s in (-1, 1)]
    assert close((found.slow, found.fast), printed, 100 * small(kind))
    assert close(found.discriminant, I * I * root * root, 10 * small(kind))


def test_eqn_10_33_as_a_formula():
    I0, I, theta, dphi, M = sympy.symbols("I0 I theta phi_dot M", positive=True)
    found = steady_precession(I0, I, theta, spin=dphi, moment=M)
    c, s = sympy.cos(theta), sympy.sin(theta)
    for dpsi in (found.slow, found.fast):
        left = (I0 - I) * c * dpsi**2 - I * dphi * dpsi + M / s
        assert sympy.simplify(sympy.expand(left)) == 0


def test_eqn_10_33_has_the_units_of_a_rate():
    inertia, rate, pure = Dimension(1, 2, 0), Dimension(0, 0, -1), Dimension()
    found = steady_precession(inertia, inertia, pure, spin=rate, mgr=inertia * rate * rate)
    assert found.slow == found.fast == rate
    assert set(found.stiffness) == {rate * rate}


def test_steady_precession_can_be_compiled():
    slow = lambda I0, spin: steady_precession(I0, 0.25, 0.9, spin=spin, mgr=1.5).slow
    assert compiled(slow)(0.6, -12.0) == pytest.approx(slow(0.6, -12.0), rel=1e-15)
    least = compiled(lambda theta: least_spin(0.6, 0.25, theta, mgr=1.5))
    assert [least(x) for x in (0.5, 2.0)] == [least_spin(0.6, 0.25, x, mgr=1.5) for x in (0.5, 2.0)]


def slow_root_to_60_digits(I0, I, theta, spin, mgr):
    with mp.workdps(60):
        a, h = (mp.mpf(I0) - mp.mpf(I)) * mp.cos(mp.mpf(theta)), mp.mpf(I) * mp.mpf(spin)
        return 2 * mp.mpf(mgr) / (h * (1 + mp.sqrt(1 - 4 * a * mp.mpf(mgr) / (h * h))))


@pytest.mark.parametrize("difference", [1e-3, 1e-6, 1e-9, 1e-12, 1e-15, 0.0, -1e-12, -1e-6])
def test_eqn_10_33_does_not_cancel_where_the_printed_form_does(difference):
    """At 1e-6, 1e-9, 1e-12, 1e-15 the printed root is wrong by 3e-10, 6e-7, 1e-3, 100 %."""
    I0, I, theta, spin, mgr = 1.0, 1.0 - difference, 1.0, 3.0, 2.0
    found = steady_precession(I0, I, theta, spin=spin, mgr=mgr)
    true = slow_root_to_60_digits(I0, I, theta, spin, mgr)
    assert abs(found.slow / true - 1) < 4e-16
    if difference == 0:
        assert found.fast == math.inf
    elif abs(difference) <= 1e-9:
        a = (I0 - I) * math.cos(theta)
        naive = (I * spin - math.sqrt((I * spin) ** 2 - 4 * a * mgr)) / (2 * a)
        assert abs(naive / true - 1) > 1e-8


@pytest.mark.parametrize("offset", [1e-3, 1e-9, 1e-15, 0.0, -1e-9])
def test_the_slow_rate_is_continuous_through_the_level_axis(offset):
    top = 0.6, 0.25, math.pi / 2 + offset
    found = steady_precession(*top, spin=12.0, mgr=1.5)
    assert abs(found.slow / slow_root_to_60_digits(*top, 12.0, 1.5) - 1) < 4e-16
    assert abs(found.slow - 1.5 / (0.25 * 12.0)) < 2 * abs(offset) + 1e-15


between = st.floats


@settings(max_examples=150)
@given(
    between(0.1, 10), between(0.01, 1.99), between(0.01, 3.13), between(-50, 50), between(-20, 20)
)
def test_both_rates_satisfy_the_quadratic_to_round_off(I0, part, theta, spin, mgr):
    I = part * I0
    assume(abs(spin) > 1e-3)
    a, h = (I0 - I) * math.cos(theta), I * spin
    assume(h * h - 4 * a * mgr > 1e-6 * h * h)
    found = steady_precession(I0, I, theta, spin=spin, mgr=mgr)
    for dpsi in (found.slow, found.fast):
        if math.isfinite(dpsi):
            terms = a * dpsi * dpsi, -h * dpsi, mgr
            assert abs(sum(terms)) <= 1e-14 * max(map(abs, terms)) + 1e-300
    assert abs(found.slow) <= abs(found.fast) * (1 + 1e-15)
    assert min(found.stiffness) >= 0


@every_kind
def test_at_discriminant_zero_both_rates_are_one(kind):
    """For I0 = 2, I = 1, theta = 0, mgr = 4 the least I phi' is 4."""
    I0, I, zero, mgr, spin = numbers(kind, 2, 1, 0, 4, 4)
    if kind != "array":
        found = steady_precession(I0, I, zero, spin=spin, mgr=mgr)
        assert close((found.slow, found.fast, found.discriminant), (2, 2, 0), small(kind))
    least = 4 * sqrt((I0 - I) * mgr / 4) / I
    assert close(least_spin(I0, I, zero, mgr=mgr), least, small(kind))


@pytest.mark.parametrize("off", [1e-2, 1e-6, 1e-10])
@pytest.mark.parametrize("of", ["spin", "omega_z"])
def test_below_the_least_spin_there_is_no_steady_precession_and_above_there_is(of, off):
    top = 0.6, 0.25, 0.9
    least = least_spin(*top, mgr=1.5, of=of)
    at_rate = lambda part: steady_precession(*top, mgr=1.5, **{of: part * least})
    above = at_rate(1 + off)
    assert above.slow < above.fast
    assert at_rate(-(1 + off)).slow < 0
    assert at_rate(1).discriminant >= 0
    for rate in map(mp.mpf, (above.slow, above.fast)):
        spin = (1 + off) * least - (rate * mp.cos(0.9) if of == "omega_z" else 0)
        assert abs(steady_moment(*top, rate, spin) / (1.5 * mp.sin(0.9)) - 1) < 1e-14
    words = rf"negative; {of} must be at least {least:.6g} rad/s in size"
    with pytest.raises(GyroError, match=words):
        at_rate(1 - off)


@pytest.mark.parametrize("theta", [1.8, 2.5, 3.1])
def test_a_hanging_body_precesses_at_every_spin(theta):
    assert least_spin(0.6, 0.25, theta, mgr=1.5) == 0
    found = steady_precession(0.6, 0.25, theta, spin=0.0, mgr=1.5)
    # the conical pendulum, both ways round
    assert found.slow == pytest.approx(-found.fast, rel=1e-15)
    assert found.slow**2 == pytest.approx(-1.5 / (0.35 * math.cos(theta)), rel=1e-14)


def resting_box():
    ground = Frame("ground")
    return ground.translate("box", ground.point("C", moving(0.0, 1.0), 0, 0)), ground


def leaning_rates():
    ground = Frame("ground")
    return ground.vector(0, 1.0, 0.1), ground.vector(0, 0, 10.0), 1.0


@pytest.mark.parametrize(("ask", "words"), [
    (lambda: instantaneous_axis(*resting_box()), "box does not turn in ground"),
    (lambda: normal_moment(*leaning_rates()), "are not at right angles"),
    (lambda: steady_precession(1.0, 2.1, 1.0, spin=1.0, mgr=0.1), "no body has I = 2.1"),
    (lambda: steady_precession(0.0, 1.0, 1.0, spin=1.0, mgr=0.1), "I0 must be positive"),
    (lambda: steady_precession(1.0, -0.1, 1.0, spin=1.0, mgr=0.1), "no body"),
    (lambda: steady_precession(0.6, 0.25, 0.9, spin=np.array([12.0, 0.1]), mgr=1.5), "no steady precession is possible"),
    (lambda: steady_precession(1.0, 1.0, 1.0, spin=0.0, mgr=1.0), "without spin a body can hold no moment"),
    (lambda: steady_precession(1.0, 0, 0.5, spin=100.0, mgr=1.0), "without I no spin helps"),
    (lambda: steady_precession(1.0, 1.0, 1.0, spin=1.0), "give one of mgr"),
    (lambda: steady_precession(1.0, 1.0, 1.0, mgr=1.0), "give either spin"),
    (lambda: steady_precession(1.0, 1.0, 0.0, spin=1.0, moment=1.0), "no line of nodes at theta = .* to have a moment about"),
    (lambda: steady_spin(1.0, 1.0, 1.0, 0.0, mgr=1.0), "the precession is zero"),
    (lambda: least_spin(1.0, 1.0, 1.0, mgr=1.0, of="omega"), "of is one of 'spin', 'omega_z'"),
    (lambda: fast_spin(0.6, 0.25, 0.9, 0.0, mgr=1.5), "approximations for a fast spin"),
    (lambda: free_precession(1.0, 1.0, 0.4, 10.0), "with I = I0 there is no precession"),
    (lambda: free_precession(1.0, 0.3, math.pi / 2, 10.0), "is pi/2: H has no axial component"),
    (lambda: nutation(0.6, 0.25, 1.5, sympy.Symbol("theta"), 0.0, 0.0, spin=20.0), "the limits of nutation need numbers"),
    (lambda: nutation(0.6, 0.25, 1.5, 0.9, 0.0, 0.0), "give either spin"),
])  # fmt: skip
def test_what_does_not_exist_or_is_not_given_is_refused_in_words(ask, words):
    with pytest.raises((GyroError, ArgumentError), match=words):
        ask()


@every_kind
def test_eqn_10_34_fast_spin_and_its_error(kind):
    I0, I, theta, spin, mgr = numbers(kind, "0.6", "0.25", "0.9", 40, "1.5")
    found = fast_spin(I0, I, theta, spin, mgr=mgr)
    true = steady_precession(I0, I, theta, spin=spin, mgr=mgr)
    assert close(found.slow, mgr / (I * spin), small(kind))
    assert close(found.fast, I * spin / ((I0 - I) * cos(theta)), 10 * small(kind))
    assert close(found.slow_error, found.slow / true.slow - 1, small(kind))
    assert close(found.fast_error, found.fast / true.fast - 1, small(kind))


@every_kind
def test_eqn_10_37_and_10_38_axis_level(kind):
    I0, I, dpsi, dphi = numbers(kind, "0.6", "0.25", "1.2", 40)
    ground, level, tiny = Frame("ground"), pi(dpsi) / 2, 10 * small(kind)
    M = I * dpsi * dphi
    assert close(steady_moment(I0, I, level, dpsi, dphi), M, tiny)
    rates = ground.vector(0, dpsi, 0), ground.vector(0, 0, dphi)
    assert close(normal_moment(*rates, I), (M, 0, 0), tiny)
    body = euler_frame(ground, "body", moving(0 * dpsi, dpsi), level, moving(0 * dphi, dphi))
    H = gyro_momentum(body, ground, I0, I)
    assert close(H, (0, I0 * dpsi, I * dphi), tiny)
    assert close(cross(body.parent.angular_velocity(ground), H), (M, 0, 0), tiny)


# -- without moment (10.35), (10.36)


@every_kind
def test_eqn_10_35_and_10_36_free_precession_needs_no_moment(kind):
    I0, I, theta, spin = numbers(kind, "0.6", "0.25", "0.9", 5)
    found = free_precession(I0, I, theta, spin)
    assert close(found.rate, I * spin / ((I0 - I) * cos(theta)), 10 * small(kind))
    assert close(steady_moment(I0, I, theta, found.rate, spin), 0, 100 * small(kind))
    both = steady_precession(I0, I, theta, spin=spin, mgr=0)
    assert close((both.slow, both.fast), (0, found.rate), 10 * small(kind))


@pytest.mark.parametrize(("I0", "I"), [(1.0, 0.3), (1.0, 1.7)])
def test_the_cones_of_the_instantaneous_axis(I0, I):
    theta, spin = 0.4, 10.0
    found = free_precession(I0, I, theta, spin)
    ground = Frame("ground")
    body = euler_frame(ground, "body", moving(0.0, found.rate), theta, moving(0.0, spin))
    omega = body.angular_velocity(ground)
    along = 1 if omega.dot(body.k) > 0 else -1
    assert found.body_cone == pytest.approx((omega * along).angle_to(body.k), rel=1e-12)
    to_K = omega.angle_to(ground.k)
    assert found.space_cone == pytest.approx(min(to_K, math.pi - to_K), rel=1e-12)


# -- nutation: its frequency and limits


@pytest.mark.parametrize("theta", [0.2, 0.9, math.pi / 2, 2.5])
@pytest.mark.parametrize("which", ["slow", "fast"])
def test_the_stiffness_is_the_curvature_of_the_effective_potential(theta, which):
    I0, I, wz, mgr = (mp.mpf(x) for x in ("0.6", "0.25", "12", "1.5"))
    theta = mp.mpf(theta)
    found = steady_precession(I0, I, theta, omega_z=wz, mgr=mgr)
    dpsi = getattr(found, which)
    h = I * wz
    p = I0 * dpsi * mp.sin(theta) ** 2 + h * mp.cos(theta)
    U = lambda x: (p - h * mp.cos(x)) ** 2 / (2 * I0 * mp.sin(x) ** 2) + mgr * mp.cos(x)
    with mp.workdps(50):
        curvature = mp.diff(U, theta, 2) / I0
    true = found.stiffness[0 if which == "slow" else 1]
    assert abs(curvature / true - 1) < mp.mpf(10) ** -12
    assert abs(nutation_stiffness(I0, I, theta, dpsi, wz) - true) <= mp.mpf(10) ** -25 * true


def ordinary(low, high):
    """Numbers with six decimals: squares of rates of 1e-106 are below the range of floats."""
    return st.floats(low, high).map(lambda x: round(x, 6))


@settings(max_examples=20)
@given(ordinary(0.1, 3), ordinary(-3, 3), ordinary(-5, 5), ordinary(-30, 30), ordinary(-4, 4), ordinary(0.05, 1.9))  # fmt: skip
def test_limits_of_nutation_have_the_energy_of_the_start(theta, theta_rate, precession, wz, mgr, I):
    found = nutation(1.0, I, mgr, theta, theta_rate, precession, omega_z=wz)
    assert found.theta_min - 1e-14 <= theta <= found.theta_max + 1e-14
    I, mgr, theta, rate, dpsi, wz = map(mp.mpf, (I, mgr, theta, theta_rate, precession, wz))
    true = nutation(mp.mpf(1), I, mgr, theta, rate, dpsi, omega_z=wz)
    # another test goes through the vertical, where the scale below is infinite
    assume(min(mp.sin(true.theta_min), mp.sin(true.theta_max)) > 1e-9)
    scale = 1 + 1 / abs(mp.sin(true.theta_min)) + 1 / abs(mp.sin(true.theta_max))
    assert abs(found.theta_min - true.theta_min) < 1e-7
    h, s2, c = I * wz, mp.sin(theta) ** 2, mp.cos(theta)
    p, E = dpsi * s2 + h * c, (rate**2 + dpsi**2 * s2) / 2 + mgr * c
    for angle in (true.theta_min, true.theta_max):
        s2, c = mp.sin(angle) ** 2, mp.cos(angle)
        f = (p - h * c) ** 2 - 2 * s2 * (E - mgr * c)
        assert abs(f) < mp.mpf(10) ** -24 * (p * p + h * h + abs(E) + 1) * scale


def test_small_nutations_keep_their_digits():
    """Displaced by 1e-9 rad/s: the roots of f in cos(theta) would be good only to 1e-8."""
    I0, I, mgr, theta, wz = 0.6, 0.25, 1.5, 0.9, 20.0
    found = steady_precession(I0, I, theta, omega_z=wz, mgr=mgr)
    rate = 1e-9
    seen = nutation(I0, I, mgr, theta, rate, found.slow, omega_z=wz, tolerance=1e-15)
    frequency = math.sqrt(found.stiffness[0])
    assert (seen.theta_max - seen.theta_min) / 2 == pytest.approx(rate / frequency, rel=1e-4)
    assert seen.period == pytest.approx(2 * math.pi / frequency, rel=1e-9)
    assert nutation(I0, I, mgr, theta, 0.0, found.slow, omega_z=wz).kind == "steady"


@pytest.mark.parametrize("tilt", [1e-3, 1e-8])
def test_near_the_vertical_no_digits_are_lost(tilt):
    start = 0.6, 0.25, 1.5, 0.4, 0.0, 12.0 / 2.4 + tilt
    true = nutation(*map(mp.mpf, start), omega_z=mp.mpf(12.0), tolerance=1e-20)
    found = nutation(*start, omega_z=12.0, tolerance=1e-20)
    assert abs(found.theta_min - true.theta_min) < 1e-14
    assert abs(found.theta_max - true.theta_max) < 1e-14


def test_nutation_of_a_plane_pendulum_and_of_arrays():
    found = nutation(1.0, 0, 2.0, 2.5, 0.0, 0.0, omega_z=0.0)
    assert found.kind == "planar"
    assert found.theta_max == pytest.approx(math.pi, abs=1e-14)
    found = nutation(0.6, 0.25, 1.5, 0.9, 0.0, np.array([0.0, 0.2, -0.2]), spin=20.0)
    assert found.kind == ["cusps", "waves", "loops"]
    one = nutation(0.6, 0.25, 1.5, 0.9, 0.0, 0.2, spin=20.0)
    assert found.theta_max[1] == pytest.approx(one.theta_max, rel=1e-15)


# -- the sleeping top


@pytest.mark.parametrize(("part", "stable"), [
    (0.9, False), (1 - 1e-4, False), (1 - 1e-12, False), (1.0, True), (1 + 1e-12, True), (1.1, True),
])  # fmt: skip
def test_the_sleeping_top_on_both_sides_of_its_threshold(part, stable):
    I0, I, mgr = 0.25, 0.5, 1.0  # critical rate 2 sqrt(I0 mgr)/I = 2
    found = sleeping_top(I0, I, mgr, 2.0 * part)
    assert (found.critical, found.stable, found.growth == 0) == (2.0, stable, stable)
    assert found.margin == pytest.approx(part**2, rel=1e-15)
    if not stable:
        growth = math.sqrt(mgr / I0) * math.sqrt((1 - part) * (1 + part))
        assert found.growth == pytest.approx(growth, rel=4e-16 / (1 - part))
    if part <= 1 - 1e-4:  # from upright, by the energy
        falls = nutation(I0, I, mgr, 1e-9, 0.0, 0.0, omega_z=2.0 * part).theta_max
        assert falls == pytest.approx(math.acos(2 * part**2 - 1), rel=1e-8)


def test_a_hanging_top_needs_no_spin_and_a_sleeping_one_that_of_the_formula():
    found = sleeping_top(0.25, 0.5, -1.0, 0.0)
    assert found.stable
    assert found.critical == 0
    assert found.margin == math.inf
    I0, I, mgr, w = sympy.symbols("I0 I mgr omega", positive=True)
    found = sleeping_top(I0, I, mgr, w)
    assert found.stable is None
    assert sympy.simplify(found.critical - 2 * sympy.sqrt(I0 * mgr) / I) == 0

"""Models of the top, the gyrocompass and the spherical pendulum, against Lagrange's equations, each
other, and the limits of nutation.
"""

import math

import numpy as np
import pytest
import sympy

from newton_euler import cos, sin
from newton_euler.applications import sleeping_top
from newton_euler.applications.nutation import nutation
from newton_euler.kinematics import euler_from_quaternion, quaternion_from_euler, quaternion_product
from newton_euler.motion import ModelError
from newton_euler.scenes.planar.hinged_rod import hinged, rod
from newton_euler.scenes.spatial import top
from newton_euler.scenes.spatial.gyrocompass import gyrocompass
from newton_euler.scenes.spatial.spherical_pendulum import nodding, pendulum
from tests.explicit import by_scipy
from tests.kinds import close, every_kind, numbers, rates, small


def swings(model, start, seconds):
    """The extremes of theta in a run of the model, and their times."""
    n, turning = model.states.index("theta"), model.states.index("theta_rate")
    out = by_scipy(model, start, seconds, events=lambda t, y: y[turning])
    return out.y_events[0][:, n], out.t_events[0]


@pytest.mark.parametrize(("theta_rate", "precession", "kind"), [
    (0.0, 0.0, "cusps"), (0.0, 0.2, "waves"), (0.0, -0.2, "loops"),
    (0.4, 0.1, "loops"), (0.05, 0.3, "waves"), (0.0, 3.0, "loops"),
])  # fmt: skip
def test_limits_of_nutation_against_integration(theta_rate, precession, kind):
    I0, I, mgr, theta, spin = 0.6, 0.25, 1.5, 0.9, 20.0
    found = nutation(I0, I, mgr, theta, theta_rate, precession, spin=spin)
    assert found.kind == kind
    wz = spin + precession * math.cos(theta)
    model = top.euler(I0, I, mgr, wz)
    extremes, times = swings(model, (0, theta, 0, precession, theta_rate), 3 * found.period)
    limits = found.theta_min, found.theta_max
    assert (min(extremes), max(extremes)) == pytest.approx(limits, abs=1e-10)
    later = times[times > 1e-6]
    assert later[2] - later[0] == pytest.approx(found.period, rel=1e-8)
    p, last = I0 * precession * math.sin(theta) ** 2 + I * wz * math.cos(theta), found.theta_max
    rate = (p - I * wz * math.cos(last)) / (I0 * math.sin(last) ** 2)
    assert found.precession_at_max == pytest.approx(rate, rel=1e-9)


def test_a_top_that_reaches_the_vertical():
    """It starts upright with theta' = 1, below its critical rate, so that p_psi = p_phi."""
    found = nutation(0.6, 0.25, 1.5, 0.0, 1.0, 0.0, omega_z=3.0)
    assert found.kind == "through the vertical"
    assert found.theta_min == 0
    assert math.isnan(found.precession_at_min)
    assert 0.1 < found.theta_max < math.pi
    model = top.nutation(0.6, 0.25, 1.5, 3.0, 0)
    extremes, _ = swings(model, (0.0, 1.0), 20.0)
    assert max(abs(extremes)) == pytest.approx(found.theta_max, abs=1e-10)


def test_a_small_tilt_grows_at_the_predicted_rate():
    I0, I, mgr, wz = 0.25, 0.5, 1.0, 1.6
    growth = sleeping_top(I0, I, mgr, wz).growth
    start = (1.0, 0.0, 0.0, 0.0, 1e-7, 0.0)
    model = top.nonspinning_frame(I0, I, mgr, wz)
    out = by_scipy(model, start, 8, rtol=1e-11, atol=1e-18, t_eval=(4.0, 8.0))
    tilt = np.hypot(out.y[1], out.y[2])
    assert math.log(tilt[1] / tilt[0]) / 4.0 == pytest.approx(growth, rel=0.02)


TOP = {"I0": 0.6, "I": 0.25, "mgr": 1.5, "omega_z": 9.0}
START = {"psi": 0.3, "theta": 0.8, "phi": 0.0, "psi_rate": 0.7, "theta_rate": -0.4}
DIFFERENCE = top.momentum_difference(0.6, 0.25, START["theta"], START["psi_rate"], 9.0)


def run(model, start, seconds):
    return [tuple(state) for state in by_scipy(model, start, seconds).y.T.tolist()]


def rolled_start(angles):
    """The state of the frame that does not spin, placed on {i, j, k} at the start (phi = 0)."""
    q = quaternion_from_euler(angles["psi"], angles["theta"], 0.0)
    return *q, angles["theta_rate"], angles["psi_rate"] * math.sin(angles["theta"])


def test_the_three_models_of_the_top_agree():
    T = 3.0
    by_euler = run(top.euler(**TOP), tuple(START.values()), T)[-1]
    nutating = top.nutation(**TOP, momentum_difference=DIFFERENCE)
    by_theta = run(nutating, (START["theta"], START["theta_rate"]), T)[-1]
    rolled = run(top.nonspinning_frame(**TOP), rolled_start(START), T)[-1]
    assert by_theta == pytest.approx((by_euler[1], by_euler[4]), abs=1e-9)
    half = TOP["omega_z"] * T / 2
    body = quaternion_product(rolled[:4], (math.cos(half), 0, 0, math.sin(half)))
    psi, theta, phi = euler_from_quaternion(body)
    assert theta == pytest.approx(by_euler[1], abs=1e-9)
    assert math.remainder(psi - by_euler[0], 2 * math.pi) == pytest.approx(0, abs=1e-9)
    assert math.remainder(phi - by_euler[2], 2 * math.pi) == pytest.approx(0, abs=1e-8)


@pytest.mark.parametrize(("model", "start"), [
    (top.euler(**TOP), tuple(START.values())),
    (top.nutation(**TOP, momentum_difference=DIFFERENCE), (0.8, -0.4)),
    (top.nonspinning_frame(**TOP), rolled_start(START)),
    # through the upright position
    (top.nonspinning_frame(**TOP), (1.0, 0.0, 0.0, 0.0, 0.3, 0.0)),
    (pendulum(3.0, 2.0, 9.81), rolled_start(START)),
    (nodding(3.0, 2.0, 9.81, 2.5, 1.0), (2.5, 0.0)),
    (hinged(**rod(3.0, 2.0, 4.0, 9.81)), (0.5, 0.0)),
    (gyrocompass(0.002, 0.003, 1000.0, 7.292e-5, 0.8), (0.5, 0.0)),
    (top.free(0.6, 0.25, 9.0), rolled_start(START)),
], ids=lambda x: getattr(x, "name", ""))  # fmt: skip
def test_invariants_are_kept(model, start):
    states = run(model, start, 5.0)
    assert model.invariants
    for name in model.invariants:
        values = [model.invariant(name, state) for state in states]
        assert max(values) - min(values) < 1e-9 * (1 + abs(values[0])), name


@every_kind
def test_the_models_obey_eqn_10_25(kind):
    I0, I, theta, dtheta, dpsi, mgr = numbers(kind, "0.6", "0.25", "0.9", "0.5", "1.2", "1.5")
    wz, tiny = numbers(kind, 9), small(kind, 0.1)
    s, c = sin(theta), cos(theta)
    *rates, ddpsi, ddtheta = top.euler(I0, I, mgr, wz).derivative((0, theta, 0, dpsi, dtheta))
    assert close(rates, (dpsi, dtheta, wz - dpsi * c), tiny)
    assert close(I0 * (ddtheta - dpsi * dpsi * s * c) + I * wz * dpsi * s, mgr * s, tiny)
    assert close(I0 * (ddpsi * s + 2 * dpsi * dtheta * c) - I * dtheta * wz, 0, tiny)
    difference = top.momentum_difference(I0, I, theta, dpsi, wz)
    reduced = top.nutation(I0, I, mgr, wz, difference).derivative((theta, dtheta))
    assert close(reduced, (dtheta, ddtheta), small(kind))


def test_upright_euler_angles_fail_the_other_models_do_not_and_lengths_do_not_matter():
    with pytest.raises(ModelError, match="the coordinates are singular there"):
        top.euler(**TOP).derivative((0.0, 0.0, 0.0, 0.7, 0.1))
    assert top.nutation(**TOP, momentum_difference=0).derivative((0.0, 0.1)) == (0.1, 0.0)
    upright = top.nonspinning_frame(**TOP).derivative((1.0, 0.0, 0.0, 0.0, 0.1, 0.0))
    assert all(map(math.isfinite, upright))
    model = top.nonspinning_frame(**TOP)
    short, long = (model.derivative((*(x * q for q in (0.96, 0.28, 0.0, 0.0)), 0.1, 0.2)) for x in (1, 1.086))  # fmt: skip
    assert close(long[4:], short[4:], 1e-14)  # rad/s^2


@pytest.mark.parametrize("kind", ["float", "array", "mpmath"])
def test_the_free_body_has_an_exact_solution(kind):
    I0, I, wz, t = numbers(kind, "0.6", "0.25", 9, 2)
    start = (*quaternion_from_euler(*numbers(kind, "0.3", "0.8", 0)), *numbers(kind, "-0.4", "0.5"))
    model = top.free(I0, I, wz)
    end = model.solution(t, start)
    for name in ("energy", "norm", "p_psi"):
        before, after = model.invariant(name, start), model.invariant(name, end)
        assert close(after, before, small(kind, 10))
    if kind == "float":
        assert run(model, start, t)[-1] == pytest.approx(end, abs=1e-10)
        x = sympy.Symbol("t")  # it is a formula too
        formula = [float(part.subs(x, 2)) for part in model.solution(x, start)]
        assert formula == pytest.approx(end, abs=1e-12)
    found = rates(lambda t: model.solution(t, start), t)
    assert close(found, model.derivative(end), small(kind, 10))


def test_section_10_11_the_gyrocompass_from_lagranges_equation():
    t = sympy.Symbol("t")
    I0, I, wz, E, lat = sympy.symbols("I0 I omega_z Omega lambda", positive=True)
    alpha, phi = sympy.Function("alpha")(t), sympy.Function("phi")(t)
    level, vertical = E * sympy.cos(lat) * sympy.sin(alpha), E * sympy.sin(lat) + alpha.diff(t)
    axial = phi.diff(t) + E * sympy.cos(lat) * sympy.cos(alpha)
    T = I0 * (level**2 + vertical**2) / 2 + I * axial**2 / 2
    equation = T.diff(alpha.diff(t)).diff(t) - T.diff(alpha)
    x = sympy.Symbol("x")
    acceleration = gyrocompass(I0, I, wz, E, lat).derivative((x, sympy.Symbol("rate")))[1]
    put = {alpha.diff(t, 2): acceleration, phi.diff(t): wz - E * sympy.cos(lat) * sympy.cos(alpha)}
    assert sympy.simplify(equation.subs(put).subs(alpha, x)) == 0


def test_section_10_4_the_spherical_pendulum_in_a_plane_and_on_a_cone():
    planar = pendulum(3.0, 2.0, 9.81)
    tilted = (*quaternion_from_euler(0.0, 2.5, 0.0), 0.0, 0.0)
    acceleration = planar.derivative(tilted)[4]
    assert acceleration == pytest.approx(3 * 9.81 / (2 * 2.0) * math.sin(2.5), rel=1e-14)
    cone = math.sqrt(3 * 9.81 / (2 * 2.0 * abs(math.cos(2.5))))
    assert nodding(3.0, 2.0, 9.81, 2.5, cone).derivative((2.5, 0))[1] == pytest.approx(0, abs=1e-12)

"""Chapter 11, the worked examples of 11.15, 11.16, 11.17, 11.19, and audits of motions that an integrator made.

(11.4 is in test_ch11_work.py.) Oracles: SciPy on second-order equations of motion, energy by bodies in frames.
"""

import math

import mpmath as mp
import numpy as np
import pytest
import sympy
from scipy.integrate import solve_ivp

from newton_euler import Dimension, Frame, at, cos, moving, sin
from newton_euler.bodies import MassError
from newton_euler.bodies.body import Body
from newton_euler.bodies.solids import sphere
from newton_euler.dynamics.energy import EnergyError, audit, kinetic_energy, kinetic_energy_about, plane_kinetic_energy
from newton_euler.dynamics.work import power
from newton_euler.kinematics.rotations import euler_frame
from newton_euler.motion.model import ModelError
from newton_euler.scenes.particles.car_on_hill import Car
from newton_euler.scenes.planar.pendulum import pendulum_energy, physical_pendulum, swing_rate
from newton_euler.scenes.planar.rolling_sphere import friction_needed, rolling_down, rolling_energy, rolling_speed
from newton_euler.scenes.planar.sliding_sphere import rolling_begins, sphere_at
from newton_euler.scenes.spatial.top import euler, top_energy
from tests.kinds import KINDS, close, numbers

every_kind = pytest.mark.parametrize("kind", KINDS)
MASS, LENGTH, TIME = Dimension(1, 0, 0), Dimension(0, 1, 0), Dimension(0, 0, 1)


def small(kind):
    """Absolute, for quantities of order 10: a few round-offs of the kind."""
    return 1e-12 if kind in ("float", "array") else mp.mpf(10) ** -25


def integrated(model, start, end):
    """States by name as functions of time, by SciPy in short steps."""
    rhs = model.compiled_rhs()
    run = solve_ivp(lambda t, y: rhs(t, *y.tolist()), (0.0, end), start, "DOP853", rtol=1e-12, atol=1e-13, max_step=0.05, dense_output=True)
    return lambda t: dict(zip(model.states, run.sol(t).tolist(), strict=True))


# -- the rolling sphere (11.15)


@every_kind
def test_example_11_15_seven_tenths_of_m_v2(kind):
    m, R, v = numbers(kind, 3, "0.2", 2)
    T = rolling_energy(m, R, v)
    assert close(T.value, 7 * m * v * v / 10, small(kind))
    assert close(T.terms["translation"] / T.value, 0 * m + 5 * v / (7 * v), small(kind))
    assert close(T.terms["rolling"] / T.value, 0 * m + 2 * v / (7 * v), small(kind))


@every_kind
def test_example_11_15_by_a_body_in_a_frame_and_about_the_contact(kind):
    m, R, v, pivoting = numbers(kind, 3, "0.25", 2, 5)
    ground = Frame("ground")
    G = ground.point("G", moving(0 * v, v), 0, R)
    frame = ground.rotate("pivot", "z", rate=pivoting, origin=G).rotate("ball", "y", rate=v / R)
    ball = sphere(R, frame, mass=m)
    T = rolling_energy(m, R, v, pivoting)
    assert close(kinetic_energy(ball, ground).value, T.value, small(kind))
    assert close(kinetic_energy_about(ball, ground.point("C", 0, 0, 0), ground).value, T.value, small(kind))
    assert close(T.terms["pivoting"], m * R * R * pivoting**2 / 5, small(kind))  # the component that the book leaves out


@every_kind
def test_example_11_15_speed_after_a_drop(kind):
    h, g = numbers(kind, "0.7", 10)
    assert close(rolling_speed(h, g) ** 2, 10 * g * h / 7, 10 * small(kind))
    assert close(rolling_speed(h, g, k=0) ** 2, 2 * g * h, 10 * small(kind))  # in free fall


def test_example_11_15_the_motion_down_the_plane():
    model = rolling_down(0.5, 9.81)
    x, v = model.solution(1.5, (0.0, 0.0))
    assert v == pytest.approx(rolling_speed(x * math.sin(0.5), 9.81), rel=1e-14)
    run = integrated(model, (0.0, 0.0), 1.5)(1.5)
    assert run["v"] == pytest.approx(v, rel=1e-11)
    assert model.invariant("energy over mass", (x, v)) == pytest.approx(0, abs=1e-13)


def test_example_11_15_the_vertical_plane_is_only_a_limit():
    """The friction needed over the normal force grows beyond bounds, which the book does not say."""
    assert friction_needed(math.pi / 4) == pytest.approx(2 / 7)
    assert friction_needed(math.pi / 2 - 1e-6) > 1e5


# -- the heavy top (11.16)


@every_kind
def test_example_11_16_energy_of_the_top_by_a_body_in_frames(kind):
    I0, I, mgr, theta, nod, precession, spin = numbers(kind, "1.5", 1, 10, "0.8", "0.4", 2, 9)
    ground = Frame("ground")
    frame = euler_frame(ground, "top", moving(theta, precession), moving(theta, nod), moving(theta, spin))
    T = kinetic_energy(Body("top", I, frame, (I0, I0, I)), ground).value
    height = frame.point("G", 0, 0, 1).position(ground).z
    assert close(top_energy(I0, I, mgr, theta, nod, precession, spin).value, T + mgr * height, 10 * small(kind))


def test_example_11_16_with_the_books_sign_the_sum_is_not_constant():
    """Against the integrated motion of a nodding top: plus stays, minus (as printed) does not."""
    I0, I, mgr, omega_z = 0.02, 0.01, 0.5, 60.0
    states = integrated(euler(I0, I, mgr, omega_z), (0.0, 0.6, 0.0, 0.0, 0.0), 0.5)
    right, printed = [], []
    for t in np.linspace(0.0, 0.5, 11):
        s = states(t)
        E = top_energy(I0, I, mgr, s["theta"], s["theta_rate"], s["psi_rate"], omega_z - s["psi_rate"] * math.cos(s["theta"]))
        right.append(E.value)
        printed.append(E.reweighted(weight=-1))
    assert np.ptp(right) < 1e-9 * abs(right[0])
    assert np.ptp(printed) > 1e-2 * mgr


# -- the physical pendulum (11.17)


@every_kind
def test_example_11_17_about_the_mass_centre_and_about_the_pivot(kind):
    m, I, l, g, theta, omega = numbers(kind, 2, "0.5", "0.75", "9.81", "0.6", 3)
    E = pendulum_energy(m, I, l, g, theta, omega)
    assert close(E.value, (I + m * l * l) * omega * omega / 2 - m * g * l * cos(theta), small(kind))
    ground = Frame("ground")  # x down, z along the axis
    frame = ground.rotate("body", "z", moving(theta, omega))
    body = Body("body", m, frame.point("G", l, 0, 0), (I, I, I))
    assert close(kinetic_energy_about(body, ground.origin, ground).value, E.terms["translation"] + E.terms["rotation"], small(kind))
    assert close(kinetic_energy(body, ground).terms["translation"], E.terms["translation"], small(kind))
    assert close(-m * g * body.centre.position(ground).x, E.terms["weight"], small(kind))


@every_kind
def test_example_11_17_its_equation_of_motion_follows_from_the_energy(kind):
    """dE/dt = 0 with theta' = omega, omega' from the Model."""
    m, I, l, g, theta, omega = numbers(kind, 2, "0.5", "0.75", "9.81", "0.6", 3)
    model = physical_pendulum(m, I, l, g)
    rates = model.derivative((theta, omega))
    E = at(lambda t: pendulum_energy(m, I, l, g, theta + omega * t, omega + rates[1] * t).value, 0 * m)
    assert close(E.rate, 0, 10 * small(kind))


def test_example_11_17_along_the_motion_and_how_far_it_swings():
    model = physical_pendulum(2.0, 0.5, 0.75, 9.81)
    states = integrated(model, (1.2, 0.0), 2.0)
    E = [model.invariant("energy", states(t)) for t in np.linspace(0, 2, 9)]
    assert np.ptp(E) < 1e-9 * abs(E[0])
    for t in (0.3, 0.9, 1.4):
        s = states(t)
        assert swing_rate(2.0, 0.5, 0.75, 9.81, s["theta"], 1.2) == pytest.approx(abs(s["omega"]), rel=1e-8)
    with pytest.raises(EnergyError, match="does not get there"):
        swing_rate(2.0, 0.5, 0.75, 9.81, 1.3, 1.2)


def test_example_11_17_near_the_turning_point_nothing_cancels():
    near = swing_rate(1.0, 0.0, 1.0, 9.81, 1.0 - 1e-12, 1.0)
    step = 1.0 - (1.0 - 1e-12)
    assert near == pytest.approx(math.sqrt(2 * 9.81 * step * math.sin(1.0)), rel=1e-11)
    naive = 2 * 9.81 * (math.cos(1.0 - 1e-12) - math.cos(1.0))
    assert not math.isclose(math.sqrt(naive), near, rel_tol=1e-6)


# -- the car on a hill (11.19)


def car(kind):
    m, wheel, k, r, g = numbers(kind, 1200, 20, "0.25", "0.3", "9.81")
    return Car(m, wheel, k, r, lambda v: v * v / 2, g)


@every_kind
def test_example_11_19_power_of_the_engine(kind):
    c = car(kind)
    v, a, theta = numbers(kind, 20, "0.8", "0.1")
    P = c.powers(v, a, theta)
    ratio = c.gyration / c.radius
    expected = c.m * v * a + 4 * c.wheel_mass * ratio * ratio * v * a + c.m * c.g * v * sin(theta) + v * v / 2 * v
    assert close(P.value, expected, 1e4 * small(kind))
    assert list(P.terms) == ["accelerate", "wheels", "climb", "air"]
    assert close(c.acceleration(P.value, v, theta), a, 10 * small(kind))


@every_kind
def test_example_11_19_it_is_the_rate_of_the_energy(kind):
    """v = 3 + 2 t up a slope: d(T + V)/dt and the drag, by the jet; T from bodies: the car and four rolling wheels."""
    c = car(kind)
    t, theta = numbers(kind, 4, "0.1")
    v = lambda t: 3 + 2 * t  # noqa: E731
    climbed = at(lambda t: c.kinetic_energy(v(t)).value + c.m * c.g * (3 * t + t * t) * sin(theta), t).rate
    assert close(c.power(v(t), 2 + 0 * t, theta), climbed + v(t) ** 3 / 2, 1e4 * small(kind))
    wheel = plane_kinetic_energy(c.wheel_mass, v(t), c.wheel_mass * c.gyration**2, v(t) / c.radius).value
    whole = (c.m - 4 * c.wheel_mass) * v(t) ** 2 / 2 + 4 * wheel
    assert close(c.kinetic_energy(v(t)).value, whole, 1e4 * small(kind))


def test_example_11_19_the_books_of_a_drive_uphill_close():
    c = car("float")
    model = c.model(power=4e4, slope=lambda s, p, t: 0.05 + 0.02 * sin(s.s / 50))
    states = integrated(model, (0.0, 10.0), 5.0)
    height = lambda s: solve_ivp(lambda x, y: [math.sin(0.05 + 0.02 * math.sin(x / 50))], (0, s), [0.0], rtol=1e-12, atol=1e-12).y[0, -1]  # noqa: E731
    powers = {"engine": lambda t: 4e4, "air": lambda t: -(states(t)["v"] ** 3) / 2}
    books = audit(lambda t: c.kinetic_energy(states(t)["v"]), 0.0, 5.0, {"weight": lambda t: c.m * c.g * height(states(t)["s"])}, powers, rtol=1e-8)
    assert books.balances(rtol=1e-8)
    assert books.works["engine"] == pytest.approx(2e5)
    assert books.heat("air") > 0
    without_wheels = audit(lambda t: c.kinetic_energy(states(t)["v"]).without("wheels"), 0.0, 5.0, {"weight": lambda t: 0.0}, powers, rtol=1e-8)
    assert not without_wheels.balances(rtol=1e-3)


def test_example_11_19_units_and_a_car_at_rest():
    c = Car(MASS, MASS, LENGTH, LENGTH, lambda v: MASS * v * v / LENGTH, LENGTH / TIME**2)
    assert c.power(LENGTH / TIME, LENGTH / TIME**2, Dimension()) == MASS * LENGTH**2 / TIME**3
    with pytest.raises((ModelError, ZeroDivisionError)):
        car("float").model(1000.0, 0.0).derivative((0.0, 0))


# -- audits of motions with loss and drive


@pytest.fixture(scope="module")
def damped_driven():
    """A pendulum with a damper c omega and a driving moment M cos(n t), integrated from rest at 1 rad for 6 s; its powers."""
    m, l, g, c, M, n = 1.5, 0.8, 9.81, 0.3, 2.5, 2.0
    rates = lambda t, y: (y[1], (-m * g * l * math.sin(y[0]) - c * y[1] + M * math.cos(n * t)) / (m * l * l))  # noqa: E731
    sol = solve_ivp(rates, (0, 6), (1.0, 0.0), "DOP853", rtol=1e-12, atol=1e-13, max_step=0.05, dense_output=True).sol
    return {
        "kinetic": lambda t: m * (l * sol(t)[1]) ** 2 / 2,
        "weight": lambda t: -m * g * l * math.cos(sol(t)[0]),
        "damper": lambda t: -c * sol(t)[1] ** 2,
        "drive": lambda t: M * math.cos(n * t) * sol(t)[1],
    }


def books_of(p, *powers, weight=1.0):
    return audit(p["kinetic"], 0.0, 6.0, {"weight": lambda t: weight * p["weight"](t)}, {n: p[n] for n in powers}, rtol=1e-8)


def test_the_books_of_a_damped_driven_pendulum_close(damped_driven):
    books = books_of(damped_driven, "damper", "drive")
    assert books.balances(rtol=1e-8)
    assert books.heat("damper") > 1  # J
    assert books.energy == pytest.approx(books.works["drive"] - books.heat("damper"), abs=1e-7)


@pytest.mark.parametrize("left", ["damper", "drive"])
def test_what_is_left_out_is_what_is_missing(damped_driven, left):
    whole = books_of(damped_driven, "damper", "drive")
    books = books_of(damped_driven, *({"damper", "drive"} - {left}))
    assert not books.balances(rtol=1e-8)
    assert books.missing == pytest.approx(whole.works[left], abs=1e-7)


def test_a_wrong_sign_of_the_potential_is_missing_twice(damped_driven):
    books = books_of(damped_driven, "damper", "drive", weight=-1.0)
    assert not books.balances(rtol=1e-8)
    right = books_of(damped_driven, "damper", "drive")
    assert books.missing == pytest.approx(-2 * right.potentials["weight"], abs=1e-7)


@pytest.mark.parametrize("v0", [7.0, np.array([2.0, 5.0, 7.0])])
def test_the_books_of_a_sphere_that_slides_and_then_rolls(v0):
    """Friction mu m g at the slip v + omega r: 1/7 m v0^2 becomes heat, and what stays is that of rolling."""
    m, mu, g, r = 2.0, 0.2, 10.0, 0.5
    begins = rolling_begins(v0, mu, g, r)
    ground = Frame("ground")

    def motion(t):
        _, v, omega = sphere_at(t, v0, mu, g, r)
        G = ground.point("G", moving(0.0 * v, v), r, 0)
        return sphere(r, ground.rotate("ball", "z", rate=omega, origin=G), mass=m)

    def friction(t):
        """Only while there is slip; at the contact point of the ball, which slides on the ground."""
        ball = motion(t)
        contact = ball.centre.velocity(ground) + ball.frame.angular_velocity(ground).cross(-r * ground.j)
        return power(-mu * m * g * ground.i, contact)

    breaks = np.unique(begins.t).tolist()
    books = audit(lambda t: kinetic_energy(motion(t), ground), 0.0, 2.0, powers={"friction": friction}, breaks=breaks)
    assert books.balances()
    assert np.allclose(books.heat("friction"), m * v0**2 / 7, rtol=1e-12)
    assert np.allclose(kinetic_energy(motion(2.0), ground).value, 7 / 10 * m * (5 / 7 * v0) ** 2, rtol=1e-14)
    naive = audit(lambda t: kinetic_energy(motion(t), ground), 0.0, 2.0)  # as if it rolled all the time
    assert not naive.balances()
    assert np.allclose(naive.missing, -m * v0**2 / 7, rtol=1e-12)


def test_a_formula_of_the_heat_of_the_sphere():
    m, v0, mu, g, r = sympy.symbols("m v_0 mu g r", positive=True)
    begins = rolling_begins(v0, mu, g, r)
    slip = lambda t: v0 - mu * g * t - 5 * mu * g * t / 2  # noqa: E731
    T = lambda t: m * (v0 - mu * g * t) ** 2 / 2 + m * (5 * mu * g * t / 2) ** 2 / 5  # noqa: E731
    books = audit(T, sympy.Integer(0), begins.t, powers={"friction": lambda t: -mu * m * g * slip(t)}, exact=True)
    assert books.balances()
    assert sympy.simplify(books.heat() - m * v0**2 / 7) == 0


def test_a_body_without_mass_is_refused():
    with pytest.raises(MassError, match="must be positive"):
        sphere(0.5, Frame("ball"), mass=-1.0)

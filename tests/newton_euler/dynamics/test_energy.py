"""Chapter 11, (11.12)-(11.14), (11.26)-(11.33), (11.36)-(11.53): kinetic energy, its rate, and the
energy equation as an audit.

The oracle for a rigid body is a handful of mass points in explicit motion: rotation matrices as
functions of time, differentiated by the product rule. No omega x r, no inertia matrix, no Euler
equation.
"""

import math

import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

from newton_euler import (
    Dimension,
    Frame,
    at,
    composite,
    cos,
    exp,
    moving,
    particle,
    sin,
    sqrt,
)
from newton_euler.algebra import WorkError
from newton_euler.algebra.ledger import Amount
from newton_euler.bodies.body import Body
from newton_euler.bodies.inertia import Inertia
from newton_euler.bodies.solids import box, cylinder, disk
from newton_euler.dynamics.energy import (
    Audit,
    EnergyError,
    audit,
    gyroscope_energy,
    kinetic_energy,
    kinetic_energy_about,
    kinetic_energy_rate,
    plane_kinetic_energy,
    rigid_power,
    speed_after,
)
from newton_euler.dynamics.potential import conservative_force, spring_potential, weight_potential
from newton_euler.dynamics.work import power, work_integral
from newton_euler.kinematics import along
from newton_euler.kinematics.rotations import apply, euler_frame, in_sequence, rotation_matrix
from tests.kinds import LENGTH, MASS, TIME, close, every_kind, numbers, within

ENERGY = MASS * LENGTH**2 / TIME**2
I, K = (1, 0, 0), (0, 0, 1)
# mass and position in the body
POINTS = (
    (2, (1, "0.5", 0)),
    (1, ("-0.5", 1, "0.25")),
    (3, (0, "-0.75", 1)),
    ("1.5", ("0.25", 0, "-1.25")),
)

small = within(1e-12, 25)


class Tumbling:
    """Four mass points on a turning frame whose origin moves: as points, and as a Body."""

    def __init__(self, kind, t=None, fixed=False):
        self.a, self.b, self.v = numbers(kind, "0.7", "-1.2", 0 if fixed else 2)
        self.t = numbers(kind, "0.5") if t is None else t
        self.masses = [numbers(kind, m) for m, _ in POINTS]
        self.places = [numbers(kind, *r) for _, r in POINTS]
        self.ground = Frame("ground")
        self.moved = [self.place(r) for r in self.places]

    def yaw(self, t):
        return self.b * t

    def pitch(self, t):
        return self.a + self.b * t * t

    def origin(self, t):
        return self.v * t, self.v * t * t, -self.v * t

    def place(self, r):
        """Rectangular ground coordinates, as moving numbers, of the point at r in the body."""

        def where(t):
            pitch, yaw = rotation_matrix(I, self.pitch(t)), rotation_matrix(K, self.yaw(t))
            turned = apply(in_sequence(pitch, yaw), r)
            return tuple(x + y for x, y in zip(turned, self.origin(t), strict=True))

        return along(where, self.t)

    def kinetic(self):
        """T with its rate: sum of m (x'^2 + y'^2 + z'^2)/2."""
        squares = (sum(moving(x.rate, x.acceleration) ** 2 for x in c) for c in self.moved)
        return sum(m * s for m, s in zip(self.masses, squares, strict=True)) / 2

    def centre(self):
        """The position of G in the ground, as moving numbers."""
        total = sum(self.masses)
        parts = [[m * x for x in c] for m, c in zip(self.masses, self.moved, strict=True)]
        return [sum(column) / total for column in zip(*parts, strict=True)]

    def loads(self):
        """Resultant force and moment about G that the points need, in ground components."""
        G, vector = self.centre(), self.ground.vector
        force = moment = vector(0, 0, 0)
        for m, c in zip(self.masses, self.moved, strict=True):
            f = vector(*(m * x.acceleration for x in c))
            arm = vector(*(x.value - g.value for x, g in zip(c, G, strict=True)))
            force, moment = force + f, moment + arm.cross(f)
        return force, moment

    def body(self):
        O = self.ground.point("O", *along(self.origin, self.t))
        yawed = self.ground.rotate("yaw", "z", at(self.yaw, self.t), origin=O)
        frame = yawed.rotate("body", "x", at(self.pitch, self.t))
        return composite("body", self.particles(frame, self.places))

    def particles(self, frame, places):
        rows = enumerate(zip(self.masses, places, strict=True))
        return [particle(m, frame.point(f"P{n}", *r), f"P{n}") for n, (m, r) in rows]


@every_kind
def test_eqn_11_12_the_work_of_the_resultant_is_the_gain_of_m_v2_over_2(kind):
    m, t = numbers(kind, 2, "0.75")
    v = lambda t: (t * t, 3 * t, 1 - t)
    F = lambda t: (2 * m * t, 3 * m, -m)
    U = work_integral(lambda s: power(F(s), v(s)), 0, t, exact=kind == "sympy")
    speeds = [sum(x * x for x in v(s)) for s in (0 * t, t)]
    assert close(U.value, m * (speeds[1] - speeds[0]) / 2, small(kind))


@every_kind
def test_eqn_11_13_kinetic_energy_of_a_particle(kind):
    m, x, y, z = numbers(kind, 2, 1, "-0.5", 3)
    ground = Frame("ground")
    T = kinetic_energy(
        particle(m, ground.point("P", moving(0 * x, x), moving(0 * y, y), moving(0 * z, z))), ground
    )
    assert close(T.value, m * (x * x + y * y + z * z) / 2, small(kind))
    assert close(T.terms["rotation"], 0, 0)


@every_kind
def test_eqn_11_14_speed_after_work(kind):
    v0, U, m = numbers(kind, 3, 8, 2)
    v1 = speed_after(v0, U, m)
    assert close(m * (v1 * v1 - v0 * v0) / 2, U, small(kind))
    assert close(speed_after(v0, Amount(U), m), v1, 0)


def test_eqn_11_14_it_just_gets_there_or_not():
    assert speed_after(3.0, -9.0, 2.0) == 0
    words = r"does not get there: the work -9\.0001 takes more than the kinetic energy 9, so it st"
    with pytest.raises(EnergyError, match=words):
        speed_after(3.0, -9.0001, 2.0)
    with pytest.raises(EnergyError, match="does not get there"):
        speed_after(np.array([3.0, 1.0]), -9.0, 2.0)


@every_kind
def test_eqn_11_42_the_mass_points_one_by_one(kind):
    scene = Tumbling(kind)
    T = kinetic_energy(scene.particles(scene.ground, scene.moved), scene.ground)
    assert (list(T.terms), T.number) == (["P0", "P1", "P2", "P3"], "11.42")
    assert close(T.value, scene.kinetic().value, small(kind))


@every_kind
def test_eqn_11_43_44_the_mixed_term_vanishes_about_the_mass_centre(kind):
    scene = Tumbling(kind)
    G, masses = scene.centre(), scene.masses
    rho = [[x.rate - g.rate for x, g in zip(c, G, strict=True)] for c in scene.moved]
    for n in range(3):
        assert close(sum(m * v[n] for m, v in zip(masses, rho, strict=True)), 0, small(kind))
    T = kinetic_energy(scene.body(), scene.ground).terms
    about = sum(m * sum(x * x for x in v) for m, v in zip(masses, rho, strict=True)) / 2
    assert close(T["translation"], sum(masses) * sum(g.rate**2 for g in G) / 2, small(kind))
    assert close(T["rotation"], about, small(kind))


@every_kind
def test_eqn_11_45_of_the_body_is_that_of_its_points(kind):
    scene = Tumbling(kind)
    body, ground = scene.body(), scene.ground
    T = kinetic_energy(body, ground)
    assert close(T.value, scene.kinetic().value, small(kind))
    v, omega = body.centre.velocity(ground), body.frame.angular_velocity(ground)
    halves = v.dot(body.momentum(ground)) + omega.dot(body.angular_momentum(ground))
    assert close(halves / 2, T.value, small(kind))
    assert T.number == "11.45"


@every_kind
def test_eqn_11_50_angular_momentum_in_plane_motion_leans_with_the_products(kind):
    Ixx, Iyy, Izz, Ixz, Iyz, w = numbers(kind, 2, 3, 4, "0.5", "-0.25", 6)
    ground = Frame("ground")
    frame = ground.rotate("plate", "z", rate=w)
    body = Body("plate", w, frame, Inertia(frame, (Ixx, Iyy, Izz), (0, Iyz, Ixz), tolerance=None))
    assert close(body.angular_momentum(ground), (-Ixz * w, -Iyz * w, Izz * w), small(kind))
    # the products of inertia drop out
    assert close(kinetic_energy(body, ground).value, Izz * w * w / 2, 10 * small(kind))


@every_kind
def test_eqn_11_51_plane_motion(kind):
    m, a, v, w = numbers(kind, 2, "0.5", 3, 4)
    ground = Frame("ground")
    G = ground.point("G", moving(0 * v, v), moving(0 * v, -v), 0)
    wheel = disk(a, ground.rotate("wheel", "z", rate=w, origin=G), "z", mass=m)
    T = plane_kinetic_energy(m, v * sqrt(2 + 0 * v), m * a * a / 2, w)
    check_terms(kinetic_energy(wheel, ground), T, small(kind))


def check_terms(found, expected, small):
    """Raises AssertionError unless the amounts have the same value and the same terms."""
    assert close(found.value, expected.value, small)
    for name in expected.terms:
        assert close(found.terms[name], expected.terms[name], small), name


@every_kind
def test_eqn_11_52_about_a_fixed_point(kind):
    scene = Tumbling(kind, fixed=True)
    body, ground = scene.body(), scene.ground
    expected = scene.kinetic().value
    # as a point of the body, and as a point of the ground
    for B in (body.frame.point("B", 0, 0, 0), ground.origin):
        T = kinetic_energy_about(body, B, ground)
        assert close(T.value, expected, small(kind))
    assert close(kinetic_energy(body, ground).value, expected, small(kind))
    assert T.number == "11.52"


def rolling_wheel():
    """Ground and a disk of 3 kg that rolls along x at 2 m/s, its contact at the origin."""
    ground = Frame("ground")
    C = ground.point("C", moving(0.0, 2.0), 0.5, 0.0)
    return ground, disk(0.5, ground.rotate("wheel", "-z", rate=4.0, origin=C), "z", mass=3.0)


def test_eqn_11_52_about_the_contact_of_a_rolling_wheel():
    """The contact need only be at rest at the instant."""
    ground, wheel = rolling_wheel()
    T = kinetic_energy_about(wheel, ground.point("contact", 0, 0, 0), ground)
    assert T.value == pytest.approx(0.75 * 3.0 * 2.0**2, rel=1e-14)
    assert kinetic_energy(wheel, ground).value == pytest.approx(T.value, rel=1e-14)


def test_eqn_11_52_refuses_a_point_that_moves():
    ground, wheel = rolling_wheel()
    about = lambda y: kinetic_energy_about(wheel, ground.point("P", 0, y, 0), ground).value
    words = r"the point of disk at P moves, at 4: \(11\.52\) needs a point .* at rest in ground"
    with pytest.raises(EnergyError, match=words):
        about(1.0)
    assert about(0.5e-9) == pytest.approx(9.0, rel=1e-8)  # within the tolerance
    with pytest.raises(EnergyError, match="moves, at 4e-08"):
        about(1e-8)


@every_kind
def test_eqn_11_53_principal_axes_at_the_fixed_point(kind):
    a, b, c, m, w1, w2 = numbers(kind, 1, 2, "0.5", 6, "1.5", -2)
    ground = Frame("ground")
    frame = ground.rotate("one", "z", a, rate=w1).rotate("body", "x", b, rate=w2)
    brick, B = box(a, b, c, frame, mass=m), frame.point("B", 0, 0, 0)
    omega = frame.angular_velocity(ground).components(frame)
    expected = sum(i * w * w for i, w in zip(brick.about(B).moments, omega, strict=True)) / 2
    assert close(kinetic_energy_about(brick, B, ground).value, expected, small(kind))


@every_kind
def test_section_11_16_of_a_gyroscope_by_eulers_angles(kind):
    I0, I, theta, nod, precession, spin = numbers(kind, "1.5", 1, "0.8", "0.4", 2, 9)
    ground = Frame("ground")
    rotor = euler_frame(ground, "rotor", *(moving(theta, w) for w in (precession, nod, spin)))
    body = Body("rotor", I, rotor, (I0, I0, I))
    T = gyroscope_energy(I0, I, theta, nod, precession, spin)
    assert close(T.value, kinetic_energy(body, ground).value, 10 * small(kind))
    assert close(T.terms["axial"], I * (spin + precession * cos(theta)) ** 2 / 2, 10 * small(kind))


@every_kind
def test_eqn_11_36_the_force_drives_the_translation(kind):
    scene = Tumbling(kind)
    F, _ = scene.loads()
    body, ground = scene.body(), scene.ground
    squares = sum(moving(g.rate, g.acceleration) ** 2 for g in scene.centre())
    rate = (sum(scene.masses) * squares / 2).rate
    assert close(power(F, body.centre, ground), rate, small(kind))
    assert close(kinetic_energy_rate(body, ground).terms["translation"], rate, small(kind))


@every_kind
def test_eqn_11_38_11_39_only_the_change_of_H_in_the_body_works(kind):
    scene = Tumbling(kind)
    body, ground = scene.body(), scene.ground
    _, M = scene.loads()
    omega, H = body.frame.angular_velocity(ground), body.angular_momentum(ground)
    alpha = body.frame.angular_acceleration(ground)
    by_inertia = body.inertia.times(alpha).dot(omega)
    for known in (H.rate(body.frame).dot(omega), by_inertia, H.dot(alpha)):
        assert close(M.dot(omega), known, small(kind))
    assert close(omega.cross(H).dot(omega), 0, small(kind))


@every_kind
def test_eqn_11_40_the_moment_drives_the_rotation(kind):
    scene = Tumbling(kind)
    body, ground = scene.body(), scene.ground
    F, M = scene.loads()
    found = kinetic_energy_rate(body, ground)
    assert close(found.value, scene.kinetic().rate, small(kind))
    assert close(found.terms["rotation"], M.dot(body.frame.angular_velocity(ground)), small(kind))
    check_terms(rigid_power(body, ground, F, M), found, small(kind))


def test_eqn_11_37_41_46_47_integrated_forces_and_moments_give_the_gain_of_kinetic_energy():
    def power_at(t):
        scene = Tumbling("float", t)
        return rigid_power(scene.body(), scene.ground, *scene.loads())

    scenes = [Tumbling("float", t) for t in (0.0, 0.5)]
    before, after = (kinetic_energy(s.body(), s.ground).terms for s in scenes)
    for name in ("translation", "rotation"):
        U = work_integral(lambda t, name=name: power_at(t).terms[name], 0.0, 0.5, rtol=1e-8)
        assert U.value == pytest.approx(after[name] - before[name], rel=1e-8)
    gain = scenes[1].kinetic().value - scenes[0].kinetic().value
    U = work_integral(lambda t: power_at(t).value, 0.0, 0.5, rtol=1e-8)
    assert U.value == pytest.approx(gain, rel=1e-8)


class Driven:
    """A mass in plane motion under weight and a spring; any other force follows from m a."""

    def __init__(self, kind):
        self.m, self.g, self.K, self.end = numbers(kind, 2, "9.81", 20, "0.75")

    def place(self, t):
        return t * t, 1 - t**3

    def velocity(self, t):
        return 2 * t, -3 * t * t

    def kinetic(self, t):
        return self.m * sum(v * v for v in self.velocity(t)) / 2

    def weight(self, t):
        return weight_potential(self.m, self.place(t)[1], self.g)

    def spring(self, t):
        return spring_potential(self.K, self.place(t)[0])

    def other(self, t):
        """F^n = m a - weight - spring, in x and y."""
        x, _ = self.place(t)
        return 2 * self.m + self.K * x, -6 * self.m * t + self.m * self.g

    def power(self, t):
        return power(self.other(t), self.velocity(t))

    def audit(self, kind, **changed):
        potentials = {"weight": self.weight, "spring": self.spring}
        forces = {"potentials": potentials, "powers": {"motor": self.power}, **changed}
        return audit(self.kinetic, 0 * self.end, self.end, **forces, exact=kind == "sympy")


@every_kind
def test_eqn_11_26_27_each_conservative_force_is_minus_a_gradient(kind):
    d = Driven(kind)
    P = Frame("ground").point("P", *d.place(d.end), 0)
    weight = conservative_force(lambda x, y, z: weight_potential(d.m, y, d.g), P)
    spring = conservative_force(lambda x, y, z: spring_potential(d.K, x), P)
    assert close(weight, (0, -d.m * d.g, 0), small(kind))
    assert close(spring, (-d.K * P.x[0].value, 0, 0), small(kind))
    total = weight + spring + P.frame.vector(*d.other(d.end), 0)
    assert close(total, (2 * d.m, -6 * d.m * d.end, 0), 10 * small(kind))  # m a


@every_kind
def test_eqn_11_28_29_30_31_48_the_change_of_T_is_potential_lost_and_work_done(kind):
    d, tiny = Driven(kind), 10 * small(kind)
    balance = d.audit(kind)
    lost = -sum(balance.potentials.values())
    assert close(balance.kinetic, lost + balance.works["motor"], tiny)
    assert close(balance.energy, balance.works["motor"], tiny)  # E: other forces alone
    assert close(balance.residual, 0, tiny)
    assert balance.balances()
    by_hand = d.kinetic(d.end) + d.weight(d.end) - d.weight(0 * d.end) + d.spring(d.end)
    assert close(balance.works["motor"], by_hand, tiny)


@every_kind
def test_eqn_11_32_49_without_them_E_is_constant(kind):
    """A mass hangs on a spring: x = a cos(n t) about equilibrium, n^2 = K/m."""
    m, g, a, t = numbers(kind, 2, "9.81", "0.5", "1.5")
    n = 0 * m + 3
    K = m * n * n
    rest = m * g / K
    x, v = (lambda t: rest + a * cos(n * t)), (lambda t: -n * a * sin(n * t))
    potentials = {
        "weight": lambda t: weight_potential(m, -x(t), g),
        "spring": lambda t: spring_potential(K, x(t)),
    }
    balance = audit(lambda t: m * v(t) ** 2 / 2, 0 * t, t, potentials)
    assert close(balance.energy, 0, 10 * small(kind))
    assert balance.balances()
    assert not close(balance.kinetic, 0, 0.1)


@every_kind
def test_eqn_11_33_friction_becomes_internal_energy(kind):
    """A block thrown along a level surface: v = v0 - mu g t until it stops."""
    m, mu, g, v0 = numbers(kind, 2, "0.25", 10, 3)
    stop = v0 / (mu * g)
    v = lambda t: v0 - mu * g * t
    T, drag = lambda t: m * v(t) ** 2 / 2, {"friction": lambda t: -mu * m * g * v(t)}
    balance = audit(T, 0 * stop, stop, powers=drag, exact=kind == "sympy")
    assert close(balance.heat("friction"), m * v0 * v0 / 2, 10 * small(kind))
    assert close(balance.energy + balance.heat(), 0, 10 * small(kind))
    with pytest.raises(EnergyError, match="no work of 'drag' is in this audit; it has friction"):
        balance.heat("drag")


@every_kind
@pytest.mark.parametrize("left_out", ["weight", "spring"])
def test_a_force_left_out_is_the_residual_of_the_energy_balance(kind, left_out):
    d = Driven(kind)
    all_of_them = {"weight": d.weight, "spring": d.spring}
    balance = d.audit(kind, potentials={n: f for n, f in all_of_them.items() if n != left_out})
    change = all_of_them[left_out](d.end) - all_of_them[left_out](0 * d.end)
    assert not balance.balances()
    assert close(balance.residual, -change, 10 * small(kind))
    if kind == "float":
        assert str(balance).endswith(f"\n  residual             {balance.residual:.6g}")


def test_an_audit_prints_its_energy_balance():
    balance = Driven("float").audit("float")
    assert isinstance(balance, Audit)
    title, *rows = str(balance).splitlines()
    assert title == "energy equation (11.29), J"
    assert [row.split("  ")[1].strip() for row in rows] == [
        "change of T", "change of V, weight", "change of V, spring", "less work, motor", "residual",
    ]  # fmt: skip


def test_both_sides_of_the_tolerance_of_the_energy_balance():
    drop = lambda extra: audit(
        lambda t: 50.0 * t * t + extra * t, 0.0, 1.0, powers={"push": lambda t: 100.0 * t}
    )
    assert drop(1e-8).balances()
    assert not drop(1e-5).balances()
    assert drop(1e-5).balances(rtol=1e-6)


@settings(max_examples=20)
@example(2.0, 1.0, 0.0, 0.0, 8.138680426062033e-160)  # energies that underflow
@given(st.floats(0.5, 5), st.floats(0.5, 3), st.floats(0, 0.9), st.floats(-1, 1), st.floats(-2, 2))
def test_the_energy_balance_of_any_damped_oscillator_closes(m, n, zeta, x0, v0):
    """Its exact solution, with the damper's heat: x = exp(-zeta n t)(a cos(d t) + b sin(d t))."""
    d = n * math.sqrt(1 - zeta * zeta)
    b = (v0 + zeta * n * x0) / d
    x = lambda t: exp(-zeta * n * t) * (x0 * cos(d * t) + b * sin(d * t))
    v = lambda t: at(x, t).rate
    spring = {"spring": lambda t: spring_potential(m * n * n, x(t))}
    damper = {"damper": lambda t: -2 * zeta * n * m * v(t) ** 2}
    balance = audit(lambda t: m * v(t) ** 2 / 2, 0.0, 2.0, spring, damper)
    assert balance.balances()
    assert balance.heat("damper") >= 0


@pytest.mark.parametrize(("arguments", "message"), [
    ({"kinetic": 3.0}, "the kinetic energy must be a function of time, as in lambda t"),
    ({"powers": {"drag": 3.0}}, "the power of drag must be a function of time"),
    ({"kinetic": lambda t: ENERGY}, r"Dimension\(.*\) has no size to be compared; put numbers in"),
])  # fmt: skip
def test_an_audit_that_cannot_be_kept_is_refused_in_words(arguments, message):
    with pytest.raises((EnergyError, WorkError), match=message):
        audit(**{"kinetic": lambda t: t, "start": 0.0, "end": 1.0, **arguments})


def test_energies_have_the_units_of_energy():
    ground, rate, inertia = Frame("ground"), 1 / TIME, MASS * LENGTH**2
    G = ground.point("G", moving(LENGTH, LENGTH * rate, LENGTH * rate**2), 0, 0)
    frame = ground.rotate("body", "z", rate=rate, acceleration=rate**2, origin=G)
    ball = cylinder(LENGTH, LENGTH, frame, "x", mass=MASS)
    B = ground.point("B", LENGTH, LENGTH, 0)
    for energy in (kinetic_energy(ball, ground), kinetic_energy_about(ball, B, ground)):
        assert energy.value == ENERGY
    assert plane_kinetic_energy(MASS, LENGTH * rate, inertia, rate).value == ENERGY
    assert gyroscope_energy(inertia, inertia, Dimension(), rate, rate, rate).value == ENERGY
    assert kinetic_energy_rate(ball, ground).value == ENERGY / TIME
    assert speed_after(LENGTH / TIME, ENERGY, MASS) == LENGTH / TIME

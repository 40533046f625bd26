"""Chapter 9: fixed-axis rotation. (9.7)-(9.10), against the printed sums and against mass points in
explicit motion; balance and balancing.
"""

import math

import mpmath as mp
import numpy as np
import pytest
import sympy
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.integrate import solve_ivp

from newton_euler import Dimension, Frame, compiled, cos, sin
from newton_euler.applications.rotors import (
    RotorError,
    balance,
    balancing_masses,
    corrections,
    imbalance,
    reactions,
    shaft_axis,
)
from newton_euler.bodies.body import Body, composite, particle
from newton_euler.bodies.solids import disk, plate, rod
from newton_euler.chapters.examples.ch09 import unbalanced_rotor
from newton_euler.dynamics.momentum import resultant_moment
from newton_euler.scenes.planar.rotor import turning_rotor
from tests.kinds import KINDS, close, numbers

every_kind = pytest.mark.parametrize("kind", KINDS)


def tolerance(kind):
    """Absolute, for quantities of order 10: some round-offs of the kind."""
    return 1e-13 if kind in ("float", "array") else mp.mpf(10) ** -26


# -- general case (9.7)-(9.10)

MASS, CENTRE, MOMENTS, PRODUCTS = (
    3,
    ("0.02", "-0.03", "0.05"),
    ("0.4", "0.5", "0.3"),
    ("0.01", "-0.02", "0.03"),
)


def general(kind):
    """The scene, and what (9.9) is written in: m, centre, I_xz, I_yz, I_zz, a, b, psi, omega,
    alpha, g.
    """
    m, g, a, b, psi, omega, alpha = numbers(
        kind, MASS, "9.81", "0.25", "0.35", "0.8", "3.5", "-2.5"
    )
    centre, moments, products = (numbers(kind, *v) for v in (CENTRE, MOMENTS, PRODUCTS))
    scene = unbalanced_rotor(m, centre, moments, products, a, b, psi, omega, alpha)
    return scene, (m, centre, products[2], products[1], moments[2], a, b, psi, omega, alpha, g)


def printed_9_9(m, centre, Ixz, Iyz, Izz, a, b, psi, omega, alpha, g):
    """The ten sums of (9.9), (9.10), as the book has them (the fourth term of A_y with its right
    sign).
    """
    x, y, z = centre
    length, c, s, w2 = a + b, cos(psi), sin(psi), omega * omega
    A = (
        m * g * (z - b) / length * c
        - b / length * m * w2 * x
        + w2 / length * Ixz
        - b / length * m * alpha * y
        + alpha / length * Iyz,
        -m * g * (z - b) / length * s
        - b / length * m * w2 * y
        + w2 / length * Iyz
        + b / length * m * alpha * x
        - alpha / length * Ixz,
    )
    B = (
        -m * g * (z + a) / length * c
        - a / length * m * w2 * x
        - w2 / length * Ixz
        - a / length * m * alpha * y
        - alpha / length * Iyz,
        m * g * (z + a) / length * s
        - a / length * m * w2 * y
        - w2 / length * Iyz
        + a / length * m * alpha * x
        + alpha / length * Ixz,
    )
    return (*A, 0), (*B, 0), m * g * (x * s + y * c) + alpha * Izz


@every_kind
def test_eqn_9_7_sum_of_forces(kind):
    scene, (m, (x, y, _), *_, psi, omega, alpha, g) = general(kind)
    found = scene.reactions(gravity=g * scene.ground.i)
    expected = (
        -m * g * cos(psi) - m * alpha * y - m * omega * omega * x,
        m * g * sin(psi) + m * alpha * x - m * omega * omega * y,
        0,
    )
    assert close(found.A + found.B, expected, tolerance(kind))
    assert close(found.axial, 0, tolerance(kind))


@every_kind
def test_eqn_9_8_sum_of_moments_about_the_origin(kind):
    scene, (m, (_, _, z), Ixz, Iyz, _, a, b, psi, omega, alpha, g) = general(kind)
    found = scene.reactions(gravity=g * scene.ground.i)
    left = (a * found.A.y - b * found.B.y, -a * found.A.x + b * found.B.x)
    right = (
        -m * g * z * sin(psi) - alpha * Ixz + omega * omega * Iyz,
        -m * g * z * cos(psi) - alpha * Iyz - omega * omega * Ixz,
    )
    assert close(left, right, tolerance(kind))


@every_kind
def test_eqn_9_9_reactions_of_any_rotor(kind):
    scene, numbers_of_it = general(kind)
    found = scene.reactions(gravity=numbers_of_it[-1] * scene.ground.i)
    A, B, _ = printed_9_9(*numbers_of_it)
    assert close(found.A, A, tolerance(kind))
    assert close(found.B, B, tolerance(kind))


@every_kind
def test_eqn_9_9_term_by_term(kind):
    scene, (m, (x, y, z), Ixz, Iyz, _, a, b, psi, omega, alpha, g) = general(kind)
    terms, length, w2 = scene.reactions(gravity=g * scene.ground.i).A.terms, a + b, omega * omega
    for name, expected in {
        "weight": (m * g * (z - b) / length * cos(psi), -m * g * (z - b) / length * sin(psi), 0),
        "static": (-b / length * m * w2 * x, -b / length * m * w2 * y, 0),
        "dynamic": (w2 / length * Ixz, w2 / length * Iyz, 0),
        "static_euler": (-b / length * m * alpha * y, b / length * m * alpha * x, 0),
        "dynamic_euler": (alpha / length * Iyz, -alpha / length * Ixz, 0),
    }.items():
        assert close(terms[name], expected, tolerance(kind)), name


@every_kind
def test_eqn_9_10_the_driving_moment(kind):
    scene, numbers_of_it = general(kind)
    found = scene.reactions(gravity=numbers_of_it[-1] * scene.ground.i)
    assert close(found.moment, printed_9_9(*numbers_of_it)[2], tolerance(kind))


def test_eqn_9_9_as_formulas():
    m, x, y, z, Ixz, Iyz, Izz, psi, omega, alpha, g = sympy.symbols(
        "m x y z Ixz Iyz Izz psi omega alpha g", real=True
    )
    a, b = sympy.symbols("a b", positive=True)
    Ixx, Iyy, Ixy = sympy.symbols("Ixx Iyy Ixy")
    scene = unbalanced_rotor(
        m, (x, y, z), (Ixx, Iyy, Izz), (Ixy, Iyz, Ixz), a, b, psi, omega, alpha
    )
    found = scene.reactions(gravity=g * scene.ground.i)
    A, B, M = printed_9_9(m, (x, y, z), Ixz, Iyz, Izz, a, b, psi, omega, alpha, g)
    for mine, printed in zip((*found.A, *found.B, found.moment), (*A, *B, M), strict=True):
        assert sympy.simplify(sympy.expand(mine - printed)) == 0


def test_eqn_9_9_has_the_units_of_force():
    mass, length, time, pure = (
        Dimension(1, 0, 0),
        Dimension(0, 1, 0),
        Dimension(0, 0, 1),
        Dimension(),
    )
    inertia = mass * length**2
    scene = unbalanced_rotor(
        mass,
        (length,) * 3,
        (inertia,) * 3,
        (inertia,) * 3,
        length,
        length,
        pure,
        1 / time,
        1 / time**2,
    )
    found = scene.reactions(gravity=length / time**2 * scene.ground.i)
    assert {found.A.x, found.A.y, found.B.x, found.B.y} == {mass * length / time**2}
    assert found.moment == mass * length**2 / time**2


def test_reactions_can_be_compiled():
    def force(psi, omega, alpha):
        scene = unbalanced_rotor(
            3.0,
            (0.02, -0.03, 0.05),
            (0.4, 0.5, 0.3),
            (0.01, -0.02, 0.03),
            0.25,
            0.35,
            psi,
            omega,
            alpha,
        )
        return scene.reactions(gravity=9.81 * scene.ground.i).A

    psi = np.linspace(0, 6, 7)
    fast = compiled(force)(psi, 3.0, 2.0)
    assert close(fast[:2], force(psi, 3.0, 2.0).components()[:2], 1e-13)


# -- mass points in explicit motion: no inertia matrix, no omega x H


def points_of_a_rotor():
    """Masses and places in the axes of the shaft, and the same as a Body."""
    shaft_points = [(2, (1, 2, -1)), (1, (-2, 1, 3)), (3, (1, -1, 2)), (1, (0, 2, 1))]
    return [(mp.mpf(m), tuple(mp.mpf(x) / 10 for x in r)) for m, r in shaft_points]


@pytest.mark.parametrize("oblique", [False, True])
def test_reactions_hold_for_mass_points_in_explicit_motion(oblique):
    masses, t0, a, b = points_of_a_rotor(), mp.mpf("0.4"), mp.mpf("0.5"), mp.mpf("0.7")
    angle, g = lambda t: 1 + 2 * t + 3 * t * t, (mp.mpf("1.5"), mp.mpf("-9"), mp.mpf("2.5"))
    ground = Frame("ground")
    base = ground.rotate("base", (1, 2, 2), mp.mpf("0.9")) if oblique else ground
    shaft = base.rotate("shaft", "z", angle(t0), 2 + 6 * t0, mp.mpf(6))
    A, B = shaft.point("A", 0, 0, -a), shaft.point("B", 0, 0, b)
    body = composite(
        "rotor",
        [particle(m, shaft.point("P", *r), f"point {n}") for n, (m, r) in enumerate(masses)],
    )
    found = reactions(body, A, B, ground, gravity=base.vector(*g))

    def place(r):
        return lambda t: (
            r[0] * mp.cos(angle(t)) - r[1] * mp.sin(angle(t)),
            r[0] * mp.sin(angle(t)) + r[1] * mp.cos(angle(t)),
            r[2],
        )

    # that the supports must give, about the origin
    force, moment = [mp.mpf(0)] * 3, [mp.mpf(0)] * 3
    with mp.workdps(60):
        for m, r in masses:
            where = place(r)(t0)
            load = [
                m * (mp.diff(lambda t, n=n, r=r: place(r)(t)[n], t0, 2) - g[n]) for n in range(3)
            ]
            force = [f + x for f, x in zip(force, load, strict=True)]
            crossed = [
                where[(n + 1) % 3] * load[(n + 2) % 3] - where[(n + 2) % 3] * load[(n + 1) % 3]
                for n in range(3)
            ]
            moment = [M + x for M, x in zip(moment, crossed, strict=True)]
    FA, FB = (v.components(base) for v in (found.A, found.B))
    small = mp.mpf(10) ** -24
    assert close((FA[0] + FB[0], FA[1] + FB[1], found.axial), tuple(force), small)
    assert close(
        (a * FA[1] - b * FB[1], -a * FA[0] + b * FB[0], found.moment), tuple(moment), small
    )


def test_the_rate_of_momentum_is_that_of_chapter_8():
    scene, _ = general("float")
    found = scene.reactions()
    arm_A, arm_B = scene.A - scene.O, scene.B - scene.O
    held = arm_A.cross(found.A) + arm_B.cross(found.B) + found.axis * found.moment
    assert close(held, resultant_moment(scene.body, scene.ground, scene.O), 1e-13)


def test_the_reactions_do_not_depend_on_the_point_of_the_terms():
    scene, _ = general("float")
    gravity = 9.81 * scene.ground.i
    for about in (None, scene.A, scene.B, scene.shaft.point("Q", 0, 0, 7.0)):
        found = reactions(scene.body, scene.A, scene.B, scene.ground, gravity, about)
        assert close(found.A, scene.reactions(gravity).A, 1e-12)
        assert close(found.B, scene.reactions(gravity).B, 1e-12)


def test_a_vertical_shaft_carries_the_weight_along_itself():
    ground = Frame("ground")
    shaft = ground.rotate("shaft", "z", rate=4.0)
    found = reactions(
        disk(0.2, shaft.point("G", 0, 0, 0.1), "z", mass=2.0),
        shaft.origin,
        shaft.point("B", 0, 0, 1.0),
        ground,
        -10.0 * ground.k,
    )
    assert found.axial == 20.0
    assert found.A.norm() == found.B.norm() == 0


# -- the two kinds of imbalance (9.4)


def on_x(*bodies_of):
    shaft = Frame("shaft")
    A, B = shaft.point("A", -0.5, 0, 0), shaft.point("B", 0.5, 0, 0)
    return composite("rotor", [make(shaft) for make in bodies_of]), A, B


@pytest.mark.parametrize(
    ("rotor", "state"),
    [
        (on_x(lambda s: disk(0.2, s.origin, "x", mass=1.0)), "both"),
        (on_x(lambda s: disk(0.2, s.point("G", 0, 0.01, 0), "x", mass=1.0)), "dynamic"),
        (
            on_x(
                lambda s: particle(1.0, s.point("P", 0.2, 0.1, 0), "P"),
                lambda s: particle(1.0, s.point("Q", -0.2, -0.1, 0), "Q"),
            ),
            "static",
        ),
        (on_x(lambda s: disk(0.2, s.rotate("tilted", "z", 0.3), "x", mass=1.0)), "static"),
        (
            on_x(
                lambda s: rod(0.4, s.rotate("slant", "z", 0.6).point("G", 0.2, 0, 0), "x", mass=1.0)
            ),
            "neither",
        ),
    ],
)
def test_the_state_of_balance(rotor, state):
    verdict = balance(*rotor)
    assert verdict.state == state
    assert ("statically balanced" in str(verdict)) == (state in ("static", "both"))
    assert ("dynamically balanced" in str(verdict)) == (state in ("dynamic", "both"))


@pytest.mark.parametrize(("offset", "static"), [(0.9e-6, True), (1.1e-6, False)])
def test_static_balance_on_both_sides_of_its_tolerance(offset, static):
    k = math.sqrt((0.02 + 0.01 + 0.01) / 2)  # of a disk of radius 0.2 about its centre
    body, A, B = on_x(lambda s: disk(0.2, s.point("G", 0, offset * k, 0), "x", mass=1.0))
    assert balance(body, A, B, tolerance=1e-6).static is static


@pytest.mark.parametrize(("tilt", "dynamic"), [(0.9e-6, True), (1.1e-6, False)])
def test_dynamic_balance_on_both_sides_of_its_tolerance(tilt, dynamic):
    angle = tilt * 0.02 / (0.02 - 0.01)  # m k^2 over the difference of the moments
    body, A, B = on_x(lambda s: disk(0.2, s.rotate("tilted", "z", angle), "x", mass=1.0))
    verdict = balance(body, A, B, tolerance=1e-6)
    assert verdict.dynamic is dynamic
    assert verdict.tilt == pytest.approx(tilt, rel=1e-6)


def test_balance_does_not_depend_on_units():
    for scale in (1e-9, 1.0, 1e9):
        body, A, B = on_x(
            lambda s, f=scale: disk(0.2 * f, s.point("G", 0, 1e-12 * f, 0), "x", mass=1.0 * f)
        )
        assert balance(body, A, B).state == "both"


def test_a_ball_of_equal_moments_is_balanced_about_every_axis_through_its_centre():
    ground = Frame("ground")
    body = ground.rotate("body", (1, 2, 3), 0.7)
    cube = composite("cube", [plate(0.2, 0.2, body.point("C", s * 0.1, 0, 0), "x", mass=1.0, name=f"x{s}") for s in (-1, 1)]
                     + [plate(0.2, 0.2, body.point("C", 0, s * 0.1, 0), "y", mass=1.0, name=f"y{s}") for s in (-1, 1)]
                     + [plate(0.2, 0.2, body.point("C", 0, 0, s * 0.1), "z", mass=1.0, name=f"z{s}") for s in (-1, 1)])  # fmt: skip
    for end in ((1.0, 0, 0), (0.3, -0.4, 0.5), (-2.0, 1.0, 7.0)):
        assert balance(cube, body.origin, body.point("B", *end)).state == "both"


def test_dynamic_balance_asks_for_the_point_where_the_body_is_not_balanced_statically():
    body, A, B = on_x(lambda s: disk(0.2, s.point("G", 0.1, 0.01, 0), "x", mass=1.0))
    assert balance(body, A, B).dynamic
    assert not balance(body, A, B, about=A).dynamic


# -- balancing

coordinate = st.floats(-1, 1).map(lambda x: round(x, 3))
mass_points = st.lists(
    st.tuples(st.floats(0.1, 5), coordinate, coordinate, coordinate), min_size=1, max_size=5
)


@settings(max_examples=60, deadline=None)
@given(mass_points, st.floats(-2, 0.4), st.floats(0.6, 2), st.floats(0.05, 1), st.floats(-3, 3))
def test_balanced_rotors_have_no_dynamic_reactions(points, z1, z2, radius, alpha):
    ground = Frame("ground")
    shaft = ground.rotate("shaft", (1, -1, 2), 0.3, 4.0, alpha)
    axis = [x / math.sqrt(6) for x in (1, -1, 2)]
    A, B = (shaft.point(n, *(s * x for x in axis)) for n, s in (("A", 0.1), ("B", 1.3)))
    body = composite(
        "rotor", [particle(m, shaft.point("P", *r), f"P{n}") for n, (m, *r) in enumerate(points)]
    )
    weights = balancing_masses(body, A, B, (z1, z2), radius=radius)
    whole = composite("balanced", [body, *weights])
    before, after = reactions(body, A, B, ground), reactions(whole, A, B, ground)
    scale = sum(m for m, *_ in points) + sum(w.mass for w in weights)
    assert max(after.A.norm(), after.B.norm()) < 1e-12 * scale * 40
    assert balance(whole, A, B, tolerance=1e-10).state == "both"
    assert before.moment - after.moment == pytest.approx(
        -alpha * radius**2 * sum(w.mass for w in weights), abs=1e-10 * scale
    )


@every_kind
def test_balancing_by_given_masses_is_the_same_by_another_radius(kind):
    ground = Frame("ground")
    m, x, z, one, three, omega = numbers(kind, 2, "0.5", 1, 1, 3, 4)
    shaft = ground.rotate("shaft", "z", rate=omega)
    A, B = shaft.point("A", 0, 0, 0 * z), shaft.point("B", 0, 0, 4 * z)
    body = composite(
        "rotor",
        [particle(m, shaft.point("P", x, 0, z)), particle(one, shaft.point("Q", 0, x, three), "Q")],
    )
    for given_as in ({"radius": (one, three)}, {"mass": (one, three)}):
        weights = balancing_masses(body, A, B, (one / 2, 2 * three / 3), **given_as)
        found = reactions(composite("balanced", [body, *weights]), A, B, ground)
        assert close(found.A, (0, 0, 0), 10 * tolerance(kind))
        assert close(found.B, (0, 0, 0), 10 * tolerance(kind))


def test_one_plane_through_the_disk_needs_no_second_weight():
    shaft = Frame("shaft")
    A, B = shaft.point("A", -0.2, 0, 0), shaft.point("B", 0.3, 0, 0)
    wheel = disk(0.2, shaft.point("G", 0, 0.01, 0), "x", mass=4.0)
    first, second = balancing_masses(wheel, A, B, (0.2, 0.4), radius=0.1)
    assert first.mass == pytest.approx(0.4, rel=1e-15)
    assert first.centre.position(shaft).components() == pytest.approx((0, -0.1, 0), abs=1e-16)
    assert second.mass == pytest.approx(0, abs=1e-16)


def test_a_balanced_rotor_needs_no_weights():
    shaft = Frame("shaft")
    A, B = shaft.point("A", -0.2, 0, 0), shaft.point("B", 0.3, 0, 0)
    weights = balancing_masses(disk(0.2, shaft.origin, "x", mass=4.0), A, B, (0.1, 0.4), radius=0.1)
    assert [w.mass for w in weights] == [0, 0]


def test_corrections_as_formulas():
    m, r, z, z1, z2 = sympy.symbols("m r z z1 z2", positive=True)
    shaft = Frame("shaft")
    U1, U2 = corrections(
        particle(m, shaft.point("P", r, 0, z)),
        shaft.origin,
        shaft.point("B", 0, 0, sympy.Integer(1)),
        (z1, z2),
    )
    assert sympy.simplify(U1.x + m * r * (z2 - z) / (z2 - z1)) == 0
    assert sympy.simplify(U2.x + m * r * (z - z1) / (z2 - z1)) == 0


# -- errors


def wheel_on(shaft):
    return disk(0.2, shaft.point("G", 0, 0.01, 0), "x", mass=4.0)


def test_errors_in_words():
    ground = Frame("ground")
    shaft = ground.rotate("shaft", "x", rate=2.0)
    A, B = shaft.point("A", -0.2, 0, 0), shaft.point("B", 0.3, 0, 0)
    wheel = wheel_on(shaft)
    with pytest.raises(RotorError, match="bearings A and C coincide, and one point is no axis"):
        shaft_axis(A, shaft.point("C", -0.2, 0, 0))
    with pytest.raises(RotorError, match=r"planes coincide, at 0\.1 and 0\.1 from A"):
        corrections(wheel, A, B, (0.1, 0.1))
    with pytest.raises(
        RotorError, match=r"radius of the balancing weights must be positive, got 0: on the axis"
    ):
        balancing_masses(wheel, A, B, (0.1, 0.2), radius=0)
    with pytest.raises(
        RotorError, match=r"mass of the balancing weights must be positive, got -0\.1"
    ):
        balancing_masses(wheel, A, B, (0.1, 0.2), mass=(0.1, -0.1))
    with pytest.raises(RotorError, match="give either the radius"):
        balancing_masses(wheel, A, B, (0.1, 0.2), radius=0.1, mass=0.1)
    with pytest.raises(RotorError, match=r"Q lies 0\.1 off the axis"):
        reactions(wheel, A, B, ground, about=shaft.point("Q", 0, 0.1, 0))


def test_a_body_that_turns_about_another_axis_is_refused():
    ground = Frame("ground")
    shaft = ground.rotate("shaft", "y", rate=2.0)
    with pytest.raises(
        RotorError, match="does not turn about its bearings as a fixed axis: its angular velocity"
    ):
        reactions(
            wheel_on(shaft), shaft.point("A", -0.2, 0, 0), shaft.point("B", 0.3, 0, 0), ground
        )
    turning = ground.rotate("shaft", "x", rate=2.0)
    with pytest.raises(RotorError, match="the velocity of A"):
        reactions(
            wheel_on(turning),
            turning.point("A", -0.2, 0.1, 0),
            turning.point("B", 0.3, 0.1, 0),
            ground,
        )


def test_balance_of_expressions_is_refused_and_imbalance_is_not():
    shaft, d = Frame("shaft"), sympy.Symbol("d")
    wheel = Body("wheel", 1, shaft.point("G", 0, d, 0), (1, 1, 1))
    A, B = shaft.point("A", -1.0, 0, 0), shaft.point("B", 1.0, 0, 0)
    with pytest.raises(RotorError, match="depends on the values of its expressions"):
        balance(wheel, A, B)
    assert sympy.simplify(imbalance(wheel, A, B).static.y - d) == 0


# -- the exercises' kind of question, and motion


def test_eqn_9_10_as_motion_keeps_its_energy():
    model = turning_rotor(2.0, 0.1, 0.05, 0.3, 9.81, moment=0.4)
    rhs = model.compiled_rhs()
    out = solve_ivp(
        lambda t, y: rhs(t, *y.tolist()),
        (0, 5),
        (0.3, 1.0),
        method="DOP853",
        rtol=1e-12,
        atol=1e-12,
    )
    energies = [model.invariant("energy", state) for state in out.y.T.tolist()]
    assert max(energies) - min(energies) < 1e-9


@every_kind
def test_eqn_9_10_as_motion_agrees_with_the_moment(kind):
    scene, (m, (x, y, _), _, _, Izz, _, _, psi, omega, _, g) = general(kind)
    moment = scene.reactions(gravity=g * scene.ground.i).moment
    model = turning_rotor(m, x, y, Izz, g, moment)
    assert close(model.derivative((psi, omega))[1], numbers(kind, "-2.5"), 10 * tolerance(kind))

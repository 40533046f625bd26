"""The rotor of 9.5: its reactions against the printed sums (9.7)-(9.10), and as a motion."""

import numpy as np
import sympy

from newton_euler import Dimension, compiled, cos, sin
from newton_euler.applications.rotors import reactions
from newton_euler.chapters.examples.ch09 import unbalanced_rotor
from newton_euler.scenes.planar.rotor import turning_rotor
from tests.explicit import by_scipy
from tests.kinds import close, every_kind, numbers, small

CENTRE, MOMENTS, PRODUCTS = ("0.02", "-0.03", "0.05"), ("0.4", "0.5", "0.3"), ("0.01", "-0.02", "0.03")  # fmt: skip


def general(kind):
    """The scene; m, centre, I_xz, I_yz, I_zz, a, b, psi, omega, alpha, g of (9.9)."""
    m, g, a, b, psi, omega, alpha = numbers(kind, 3, "9.81", "0.25", "0.35", "0.8", "3.5", "-2.5")  # fmt: skip
    centre, moments, products = (numbers(kind, *v) for v in (CENTRE, MOMENTS, PRODUCTS))
    scene = unbalanced_rotor(m, centre, moments, products, a, b, psi, omega, alpha)
    return scene, (m, centre, products[2], products[1], moments[2], a, b, psi, omega, alpha, g)


def terms_of_A(m, centre, Ixz, Iyz, Izz, a, b, psi, omega, alpha, g):
    """The terms of A in (9.9) as the book has them (the fourth of A_y with the sign corrected)."""
    x, y, z = centre
    length, w2, weight = a + b, omega * omega, m * g * (z - b) / (a + b)
    return {
        "weight": (weight * cos(psi), -weight * sin(psi), 0),
        "static": (-b / length * m * w2 * x, -b / length * m * w2 * y, 0),
        "dynamic": (w2 / length * Ixz, w2 / length * Iyz, 0),
        "static_euler": (-b / length * m * alpha * y, b / length * m * alpha * x, 0),
        "dynamic_euler": (alpha / length * Iyz, -alpha / length * Ixz, 0),
    }


def printed_9_9(m, centre, Ixz, Iyz, Izz, a, b, psi, omega, alpha, g):
    """The sums of (9.9), (9.10); B is A with the bearings exchanged: a for b, and their senses."""
    x, y, _ = centre
    A = terms_of_A(m, centre, Ixz, Iyz, Izz, a, b, psi, omega, alpha, g)
    B = terms_of_A(m, centre, Ixz, Iyz, Izz, -b, -a, psi, omega, alpha, g)
    moment = m * g * (x * sin(psi) + y * cos(psi)) + alpha * Izz
    return *([sum(parts) for parts in zip(*terms.values(), strict=True)] for terms in (A, B)), moment  # fmt: skip


@every_kind
def test_eqn_9_7_to_9_10_reactions_and_driving_moment_of_any_rotor(kind):
    scene, printed = general(kind)
    found, tiny = scene.reactions(gravity=printed[-1] * scene.ground.i), small(kind, 0.1)
    A, B, moment = printed_9_9(*printed)
    assert close((found.A, found.B), (A, B), tiny)
    assert close((found.moment, found.axial), (moment, 0), tiny)
    for name, expected in terms_of_A(*printed).items():
        assert close(found.A.terms[name], expected, tiny), name
    m, (x, y, _), *_, psi, omega, alpha, g = printed
    across = -m * g * cos(psi) - m * alpha * y - m * omega * omega * x  # 9.7
    along = m * g * sin(psi) + m * alpha * x - m * omega * omega * y
    assert close(found.A + found.B, (across, along, 0), tiny)


def test_eqn_9_9_as_formulas():
    m, x, y, z, Ixz, Iyz, Izz, psi, omega, alpha, g = sympy.symbols(
        "m x y z Ixz Iyz Izz psi omega alpha g", real=True
    )
    a, b, Ixx, Iyy, Ixy = sympy.symbols("a b I_xx I_yy I_xy", positive=True)
    moments, products = (Ixx, Iyy, Izz), (Ixy, Iyz, Ixz)
    scene = unbalanced_rotor(m, (x, y, z), moments, products, a, b, psi, omega, alpha)
    found = scene.reactions(gravity=g * scene.ground.i)
    A, B, M = printed_9_9(m, (x, y, z), Ixz, Iyz, Izz, a, b, psi, omega, alpha, g)
    for mine, printed in zip((*found.A, *found.B, found.moment), (*A, *B, M), strict=True):
        assert sympy.simplify(sympy.expand(mine - printed)) == 0


def test_eqn_9_9_has_the_units_of_force():
    mass, length, time, pure = Dimension(1, 0, 0), Dimension(0, 1, 0), Dimension(0, 0, 1), Dimension()  # fmt: skip
    inertia, motion = (mass * length**2,) * 3, (pure, 1 / time, 1 / time**2)
    scene = unbalanced_rotor(mass, (length,) * 3, inertia, inertia, length, length, *motion)
    found = scene.reactions(gravity=length / time**2 * scene.ground.i)
    assert {found.A.x, found.A.y, found.B.x, found.B.y} == {mass * length / time**2}
    assert found.moment == mass * length**2 / time**2


def test_reactions_can_be_compiled():
    def force(psi, omega, alpha):
        scene = unbalanced_rotor(3.0, (0.02, -0.03, 0.05), (0.4, 0.5, 0.3), (0.01, -0.02, 0.03), 0.25, 0.35, psi, omega, alpha)  # fmt: skip
        return scene.reactions(gravity=9.81 * scene.ground.i).A

    psi = np.linspace(0, 6, 7)
    assert close(compiled(force)(psi, 3.0, 2.0)[:2], force(psi, 3.0, 2.0).components()[:2], 1e-13)


def test_the_reactions_do_not_depend_on_the_point_of_the_terms():
    scene, _ = general("float")
    gravity = 9.81 * scene.ground.i
    for about in (None, scene.A, scene.B, scene.shaft.point("Q", 0, 0, 7.0)):
        found = reactions(scene.body, scene.A, scene.B, scene.ground, gravity, about)
        assert close(found.A, scene.reactions(gravity).A, 1e-12)
        assert close(found.B, scene.reactions(gravity).B, 1e-12)


def test_eqn_9_10_as_motion_keeps_its_energy():
    model = turning_rotor(2.0, 0.1, 0.05, 0.3, 9.81, moment=0.4)
    states = by_scipy(model, (0.3, 1.0), 5, atol=1e-12).y.T
    assert np.ptp([model.invariant("energy", state) for state in states.tolist()]) < 1e-9


@every_kind
def test_eqn_9_10_as_motion_agrees_with_the_moment(kind):
    scene, (m, (x, y, _), _, _, Izz, _, _, psi, omega, _, g) = general(kind)
    moment = scene.reactions(gravity=g * scene.ground.i).moment
    model = turning_rotor(m, x, y, Izz, g, moment)
    assert close(model.derivative((psi, omega))[1], numbers(kind, "-2.5"), small(kind))

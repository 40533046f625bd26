"""Any orthogonal coordinates by the five-step method, and gradients: against systems known by other
means, and where coordinates are singular.
"""

import math

import mpmath as mp
import numpy as np
import pytest
import sympy

from newton_euler import (
    Dimension,
    Frame,
    at,
    compiled,
    cos,
    cosh,
    cylindrical,
    frenet,
    moving,
    sin,
    sinh,
    spherical,
    sqrt,
)
from newton_euler.algebra import SingularError
from newton_euler.kinematics import along, curvilinear, gradient
from tests.explicit import about_z, explicit, in_space, motion
from tests.kinds import KINDS, close, every_kind, numbers, within

ground = Frame("ground")


def parabolic(u, v, w):
    return (u * u - v * v) / 2, u * v, w


def elliptic(u, v, w):
    return cosh(u) * cos(v), sinh(u) * sin(v), w


def toroidal(s, theta, phi):
    """Round a ring of radius 3: s from its core, theta round z, phi up from the outside."""
    return (3 + s * cos(phi)) * cos(theta), (3 + s * cos(phi)) * sin(theta), s * sin(phi)


ALL = [in_space, about_z, parabolic, elliptic, toroidal]


# done exactly, the others take SymPy minutes
CASES = [(kind, f) for f in ALL for kind in KINDS if kind != "sympy" or f in (about_z, parabolic)]
every_case = pytest.mark.parametrize(("kind", "position"), CASES)
small = within(1e-13, 25)


def placed(position, kind):
    return ground, curvilinear(ground, "P", position, *map(moving, *motion(kind)))


@every_case
def test_section_3_4_the_steps_give_the_motion_written_out_and_differentiated(kind, position):
    ground, P = placed(position, kind)
    v, a, tiny = P.velocity(ground), P.acceleration(ground), 10 * small(kind)
    for order, vector in enumerate((P.position(ground), v, a)):
        known = explicit(position, order)(kind, *motion(kind))
        assert close(vector.components(ground), known, tiny)
    h_times_rate = [h * d for h, d in zip(P.scale_factors, motion(kind)[1], strict=True)]
    assert close(v.components(), h_times_rate, tiny)
    assert close(v.without(), v, tiny)
    assert close(a.without(), a, tiny)
    # by the basic kinematic equation, with the turning of the local axes
    assert close(v.rate(ground), a, tiny)
    axes = P.local.i, P.local.j, P.local.k
    assert close([[e.dot(f) for f in axes] for e in axes], ((1, 0, 0), (0, 1, 0), (0, 0, 1)), tiny)


def test_the_terms_are_named_after_the_rates_and_structural_zeros_are_left_out():
    q = moving(2.0, 0.5, 0.2), moving(0.0, 3.0, 0.1), moving(1.0, 0.0, 0.7)
    P = curvilinear(ground, "P", about_z, *q, names=("r", "theta", "z"))
    a, known = P.acceleration(ground), cylindrical(ground, "Q", *q).local
    assert close(P.local.angular_acceleration(ground), known.angular_acceleration(ground), 1e-15)
    assert list(a.terms) == ["r''", "theta''", "z''", "r' theta'", "theta'^2"]
    assert close(a.terms["r' theta'"], (0, 3.0, 0), 1e-15)
    assert close(a.without("theta'^2"), (0.2, 3.2, 0.7), 1e-15)
    assert "equation (3.15)" in str(a.explain())


def test_symbols_units_and_tracing():
    P = lambda u, v, w, du=1: curvilinear(ground, "P", parabolic, moving(u, du), v, w)
    u, v = sympy.symbols("u v", positive=True)
    assert sympy.simplify(P(u, v, 0).acceleration(ground).x - u / sympy.sqrt(u**2 + v**2)) == 0
    root, length = Dimension(0, 0.5, 0), Dimension(0, 1, 0)
    assert P(root, root, length, root).acceleration(ground).x == length
    size = lambda u, v, du: P(u, v, 0, du).acceleration(ground).norm()
    assert close(compiled(size)(3.0, 4.0, 2.0), size(3.0, 4.0, 2.0), 1e-14)


@pytest.mark.parametrize(("position", "q", "number"), [
    (about_z, (0.0, 0.5, 1.0), 2), (in_space, (2.0, 0.3, math.pi / 2), 2), (in_space, (0.0, 0.3, 0.2), 2), (elliptic, (0.0, 0.0, 1.0), 1),
    (elliptic, (0.0, math.pi, 1.0), 1), (in_space, (mp.mpf(2), mp.mpf(0), mp.pi / 2), 2), (about_z, (np.array([1.0, 0.0]), 0.5, 1.0), 2),
])  # fmt: skip
def test_at_an_axis_a_pole_or_a_focus_the_coordinates_are_refused_in_words(position, q, number):
    words = rf"coordinate {number} is singular here.*scale factor zero.*use other coordinates near"
    with pytest.raises(SingularError, match=words):
        curvilinear(Frame("ground"), "P", position, *q)


@pytest.mark.parametrize("off", [1e-3, 1e-8, 1e-12, 1e-100])
def test_near_the_axis_unit_vectors_are_right_to_the_last_digits(off):
    P = curvilinear(ground, "P", about_z, off, 0.5, 1.0)
    assert close(P.local.j.components(ground), (-math.sin(0.5), math.cos(0.5), 0), 3e-16)


@pytest.mark.parametrize(("off", "tolerance_"), [(1e-3, 1e-12), (1e-8, 1e-7), (1e-12, 1e-3)])
def test_near_the_pole_unit_vectors_are_right_and_rates_as_good_as_the_elevation(off, tolerance_):
    """The float nearest to pi/2 - off has a relative error of up to 1e-16/off from the pole."""
    P = curvilinear(ground, "P", in_space, 1.0, 0.5, math.pi / 2 - off)
    assert close(P.local.j.components(ground), (-math.sin(0.5), math.cos(0.5), 0), 4e-16)
    assert abs(P.scale_factors[1] / math.sin(off) - 1) < tolerance_


def test_coordinates_that_are_not_orthogonal_or_left_handed_are_refused_in_words():
    with pytest.raises(SingularError, match=r"not orthogonal here: e_1 . e_2 = 0\.6"):
        curvilinear(ground, "P", lambda u, v, w: (u + 0.6 * v, 0.8 * v, w), 1.0, 1.0, 1.0)
    with pytest.raises(SingularError, match=r"left-handed.*exchange two"):
        curvilinear(ground, "P", lambda R, phi, theta: in_space(R, theta, phi), 1.0, 0.2, 1.0)


def field(x, y, z):
    return x * y**2 + sin(z) * x - y / z


@every_kind
def test_eqn_A_22_gradient_is_the_three_partial_derivatives(kind):
    x, y, z = numbers(kind, "0.7", "-1.2", "0.4")
    expected = (y**2 + sin(z), 2 * x * y - 1 / z, cos(z) * x + y / z**2)
    assert close(gradient(field, ground.point("P", x, y, z)), expected, small(kind))


@every_kind
def test_eqn_A_22_gradient_is_the_same_vector_in_every_system(kind):
    q = numbers(kind, "1.3", "0.7", "0.4")
    for make, position in ((cylindrical, about_z), (spherical, in_space)):
        P = make(ground, "P", *q)
        here = gradient(lambda *p, position=position: field(*position(*p)), P)
        assert here.frame is P.local
        known = gradient(field, ground.point("Q", *position(*q)))
        assert close(here.components(ground), known, small(kind))


def test_gradient_is_the_force_of_a_potential_and_the_rate_along_a_path():
    """df/dt = grad f . v, along a path, exactly."""
    ground, t = Frame("ground"), 0.6
    path = lambda t: (cos(t), t * t, 2 + sin(3 * t))
    P = ground.point("P", *along(path, t))
    rate = at(lambda s: field(*path(s)), t).rate
    assert close(gradient(field, P).dot(P.velocity(ground)), rate, 1e-14)
    assert gradient(lambda x, y, z: 5.0, P).components() == (0, 0, 0)
    length = Dimension(0, 1, 0)
    assert gradient(lambda x, y, z: x * y, ground.point("P", length, length, length)).x == length


tight = within(1e-14, 27)


@every_kind
def test_eqn_3_14_to_3_17_magnitudes_are_the_same_in_every_orthonormal_system(kind):
    P = spherical(ground, "P", *map(moving, *motion(kind)))
    vectors = v, a = P.velocity(ground), P.acceleration(ground)
    frames = [ground, P.local, P.local.parent]
    if kind != "sympy":  # exact, it takes SymPy long
        frames.append(frenet(v.expressed_in(ground), a.expressed_in(ground)).frame)
    for frame in frames:
        for x in vectors:
            assert close(sqrt(sum(c * c for c in x.components(frame))), x.norm(), tight(kind))

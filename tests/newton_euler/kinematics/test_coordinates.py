"""Polar, cylindrical and spherical components: laws, the way back, and the neighbourhood of axis
and pole. Equations: test_ch02, test_ch03.
"""

import math

import mpmath as mp
import numpy as np
import pytest
import sympy
from hypothesis import given, settings
from hypothesis import strategies as st

from newton_euler import Dimension, Frame, compiled, cos, cylindrical, moving, polar, sin, spherical
from newton_euler.algebra import SingularError
from newton_euler.kinematics import (
    T_phi,
    T_theta,
    T_theta_phi,
    curvilinear,
    cylindrical_coordinates,
    cylindrical_frame,
    frenet,
    polar_coordinates,
    spherical_coordinates,
    spherical_frame,
)
from newton_euler.kinematics.rotations import apply, direction_cosines, product, transpose
from tests.explicit import about_z, explicit, in_space, motion
from tests.kinds import close, every_kind, numbers, within

ground = Frame("ground")
SYSTEMS = {
    "cylindrical": (cylindrical, cylindrical_coordinates, about_z),
    "spherical": (spherical, spherical_coordinates, in_space),
}

every_system = pytest.mark.parametrize("system", SYSTEMS)
EPS = 2.0**-52
moderate = st.floats(-3, 3).map(lambda x: x if abs(x) > 1e-300 else 0.0)  # smaller ones lose digits
small = within(2e-14, 26)


def made(make, q, rates, second):
    return ground, make(ground, "P", *(moving(*x) for x in zip(q, rates, second, strict=True)))


@every_kind
@every_system
def test_motion_is_that_written_out_and_of_its_terms_and_gives_its_coordinates_back(kind, system):
    make, back, position = SYSTEMS[system]
    q, tiny = motion(kind), small(kind)
    ground, P = made(make, *q)
    r, v, a = P.position(ground), P.velocity(ground), P.acceleration(ground)
    for order, vector in enumerate((r, v, a)):
        assert close(vector.components(ground), explicit(position, order)(kind, *q), tiny)
    assert close(v.without(), v, tiny)
    assert close(a.without(), a, tiny)
    assert close(v.rate(ground), a, tiny)
    found = back(r, v, a)
    for part, given_ in zip(("value", "rate", "acceleration"), q, strict=True):
        assert close(tuple(getattr(x, part) for x in found), given_, 10 * tiny)


@settings(max_examples=60)
@given(st.lists(moderate, min_size=9, max_size=9))
def test_magnitudes_are_the_same_in_rectangular_cylindrical_and_spherical_components(x):
    """(3.16), (3.17); and converting from rectangular to either system and back changes nothing."""
    P = ground.point("P", *(moving(*x[n::3]) for n in range(3)))
    r, v, a = P.position(ground), P.velocity(ground), P.acceleration(ground)
    if math.hypot(r.x, r.y) < 1e-2:
        return
    for make, back, _ in SYSTEMS.values():
        Q = make(ground, "Q", *back(r, v, a))
        scale = max(a.norm(), (1 + v.norm()) ** 2 / math.hypot(r.x, r.y))
        assert close(Q.position(ground), r, 50 * EPS * r.norm())
        assert close(Q.velocity(ground).norm(), v.norm(), 50 * EPS * v.norm())
        assert close(Q.acceleration(ground).norm(), a.norm(), 100 * EPS * scale)
        assert close(Q.acceleration(ground).expressed_in(ground), a, 100 * EPS * scale)


@every_kind
def test_eqn_3_26_and_3_27_cylindrical_and_spherical_terms_are_those_the_book_writes_out(kind):
    q, d, e = motion(kind)
    ground, P = made(cylindrical, q, d, e)
    r = q[0]
    expected = {
        "radial": (e[0], 0, 0), "centripetal": (-r * d[1] ** 2, 0, 0), "euler": (0, r * e[1], 0),
        "coriolis": (0, 2 * d[0] * d[1], 0), "axial": (0, 0, e[2]),
    }  # fmt: skip
    assert_terms(P.acceleration(ground), expected, kind)
    ground, P = made(spherical, q, d, e)
    module = {"float": np, "array": np, "mpmath": mp, "sympy": sympy}[kind]
    c, s = module.cos(q[2]), module.sin(q[2])
    expected = {
        "radial": (e[0], 0, 0), "centripetal_theta": (-r * (d[1] * c) ** 2, 0, r * d[1] ** 2 * s * c), "centripetal_phi": (-r * d[2] ** 2, 0, 0),
        "euler_theta": (0, r * e[1] * c, 0), "euler_phi": (0, 0, r * e[2]), "coriolis_theta": (0, 2 * d[0] * d[1] * c, 0),
        "coriolis_phi": (0, 0, 2 * d[0] * d[2]), "coriolis_theta_phi": (0, -2 * r * d[1] * d[2] * s, 0),
    }  # fmt: skip
    assert_terms(P.acceleration(ground), expected, kind)
    expected = {"radial": (d[0], 0, 0), "theta": (0, r * d[1] * c, 0), "phi": (0, 0, r * d[2])}
    assert_terms(P.velocity(ground), expected, kind)


def assert_terms(vector, expected, kind):
    assert list(vector.terms) == list(expected)
    for name, components in expected.items():
        assert close(vector.terms[name].components(), components, small(kind)), name


def test_units_follow_and_a_traced_formula_is_short():
    L, one, w = Dimension(0, 1, 0), Dimension(), Dimension(time=-1)
    _, P = made(spherical, (L, one, one), (L * w, w, w), (L * w**2, w**2, w**2))
    r, v, a = P.position(P.ground), P.velocity(P.ground), P.acceleration(P.ground)
    assert set(a) == {L * w**2}
    assert spherical_coordinates(r, v, a)[1].acceleration == w**2

    def acceleration(R, theta, phi, *rates):
        ground = Frame("ground")
        return spherical(ground, "P", *map(moving, (R, theta, phi), rates)).acceleration(ground)

    assert compiled(lambda R, a, b, dR, da, db: acceleration(R, a, b, dR, da, db)).operations <= 20


@pytest.mark.parametrize("back", [cylindrical_coordinates, spherical_coordinates])
def test_on_the_axis_the_way_back_is_refused_in_words(back):
    words = r"on (the|a) .*z axis.*theta and its rates do not exist.*rectangular components"
    for x in (0.0, 0.1 + 0.2 - 0.3, mp.mpf(0)):
        with pytest.raises(SingularError, match=words):
            back(ground.vector(x, 0 * x, 1 + 0 * x), v=ground.vector(1.0, 0, 0))
    with pytest.raises(SingularError):
        back(ground.vector(np.array([1.0, 0.0]), np.array([0.5, 0.0]), 1.0))
    with pytest.raises(SingularError, match="polar components are for the x, y plane"):
        polar_coordinates(ground.vector(1.0, 1.0, 0.5))
    with pytest.raises(SingularError):
        polar_coordinates(ground.vector(0.0, 0.0, 0))


@pytest.mark.parametrize("distance", [1e-1, 1e-4, 1e-8, 1e-14])
@every_system
def test_near_the_axis_rates_are_large_and_right_to_the_last_digits(system, distance):
    """A straight line that misses the axis: theta' = v/distance."""
    make, back, _ = SYSTEMS[system]
    x = distance, 0.3 * distance, 1.0
    for v, a in (((0.2, 1.0, 0.1), (0.0, 0.0, 0.0)), ((0.2, 1.0, 0.1), (1.0, -2.0, 0.5))):
        float_ = back(ground.vector(*x), ground.vector(*v), ground.vector(*a))
        exact = back(*(ground.vector(*map(mp.mpf, c)) for c in (x, v, a)))
        for f, m in zip(float_, exact, strict=True):
            assert abs(f.rate - m.rate) <= 20 * EPS * abs(m.rate)
            largest = (
                max(abs(y.acceleration) for y in exact) if m is exact[0] else abs(m.acceleration)
            )
            assert abs(f.acceleration - m.acceleration) <= 100 * EPS * largest
        again = make(ground, "P", *float_).acceleration(ground).components(ground)
        # terms of order v^2/distance cancel; in spherical coordinates cos phi has lost digits
        # too, because phi is a float near pi/2
        assert close(again, a, 50 * EPS * (1 + distance ** (-2 if system == "spherical" else -1)))


@every_kind
def test_eqn_2_15_to_2_18_polar_components(kind):
    (r, theta, _), (dr, w, _), (ddr, al, _) = motion(kind)
    P, tiny = polar(ground, "P", moving(r, dr, ddr), moving(theta, w, al)), small(kind)
    e_r, e_theta = P.local.i, P.local.j
    assert close(P.position(ground), (r * e_r).expressed_in(ground), tiny)  # 2.15
    assert close(e_r.rate(ground), w * e_theta, 0)  # 2.16
    assert close(e_theta.rate(ground), -w * e_r, 0)
    v, a = P.velocity(ground), P.acceleration(ground)
    assert close(v, (dr, r * w, 0), tiny)  # 2.17
    assert_terms(v, {"radial": (dr, 0, 0), "transverse": (0, r * w, 0)}, kind)
    assert close(a, (ddr - r * w**2, 2 * dr * w + r * al, 0), tiny)  # 2.18
    assert list(a.terms) == ["radial", "centripetal", "euler", "coriolis"]
    assert "coriolis  2 r' theta' e_theta" in str(a.explain())
    assert "equation (2.18)" in str(a.explain())


UNIT = ((1, 0, 0), (0, 1, 0), (0, 0, 1))


@every_kind
def test_eqn_3_18_to_3_23_cylindrical_coordinates_in_rectangular_and_in_their_own_components(kind):
    q, d, e = motion(kind)
    (r, theta, z), (dr, w, dz), (ddr, al, ddz) = q, d, e
    tiny, c, s = small(kind), cos(theta), sin(theta)
    P = cylindrical(ground, "P", *map(moving, q, d, e))
    v, a = P.velocity(ground), P.acceleration(ground)
    assert close(P.position(ground), (r * c, r * s, z), tiny)  # 3.18
    axes = (c, -s, 0), (s, c, 0), (0, 0, 1)
    for unit_vector, known in zip((ground.i, ground.j, ground.k), axes, strict=True):  # 3.19
        assert close(unit_vector.components(P.local), known, tiny)
    in_ground = dr * c - r * w * s, dr * s + r * w * c, dz
    assert close(v.components(ground), in_ground, tiny)  # 3.20
    x = ddr * c - 2 * dr * w * s - r * al * s - r * w**2 * c
    y = ddr * s + 2 * dr * w * c + r * al * c - r * w**2 * s
    assert close(a.components(ground), (x, y, ddz), tiny)  # 3.21
    assert close(v, (dr, r * w, dz), tiny)  # 3.22
    assert close(a, (ddr - r * w**2, r * al + 2 * dr * w, ddz), tiny)  # 3.23


@every_kind
def test_eqn_3_24_and_3_25_spherical_coordinates_with_the_elevation(kind):
    R, theta, phi = motion(kind)[0]
    P = spherical(ground, "P", R, theta, phi)
    c, s, cp, sp = cos(theta), sin(theta), cos(phi), sin(phi)
    assert close(P.position(ground), (R * cp * c, R * cp * s, R * sp), small(kind))
    axes = ((cp * c, -s, -sp * c), (cp * s, c, -sp * s), (sp, 0, cp))
    for unit_vector, known in zip((ground.i, ground.j, ground.k), axes, strict=True):
        assert close(unit_vector.components(P.local), known, small(kind))


@every_kind
def test_section_3_7_rates_of_the_spherical_unit_vectors(kind):
    (_, theta, phi), (_, w, p) = motion(kind)[0], motion(kind)[1]
    axes = spherical_frame(ground, moving(theta, w), moving(phi, p))
    c, s = cos(phi), sin(phi)
    rates = ((0, w * c, p), (-w * c, 0, w * s), (-p, -w * s, 0))
    for e, known in zip((axes.i, axes.j, axes.k), rates, strict=True):
        assert close(e.rate(ground), known, small(kind))
    assert close(axes.angular_velocity(ground), (w * s, -p, w * c), small(kind))


@every_kind
def test_eqn_3_28_to_3_33_components_of_one_vector_in_three_systems(kind):
    theta, phi, *Q = numbers(kind, "0.7", "0.4", "1.5", "-0.6", "0.9")
    local, sphere = cylindrical_frame(ground, theta), spherical_frame(ground, theta, phi)
    x, y, z = Q
    c, s, tiny = cos(theta), sin(theta), small(kind)
    turned = ground.vector(*Q).components(local)
    assert close(turned, (x * c + y * s, -x * s + y * c, z), tiny)  # 3.31
    assert close(apply(T_theta(theta), Q), turned, tiny)  # 3.32
    assert close(apply(transpose(T_theta(theta)), turned), Q, tiny)  # 3.33
    for frame in (local, sphere):  # 3.28, 3.29, 3.30
        a, b, d = ground.vector(*Q).components(frame)
        assert close((a * frame.i + b * frame.j + d * frame.k).components(ground), Q, tiny)


@every_kind
def test_eqn_3_34_to_3_38_the_matrices(kind):
    theta, phi, *Q = numbers(kind, "0.7", "0.4", "1.5", "-0.6", "0.9")
    c, s, cp, sp = cos(theta), sin(theta), cos(phi), sin(phi)
    first, second, both = T_theta(theta), T_phi(phi), T_theta_phi(theta, phi)
    local, sphere = cylindrical_frame(ground, theta), spherical_frame(ground, theta, phi)
    tiny = small(kind)
    for T in (first, second, both):
        assert close(product(T, transpose(T)), UNIT, tiny)  # 3.34: the inverse is the transpose
    assert close(first, direction_cosines(local, ground), tiny)  # 3.34
    assert close(both, direction_cosines(sphere, ground), tiny)  # 3.36
    assert close(both, ((c * cp, s * cp, sp), (-s, c, 0), (-c * sp, -s * sp, cp)), tiny)
    assert close(product(both, transpose(first)), second, tiny)  # 3.37
    assert close(second, ((cp, 0, sp), (0, 1, 0), (-sp, 0, cp)), 0)
    known = ground.vector(*Q).components(sphere)
    assert close(apply(both, Q), known, tiny)  # 3.35
    assert close(apply(second, apply(first, Q)), known, tiny)  # 3.38


LOCAL = {
    r"\hat{e}_r \hat{e}_\theta \hat{k}": polar(ground, "P", 1.0, 0.3).local,
    r"\hat{e}_R \hat{e}_\theta \hat{e}_\phi": spherical(ground, "P", 1.0, 0.3, 0.2).local,
    r"\hat{e}_t \hat{e}_n \hat{e}_b": frenet(
        ground.vector(1.0, 0, 0), ground.vector(0, 2.0, 0)
    ).frame,
    r"\hat{e}_1 \hat{e}_2 \hat{e}_3": curvilinear(ground, "P", lambda *q: q, 1.0, 2.0, 3.0).local,
}


@pytest.mark.parametrize("hats", LOCAL)
def test_local_unit_vectors_are_typeset_by_their_own_names(hats):
    latex = LOCAL[hats].vector(1, 2, 3).latex()
    assert all(hat in latex for hat in hats.split())
    assert r"\hat{\imath}" not in latex


def test_a_negative_term_is_subtracted_where_the_sum_is_typeset():
    P = cylindrical(ground, "P", 1.0, moving(0.0, rate=2.0), 0.0)
    formula = P.acceleration(ground).explain().latex.partition(r"\tag")[0]
    assert r"\ddot{r}\,\hat{e}_r - r\dot{\theta}^2" in formula
    assert "+ -" not in formula

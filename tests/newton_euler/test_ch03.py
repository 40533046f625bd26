"""Chapter 3: every numbered equation over every kind of number."""

import mpmath as mp
import pytest
import sympy

from newton_euler import Frame, at, cos, cylindrical, frenet, moving, sin, spherical, sqrt
from newton_euler.kinematics import T_phi, T_theta, T_theta_phi, along, curvilinear, cylindrical_frame, frenet_along, spherical_frame
from newton_euler.kinematics.paths import derivatives
from newton_euler.kinematics.rotations import apply, direction_cosines, product, transpose
from tests.explicit import explicit, polar_position, spherical_position
from tests.kinds import KINDS, close, numbers

every_kind = pytest.mark.parametrize("kind", KINDS)
ground = Frame("ground")
UNIT = ((1, 0, 0), (0, 1, 0), (0, 0, 1))


def tolerance(kind):
    return 2e-14 if kind in ("float", "array") else mp.mpf(10) ** -26


def motion(kind):
    return numbers(kind, "1.3", "0.7", "0.4"), numbers(kind, "0.5", "-0.9", "1.1"), numbers(kind, "0.3", "0.8", "-0.6")


def twisted(q):
    """A space curve, all of whose derivatives are easy to write out."""
    return q, q * q, q**3


def by_arc_length(kind, f, t, speed):
    """The derivative by arc length of a triple of functions of the time."""
    return tuple(at(lambda s, n=n: f(s)[n], t).rate / speed for n in range(3))


def axes_of(name):
    """Components of e_t, e_n or e_b along the twisted cubic, as a function of time: from the definitions, not from the engine."""

    def evaluated(t):
        v, a = (1, 2 * t, 3 * t * t), (0, 2, 6 * t)
        n = (v[1] * a[2] - v[2] * a[1], v[2] * a[0] - v[0] * a[2], v[0] * a[1] - v[1] * a[0])
        e_t = unit(v)
        e_b = unit(n)
        e_n = (e_b[1] * e_t[2] - e_b[2] * e_t[1], e_b[2] * e_t[0] - e_b[0] * e_t[2], e_b[0] * e_t[1] - e_b[1] * e_t[0])
        return {"t": e_t, "n": e_n, "b": e_b}[name]

    return evaluated


def unit(c):
    length = sqrt(c[0] * c[0] + c[1] * c[1] + c[2] * c[2])
    return tuple(x / length for x in c)


# -- rectangular and intrinsic components


@every_kind
def test_eqn_3_1_to_3_3_rectangular_components(kind):
    q, d, e = motion(kind)
    P = ground.point("P", *(moving(*x) for x in zip(q, d, e, strict=True)))
    for vector, known in ((P.position(ground), q), (P.velocity(ground), d), (P.acceleration(ground), e)):
        assert close(vector, known, 0)


@every_kind
def test_eqn_3_4_to_3_8_the_triad_by_its_definitions(kind):
    t = numbers(kind, "0.6")
    here = frenet_along(twisted, t, ground)
    assert close(here.e_t.components(ground), axes_of("t")(t), tolerance(kind))  # 3.4
    turning = ground.vector(*by_arc_length(kind, axes_of("t"), t, here.speed))
    assert close(turning.norm(), here.flexure, tolerance(kind))  # 3.6
    assert close((turning / here.flexure).components(), here.e_n.components(ground), tolerance(kind))  # 3.5
    assert close(here.e_t.cross(here.e_n), here.e_b, tolerance(kind))  # 3.7
    assert close(here.e_b.cross(here.e_t), here.e_n, tolerance(kind))  # 3.8
    assert close(here.e_n.cross(here.e_b), here.e_t, tolerance(kind))
    assert close(here.flexure**2, 4 * (1 + 9 * t**2 + 9 * t**4) / (1 + 4 * t**2 + 9 * t**4) ** 3, tolerance(kind))


@every_kind
def test_eqn_3_9_to_3_11_torsion_and_the_frenet_formulas(kind):
    """Both by differentiating the definitions along the path and by the turning of the engine's triad."""
    t = numbers(kind, "0.6")
    here = frenet_along(twisted, t, ground)
    f, tau = here.flexure, here.torsion
    rates = {"t": f * here.e_n, "b": tau * here.e_n, "n": -tau * here.e_b - f * here.e_t}
    for name, e in (("t", here.e_t), ("n", here.e_n), ("b", here.e_b)):
        assert close(by_arc_length(kind, axes_of(name), t, here.speed), rates[name].components(ground), 10 * tolerance(kind))
        assert close(e.rate(ground) / here.speed, rates[name], tolerance(kind))
    slope = ground.vector(*by_arc_length(kind, axes_of("b"), t, here.speed))
    assert close(here.e_n.dot(slope), tau, tolerance(kind))  # 3.10
    assert close(tau, -3 / (1 + 9 * t**2 + 9 * t**4), tolerance(kind))


@every_kind
def test_eqn_3_12_and_3_13_velocity_and_acceleration_in_the_osculating_plane(kind):
    t, rate, growth = numbers(kind, "0.6", "1.4", "-0.3")
    P = ground.point("P", *along(twisted, moving(t, rate, growth)))
    here = frenet_along(twisted, moving(t, rate, growth), ground)
    v, a = P.velocity(ground), P.acceleration(ground)
    assert close(here.velocity.components(ground), v, 10 * tolerance(kind))
    assert close(here.acceleration.components(ground), a, 10 * tolerance(kind))
    assert close(here.speed_rate, v.dot(a) / v.norm(), 10 * tolerance(kind))
    assert close(here.flexure, v.cross(a).norm() / v.norm() ** 3, 10 * tolerance(kind))
    assert close(here.acceleration.terms["normal"], (0, here.speed**2 * here.flexure, 0), 0)


@every_kind
def test_section_3_2_plane_curves_have_no_torsion(kind):
    t = numbers(kind, "0.6")
    tilted = frenet_along(lambda q: (q, q * q, 2 * q - 3 * q * q), t, ground)
    assert close(tilted.torsion, 0, tolerance(kind))


# -- the general approach


@every_kind
def test_eqn_3_14_to_3_17_magnitudes_are_the_same_in_every_orthonormal_system(kind):
    P = spherical(ground, "P", *(moving(*x) for x in zip(*motion(kind), strict=True)))
    v, a = P.velocity(ground), P.acceleration(ground)
    triads = [frenet(v.expressed_in(ground), a.expressed_in(ground)).frame] if kind != "sympy" else []  # exact, it takes SymPy long
    for frame in (ground, P.local, P.local.parent, *triads):
        assert close(sqrt(sum(x * x for x in v.components(frame))), v.norm(), tolerance(kind))
        assert close(sqrt(sum(x * x for x in a.components(frame))), a.norm(), tolerance(kind))


# -- cylindrical and spherical components


@every_kind
def test_eqn_3_18_to_3_21_cylindrical_coordinates_in_rectangular_components(kind):
    q, d, e = motion(kind)
    (r, theta, z), (dr, w, dz), (ddr, al, ddz) = q, d, e
    P = cylindrical(ground, "P", *(moving(*x) for x in zip(q, d, e, strict=True)))
    c, s = cos(theta), sin(theta)
    assert close(P.position(ground), (r * c, r * s, z), tolerance(kind))  # 3.18
    for unit_vector, known in ((ground.i, (c, -s, 0)), (ground.j, (s, c, 0)), (ground.k, (0, 0, 1))):  # 3.19
        assert close(unit_vector.components(P.local), known, tolerance(kind))
    assert close(P.velocity(ground).components(ground), (dr * c - r * w * s, dr * s + r * w * c, dz), tolerance(kind))  # 3.20
    x = ddr * c - 2 * dr * w * s - r * al * s - r * w**2 * c
    y = ddr * s + 2 * dr * w * c + r * al * c - r * w**2 * s
    assert close(P.acceleration(ground).components(ground), (x, y, ddz), tolerance(kind))  # 3.21


@every_kind
def test_eqn_3_22_and_3_23_cylindrical_components(kind):
    q, d, e = motion(kind)
    (r, _, _), (dr, w, dz), (ddr, al, ddz) = q, d, e
    P = cylindrical(ground, "P", *(moving(*x) for x in zip(q, d, e, strict=True)))
    assert close(P.velocity(ground), (dr, r * w, dz), tolerance(kind))
    assert close(P.acceleration(ground), (ddr - r * w**2, r * al + 2 * dr * w, ddz), tolerance(kind))
    assert close(P.acceleration(ground).components(ground), explicit(polar_position, 2)(kind, q, d, e), tolerance(kind))


@every_kind
def test_eqn_3_24_and_3_25_spherical_coordinates_with_the_elevation(kind):
    R, theta, phi = motion(kind)[0]
    P = spherical(ground, "P", R, theta, phi)
    c, s, cp, sp = cos(theta), sin(theta), cos(phi), sin(phi)
    assert close(P.position(ground), (R * cp * c, R * cp * s, R * sp), tolerance(kind))
    axes = ((cp * c, -s, -sp * c), (cp * s, c, -sp * s), (sp, 0, cp))
    for unit_vector, known in zip((ground.i, ground.j, ground.k), axes, strict=True):
        assert close(unit_vector.components(P.local), known, tolerance(kind))


@every_kind
def test_eqn_3_26_and_3_27_spherical_components(kind):
    q, d, e = motion(kind)
    (R, _, phi), (dR, w, p), (ddR, al, be) = q, d, e
    P = spherical(ground, "P", *(moving(*x) for x in zip(q, d, e, strict=True)))
    c, s = cos(phi), sin(phi)
    assert close(P.velocity(ground), (dR, R * w * c, R * p), tolerance(kind))
    a_R = ddR - R * p**2 - R * w**2 * c**2
    a_phi = (2 * R * dR * p + R**2 * be) / R + R * w**2 * s * c
    a_theta = c / R * (2 * R * dR * w + R**2 * al) - 2 * R * w * p * s
    assert close(P.acceleration(ground), (a_R, a_theta, a_phi), tolerance(kind))
    assert close(P.acceleration(ground).components(ground), explicit(spherical_position, 2)(kind, q, d, e), tolerance(kind))


@every_kind
def test_section_3_7_rates_of_the_spherical_unit_vectors(kind):
    (_, theta, phi), (_, w, p) = motion(kind)[0], motion(kind)[1]
    axes = spherical_frame(ground, moving(theta, w), moving(phi, p))
    c, s = cos(phi), sin(phi)
    rates = ((0, w * c, p), (-w * c, 0, w * s), (-p, -w * s, 0))
    for e, known in zip((axes.i, axes.j, axes.k), rates, strict=True):
        assert close(e.rate(ground), known, tolerance(kind))
    assert close(axes.angular_velocity(ground), (w * s, -p, w * c), tolerance(kind))


# -- transformation of components


@every_kind
def test_eqn_3_28_to_3_33_components_of_one_vector_in_three_systems(kind):
    theta, phi, *Q = numbers(kind, "0.7", "0.4", "1.5", "-0.6", "0.9")
    vector, local, sphere = ground.vector(*Q), cylindrical_frame(ground, theta), spherical_frame(ground, theta, phi)
    x, y, z = Q
    c, s = cos(theta), sin(theta)
    assert close(vector.components(local), (x * c + y * s, -x * s + y * c, z), tolerance(kind))  # 3.31
    assert close(apply(T_theta(theta), Q), vector.components(local), tolerance(kind))  # 3.32
    assert close(apply(transpose(T_theta(theta)), vector.components(local)), Q, tolerance(kind))  # 3.33
    for frame in (local, sphere):  # 3.28, 3.29, 3.30
        a, b, d = vector.components(frame)
        assert close((a * frame.i + b * frame.j + d * frame.k).components(ground), Q, tolerance(kind))


@every_kind
def test_eqn_3_34_to_3_38_the_matrices(kind):
    theta, phi, *Q = numbers(kind, "0.7", "0.4", "1.5", "-0.6", "0.9")
    c, s, cp, sp = cos(theta), sin(theta), cos(phi), sin(phi)
    both = T_theta_phi(theta, phi)
    for T in (T_theta(theta), T_phi(phi), both):
        assert close(product(T, transpose(T)), UNIT, tolerance(kind))  # 3.34: the inverse is the transpose
    assert close(T_theta(theta), direction_cosines(cylindrical_frame(ground, theta), ground), tolerance(kind))  # 3.34
    assert close(both, direction_cosines(spherical_frame(ground, theta, phi), ground), tolerance(kind))  # 3.36
    assert close(both, ((c * cp, s * cp, sp), (-s, c, 0), (-c * sp, -s * sp, cp)), tolerance(kind))
    assert close(product(both, transpose(T_theta(theta))), T_phi(phi), tolerance(kind))  # 3.37
    assert close(T_phi(phi), ((cp, 0, sp), (0, 1, 0), (-sp, 0, cp)), 0)
    spherical_components = apply(both, Q)  # 3.35
    assert close(spherical_components, ground.vector(*Q).components(spherical_frame(ground, theta, phi)), tolerance(kind))
    assert close(apply(T_phi(phi), apply(T_theta(theta), Q)), spherical_components, tolerance(kind))  # 3.38


def test_section_3_4_the_five_steps_symbolically():
    """Cylindrical components out of the position function, with the formulas of the book as result."""
    t = sympy.Symbol("t")
    r, theta, z = (sympy.Function(n)(t) for n in ("r", "theta", "z"))
    P = curvilinear(ground, "P", lambda r, theta, z: (r * cos(theta), r * sin(theta), z), r, theta, z)
    known = cylindrical(ground, "Q", r, theta, z)
    for x, y in zip(P.velocity(ground), known.velocity(ground), strict=True):
        at_a_point = {r.diff(t): 0.3, theta.diff(t): -0.8, z.diff(t): 0.6, r: 1.7, theta: 0.4, z: 2.0}
        assert abs(sympy.sympify(x - y).subs(at_a_point).evalf()) < 1e-14


def test_derivatives_of_the_twisted_cubic():
    assert derivatives(twisted, 2.0) == ((2.0, 4.0, 8.0), (1, 4.0, 12.0), (0, 2, 12.0), (0, 0, 6))

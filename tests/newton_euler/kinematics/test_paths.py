"""Intrinsic components: the Frenet triad of space curves, the sign of torsion, and straight lines,
inflections and rest. Equations: test_ch02, test_ch03.
"""

import math
import random

import mpmath as mp
import numpy as np
import pytest
import sympy
from hypothesis import given, settings
from hypothesis import strategies as st

from newton_euler import Dimension, Frame, at, compiled, cos, frenet, moving, polar, sin, sqrt
from newton_euler.algebra import FrameError, SingularError
from newton_euler.kinematics import (
    along,
    at_speed,
    flexure,
    frenet_along,
    polar_coordinates,
    speed_rate,
)
from newton_euler.kinematics.paths import derivatives
from tests.explicit import curve
from tests.kinds import close, every_kind, numbers, rates, within

EPS = 2.0**-52
ground = Frame("ground")
small = within(1e-13, 25)


def knot(q):
    return (2 + cos(3 * q)) * cos(2 * q), (2 + cos(3 * q)) * sin(2 * q), sin(3 * q)


def twisted(q):
    return q, q * q, q**3 / 3


@every_kind
def test_derivatives_of_a_path_up_to_the_third_are_those_of_SymPy(kind):
    q = numbers(kind, "0.7")
    s = sympy.Symbol("s")
    names = {"float": "numpy", "array": "numpy", "mpmath": "mpmath", "sympy": "sympy"}
    for order, found in enumerate(derivatives(knot, q)):
        known = sympy.lambdify(s, [sympy.diff(x, s, order) for x in knot(s)], names[kind])(q)
        assert close(found, known, 100 * small(kind))


@settings(max_examples=40)
@given(st.floats(-3, 3), st.floats(0.2, 4))
def test_the_triad_is_orthonormal_and_right_handed_and_no_parameter_changes_it(q, rate):
    here = frenet_along(knot, q, ground)
    axes = here.e_t, here.e_n, here.e_b
    assert close([[e.dot(f) for f in axes] for e in axes], ((1, 0, 0), (0, 1, 0), (0, 0, 1)), 1e-14)
    assert close(here.e_t.cross(here.e_n), here.e_b, 1e-14)
    faster = frenet_along(knot, moving(q, rate, -0.7), ground)
    assert close(faster.frame.rotation(ground), here.frame.rotation(ground), 1e-12)
    small = 1e-12 * (1 + abs(here.torsion))
    assert close((faster.flexure, faster.torsion), (here.flexure, here.torsion), small)
    assert close(faster.speed, rate * here.speed, 1e-13 * rate)


def test_from_motion_and_from_path_the_same_triad_follows():
    q = moving(0.7, 1.3, 0.4)
    P = ground.point("P", *along(knot, q))
    a = P.acceleration(ground)
    by_motion, by_path = frenet(P.velocity(ground), a), frenet_along(knot, q, ground)
    assert close(by_motion.frame.rotation(ground), by_path.frame.rotation(ground), 1e-15)
    assert close(by_motion.acceleration.components(ground), a, 1e-13)
    with pytest.raises(SingularError, match=r"torsion needs the rate of the acceleration.*jerk="):
        _ = by_motion.torsion
    with pytest.raises(FrameError, match=r"angular velocity of e_t, e_n, e_b of path is not known"):
        by_motion.e_n.rate(ground)


def test_a_fraction_in_a_path_is_as_exact_as_the_parameter():
    """1/3 among the jets of a 30-digit number must not become the float 0.333…"""
    q, small = mp.mpf("0.7"), mp.mpf(10) ** -28
    known = (q, q * q, q**3 / 3), (1, 2 * q, q * q), (0, 2, 2 * q), (0, 0, 2)
    assert close(derivatives(twisted, q), known, small)
    _, first, second, _ = derivatives(lambda q: (q / 3, q * q / 3, q), q)
    assert close(first, (mp.mpf(1) / 3, 2 * q / 3, 1), small)
    assert close(second, (0, mp.mpf(2) / 3, 0), small)


def test_units_tracing_and_symbols():
    L, T, v = Dimension(0, 1, 0), Dimension(0, 0, 1), ground.vector
    here = frenet(v(L / T, L / T, 0), v(L / T**2, 0, L / T**2), v(0, 0, L / T**3))
    assert (here.flexure, here.torsion, here.radius, here.speed_rate) == (1 / L, 1 / L, L, L / T**2)
    bends = lambda q: (lambda F: (F.flexure, F.torsion))(frenet_along(knot, q, Frame("g")))
    assert close(compiled(bends)(0.7), bends(0.7), 1e-14)
    q = sympy.Symbol("q", positive=True)
    here = frenet_along(lambda q: (q, q**2, 0), q, ground)
    assert sympy.simplify(here.flexure - 2 / (1 + 4 * q**2) ** sympy.Rational(3, 2)) == 0


def test_explanations_carry_the_numbers_of_the_book():
    here = frenet(ground.vector(0, 5.0, 0), ground.vector(-2.0, 1.5, 0))
    text = str(here.acceleration.explain("m/s^2"))
    assert "equation (3.13)" in text
    assert "normal  nu^2 f e_n" in text
    assert close(here.acceleration.without("normal"), (1.5, 0, 0), 0)


LINES = {
    "graph": lambda q: (q, 2 * q + 1, 0),
    "with rounding in the speed": lambda q: (q * (cos(q) ** 2 + sin(q) ** 2), 0.0, 0),
    "with cancelling curvature": lambda q: (2 * q + (sin(2 * q) - 2 * sin(q) * cos(q)) / 10, 3 * q, 0.7),
    "to and fro": lambda q: (cos(q) ** 2, sin(q) ** 2, 0),
    "uneven": lambda q: (0.7 * q**3, 1.3 * q**3, 0.11 * q**3),
}  # fmt: skip
STRAIGHT = r"straight here.*e_n, e_b and the torsion do not exist.*radius of curvature is infinite"


@pytest.mark.parametrize("line", LINES)
def test_on_a_straight_line_rounding_is_not_taken_for_a_normal(line):
    generator = random.Random(1)
    for _ in range(100):
        with pytest.raises(SingularError, match=STRAIGHT):
            frenet_along(LINES[line], generator.uniform(0.1, 5), ground)


def test_a_straight_line_in_polar_components_is_seen_from_its_ledger():
    """r'' and r theta'^2 cancel: the remaining 1e-16 of them is not an acceleration."""
    dice = random.Random(2)
    for _ in range(200):
        angle, off, ahead = dice.uniform(0, 7), dice.uniform(0.1, 3), dice.uniform(-5, 5)
        c, s = math.cos(angle), math.sin(angle)
        r, v = ground.vector(c * ahead - s * off, s * ahead + c * off, 0), (1.7 * c, 1.7 * s, 0)
        at_rest = ground.vector(0.0, 0.0, 0)
        P = polar(ground, "P", *polar_coordinates(r, ground.vector(*v), at_rest))
        with pytest.raises(SingularError, match="straight here"):
            frenet(P.velocity(ground), P.acceleration(ground))


@pytest.mark.parametrize("x", [1e-150, 1e-12, 1e-8, 1e-3])
def test_near_an_inflection_curvature_is_exact_and_at_it_refused(x):
    cubic = lambda q: (q, q**3, 0)
    for side in (1, -1):
        here = frenet_along(cubic, side * x, ground)
        assert abs(here.flexure / (6 * x / (1 + 9 * x**4) ** 1.5) - 1) < 4 * EPS
        assert here.e_n.components(ground)[1] * side > 0.99  # e_n jumps to the other side
    for q in (0.0, mp.mpf(0), sympy.Integer(0), np.array([1.0, 0.0])):
        with pytest.raises(SingularError, match="straight here"):
            frenet_along(cubic, q, ground)


@pytest.mark.parametrize(
    ("off", "known"), [(0.0, False), (2e-16, False), (1e-12, True), (1e-8, True)]
)
def test_an_inflection_away_from_zero_is_as_sharp_as_the_parameter_is(off, known):
    q = 1 + off
    shifted = lambda q: (q, (q - 1) ** 3, 0)
    if known:
        assert abs(frenet_along(shifted, q, ground).flexure / (6 * (q - 1)) - 1) < 4 * EPS
    else:
        with pytest.raises(SingularError):
            frenet_along(shifted, q, ground)


def test_flexure_and_speed_rate_exist_on_a_line_and_not_at_rest():
    v, a = ground.vector(3.0, 4.0, 0), ground.vector(0.6, 0.8, 0)
    assert close((speed_rate(v, a), flexure(v, a)), (1.0, 0.0), 1e-15)
    for refused in (speed_rate, flexure, frenet):
        with pytest.raises(SingularError, match=r"at rest.*no direction.*frenet_along"):
            refused(ground.vector(0.0, 0.0, 0.0), a)
    with pytest.raises(SingularError, match="at rest"):
        frenet_along(lambda q: (q**2, q**3, 0), 0.0, ground)  # a cusp
    with pytest.raises(SingularError, match=r"is zero at q = 0\.0: the path stands still"):
        at_speed(lambda q: (q**2, q**3, 0), 0.0, 1.0)


def test_the_contact_point_of_a_rolling_wheel_is_at_rest_not_moving_at_1e_minus_16():
    C = ground.point("C", moving(0.0, -0.7 * 0.31), 0, 0.31)
    wheel = ground.rotate("wheel", "-y", 0.3, 0.7, origin=C)
    contact = wheel.point("contact", 0.31 * math.sin(-0.3), 0, -0.31 * math.cos(0.3))
    v, a = contact.velocity(ground), contact.acceleration(ground)
    assert v.norm() < 1e-15
    with pytest.raises(SingularError, match="at rest"):
        frenet(v, a)


def test_a_path_must_return_three_coordinates():
    with pytest.raises(FrameError, match=r"a place on a path .*three numbers are expected"):
        frenet_along(lambda q: (q, q), 1.0, ground)


tight = within(2e-14, 26)


@every_kind
def test_eqn_2_4_2_5_2_14_velocity_along_the_tangent_and_its_rate(kind):
    r, v, a, t = curve(kind)
    P, small = ground.point("P", *along(r, t)), tight(kind)
    here = frenet(P.velocity(ground), P.acceleration(ground))
    assert close(here.velocity, (here.speed, 0, 0), 0)
    assert close((here.speed * here.e_t).components(ground), v(t), small)
    assert close(here.acceleration.components(ground), a(t), small)
    here = frenet_along(r, t, ground)  # then e_t' is known, and (2.5) is the product rule
    assert close(here.velocity.rate(ground), here.acceleration, small)
    by_rule = here.speed_rate * here.e_t + here.speed * here.e_t.rate(ground)
    assert close(here.acceleration, by_rule, small)


@every_kind
@pytest.mark.parametrize("sense", [1, -1])
def test_eqn_2_6_to_2_11_the_triad_turns_with_the_direction_of_travel(kind, sense):
    """theta(t) of e_t, for either sense of turning: e_t' = |theta'| e_n."""
    c, t = numbers(kind, "0.8", "0.6")
    theta, speed, small = lambda t: sense * c * t * t, lambda t: 2 + sin(t), tight(kind)
    v = ground.vector(*along(lambda s: (speed(s) * cos(theta(s)), speed(s) * sin(theta(s)), 0), t))
    here = frenet(v, v.rate(ground), v.rate(ground).rate(ground))
    angle, rate = theta(t), 2 * c * t
    assert close(here.e_t.components(ground), (cos(angle), sin(angle), 0), small)
    normal = -sense * sin(angle), sense * cos(angle), 0
    assert close(here.e_n.components(ground), normal, small)  # 2.6, 2.8
    assert close(here.e_t.rate(ground).components(), (0, rate, 0), small)  # 2.7, 2.9, 2.10
    assert close(here.acceleration, (at(speed, t).rate, speed(t) * rate, 0), small)  # 2.11
    assert close(here.radius, speed(t) / rate, 10 * small)  # 2.12


@every_kind
def test_eqn_2_12_radius_of_curvature_is_that_of_the_circle(kind):
    R, w, t = numbers(kind, "2.5", "-0.8", "0.3")
    circle = lambda t: (R * cos(w * t), R * sin(w * t), 0)
    here = frenet_along(circle, t, ground)
    to_center = here.to_center.components(ground)
    assert close(to_center, [-x for x in circle(t)], tight(kind))
    assert close(here.radius, R, tight(kind))
    assert close(here.acceleration.terms["normal"].norm(), here.speed**2 / R, tight(kind))


@every_kind
def test_eqn_2_13_radius_of_curvature_of_a_graph(kind):
    x = numbers(kind, "0.7")
    here = frenet_along(lambda x: (x, x**3 - 2 * x, 0), x, ground)
    assert close(here.radius**2, (1 + (3 * x**2 - 2) ** 2) ** 3 / (6 * x) ** 2, 10 * tight(kind))


def twisted_cubic(q):
    """A space curve whose derivatives are all easy to write out."""
    return q, q * q, q**3


def by_arc_length(f, t, speed):
    """The derivative with respect to arc length of a triple of functions of time."""
    return tuple(rate / speed for rate in rates(f, t))


def axes_of(name):
    """Components of e_t, e_n or e_b along the cubic as functions of time, by the definitions."""
    cross = lambda a, b: tuple(a[n - 2] * b[n - 1] - a[n - 1] * b[n - 2] for n in range(3))

    def evaluated(t):
        v, a = (1, 2 * t, 3 * t * t), (0, 2, 6 * t)
        e_t, e_b = unit(v), unit(cross(v, a))
        return {"t": e_t, "n": cross(e_b, e_t), "b": e_b}[name]

    return evaluated


def unit(c):
    length = sqrt(c[0] * c[0] + c[1] * c[1] + c[2] * c[2])
    return tuple(x / length for x in c)


@every_kind
def test_eqn_3_4_to_3_8_the_triad_by_its_definitions(kind):
    t, tiny = numbers(kind, "0.6"), tight(kind)
    here = frenet_along(twisted_cubic, t, ground)
    assert close(here.e_t.components(ground), axes_of("t")(t), tiny)  # 3.4
    turning = ground.vector(*by_arc_length(axes_of("t"), t, here.speed))
    assert close(turning.norm(), here.flexure, tiny)  # 3.6
    assert close((turning / here.flexure).components(), here.e_n.components(ground), tiny)  # 3.5
    for e, f, g in ("tnb", "btn", "nbt"):  # 3.7, 3.8
        e, f, g = (getattr(here, f"e_{x}") for x in (e, f, g))
        assert close(e.cross(f), g, tiny)
    squared = 4 * (1 + 9 * t**2 + 9 * t**4) / (1 + 4 * t**2 + 9 * t**4) ** 3
    assert close(here.flexure**2, squared, tiny)


@every_kind
def test_eqn_3_9_to_3_11_torsion_and_the_frenet_formulas(kind):
    """Checked by the definitions along the path, and by the turning of the engine's triad."""
    t = numbers(kind, "0.6")
    here = frenet_along(twisted_cubic, t, ground)
    f, tau = here.flexure, here.torsion
    rates = {"t": f * here.e_n, "b": tau * here.e_n, "n": -tau * here.e_b - f * here.e_t}
    for name, e in (("t", here.e_t), ("n", here.e_n), ("b", here.e_b)):
        slope = by_arc_length(axes_of(name), t, here.speed)
        assert close(slope, rates[name].components(ground), 10 * tight(kind))
        assert close(e.rate(ground) / here.speed, rates[name], tight(kind))
    slope = ground.vector(*by_arc_length(axes_of("b"), t, here.speed))
    assert close(here.e_n.dot(slope), tau, tight(kind))  # 3.10
    assert close(tau, -3 / (1 + 9 * t**2 + 9 * t**4), tight(kind))


@every_kind
def test_eqn_3_12_and_3_13_velocity_and_acceleration_in_the_osculating_plane(kind):
    t, rate, growth = numbers(kind, "0.6", "1.4", "-0.3")
    P = ground.point("P", *along(twisted_cubic, moving(t, rate, growth)))
    here = frenet_along(twisted_cubic, moving(t, rate, growth), ground)
    v, a = P.velocity(ground), P.acceleration(ground)
    assert close(here.velocity.components(ground), v, 10 * tight(kind))
    assert close(here.acceleration.components(ground), a, 10 * tight(kind))
    assert close(here.speed_rate, v.dot(a) / v.norm(), 10 * tight(kind))
    assert close(here.flexure, v.cross(a).norm() / v.norm() ** 3, 10 * tight(kind))
    assert close(
        here.acceleration.terms["normal"], (0, here.speed**2 * here.flexure, 0), tight(kind)
    )


@given(*[st.tuples(*[st.integers(-9, 9)] * 3)] * 2, *[st.floats(-280, 280)] * 2)
@settings(max_examples=60, deadline=None)
def test_tangential_acceleration_and_flexure_keep_their_digits_at_all_sizes(v, a, m, n):
    exact = [[mp.mpf(x) * mp.mpf(10) ** k for x in c] for c, k in ((v, m), (a, n))]
    slow = [ground.vector(*c) for c in exact]
    fast = [ground.vector(*map(float, c)) for c in exact]
    size = mp.sqrt(sum(x * x for x in exact[0]))
    if not size:
        return
    assert fast[0].angle_to(fast[0]) < 1e-7
    rate = float(sum(x * y for x, y in zip(*exact, strict=True)) / size)
    assert float(speed_rate(*fast)) == pytest.approx(rate, abs=1e-14 * float(slow[1].norm()))
    bent = float(slow[0].cross(slow[1]).norm() / size**3)
    if bent == 0 or 1e-300 < bent < 1e300:
        noise = 1e-15 * float(slow[1].norm() / size**2)
        assert float(flexure(*fast)) == pytest.approx(bent, rel=1e-9, abs=noise)
    if any(np.cross(v, a)) and 1e-150 < bent < 1e150:
        found = frenet(*fast)
        assert float(found.flexure) == pytest.approx(bent, rel=1e-9)
        assert found.speed_rate == pytest.approx(rate, abs=1e-14 * float(slow[1].norm()))

"""Chapter 11, (11.1)-(11.11), 11.4, 11.13: work by each of its integrals, power, couples; where an
integral fails.

Oracles: antiderivatives by hand, sums over short chords, and for power the rate of kinetic
    energy of an explicit motion.
"""

import math
import sys

import mpmath as mp
import numpy as np
import pytest
import sympy
from hypothesis import given, settings
from hypothesis import strategies as st

from newton_euler import Dimension, Frame, at, compiled, cos, moving, sin, sqrt
from newton_euler.algebra import DimensionError, FrameError, WorkError
from newton_euler.algebra.ledger import Amount, TermError, summed
from newton_euler.dynamics.work import (
    constant_force_work,
    pair_power,
    power,
    work_along,
    work_in_time,
    work_integral,
)
from newton_euler.kinematics import along
from tests.kinds import LENGTH, MASS, TIME, close, every_kind, number, numbers, rates, within

FORCE, POWER = MASS * LENGTH / TIME**2, MASS * LENGTH**2 / TIME**3
small = within(1e-12, 26)


def swirl(x, y, z):
    """A force field with curl, so that its work depends on the path."""
    return -y, x, z


def helix(a, c):
    """A helix of radius a rising c per radian; swirl does the work a^2 + c^2 q per unit of q."""
    return lambda q: (a * cos(q), a * sin(q), c * q)


def on_helix(a, c, q):
    return a * a * q + c * c * q * q / 2


@every_kind
def test_eqn_11_1_work_along_a_helix(kind):
    a, c, q = numbers(kind, 2, "0.5", "1.5")
    U = work_along(swirl, helix(a, c), 0, q, exact=kind == "sympy")
    assert close(U.value, on_helix(a, c, q), small(kind))


@every_kind
def test_eqn_11_2_work_in_time_is_that_along_the_path_however_fast_it_is_run_through(kind):
    a, c, t = numbers(kind, 2, "0.5", "1.25")
    ground, path = Frame("ground"), helix(a, c)
    force = lambda t: ground.vector(*swirl(*path(t * t)))
    velocity = lambda t: ground.point("P", *along(lambda s: path(s * s), t)).velocity(ground)
    U = work_in_time(force, velocity, 0, t, exact=kind == "sympy")
    assert close(U.value, on_helix(a, c, t * t), small(kind))


@every_kind
def test_eqn_11_3_work_is_the_integral_of_the_tangential_component_over_the_arc(kind):
    a, c, q = numbers(kind, "1.5", 2, "0.75")  # a wire of length 5/2 per radian
    path, stretch = helix(a, c), sqrt(a * a + c * c)

    def F_t(s):
        tangent = [rate / stretch for rate in rates(path, s / stretch)]
        return power(swirl(*path(s / stretch)), tangent)

    U = work_integral(F_t, 0, stretch * q, exact=kind == "sympy")
    assert close(U.value, on_helix(a, c, q), small(kind))


@every_kind
def test_eqn_11_4_force_times_displacement_along_it(kind):
    """A force c z + d z^2 along k, whose point of application moves up a slanting curve."""
    c, d, h = numbers(kind, 3, "-0.5", 2)
    exact = kind == "sympy"
    F, slanting = lambda z: c * z + d * z * z, lambda q: (q, 3 * q, h * q * q)
    expected = c * h * h / 2 + d * h**3 / 3
    along_path = work_along(lambda x, y, z: (0, 0, F(z)), slanting, 0, 1 + 0 * h, exact=exact)
    for U in (work_integral(F, 0, h, exact=exact), along_path):
        assert close(U.value, expected, small(kind))


@every_kind
def test_eqn_11_5_the_rectangular_terms_each_along_the_path(kind):
    a, c, q = numbers(kind, 2, "0.5", "1.5")
    U = work_along(swirl, helix(a, c), 0, q, exact=kind == "sympy")
    x, y = a * a * (q / 2 - sin(2 * q) / 4), a * a * (q / 2 + sin(2 * q) / 4)
    for name, expected in (("x", x), ("y", y), ("z", c * c * q * q / 2)):
        assert close(U.terms[name], expected, small(kind))
    assert U.number == "11.5"


@every_kind
def test_eqn_11_6_the_work_of_a_constant_force_needs_no_path(kind):
    F, x0, z0, x1, y1, z1 = numbers(kind, 7, 1, "0.5", 3, -2, "2.25")
    ground = Frame("ground")
    force, start, end = -F * ground.k, ground.point("A", x0, 0, z0), ground.point("B", x1, y1, z1)
    assert close(constant_force_work(force, start, end).value, -F * (z1 - z0), small(kind))
    bent = lambda q: (x0 + (x1 - x0) * q**3, y1 * q * q, z0 + (z1 - z0) * q + sin(q) * (1 - q))
    U = work_along(lambda x, y, z: (0, 0, -F), bent, 0, 1 + 0 * F, exact=kind == "sympy")
    assert close(U.value, -F * (z1 - z0), small(kind))


@every_kind
def test_eqn_11_7_the_work_of_a_weight(kind):
    m, g, z0, z1 = numbers(kind, 2, "9.81", "1.5", "0.25")
    ground = Frame("ground")
    turned = ground.rotate("turned", "x", m)  # points of another frame serve as well
    start, end = ground.point("A", 1, 1, z0), turned.point("B", 0, sin(m) * z1, cos(m) * z1)
    U = constant_force_work(-m * g * ground.k, start, end)
    assert close(U.value, m * g * (z0 - z1), 10 * small(kind))


@settings(max_examples=20)
@given(st.lists(st.floats(-3, 3), min_size=6, max_size=6))
def test_example_11_4_any_path_between_two_places_gives_the_same(c):
    path = lambda q: (
        1 + q + c[0] * q * (1 - q),
        2 * q + c[1] * sin(3 * q) * (1 - q),
        3 - q + c[2] * q * (q - 1) * cos(c[3] * q),
    )
    assert work_along(lambda x, y, z: (c[4], 0, c[5]), path, 0.0, 1.0).value == pytest.approx(
        c[4] - c[5], abs=1e-9
    )


@every_kind
def test_eqn_11_8_power_is_the_rate_of_work(kind):
    """U(t) of F = (c t, d) at v = (t, t^2) by hand, differentiated by the jet."""
    c, d, t = numbers(kind, 3, "0.5", "1.5")
    U = lambda t: c * t**3 / 3 + d * t**3 / 3
    F, v = lambda s: (c * s, d, 0), lambda s: (s, s * s, 0)
    assert close(work_in_time(F, v, 0, t, exact=kind == "sympy").value, U(t), small(kind))
    assert close(power(F(t), v(t)), at(U, t).rate, small(kind))


@every_kind
def test_eqn_11_9_power_of_the_resultant_is_the_rate_of_kinetic_energy(kind):
    m, t = numbers(kind, 2, "0.75")
    ground = Frame("ground")
    place = along(lambda t: (sin(t), t**3, cos(2 * t) * t), t)
    P = ground.point("P", *place)
    T = m * sum(moving(x.rate, x.acceleration) ** 2 for x in place) / 2
    F, v = m * P.acceleration(ground), P.velocity(ground)
    for given_as in ((F, P, ground), (F, v), (tuple(F), tuple(v))):
        assert close(power(*given_as), T.rate, small(kind))


def tumbling(kind):
    """A body that turns about two axes while its origin moves; two of its points, and an arm."""
    a, b, v, x = numbers(kind, "0.7", "-1.25", 3, "0.4")
    ground = Frame("ground")
    O = ground.point("O", moving(a, v), moving(b, -v), 0)
    body = ground.rotate("yaw", "z", moving(a, b), origin=O).rotate("body", "x", moving(b, a))
    return ground, body, body.point("C", x, a, b), body.point("D", -b, x, a), body.vector(v, a, x)


@every_kind
def test_eqn_11_10_a_couple_has_the_power_of_its_moment(kind):
    ground, body, C, D, F = tumbling(kind)
    omega, r = body.angular_velocity(ground), D - C
    M = r.cross(F)
    expected = power(M, body, ground)
    assert close(F.dot(D.velocity(ground)) - F.dot(C.velocity(ground)), expected, small(kind))
    for way in (F.dot(omega.cross(r)), omega.dot(M), pair_power(F, D, C, ground), power(M, omega)):
        assert close(way, expected, small(kind))


@every_kind
def test_eqn_11_11_a_couple_in_the_plane_over_time_and_over_the_angle(kind):
    """M = c sin(theta), with theta = t^2."""
    c, t = numbers(kind, 3, "1.25")
    exact = kind == "sympy"
    M, omega = lambda t: (0, 0, c * sin(t * t)), lambda t: (0, 0, 2 * t)
    in_angle = work_integral(lambda theta: c * sin(theta), 0, t * t, exact=exact)
    for U in (in_angle, work_in_time(M, omega, 0, t, exact=exact)):
        assert close(U.value, c * (1 - cos(t * t)), small(kind))


@every_kind
def test_section_11_13_forces_between_two_points_of_a_body_do_no_work(kind):
    ground, _, C, D, _ = tumbling(kind)
    line = D - C
    assert close(pair_power(3 * line, D, C, ground), 0, small(kind))
    assert not close(power(3 * line, D, ground), 0, 1e-3)  # each force alone does work


def test_section_11_13_between_two_bodies_they_do():
    """The power of a stretching spring is minus the tension times the rate of the distance."""
    ground = Frame("ground")
    A, B = ground.point("A", 0, 0, 0), ground.point("B", moving(3.0, 2.0), moving(4.0, -1.0), 0)
    rate = (3.0 * 2.0 - 4.0 * 1.0) / 5.0
    found = pair_power(-7.0 * (B - A).direction(), B, A, ground)
    assert found == pytest.approx(-7.0 * rate, rel=1e-14)


def test_power_has_consistent_units_and_can_be_traced():
    assert power((FORCE, FORCE, 0), (LENGTH / TIME, 0, LENGTH / TIME)) == POWER
    ground = Frame("ground")
    shaft, B = ground.rotate("shaft", "z", rate=1 / TIME), ground.point("B", 0, 0, LENGTH)
    assert power(FORCE * LENGTH * ground.k, shaft, ground) == POWER
    assert constant_force_work(FORCE * ground.k, ground.origin, B).value == POWER * TIME
    with pytest.raises(DimensionError, match="cannot add"):
        power((FORCE, FORCE, 0), (LENGTH / TIME, LENGTH, 0))

    def of_wheel(F, r, w):
        ground = Frame("ground")
        wheel = ground.rotate("wheel", "z", rate=w)
        return power(F * wheel.j, wheel.point("P", r, 0, 0), ground)

    assert compiled(of_wheel)(2.0, 3.0, 0.5) == 3.0


def test_an_mpf_keeps_its_digits_and_the_true_error_is_within_the_estimate():
    U = work_integral(lambda x: cos(x), mp.mpf(0), mp.mpf(1))
    assert abs(U.value - mp.sin(1)) < mp.mpf(10) ** -28
    assert 0 < U.error < 1e-17
    for f, true in (
        (lambda x: sqrt(x), 2 / 3),
        (lambda x: 1 / (0.01 + (x - 0.3) ** 2), 10 * (math.atan(7.0) + math.atan(3.0))),
    ):
        U = work_integral(f, 0.0, 1.0, rtol=1e-8)
        assert abs(U.value - true) <= U.error < 1e-6
        force = lambda x, y, z, f=f: (f(x), f(y), 0)
        assert work_along(force, lambda q: (q, q, 0), 0.0, 1.0, rtol=1e-8).error == 2 * U.error


@every_kind
def test_an_amount_stands_for_its_value(kind):
    a, b = numbers(kind, 5, 2)
    U = summed({"one": a, "two": -b}, "work", "11.1")
    V = summed({"all": b})
    for got, expected in (
        (U + V, a), (U - V, a - 2 * b), (1 + U, 1 + a - b), (1 - U, 1 - a + b), (2 * U, 2 * (a - b)), (U * b, (a - b) * b), (U / b, (a - b) / b),
        (-U, b - a), (U.without("two"), a), (U.reweighted(one=2), 2 * a - b),
    ):  # fmt: skip
        assert close(got, expected, small(kind))


def test_an_amount_explains_itself():
    U = work_along(swirl, helix(2.0, 0.5), 0.0, 1.5)
    assert float(U) == U.value
    text = U.explain()
    assert text.splitlines()[0] == "work, equation (11.5)"
    assert text.splitlines()[-1] == "  sum  6.28125 J"
    assert np.all(np.ones(2) * Amount(3.0) == np.array([3.0, 3.0]))
    with pytest.raises(TermError, match="no term 'w'; the terms are x, y, z"):
        U.without("w")


def test_a_force_with_a_jump_is_divided_there():
    """Friction changes sign: the rule for mpf refuses, adaptive quadrature does not."""
    turn = math.sqrt(0.1)
    force = lambda x: -1 if x < turn else 1
    U = lambda one, **breaks: work_integral(force, 0 * one, one, **breaks).value
    assert U(1.0) == pytest.approx(1 - 2 * turn, abs=1e-9)
    assert U(1.0, breaks=(turn,)) == pytest.approx(1 - 2 * turn, abs=1e-15)
    with pytest.raises(WorkError, match="does not converge; divide it with breaks"):
        U(mp.mpf(1))
    assert abs(U(mp.mpf(1), breaks=(mp.mpf(turn),)) - (1 - 2 * mp.mpf(turn))) < 1e-28


@pytest.mark.parametrize("middle", np.linspace(0.02, 0.98, 61))
@pytest.mark.parametrize("scipy", [True, False])
def test_a_pulse_of_two_percent_of_the_way_is_seen_wherever_it_is(monkeypatch, middle, scipy):
    """With 21 points on the whole path, a third of these pulses were missed."""
    if not scipy:
        monkeypatch.setitem(sys.modules, "scipy.integrate", None)
    pulse = lambda x: max(0.0, 1 - (100 * (x - middle)) ** 2) ** 4
    found = work_integral(pulse, 0.0, 1.0)
    assert found.value == pytest.approx(0.01 * 256 / 315, rel=1e-6)


def test_a_short_pulse_between_the_samples_is_missed_unless_it_is_named():
    """The naive way fails silently; work_integral's docstring says so, and what to do."""
    pulse = lambda t: 1e6 if 0.40001 < t < 0.400011 else 0.0
    assert work_integral(pulse, 0.0, 1.0).value == 0
    assert work_integral(pulse, 0.0, 1.0, breaks=(0.40001, 0.400011)).value == pytest.approx(
        1.0, rel=1e-6
    )


@pytest.mark.parametrize(("f", "options", "message"), [
    (lambda x: 1 / x, {}, "did not converge to 1e-10.*breaks="),
    (lambda x: 1 / (x - 0.5), {}, r"float division by zero\nthe integrand has no value at 0\.5|did not converge"),
    (lambda x: sin(1 / x) / x, {}, "did not converge"),
    (lambda x: sqrt(x - 0.5), {}, r"no value at 0.03125"),
    (lambda x: math.inf, {}, "the integrand is inf at 0.03125"),
    (lambda x: sin(sympy.Symbol("k") * sqrt(1 - x**4)), {}, "SymPy finds no formula for this integral; put numbers in"),
    (lambda x: sin(cos(x * x)), {"exact": True}, r"SymPy finds no formula.*without exact=True"),
    (lambda x: "x", {"exact": True}, "SymPy cannot read the integrand"),
])  # fmt: skip
def test_integrals_that_do_not_exist_are_refused_in_words(f, options, message):
    one = 1 if options else 1.0
    with pytest.raises((WorkError, ZeroDivisionError), match=message):
        work_integral(f, 0 * one, one, **options)


def test_power_asks_for_what_belongs_together_and_for_a_path_at_rest():
    ground = Frame("ground")
    with pytest.raises(FrameError, match="two Vectors, two triples"):
        power(ground.i, (1.0, 0, 0))
    with pytest.raises(FrameError, match="takes a Point, or the Frame of a couple"):
        power(ground.i, (1.0, 0, 0), ground)
    with pytest.raises(FrameError, match="share no frame"):
        power(ground.i, Frame("elsewhere").i)
    assert number(power(3.0 * ground.i, ground.point("P", 1, 2, 3), ground)) == 0
    # derivatives with respect to the parameter and to time could not be told apart
    with pytest.raises(WorkError, match=r"the path moves.*work_in_time"):
        spring_work(100.0, moving(0.2, rate=0.1))


def spring_work(k, x):
    """Work of a spring along a quarter circle of radius x: -k x^2/2 times 1 - (sqrt 2 - 1)^2."""
    return work_along(
        lambda X, Y, Z: (-k * X, -k * Y / 3, 0), lambda a: (x * cos(a), x * sin(a), 0), 0.0, 1.5
    ).value


def spring_work_by_hand(k, x):
    return k * x**2 / 2 * (1 - cos(1.5) ** 2) - k * x**2 / 6 * sin(1.5) ** 2


def test_the_work_along_a_path_takes_arrays_moving_and_traced_numbers():
    k, x = np.array([100.0, 300.0]), 0.2
    np.testing.assert_allclose(spring_work(k, x), spring_work_by_hand(k, x), rtol=1e-13)
    run = compiled(spring_work)
    assert run(100.0, x) == pytest.approx(spring_work_by_hand(100.0, x), rel=1e-13)
    np.testing.assert_allclose(run(k, x), spring_work_by_hand(k, x), rtol=1e-13)
    stiffening = moving(100.0, rate=0.1, acceleration=0.3)
    found, expected = spring_work(stiffening, x), spring_work_by_hand(stiffening, x)
    assert found.rate == pytest.approx(expected.rate, rel=1e-12)
    assert found.acceleration == pytest.approx(expected.acceleration, rel=1e-12)


def test_the_work_along_a_path_has_the_dimension_of_energy():
    force, length = Dimension(1, 1, -2), Dimension(0, 1, 0)
    assert spring_work(force / length, length) == force * length
    twist = lambda x, y, z: (force / length * y, -force / length * x, 0)
    side = work_along(twist, lambda s: (length * s, 0, 0), 0.0, 1.0)  # y is 0 along it
    other = work_along(twist, lambda s: (length, length * s, 0), 0.0, 1.0)
    assert side.value == 0
    assert side.value + other.value == force * length
    with pytest.raises(DimensionError, match="cannot add"):
        work_integral(lambda x: force + x, 0, length)


def test_work_with_symbols_goes_by_formula_without_being_asked():
    k, x = sympy.symbols("k x", positive=True)
    assert work_integral(lambda s: -k * s, 0.0, x).value == -k * x**2 / 2

"""Closed forms: exact close to every limit, one formula for floats, arrays, 30 digits and traced
text (8.14, 10.24, 11.17, 6.4).
"""

import itertools
import math
import random
from dataclasses import replace
from fractions import Fraction

import mpmath
import numpy as np
import pytest
import sympy
from hypothesis import given
from hypothesis import strategies as st

from newton_euler import compiled, integrate
from newton_euler.motion import ModelError
from newton_euler.motion.prepared import PreparedModel
from newton_euler.scenes.closed_forms.double_double import doubled
from newton_euler.scenes.closed_forms.elliptic import coupled, jacobi, unwrapped
from newton_euler.scenes.particles.orbit import orbit
from newton_euler.scenes.planar.pendulum import physical_pendulum
from newton_euler.scenes.spatial import top
from newton_euler.scenes.spatial.free_body import free_body
from tests.honesty.closed_forms import kepler
from tests.kinds import close, compiled_by
from tests.models import from_farthest

EPS = 2.0**-52


def nutating(I0, I, mgr, omega_z, theta, precession):
    """The parameters of a top that precesses at the given rate at the given theta."""
    return I0, I, mgr, omega_z, top.momentum_difference(I0, I, theta, precession, omega_z)


TOP = nutating(1.0, 1.5, 5.0, 8.0, 0.6, 0.0)  # the top of the benchmarks
PENDULUM = physical_pendulum(2.0, 0.5, 0.5, 10.0)
# rad/s at the bottom, with which this pendulum just reaches the top
SEPARATRIX = 2 * math.sqrt(10.0)


def text(model):
    """The exact solution, run from its traced text on floats."""
    return PreparedModel(model).function(model.exact)


def in_digits(model):
    return model.changed(**{n: mpmath.mpf(x) for n, x in model.parameters.items()})


def precisely(model, t, start):
    """The same formula with the same numbers, in 40 digits."""
    with mpmath.workdps(40):
        found = in_digits(model).solution(mpmath.mpf(t), tuple(map(mpmath.mpf, start)))
        return tuple(map(float, found))


def stepped(model, t, start):
    """An independent solution, to 1e-11, by a Runge-Kutta method."""
    end = integrate(replace(model, exact=None), t, start, 1e-11, "dop853").end
    return tuple(end[n] for n in model.states)


def by_series(model, t, start):
    """An independent solution: Taylor series in 25 digits."""
    with mpmath.workdps(25):
        rates, begin = in_digits(model).derivative, [mpmath.mpf(x) for x in start]
        return tuple(mpmath.odefun(lambda t, y: list(rates(y, t)), 0, begin, tol=mpmath.mpf("1e-17"))(t))  # fmt: skip


# -- twice the digits


@given(*[st.floats(0.5, 2.0) for _ in range(4)])
def test_doubled_differences_are_right_to_1e_minus_15_or_1e_minus_30_of_their_terms(a, b, c, d):
    b = a * (1 + b * 1e-12)
    A, B, C, D = map(Fraction, (a, b, c, d))
    exact = A * (A - B) * C - D * (B - A)
    found = doubled(lambda a, b, c, d: a * (a - b) * c - d * (b - a), a, b, c, d)
    assert abs(Fraction(found) - exact) <= Fraction(1e-15) * abs(exact) + Fraction(1e-30)
    assert doubled(lambda a, b, c: a * b - c, a, c, a * c) == A * C - Fraction(a * c)


@given(st.floats(1e-20, 1.0), st.floats(-9.0, 9.0))
def test_what_is_small_beside_a_doubled_number_is_not_lost(small, large):
    assert doubled(lambda a, b: a + b - b, small, large) == pytest.approx(small, rel=1e-9, abs=0)
    assert doubled(lambda a, b: b + a - b, small, large) == pytest.approx(small, rel=1e-9, abs=0)


# -- Jacobi's functions


@pytest.mark.parametrize(
    "m1", [1.0, 0.999, 0.5, 0.011, 1e-4, 0.9e-4, 1e-9, 1e-100, 1e-300, 5e-324, 0.0]
)
def test_traced_functions_take_enough_levels_for_every_parameter(m1):
    f = compiled(jacobi)
    for u in (-40.0, -1.0, 0.0, 1e-200, 0.3, 2.0, 33.3, 350.0):
        assert close(f(u, m1), jacobi(u, m1), 4 * EPS * (1 + abs(u)))


@given(st.floats(-50, 50), st.floats(1e-12, 1))
def test_the_amplitude_is_within_a_quarter_turn_of_the_mean_phase(u, m1):
    s, c, d, phase = jacobi(u, m1)
    assert s * math.sin(phase) + c * math.cos(phase) > -1e-12
    assert abs(d * d - c * c - m1 * s * s) < 1e-14


@given(*[st.floats(-2, 2) for _ in range(3)], *[st.floats(0.01, 2) for _ in range(3)])
def test_coupled_quantities_change_at_rates_that_are_products_of_the_others(x, y, z, kx, ky, kz):
    k = kx, -ky, kz
    gap, h = k[1] * (k[0] * z * z - k[2] * x * x), 1e-4
    before, (p, q, r), after = (coupled(k, (x, y, z), gap, t)[:3] for t in (0.7 - h, 0.7, 0.7 + h))
    rates = [(b - a) / (2 * h) for a, b in zip(before, after, strict=True)]
    assert close(rates, (k[0] * q * r, k[1] * r * p, k[2] * p * q), 2e-5)


@given(st.floats(-50, 50), st.floats(-3, 3))
def test_an_angle_is_counted_through_all_turns_by_a_phase_within_pi_of_it(turned, off):
    start, now = (math.cos(0.4), math.sin(0.4)), (math.cos(0.4 + turned), math.sin(0.4 + turned))
    assert abs(unwrapped(0.4, start, now, turned + off) - (0.4 + turned)) < 1e-13


# -- the free body


def random_body(rng):
    """A third of the bodies start near the separatrix, and some have equal moments."""
    I, w = [rng.uniform(0.5, 3) for _ in range(3)], [rng.gauss(0, 1) for _ in range(3)]
    kind = rng.randrange(6)
    if kind == 0:
        I[1] = I[0]
    if kind == 1:
        I[2] = I[1] * (1 + 10 ** rng.uniform(-16, -1))
    if kind >= 4:
        c, b, a = sorted(range(3), key=I.__getitem__)
        separatrix = w[a] * math.sqrt(I[a] * (I[a] - I[b]) / (I[c] * (I[b] - I[c])))
        w[c] = separatrix * (1 + rng.choice((-1, 0, 1)) * 10 ** rng.uniform(-16, -1))
    return I, w, 10 ** rng.uniform(-2, 3)


@pytest.mark.parametrize("seed", range(100))
def test_the_text_of_the_free_body_is_right_to_5_round_offs_of_the_angle_turned(seed):
    I, w, t = random_body(random.Random(seed))
    body, size = free_body(*I), math.sqrt(sum(x * x for x in w))
    assert close(text(body)(t, *w), precisely(body, t, w), 5 * EPS * size * (1 + size * t))  # rad/s


def test_it_is_right_at_once_for_bodies_turned_every_way_round():
    I, w = (1.0, 2.0, 3.0), (0.3, 1.0, 0.2)
    expected = by_series(free_body(*I), 1.0, w)
    for order, sense in itertools.product(itertools.permutations(range(3)), (1, -1)):
        if sense == (-1) ** sum(a > b for a, b in itertools.combinations(order, 2)):
            # a change of handedness reverses the rates
            found = text(free_body(*(I[n] for n in order)))(1.0, *(sense * w[n] for n in order))
            assert close(found, [sense * expected[n] for n in order], 2e-15)


def test_a_body_at_rest_or_turning_about_an_axis_or_with_equal_moments_stays():
    for I in ((1.0, 2.0, 3.0), (2.0, 2.0, 1.0), (2.0, 2.0, 2.0)):
        for w in ((0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)):
            assert close(text(free_body(*I))(400.0, *w), w, 4 * EPS)
    assert close(text(free_body(2.0, 2.0, 2.0))(9.0, 0.1, 0.2, 0.3), (0.1, 0.2, 0.3), 4 * EPS)


# -- against independent solutions


TOPS = {  # parameters; theta, theta_rate
    "cusps": (TOP, (0.6, 0.0)),
    "loops": (nutating(1.0, 1.5, 5.0, 8.0, 0.6, -1.0), (0.6, 0.0)),
    "waves": (nutating(1.0, 1.5, 5.0, 8.0, 0.6, 1.0), (0.6, 0.3)),
    "pulled upwards": (nutating(1.0, 1.5, -5.0, 3.0, 2.0, 1.0), (2.0, -0.3)),
    "no weight": (nutating(1.0, 1.5, 0.0, 8.0, 0.6, 1.0), (0.6, 0.3)),
    "spherical pendulum": (nutating(1.0, 0.0, 5.0, 0.0, 2.0, 0.5), (2.0, 0.3)),
    "over the top": ((1.0, 0.0, 5.0, 0.0, 0.0), (2.0, -5.0)),
    "swings through the bottom": ((1.0, 0.0, 5.0, 0.0, 0.0), (2.0, 1.0)),
    "through the upright": ((0.02, 0.01, 0.5, 100.0, 0.0), (0.3, 1.0)),
    "falls from near the upright": ((1.0, 1.5, 5.0, 2.0, 0.0), (0.1, 0.0)),
    "nearly through the upright": ((1.0, 1.5, 5.0, 2.0, 1e-5), (0.3, -2.0)),
    "on the other side": (nutating(1.0, 1.5, 5.0, 3.0, 0.6, 1.0), (-0.6, 0.4)),
}
# model, time, start, and how near the independent solutions come, by steps and in 25 digits
MOTIONS = {
    **{f"pendulum from {start}": (PENDULUM, 3.0, start, 1e-10 * max(map(abs, start)), 2e-14 * max(map(abs, start)))
       for start in [(1.0, 0.0), (-2.0, 3.0), (0.0, 6.5), (9.0, -7.0), (3.1, 0.0), (1e-7, 0.0)]},
    **{f"top, {name}": (top.nutation(*parameters), 0.9, start, 1e-9, 1e-11 if "nearly" in name else 2e-14)
       for name, (parameters, start) in TOPS.items()},
}  # fmt: skip


@pytest.mark.parametrize("name", MOTIONS)
def test_a_closed_form_agrees_with_integration_by_steps(name):
    model, t, start, near, _ = MOTIONS[name]
    assert close(text(model)(t, *start), stepped(model, t, start), near)


@pytest.mark.slow
@pytest.mark.parametrize("name", MOTIONS)
def test_a_closed_form_agrees_with_25_digit_integration(name):
    model, t, start, _, near = MOTIONS[name]
    assert close(text(model)(t, *start), by_series(model, t, start), near)


# -- the pendulum


@pytest.mark.parametrize("off", [1e-2, 1e-6, 1e-10, 1e-13, 0.0, -1e-13, -1e-10, -1e-6, -1e-2])
def test_on_both_sides_of_the_separatrix_it_is_the_motion_of_a_start_within_round_off(off):
    omega = SEPARATRIX * (1 + off)
    found = text(PENDULUM)(4.0, 0.0, omega)
    between = [precisely(PENDULUM, 4.0, (0.0, omega * (1 + n * EPS))) for n in (-4, 4)]
    bounds = [(min(a, b) - 1e-13, max(a, b) + 1e-13) for a, b in zip(*between, strict=True)]
    assert all(low <= x <= high for x, (low, high) in zip(found, bounds, strict=True))


def test_a_pendulum_counts_every_turn_keeps_small_swings_and_stays_upright():
    theta, omega = text(PENDULUM)(1000.0, 0.0, -30.0)
    assert theta == pytest.approx(precisely(PENDULUM, 1000.0, (0.0, -30.0))[0], rel=1e-13)
    assert theta < -29000
    assert omega < -25
    theta, _ = text(PENDULUM)(1.0, 1e-150, 0.0)
    assert theta / 1e-150 == pytest.approx(math.cos(math.sqrt(10)), rel=1e-14)
    assert close(text(PENDULUM)(5.0, math.pi, 0.0), (math.pi, 0.0), 1e-8)
    up = physical_pendulum(2.0, 0.5, 0.5, -10.0)
    assert close(text(up)(3.0, 1.0, 0.3), stepped(up, 3.0, (1.0, 0.3)), 1e-10)
    assert close(text(up)(3.0, 1.0, 9.3), stepped(up, 3.0, (1.0, 9.3)), 1e-10)
    assert close(text(physical_pendulum(2.0, 0.5, 0.5, 0.0))(3.0, 1.0, 0.3), (1.9, 0.3), 1e-15)


# -- the top


def random_top(rng):
    I0, theta = rng.uniform(0.3, 3), rng.uniform(0.05, 3.1)
    I, mgr, spin = rng.uniform(0, 2) * I0, rng.gauss(0, 5), rng.gauss(0, 6)
    rate, precession = rng.gauss(0, 2), rng.gauss(0, 3)
    kind = rng.randrange(6)
    if kind == 0:
        I, precession = 0.0, precession * rng.randrange(2)
    if kind == 1:
        mgr *= 10 ** rng.uniform(-20, 0) * rng.randrange(2)
    if kind == 2:
        theta, rate = 10 ** rng.uniform(-8, -1), rate * theta
    *parameters, q = nutating(I0, I, mgr, spin, theta, precession)
    if kind in (3, 4):
        q = 10 ** rng.uniform(-20, -2) if kind == 4 else 0.0
    return (*parameters, q), 10 ** rng.uniform(-2, 2), (theta, rate)


@pytest.mark.parametrize("seed", range(100))
def test_the_text_of_the_top_is_right_to_50_round_offs_of_the_angle_turned(seed):
    parameters, t, start = random_top(random.Random(seed))
    model = top.nutation(*parameters)
    I0, I, mgr, spin, _ = parameters
    energy = abs(model.invariant("energy", start))
    rate = math.sqrt(2 * (energy + abs(mgr)) / I0) + abs(I * spin) / I0
    off = [abs(a - b) for a, b in zip(text(model)(t, *start), precisely(model, t, start), strict=True)]  # fmt: skip
    assert off[0] < 50 * EPS * (1 + rate * t)
    assert off[1] < 50 * EPS * (1 + rate * t) * rate


@pytest.mark.parametrize("off", [0.0, 1e-13, 1e-9, 1e-5])
def test_steady_precession_stays_and_beside_it_the_nutation_is_small(off):
    I0, I, mgr, spin, theta = 1.0, 1.5, 5.0, 8.0, 0.6
    a, b = I0 * math.cos(theta), I * spin
    steady = 2 * mgr / (b + math.sqrt(b * b - 4 * a * mgr))
    model = top.nutation(*nutating(I0, I, mgr, spin, theta, steady * (1 + off)))
    found = text(model)(7.0, theta, 0.0)
    assert close(found, precisely(model, 7.0, (theta, 0.0)), 1e-14)
    assert abs(found[0] - theta) < off + 1e-14


@pytest.mark.parametrize("mgr", [-4.6, 4.6])
@pytest.mark.parametrize("tilt", [1e-3, 1e-7])
def test_small_nutations_about_a_vertical_keep_their_relative_accuracy(mgr, tilt):
    """A top pulled up near the upward vertical, and a fast top that sleeps there."""
    spin = 1.9 if mgr < 0 else 90.0
    model = top.nutation(*nutating(0.8, 0.06, mgr, spin, tilt, 0.3))
    for t in (0.1, 2.0, 9.0):
        found, exact = text(model)(t, tilt, 0.4 * tilt), precisely(model, t, (tilt, 0.4 * tilt))
        assert close(found, exact, 1e-12 * tilt)


def test_a_sleeping_top_sleeps_every_top_starts_at_its_start_and_not_on_the_vertical():
    for spin in (1.0, 100.0):
        assert text(top.nutation(0.02, 0.01, 0.5, spin, 0.0))(50.0, 0.0, 0.0) == (0.0, 0.0)
    for parameters, start in TOPS.values():
        assert close(text(top.nutation(*parameters))(0.0, *start), start, 1e-15 * 6)
    model = top.nutation(1.0, 1.5, 5.0, 8.0, 1.0)
    with pytest.raises(ZeroDivisionError):
        text(model)(1.0, 0.0, 0.0)
    with pytest.raises(ZeroDivisionError):
        model.solution(1.0, (0.0, 0.0))


# -- orbits


def by_kepler(t, *state):
    """The orbit about mu = 1 in 40 digits, with Kepler's equation solved between bounds."""
    with mpmath.workdps(40):
        x, y, u, v = map(mpmath.mpf, state)
        return tuple(map(float, kepler(mpmath, mpmath.mpf(1), (x, y), (u, v), mpmath.mpf(t))))


@pytest.mark.parametrize("e", [0.0, 1e-9, 0.3, 0.9, 0.999, 0.999999])
def test_the_text_of_the_orbit_agrees_with_keplers_equation_solved_between_bounds(e):
    model = orbit(1.0)
    start = from_farthest(1.0, 1.0, e)
    for begin in (0.0, 2.0, math.pi, 3.3):
        x = model.solution(begin, start)
        for t in (-20.0, -0.3, 0.0, 1e-5, 1.0, 3.1, 3.2, 50.0):
            found, expected = text(model)(t, *x), by_kepler(t, *x)
            assert math.dist(found[2:], model.solution(t, x)[2:]) == 0
            speed = math.hypot(*expected[2:])
            assert math.dist(found[:2], expected[:2]) < 5 * EPS * (2 + speed * (1 + abs(t)))


def test_it_has_no_value_where_the_orbit_is_not_an_ellipse():
    for start in ((1.0, 0.0, 0.0, 1.5), (1.0, 0.0, 0.5, 0.0)):
        assert all(map(math.isnan, text(orbit(1.0))(3.0, *start)))


# -- every closed form


MODELS = [
    (free_body(1.0, 2.0, 3.0), (0.1, 1.0, 0.2)), (PENDULUM, (1.0, 0.5)), (PENDULUM, (0.0, 7.0)), (top.nutation(*TOP), (0.6, 0.1)),
    (orbit(1.0), (1.0, 0.0, 0.1, 1.2)),
]  # fmt: skip


@pytest.mark.parametrize(("model", "start"), MODELS)
def test_its_text_on_arrays_and_through_heyoka_gives_what_it_gives_one_by_one(model, start):
    f, times = text(model), np.linspace(-2.0, 9.0, 40)
    one_by_one = np.array([f(t, *start) for t in times.tolist()]).T
    assert close(tuple(f(times, *start)), tuple(one_by_one), 1e-13)
    pytest.importorskip("heyoka")
    fast = compiled_by("heyoka", lambda t: f(t, *start))
    assert close(tuple(fast(times)), tuple(one_by_one), 1e-13)


@pytest.mark.parametrize(("model", "start"), MODELS)
def test_arrays_of_starts_are_solved_at_once_without_tracing(model, start):
    scale = np.array([1.0, 1.01, 0.99])
    together = model.solution(2.0, tuple(x * scale for x in start))
    for n, x in enumerate(scale.tolist()):
        alone = model.solution(2.0, tuple(x * v for v in start))
        assert close([v[n] for v in together], alone, 1e-13)


@pytest.mark.parametrize("model", [PENDULUM, top.nutation(*TOP)])
def test_expressions_are_refused_in_words(model):
    with pytest.raises(ModelError, match="needs numbers"):
        model.solution(sympy.Symbol("t"), (0.6, 0.1))

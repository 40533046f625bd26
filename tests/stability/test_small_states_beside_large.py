"""A small state beside one of 6.4e6 (a place on the Earth) or 1.5e11 (an orbit), even where it is
small because these cancel: the error of each is relative to its own size.
"""

import itertools
import math
from contextlib import suppress

import numpy as np
import pytest

from newton_euler import Event, Model, cos, integrate, prepare, sin, sqrt, where
from newton_euler.motion import AccuracyError, FarError, second_order

EARTH = 3.986004418e14


def spring_at(place):
    """A vibration of 1e-3 m whose model also has a position, which travels at 30 km/s."""
    rates = lambda s, p, t: (3e4 + 0.0 * s.z, s.u, -p.k * s.x)
    return Model("in a vehicle", {"k": 9.0}, ("z", "x", "u"), rates), (place, 1e-3, 0.0)


METHODS = ("auto", "taylor", "dop853", "scipy DOP853", "scipy RK45")


@pytest.mark.one_in(4)
@pytest.mark.parametrize("rtol", [1e-3, 1e-6, 1e-9])
@pytest.mark.parametrize("place", [6.4e6, 1.5e11])
@pytest.mark.parametrize("method", METHODS)
def test_a_vibration_far_away_is_as_accurate_as_asked(method, place, rtol):
    model, start = spring_at(place)
    motion = integrate(model, 20.0, start, rtol, method)
    assert abs(motion.end["x"] / 1e-3 - math.cos(60.0)) <= motion.error <= rtol


@pytest.mark.parametrize("method", ["auto", "taylor", "dop853"])
def test_prepared_runs_and_batches_are_as_accurate_too(method):
    model, start = spring_at(6.4e6)
    assert abs(prepare(model, 1e-9, method)(20.0, start)[1] / 1e-3 - math.cos(60.0)) <= 1e-9
    motions = integrate(model, 20.0, (start[0], np.full(70, 1e-3), 0.0), 1e-9, method)
    assert abs(motions.states["x"][:, -1] / 1e-3 - math.cos(60.0)).max() <= 1e-9
    assert (motions.error <= 1e-9).all()


@pytest.mark.parametrize("method", ["auto", "taylor", "dop853"])
def test_the_attitude_of_a_satellite_beside_its_orbit(method):
    """Circular orbit and small libration: the frequency is sqrt(3 q) of the orbit's."""
    r, q, a0 = 7e6, 0.4, 1e-9
    n = math.sqrt(EARTH / r**3)

    def rates(s, p, t):
        r3 = (s.x * s.x + s.y * s.y) * sqrt(s.x * s.x + s.y * s.y)
        return s.u, s.v, -EARTH * s.x / r3, -EARTH * s.y / r3, s.w, -3 * q * n * n * sin(s.a)

    model = Model("satellite", {}, ("x", "y", "u", "v", "a", "w"), rates)
    t = 2.3 * 2 * math.pi / n
    motion = integrate(model, t, (r, 0.0, 0.0, n * r, a0, 0.0), 1e-9, method)
    assert abs(motion.end["a"] / a0 - math.cos(math.sqrt(3 * q) * n * t)) <= 1e-9
    assert abs(motion.end["x"] / r - math.cos(n * t)) <= 1e-8  # the start is rounded too


@pytest.mark.parametrize("unit", [1e-12, 1.0, 1e12])
@pytest.mark.parametrize("method", ["taylor", "dop853"])
def test_the_error_does_not_depend_on_the_unit(method, unit):
    model = Model("oscillator", {"k": 1.0}, ("x", "v"), lambda s, p, t: (s.v, -p.k * s.x))
    for rtol in (1e-5, 1e-9):
        motion = integrate(model, 30.0, (unit, 0.0), rtol, method)
        assert abs(motion.end["x"] / unit - math.cos(30.0)) <= motion.error <= rtol


@pytest.mark.parametrize("method", ["auto", "dop853", "taylor"])
def test_a_state_that_is_zero_by_cancellation_costs_nothing_and_is_not_refused(method):
    """Steady precession in Euler angles: the rate of nutation is a rounded zero."""
    from newton_euler.scenes.spatial.top import euler

    I0, I, mgr, theta, psi_rate = 1.0, 0.4, 2.0, 0.7, 0.9
    spin = (mgr + (I0 - I) * math.cos(theta) * psi_rate**2) / (I * psi_rate)
    model = euler(I0, I, mgr, spin)
    names = model.states
    values = {"psi": 0.0, "theta": theta, "psi_rate": psi_rate, "theta_rate": 0.0}
    start = tuple(values.get(n, 0.0) for n in names)
    motion = integrate(model, 10.0, start, 1e-9, method)
    assert motion.cost.calls < 50_000
    assert motion.error <= 1e-9


@pytest.mark.parametrize("left", [1e-2, 1e-5, 3e-6])
@pytest.mark.parametrize("rtol", [1e-3, 1e-6, 1e-9])
def test_the_speed_of_a_rocket_is_judged_by_its_size_though_almost_no_mass_is_left(left, rtol):
    """v' = u q/m: near m = 0 the effect of the mass on the speed has no bound."""
    u, q, m0 = 3000.0, 250.0, 1e4
    model = Model(
        "rocket", {"u": u, "q": q}, ("v", "m"), lambda s, p, t: (p.u * p.q / s.m, -p.q + 0 * s.v)
    )
    motion = integrate(model, m0 / q * (1 - left), (0.0, m0), rtol, "dop853")
    speed = u * math.log(m0 / motion.end["m"])
    assert abs(motion.end["v"] / speed - 1) <= motion.error <= rtol


def far_spring(place, k=4.0):
    acceleration = lambda s, p, t: (-p.k * (s.x - p.place),)
    return second_order("far spring", {"k": k, "place": place}, ("x",), acceleration)


@pytest.mark.one_in(4)
@pytest.mark.parametrize("amplitude", [1e-3, 1e-2, 1.0])
@pytest.mark.parametrize("place", [1e3, -6.4e6, 1e9])
@pytest.mark.parametrize("method", METHODS)
def test_the_speed_on_a_far_spring_is_right_by_its_own_size_or_refused(method, place, amplitude):
    start = place + amplitude, 0.0
    a = start[0] - place
    lost = 2.0**-52 * abs(place) / a  # what round-off leaves unknown
    for rtol in (1e-3, 1e-6, 1e-9):
        try:
            found = integrate(far_spring(place), 10.0, start, rtol, method)
        except AccuracyError as error:
            words = str(error)
        else:
            words = ""
            assert abs(found.end["dx"] / (2 * a) + math.sin(20.0)) <= found.error <= rtol
        assert not words or ("take the distance from" in words and 30 * lost > rtol)


KICKED, DRIVEN, BY_A_CLOCK, BY_A_CLOCK_OF_STATES = range(4)


@pytest.mark.one_in(4)
@pytest.mark.parametrize("how", [None, KICKED, DRIVEN, BY_A_CLOCK, BY_A_CLOCK_OF_STATES])
@pytest.mark.parametrize("place", [1e3, 6.371e6, 1e9])
def test_a_swing_of_a_few_last_digits_of_its_place_is_right_or_refused_in_words(place, how):
    """From 1e-1 down to 8 units in the last place; at 1e-12 floats cannot do any."""
    k, w, T, least = 4.0, 1.3, 4.1, 8 * math.ulp(place)
    phase = lambda s, p, t: {DRIVEN: p.w * t, BY_A_CLOCK: s.clock}.get(how, -s.clock)
    push = lambda s, p, t: p.f * sin(phase(s, p, t))
    clock = lambda s, p: 0.0 * s.x - p.w if how == BY_A_CLOCK_OF_STATES else p.w
    rates = lambda s, p, t: (s.v, -p.k * (s.x - p.place) + push(s, p, t), clock(s, p))
    for a in [least, *(10.0**-n for n in range(1, 9) if 10.0**-n > least)]:
        f = 0.0 if how in (None, KICKED) else a * k
        start = place if how is not None else place + a, 3 * a if how == KICKED else 0.0, 0.0
        parameters = {"k": k, "place": place, "f": f, "w": w}
        model = Model("far swing", parameters, ("x", "v", "clock"), rates)
        begin, b = start[0] - place, f / (k - w * w)
        exact = -2 * begin * math.sin(2 * T) + (start[1] - b * w) * math.cos(2 * T)
        exact += b * w * math.cos(w * T)
        for rtol in (1e-3, 1e-6, 1e-9, 1e-12):
            try:
                v, words = integrate(model, T, start, rtol).end["v"], ""
            except AccuracyError as error:
                v, words = math.inf, str(error)
            if words:
                assert "take the distance from" in words
                assert 300 * 2.0**-52 * place / a > rtol
            else:
                assert abs(v - exact) <= rtol * 3 * a


@pytest.mark.parametrize("rtol", [1e-2, 1e-3])
@pytest.mark.parametrize("width", [1.0, 1e-2])
def test_a_short_push_of_a_micrometre_by_a_clock_is_right_or_refused(width, rtol):
    k, place, f, T = 4.0, 6.4e6, 1e-6 / width, 10.3

    def rates(s, p, t):
        push = where(s.clock > -6.0, where(s.clock < width - 6.0, f, 0.0), 0.0)
        return s.v, push - k * (s.x - place), 1.0 + 0.0 * s.x

    exact = f / 2 * (math.sin(2 * (T - 5)) - math.sin(2 * (T - 5 - width)))
    model = Model("pushed", {}, ("x", "v", "clock"), rates)
    with suppress(FarError):
        assert abs(integrate(model, T, (place, 0, -11), rtol).end["v"] - exact) <= rtol * 1e-6


@pytest.mark.one_in(2)
@pytest.mark.parametrize("rtol", [1e-1, 1e-2])
def test_two_series_that_make_about_the_same_of_a_small_state_do_not_confirm_it(rtol):
    pytest.importorskip("heyoka")
    for place, k in itertools.product((6e3, 6.7e4, 2.1e6), (0.5, 4.0, 40.0)):
        n, start = math.sqrt(k), place + np.geomspace(1e-4, 1e-1, 70)
        a, T = start - place, 33.0 / n
        model = far_spring(place, k)
        motions = integrate(model, T, (start, 0.0), rtol, "taylor").states["dx"][:, -1]
        alone = [integrate(model, T, (x, 0.0), rtol, "taylor").end["dx"] for x in start[::7]]
        exact = -a * n * math.sin(33.0)
        assert (abs(motions - exact) <= rtol * a * n).all()
        assert (abs(alone - exact[::7]) <= rtol * a[::7] * n).all()


@pytest.mark.one_in(3)
@pytest.mark.parametrize("rtol", [1e-3, 1e-6])
@pytest.mark.parametrize("digits", [0.0, 4.0])
@pytest.mark.parametrize("by_states", [False, True])
def test_a_swing_that_resonance_makes_of_a_push_below_the_last_digit_is_right_or_refused(
    by_states, digits, rtol
):
    """The push never moves the rate beyond the last digit of the place; over thirty periods it
    makes a swing of many of them.
    """
    place, w, T = 6.4e6, 1.7, 60.6 * math.pi / 1.7
    digit = math.ulp(place)
    for swing in (1e-2, 3.0, 100.0):  # digits of the place
        f = swing * digit * 2 * w / T

        def rates(s, p, t, f=f):
            push = f * s.u if by_states else f * sin(w * t)
            turning = (w * s.c, -w * s.u) if by_states else ()
            return s.v, push - w * w * (s.x - place), *turning

        names = ("x", "v", *("uc" if by_states else ""))
        start = place + digits * digit, 0.0, *((0.0, 1.0) if by_states else ())
        exact = f / 2 * T * math.sin(w * T) - w * digits * digit * math.sin(w * T)
        size = w * digit * max(swing, digits)
        for method in ("dop853", "auto"):
            with suppress(FarError):
                end = integrate(Model("pushed", {}, names, rates), T, start, rtol, method).end
                assert abs(end["v"] - exact) <= rtol * size


@pytest.mark.parametrize("rtol", [1e-1, 1e-3])
def test_a_state_that_a_first_run_makes_large_is_judged_by_its_own_size_over_a_long_time(rtol):
    rates = lambda s, p, t: (s.v, sin(1.7 * s.c) * 1e-3 - 4.0 * (s.x - 6.4e6), 1e3 + 0 * s.x)
    with pytest.raises(FarError, match="take the distance from"):
        integrate(Model("driven fast", {}, ("x", "v", "c"), rates), 10.0, (6.4e6, 0.0, 0.0), rtol)


def test_what_hangs_or_turns_at_rest_is_not_refused_for_the_last_digit_of_its_place():
    """Its speed should be zero, but a float is not quite where it is at rest."""
    hanging = lambda s, p, t: (s.v, p.g - p.k * s.x / p.m)
    turning = lambda s, p, t: (s.v, s.r * s.w * s.w - p.g / (s.r * s.r), -2 * s.v * s.w / s.r)
    around = lambda s, p, t: (s.v, s.h * s.h / s.r**3 - p.g / s.r**2, 0.0 * s.r)
    for n in range(1, 30):
        m, k, g = 0.1 * n, 1.0 + 3.7 * n, 9.81
        hung = Model("hanging", {"m": m, "k": k, "g": g}, ("x", "v"), hanging), (m * g / k, 0.0)
        circle = Model("circle", {"g": g}, ("r", "v", "w"), turning), (m, 0.0, math.sqrt(g / m**3))
        orbit = Model("orbit", {"g": g}, ("r", "v", "h"), around), (m, 0.0, math.sqrt(g * m))
        for model, start in (hung, circle, orbit):
            for rtol in (1e-3, 1e-9):
                assert abs(integrate(model, 1.0, start, rtol, "dop853").end["v"]) < rtol


def test_a_small_state_is_not_refused_where_round_off_leaves_it_as_accurate_as_asked():
    """A kilometre beside a millimetre: 2e-10 of its size is lost, and 1e-9 was asked for."""
    pytest.importorskip("heyoka")
    found = integrate(far_spring(1e3), 1.0, (1e3 + 1e-3, 0.0), 1e-9)
    a = (1e3 + 1e-3) - 1e3
    assert abs(found.end["dx"] / (2 * a) + math.sin(2.0)) <= found.error <= 1e-9


def test_a_far_motion_is_accurate_but_for_the_small_state():
    with pytest.raises(FarError) as refused:
        integrate(far_spring(6.4e6), 10.0, (6.4e6 + 1e-2, 0.0), 1e-9)
    found, a = refused.value.reached, (6.4e6 + 1e-2) - 6.4e6
    assert abs(found.end["x"] - 6.4e6 - a * math.cos(20.0)) < 1e-9 * 6.4e6
    assert abs(found.end["dx"] / (2 * a) + math.sin(20.0)) <= found.error


@pytest.mark.parametrize("rtol", [1e-3, 1e-6, 1e-9])
def test_the_same_call_gives_the_same_answer_once_the_series_is_compiled(rtol):
    def asked(method):
        try:
            return integrate(far_spring(6.4e6), 10.0, (6.4e6 + 1e-2, 0.0), rtol, method).end["dx"]
        except AccuracyError as error:
            return str(error)

    first, _, second = asked("auto"), asked("taylor"), asked("auto")
    if isinstance(first, float):
        assert abs(first - second) <= 2 * rtol * 2e-2
    else:
        assert "take the distance from 6.4e+06" in first
        assert "take the distance from 6.4e+06" in second


@pytest.mark.parametrize("method", ["dop853", "taylor"])
def test_a_far_spring_that_bounces_is_right_after_each_impact(method):
    """On one side of its position only, with half of the speed left: the amplitude is halved."""
    model, place = far_spring(6.4e6), 6.4e6
    again = lambda s, p, t: (model, (s.x, -0.5 * s.dx))
    wall = Event(lambda s, p, t: s.x - p.place, direction=-1, then=again)
    found = integrate(model, 4.0, (place + 1e-2, 0.0), 1e-3, method, wall)
    a = (place + 1e-2) - place
    assert len(found.events) == 3
    assert found.end["dx"] == pytest.approx(a / 8 * 2 * math.cos(8.0 - 2.5 * math.pi), rel=1e-2)


@pytest.mark.one_in(4)
@pytest.mark.parametrize("method", ["auto", "dop853", "taylor"])
@pytest.mark.parametrize("rtol", [1e-3, 1e-6, 1e-9])
def test_a_state_that_is_nothing_but_error_is_not_refused(method, rtol):
    """r r' on a circular orbit, and the difference of two equal oscillators."""

    def orbit(s, p, t):
        r3 = (s.x * s.x + s.y * s.y) ** 1.5
        return s.u, s.v, -s.x / r3, -s.y / r3, s.x * s.u + s.y * s.v + 0.0 * s.e

    pair = lambda s, p, t: (s.u, -p.k * s.x, s.v, -p.k * sin(s.y) * s.y / sin(s.y), s.x - s.y)
    one = Model("orbit", {}, ("x", "y", "u", "v", "e"), orbit)
    two = Model("pair", {"k": 3.7}, ("x", "u", "y", "v", "e"), pair)
    for model, start in ((one, (1.0, 0.0, 0.0, 1.0, 0.0)), (two, (1.0, 0.0, 1.0, 0.0, 0.0))):
        motion = integrate(model, 10.0, start, rtol, method)
        assert motion.error <= rtol
        assert abs(motion.end["e"]) <= 1e-2 * rtol


def test_a_wire_after_many_turns_that_swings_by_a_clock_has_the_rate_that_was_asked():
    """The error of its angle, relative to thousands of radians, does not set the steps."""
    k, f, q = 2.649127506057907, 0.007227831712865494, 0.39350308
    a0, clock = 9839.468191043232, 28.7
    rates = lambda s, p, t: (s.v, -k * (s.a - a0) + f * cos(q * s.clock), 1.0 + 0.0 * s.a)
    start, T = (9840.292255447695, 0.0, clock), 19.601288432177043
    rate = integrate(Model("wire", {}, ("a", "v", "clock"), rates), T, start, 1e-6).end["v"]
    w, b = math.sqrt(k), f / (k - q * q)
    x, u = start[0] - a0 - b * math.cos(q * clock), b * q * math.sin(q * clock)
    exact = u * math.cos(w * T) - w * x * math.sin(w * T) - b * q * math.sin(q * (clock + T))
    assert rate == pytest.approx(exact, abs=1e-6 * 1.33)

"""The models that make up the ladders of chapters 6, 9, 10 and 11: their units, closed forms,
limits, invariants and bounds, and which model is chosen.
"""

import math
import random
from dataclasses import replace

import mpmath as mp
import numpy as np
import pytest
import sympy
from hypothesis import given
from hypothesis import strategies as st
from scipy.integrate import solve_ivp

from newton_euler import Dimension, integrate
from newton_euler.chapters.examples.ch11 import Car
from newton_euler.motion.model import ModelError, Named, is_law
from newton_euler.scenes import ladder
from newton_euler.scenes.particles.space_station import body_in_air
from newton_euler.scenes.planar.hinged_rod import hinged, least_rate, on_free_shaft, rod
from newton_euler.scenes.planar.rolling_sphere import rolling_in_air
from tests.newton_euler.scenes.draws import LATER_CHAPTERS as DRAWS

PURE, MASS, LENGTH, TIME = Dimension(), Dimension(1, 0, 0), Dimension(0, 1, 0), Dimension(0, 0, 1)
SPEED, FORCE = LENGTH / TIME, MASS * LENGTH / TIME**2
G, INERTIA, RATE = LENGTH / TIME**2, MASS * LENGTH**2, PURE / TIME
PLANE = {"x": LENGTH, "y": LENGTH, "dx": SPEED, "dy": SPEED}

# by name: the dimensions of the parameters, the states, and the observed quantity
UNITS = {
    "aircraft": (
        {"m": MASS, "g": G, "thrust": FORCE, "k_lift": MASS / LENGTH, "k_drag": MASS / LENGTH, "bank": PURE,
         "chi0": PURE, "gamma0": PURE, "v0": SPEED, "x0": LENGTH, "y0": LENGTH, "h0": LENGTH},
        {"x": LENGTH, "y": LENGTH, "h": LENGTH, "s": LENGTH, "v": SPEED, "chi": PURE, "gamma": PURE},
        LENGTH,
    ),
    "space station": ({"omega": RATE, "radius": LENGTH, "air": PURE / LENGTH, "creep": SPEED}, PLANE, LENGTH),
    "air near a low": ({"latitude": PURE, "rate": RATE, "pressure_gradient": PURE / TIME**2, "friction": RATE}, PLANE, LENGTH),
    "rotor": (
        {"mass": MASS, "x": LENGTH, "y": LENGTH, "I": INERTIA, "g": G, "moment": FORCE * LENGTH, "omega": RATE},
        {"psi": PURE, "omega": RATE},
        PURE,
    ),
    "turning shaft": (
        {"weight_moment": FORCE * LENGTH, "momentum": INERTIA / TIME, "omega": RATE, "inertia_difference": INERTIA,
         "about_hinge": INERTIA, "shaft": INERTIA, "rest": PURE, "stiffness": PURE / TIME**2},
        {"theta": PURE, "theta_rate": RATE},
        PURE,
    ),
    "sphere on an incline": ({"slope": PURE, "g": G, "k": PURE, "air": PURE / LENGTH}, {"x": LENGTH, "v": SPEED}, LENGTH),
    "car on a hill": (
        {"m": MASS, "air": MASS / LENGTH, "g": G, "force": FORCE, "slope": PURE,
         "wheel_mass": MASS, "gyration": LENGTH, "radius": LENGTH, "wheels": PURE},
        {"s": LENGTH, "v": SPEED},
        LENGTH,
    ),
}  # fmt: skip
RUNGS = [(name, rung.name) for name in UNITS for rung in ladder(name).rungs]


def same(found, expected):
    """Whether dimensions are equal; a structural zero has any dimension."""
    pairs = zip(found, expected, strict=True)
    return all(f == e or (isinstance(f, int) and f == 0) for f, e in pairs)


@pytest.mark.parametrize(("name", "rung"), RUNGS)
def test_rates_solutions_and_bounds_have_the_units_of_their_quantities(name, rung):
    parameters, known, asked = UNITS[name]
    rung = ladder(name).rung(rung)
    numbers = {n: parameters[n] for n, x in rung.model.parameters.items() if not is_law(x)}
    model, states = rung.model.changed(**numbers), tuple(known[n] for n in rung.model.states)
    assert same(model.derivative(states, TIME), [x / TIME for x in states])
    if model.exact:
        assert same(model.solution(TIME, states), states)
    assert all(x in (asked, math.inf) for x in model.neglected(TIME, states).values())
    state = Named("state", dict(zip(model.states, states, strict=True)))
    parameter = Named("parameter", model.parameters)
    assert all(x == asked for x in rung.observed(state, parameter, TIME))


KEEPING = [(name, rung) for name, rung in RUNGS if ladder(name).rung(rung).model.invariants]


@pytest.mark.parametrize(("name", "rung"), KEEPING)
def test_invariants_are_kept_by_the_integrated_rates(name, rung):
    r = random.Random(6)
    for _ in range(3):
        asked, _ = DRAWS[name](r)
        model, start = replace(asked.rung(rung).model, exact=None), asked.rung(rung).start
        motion = integrate(model, asked.t, start, 1e-10, "dop853", samples=50)
        assert max(motion.drift.values()) < 1e-7, motion.drift


# balanced by a thrust of 972 N
FLY = {"lift": 1000 * 9.81 / 60**2, "drag": 0.27, "start": (60.0, 0.5, 0.0, 0.0, 0.0, 1000.0)}
# by rung: its ladder, the order in e in which its error vanishes, and what is given
LIMITS = {
    "block on an incline": ("sphere on an incline", 1, lambda e: {"k": e, "air": e / 10}),
    "sphere on an incline": ("sphere on an incline", 1, lambda e: {"air": e}),
    "car, particle": ("car on a hill", 1, lambda e: {"wheel_mass": 1e3 * e, "air": e}),
    "car on wheels": ("car on a hill", 1, lambda e: {"air": e}),
    "uniform gravity in a turning station": (
        "space station", 1, lambda e: {"omega": e, "radius": 9 / e**2, "air": e * e, "start": (9 / e**2 - 2, 0.0, 0.0, 3.0)}
    ),
    "free body in a turning station": ("space station", 1, lambda e: {"air": e}),
    "air near a low, Earth at rest": ("air near a low", 1, lambda e: {"latitude": e, "friction": 1e-4 * e}),
    "air near a low, without friction": ("air near a low", 1, lambda e: {"friction": 1e-4 * e}),
    "rotor at a constant rate": ("rotor", 1, lambda e: {"moment": e, "x": 1e-3 * e}),
    "rotor without weight": ("rotor", 1, lambda e: {"x": 1e-2 * e}),
    "small swings on a turning shaft": ("turning shaft", 2, lambda e: {"start": (1.092976956 + e, 0.0), "shaft": 4 / e**2}),
    "hinged on a turning shaft": ("turning shaft", 1, lambda e: {"shaft": 4 / e}),
    "aircraft, straight": ("aircraft", 1, lambda e: {**FLY, "bank": e, "thrust": 972 * (1 + e)}),
    "aircraft in a level turn": ("aircraft", 1, lambda e: {**FLY, "bank": 0.3, "lift": FLY["lift"] / math.cos(0.3), "thrust": 972 * (1 + e)}),
    "aircraft in a vertical plane": ("aircraft", 1, lambda e: {**FLY, "bank": e}),
}  # fmt: skip


def test_every_rung_but_the_fullest_has_a_limit_in_which_it_is_right():
    assert list(LIMITS.keys() - {rung for _, rung in RUNGS}) == []
    assert {rung for name, rung in RUNGS if rung != ladder(name).fullest.name} == LIMITS.keys()


@pytest.mark.parametrize("rung", LIMITS)
def test_a_rung_becomes_the_fullest_one_where_what_it_neglects_vanishes(rung):
    name, order, given = LIMITS[rung]
    near, nearer = (ladder(name, **given(e)) for e in (1e-2, 1e-3))
    ratio = near.error(near.rung(rung)) / nearer.error(nearer.rung(rung))
    assert ratio == pytest.approx(10**order, rel=0.15)


# by rung: the part of its bound that the error reaches in some draw; bounds are wide for motions
# that may run apart
REACHED = {
    "uniform gravity in a turning station": 0.7, "free body in a turning station": 0.6,
    "small swings on a turning shaft": 0.4, "hinged on a turning shaft": 0.01,
}  # fmt: skip
BOUNDED = [(name, rung) for name, rung in RUNGS if ladder(name).rung(rung).bound(1.0) < math.inf]


@pytest.mark.one_in(3)
@pytest.mark.parametrize(("name", "rung"), BOUNDED)
def test_bounds_hold_and_are_as_narrow_as_stated(name, rung):
    r, ratios = random.Random(8), []
    for n in range(36):
        found, _ = DRAWS[name](r)
        found = replace(found, t=found.t * (1.0, 0.1, 0.02)[n % 3])
        error, size = found.error(found.rung(rung)), abs(found.observe(found.fullest, 1e-11)).max()
        if error > 1e-8 * size:
            ratios.append(error / found.rung(rung).bound(found.t))
    assert REACHED.get(rung, 0.99) < max(ratios) < 1 + 1e-6


slopes, airs = st.floats(0.05, 1.4), st.floats(1e-4, 0.1)


@given(slopes, airs, st.floats(0.0, 1.0), st.floats(0.0, 30.0))
def test_a_sphere_in_air_keeps_what_power_against_the_air_leaves(slope, air, k, v):
    """(v^2 - a/b) e^(2 b x) is constant, with a = g sin(slope)/(1 + k) and b = air/(1 + k)."""
    a, b = 9.81 * math.sin(slope) / (1 + k), air / (1 + k)
    end = integrate(rolling_in_air(slope, 9.81, air, k), 2.5, (0.0, v), 1e-11).end
    kept = (end["v"] ** 2 - a / b) * math.exp(2 * b * end["x"])
    assert kept == pytest.approx(v**2 - a / b, rel=1e-7, abs=1e-8 * a / b)


def closed_form(air):
    """Distance after 3 s from v0 = 1 m/s on a slope of 0.5: log(cosh(n t) + b v0/n sinh(n t))/b."""
    a, b = mp.mpf(9.81) * math.sin(0.5) * 5 / 7, mp.mpf(air) * 5 / 7
    n = (a * b) ** 0.5
    return float(mp.log(mp.cosh(3 * n) + b / n * mp.sinh(3 * n)) / b)


@pytest.mark.parametrize("air", [1e-14, 1e-10, 1e-6, 1e-2])
def test_a_sphere_in_next_to_no_air_is_accurate_where_the_closed_form_in_floats_is_not(air):
    end = integrate(rolling_in_air(0.5, 9.81, air), 3.0, (0.0, 1.0), 1e-10).end
    with mp.workdps(40):
        assert end["x"] == pytest.approx(closed_form(air), rel=1e-10)


def test_the_rod_on_a_free_shaft_obeys_lagranges_equations_of_rod_and_shaft():
    """There are two coordinates: the angle of the shaft is not eliminated."""
    W, E, J, H = 14, 2, sympy.Rational(3, 2), sympy.Rational(5, 2)
    t, (a, w, p) = sympy.Symbol("t"), sympy.symbols("a w p")
    theta, psi = sympy.Function("theta")(t), sympy.Function("psi")(t)
    about_shaft = J + E * sympy.sin(theta) ** 2
    L = (H * theta.diff(t) ** 2 + about_shaft * psi.diff(t) ** 2) / 2 + W * sympy.cos(theta)
    equations = [L.diff(q.diff(t)).diff(t) - L.diff(q) for q in (theta, psi)]
    (found,) = sympy.solve(equations, [theta.diff(t, 2), psi.diff(t, 2)], dict=True)
    put = {theta.diff(t): w, psi.diff(t): p}
    rates = [found[q.diff(t, 2)].subs(put).subs(theta, a) for q in (theta, psi)]
    f = sympy.lambdify((a, w, p), rates)
    full = solve_ivp(lambda t, y: [y[1], *f(*y)], (0, 5), [0.4, 0.7, 3.0], "DOP853", rtol=1e-12, atol=1e-12)  # fmt: skip
    end = integrate(on_free_shaft(14.0, 2.0, 3.0, 1.5, 0.4, about_hinge=2.5), 5.0, (0.4, 0.7), 1e-10).end  # fmt: skip
    assert (end["theta"], end["theta_rate"]) == pytest.approx(full.y[:2, -1], abs=1e-8)


@given(st.floats(-3.0, 3.0), st.floats(-2.0, 2.0))
def test_a_heavy_shaft_turns_evenly_and_a_light_one_does_not(theta, rate):
    data = rod(3.0, 2.0, 4.0, 9.81)
    even = hinged(**data).derivative((theta, rate))
    for shaft, start, off in ((1e12, 0.3, 1e-9), (1.0, theta, 1e-12)):
        found = on_free_shaft(**data, shaft=shaft, theta=start).derivative((theta, rate))
        assert found == pytest.approx(even, rel=off, abs=off)


def test_a_body_in_the_air_of_the_station_is_held_by_a_wind_among_the_stars():
    omega, air, creep, start = -0.4, 0.05, 0.01, (50.0, 3.0, -4.0, 2.0)

    def among_stars(t, y):
        x, y_, vx, vy = y
        u, w = vx + omega * y_, vy - omega * x
        hold = air * math.sqrt(u * u + w * w + creep**2)
        return [vx, vy, -hold * u, -hold * w]

    begin = [50.0, 3.0, -4.0 - omega * 3.0, 2.0 + omega * 50.0]
    x, y, _, _ = solve_ivp(among_stars, (0, 3), begin, "DOP853", rtol=1e-12, atol=1e-12).y[:, -1]
    end = integrate(body_in_air(omega, air, creep), 3.0, start, 1e-11).end
    c, s = math.cos(3 * omega), math.sin(3 * omega)
    assert (end["x"], end["y"]) == pytest.approx((c * x + s * y, c * y - s * x), abs=1e-8)


@pytest.mark.parametrize("method", ["dop853", "taylor"])
def test_a_body_at_rest_in_the_air_of_the_station_can_be_let_go(method):
    if method == "taylor":
        pytest.importorskip("heyoka")
    models, start = (body_in_air(-0.3, 0.01, creep) for creep in (1e-2, 1e-4)), (98.0, 0, 0, 0)
    one, other = (integrate(model, 2.0, start, 1e-9, method).end["x"] for model in models)
    assert one == pytest.approx(other, abs=1e-5)


def test_air_near_a_low_with_friction_is_the_sum_of_two_complex_exponentials():
    found = ladder("air near a low", friction=3e-5)
    x, y, dx, dy = found.fullest.start
    p = found.fullest.model.parameters
    f = 2 * p["rate"] * math.sin(p["latitude"])
    one, two = np.roots([1, p["friction"] + 1j * f, p["pressure_gradient"]])
    z, w = complex(x, y), complex(dx, dy)
    A, B = (w - two * z) / (one - two), (one * z - w) / (one - two)
    t = np.linspace(0.0, found.t, 257)
    place = A * np.exp(one * t) + B * np.exp(two * t)
    assert np.abs(found.observe(found.fullest, 1e-12) - [place.real, place.imag]).max() < 1e-5


@given(st.floats(1.0, 50.0), st.floats(0.0, 0.3), st.floats(500.0, 5000.0))
def test_the_fullest_car_spends_the_power_of_11_19(v, slope, force):
    car = Car(m=1200, wheel_mass=20, gyration=0.25, radius=0.3, drag=lambda v: 0.4 * v * v, g=9.81)
    model = ladder("car on a hill", slope=slope, force=force, start=(0.0, v), t=1e-3).fullest.model
    assert car.power(v, model.derivative((0.0, v))[1], slope) == pytest.approx(force * v, rel=1e-9)


def test_a_balanced_aircraft_flies_straight_or_in_a_level_turn():
    for climb in (0.0, 0.1, -0.1):
        start, thrust = (60.0, 0.5, climb, 0.0, 0.0, 1000.0), 972.0 + 9810.0 * math.sin(climb)
        lift = FLY["lift"] * math.cos(climb)
        straight = ladder("aircraft", lift=lift, drag=0.27, thrust=thrust, start=start, bank=0.0)
        assert straight.error(straight.rung("aircraft, straight")) < 1e-6
    bank = {**FLY, "lift": FLY["lift"] / math.cos(0.4)}
    turn = ladder("aircraft", **bank, thrust=972.0, bank=0.4, t=60.0)
    assert turn.error(turn.rung("aircraft in a level turn")) < 1e-6
    assert turn.error(turn.rung("aircraft, straight")) > 100


@pytest.mark.parametrize(("name", "given", "words"), [
    ("sphere on an incline", {"start": (0.0, -0.1)}, r"a sphere that comes down, v >= 0; got v = -0\.1"),
    ("space station", {"omega": 0.0}, "omega must not be zero"),
    ("turning shaft", {"mass": 1.0, "length": 1.5, "omega": math.sqrt(9.81)}, "the least rate of swinging out"),
])  # fmt: skip
def test_what_has_no_ladder_is_refused(name, given, words):
    with pytest.raises(ModelError, match=words):
        ladder(name, **given)


@pytest.mark.parametrize("air", [0.0, 0.4, 50.0])
def test_a_car_that_comes_to_rest_is_refused_just_before_it_does(air):
    """The time is the integral of dv/a."""
    left, mass = 500.0 - 1200 * 9.81 * math.sin(0.1), 1200 + 4 * 20 * (0.25 / 0.3) ** 2
    stops = float(mp.quad(lambda v: mass / (air * v * v - left), [0, 1, 15]))
    given = {"force": 500.0, "slope": 0.1, "air": air, "start": (0.0, 15.0)}
    assert ladder("car on a hill", **given, t=0.9999 * stops).rungs
    with pytest.raises(ModelError, match="the car goes uphill until"):
        ladder("car on a hill", **given, t=1.0001 * stops)


def test_small_swings_exist_on_both_sides_of_the_least_rate():
    data = rod(1.0, 1.5, 1.0, 9.81)  # sqrt(3 g/(2 L)), here sqrt(9.81)
    least = least_rate(**data)
    given = {"mass": 1.0, "length": 1.5, "shaft": 1e9}
    for omega, rest in ((0.999 * least, 0.0), (1.001 * least, math.acos(1 / 1.001**2))):
        found = ladder("turning shaft", **given, omega=omega, start=(rest + 1e-6, 0.0))
        assert found.error(found.rungs[0]) < 1e-8


def test_a_rod_on_either_side_and_a_slow_station_have_their_ladders():
    one, other = (ladder("turning shaft", start=(sense * 1.2, 0.0)) for sense in (1, -1))
    assert one.error(one.rungs[0]) == pytest.approx(other.error(other.rungs[0]), rel=1e-9)
    barely = ladder("space station", omega=1e-9)
    assert barely.error(barely.rungs[0]) < 1.0  # m, from the air alone

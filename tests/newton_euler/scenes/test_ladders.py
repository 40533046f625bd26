"""Ladders: the choice is the cheapest rung that holds, on evidence that another integration
confirms; and refusals, in words.

The judge shares only the right-hand sides with the ladders: it solves them by SciPy's DOP853 to
1e-12, with no closed form and at instants of its own.
"""

import math
import random
import time
from collections import Counter
from itertools import pairwise
from types import SimpleNamespace

import mpmath
import numpy as np
import pytest
import sympy
from scipy.integrate import solve_ivp

from newton_euler import Model, integrate, moving, prepare, smallest
from newton_euler.kinematics import euler_matrix, matrix_from_quaternion, quaternion_from_euler
from newton_euler.motion import ModelError, Neglected, second_order
from newton_euler.scenes import LADDERS, Ladder, Rung, ladder, ladders
from newton_euler.scenes.particles import orbit
from newton_euler.scenes.spatial import free_body, spherical_pendulum, top_ladder
from tests.kinds import rates
from tests.newton_euler.scenes.draws import DRAWS, FREEDOM

BORDER = 1.001
each_ladder = pytest.mark.parametrize("name", DRAWS)
JUDGED = (np.arange(700) + math.sqrt(0.5)) / (699 + math.sqrt(0.5))  # fractions of the time


def predicted(rung, t, start=None):
    """The prediction of the rung at the instants of the judge, an array (parts, instants)."""
    rhs, model = rung.model.compiled_rhs(), rung.model
    start = np.array(rung.start if start is None else start, dtype=float)
    atol = 1e-13 * max(1.0, *abs(start))
    run = solve_ivp(lambda t, y: rhs(t, *y.tolist()), (0, t), start, "DOP853", JUDGED * t, rtol=1e-12, atol=atol)  # fmt: skip
    states = SimpleNamespace(**dict(zip(model.states, run.y, strict=True)))
    seen = rung.observed(states, SimpleNamespace(**model.parameters), run.t)
    return np.array([x + 0 * run.t for x in seen])


def true_errors(asked, rungs):
    """{name: true error}; infinite where the equations cannot be followed."""
    full, out = predicted(asked.rungs[-1], asked.t), {}
    for rung in rungs:
        try:
            out[rung.name] = np.linalg.norm(predicted(rung, asked.t) - full, axis=0).max()
        except (ZeroDivisionError, ValueError):
            out[rung.name] = math.inf
    return out


def judged(name, count, seed):
    """For ``count`` draws: the chosen rung, whether it is right, and rungs beyond their bound."""
    r = random.Random(f"{name} {seed}")
    for _ in range(count):
        asked, tolerance = DRAWS[name](r)
        choice = smallest(asked, tolerance)
        upto = asked.rungs[: [rung.name for rung in asked.rungs].index(choice.rung.name) + 1]
        errors = true_errors(asked, upto)
        *cheaper, taken = errors.values()
        right = taken <= BORDER * tolerance and all(BORDER * error > tolerance for error in cheaper)
        noise = 1e-9 * tolerance + 1e-11 * max(map(abs, asked.rungs[-1].start))
        bound = lambda rung, t=asked.t, noise=noise: rung.bound(t) * (1 + 1e-9) + noise
        low = [rung.name for rung in upto if errors[rung.name] > bound(rung)]
        yield choice.rung.name, right, low, (asked, tolerance, errors)


def faults(name, count, seed):
    """Draws with a wrong choice, if more than one in a hundred, and rungs beyond their bound."""
    found = list(judged(name, count, seed))
    wrong = [what for _, right, _, what in found if not right]
    low = [low for _, _, low, _ in found if low]
    return (wrong if len(wrong) > count // 100 else []) + low


@pytest.mark.one_in(3)
@pytest.mark.parametrize(("count", "seed"), [(24, "quick"), pytest.param(320, "many", marks=pytest.mark.slow)])  # fmt: skip
@each_ladder
def test_the_choice_is_the_cheapest_rung_that_holds_and_bounds_are_bounds(name, count, seed):
    assert faults(name, count, seed) == []


def test_bounds_of_a_physical_pendulum_are_not_wild_guesses():
    """Half of the bounds lie within a factor of ten of the error."""
    r, near = random.Random("physical pendulum bounds"), []
    for _ in range(30):
        asked, _ = DRAWS["physical pendulum"](r)
        known = [rung for rung in asked.rungs[:-1] if rung.bound(asked.t) < math.inf]
        errors = true_errors(asked, known).values()
        near += [rung.bound(asked.t) < 10 * e for rung, e in zip(known, errors, strict=True)]
    assert sum(near) > len(near) / 2


@pytest.mark.one_in(3)
@each_ladder
def test_every_rung_is_the_right_choice_now_and_then(name):
    r, chosen = random.Random(f"{name} every"), Counter()
    wanted = set(FREEDOM[name])
    for _ in range(400):
        chosen[smallest(*DRAWS[name](r)).rung.name] += 1
        if wanted <= set(chosen):
            break
    assert wanted - set(chosen) == set(), chosen


EXACT = [(name, rung.name) for name in LADDERS for rung in ladder(name).rungs if rung.model.exact]
COMPARE = {"pendulum, a particle", "physical pendulum", "satellite, ellipse", "free body"}


@pytest.mark.parametrize(("name", "rung"), [pair for pair in EXACT if pair[1] not in COMPARE])
def test_closed_forms_solve_their_equations_to_25_digits(name, rung):
    """Differentiated by the product rule; forms that compare numbers: tested with their scenes."""
    r = random.Random(5)
    draws = [ladder(name), *(DRAWS[name](r)[0] for _ in range(5))]
    rungs = [asked.rung(rung) for asked in draws if rung in {x.name for x in asked.rungs}]
    assert max(map(off, rungs)) < 1e-25


def off(rung):
    """The error of the start, and of the rates at 3/4 s, relative to the size of the solution."""
    t = mpmath.mpf(3) / 4
    with mpmath.workdps(40):
        start = [mpmath.mpf(x) for x in rung.start]
        numbers = {n: mpmath.mpf(x) for n, x in rung.model.parameters.items() if x}
        model = rung.model.changed(**numbers)
        state, first = model.solution(t, start), model.solution(0 * t, start)
        found = rates(lambda t: model.solution(t, start), t)
        expected = zip((*found, *first), (*model.derivative(state, t), *start), strict=True)
        size = 1 + max(float(abs(x)) for x in (*state, *found))
        return max(float(abs(a - b)) for a, b in expected) / size


@pytest.mark.parametrize("I_z", [0.5, 0.999999, 1.0, 1.000001, 1.1, 1.2, 1.5])
def test_small_wobble_is_right_on_both_sides_of_the_intermediate_axis(I_z):
    """Checked against the exponential of the matrix, to 30 digits."""
    model = free_body.small_wobble(1.0, 1.2, I_z, 3.0)
    with mpmath.workdps(30):
        columns = [[mpmath.mpf(x) for x in model.derivative(unit)] for unit in ((1, 0), (0, 1))]
        moved = mpmath.expm(2 * mpmath.matrix(columns).T) * mpmath.matrix([0.1, -0.2])
    assert model.solution(2.0, (0.1, -0.2)) == pytest.approx([float(x) for x in moved], rel=1e-12)


@pytest.mark.parametrize(("model", "start"), [
    (top_ladder.asymmetric_top_quaternion, (0.9, 0.3, 0.1, 0.2, 1.0, 2.0, 30.0)),
    (top_ladder.asymmetric_top_euler_angles, (0.2, 0.6, 0.1, 1.0, 2.0, 30.0)),
])  # fmt: skip
def test_the_fullest_top_keeps_its_energy_and_its_momentum_about_the_vertical(model, start):
    """And is the symmetric one where it has no asymmetry."""
    asked = ladder("top", asymmetry=0.0)
    assert asked.error(asked.rung("top, nutation and precession")) < 1e-9
    mgr, moments = 0.5, np.array([0.02 * 0.7, 0.02 * 1.3, 0.01])
    rates = model(0.02, 0.01, mgr, asymmetry=0.3).derivative(start)
    *attitude, w_x, w_y, w_z = (moving(x, rate) for x, rate in zip(start, rates, strict=True))
    turned = matrix_from_quaternion(attitude) if len(attitude) == 4 else euler_matrix(*attitude)
    w, up = np.array([w_x, w_y, w_z]), np.array(turned[2])
    assert abs((moments * w @ w / 2 + mgr * up[2]).rate) < 1e-12
    assert abs((moments * w @ up).rate) < 1e-12


def test_the_pull_of_an_oblate_earth_is_that_of_its_potential():
    """V = -mu/r (1 - J2 (R/r)^2 (3 sin^2(latitude) - 1)/2), at the equator; it holds a circle at
    the rate with r rate^2 = dV/dr.
    """
    with mpmath.workdps(40):
        mu, J2R2, r, none = map(mpmath.mpf, ("8", "0.1", "2", "0"))
        pull = mpmath.diff(lambda r: -mu / r * (1 + J2R2 / (2 * r * r)), r)
        found = orbit.over_equator(mu, J2R2, none).derivative((r, none, none))[1]
        assert abs(found + pull) < mpmath.mpf(10) ** -25
        rate = mpmath.sqrt(pull / r)
        circling = orbit.over_equator(mu, J2R2, r * r * rate).derivative((r, none, none))
        assert max(map(abs, np.subtract(circling, (0, 0, rate)))) < mpmath.mpf(10) ** -25


@pytest.mark.parametrize("latitude", [0.3, -1.2, math.pi / 2])
def test_foucaults_pendulum_turns_with_the_sine_of_the_latitude(latitude):
    """It turns by -rate sin(latitude) t, in the fullest model too."""
    given = {"length": 9.81, "start": (0.0, 0.0, 1e-3, 0.0), "t": 2.25 * 2 * math.pi}
    asked = ladder("Foucault's pendulum", latitude=latitude, rate=1e-3, **given)
    for rung in (asked.rungs[1], asked.fullest):
        x, y = asked.observe(rung, 1e-12)[:, -1]
        assert math.atan2(y, x) == pytest.approx(-1e-3 * math.sin(latitude) * asked.t, rel=1e-3)


def test_a_bar_swings_as_the_spherical_pendulum_of_the_top():
    """Without friction; compared with the quaternion of the bar, which hangs at theta = pi."""
    length, g, t = 1.2, 9.81, 3.0
    asked = ladder("spherical pendulum", length=length, g=g, start=(0.5, 0.0, 0.0, 1.0), t=t)
    q = quaternion_from_euler(math.pi / 2, math.pi - math.asin(0.5 / length), 0.0)
    bar = spherical_pendulum.pendulum(1.0, length, g)
    end = integrate(bar, t, (*q, 0.0, 1.0 / length), 1e-12).end
    turned = matrix_from_quaternion([end[n] for n in ("q0", "q1", "q2", "q3")])
    found = asked.observe(asked.rung("bar, any swing"), 1e-12)[:, -1]
    assert found == pytest.approx([length * row[2] for row in turned[:2]], abs=1e-10)


@each_ladder
def test_the_state_of_each_model_has_the_degrees_of_freedom_of_its_scene(name):
    assert set(DRAWS) == set(FREEDOM) == set(LADDERS)
    found = {rung.name: len(rung.model.states) for rung in ladder(name).rungs}
    assert found == {n: 2 * freedom - left_out + spare for n, (freedom, left_out, spare) in FREEDOM[name].items()}  # fmt: skip


@pytest.mark.one_in(3)
@each_ladder
def test_no_state_is_superfluous(name):
    """A prediction shows as many directions of the start as it has states, less the spare ones."""
    asked = ladder(name)
    for rung in asked.rungs:
        seen = np.array([column(rung, asked.t / 3, n) for n in range(len(rung.start))])
        visible = (np.linalg.svd(seen, compute_uv=False) > 1e-6).sum()
        assert visible == len(rung.model.states) - FREEDOM[name][rung.name][2], rung.name


def column(rung, t, n):
    """How the prediction depends on one number of the start, scaled to length 1."""
    start = np.array(rung.start, dtype=float)
    step = np.zeros(len(start))
    step[n] = 1e-4 * max(abs(start[n]), 1e-2 * abs(start).max() or 1.0)
    apart = (predicted(rung, t, start + step) - predicted(rung, t, start - step)).ravel()
    length = np.linalg.norm(apart)
    return apart / length if length > 1e-9 * abs(step).max() else 0 * apart


@pytest.mark.benchmark
@pytest.mark.parametrize("name", LADDERS)
def test_no_rung_costs_more_than_the_next(name):
    """No rung takes a third more processor time: some differ by only a few operations."""
    asked = ladder(name)
    runs = [(prepare(rung.model), rung.start, []) for rung in asked.rungs]
    for run, start, costs in 30 * runs:
        begun, count = time.process_time(), 0
        while time.process_time() < begun + 3e-4:
            run(asked.t, start)
            count += 1
        costs.append((time.process_time() - begun) / count)
    costs = [min(costs) for _, _, costs in runs]
    assert all(a < 1.33 * b for a, b in pairwise(costs)), costs
    assert costs[0] < 0.7 * costs[-1]


def oscillator(name="oscillator", k=4.0, neglects=()):
    return second_order(name, {"k": k}, ("x",), lambda s, p, t: (-p.k * s.x,), neglects=neglects)


def place(s, p, t):
    return (s.x,)


def by(bound, of="position, m"):
    return Neglected("drag", bound, of)


def hand_made(*models, t=2.0):
    rungs = tuple(Rung(m, (1.0, 0.0), place) for m in models)
    return Ladder("oscillators", "position, m", t, rungs)


def test_a_small_bound_accepts_without_any_motion(monkeypatch):
    asked = hand_made(oscillator("a", neglects=[by(lambda s, p, t: s.x * t)]), oscillator("b"))
    monkeypatch.setattr(Ladder, "observed", lambda *given: pytest.fail("it was integrated"))
    choice = smallest(asked, 2.5)
    assert choice.evidence == {"a": ladders.Evidence(2.0, None)}
    assert str(choice) == "for position, m, within 2.5:\ntakes a: off by at most 2\nit leaves out drag"  # fmt: skip


def test_a_large_bound_is_measured():
    large = [by(lambda s, p, t: t)]
    rough = oscillator("a", 4.0, large), oscillator("b", 4.001, large)
    asked = hand_made(*rough, oscillator("c", 4.01))
    true = np.abs(np.cos(2 * JUDGED * 2) - np.cos(math.sqrt(4.01) * JUDGED * 2)).max()
    assert asked.error(asked.rung("a")) == pytest.approx(true, rel=1e-3)
    assert [smallest(asked, x * true).model.name for x in (1.01, 0.99, 0.5)] == ["a", "b", "c"]
    evidence = smallest(asked, 0.5 * true).evidence
    assert list(evidence) == ["a", "b", "c"]
    assert evidence["c"] == ladders.Evidence(0.0, None)


def test_what_has_no_bound_or_cannot_be_followed_does_not_hold():
    rung = Rung(oscillator(neglects=[by(lambda s, p, t: t), by(None)]), (1.0, 0.0), place)
    assert list(rung.model.neglected(2.0, (1.0, 0.0)).values()) == [2.0, math.inf]
    assert rung.bound(2.0) == math.inf
    runs_away = Model("runs away", {}, ("x", "v"), lambda s, p, t: (s.x * s.x, s.v))
    asked = hand_made(runs_away, oscillator())
    assert asked.error(asked.rungs[0]) == math.inf
    assert smallest(asked, 100.0).model.name == "oscillator"
    assert "no bound is known, by inf from the fullest" in str(smallest(asked, 100.0))


def test_errors_are_measured_as_well_as_asked_for_and_for_each_rung_itself():
    asked = hand_made(oscillator("a"), oscillator("b", 4.0 + 1e-10))
    # d cos(k^1/2 t)
    true = 1e-10 / 4 * max(abs(t * math.sin(2 * t)) for t in np.linspace(0, 2, 5001))
    rough, fine = asked.error(asked.rungs[0], 1.0), asked.error(asked.rungs[0])
    assert rough < 1e-8
    assert fine == pytest.approx(true, rel=0.02)
    assert asked.error(asked.rungs[0], 1.0) == fine  # an error known well is not measured again
    asked = hand_made(oscillator("a", 4.1), oscillator("b"))
    other = Rung(oscillator("a", 4.5), (1.0, 0.0), place)
    assert asked.error(other) > 3 * asked.error(asked.rungs[0])


FIRST = oscillator("a", neglects=[by(lambda s, p, t: t)])
LAST = oscillator("b", neglects=[by(lambda s, p, t: 0.1 * t)])
ENERGY = oscillator(neglects=[by(lambda s, p, t: t, "energy")])


def test_an_effect_that_the_fullest_model_neglects_counts_for_all():
    """Of two equal models each is as good as the other, and both only as good as the last bound."""
    assert smallest(hand_made(FIRST, LAST), 0.21).model.name == "a"


@pytest.mark.parametrize(("ask", "words"), [
    (lambda: hand_made(FIRST).rungs[0].bound(sympy.Symbol("t")), "bounds of 'a' need numbers"),
    (lambda: hand_made(ENERGY), "of different quantities: position, m; energy"),
    (lambda: hand_made(FIRST, FIRST), r"the rungs of 'oscillators' need names of their own, got \['a', 'a'\]"),
    (hand_made, r"got \[\]"),
    (lambda: smallest(hand_made(FIRST, LAST), 0.19), r"no model is as accurate as 0\.19; the errors may reach a: 2, b: 0\.2"),
    (lambda: smallest(hand_made(FIRST), 0), "the tolerance is a positive number, position, m; got 0"),
    (lambda: hand_made(FIRST, LAST).rung("c"), "oscillators has no rung 'c'; it has a, b"),
    (lambda: ladder("cart"), "there is no ladder 'cart'; there are satellite, .*, projectile, "),
])  # fmt: skip
def test_what_a_ladder_and_a_question_must_be(ask, words):
    with pytest.raises(ModelError, match=words):
        ask()

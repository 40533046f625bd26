"""Scenes of the book, integrated: orders of convergence, honest errors, events and switches, many at
once.
"""

import math
import statistics

import mpmath
import numpy as np
import pytest

from newton_euler.chapters.examples.ch08 import rolling_begins, sphere_at
from newton_euler.motion import ModelError
from newton_euler.motion.events import Event
from newton_euler.motion.integration import integrate
from newton_euler.motion.methods.table import METHODS
from newton_euler.motion.prepared import prepared_model
from newton_euler.motion.solution import AccuracyError, MotionError
from newton_euler.scenes.particles.space_station import free_body as station_body
from newton_euler.scenes.planar.pendulum import physical_pendulum
from newton_euler.scenes.planar.sliding_sphere import rolling, sliding
from newton_euler.scenes.spatial import top
from tests.models import forced, oscillator
from tests.motions import SCENES, SPIN, reference, top_start, true_error

ADAPTIVE = ("taylor", "dop853", "scipy DOP853", "scipy RK45", "scipy LSODA")
TOLERANCES = tuple(10.0**-n for n in range(3, 13))


def swing(**more):
    return integrate(physical_pendulum(2.0, 0.5, 0.5, 10.0), 10.0, (1.0, 0.0), **more)


def needs(method):
    if method == "taylor":
        pytest.importorskip("heyoka")


@pytest.mark.parametrize("method", ["scipy RK45", "verlet", "yoshida4", "yoshida6", "yoshida8"])
def test_methods_converge_with_their_order(method):
    """The slope of log error over log step, on a pendulum in its closed form to 30 digits."""
    order = METHODS[method].order
    first = {"verlet": 0.1, "yoshida4": 0.05, "scipy RK45": 0.1, "yoshida6": 0.12, "yoshida8": 0.06}
    steps = [first[method] / 1.5**k for k in range(4)]
    exact = reference_of_the_pendulum()
    errors = [abs(swing(method=method, step=h).end["theta"] - exact) for h in steps]
    assert slope(steps, errors) == pytest.approx(order, abs=0.45), errors


def slope(steps, errors):
    return np.polyfit(np.log(steps), np.log(errors), 1)[0]


def reference_of_the_pendulum(t=10.0, amplitude=1.0):
    """By Jacobi's elliptic functions: sin(theta/2) = k cd(w t)."""
    with mpmath.workdps(30):
        w = mpmath.sqrt(2 * 10 * mpmath.mpf("0.5") / (mpmath.mpf("0.5") + 2 * mpmath.mpf("0.25")))
        k = mpmath.sin(mpmath.mpf(amplitude) / 2)
        return float(2 * mpmath.asin(k * mpmath.ellipfun("cd", w * t, m=k * k)))


def test_the_references_of_these_tests_agree_with_another_program():
    """mpmath's own Taylor series, 25 digits, and the closed form of the pendulum."""
    pytest.importorskip("heyoka")
    assert abs(reference("pendulum")[0] - reference_of_the_pendulum()) < 1e-15
    model, _, start = SCENES["free body, calm"]
    with mpmath.workdps(25):
        motion = mpmath.odefun(
            lambda t, y: list(model.derivative(y)),
            0,
            [mpmath.mpf(x) for x in start],
            tol=mpmath.mpf("1e-20"),
        )
        found = [float(x) for x in motion(2)]
    ours = integrate(model, 2.0, start, 1e-12)
    assert max(abs(a - b) for a, b in zip(found, ours.end.values(), strict=True)) < 1e-12


@pytest.mark.parametrize("method", ["exact", *ADAPTIVE])
def test_agreement_with_an_exact_solution(method):
    needs(method)
    model, start = station_body(0.5), (2.0, 0.0, 1.0, 1.0)
    rtol = 1e-8 if method == "scipy LSODA" else 1e-9
    motion = integrate(model, 20.0, start, rtol, method)
    for name, x in zip(model.states, model.solution(20.0, start), strict=True):
        assert abs(motion.end[name] - x) <= rtol * max(abs(motion.states[name]))


def honesty(method, scenes, tolerances):
    """True error over the error asked for, and over the one reported."""
    asked, reported = [], []
    for scene in scenes:
        model, t, start = SCENES[scene]
        for rtol in tolerances:
            if rtol < METHODS[method].min_rtol or METHODS[method].unusable_because(_system(model)):
                continue
            motion = integrate(model, t, start, rtol, method)
            error = true_error(scene, motion)
            asked.append(error / rtol)
            reported.append(error / motion.error)
    return asked, reported


def _system(model):
    from newton_euler.motion.prepared import PreparedModel

    return PreparedModel(model)


def within(ratios):
    return sum(x <= 1 for x in ratios) / len(ratios)


@pytest.mark.parametrize("method", ["dop853", "taylor"])
def test_errors_are_what_was_asked_for(method):
    """In the median a heyoka run is more accurate: its error falls by steps, and its cost hardly
    depends on it.
    """
    pytest.importorskip("heyoka")
    scenes = ("top", "free body", "pendulum", "turning shaft", "planet", "forced", "aircraft")
    asked, reported = honesty(method, scenes, (1e-3, 1e-5, 1e-7, 1e-9, 1e-11))
    assert within(asked) == 1
    assert within(reported) >= 0.97
    assert statistics.median(asked) >= (3e-3 if method == "dop853" else 1e-4)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("method", "least"),
    [("taylor", 1e-4), ("dop853", 1e-3), ("scipy DOP853", 1e-3), ("scipy RK45", 1e-3), ("scipy LSODA", 1e-3), ("scipy Radau", 1e-4),
     ("yoshida4", 1e-3), ("yoshida6", 1e-4), ("yoshida8", 1e-4), ("lie-poisson4", 1e-3), ("lie-poisson6", 1e-4)],
)  # fmt: skip
def test_errors_are_what_was_asked_for_everywhere(method, least):
    pytest.importorskip("heyoka")
    tolerances = [x for x in TOLERANCES if method != "scipy Radau" or x >= 1e-8]
    asked, reported = honesty(method, SCENES, tolerances)
    print(
        f"\n{method}: {len(asked)} runs, within {within(asked):.3f}, median "
        f"{statistics.median(asked):.2g}, reported {within(reported):.3f}"
    )
    assert within(asked) >= 0.95
    assert statistics.median(asked) >= least


def test_an_error_that_cannot_be_reached_is_refused_with_what_can():
    """Swinging over the top, the last digits of a float are not enough for 1e-13."""
    model, t, start = SCENES["pendulum, over the top"]
    with pytest.raises(
        AccuracyError, match="and rtol = 1e-13 was requested; ask for rtol"
    ) as refused:
        integrate(model, 3 * t, start, 1e-13, "dop853")
    reached = refused.value.reached
    assert reached.error > 1e-13
    assert "not reached" in str(reached)
    could = float(str(refused.value).split("ask for rtol = ")[1].split(".")[0])
    assert reached.error < could < 20 * reached.error
    assert integrate(model, 3 * t, start, could, "dop853").error <= could


def test_samples_are_where_they_were_asked_for():
    motion = integrate(oscillator(), (1.0, 3.0), (1.0, 0.0), samples=[1.0, 1.5, 3.0])
    assert motion.times.tolist() == [1.0, 1.5, 3.0]
    assert motion.states["x"] == pytest.approx([1.0, math.cos(1.0), math.cos(4.0)], abs=1e-12)
    assert len(swing(samples=7).states["theta"]) == 7


def test_the_grid_of_heyoka_is_the_same_motion():
    pytest.importorskip("heyoka")
    grid, dense = (
        swing(method="taylor", samples=50),
        swing(method="taylor").at(np.linspace(0, 10, 50)),
    )
    assert max(abs(grid.states["theta"] - dense["theta"])) < 1e-10


def test_the_record_tells_what_it_cost_and_how_it_ended():
    motion = swing(method="dop853")
    assert motion.cost.calls > 100
    assert motion.ended == "reached t = 10"
    text = motion.explain()
    for words in (
        "physical pendulum",
        "method: ",
        "error of the last state",
        "drift of energy",
        "calls of the right-hand side",
    ):
        assert words in text


def test_the_cost_of_preparing_is_the_time_until_the_first_run(monkeypatch):
    clock = iter([10.0, 10.5])
    monkeypatch.setattr("newton_euler.motion.integration.perf_counter", lambda: next(clock))
    assert swing().cost.preparing == 0.5


@pytest.mark.parametrize("method", ["auto", *ADAPTIVE])
def test_a_sphere_slides_and_then_rolls(method):
    needs(method)
    begins = Event(
        lambda s, p, t: s.v + s.omega * p.r,
        then=lambda s, p, t: (rolling(p.r), (s.x, s.v, s.omega)),
        name="rolling begins",
    )
    motion = integrate(sliding(0.2, 10.0, 0.5), 3.0, (0.0, 7.0, 0.0), 1e-8, method, begins)
    exact = rolling_begins(7.0, 0.2, 10.0, 0.5)
    assert motion.events[0].t == pytest.approx(exact.t, abs=1e-12)
    assert [len(segment.stepper.step_times) < 60 for segment in motion.segments] == [True, True]
    assert motion.end["x"] == pytest.approx(sphere_at(3.0, 7.0, 0.2, 10.0, 0.5)[0], abs=1e-11)
    assert motion.at(0.5)["x"] == pytest.approx(sphere_at(0.5, 7.0, 0.2, 10.0, 0.5)[0], abs=1e-9)


@pytest.mark.parametrize("method", ["dop853", "taylor", "scipy DOP853", "yoshida6"])
def test_a_pendulum_turns_where_it_should(method):
    needs(method)
    motion = swing(method=method, events=Event(lambda s, p, t: s.omega, name="turns"))
    assert len(motion.events) == 9
    for event in motion.events:
        assert abs(event.state["theta"]) == pytest.approx(1.0, abs=2e-9)
        assert abs(event.state["theta"] - reference_of_the_pendulum(event.t)) < 1e-8
    down = swing(method=method, events=Event(lambda s, p, t: s.omega, 1, terminal=True))
    assert down.t_end == pytest.approx(motion.events[0].t, abs=1e-9)
    assert down.ended.startswith("event 1 at t = ")


def test_an_event_may_branch_on_values():
    motion = swing(events=Event(lambda s, p, t: s.omega if t > 2 else 1.0, name="turns, later"))
    assert motion.events[0].t > 2


def test_events_may_come_one_after_the_other():
    turns = Event(lambda s, p, t: s.omega, terminal=True, name="turns")
    for events in (turns, [turns], (e for e in [turns])):
        assert swing(events=events).ended.startswith("turns at t = ")


@pytest.mark.parametrize("method", ["taylor", "dop853"])
def test_many_tops_are_what_each_is(method):
    needs(method)
    spins = np.linspace(6.0, 9.0, 5)
    motions = integrate(
        top.nonspinning_frame(1.0, 1.5, 5.0, spins), 3.0, top_start(0.6), 1e-9, method, samples=4
    )
    assert len(motions) == 5
    for n, spin in enumerate(spins.tolist()):
        one = integrate(
            top.nonspinning_frame(1.0, 1.5, 5.0, spin),
            3.0,
            top_start(0.6),
            1e-10,
            "dop853",
            samples=4,
        )
        for name in one.states:
            assert max(abs(motions.states[name][n] - one.states[name])) < 2e-9


def test_a_parameter_without_a_number_is_named():
    import sympy

    with pytest.raises(ModelError, match="the parameter m of 'physical pendulum' has no number"):
        integrate(physical_pendulum(sympy.Symbol("m"), 0.5, 0.5, 10.0), 1.0, (1.0, 0.0))


def test_a_symbol_of_symengine_is_no_number():
    m = pytest.importorskip("symengine").Symbol("m")
    with pytest.raises(ModelError, match="the parameter m of 'physical pendulum' has no number"):
        integrate(physical_pendulum(m, 0.5, 0.5, 10.0), 1.0, (1.0, 0.0))
    with pytest.raises(ModelError, match="needs a number for omega, got m"):
        integrate(physical_pendulum(2.0, 0.5, 0.5, 10.0), 1.0, (1.0, m))


def test_heyoka_that_is_missing_is_said(monkeypatch):
    monkeypatch.setattr("newton_euler.motion.methods.table.installed", lambda: False)
    with pytest.raises(
        ModelError, match=r"heyoka is not installed: pip install 'newton-euler\[fast\]'"
    ):
        swing(method="taylor")
    with pytest.raises(
        ModelError, match="needs heyoka, without which the least is 1e-13; heyoka is not installed"
    ):
        integrate(forced(), 1.0, (1.0, 0.0), 1e-14)


@pytest.mark.parametrize("scene", SCENES)
def test_what_parameters_alone_give_is_computed_once(scene):
    """The rest has other arguments than the parameters, fewer operations, and the same rates within
    round-off.
    """
    model, _, start = SCENES[scene]
    system = prepared_model(model)
    rest, _ = system.traced.folded
    states = [x + 0.01 * n for n, x in enumerate(start, 1)]
    whole, rates = system.rates(0.3, states), system.folded_rates(0.3, *states, *system.constants)
    scale = max(map(abs, whole))
    assert max(abs(a - b) for a, b in zip(whole, rates, strict=True)) <= 4e-15 * scale
    count = lambda source: sum(source.count(f" {op} ") for op in "*/+-")
    assert count(rest.source) <= count(system.traced.rhs.source)
    arguments = rest.source.split("(", 1)[1].split(")")[0].split(", ")
    assert not set(arguments) & set(model.parameters)


@pytest.mark.parametrize("method", ["dop853", "taylor", "scipy RK45"])
def test_euler_angles_of_an_upright_top_are_refused_at_their_singular_place(method):
    needs(method)
    with pytest.raises(MotionError, match="t = 0, at psi = 0, theta = 0"):
        integrate(top.euler(1.0, 1.5, 5.0, SPIN), 1.0, (0.0,) * 5, method=method, rtol=1e-6)

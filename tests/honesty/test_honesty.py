"""Tests of the harness itself, and the promises of the engine."""

import csv
import importlib.util
import math
import os
import subprocess
import sys
import threading
import time
from dataclasses import replace
from itertools import pairwise
from pathlib import Path
from random import Random
from types import SimpleNamespace

import pytest

import tests.honesty.families
import tests.honesty.holdout  # noqa: F401
from newton_euler import prepare
from newton_euler.accuracy.measurements.reference import by_extrapolation
from newton_euler.motion import ModelError
from tests.honesty import closed_forms, judge, references, report
from tests.honesty.cases import DRAWS, FAMILIES, HOLDOUT, draw, names
from tests.honesty.references import NoReferenceError, reference
from tests.honesty.workers import Plan, results

pytest.importorskip("mpmath")
ROOT = Path(__file__).parents[2]
SUBJECTS = {
    "smooth",
    "kinked",
    "stiff",
    "multi-scale",
    "chaotic",
    "singular",
    "near-singular",
    "long",
    "forced",
    "events",
    "tiny",
    "units",
    "batch",
    "mechanics",
}


@pytest.fixture(scope="session")
def cache(tmp_path_factory):
    return tmp_path_factory.mktemp("references")


def judged(case, truth, method="auto", way="", rtol=1e-6, **engine):
    return judge.judged(case, {0: truth}, method, way, rtol, **engine)


def known(name, cache, seed=0, number=0):
    """A case and its reference."""
    case = draw(name, seed, number)
    return case, reference(case, cache)


# -- the families


def test_there_are_at_least_48_families_of_every_subject():
    assert len(FAMILIES) >= 48
    assert {tag for f in FAMILIES.values() for tag in f.tags} >= SUBJECTS
    assert all(f.__doc__ for f in FAMILIES.values())


def numbers(x):
    return tuple(x.tolist()) if getattr(x, "shape", ()) else x


@pytest.mark.parametrize("name", [*FAMILIES, *HOLDOUT])
def test_a_family_draws_the_same_for_the_same_seed_and_others_for_another(name):
    def described(case):
        model = case.written_out or case.model
        parameters = {n: numbers(x) for n, x in model.parameters.items()}
        return (
            model.compiled_rhs(*parameters).source,
            parameters,
            tuple(map(numbers, case.start)),
            case.t0,
            case.t_end,
        )

    first = [described(draw(name, 0, k)) for k in range(DRAWS)]
    assert described(draw(name, 0, 1)) == first[1]
    assert described(draw(name, 1, 1)) not in first
    assert all(first[i] != first[j] for i in range(DRAWS) for j in range(i))


@pytest.mark.parametrize("name", [*FAMILIES, *HOLDOUT])
def test_every_draw_has_a_start_with_finite_rates_and_a_positive_time(name):
    for k in range(DRAWS):
        case = draw(name, 0, k)
        for member in judge.members(case):
            one = case.member(member)
            assert one.t_end > one.t0
            assert all(map(math.isfinite, one.model.derivative(one.start, one.t0)))
            assert list(one.times) == sorted(one.times)


@pytest.mark.parametrize("name", [n for n in FAMILIES if draw(n, 0, 0).branches])
def test_the_pieces_of_a_kinked_model_are_its_rates(name):
    case, chance = draw(name, 0, 0).member(0), Random(name)
    p = names(case.model.parameters, case.model.parameters.values())
    met = set()
    for _ in range(60):
        size, t = 10 ** chance.uniform(-2, 0.3), chance.uniform(case.t0, case.t_end)
        x = tuple((abs(a) + 1.0) * size * chance.uniform(-1, 1) for a in case.start)
        # whose level is never negative
        x = tuple(map(abs, x)) if name == "tank_with_an_overflow" else x
        s = names(case.model.states, x)
        signs = tuple(1 if g(s, p, t) > 0 else -1 for g in case.branches.switches)
        assert case.branches.rates(s, p, t, signs) == pytest.approx(
            case.model.derivative(x, t), rel=1e-12, abs=1e-12
        )
        met.add(signs)
    assert len(met) > len(case.branches.switches)


# -- the references


@pytest.mark.parametrize("name", [n for n in FAMILIES if draw(n, 0, 0).exact])
def test_a_closed_form_has_the_rates_of_its_model(name, cache):
    truth = reference(draw(name, 0, 0).member(0), cache)
    assert truth.agreement < 1e-18


def test_a_wrong_closed_form_is_no_reference():
    case = draw("pendulum", 0, 0)
    wrong = replace(
        case,
        exact=lambda mp, s, p, t: closed_forms.pendulum(
            mp, p.k * (1 + mp.mpf(10) ** -14), s.theta, s.omega, t
        ),
    )
    with pytest.raises(NoReferenceError, match="differ by"):
        reference(wrong)


@pytest.mark.parametrize("name", ["pendulum", "free_body", "planet_in_any_units"])
def test_series_and_extrapolation_end_where_the_closed_form_does(name):
    pytest.importorskip("heyoka")
    case = draw(name, 0, 0)
    case = replace(case, t_end=case.t_end / 8)
    exact, other = reference(case), reference(replace(case, exact=None))
    assert exact.ways[0] == "closed form"
    assert other.ways == ("Taylor series, 42 digits", "extrapolation, 22 digits")
    assert (
        judge.true_error(
            [float(x) for x in other.states[-1]], exact.states[-1], exact.sizes, exact.natural
        )
        < 2e-16
    )
    assert all(
        abs(float(a) - float(b)) <= 1e-28 * abs(float(a))
        for a, b in zip(exact.states[-1], other.states[-1], strict=True)
    )
    assert other.condition == pytest.approx(exact.condition, rel=0.05)
    assert other.sizes == pytest.approx(exact.sizes, rel=0.1)


def test_the_extrapolation_of_the_accuracy_charts_agrees(cache):
    case, truth = known("duffing", cache)
    ended = by_extrapolation(case.model, case.t_end, case.start, digits=18)
    assert [float(x) for x in ended] == pytest.approx(
        [float(x) for x in truth.states[-1]], rel=1e-15
    )


def test_friction_is_followed_from_kink_to_kink(cache):
    """Each swing ends nearer to the middle by 2 mu/k, so there is a closed form after n of them."""
    case, truth = known("dry_friction", cache)
    k, mu, x = *case.model.parameters.values(), case.start[0]
    n = int(case.t_end * math.sqrt(k) / math.pi)
    # it moves to the left first, and friction pushes to the right
    centre = (mu if n % 2 == 0 else -mu) / k
    amplitude = x - (2 * n + 1) * mu / k
    end = centre + (-1) ** n * amplitude * math.cos(math.sqrt(k) * case.t_end - n * math.pi)
    assert float(truth.states[-1][0]) == pytest.approx(end, rel=1e-12)


def test_a_bouncing_ball_is_followed_through_its_impacts(cache):
    case, truth = known("bouncing_ball", cache)
    g, e, h = *case.model.parameters.values(), case.start[0]
    fall = math.sqrt(2 * h / g)
    exact = [fall * (1 + 2 * sum(e**n for n in range(1, k + 1))) for k in range(20)]
    assert [float(t) for _, t, _ in truth.events] == pytest.approx(
        [t for t in exact if t < case.t_end], rel=1e-14
    )


def test_zeros_of_a_function_that_is_faster_than_the_motion_are_all_found(cache):
    """Between two of 20 000 instants there is at most one."""
    pytest.importorskip("heyoka")
    case = replace(draw("beats_of_two_tones", 0, 0), t_end=3.0)
    truth = reference(case, cache)
    k, w = case.model.parameters.values()
    times = [case.t_end * n / 20_000 for n in range(20_001)]
    g = [math.cos(w * t) - math.cos(math.sqrt(k) * t) / 2 for t in times]
    assert len(truth.events) == sum(a * b < 0 for a, b in pairwise(g))


def test_a_pulse_that_one_way_steps_over_is_found_out():
    pytest.importorskip("heyoka")
    case = draw("narrow_pulse", 0, 0)
    with pytest.raises(NoReferenceError, match="differ by"):
        reference(replace(case, knots=()))


def test_what_is_not_reached_in_time_is_said_and_remembered(tmp_path):
    pytest.importorskip("heyoka")
    case = replace(draw("lorenz", 0, 0), t_end=1e5)
    for _ in range(2):
        begun = time.perf_counter()
        with pytest.raises(NoReferenceError, match=r"not reached in 0\.5 s"):
            reference(case, tmp_path, 0.5)
    assert time.perf_counter() - begun < 0.4
    assert len(list(tmp_path.iterdir())) == 1


def test_a_reference_is_kept_by_its_content(tmp_path):
    case = draw("damped_oscillator", 0, 0)
    first = reference(case, tmp_path)
    assert reference(replace(case, name="another"), tmp_path) == first
    assert len(list(tmp_path.iterdir())) == 1
    reference(replace(case, model=case.model.changed(c=0.0)), tmp_path)
    assert len(list(tmp_path.iterdir())) == 2


def test_a_rate_that_is_zero_has_the_size_that_its_coupling_gives_it(cache):
    pytest.importorskip("heyoka")  # without it a minute
    truth = reference(replace(draw("steady_precession", 0, 0), t_end=0.5), cache)
    nutation = truth.sizes[2], truth.natural[2]
    assert nutation[0] < 1e-12
    assert nutation[1] > 0.1


# -- the judge


def fake(case, truth, off, estimate, method="fake"):
    """An integrator that is off by so much of each state's size, and returns another estimate."""

    def states(at):
        known = references.scales(truth.sizes, truth.natural)
        return dict(
            zip(
                case.model.states,
                (float(x) + off * s for x, s in zip(at, known, strict=True)),
                strict=True,
            )
        )

    def run(model, t, start, rtol=1e-9, taken="auto", events=(), samples=None):
        rows = [states(x) for x in truth.states]
        table = {
            n: SimpleNamespace(tolist=lambda n=n: [row[n] for row in rows[:-1]])
            for n in model.states
        }
        end = states(truth.states[-1])
        return SimpleNamespace(
            error=estimate,
            end=end,
            t_end=case.t_end,
            events=(),
            method=SimpleNamespace(name=method),
            at=lambda times: table,
            states=table,
        )

    return run


@pytest.mark.parametrize(
    ("off", "estimate", "outcome", "covers", "silent"),
    [
        (1e-8, 1e-7, "met", True, False),
        (1e-8, 1e-9, "met", False, False),  # accurate enough, but the estimate is below the error
        (5e-6, 1e-7, "missed", False, False),
        (1e-4, 1e-12, "missed", False, True),  # silently wrong
        (1e-4, 1e-3, "missed", True, False),  # wrong, and the estimate says so
        (math.nan, 1e-12, "missed", False, True),
    ],
)
def test_an_estimate_below_the_true_error_is_caught(off, estimate, outcome, covers, silent, cache):
    case, truth = known("pendulum", cache)
    run = judged(case, truth, integrate=fake(case, truth, off, estimate))
    assert (run.outcome, run.covers, run.silent) == (outcome, covers, silent)
    assert run.error == pytest.approx(off, rel=1e-6) or math.isinf(run.error)
    assert run.inside == pytest.approx(off, rel=1e-6) or math.isinf(run.inside)


def test_a_prepared_run_and_a_batch_without_an_estimate_are_held_to_what_was_asked(cache):
    case, truth = known("pendulum", cache)
    true = tuple(float(x) for x in truth.states[-1])
    off = judged(
        case,
        truth,
        way="prepared",
        prepare=lambda *_: lambda t, start: tuple(x * (1 + 1e-4) for x in true),
    )
    assert (off.outcome, off.silent, off.covers) == ("missed", True, None)

    def batch(model, t, start, rtol, method):
        import numpy as np

        rows = np.array([[x] * len(start[0]) for x in true])
        rows[:, len(start[0]) // 2] *= 1 + 1e-4  # one among many
        states = dict(zip(model.states, rows[:, :, None], strict=True))
        return SimpleNamespace(states=states, error=None, method=SimpleNamespace(name="fake"))

    assert judged(case, truth, way="batch of 64", integrate=batch).silent


@pytest.mark.parametrize(
    ("raised", "outcome"),
    [
        (ModelError("cannot be had"), "refused"),
        (ZeroDivisionError("0/0"), "raw"),
        (KeyError("x"), "raw"),
    ],
)
def test_a_refusal_in_words_is_estimate_from_a_raw_error(raised, outcome, cache):
    case, truth = known("pendulum", cache)

    def run(*_, **__):
        raise raised

    found = judged(case, truth, integrate=run)
    assert (found.outcome, found.needless, found.returned) == (outcome, outcome == "refused", False)
    ill = replace(truth, condition=1e9)  # here it is right to refuse
    assert not judged(case, ill, integrate=run).needless


def test_a_call_that_does_not_end_is_a_timeout(cache):
    case, truth = known("pendulum", cache)
    run = judged(case, truth, seconds=0.05, integrate=lambda *_, **__: time.sleep(5))
    assert (run.outcome, run.returned) == ("timeout", False)


def test_an_answer_where_there_is_no_motion_is_silently_wrong(cache):
    case, truth = known("blow_up_on_the_way", cache)
    end = SimpleNamespace(
        error=1e-12,
        end={"x": 1.0},
        t_end=case.t_end,
        events=(),
        method=SimpleNamespace(name="fake"),
        at=lambda t: {},
    )
    assert judged(case, truth, integrate=lambda *_, **__: end).silent


def test_a_lost_event_is_an_error_unless_two_lie_too_close_to_tell(cache):
    case, truth = known("bouncing_ball", cache)
    found = [(n, float(t)) for n, t, _ in truth.events]
    assert judge.events_error(found, truth, 1e-9) < 1e-15
    assert judge.events_error(found[1:], truth, 1e-9) == math.inf
    late = [(n, t + 1e-5 * case.t_end) for n, t in found]
    assert 1e-6 < judge.events_error(late, truth, 1e-9) <= 1.0001e-5
    assert judge.events_error(found[1:], replace(truth, margin=1e-10), 1e-9) == 0.0


def test_no_state_is_judged_below_its_unit_or_below_what_its_coupling_makes_of_it():
    sizes, natural = (2.0, 1e-9, 0.0), (0.1, 1e-9, 4.0)
    true = ("1.0", "0.0", "0.0")
    assert judge.true_error((1.002, 0.0, 0.0), true, sizes, natural) == pytest.approx(1e-3)
    # of 1e-6 in its unit
    assert judge.true_error((1.0, 1e-9, 0.0), true, sizes, natural) == pytest.approx(1e-3)
    assert judge.true_error((1.0, 1e-9, 0.0), true, sizes, natural, unit=0.0) == pytest.approx(1.0)
    # of a thousandth of 4
    assert judge.true_error((1.0, 0.0, 4e-15), true, sizes, natural) == pytest.approx(1e-12)
    assert judge.true_error((1.0, math.inf, 0.0), true, sizes, natural) == math.inf


def test_an_answer_that_changes_is_noticed(cache):
    case, truth = known("pendulum", cache)
    good, bad = fake(case, truth, 0.0, 1e-12), fake(case, truth, 1e-4, 1e-12, "other")
    calls = []

    def moody(*args, **named):
        calls.append(1)
        return (bad if len(calls) > 5 else good)(*args, **named)

    (change,) = judge.repeated(
        case, truth, {1e-6: judge.answer(case, 1e-6, moody)}, calls=10, integrate=moody
    )
    assert (change.answers, change.calls, change.methods, change.gross) == (
        6,
        11,
        ("fake", "other"),
        True,
    )
    assert change.moved == pytest.approx(1e-4)
    (same,) = judge.repeated(
        case, truth, {1e-6: judge.answer(case, 1e-6, good)}, calls=10, integrate=good
    )
    assert (same.answers, same.gross) == (0, False)


def test_threads_that_share_a_state_are_noticed(cache):
    case, truth = known("pendulum", cache)
    shared = {}

    def shared_prepare(model, rtol):
        def run(t, start):
            shared["x"] = start
            time.sleep(1e-4)  # the other thread comes in between
            return shared["x"]

        return run

    own = threading.local()

    def own_prepare(model, rtol):
        def run(t, start):
            own.x = start
            time.sleep(1e-4)
            return own.x

        return run

    alone = fake(case, truth, 0.0, 1e-12)
    changes = judge.in_two_threads(case, truth, prepare=shared_prepare, integrate=alone)
    assert next(changes).answers > 0
    assert all(
        change.answers == 0
        for change in judge.in_two_threads(case, truth, prepare=own_prepare, integrate=alone)
    )


def test_every_way_is_asked_at_every_tolerance():
    single, batch, late, eventful = (
        judge.runs_of(draw(n, 0, 0))
        for n in ("pendulum", "many_pendulums", "late_beginning", "bouncing_ball")
    )
    assert len(set(single)) == len(single)
    assert {t for _, _, t in single} == set(judge.TOLERANCES)
    assert {m for m, way, _ in single if not way} == {"auto", *judge.METHOD_NAMES}
    assert {way for m, way, _ in single if m == "auto"} == {
        "",
        "samples",
        "prepared",
        "batch of 3",
        "batch of 64",
    }
    assert single[0][:2] == ("auto", "")
    assert {way.partition(" of ")[0] for _, way, _ in batch} == {"batch"}
    assert "prepared" not in {way for _, way, _ in late + eventful}


# -- the report


def test_the_table_counts_what_it_says(tmp_path):
    base = judge.Run(
        "pendulum/0/0", ("smooth",), "auto", "", 1e-6, "dop853", (), "met", 1e-7, 1e-7, 5e-6, 1e-6
    )
    runs = [
        base,
        replace(base, estimate=1e-8),
        replace(base, outcome="missed", error=1e-3, unitless=1e-3, inside=1e-3),
        replace(base, outcome="refused", needless=True),
    ]
    runs += [replace(base, outcome="raw"), replace(base, outcome="timeout")]
    by_tolerance, total = report.table(runs)
    assert (by_tolerance.runs, by_tolerance.returned, by_tolerance.met, by_tolerance.covers) == (
        6,
        3,
        2 / 3,
        1 / 3,
    )
    assert (
        by_tolerance.silent,
        by_tolerance.refused,
        by_tolerance.needless,
        by_tolerance.raw,
        by_tolerance.timeout,
    ) == (1, 1, 1, 1, 1)
    assert (by_tolerance.ratio, by_tolerance.inside) == (pytest.approx(0.1), 2 / 3)
    assert replace(total, rtol=1e-6) == by_tolerance
    assert not total.reaches_goals
    assert report.line("auto", None, [base]).reaches_goals
    assert [r.error for r in report.worst(runs)] == [1e-3]
    report.write(
        tmp_path,
        [SimpleNamespace(case="pendulum/0/0", runs=runs, changes=[], dropped="", condition=1.0)],
        [by_tolerance, total],
    )
    with open(tmp_path / "table.csv") as file:
        assert [row["silent"] for row in csv.DictReader(file)] == ["1", "1"]


def test_one_command_prints_the_table_and_what_reproduces_the_worst(tmp_path):
    command = [
        sys.executable,
        *["-m", "tests.honesty", "--families", "tiny_spring", "--draws", "1", "--jobs", "1"],
    ]
    command += ["--methods", "auto,dop853", "--tolerances", "1e-6", "--cache"]
    run = subprocess.run(
        [*command, tmp_path / "cache", "--out", tmp_path / "out"],
        cwd=ROOT,
        capture_output=True,
        text=True,
        timeout=120,
        env={**os.environ, "PYTHONPATH": str(ROOT)},
        check=True,
    )
    assert "auto, without heyoka" in run.stdout
    assert "1 models of 1 families" in run.stdout
    assert sorted(f.name for f in (tmp_path / "out").iterdir()) == [
        "changes.csv",
        "honesty.json",
        "honesty.png",
        "runs.csv",
        "table.csv",
    ]
    assert len(list((tmp_path / "cache").iterdir())) == 1
    with open(tmp_path / "out" / "runs.csv") as file:
        rows = list(csv.DictReader(file))
    assert {(r["case"], r["outcome"]) for r in rows if r["method"] == "dop853"} == {
        ("tiny_spring/0/0", "met")
    }


# -- the promises of the engine

needs_heyoka = pytest.mark.skipif(
    importlib.util.find_spec("heyoka") is None, reason="heyoka is not installed"
)
BROKEN_ONCE = [  # the case, and how it is asked
    pytest.param(
        "dry_friction/0/0",
        "auto",
        "prepared",
        1e-9,
        id="prepared runs go through kinks",
        marks=needs_heyoka,
    ),
    pytest.param(
        "dry_friction/0/0",
        "auto",
        "batch of 64",
        1e-9,
        id="batches go through kinks",
        marks=needs_heyoka,
    ),
    pytest.param(
        "dry_friction/0/0", "taylor", "", 1e-9, id="series go through kinks", marks=needs_heyoka
    ),
    pytest.param(
        "beside_a_constant/0/0",
        "taylor",
        "",
        1e-9,
        id="taylor beside a large state",
        marks=needs_heyoka,
    ),
    pytest.param("beside_a_constant/0/0", "dop853", "", 1e-9, id="dop853 beside a large state"),
    pytest.param("zeros_of_a_spring_by_its_closed_form/0/1", "auto", "", 1e-6, id="lost events"),
    pytest.param("pendulum_by_its_closed_form/0/2", "auto", "", 1e-12, id="phase of a closed form"),
    pytest.param(
        "tank_with_an_overflow/0/1",
        "scipy DOP853",
        "",
        1e-6,
        id="a raw error where the rates have no value",
    ),
    pytest.param(
        "pendulum_beside_the_upright/0/2",
        "yoshida8",
        "",
        1e-9,
        id="splitting beside a separatrix",
    ),
]


@pytest.mark.parametrize(("name", "method", "way", "rtol"), BROKEN_ONCE)
def test_an_answer_is_as_accurate_as_asked_and_the_estimate_covers_it(
    name, method, way, rtol, cache
):
    family, seed, number = name.split("/")
    case, truth = known(family, cache, int(seed), int(number))
    run = judged(case, truth, method, way, rtol, seconds=30.0)
    # "unfit": a series does not take rates with kinks
    assert run.outcome in ("met", "unfit") or (run.outcome == "refused" and not run.needless)
    assert run.covers is not False


@needs_heyoka
def test_a_call_gives_the_same_answer_after_others(cache):
    case, truth = known("dry_friction", cache)
    first = {1e-9: judge.answer(case, 1e-9)}
    prepare(case.model)
    (change,) = judge.repeated(case, truth, first, calls=3)
    assert not change.gross


@needs_heyoka
def test_a_large_batch_returns_an_estimate(cache):
    case, truth = known("pendulum", cache)
    assert judged(case, truth, way="batch of 64").estimate is not None


@needs_heyoka
def test_two_threads_get_the_answers_that_each_gets_alone(cache):
    case, truth = known("pendulum", cache)
    (prepared, *_) = judge.in_two_threads(case, truth, calls=8000, seconds=30.0)
    assert prepared.answers == 0


SAMPLE = (
    "pendulum",
    "free_body",
    "close_approach",
    "charged_particle",
    "beside_a_constant",
    "beside_a_traveller",
    "fast_and_slow",
    "tank_that_runs_empty",
    "chain_of_decays",
    "near_resonance",
    "spring_by_its_closed_form",
    "free_body_by_its_closed_form",
)


@pytest.fixture(scope="module")
def sample(cache):
    """Calls by auto for a few models whose references are cheap."""
    found = []
    for name in SAMPLE:
        case, truth = known(name, cache)
        found += [judged(case, truth, rtol=rtol) for rtol in judge.TOLERANCES]
    return report.line("auto", None, found)


def test_a_sample_of_models_has_no_raw_errors_and_no_needless_refusals(sample):
    assert sample.runs == 4 * len(SAMPLE)
    assert (sample.raw, sample.timeout, sample.needless) == (0, 0, 0)
    assert sample.met > 0.8  # 0.90 when this was written


def test_a_sample_of_models_reaches_the_goals(sample):
    assert sample.reaches_goals


@pytest.fixture(scope="module")
def everything():
    """All families, every method: half an hour."""
    cases = [(name, 0, k) for name in FAMILIES for k in range(DRAWS)]
    return list(results(cases, Plan(cache=str(references.cache_folder())), os.cpu_count()))


@pytest.mark.slow
def test_references_are_reached(everything):
    assert sum(bool(r.dropped) for r in everything) <= 0.02 * len(everything)


@pytest.mark.slow
def test_every_way_to_ask_reaches_the_goals(everything):
    lines = report.table([run for r in everything for run in r.runs])
    assert [x for x in lines if x.rtol is not None and not x.reaches_goals] == []


@pytest.mark.slow
def test_every_call_ends_with_an_answer_or_a_refusal(everything):
    assert [
        run.words for r in everything for run in r.runs if run.outcome in ("raw", "timeout")
    ] == []


@pytest.mark.slow
def test_no_answer_depends_on_what_ran_before_or_beside_it(everything):
    assert [
        c for r in everything for c in r.changes if c.gross or (c.answers and len(c.methods) < 2)
    ] == []

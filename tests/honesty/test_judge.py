"""The judge: true errors, outcomes, and answers that depend on other calls."""

import math
import threading
import time
from dataclasses import replace
from fractions import Fraction
from types import SimpleNamespace

import pytest

from newton_euler.motion import METHODS, ModelError
from tests.honesty import judge, references
from tests.honesty.cases import draw


@pytest.fixture
def pendulum(known):
    return known("pendulum")


def judged(case, truth, way="", **engine):
    return judge.judged(case, {0: truth}, "auto", way, 1e-6, **engine)


def fake(case, truth, off, estimate, method="fake"):
    """An integrator wrong by ``off`` times each state's size, which returns a given estimate."""
    known = references.scales(truth.sizes, truth.natural)
    rows = [
        [float(x) + off * size for x, size in zip(row, known, strict=True)] for row in truth.states
    ]
    columns = zip(*rows[:-1], strict=True)
    table = {
        n: SimpleNamespace(tolist=lambda column=column: list(column))
        for n, column in zip(case.model.states, columns, strict=True)
    }
    end = dict(zip(case.model.states, rows[-1], strict=True))
    found = {"error": estimate, "end": end, "t_end": case.t_end, "events": ()}
    motion = SimpleNamespace(
        **found, method=SimpleNamespace(name=method), at=lambda times: table, states=table
    )
    return lambda *_, **__: motion


@pytest.mark.parametrize(("off", "estimate", "outcome", "covers", "silent"), [
    (1e-8, 1e-7, "met", True, False), (1e-8, 1e-9, "met", False, False),
    (5e-6, 1e-7, "missed", False, False), (1e-4, 1e-12, "missed", False, True),
    (1e-4, 1e-3, "missed", True, False), (math.nan, 1e-12, "missed", False, True),
])  # fmt: skip
def test_an_estimate_below_the_error_is_caught(off, estimate, outcome, covers, silent, pendulum):
    run = judged(*pendulum, integrate=fake(*pendulum, off, estimate))
    assert (run.outcome, run.covers, run.silent) == (outcome, covers, silent)
    assert run.error == pytest.approx(off, rel=1e-6) or math.isinf(run.error)
    assert run.inside == pytest.approx(off, rel=1e-6) or math.isinf(run.inside)


def test_a_prepared_run_and_a_batch_without_an_estimate_are_judged_by_what_was_asked(pendulum):
    true = tuple(float(x) for x in pendulum[1].states[-1])
    prepared = lambda *_: lambda t, start: tuple(x * (1 + 1e-4) for x in true)
    off = judged(*pendulum, way="prepared", prepare=prepared)
    assert (off.outcome, off.silent, off.covers) == ("missed", True, None)

    def batch(model, t, start, rtol, method):
        import numpy as np

        rows = np.array([[x] * len(start[0]) for x in true])
        rows[:, len(start[0]) // 2] *= 1 + 1e-4  # one among many
        states = dict(zip(model.states, rows[:, :, None], strict=True))
        return SimpleNamespace(states=states, error=None, method=SimpleNamespace(name="fake"))

    assert judged(*pendulum, way="batch of 64", integrate=batch).silent


@pytest.mark.parametrize(("raised", "outcome"), [
    (ModelError("cannot be had"), "refused"), (ZeroDivisionError("0/0"), "raw"),
    (KeyError("x"), "raw"),
])  # fmt: skip
def test_a_refusal_in_words_is_distinguished_from_a_raw_error(raised, outcome, pendulum):
    def run(*_, **__):
        raise raised

    found = judged(*pendulum, integrate=run)
    assert (found.outcome, found.needless, found.returned) == (outcome, outcome == "refused", False)
    ill = replace(pendulum[1], condition=1e9)  # here a refusal is right
    assert not judged(pendulum[0], ill, integrate=run).needless


def test_no_end_is_a_timeout_and_an_answer_where_there_is_no_motion_silently_wrong(pendulum, known):
    run = judged(*pendulum, seconds=0.05, integrate=lambda *_, **__: time.sleep(5))
    assert (run.outcome, run.returned) == ("timeout", False)
    case, truth = known("blow_up_on_the_way")
    found = {"error": 1e-12, "end": {"x": 1.0}, "t_end": case.t_end, "events": ()}
    motion = SimpleNamespace(**found, method=SimpleNamespace(name="fake"), at=lambda t: {})
    assert judged(case, truth, integrate=lambda *_, **__: motion).silent


def test_a_lost_event_is_an_error_unless_two_lie_too_close_to_distinguish(known):
    case, truth = known("bouncing_ball")
    found = [(n, float(t)) for n, t, _ in truth.events]
    assert judge.events_error(found, truth, 1e-9) < 1e-15
    assert judge.events_error(found[1:], truth, 1e-9) == math.inf
    late = [(n, t + 1e-5 * case.t_end) for n, t in found]
    assert 1e-6 < judge.events_error(late, truth, 1e-9) <= 1.0001e-5
    assert judge.events_error(found[1:], replace(truth, margin=1e-10), 1e-9) == 0.0


def test_errors_are_relative_to_the_time_since_the_start_and_found_beside_next_to_nothing(known):
    case, truth = known("eclipses_by_the_clock_of_the_mission")
    late = [(n, float(t) + 1e-5 * (case.t_end - case.t0)) for n, t, _ in truth.events]
    weight = max(w for *_, w in truth.events)
    assert Fraction(truth.events[0][1]) > case.t0 > case.t_end - case.t0
    assert judge.events_error(late, truth, 1e-9, case.t0) == pytest.approx(1e-5 * weight, rel=1e-6)
    # written as a fraction of integers the error has millions of digits
    assert judge.true_error((1e-9,), ("-1e-9000000",), (2.0,), (2.0,)) == pytest.approx(5e-10)


@pytest.mark.parametrize(
    ("state", "unit", "error"),
    [
        ((1.002, 0.0, 0.0), judge.UNIT, 1e-3),
        ((1.0, 1e-9, 0.0), judge.UNIT, 1e-3),  # of 1e-6 in its unit
        ((1.0, 1e-9, 0.0), 0.0, 1.0),
        ((1.0, 0.0, 4e-15), judge.UNIT, 1e-12),  # of a thousandth of 4
        ((1.0, math.inf, 0.0), judge.UNIT, math.inf),
    ],
)
def test_no_state_is_judged_below_its_unit_or_what_its_coupling_makes_of_it(state, unit, error):
    true, sizes, natural = ("1.0", "0.0", "0.0"), (2.0, 1e-9, 0.0), (0.1, 1e-9, 4.0)
    assert judge.true_error(state, true, sizes, natural, unit) == pytest.approx(error)


def test_an_answer_that_changes_is_noticed(pendulum):
    good, bad = fake(*pendulum, 0.0, 1e-12), fake(*pendulum, 1e-4, 1e-12, "other")
    calls = []

    def moody(*args, **named):
        calls.append(1)
        return (bad if len(calls) > 5 else good)(*args, **named)

    def repeated(engine):
        first = {1e-6: judge.answer(pendulum[0], 1e-6, engine)}
        (change,) = judge.repeated(*pendulum, first, calls=10, seconds=1e9, integrate=engine)
        return change

    change = repeated(moody)
    assert (change.answers, change.calls, change.gross) == (6, 11, True)
    assert change.methods == ("fake", "other")
    assert change.moved == pytest.approx(1e-4)
    same = repeated(good)
    assert (same.answers, same.gross) == (0, False)


def test_threads_that_share_a_state_are_noticed(pendulum):
    def prepare_in(place):
        def run(t, start):
            place.x = start
            time.sleep(1e-4)  # so that the other thread comes between
            return place.x

        return lambda model, rtol: run

    def answers(place):
        alone = fake(*pendulum, 0.0, 1e-12)
        changes = judge.in_two_threads(*pendulum, prepare=prepare_in(place), integrate=alone)
        return [change.answers for change in changes]

    assert answers(SimpleNamespace())[0] > 0
    assert not any(answers(threading.local()))


def test_every_way_is_asked_at_every_tolerance():
    cases = ("pendulum", "many_pendulums", "late_beginning", "bouncing_ball")
    single, batch, late, eventful = (judge.runs_of(draw(n, 0, 0)) for n in cases)
    assert len(set(single)) == len(single)
    assert {t for _, _, t in single} == set(judge.TOLERANCES)
    assert {m for m, way, _ in single if not way} == {"auto", *METHODS}
    ways = {way for m, way, _ in single if m == "auto"}
    assert ways == {"", "samples", "prepared", "batch of 3", "batch of 64"}
    assert single[0][:2] == ("auto", "")
    assert {way.partition(" of ")[0] for _, way, _ in batch} == {"batch"}
    assert "prepared" not in {way for _, way, _ in late + eventful}

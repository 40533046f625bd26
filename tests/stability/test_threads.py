"""Threads share no state through what a user calls: each gets, bit for bit, the answer that it
would get alone.
"""

import math
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest

from newton_euler import sin
from newton_euler.motion import Event, integrate, prepare, second_order
from newton_euler.scenes.planar.pendulum import physical_pendulum
from tests.honesty.limits import frequent_switches


def pendulum(method=""):
    if method == "exact":
        return physical_pendulum(2.0, 0.5, 0.5, 10.0)
    return second_order("pendulum", {"k": 4.0}, ("a",), lambda s, p, t: (-p.k * sin(s.a),))


@pytest.fixture
def busy():
    """Threads that take turns every microsecond."""
    with frequent_switches():
        yield


def in_threads(call, arguments, threads=4):
    with ThreadPoolExecutor(threads) as pool:
        return list(pool.map(lambda a: call(*a), arguments))


METHODS = ["taylor", "dop853", "exact"]


@pytest.mark.parametrize("method", METHODS)
def test_a_prepared_run_in_four_threads(method, busy):
    run = prepare(pendulum(method), 1e-9, method)
    count = 60 if method == "dop853" else 1500
    asked = [(5.0 + n % 3, (0.1 + 2.5 * (n % 97) / 97, 0.0)) for n in range(count)]
    alone = {a: run(*a) for a in asked}
    assert in_threads(run, asked) == [alone[a] for a in asked]


@pytest.mark.parametrize("method", METHODS)
def test_whole_integrations_in_four_threads(method, busy):
    model = pendulum(method)
    turns = Event(lambda s, p, t: s.omega if method == "exact" else s.da, name="turns")

    def run(t, start):
        motion = integrate(model, t, start, 1e-9, method, turns)
        return motion.end, motion.error, [e.t for e in motion.events], motion.at(t / 3)

    asked = [(5.0, (0.1 + 2.5 * n / 12, 0.0)) for n in range(12)] * 2
    alone = [run(*a) for a in asked]
    assert in_threads(run, asked) == alone


@pytest.mark.parametrize("method", METHODS)
def test_one_motion_is_read_by_four_threads(method, busy):
    """The dense output between the steps is made when it is first asked for."""
    made = lambda: integrate(pendulum(method), 20.0, (1.0, 0.0), 1e-9, method)
    times = [(t,) for t in np.random.default_rng(1).uniform(0, 20, 400).tolist()]
    alone = [made().at(*t) for t in times[:40]]
    for _ in range(2):
        assert in_threads(made().at, times)[:40] == alone


def test_batches_of_heyoka_in_two_threads(busy):
    pytest.importorskip("heyoka")
    model = pendulum()

    def run(first):
        a = np.linspace(first, 2.9, 200)
        return integrate(model, 10.0, (a, 0.0), 1e-9).states["a"].tolist()

    asked = [(0.1 * n,) for n in range(1, 9)]
    alone = [run(*a) for a in asked]
    assert in_threads(run, asked, 2) == alone


def test_models_with_other_parameters_share_their_compiled_code_but_no_numbers(busy):
    pytest.importorskip("heyoka")
    runs = [prepare(pendulum().changed(k=1.0 + n), 1e-9, "taylor") for n in range(4)]
    alone = [run(3.0, (0.01, 0.0))[0] for run in runs]
    assert alone == pytest.approx(
        [0.01 * math.cos(3 * math.sqrt(1 + n)) for n in range(4)], abs=2e-6
    )
    many = lambda run, expected: sum(run(3.0, (0.01, 0.0))[0] != expected for _ in range(2000))
    assert in_threads(many, zip(runs, alone, strict=True)) == [0] * 4

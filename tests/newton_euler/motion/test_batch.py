"""Many motions at once: which of them vouch for which, and that each is as accurate as asked."""

import importlib.util
import math
from types import SimpleNamespace

import numpy as np
import pytest

from newton_euler import Model, cos, exp, integrate, sin
from newton_euler.motion import ModelError, second_order
from newton_euler.motion.batch import MIN_HEYOKA_BATCH, _by_series, _representatives
from newton_euler.motion.control.verified import NEAR_END, NEAR_START
from newton_euler.motion.prepared import prepared_model

HEYOKA = importlib.util.find_spec("heyoka") is not None
needs_heyoka = pytest.mark.skipif(not HEYOKA, reason="heyoka is not installed")
PENDULUM = second_order("pendulum", {"n": 1.0}, ("a",), lambda s, p, t: (-p.n * sin(s.a),))


def test_motions_close_to_each_other_have_one_representative():
    """Two clusters of starts and ends, of 20 motions each, in turn."""
    begins = np.array([[1.0, 2.0] * 20, [1e-6, 1e-6] * 20]) * np.linspace(1.0, 1.01, 40)
    ends = np.array([[5.0, -5.0] * 20]) * np.linspace(1.0, 1.01, 40)
    chosen, vouching = _representatives(begins, ends)
    assert chosen.tolist() == [0, 1]
    assert vouching.tolist() == [0, 1] * 20


@pytest.mark.parametrize(("part", "which", "count"), [
    (0.99 * NEAR_START, "begins", 1),
    (1.01 * NEAR_START, "begins", 2),
    (0.99 * NEAR_END, "ends", 1),
    (1.01 * NEAR_END, "ends", 2),
])  # fmt: skip
@pytest.mark.parametrize("sign", [1, -1])
def test_close_is_a_part_of_the_size(part, which, count, sign):
    values = {"begins": np.full((2, 12), sign * 7.0), "ends": np.full((2, 12), sign * 7.0)}
    values[which][1, 5] *= 1 - part
    chosen, vouching = _representatives(values["begins"], values["ends"])
    assert chosen.tolist() == [0, 5][:count]
    assert vouching[5] == chosen[-1]
    assert np.delete(vouching, 5).tolist() == [0] * 11


@pytest.mark.parametrize(("clusters", "covered"), [(5, True), (6, True), (7, False), (20, False)])
def test_a_cover_that_is_no_smaller_than_the_whole_is_not_looked_for(clusters, covered):
    """Of 20 motions: the search is given up when more than a quarter of them is not enough."""
    begins = np.resize(np.linspace(-1.0, 1.0, clusters), 20)[None]
    chosen, vouching = _representatives(begins, np.ones((1, 20)))
    numbers = np.arange(20)
    assert chosen.tolist() == numbers[: clusters if covered else 20].tolist()
    assert vouching.tolist() == (numbers % clusters if covered else numbers).tolist()


def test_a_motion_without_an_end_vouches_for_itself_only():
    ends = np.full((1, 20), 2.0)
    ends[0, [3, 7]] = math.nan
    chosen, vouching = _representatives(np.ones((1, 20)), ends)
    assert chosen.tolist() == [0, 3, 7]
    assert vouching[[3, 7]].tolist() == [3, 7]


def system(hazards=(), kinks=()):
    traced = SimpleNamespace(hazards=hazards, kinks=kinks)
    return SimpleNamespace(traced=traced, model=SimpleNamespace(name="any"))


@needs_heyoka
def test_heyoka_is_taken_for_many_motions_or_if_it_is_asked_for():
    assert not _by_series(system(), "auto", MIN_HEYOKA_BATCH - 1)
    assert _by_series(system(), "auto", MIN_HEYOKA_BATCH)
    assert _by_series(system(), "taylor", 1)
    assert not _by_series(system(), "dop853", 10 * MIN_HEYOKA_BATCH)
    assert not _by_series(system(), "exact", 10 * MIN_HEYOKA_BATCH)


@needs_heyoka
def test_heyoka_is_not_taken_for_what_a_series_does_not_see():
    assert not _by_series(system(hazards=("sqrt",)), "taylor", 100)
    assert not _by_series(system(hazards=("sqrt",)), "auto", 100)
    assert not _by_series(system(kinks=("where",)), "auto", 100)


def amplitudes(count):
    return np.linspace(0.1, 2.0, count)


@needs_heyoka
@pytest.mark.parametrize("count", [1, 3, 65])
@pytest.mark.parametrize(
    "samples",
    [None, 7, [2.0, 5.0], [0.0, 2.0, 5.0], [5.0], [0.0, 5.0]],
    ids=str,
)
def test_each_motion_of_a_batch_is_that_of_integrate_at_its_samples(count, samples):
    a = amplitudes(count)
    motions = integrate(PENDULUM, 5.0, (a, 0.0 * a), method="taylor", samples=samples)
    assert len(motions) == count
    assert motions.states["a"].shape == (count, len(motions.times))
    assert motions.method.name == "taylor"
    assert motions.cost.calls > 0
    assert (motions.error <= 1e-9).all()
    for n in {0, count // 2, count - 1}:
        one = integrate(PENDULUM, 5.0, (a[n], 0.0), 1e-11)
        for name in ("a", "da"):
            apart = abs(motions.states[name][n] - one.at(motions.times)[name])
            assert apart.max() <= 2e-9


@needs_heyoka
@pytest.mark.parametrize("t", [(2.0, 6.0), (-1.0, 3.0)])
def test_a_batch_begins_when_it_is_asked_to(t):
    model = Model("driven", {"w": 1.0}, ("x",), lambda s, p, t: (cos(p.w * t),))
    w = np.linspace(0.5, 1.5, 9)
    motions = integrate(model.changed(w=w), t, (np.ones(9),), method="taylor")
    exact = 1 + (np.sin(w * t[1]) - np.sin(w * t[0])) / w
    assert motions.times.tolist() == list(t)
    assert abs(motions.states["x"][:, 0] - 1).max() == 0
    assert abs(motions.states["x"][:, -1] - exact).max() < 1e-9
    sizes = np.maximum(1.0, abs(exact))
    assert (abs(motions.states["x"][:, -1] - exact) / sizes <= motions.error).all()


@needs_heyoka
def test_a_batch_does_not_pass_over_a_pulse():
    model = Model(
        "struck", {"h": 1.0}, ("x",), lambda s, p, t: (p.h * exp(-(((t - 50) / 0.05) ** 2)),)
    )
    h = np.linspace(1.0, 2.0, 5)
    motions = integrate(model.changed(h=h), 100.0, (np.zeros(5),), method="taylor")
    assert motions.states["x"][:, -1] == pytest.approx(h * 0.05 * math.sqrt(math.pi), rel=1e-9)


@needs_heyoka
@pytest.mark.parametrize("samples", [[3.0, 2.0], [2.0, 2.0]], ids=str)
def test_samples_of_a_batch_increase_from_its_start(samples):
    with pytest.raises(ModelError, match="must increase from t = 0"):
        integrate(PENDULUM, 5.0, (amplitudes(3), np.zeros(3)), method="taylor", samples=samples)


@pytest.mark.parametrize("count", [1, 2, 70])
def test_the_errors_of_a_batch_of_closed_forms_are_those_asked_for(count):
    spring = second_order(
        "spring",
        {"w": 1.0},
        ("x",),
        lambda s, p, t: (-p.w * p.w * s.x,),
        exact=lambda s, p, t: (
            s.x * cos(p.w * t) + s.dx / p.w * sin(p.w * t),
            s.dx * cos(p.w * t) - p.w * s.x * sin(p.w * t),
        ),
    )
    w = np.linspace(1.0, 3.0, count)
    motions = integrate(spring.changed(w=w), (1.0, 5.0), (np.ones(count), 0.0), samples=5)
    assert motions.method.name == "exact"
    assert motions.times.tolist() == [1.0, 2.0, 3.0, 4.0, 5.0]
    exact = np.cos(w[:, None] * (motions.times - 1.0))
    assert abs(motions.states["x"] - exact).max() < 1e-13
    assert (motions.error <= motions.rtol).all()
    assert motions.cost.calls >= 5


def test_what_no_batch_can_begin_with_is_said():
    a = amplitudes(3)
    with pytest.raises(ModelError, match=r"lengths that do not fit together: a \(3,\), da \(2,\)"):
        integrate(PENDULUM, 1.0, (a, np.zeros(2)))
    with pytest.raises(ModelError, match="one dimension, got"):
        integrate(PENDULUM, 1.0, (np.ones((2, 2)), 0.0))
    for bad in (math.nan, math.inf):
        with pytest.raises(ModelError, match="must be finite numbers"):
            integrate(PENDULUM, 1.0, (np.array([1.0, bad]), 0.0))
        with pytest.raises(ModelError, match="must be finite numbers"):
            integrate(PENDULUM.changed(n=np.array([1.0, bad])), 1.0, (1.0, 0.0))


def test_without_heyoka_each_motion_of_a_batch_is_integrated_by_itself():
    a = amplitudes(3)
    motions = integrate(PENDULUM, (1.0, 4.0), (a, np.zeros(3)), method="dop853", samples=4)
    assert motions.method.name == "dop853"
    for n in range(3):
        one = integrate(PENDULUM, (1.0, 4.0), (a[n], 0.0), method="dop853", samples=4)
        assert motions.states["a"][n].tolist() == one.states["a"].tolist()
        assert motions.error[n] == one.error
    assert motions.cost.calls == sum(
        integrate(PENDULUM, (1.0, 4.0), (x, 0.0), method="dop853").cost.calls for x in a
    )


def test_a_prepared_model_is_not_changed_by_its_batch():
    before = prepared_model(PENDULUM).p
    integrate(PENDULUM.changed(n=np.array([1.0, 2.0])), 1.0, (1.0, 0.0), method="dop853")
    assert prepared_model(PENDULUM).p == before

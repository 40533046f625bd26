"""The references: two ways that agree, kept by their content."""

import math
from dataclasses import replace
from itertools import pairwise
from types import SimpleNamespace

import pytest

from newton_euler.accuracy.measurements.reference import by_extrapolation
from tests.honesty import closed_forms, judge, references
from tests.honesty.cases import DRAWS, draw
from tests.honesty.references import NoReferenceError, reference
from tests.models import needs_heyoka


def floats(row):
    return [float(x) for x in row]


def test_two_motions_differ_by_their_worst_state_and_a_wrong_closed_form_is_no_reference():
    a, b = (SimpleNamespace(states=[(1.0, 2.0), (0.0, x), (5.0, 0.0)]) for x in (2.0, 3.0))
    assert references._distance(a, b, (5.0, 2.0), (0.0, 0.0)) == 0.5

    def wrong(mp, s, p, t):
        return closed_forms.pendulum(mp, p.k * (1 + mp.mpf(10) ** -14), s.theta, s.omega, t)

    with pytest.raises(NoReferenceError, match="differ by"):
        reference(replace(draw("pendulum", 0, 0), exact=wrong))


@needs_heyoka
@pytest.mark.parametrize("name", ["pendulum", "free_body", "planet_in_any_units"])
def test_series_and_extrapolation_end_where_the_closed_form_does(name):
    case = draw(name, 0, 0)
    case = replace(case, t_end=case.t_end / 8)
    exact, other = reference(case), reference(replace(case, exact=None))
    assert exact.ways[0] == "closed form"
    assert other.ways == ("Taylor series, 42 digits", "extrapolation, 22 digits")
    about = exact.states[-1], exact.sizes, exact.natural
    assert judge.true_error(floats(other.states[-1]), *about) < 2e-16
    assert floats(other.states[-1]) == pytest.approx(floats(exact.states[-1]), rel=1e-28, abs=0)
    assert other.condition == pytest.approx(exact.condition, rel=0.05)
    assert other.sizes == pytest.approx(exact.sizes, rel=0.1)


def test_the_condition_shows_that_place_and_speed_decide_when_a_wall_is_met(cache):
    """Not where both are changed by the same part: a speed turns within 1e-4 of the whole time."""
    assert reference(draw("ball_on_a_hertz_contact", 0, 5), cache).condition > 1e3


def test_the_extrapolation_of_the_accuracy_charts_agrees(known):
    case, truth = known("duffing")
    end = by_extrapolation(case.model, case.t_end, case.start, digits=18)
    assert floats(end) == pytest.approx(floats(truth.states[-1]), rel=1e-15)


def test_friction_is_followed_from_kink_to_kink(known):
    """Each swing ends nearer to the middle by 2 mu/k, so there is a closed form after n of them."""
    case, truth = known("dry_friction")
    k, mu, x = *case.model.parameters.values(), case.start[0]
    n = int(case.t_end * math.sqrt(k) / math.pi)
    # it moves to the left first, and friction pushes to the right
    centre = (mu if n % 2 == 0 else -mu) / k
    amplitude = x - (2 * n + 1) * mu / k
    end = centre + (-1) ** n * amplitude * math.cos(math.sqrt(k) * case.t_end - n * math.pi)
    assert float(truth.states[-1][0]) == pytest.approx(end, rel=1e-12)


def test_a_bouncing_ball_is_followed_through_its_impacts(known):
    case, truth = known("bouncing_ball")
    g, e, h = *case.model.parameters.values(), case.start[0]
    fall = math.sqrt(2 * h / g)
    exact = [fall * (1 + 2 * sum(e**n for n in range(1, k + 1))) for k in range(20)]
    exact = [t for t in exact if t < case.t_end]
    assert [float(t) for _, t, _ in truth.events] == pytest.approx(exact, rel=1e-14)


@needs_heyoka
def test_zeros_of_a_function_that_is_faster_than_the_motion_are_all_found(cache):
    """Between two of 20 000 instants there is at most one."""
    case = replace(draw("beats_of_two_tones", 0, 0), t_end=3.0)
    truth = reference(case, cache)
    k, w = case.model.parameters.values()
    times = [case.t_end * n / 20_000 for n in range(20_001)]
    g = [math.cos(w * t) - math.cos(math.sqrt(k) * t) / 2 for t in times]
    assert len(truth.events) == sum(a * b < 0 for a, b in pairwise(g))


@needs_heyoka
def test_a_pulse_that_one_way_steps_over_is_found_out():
    with pytest.raises(NoReferenceError, match="differ by"):
        reference(replace(draw("narrow_pulse", 0, 0), knots=()))


@needs_heyoka
def test_what_is_not_reached_in_time_is_reported_and_remembered(tmp_path, monkeypatch):
    case = replace(draw("lorenz", 0, 0), t_end=1e5)
    for _ in range(2):
        with pytest.raises(NoReferenceError, match=r"not reached in 0\.5 s"):
            reference(case, tmp_path, 0.5)
        monkeypatch.setattr(references, "_computed", lambda *_: pytest.fail("computed again"))
    assert len(list(tmp_path.iterdir())) == 1


def test_a_reference_is_kept_by_its_content(tmp_path):
    case = draw("damped_oscillator", 0, 0)
    first = reference(case, tmp_path)
    assert reference(replace(case, name="another"), tmp_path) == first
    assert len(list(tmp_path.iterdir())) == 1
    reference(replace(case, model=case.model.changed(c=0.0)), tmp_path)
    assert len(list(tmp_path.iterdir())) == 2


@needs_heyoka  # without it a minute
def test_a_rate_that_is_zero_has_the_size_that_its_coupling_gives_it(cache):
    truth = reference(replace(draw("steady_precession", 0, 0), t_end=0.5), cache)
    assert truth.sizes[2] < 1e-12  # of the nutation
    assert truth.natural[2] > 0.1


@pytest.mark.parametrize(
    "number", [0, *(pytest.param(n, marks=pytest.mark.slow) for n in range(1, DRAWS))]
)
def test_the_margin_is_the_depth_of_a_dip_whether_or_not_a_sample_falls_into_it(number, known):
    """The probe is next to its sun at 1 - e; the range is that of the far end."""
    case, truth = known("pairs_of_passages", number=number)
    e, low = case.start[0] - 1, case.model.parameters["low"]
    depth = abs((1 - e) ** 2 - low**2) / ((1 + e) ** 2 - low**2)
    assert truth.margin == pytest.approx(depth, rel=1e-3)

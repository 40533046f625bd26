"""Tests of the families of the holdout."""

from fractions import Fraction
from random import Random

import pytest

import tests.honesty.families
import tests.honesty.holdout  # noqa: F401
from tests.honesty import judge
from tests.honesty.cases import DRAWS, FAMILIES, HOLDOUT, draw, names
from tests.honesty.references import reference

pytest.importorskip("mpmath")
SUBJECTS = {
    "batch",
    "chaotic",
    "closed form",
    "equilibrium",
    "events",
    "forced",
    "kinked",
    "late",
    "law",
    "long",
    "mechanics",
    "multi-scale",
    "near-singular",
    "singular",
    "smooth",
    "sticking",
    "stiff",
    "tiny",
    "units",
}
KINKED = [n for n in HOLDOUT if draw(n, 0, 0).branches]
SOLVED = [n for n in HOLDOUT if draw(n, 0, 0).exact]
BRINGS_ITS_SOLUTION = [n for n in HOLDOUT if any(draw(n, 0, k).model.exact for k in range(DRAWS))]
IMPACTS = [n for n in HOLDOUT if draw(n, 0, 0).impact]
LAWS = [n for n in HOLDOUT if draw(n, 0, 0).written_out]


@pytest.fixture(scope="session")
def cache(tmp_path_factory):
    return tmp_path_factory.mktemp("references")


def test_the_holdout_has_at_least_45_families_of_every_subject_and_none_is_a_known_one():
    assert len(HOLDOUT) >= 45
    assert not HOLDOUT.keys() & FAMILIES.keys()
    assert {tag for f in HOLDOUT.values() for tag in f.tags} >= SUBJECTS
    assert all(f.__doc__ for f in HOLDOUT.values())


def numbers(x):
    return tuple(x.tolist()) if getattr(x, "shape", ()) else x


@pytest.mark.parametrize("name", HOLDOUT)
def test_knots_lie_inside_the_motion(name):
    for k in range(DRAWS):
        case = draw(name, 0, k)
        for member in judge.members(case):
            one = case.member(member)
            assert all(one.t0 < t < one.t_end for t in one.knots)


def somewhere(case, chance):
    """A random state and a time: each state of either sign, up to five times its value at the
    start or that of a parameter.
    """
    p = (case.written_out or case.model).parameters
    sizes = [1.0, *(abs(x) for x in p.values() if x)]
    x = tuple(
        (chance.choice((abs(a), 0.0)) or chance.choice(sizes)) * chance.uniform(-5.0, 5.0)
        for a in case.start
    )
    return x, chance.uniform(case.t0, case.t_end)


@pytest.mark.parametrize("name", KINKED)
def test_the_pieces_of_a_kinked_model_are_its_rates(name):
    """Each switch is met on both of its sides."""
    case, chance = draw(name, 0, 0).member(0), Random(name)
    parameters = (case.written_out or case.model).parameters
    p = names(parameters, parameters.values())
    met = set()
    for _ in range(400):
        x, t = somewhere(case, chance)
        s = names(case.model.states, x)
        signs = tuple(1 if g(s, p, t) > 0 else -1 for g in case.branches.switches)
        rates = case.model.derivative(x, t)
        assert case.branches.rates(s, p, t, signs) == pytest.approx(rates, rel=1e-12, abs=1e-12)
        met |= set(enumerate(signs))
    assert len(met) == 2 * len(case.branches.switches)


@pytest.mark.parametrize("name", LAWS)
def test_a_model_that_is_written_out_has_the_rates_of_the_one_with_laws(name):
    case, chance = draw(name, 0, 0), Random(name)
    for _ in range(20):
        x, t = somewhere(case, chance)
        assert case.written_out.derivative(x, t) == pytest.approx(
            case.model.derivative(x, t), rel=1e-13
        )


@pytest.mark.parametrize("name", SOLVED)
def test_a_closed_form_has_the_rates_of_its_model(name, cache):
    truth = reference(draw(name, 0, 0).member(0), cache)
    assert truth.agreement < 1e-15


@pytest.mark.parametrize("name", BRINGS_ITS_SOLUTION)
def test_the_solution_that_a_model_brings_begins_at_the_start(name):
    for k in range(DRAWS):
        case = draw(name, 0, k)
        if case.model.exact:
            sizes = [max(map(abs, case.start))] * len(case.start)
            begins = case.model.solution(0.0, case.start)
            for x, begin, size in zip(begins, case.start, sizes, strict=True):
                assert abs(x - begin) <= 1e-9 * size


@pytest.mark.parametrize("name", IMPACTS)
def test_an_impact_of_the_reference_has_the_states_of_the_one_that_the_engine_sees(name):
    case = draw(name, 0, 0)
    s = names(case.model.states, [0.3 + x for x in case.start])
    p = names(case.model.parameters, case.model.parameters.values())
    told = [e.then(s, p, 0.7)[1] for e in case.events if e.then]
    assert told
    assert len(told[0]) == len(case.impact(s, p, 0.7)) == len(case.start)


def test_the_error_of_an_event_is_relative_to_the_time_since_the_start(cache):
    case = draw("eclipses_by_the_clock_of_the_mission", 0, 0)
    truth = reference(case, cache)
    late = [(n, float(t) + 1e-5 * (case.t_end - case.t0)) for n, t, _ in truth.events]
    weight = max(w for *_, w in truth.events)
    assert Fraction(truth.events[0][1]) > case.t0 > case.t_end - case.t0
    assert judge.events_error(late, truth, 1e-9, case.t0) == pytest.approx(1e-5 * weight, rel=1e-6)


@pytest.mark.parametrize("number", range(DRAWS))
def test_the_margin_is_the_depth_of_a_dip_whether_or_not_a_look_falls_into_it(number, cache):
    """The probe is next to its sun at 1 - e; the range is that of the far end."""
    case = draw("pairs_of_passages", 0, number)
    e, low = case.start[0] - 1, case.model.parameters["low"]
    depth = abs((1 - e) ** 2 - low**2) / ((1 + e) ** 2 - low**2)
    assert reference(case, cache).margin == pytest.approx(depth, rel=1e-3)

"""The families of random models, held out or not: what each of them promises."""

import math
from random import Random

import pytest

import tests.honesty.families
import tests.honesty.holdout  # noqa: F401
from tests.honesty import judge
from tests.honesty.cases import DRAWS, FAMILIES, HOLDOUT, draw
from tests.honesty.pieces import pieces
from tests.honesty.references import reference

SUBJECTS = {
    *("smooth", "kinked", "stiff", "multi-scale", "chaotic", "singular", "near-singular", "long"),
    *("forced", "events", "tiny", "units", "batch", "mechanics"),
}
OF_THE_HOLDOUT = SUBJECTS | {"closed form", "equilibrium", "late", "law", "sticking"}
ALL = [*FAMILIES, *HOLDOUT]
FIRST = {n: draw(n, 0, 0) for n in ALL}


@pytest.mark.parametrize(("known", "least", "subjects"), [
    (FAMILIES, 48, SUBJECTS), (HOLDOUT, 45, OF_THE_HOLDOUT),
], ids=["known", "holdout"])  # fmt: skip
def test_there_are_families_of_every_subject_each_described(known, least, subjects):
    assert len(known) >= least
    assert {tag for f in known.values() for tag in f.tags} >= subjects
    assert all(f.__doc__ for f in known.values())


def numbers(x):
    return tuple(x.tolist()) if getattr(x, "shape", ()) else x


def written_out(case):
    """The model that its reference takes."""
    return case.written_out or case.model


def described(case):
    model = written_out(case)
    parameters = {n: numbers(x) for n, x in model.parameters.items()}
    source = model.compiled_rhs(*parameters).source
    return source, parameters, tuple(map(numbers, case.start)), case.t0, case.t_end


@pytest.mark.parametrize("name", ALL)
def test_a_family_draws_the_same_for_the_same_seed_and_others_for_another(name):
    first = [described(draw(name, 0, k)) for k in range(DRAWS)]
    assert described(draw(name, 0, 1)) == first[1]
    assert described(draw(name, 1, 1)) not in first
    assert all(first[i] != first[j] for i in range(DRAWS) for j in range(i))


@pytest.mark.parametrize("name", ALL)
def test_every_draw_has_a_start_with_finite_rates_and_a_positive_time(name):
    for case in (draw(name, 0, k) for k in range(DRAWS)):
        for one in map(case.member, judge.members(case)):
            assert one.t_end > one.t0
            assert all(map(math.isfinite, one.model.derivative(one.start, one.t0)))
            assert list(one.times) == sorted(one.times)


def somewhere(case, chance):
    """A random state and time, up to five times the start's values or a parameter's."""
    p = written_out(case).parameters
    sizes = [1.0, *(abs(x) for x in p.values() if x)]
    x = tuple(
        (chance.choice((abs(a), 0.0)) or chance.choice(sizes)) * chance.uniform(-5.0, 5.0)
        for a in case.start
    )
    return x, chance.uniform(case.t0, case.t_end)


KINKED = [
    n
    for n, case in FIRST.items()
    if not (case.exact or case.singular) and pieces(written_out(case.member(0)))[1]
]


@pytest.mark.parametrize("name", KINKED)
def test_the_pieces_of_a_kinked_model_are_its_rates(name):
    """Each switch is tested on both of its sides."""
    case, chance = FIRST[name].member(0), Random(name)
    rates, switches = pieces(written_out(case))
    p = written_out(case).parameters
    met = set()
    for _ in range(400):
        x, t = somewhere(case, chance)
        if name == "tank_with_an_overflow":
            x = tuple(map(abs, x))  # a level
        if name == "swing_on_a_table":
            x = max(-4.0, min(4.0, x[0])), x[1]  # where the table is
        if name in ("puck_through_a_round_puddle", "lorry_in_a_bed_of_gravel"):
            x = *(p["R"] * chance.uniform(-2.0, 2.0) for _ in "xy"), *x[2:]  # about the patch
        at = t, *x, *p.values()
        signs = [1 if g(*at) > 0 else -1 for g in switches]
        known = case.model.derivative(x, t)
        assert rates(*at, *signs) == pytest.approx(known, rel=1e-12, abs=1e-12)
        met |= set(enumerate(signs))
    assert len(met) == 2 * len(switches)


@pytest.mark.one_in(3)
@pytest.mark.parametrize("name", [n for n in ALL if FIRST[n].exact])
def test_a_closed_form_has_the_rates_of_its_model(name, cache):
    truth = reference(FIRST[name].member(0), cache)
    assert truth.agreement < (1e-18 if name in FAMILIES else 1e-15)


@pytest.mark.parametrize("name", [n for n in ALL if FIRST[n].written_out])
def test_a_model_that_is_written_out_has_the_rates_of_the_one_with_laws(name):
    case, chance = FIRST[name], Random(name)
    for _ in range(20):
        x, t = somewhere(case, chance)
        rates = case.model.derivative(x, t)
        assert case.written_out.derivative(x, t) == pytest.approx(rates, rel=1e-13)


BRINGS_ITS_SOLUTION = [n for n in HOLDOUT if any(draw(n, 0, k).model.exact for k in range(DRAWS))]


@pytest.mark.parametrize("name", BRINGS_ITS_SOLUTION)
def test_the_solution_that_a_model_brings_begins_at_the_start(name):
    for case in (draw(name, 0, k) for k in range(DRAWS)):
        if case.model.exact:
            size = max(map(abs, case.start))
            begin = case.model.solution(0.0, case.start)
            assert begin == pytest.approx(case.start, rel=0, abs=1e-9 * size)

"""reference.py: the final states to 30 digits, against exact solutions and found in two ways."""

import mpmath as mp
import pytest

from newton_euler.accuracy.measurements import reference
from newton_euler.scenes import SCENES

EXACT = [name for name in SCENES if SCENES[name].motion[0].exact]


@pytest.mark.one_in(4)
@pytest.mark.parametrize("name", EXACT)
def test_references_agree_with_exact_solutions_to_28_digits(name):
    model, t, start = SCENES[name].motion
    with mp.workdps(45):
        exact = in_digits(model).solution(mp.mpf(t), [mp.mpf(x) for x in start])
        assert apart(reference.reference_solution(model, t, start), exact) < 1e-28


QUICK_TO_EXTRAPOLATE = ("aircraft", "aircraft in space", "projectile")


@pytest.mark.parametrize(
    "name",
    [
        n if n in QUICK_TO_EXTRAPOLATE else pytest.param(n, marks=pytest.mark.slow)
        for n in SCENES
        if n not in EXACT
    ],
)
def test_references_without_exact_solution_agree_with_extrapolation_to_28_digits(name):
    pytest.importorskip("heyoka")
    motion = SCENES[name].motion
    assert apart(reference.by_heyoka(*motion), reference.by_extrapolation(*motion)) < 1e-28


def test_extrapolation_agrees_with_an_exact_solution_to_30_digits():
    model, _, start = SCENES["space station"].motion
    with mp.workdps(45):
        exact = in_digits(model).solution(mp.mpf(7), [mp.mpf(x) for x in start])
        assert apart(reference.by_extrapolation(model, 7.0, start), exact) < 1e-30
        assert apart(reference.by_extrapolation(model, 7.0, start, digits=16), exact) > 1e-30


def in_digits(model):
    """The same model with its parameters as mpf."""
    return model.changed(**{n: mp.mpf(x) for n, x in model.parameters.items()})


def apart(a, b):
    """The largest difference between two states over the largest value, in all digits."""
    with mp.workdps(45):
        return float(max(abs(x - y) for x, y in zip(a, b, strict=True)) / max(map(abs, b)))

"""What a released sheet says that any answer must satisfy."""

import math
import random
from dataclasses import replace

import pytest

from exercises.catalogue import problem, select
from exercises.catalogue.sanity import sane_answers
from exercises.catalogue.variants import draw, flat
from newton_euler.answers.forms import Form
from newton_euler.answers.sanity import doubts

SOME = ("2/4", "2/18", "3/27", "4/16", "5/16", "6/21", "7/3", "8/8", "9/1", "10/8", "11/8", "A/9")


@pytest.mark.parametrize("name", SOME)
def test_right_answers_are_never_doubted(name):
    p = problem(name)
    for n in range(3):
        values = draw(p, f"sane {n}".encode())
        right = p.solve({**{s: sum(x.vary) / 2 for s, x in p.symbols.items()}, **values})
        for a in p.answers:
            if not a.kind.is_formula and not isinstance(right[a.key], (str, int)):
                tree = [float(x) for x in flat(right[a.key])]
                tree = tree[0] if len(tree) == 1 else tree
                sane = sane_answers(p).get(a.key)
                assert doubts(Form(a.kind, a.unit), tree, {}, sane) == [], (a.key, values)


def test_bounds_are_powers_of_ten_and_give_away_no_key():
    for name in SOME:
        for bounds in sane_answers(problem(name)).values():
            for x in bounds if isinstance(bounds, tuple) else ():
                assert x == 0 or math.isclose(math.log10(x), round(math.log10(x)), abs_tol=1e-9)


def test_metres_for_millimetres_are_doubted():
    p = problem("4/16")
    sane = sane_answers(p)["v_D"]
    v = [0.0096 * x for x in (-1, 0.65, -0.37)]
    (doubt,) = doubts(Form("vector", "mm/s"), v, {}, sane)
    assert "check the units" in doubt


def test_every_problem_has_its_bounds():
    """It runs for all of them; for most that ask for numbers there is some bound."""
    some = random.Random(3).sample(select(["all"]), 40)
    asked = [p for p in some if any(a.kind.name in ("number", "vector") for a in p.answers)]
    assert sum(bool(sane_answers(p)) for p in asked) >= 0.9 * len(asked)


def test_what_is_never_negative_is_known_in_any_words():
    p = problem("4/1")
    told = replace(p, answers=tuple(replace(a, means="Betrag") for a in p.answers))
    assert sane_answers(told) == sane_answers(p)
    assert {x[2] for x in sane_answers(p).values()} == {"magnitude"}

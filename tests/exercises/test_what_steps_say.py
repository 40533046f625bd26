"""The steps that practice asks for lead to the answers and give none away: they are found from the
givens and from each other, and none of them is an answer or another step.
"""

import math
import re
from functools import cache

import pytest

from exercises.catalogue import select
from exercises.catalogue.checks import values
from exercises.catalogue.steps import listed_steps, repeated
from exercises.catalogue.tracing import before
from exercises.catalogue.variants import flat
from newton_euler.algebra.trace import Step as Traced
from newton_euler.algebra.trace import Trace
from tests.by_chapter import by_chapter

ALL = select(["all"])
SEEDS = 1, 2, 3
# moments about two axes, which are the same by the symmetry of the body
SYMMETRIC = {("7/6", "I_yy"), ("7/8", "I_xx"), ("8/11", "I_zx")}

by_id = pytest.mark.parametrize("p", ALL, ids=lambda p: p.id.replace("/", "_"))


@cache
def sheets(p):
    """For some students, ({step: (numbers, whether it is a term)}, {answer: numbers})."""
    found = []
    for seed in SEEDS:
        g = p.base(values(p, seed))
        asked = {k: x for k, x in p.code.solve(g).items() if not p.answer(k).kind.is_word}
        listed = {s.key: (numbers(s.value), bool(s.term)) for s in listed_steps(p, g)
                  if not s.kind.is_word and s.key not in repeated(p)}  # fmt: skip
        found.append((listed, {k: numbers(x) for k, x in asked.items()}))
    return found


def numbers(x):
    return [float(part) for part in flat(x)]


def same(x, y):
    size = max(map(abs, [*x, *y]))
    return size > 0 and len(x) == len(y) and math.dist(x, y) <= 1e-9 * size


def always(p, claim):
    return all(claim(*sheet) for sheet in sheets(p))


@pytest.mark.one_in(4)
@by_id
def test_no_step_is_an_answer(p):
    listed, asked = sheets(p)[0]
    for step, (_, is_term) in listed.items():
        for key in asked:
            assert not always(p, lambda s, a, n=step, k=key: n in s and same(s[n][0], a[k])), (
                f"the step {step} is the answer {key}"
            )
            assert is_term or not always(
                p, lambda s, a, n=step, k=key: n in s and same([-x for x in s[n][0]], a[k])
            ), f"the step {step} is the answer {key} but for its sign"


@by_chapter
def test_no_step_is_another_step(p):
    keys = list(sheets(p)[0][0])
    for n, one in enumerate(keys):
        for other in keys[:n]:
            assert (p.id, one) in SYMMETRIC or not always(
                p, lambda s, _, x=one, y=other: {x, y} <= set(s) and same(s[x][0], s[y][0])
            ), f"the step {one} is the step {other}"


FUNCTIONS = {"cosine": math.cos, "sine": math.sin, "tangent": math.tan, "square": lambda x: x * x}


@by_chapter
def test_no_step_leaves_only_a_key_of_the_calculator_to_press(p):
    """A step that is a function of one answer alone, such as its cosine, gives it away."""
    listed, asked = sheets(p)[0]
    scalars = [(n, k) for n, (x, _) in listed.items() for k, y in asked.items()
               if len(x) == len(y) == 1]  # fmt: skip
    for step, key in scalars:
        for name, f in FUNCTIONS.items():

            def gives_away(s, a, n=step, k=key, f=f):
                return n in s and any(a[k]) and same(s[n][0], [f(a[k][0])])

            assert not always(p, gives_away), f"the step {step} is the {name} of the answer {key}"


@by_chapter
def test_a_step_has_a_name_to_read(p):
    """A symbol or a word, not a formula stripped of its signs, such as BxC or dRdt."""
    for s in listed_steps(p, p.base(values(p, 1))):
        assert not re.search(r"[a-z][A-Z]|[A-Z]x[A-Z]|^to$", s.key.partition("_")[0]), s.key


def traced(x):
    """The traced numbers of a value that are computed, up to the sign."""
    parts = [] if isinstance(x, (str, int)) or callable(x) else flat(x)
    parts = [part.args[0] if getattr(part, "op", "") == "neg" else part for part in parts]
    return {part.number: part for part in parts if isinstance(part, Traced)}


@by_chapter
def test_no_step_is_computed_from_the_last_answer(p):
    """It may follow from an earlier answer, which leads to the next."""
    trace = Trace()
    g = p.base({n: trace.new("argument", n) for n in p.units})
    listed, asked = listed_steps(p, g), [traced(x) for x in p.code.solve(g).values()]
    given = traced([getattr(g, n) for n in p.units])
    given = before(given.values())
    last = next((set(x) - given for x in reversed(asked) if set(x) - given), None)
    for s in listed if last else ():
        found = traced(s.value)
        assert not last <= before(found.values()) - set(found), f"{s.key} is found from the answer"

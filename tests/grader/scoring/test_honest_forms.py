"""Right answers earn full points in whatever form they come: every form, over the chapter."""

import itertools

import pytest
import sympy

from exercises.catalogue import problems
from exercises.catalogue.variants import draw, evaluate
from grader.scoring import score_receipt
from newton_euler.answers.receipts import record

from .honest_forms import FORMULAS, NUMBERS, VECTORS, VECTORS_OF_FORMULAS

# NumPy advises against its matrix; students use it all the same
pytestmark = pytest.mark.filterwarnings("ignore:the matrix subclass:PendingDeprecationWarning")

KINDS = {
    "number": NUMBERS,
    "vector": VECTORS,
    "expression": FORMULAS,
    "vector_expression": VECTORS_OF_FORMULAS,
}
ASKED = {
    kind: [(p, a) for p in problems("ch04") for a in p.answers if a.kind.name == kind]
    for kind in KINDS
}
EVERY = [(kind, name, p, a) for kind in KINDS for name in KINDS[kind] for p, a in ASKED[kind]]
VALUES = {p.id: draw(p, b"honest forms") for p in problems("ch04")}


def in_form(kind, name, p, a):
    """The right answer in this form."""
    make = KINDS[kind][name]
    if not kind.endswith("expression"):
        key = [float(x) for x in evaluate(p, VALUES[p.id])[0][a.key]]
        return make(key[0] if kind == "number" else key)
    key = p.formulas()[a.key]
    symbol = p.sympy_symbols()[sorted(p.symbols)[0]]
    parts = [sympy.sympify(x) for x in (key if kind.startswith("vector") else [key])]
    return make(parts if kind.startswith("vector") else parts[0], symbol)


def verdict(kind, name, p, a):
    """ "right", or the message."""
    units = {n: s.unit for n, s in p.symbols.items()}
    answers, faults = record({a.key: a.form}, units, {a.key: in_form(kind, name, p, a)})
    receipt = {"answers": answers, "faults": faults}
    part = next(x for x in score_receipt(p, VALUES[p.id], receipt).parts if x.key == a.key)
    return part.message if part.points == 1 else f"{part.verdict}: {part.message}"


TURNS = {kind: itertools.cycle(ASKED[kind]) for kind in KINDS}
ONCE = [(kind, name, *next(TURNS[kind])) for kind in KINDS for name in KINDS[kind]]


@pytest.mark.parametrize(("kind", "name", "p", "a"), ONCE, ids=[f"{k}: {n}" for k, n, *_ in ONCE])
def test_a_right_answer_earns_its_points_in_this_form(kind, name, p, a):
    assert verdict(kind, name, p, a) == "right"


@pytest.mark.slow
@pytest.mark.parametrize("p", problems("ch04"), ids=lambda p: p.id)
def test_every_form_earns_its_points_in_every_problem_of_the_chapter(p):
    missed = [
        (kind, name, a.key, output)
        for kind, name, other, a in EVERY
        if other is p and (output := verdict(kind, name, p, a)) != "right"
    ]
    assert missed == []


@pytest.mark.parametrize("p", [p for p in problems("ch04") if not p.symbolic], ids=lambda p: p.id)
def test_an_answer_of_three_significant_figures_is_right_for_every_students_numbers(p):
    for n in range(100):
        values = draw(p, f"three figures {n}".encode())
        right = evaluate(p, values)[0]
        rounded = {a.key: [float(f"{x:.3g}") for x in right[a.key]] for a in p.answers}
        answers = {
            a.key: x if len(x) > 1 else x[0]
            for a, x in zip(p.answers, rounded.values(), strict=True)
        }
        score = score_receipt(p, values, {"answers": answers})
        assert score.points == score.out_of, (values, score)

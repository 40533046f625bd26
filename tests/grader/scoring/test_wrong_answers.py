"""Nearly right answers earn nothing: every problem of the chapter, fifty draws, every perturbation."""

import itertools
from collections import Counter

import pytest

from exercises.catalogue.variants import draw, evaluate
from grader.scoring import score_receipt
from grader.scoring.numbers import numbers_of
from newton_euler.answers.tolerance import NOISE
from tests.grader.scoring.answered import CH04, plain, right_trees

DRAWS = 50
NUMERIC = [p for p in CH04 if not p.symbolic]
SYMBOLIC = [p for p in CH04 if p.symbolic]


def with_component(vector, n, x):
    return [*vector[:n], x, *vector[n + 1 :]]


def perturbed(kind, right):
    """(perturbation, wrong answer) of a right answer: numbers, or trees."""
    vector = right if kind.is_vector else [right]
    sizes = [abs(x) if isinstance(x, float) else 0.0 if x == 0 else 1.0 for x in vector]
    for n, x in enumerate(vector):
        if sizes[n] <= NOISE * max(sizes):
            continue
        if kind.is_formula:
            yield "1.0001 times", with_component(vector, n, ["*", 1.0001, x])
            yield "turned", with_component(vector, n, ["*", -1, x])
        else:
            yield "0.6 % too much", [1.006 * y for y in vector]
            yield "turned", with_component(vector, n, -x)
        yield "dropped", with_component(vector, n, 0.0)
    for a, b in itertools.combinations(range(len(vector)), 2):
        swapped = with_component(with_component(vector, a, vector[b]), b, vector[a])
        if kind.name == "vector" and abs(vector[a] - vector[b]) > 0.01 * max(sizes):
            yield "swapped", swapped


def passed(p, values, right):
    """The perturbations that earn points."""
    tried = [(a, *x) for a in p.answers for x in perturbed(a.kind, right[a.key])]
    assert tried
    for a, name, wrong in tried:
        tree = wrong if a.kind.is_vector else wrong[0]
        if score_receipt(p, values, {"answers": {a.key: tree}}).points:
            yield name, a.key, values


@pytest.mark.one_in(3)
@pytest.mark.parametrize("p", NUMERIC, ids=lambda p: p.id)
def test_no_perturbed_number_or_vector_passes(p):
    for n in range(DRAWS):
        values = draw(p, f"wrong answers {n}".encode())
        right = evaluate(p, values)[0]
        assert not [*passed(p, values, {a.key: plain(right[a.key]) for a in p.answers})]


@pytest.mark.parametrize("p", SYMBOLIC, ids=lambda p: p.id)
def test_no_perturbed_formula_passes(p):
    assert not [*passed(p, {}, right_trees(p, {}))]


@pytest.mark.one_in(3)
@pytest.mark.parametrize("p", NUMERIC, ids=lambda p: p.id)
def test_the_books_answers_are_reported_and_earn_nothing(p):
    book = numbers_of(p, p.book_values).key
    for n in range(DRAWS):
        values = draw(p, f"wrong answers {n}".encode())
        own = numbers_of(p, values).key
        answers = {a.key: plain(book[a.key][0]) for a in p.answers}
        score = score_receipt(p, values, {"answers": answers})
        for a, part in zip(p.answers, score.parts, strict=True):
            if not a.kind.is_right(book[a.key], own[a.key], a.atol):
                assert part.points == 0
                assert "the answer for the book's numbers; yours are others" in part.message


@pytest.mark.parametrize(
    "p", [p for p in NUMERIC if any(g.vary for g in p.givens.values())], ids=lambda p: p.id
)
def test_a_neighbours_answers_rarely_pass(p):
    """A number within half a percent: by chance 1 % of a class, a whole problem 1 of 1000."""
    keys = [numbers_of(p, draw(p, f"neighbour {n}".encode())).key for n in range(DRAWS)]
    pairs = list(itertools.permutations(keys, 2))
    hits = Counter()
    for own, others in pairs:
        found = [a.kind.is_right(others[a.key], own[a.key], a.atol) for a in p.answers]
        hits.update(a.key for a, hit in zip(p.answers, found, strict=True) if hit)
        hits["whole problem"] += all(found)
    assert max(hits[a.key] for a in p.answers) <= 0.012 * len(pairs)
    assert hits["whole problem"] <= 0.002 * len(pairs)

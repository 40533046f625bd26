"""The wrong model behind a wrong answer: named if only one fits, never for a right answer."""

import math
from collections import Counter

import numpy as np
import pytest

from exercises.catalogue import problem
from exercises.catalogue.variants import SEPARATION, draw, evaluate, flat
from exercises.catalogue.wording import term_text
from grader.scoring import score_receipt
from grader.scoring.numbers import Numbers
from newton_euler.algebra.ledger import Crossed, equation
from newton_euler.algebra.vectors import Vector
from newton_euler.answers import tolerance
from tests.grader.scoring.answered import CH04, judged, texts, trees

DATA = ("book", "variant")


def values(p, data):
    return p.book_values if data == "book" else draw(p, b"tests of diagnosis")


def listed(p, given):
    """[(mistake, key, the student's tree)] of a problem's YAML, computed with symbols."""
    wrong = p.code.mistakes(p.base({**p.sympy_symbols(), **given}))
    return [
        (name, key, trees(p, p.in_units({key: v}))[key])
        for name, answers in wrong.items()
        for key, v in answers.items()
    ]


def part_of(p, given, key, tree):
    return judged(p, {key: tree}, given)[key]


def numbers_of(p, given):
    """Key and mistakes as arrays (components, points), to see which mistakes give the same."""
    right, wrong = evaluate(p, Numbers(p, given).sample)

    def rows(answers):
        stacked = {k: np.stack(np.broadcast_arrays(*v)) for k, v in answers.items()}
        return {k: v.astype(float).reshape(len(v), -1) for k, v in stacked.items()}

    return rows(right), {m: rows(w) for m, w in wrong.items()}


def twins(wrong, name, key, tolerance):
    """Other listed mistakes that give the same numbers, within what a student may round."""
    mine = wrong[name][key]
    near = 2 * tolerance * np.linalg.norm(mine)
    others = {m: w[key] for m, w in wrong.items() if m != name and key in w}
    return [m for m, x in others.items() if np.linalg.norm(x - mine) <= near]


CASES = [(p, data) for p in CH04 for data in DATA]
IDS = [f"{p.id} {data}" for p, data in CASES]


@pytest.mark.parametrize(("p", "data"), CASES, ids=IDS)
def test_every_listed_mistake_earns_nothing_and_is_named_without_a_number_of_the_key(p, data):
    given = values(p, data)
    right, wrong = numbers_of(p, given)
    numerals = {f"{abs(x):.4g}" for v in right.values() for x in v.flat}
    for name, key, tree in listed(p, given):
        part = part_of(p, given, key, tree)
        assert (part.points, part.verdict) == (0, "wrong"), (name, key)
        assert not [n for n in numerals if len(n) > 4 and n in (part.diagnosis or "")], name
        is_formula = p.answer(key).kind.is_formula
        same = twins(wrong, name, key, tolerance.FORMULA_RTOL if is_formula else tolerance.RTOL)
        if not same:
            assert texts(part)[0] == p.mistakes[name], (name, key)
            assert {c.group for c in part.causes[1:]} <= {"term"}, (name, key)
            assert part.message == f"not right; it fits a solution that {part.diagnosis}"
        else:  # several fit: all are named, or those that fit better
            own = {c.text for c in part.causes if c.group == "listed"}
            assert own <= {p.mistakes[m] for m in (name, *same)}, name
            assert p.mistakes[name] in texts(part), (name, key)


@pytest.mark.parametrize(("p", "data"), CASES, ids=IDS)
def test_a_right_answer_never_gets_a_diagnosis_even_when_rounded(p, data):
    given = values(p, data)
    right = trees(p, p.solve({**p.sympy_symbols(), **given}))
    for part in score_receipt(p, given, {"answers": right}).parts:
        assert (part.verdict, part.diagnosis) == ("right", None)
    if not p.symbolic:
        rounded = {
            k: [float(f"{x:.3g}") for x in v] if isinstance(v, list) else float(f"{v:.3g}")
            for k, v in right.items()
        }
        for part in score_receipt(p, given, {"answers": rounded}).parts:
            assert part.diagnosis is None
            assert part.points


def vectors(kind="vector"):
    return [(p, a) for p in CH04 for a in p.answers if a.kind.name == kind]


def diagnosed(p, a, given, value):
    """The part of a Vector or numbers handed in for answer ``a``."""
    value = list(flat(value)) if a.kind.name == "vector" else value
    return part_of(p, given, a.key, trees(p, {a.key: value})[a.key])


@pytest.mark.parametrize(("p", "a"), vectors(), ids=[f"{p.id} {a.key}" for p, a in vectors()])
def test_a_term_left_out_or_turned_is_named_from_the_ledger_or_a_listed_mistake(p, a):
    given = values(p, "variant")
    right = p.solve(given)[a.key]
    if not isinstance(right, Vector) or not right.terms:
        pytest.skip("no named terms")
    whole = math.hypot(*flat(right))
    candidates, (_, wrong) = {}, numbers_of(p, given)
    for m, answers in wrong.items():
        if a.key in answers:
            candidates[m, "listed"] = tuple(answers[a.key][:, 0])
    for name, factor in [(n, f) for n in right.terms for f in (0, -1)]:
        candidates[name, factor] = tuple(map(float, flat(right.reweighted(**{name: factor}))))
    for (name, factor), numbers in candidates.items():
        if factor == "listed" or math.dist(numbers, flat(right)) < 1.1 * SEPARATION * max(
            whole, math.hypot(*numbers)
        ):
            continue  # this term is too small to be missed
        part = diagnosed(p, a, given, numbers)
        assert part.points == 0
        near = 2 * tolerance.RTOL * math.hypot(*numbers)
        alike = [n for n, w in candidates.items() if math.dist(w, numbers) <= near]
        assert part.diagnosis or len(alike) > 1, (name, factor)


def in_degrees(p):
    return [name for name, q in p.givens.items() if q.unit.startswith(("deg", "rev"))]


@pytest.mark.parametrize("p", [*filter(in_degrees, CH04)], ids=lambda p: p.id)
def test_angles_and_rates_used_in_degrees_are_reported(p):
    given = values(p, "variant")
    found, g = 0, p.base(given)
    for name in in_degrees(p):
        wrong = p.in_units(p.code.solve(g.but(**{name: g.stated(name)})))
        parts = [diagnosed(p, a, given, wrong[a.key]) for a in p.answers]
        found += sum(part.diagnosis is not None for part in parts if not part.points)
    assert found


def test_the_components_in_another_frame_and_a_transposed_rotation_are_reported():
    found = Counter()
    for p, a in vectors():
        given = values(p, "variant")
        right = p.solve(given)[a.key]
        if not isinstance(right, Vector):
            continue
        for frame in right.frame.tree:
            here, there = flat(right), tuple(map(float, right.components(frame)))
            back = tuple(map(float, Vector(right.c, frame).components(right.frame)))
            for numbers in (there, back):
                if math.dist(here, numbers) > 1.1 * SEPARATION * math.hypot(*here):
                    part = diagnosed(p, a, given, numbers)
                    assert part.points == 0
                    found[part.diagnosis is not None] += 1
    assert found[True] >= 0.95 * sum(found.values()) > 0


def test_terms_are_named_in_the_words_of_the_problem():
    turning, growing = equation("angular velocity"), equation("angular acceleration")
    coriolis = "the Coriolis term 2 omega x v_r"
    assert term_text("coriolis", equation("acceleration")) == coriolis
    assert term_text("arm", turning) == "the turning of the arm"
    assert term_text("A", turning) == "the turning of A"
    assert term_text("about y", turning) == "the turning about y"
    assert term_text("arm", growing) == "the rate of the turning of the arm"
    both = "the cross product of the turning of the arm and the turning of the rod"
    assert term_text(Crossed("arm", "rod"), growing) == both
    assert term_text("2 x 4 x 8", growing) == "the rate of the turning of the 2 x 4 x 8"
    assert term_text("u''", equation("curvilinear acceleration")) == "the term u''"


def test_neither_an_origin_nor_a_frame_without_a_name_is_named():
    for kind in ("velocity", "acceleration"):
        text = term_text("origin", equation(kind))
        assert text == f"the {kind} of the origin of the moving frame"
    # 4/3 speaks of a base and two arms, its solution of a house and a boom
    output = [c.text for c, _ in Numbers(problem("4/3"), problem("4/3").book_values).wrong("a")]
    assert not [t for t in output if "house" in t or "boom" in t]
    assert any("another frame" in t for t in output)


@pytest.mark.parametrize(("number", "key"), [("4/16", "alpha_CD"), ("4/28", "alpha_panel")])
def test_a_cause_that_the_right_parts_contradict_is_named_in_this_part(number, key):
    """A rate taken the other way would also show in the velocity: a sign is likelier."""
    p = problem(number)
    given = values(p, "variant")
    right = trees(p, p.solve(given))
    turned = {**right, key: [-x for x in right[key]]}
    parts = judged(p, turned, given)
    other = {"4/16": "beta_the_other_way", "4/28": "panels_the_other_way"}[number]
    assert "sign" in texts(parts[key])[0]
    assert texts(parts[key])[1:] == [f"in this part {p.mistakes[other]}"]
    assert p.mistakes[other] in texts(part_of(p, given, key, turned[key]))


def test_a_listed_mistake_in_one_part_is_said_before_another_number_that_fits():
    """7/26: 2*m*r^2 of the ring, with the half ring right, is also a factor that is left out."""
    p = problem("7/26")
    m, r = p.sympy_symbols().values()
    right = trees(p, p.solve(p.sympy_symbols()))
    ring = trees(p, {**p.solve(p.sympy_symbols()), "I_ring": 2 * m * r**2})["I_ring"]
    part = judged(p, {**right, "I_ring": ring}, {})["I_ring"]
    assert "in this part uses m*r^2, of the axis normal to the plane" in part.message


PANEL = lambda v: v.components(v.frame.tree[2])


@pytest.mark.parametrize(("key", "change", "words"), [
    ("a_A", lambda a: flat(a.without("relative")), "leaves out the acceleration relative to the m"),
    ("v_A", PANEL, "axes of the panel"),
])  # fmt: skip
def test_a_slip_in_one_part_is_named_where_the_others_are_right(key, change, words):
    p = problem("4/28")
    given = values(p, "variant")
    right = p.solve(given)
    answers = {**trees(p, right), key: [float(x) for x in change(right[key])]}
    assert words in judged(p, answers, given)[key].diagnosis


def test_a_times_n_alone_in_4_1_is_more_than_a_unit_slip():
    """It also leaves out the axial speed."""
    p = problem("4/1")
    for seed in (b"a", b"b", b"c", b"d"):
        given = draw(p, seed)
        told_of = texts(part_of(p, given, "speed", given["a"] * given["n"]))
        assert p.mistakes["circular_only"] in told_of
        assert not [t for t in told_of if t.startswith("uses n")]

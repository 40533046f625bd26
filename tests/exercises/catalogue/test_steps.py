"""The steps on the way to the answers, and the worked solution made from them."""

from types import SimpleNamespace

import pytest
import sympy

from exercises.catalogue import CatalogueError, problem, select
from exercises.catalogue.checks import check
from exercises.catalogue.steps import Step, faults, repeated, steps
from exercises.catalogue.variants import draw
from newton_euler import Vector

ALL = select(["all"])
# for every symbol
AT = dict.fromkeys({x for p in ALL for x in p.sympy_symbols().values()}, 0.7)


def shown(p, values):
    return {s.key: s for s in steps(p, values)}


def test_steps_of_4_16_are_in_the_units_and_axes_of_the_answers():
    p = problem("4/16")
    found = shown(p, p.book_values)
    assert list(found)[:2] == ["omega_CD", "v_r"]
    # the shaft turns with 0.6 about Z; beta grows about -X at 0.45
    assert [float(x) for x in found["omega_CD"].value.c] == pytest.approx([-0.45, 0, 0.6])
    # 16 mm * 0.45 rad/s, perpendicular to CD at 120 degrees
    assert [float(x) for x in found["v_r"].value.c] == pytest.approx([0, 7.2 * 3**0.5 / 2, -3.6])
    assert found["a_D_coriolis"].equation == "4.18"
    assert "2 omega x v_r" in found["a_D_coriolis"].means


def test_terms_have_their_equation_of_the_chapter_and_words_for_their_coordinates():
    p = problem("2/27")
    found = shown(p, p.book_values)
    assert found["a_B_euler"].equation == "2.25"  # the engine has it as (4.18)
    assert found["a_B_euler"].means == "the term alpha x r, in a_B"
    p = problem("2/20")
    assert shown(p, p.book_values)["a_euler"].means == "the Euler term r theta'' e_theta, in a"
    p = problem("3/26")
    texts = [s.means for s in steps(p, p.book_values)]
    assert any(text.startswith("the Coriolis term of theta and phi, -2 R theta'") for text in texts)


@pytest.mark.one_in(6)
@pytest.mark.parametrize("p", ALL, ids=lambda p: p.id)
def test_the_terms_among_the_steps_add_up_to_the_answers(p):
    values = {**draw(p, b"steps"), **p.sympy_symbols()}
    answers, found = p.solve(values), steps(p, values)
    for key, answer in answers.items():
        own = [s.value for s in found if s.term and s.key.startswith(f"{key}_")]
        if not (own and getattr(answer, "terms", None)):
            continue
        for n in range(3):
            gap = sympy.sympify(sum(v.c[n] for v in own) - answer.c[n])
            size = max(abs(complex(sympy.N(x, subs=AT))) for x in answer.c)
            assert abs(complex(sympy.N(gap, subs=AT))) <= 1e-9 * size


def with_steps(monkeypatch, *found):
    p = problem("4/16")
    monkeypatch.setattr(p.code, "steps", lambda g: [f(g) for f in found])
    return p


def test_a_step_with_the_name_of_an_answer_or_a_given_is_refused(monkeypatch):
    for key in ("a_D", "omega", "not a name"):
        p = with_steps(monkeypatch, lambda g, key=key: Step(key, g.omega, "rad/s", "the rate"))
        with pytest.raises(CatalogueError, match=f"4/16: the step {key!r} needs a name"):
            steps(p, p.book_values)


def test_a_step_stated_in_a_wrong_unit_is_a_fault_of_the_problem(monkeypatch):
    p = with_steps(monkeypatch, lambda g: Step("rate", g.omega * g.b, "rad/s", "the rate"))
    assert faults(p, p.book_values) == ["the step rate is stated in rad/s (1/s), but has m/s"]
    p = with_steps(monkeypatch, lambda g: Step("rate", g.omega * g.b, "rad/s", "the rate"))
    assert check(p) == [f"{fault} (seed 0)" for fault in faults(p, p.book_values)]
    p = with_steps(monkeypatch, lambda g: Step("rate", g.omega + g.b, "rad/s", "the rate"))
    assert "steps adds unlike quantities" in check(p)[0]


def test_a_step_says_its_kind_and_has_its_form(monkeypatch):
    kinds = lambda name: [s.kind.name for s in steps(problem(name), problem(name).book_values)]
    assert kinds("A/4") == ["number"] * 2  # whole numbers, but only for the book's numbers
    assert set(kinds("5/24")) == {"count"}
    assert set(kinds("7/3")) == {"number", "vector", "matrix"}
    rows = lambda g: ((g.b, 0, 0), (0, g.b, 0), (0, 0, g.b))
    p = with_steps(monkeypatch, lambda g: Step("rows", rows(g), "mm", "a matrix"))
    assert faults(p, p.book_values) == ["the step rows is not a number: name its kind"]
    p = with_steps(monkeypatch, lambda g: Step("rows", rows(g), "mm", "a matrix", kind="matrix"))
    assert faults(p, p.book_values) == []


def test_a_step_that_is_an_answer_and_a_term_that_is_a_step_are_not_asked_for(monkeypatch):
    p = problem("4/16")
    D = lambda g: p.code.solve(g)["v_D"]
    term = lambda g, name: D(g).terms[name]
    asked_as = lambda g, name: {"term": (name, D(g).equation)}
    p = with_steps(
        monkeypatch,
        lambda g: Step("all", 1 * D(g), "mm/s", "velocity of D"),
        lambda g: Step("part", term(g, "relative"), "mm/s", "velocity of D in BC"),
        lambda g: Step("again", term(g, "relative"), "mm/s", "v_D", **asked_as(g, "relative")),
        lambda g: Step("turn", term(g, "rotation"), "mm/s", "v_D", **asked_as(g, "rotation")),
    )
    repeated.cache_clear()
    found = repeated(p)
    repeated.cache_clear()
    assert found == {"all", "again"}


def test_a_step_of_the_text_that_is_an_answer_is_a_fault(monkeypatch):
    p = problem("8/4")
    key = next(iter(p.steps))
    answer = lambda g: next(x for x in p.code.solve(g).values() if isinstance(x, Vector))
    monkeypatch.setattr(p.code, "steps", lambda g: {key: 2 * answer(g) / 2})
    repeated.cache_clear()
    found = faults(p, p.book_values)
    repeated.cache_clear()
    assert f"the step {key} is an answer" in found


def test_steps_in_code_and_text_are_the_same(monkeypatch):
    p = problem("8/3")
    monkeypatch.setattr(p.code, "steps", lambda g: {"m": g.W / g.g, "I_G": g.W / g.g * g.L**2})
    assert faults(p, p.book_values) == ["the step a_G is in p03.yaml but not computed"]
    monkeypatch.setattr(p.code, "steps", lambda g: {"a_C": g.g})
    faults_found = "8/3: the step 'a_C' is computed but not in p03.yaml; did you mean a_G?"
    assert faults(p, p.book_values) == [faults_found]


def proving(monkeypatch, **found):
    """4/16, whose proof also gives these steps, multiplied by the rates of the problem."""
    p = problem("4/16")
    prove = p.code.prove
    also = {key: (lambda g, f=f: f(g)) for key, f in found.items()}
    monkeypatch.setattr(p.code, "prove", lambda g: prove(g) | {k: f(g) for k, f in also.items()})
    return p


def test_a_step_that_the_proof_finds_too_is_compared_and_what_nobody_asks_for_is_a_fault(
    monkeypatch,
):
    assert check(proving(monkeypatch, omega_CD=lambda g: [-g.b_dot, 0, g.omega]), 2) == []
    wrong = proving(monkeypatch, omega_CD=lambda g: [g.b_dot, 0, g.omega])
    assert "omega_CD: the step in floats and prove differ by 1.2e+00 of its size" in check(wrong)[0]
    faults_found = check(proving(monkeypatch, omega_AB=lambda g: g.omega))
    assert faults_found == [
        "prove returns omega_AB, which is neither asked for nor one of the steps (seed 0)"
    ]


def test_a_problem_without_sums_has_no_steps_of_its_own():
    p = SimpleNamespace(id="0/1", code=SimpleNamespace(solve=lambda g: {"x": 2.0}), units={},
                        answers=(), step_texts={}, base=lambda values, one: None)  # fmt: skip
    assert steps(p, {}) == []

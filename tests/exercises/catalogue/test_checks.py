"""A problem broken in one of the ways in which problems break is caught by ``check``."""

import itertools
import re

import pytest

from exercises import problem
from exercises.catalogue import variants
from exercises.catalogue.checks import alike, check
from exercises.catalogue.following import earlier_answers
from exercises.catalogue.units import in_frame
from newton_euler import Frame, pi
from newton_euler.algebra import FrameError

P = problem("4/16")
SOLVE, PROVE, MISTAKES = P.code.solve, P.code.prove, P.code.mistakes


@pytest.fixture
def tamper(monkeypatch):
    """A function that replaces functions of 4/16's code and returns the faults that check finds."""

    def put(**functions):
        for name, function in functions.items():
            monkeypatch.setattr(P.code, name, function)
        variants._compiled.cache_clear()
        earlier_answers.cache_clear()
        return check(P, seeds=2)

    yield put
    monkeypatch.undo()
    variants._compiled.cache_clear()
    earlier_answers.cache_clear()


def changed(results, **changes):
    return {key: changes[key](x) if key in changes else x for key, x in results.items()}


def test_the_untouched_problem_is_found_good(tamper):
    assert tamper() == []


def test_a_wrong_sign_a_dropped_term_and_a_misread_angle_are_caught(tamper):
    (fault, *_) = tamper(solve=lambda g: SOLVE(g.but(omega=-g.omega)))
    assert fault.startswith(
        "alpha_CD: solve in floats and prove differ by 2.0e+00 of its size: (0, 0.27, 0) against ("
    )
    faults = tamper(solve=lambda g: changed(SOLVE(g), a_D=lambda a: a.without("coriolis")))
    assert [fault.partition(" by ")[0] for fault in faults[:2]] == [
        "a_D: solve in floats and prove differ",
        "a_D: solve in 50 digits and prove differ",
    ]
    assert faults[2].startswith("the mistake no_coriolis gives nearly the right a_D")
    assert all(fault.endswith(" (seed 0)") for fault in faults)
    faults = tamper(solve=lambda g: SOLVE(g.but(beta_1=g.beta_1 + pi(g.beta_1) / 6)))
    assert {fault.partition(":")[0] for fault in faults if " prove " in fault} == {"v_D", "a_D"}


def solved(**changes):
    """``solve`` with some answers changed."""
    return {"solve": lambda g: changed(SOLVE(g), **changes)}


def mistaken(change):
    """``mistakes`` changed by a function of the right ones and the givens."""
    return {"mistakes": lambda g: change(MISTAKES(g), g)}


def renamed(wrong, g):
    return {"no_coriolis_term" if n == "no_coriolis" else n: m for n, m in wrong.items()}


@pytest.mark.parametrize(("functions", "fault"), [
    (solved(v_D=lambda v: v * (1 + 2**-36)), "v_D: solve in 50 digits and prove differ by 1.5e-11"),
    ({"prove": lambda g: changed(PROVE(g), v_D=lambda v: [-x for x in v])}, "v_D: solve in floats and prove differ"),
    ({"solve": lambda g: changed(SOLVE(g), v_D=lambda v: v + v.frame.i * g.L)}, "solve adds unlike quantities: cannot add "),
    ({"solve": lambda g: changed(SOLVE(g), v_D=lambda v: v * g.omega)}, "v_D is asked for in mm/s (m/s), but solve gives m/s^2"),
    (solved(v_D=lambda v: v.frame.vector(1.0, 0, 0)), "v_D is asked for in mm/s (m/s), but solve gives 1.0"),
    ({"solve": lambda g: dict(reversed(SOLVE(g).items()))}, "solve returns ['a_D', 'v_D', 'alpha_CD'] but the problem asks for ['alpha_CD', 'v_D', 'a_D']"),
    ({"prove": lambda g: {"alpha_CD": PROVE(g)["alpha_CD"]}}, "prove returns ['alpha_CD'] but"),
    (mistaken(lambda wrong, g: {n: m for n, m in wrong.items() if n != "no_coriolis"}), "the mistake no_coriolis is in p16.yaml but not computed"),
    (mistaken(renamed), "the mistake no_coriolis_term is computed but not in p16.yaml"),
    (mistaken(lambda wrong, g: {**wrong, "no_coriolis": {"a_C": wrong["no_coriolis"]["a_D"]}}), "the mistake no_coriolis must give some of ['alpha_CD', 'v_D', 'a_D'], but gives ['a_C']"),
    (mistaken(lambda wrong, g: {**wrong, "no_coriolis": {"a_D": SOLVE(g)["a_D"]}}), "the mistake no_coriolis gives nearly the right a_D: ("),
    ({"follows": {"a_D": lambda g, alpha_CD: 2 * alpha_CD}}, "a_D does not follow from alpha_CD: follows gives ("),
    ({"follows": {"a_D": lambda g, alpha: alpha}}, "follows has alpha; the problem asks for alpha_CD, v_D, a_D; did you mean alpha_CD? (seed 0)"),
])  # fmt: skip
def test_a_fault_is_caught(tamper, functions, fault):
    assert any(found.startswith(fault) for found in tamper(**functions))


def test_a_mistake_under_the_key_of_another_answer_gives_a_warning(monkeypatch):
    stored = lambda wrong, g: {**wrong, "no_coriolis": {"v_D": wrong["no_coriolis"]["a_D"]}}
    monkeypatch.setattr(P.code, "mistakes", mistaken(stored)["mistakes"])
    message = "the mistake no_coriolis gives v_D the dimension of a_D: is it stored under its key?"
    assert message in alike(P)


@pytest.mark.parametrize("names", [itertools.repeat("arm"), map("arm {}".format, range(99))])
def test_frames_of_another_call_in_the_tree_of_an_answer_are_a_fault(tamper, names):
    ground = Frame("ground")  # as if made by the module

    def solve(g):
        D = ground.rotate(next(names), "z", rate=g.omega).point("D", g.b, 0, 0)
        return {**SOLVE(g), "v_D": D.velocity(ground)}

    fault, *_ = tamper(solve=solve)
    assert re.match(r"v_D has the frame arm.* of an earlier call in its tree", fault)


@pytest.mark.parametrize("name", ["rod", "ground"])
def test_a_mistake_in_other_axes_is_caught_whatever_their_name(tamper, name):
    def in_turned_axes(g):
        a = MISTAKES(g)["no_coriolis"]["a_D"]
        turned = a.frame.rotate(name, "x", angle=0.5)
        assert in_frame(a.frame, a.expressed_in(turned)).frame is a.frame
        return {**MISTAKES(g), "no_coriolis": {"a_D": a.expressed_in(turned)}}

    (fault,) = tamper(mistakes=in_turned_axes)
    assert fault == f"a_D is in ground, but the mistake no_coriolis has it in {name}: use in_frame"


def test_frames_of_one_name_in_one_parent_are_told_apart_by_their_order():
    def vectors():
        ground = Frame("ground")
        return [ground.rotate("arm", "z", angle=x).vector(1.0, 0, 0) for x in (0.5, 1.0)]

    (first, second), (one, other) = vectors(), vectors()
    assert in_frame(first.frame, one) is one
    assert in_frame(second.frame, other) is other
    with pytest.raises(FrameError):  # they share no frame
        in_frame(second.frame, one)

"""Forces, couples, and their moments: (8.4)-(8.7), (8.20), (8.21)."""

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from newton_euler import Couple, Dimension, Force, ForceSystem, Frame, compiled, solve_linear
from newton_euler.algebra import FrameError
from newton_euler.algebra.errors import ArgumentError
from newton_euler.dynamics import ForceError
from tests.kinds import close, every_kind, numbers, within

triples = st.tuples(*[st.floats(-10, 10)] * 3)
ground = Frame("ground")
small = within(1e-13, 26)


def system(kind):
    """Three forces and a couple, in the ground and in a frame turned and displaced from it."""
    shop = Frame("ground")
    angle, x, y, z = numbers(kind, "0.3", 1, -2, "1/2")
    bench = shop.rotate("bench", "z", angle=angle, origin=shop.point("bench", x, y, z))
    parts = {
        "weight": (shop.vector(0 * x, 0 * y, -9 + 0 * z), shop.point("G", y, z, x)),
        "rope": (bench.vector(x, y, z), bench.point("A", z, x, y)),
        "push": Force(shop.vector(z, z, x), shop.point("B", x, x, y)),
        "motor": Couple(bench.vector(y, x, 2 * x)),
    }
    return shop, bench, ForceSystem(parts, shop)


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


@every_kind
def test_eqn_8_4_to_8_8_the_moment_about_any_point_is_the_sum_of_d_cross_f(kind):
    shop, bench, s = system(kind)
    C = bench.point("C", *numbers(kind, 2, "1/3", -1))
    c = C.position(shop).components()
    total = s.parts[3].vector.components(shop)
    for part in s.parts[:3]:
        d = [p - q for p, q in zip(part.point.position(shop).components(), c, strict=True)]
        total = [t + m for t, m in zip(total, cross(d, part.vector.components(shop)), strict=True)]
    M = s.moment(C)
    assert close(M, total, small(kind))
    assert list(M.terms) == ["weight", "rope", "push", "motor"]
    assert close(
        sum((M.terms[n] for n in ("rope", "push", "motor")), M.terms["weight"]), M, small(kind)
    )
    assert list(s.force.terms) == ["weight", "rope", "push"]


@every_kind
def test_eqn_8_5_and_8_6_forces_between_two_points_along_their_line_have_no_moment(kind):
    shop, bench, s = system(kind)
    P, Q = s.parts[0].point, s.parts[1].point
    f = (P - Q).expressed_in(shop) * numbers(kind, "7/3")
    pair = ForceSystem({"on P": (f, P), "on Q": (-f, Q)}, shop)
    assert close(pair.force, (0, 0, 0), small(kind))
    assert close(pair.moment(bench), (0, 0, 0), 10 * small(kind))


@every_kind
def test_eqn_8_20_a_force_moves_with_the_couple_of_its_moment(kind):
    shop, bench, s = system(kind)
    force, C = s.parts[1], bench.point("C", *numbers(kind, 2, "1/3", -1))
    moved = force.moved(C)
    for about in (shop.origin, C, s.parts[0].point):
        assert close(moved.moment(about), force.moment(about), 10 * small(kind))
    assert close(moved.force, force.vector, small(kind))
    assert moved.parts[1].name == "couple of rope"


@settings(max_examples=60)
@given(triples, triples, triples, triples, triples)
def test_systems_with_one_resultant_and_one_moment_are_equivalent(a, b, p, q, c):
    A, B, C = (ground.point(n, *x) for n, x in zip("ABC", (p, q, c), strict=True))
    s = ForceSystem([(ground.vector(*a), A), (ground.vector(*b), B)])
    assert s.equivalent(s.at(C))
    assert s.at(A).equivalent(s.at(B))


@settings(max_examples=30)
@given(triples, triples, triples)
def test_a_different_moment_is_not_equivalent(a, p, c):
    assume(np.linalg.norm(a) > 1e-2)
    A, C = ground.point("A", *p), ground.point("C", *c)
    assume(np.linalg.norm(np.cross(np.subtract(c, p), a)) > 1e-3)
    F = ground.vector(*a)
    assert not ForceSystem([(F, A)]).equivalent(ForceSystem([(F, C)]))
    assert not ForceSystem([(F, A)]).equivalent(ForceSystem([(F * 1.1, A)]))


def test_a_system_without_forces_has_a_frame_and_a_text():
    nothing = ForceSystem([], frame=ground)
    assert (nothing.force.norm(), str(nothing)) == (0, "no forces")


def test_forces_may_hold_unknowns():
    """The forces in three legs that carry a table are unknowns in the equations of equilibrium."""
    legs = [ground.point("leg", *x, 0) for x in ((0, 0), (2.0, 0), (0, 3.0))]
    weight = ground.vector(0, 0, -60.0), ground.point("G", 0.5, 1.0, 0)

    def balance(A, B, C):
        held = [(ground.vector(0, 0, f), P) for f, P in zip((A, B, C), legs, strict=True)]
        s = ForceSystem([*held, weight], ground)
        return {"force": s.force, "moment": s.moment(legs[0])}

    assert close(tuple(solve_linear(balance)), (25, 15, 20), 1e-12)


def test_moments_can_be_compiled_and_have_the_unit_of_force_times_length():
    def moment(F, x):
        here = Frame("here")
        return ForceSystem([(here.vector(F, 0, F), here.point("A", x, x, 0))]).moment(
            here.point("O", 0, 0, 0)
        )

    assert compiled(moment)(2.0, 3.0) == tuple(moment(2.0, 3.0))
    force, length = Dimension(1, 1, -2), Dimension(0, 1)
    assert all(x == force * length for x in moment(force, length) if x != 0)


@pytest.mark.parametrize(("ask", "error", "words"), [
    (lambda: ForceSystem([3]), ForceError, r"a force is a pair \(Vector, Point\), a couple Couple\(Vector\); got 3"),
    (lambda: ForceSystem([(2.0, ground.origin)]), FrameError, "Force: vector is a Vector"),
    (lambda: ForceSystem({"wind": (ground.i, "there")}), FrameError, "the place of wind is a Point or a Frame"),
    (lambda: Force(ground.i, ground.origin, 1j), ArgumentError, "Force: name is a text; got 1j"),
    (lambda: Couple(ground.i, ()), ArgumentError, "Couple: name is a text"),
    (lambda: ForceSystem([]), ForceError, "a system without forces needs a frame"),
    (lambda: ForceSystem([(ground.i, ground)]).moment("A"), FrameError,
     "the place of the point that the moment is about is a Point or a Frame"),
])  # fmt: skip
def test_what_is_not_a_force_is_refused_in_words(ask, error, words):
    with pytest.raises(error, match=words):
        ask()

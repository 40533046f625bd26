"""Chapter 4 against explicit motion: rotation matrices multiplied out and differentiated
numerically in 50 digits.

The oracle has the position matrices as functions of time, and :mod:`tests.turning` to differentiate
them.
"""

import gc
import math
import random
import warnings
import weakref
from functools import cache
from itertools import combinations, pairwise

import mpmath
import numpy as np
import pytest
import sympy
from hypothesis import given, settings
from hypothesis import strategies as st
from mpmath import mp, mpf

from newton_euler import Dimension, Frame, Vector, at, cos, cross, moving, pi, sin
from newton_euler.algebra import FrameError, ScalarError, same
from newton_euler.kinematics import AngleWarning, along
from tests.explicit import curve, motion
from tests.kinds import KINDS, close, compiled_by, every_kind, number, numbers, within
from tests.turning import DIGITS, angular_acceleration, angular_velocity, rate, rot, second_rate
from tests.turning import cross as cross50

ground = Frame("ground")
# the factors by which tests.kinds scales a number, instant by instant
SCALES = {"float": (1.0,), "array": (1.0, 1.0625, 0.875), "mpmath": (1,), "sympy": (1,)}
FAST_KINDS = ("float", "array", "mpmath")
AXES = ["x", "y", "z", "-x", "-y", "-z", (1, 1, 1), (1, 2, -2), (0, 3, 4), (-2, 1, 1)]


def decimals(rng, count, largest=2.0):
    return [round(rng.uniform(-largest, largest), 2) for _ in range(count)]


def random_tree(seed, count):
    """Each frame hangs on an earlier one, mostly the last, with any axis and a moving origin."""
    rng, tree = random.Random(seed), []
    for n in range(count):
        parent = n if rng.random() < 0.7 else rng.randrange(n + 1)
        tree.append({"parent": parent, "axis": rng.choice(AXES), "angle": decimals(rng, 3)})
        tree[n]["origin"] = None if rng.random() < 0.2 else [decimals(rng, 3) for _ in range(3)]
    return tree


def chain(seed, count):
    return [{**s, "parent": n} for n, s in enumerate(random_tree(seed, count))]


def in_engine(tree, kind, faster=1):
    """The frames of a tree, ground first; ``faster`` multiplies all angles."""
    coordinate = lambda v: moving(*numbers(kind, *v))
    frames = [Frame("f0")]
    for n, s in enumerate(tree, start=1):
        parent = frames[s["parent"]]
        origin = s["origin"] and parent.point(f"O{n}", *map(coordinate, s["origin"]))
        axis = s["axis"]
        if not isinstance(axis, str) and kind == "sympy":
            axis = tuple(map(sympy.Integer, axis))
        frames.append(parent.rotate(f"f{n}", axis, faster * coordinate(s["angle"]), origin=origin))
    return frames


class Explicit:
    """The same tree: orientation R(n, t) and origin X(n, t) of each frame in the ground."""

    def __init__(self, tree, scale=1):
        self.tree, self.scale = tree, mpf(scale)
        self.R, self.X = cache(self.R), cache(self.X)  # each frame above asks for them again

    def course(self, v, t):
        value, rate_, acceleration = (mpf(str(x)) * self.scale for x in v)
        return value + rate_ * t + acceleration * t * t / 2

    def column(self, x, t):
        return mpmath.matrix([self.course(v, t) for v in x] if x else [0, 0, 0])

    def R(self, n, t):
        if n == 0:
            return mp.eye(3)
        s = self.tree[n - 1]
        axis, angle = s["axis"], self.course(s["angle"], t)
        if isinstance(axis, str):
            axis, angle = axis[-1], -angle if "-" in axis else angle
        return self.R(s["parent"], t) * rot(axis, angle)

    def X(self, n, t):
        if n == 0:
            return mpmath.matrix([0, 0, 0])
        s = self.tree[n - 1]
        return self.X(s["parent"], t) + self.R(s["parent"], t) * self.column(s["origin"], t)

    def between(self, n, m):
        """Orientation of frame n in frame m."""
        return lambda t: self.R(m, t).T * self.R(n, t)

    def seen(self, n, x, m):
        """Position from the origin of frame m, in its components, of the point x of frame n."""
        return lambda t: (
            self.R(m, t).T * (self.X(n, t) + self.R(n, t) * self.column(x, t) - self.X(m, t))
        )

    def turned(self, n, x, m):
        """A vector with components x in frame n, in components of frame m."""
        return lambda t: self.between(n, m)(t) * self.column(x, t)


def agrees(kind, vector, frame, expected):
    """``vector`` has the components ``expected(scale)`` at every instant of its kind."""
    small = 1e-24 if kind in ("mpmath", "sympy") else 1e-12
    for n, scale in enumerate(SCALES[kind]):
        with mp.workdps(DIGITS):
            wanted = expected(scale)
            size = max(1, *map(abs, wanted))
        for x, y in zip(vector.components(frame), wanted, strict=True):
            instant = x[n] if isinstance(x, np.ndarray) else x
            assert abs(number(instant) - y) <= small * size, (vector, n, y)
    return True


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("axis", AXES)
def test_eqn_4_13_and_4_14_and_2_19_to_2_21_a_vector_fixed_in_a_frame_turns_with_it(kind, axis):
    tree = [{"parent": 0, "axis": axis, "angle": [0.7, 1.3, -0.4], "origin": None}]
    ground, body = in_engine(tree, kind)
    for n, unit in enumerate((body.i, body.j, body.k)):
        e = mpmath.matrix([int(n == m) for m in range(3)])
        turned = lambda s, e=e: rate(lambda t: Explicit(tree, s).R(1, t) * e)
        assert close(unit.rate(ground), cross(body.angular_velocity(ground), unit))
        assert agrees(kind, unit.rate(ground), ground, turned)


Q = [[0.3, 1.1, -0.6], [1.2, -0.4, 0.9], [-0.8, 0.5, 0.2]]


def moving_vector(kind, frame, q=Q):
    return frame.vector(*(moving(*numbers(kind, *v)) for v in q))


@pytest.mark.parametrize("kind", FAST_KINDS)
@pytest.mark.parametrize("seed", range(4))
def test_eqn_4_15_and_4_27_and_2_22_rate_of_a_moving_vector_seen_from_any_frame(kind, seed):
    tree = random_tree(seed, 4)
    frames = in_engine(tree, kind)
    for m, observer in enumerate(frames):
        dQ = moving_vector(kind, frames[4]).rate(observer)
        assert agrees(kind, dQ, observer, lambda s, m=m: rate(Explicit(tree, s).turned(4, Q, m)))
        if m != 4:
            assert list(dQ.terms) == ["relative", "rotation"]
            assert close(sum(dQ.terms.values()), dQ)
            own = tuple(numbers(kind, *(v[1] for v in Q)))
            assert close(dQ.terms["relative"].components(frames[4]), own)


@pytest.mark.parametrize("seed", range(3))
def test_eqn_4_15_twice_with_two_observers(seed):
    """The rate, seen from k, of the rate seen from j."""
    tree = random_tree(seed, 4)
    frames, e = in_engine(tree, "mpmath"), Explicit(tree)
    for j, k in ((0, 0), (0, 2), (3, 1), (4, 0), (1, 4), (4, 4)):
        seen_from_k = lambda t, j=j, k=k: e.between(j, k)(t) * rate(e.turned(4, Q, j), t)
        found = moving_vector("mpmath", frames[4]).rate(frames[j]).rate(frames[k])
        assert agrees("mpmath", found, frames[k], lambda s, f=seen_from_k: rate(f))


@pytest.mark.parametrize("kind", FAST_KINDS)
def test_eqn_4_15_holds_for_sums_products_and_cross_products(kind):
    tree = chain(11, 2)
    f, first, second = in_engine(tree, kind)
    other, factor = [[1.0, 0.2, 0.1], [0.4, 0.0, -0.3], [0.7, -0.5, 0.6]], [0.9, -1.7, 0.4]
    A, B = moving_vector(kind, first), moving_vector(kind, second, other)
    M = moving(*numbers(kind, *factor))

    def explicit(combine, s):
        e = Explicit(tree, s)
        a, b = e.turned(1, Q, 0), e.turned(2, other, 0)
        return rate(lambda t: combine(a(t), b(t), e.course(factor, t)))

    for found, combine in (
        (A + B, lambda a, b, m: a + b),
        (A - B, lambda a, b, m: a - b),
        (A.cross(B), lambda a, b, m: cross50(a, b)),
        (M * A, lambda a, b, m: m * a),
        (A / M, lambda a, b, m: a / m),
        ((-A).expressed_in(second), lambda a, b, m: -a),
        (3 * A / 2, lambda a, b, m: 3 * a / 2),
    ):
        assert agrees(kind, found.rate(f), f, lambda s, c=combine: explicit(c, s))


POINT = [[0.6, -1.2, 0.5], [0.4, 0.7, -0.9], [-1.1, 0.3, 0.8]]


@pytest.mark.parametrize("kind", FAST_KINDS)
@pytest.mark.parametrize("seed", range(4))
def test_eqn_4_16_to_4_18_and_2_23_to_2_26_from_every_observer_by_way_of_every_frame(kind, seed):
    """Observers above, below, and in other branches; every ``via`` gives the same total."""
    tree = random_tree(seed, 5)
    frames = in_engine(tree, kind)
    here = random.Random(seed).randrange(6)
    P = frames[here].point("P", *(moving(*numbers(kind, *v)) for v in POINT))
    for m, observer in enumerate(frames):
        seen = {s: Explicit(tree, s).seen(here, POINT, m) for s in SCALES[kind]}
        assert agrees(kind, P.position(observer), observer, lambda s, f=seen: f[s](mpf(0)))
        velocity = {s: rate(f) for s, f in seen.items()}
        acceleration = {s: second_rate(f) for s, f in seen.items()}
        for via in (None, *frames):
            v, a = P.velocity(observer, via), P.acceleration(observer, via)
            assert agrees(kind, v, observer, velocity.get)
            assert agrees(kind, a, observer, acceleration.get)
            assert v.frame is a.frame is (via or P.frame)
            for x in (v, a):
                if x.terms:
                    assert close(sum(x.terms.values()), x, 1e-10)


@pytest.mark.parametrize("seed", range(4))
def test_eqn_4_28_and_4_29_term_by_term(seed):
    """Each term against its own definition."""
    tree = random_tree(seed + 20, 5)
    frames = in_engine(tree, "mpmath")
    P = frames[5].point("P", *(moving(*numbers("mpmath", *v)) for v in POINT))
    e = Explicit(tree)
    for j, i in ((0, 5), (0, 2), (2, 5), (3, 4), (5, 1), (1, 3)):
        observer, via = frames[j], frames[i]
        v, a = P.velocity(observer, via), P.acceleration(observer, via)
        if not a.terms:
            assert i == j or P.frame is observer
            continue
        with mp.workdps(DIGITS):
            into, seen, origin = e.between(i, j), e.seen(5, POINT, i), e.seen(i, None, j)
            r, v_r, a_r = (into(mpf(0)) * x for x in (seen(mpf(0)), rate(seen), second_rate(seen)))
            omega, alpha = angular_velocity(into), angular_acceleration(into)
            expected_v = {"origin": rate(origin), "relative": v_r, "rotation": cross50(omega, r)}
            expected_a = {"origin": second_rate(origin), "relative": a_r}
            expected_a |= {"coriolis": 2 * cross50(omega, v_r), "euler": cross50(alpha, r)}
            expected_a["centripetal"] = cross50(omega, cross50(omega, r))
        for terms, expected in ((v.terms, expected_v), (a.terms, expected_a)):
            assert list(terms) == list(expected)
            for name, wanted in expected.items():
                assert agrees("mpmath", terms[name], observer, lambda s, w=wanted: w), (name, j, i)


def test_eqn_4_18_terms_nest_down_to_the_ground():
    """The origin's acceleration is itself a sum with terms, and so on."""
    tree = chain(5, 3)
    for s in tree:
        s["origin"] = [[0.5, 0.1, 0.2], [0.3, -0.4, 0.1], [0.2, 0.2, -0.1]]
    frames = in_engine(tree, "float")
    a = frames[3].point("P", 1.0, 2.0, 3.0).acceleration(frames[0])
    depth = 0
    while a.terms:
        assert close(sum(a.terms.values()), a, 1e-10)
        a, depth = a.terms["origin"], depth + 1
    # origin of f3 by way of f2, of f2 by way of f1, and of f1 in the ground, where nothing is
    # left to split
    assert depth == 3
    assert close(a.components(frames[0]), (0.2, 0.1, -0.1))


@pytest.mark.parametrize("seed", range(3))
def test_eqn_4_18_the_rate_of_the_velocity_is_the_acceleration(seed):
    tree = random_tree(seed, 5)
    frames = in_engine(tree, "float")
    P = frames[5].point("P", *(moving(*v) for v in POINT))
    for observer in frames:
        for via in (None, *frames):
            assert close(P.velocity(observer, via).rate(observer), P.acceleration(observer), 1e-9)


def test_eqn_4_29_on_symengine_and_through_heyoka():
    symengine = pytest.importorskip("symengine")
    pytest.importorskip("heyoka")
    tree = chain(3, 3)

    def acceleration(w):
        frames = in_engine(tree, "float", w)
        P = frames[-1].point("P", *(moving(*v) for v in POINT))
        return P.acceleration(frames[0]).expressed_in(frames[0])

    direct = acceleration(1.0)
    w = symengine.Symbol("w")
    for got, wanted in zip(acceleration(w), direct, strict=True):
        assert abs(float(got.subs({w: 1.0})) - wanted) < 1e-11
    f = compiled_by("heyoka", acceleration)
    for got, wanted in zip(f(np.array([1.0, 2.0])), direct, strict=True):
        assert abs(got[0] - wanted) < 1e-11
    assert agrees(
        "float", direct, direct.frame, lambda s: second_rate(Explicit(tree, s).seen(3, POINT, 0))
    )


def test_eqn_4_18_has_the_units_of_an_acceleration_whatever_the_chain():
    pure, per_s, per_s2 = Dimension(), Dimension(time=-1), Dimension(time=-2)
    m, m_s, m_s2 = Dimension(length=1), Dimension(0, 1, -1), Dimension(0, 1, -2)
    frames = [Frame("f0")]
    for n, axis in enumerate(["x", (1, 2, 2), "-z", "y"], start=1):
        origin = frames[-1].point("O", moving(m, m_s, m_s2), m, 0)
        frames.append(frames[-1].rotate(f"f{n}", axis, moving(pure, per_s, per_s2), origin=origin))
    P = frames[-1].point("P", moving(m, m_s, m_s2), moving(m, m_s), m)
    for observer in frames:
        for via in frames:
            v, a = P.velocity(observer, via), P.acceleration(observer, via)
            assert {c for c in v.components(frames[0]) if c} == {m_s}
            assert {c for c in a.components(frames[0]) if c} == {m_s2}
    assert set(frames[-1].angular_acceleration(frames[0]).components()) == {per_s2}


@pytest.mark.one_in(3)
@pytest.mark.parametrize("kind", FAST_KINDS)
@pytest.mark.parametrize("seed", range(5))
def test_eqn_4_19_to_4_24_angular_velocity_and_acceleration_between_any_two_frames(kind, seed):
    tree = random_tree(seed, 6)
    frames = in_engine(tree, kind)
    rng = random.Random(seed)
    for _ in range(8):
        n, m = rng.randrange(7), rng.randrange(7)
        between = lambda s, n=n, m=m: Explicit(tree, s).between(n, m)
        omega = frames[n].angular_velocity(frames[m])
        alpha = frames[n].angular_acceleration(frames[m])
        assert agrees(kind, omega, frames[m], lambda s, f=between: angular_velocity(f(s)))
        assert agrees(kind, alpha, frames[m], lambda s, f=between: angular_acceleration(f(s)))
        for x in (omega, alpha):
            assert close(sum(x.terms.values(), start=0 * x), x, 1e-10)


@pytest.mark.parametrize("count", [2, 3, 4, 5, 6])
@pytest.mark.parametrize("kind", FAST_KINDS)
def test_eqn_4_25_and_4_26_and_the_rule_for_n_frames(kind, count):
    """The sum of the relative accelerations and of all products of an inner and an outer rate."""
    frames = in_engine(chain(count, count), kind)
    ground, last = frames[0], frames[-1]
    alpha = last.angular_acceleration(ground)
    pairs = list(pairwise(frames))
    spins = {f.name: f.angular_velocity(parent) for parent, f in pairs}
    expected = {f.name: f.angular_acceleration(parent) for parent, f in pairs}
    for (n, u), (m, v) in combinations(spins.items(), 2):
        expected[f"{n} x {m}"] = u.cross(v)
    assert set(alpha.terms) == set(expected)
    for name, term in expected.items():
        assert close(alpha.terms[name], term, 1e-11), name
    if count == 2:
        assert alpha.explain().equation.number == "4.25"


def test_eqn_4_25_leaves_out_a_frame_that_is_only_translated():
    cart = ground.translate("cart", ground.point("C", moving(0.0, 1.0, 2.0), 0, 0))
    wheel = cart.rotate("wheel", "y", 0.1, rate=3.0)
    assert list(wheel.angular_velocity(ground).terms) == ["wheel"]
    assert cart.angular_velocity(ground).components() == (0, 0, 0)
    assert wheel.point("P", 0, 0, 0).acceleration(ground).components(ground) == (2.0, 0, 0)
    assert ground.origin.acceleration(cart).components(cart) == (-2.0, 0, 0)


@pytest.mark.parametrize("seed", range(4))
def test_section_4_7_omega_has_the_same_rate_in_its_two_frames_and_in_no_third(seed):
    frames = in_engine(chain(seed + 30, 4), "float")
    a, b, third = frames[4], frames[2], frames[0]
    omega, alpha = a.angular_velocity(b), a.angular_acceleration(b)
    assert close(omega.rate(a), alpha, 1e-11)
    assert close(omega.rate(b), alpha, 1e-11)
    assert close(omega.rate(third), alpha + a.angular_velocity(third).cross(omega), 1e-10)
    assert not same(omega.rate(third), alpha, 1e-3)


VALUES = (0.4, 1.2, 0.3, 4, 0.7, 2, 0.5)


def inclined_disk(phi, omega, domega, p, dp, R, r):
    """Frames as in the book: 2 in the shaft, 3 in the disk with j to A and k along OB."""
    ground = Frame("1")
    shaft = ground.rotate("2", "z", rate=omega, acceleration=domega)
    half_turn = shaft.rotate("half turn", "z", angle=pi(phi))
    tilted = half_turn.rotate("tilted", "x", angle=pi(phi) / 2 - phi)
    disk = tilted.rotate("3", "z", rate=p, acceleration=dp, origin=tilted.point("B", 0, 0, R))
    return ground, shaft, disk, disk.point("A", 0, r, 0)


@pytest.mark.parametrize("kind", KINDS)
def test_example_4_11_by_the_printed_formulas_and_each_of_their_terms(kind):
    phi, w, dw, p, dp, R, r = q = numbers(kind, *VALUES)
    ground, shaft, frame, A = inclined_disk(*q)
    s, c = sin(phi), cos(phi)
    assert close(frame.rotation(ground), ((-1, 0, 0), (0, -s, c), (0, c, s)))
    along = r * w * s + r * p - R * w * c
    for via in (frame, shaft):
        assert close(A.velocity(ground, via).components(ground), (along, 0, 0))
    assert close(frame.origin.velocity(ground).components(ground), (-w * R * c, 0, 0))
    alpha = frame.angular_acceleration(ground)
    assert close(alpha.components(frame), (w * p * c, dw * c, dw * s + dp))
    assert close(alpha.terms["2 x 3"].components(frame), (w * p * c, 0, 0))
    a = A.acceleration(ground)
    assert a.frame is frame
    assert close(a.terms["origin"], (dw * R * c, w**2 * R * s * c, -(w**2) * R * c**2))
    assert close(a.terms["centripetal"], (0, -r * (p + w * s) ** 2, w * r * c * (p + w * s)))
    assert close(a.terms["euler"], (-(dw * s + dp) * r, 0, w * p * r * c))
    assert close(a.terms["coriolis"], (0, 0, 0))
    assert close(a.terms["relative"], (0, 0, 0))
    printed = (
        dw * r * (R / r * c - s) - r * dp,
        w**2 * r * (R / r * s * c - (p / w + s) ** 2),
        w**2 * r * c * (-R / r * c + 2 * p / w + s),
    )
    assert close(a, printed)


reals = st.floats(-3, 3).map(lambda x: round(x, 4))
triples = st.tuples(reals, reals, reals)
axes = st.one_of(st.sampled_from(AXES), triples.filter(lambda e: sum(x * x for x in e) > 0.01))

nines = st.tuples(triples, triples, triples)
turns = st.lists(st.tuples(axes, triples, nines), min_size=1, max_size=5)


def build(turns_, branch_at=0):
    frames = [Frame("f0")]
    for n, (axis, angle, place) in enumerate(turns_, start=1):
        parent = frames[branch_at % n] if n == len(turns_) else frames[-1]
        O = parent.point("O", *(moving(*p) for p in place))
        frames.append(parent.rotate(f"f{n}", axis, moving(*angle), origin=O))
    return frames


@settings(max_examples=60)
@given(turns, triples, triples, st.integers(0, 5))
def test_vectors_and_their_products_do_not_depend_on_the_frame(turns_, a, b, branch):
    frames = build(turns_, branch)
    last = frames[-1]
    u, v = last.vector(*a), last.vector(*b)
    for f in frames:
        there = u.expressed_in(f)
        assert there.norm() == pytest.approx(u.norm(), rel=1e-13, abs=1e-13)
        assert close(there.expressed_in(last), a, 1e-13)
        assert there.dot(v) == pytest.approx(u.dot(v), abs=1e-12)
        assert close(there.cross(v), u.cross(v).expressed_in(f), 1e-12)
    R = np.array(last.rotation(frames[0]), dtype=float)
    assert np.allclose(R @ R.T, np.eye(3), atol=1e-13)
    assert np.linalg.det(R) == pytest.approx(1.0)
    assert np.allclose(R[:, 1], [float(c) for c in last.j.components(frames[0])], atol=1e-15)


def test_an_axis_may_be_a_vector_and_of_whole_numbers_keeps_all_digits():
    spun = ground.rotate("spun", (1, 1, 1), rate=numbers("mpmath", "1/3"))
    assert abs(spun.angular_velocity(ground).x - 1 / (3 * mpmath.sqrt(3))) < 1e-29
    turned = ground.rotate("turned", (1, 1, 1), angle=2 * mpmath.pi / 3)
    assert close(turned.i.components(ground), (0, 1, 0), 1e-28)
    exact = ground.rotate("exact", (1, 1, 1), angle=sympy.pi / 3)
    assert exact.i.components(ground)[0] == sympy.Rational(2, 3)
    arm = ground.rotate("arm", "z", np.pi / 2)
    omega = ground.rotate("b", 5 * arm.i, rate=2.0).angular_velocity(ground)
    assert close(omega.components(ground), (0, 2.0, 0))


def test_what_is_zero_by_structure_stays_zero_and_is_shown_so():
    arm = ground.rotate("arm", "z", rate=2.0)
    P = arm.point("P", 1.0, 0, 0)
    a = P.acceleration(ground)
    assert str(a) == "[-4, 0, 0] in arm"
    assert [str(t) for t in a.terms.values()] == [f"[{x}, 0, 0] in arm" for x in (0, 0, 0, 0, -4)]
    arm = ground.rotate("arm", "z", 0.2)
    assert repr(arm) == "Frame(arm < ground)"
    assert repr(arm.point("P", 1.0, 0, 0)) == "Point(P at (1.0, 0, 0) in arm)"
    assert arm.origin.name == "origin of arm"
    assert ground.origin.position(ground).components() == (0, 0, 0)


def test_what_is_given_as_an_expression_in_t_has_its_rates():
    t, positive = sympy.Symbol("t"), sympy.Symbol("t", real=True, positive=True)
    assert ground.rotate("arm", "z", rate=3 * t**2).angular_acceleration(ground).z == 6 * t
    arm = ground.rotate("arm", "z", 3 * positive**2)
    assert arm.angular_velocity(ground).z == 6 * positive
    with pytest.raises(ScalarError, match="2 different symbols named t"):
        ground.rotate("arm", "z", t + positive)
    assert (t**2 * ground.i).rate(ground).components() == (2 * t, 0, 0)
    assert (ground.i / t).rate(ground).rate(ground).components() == (2 / t**3, 0, 0)


def robot(root="ground", arm="arm"):
    ground = Frame(root)
    return ground, ground.rotate(arm, "z", 0.2, rate=1.0)


@pytest.mark.parametrize("ask", [
    lambda a, b: a.i + b.j,
    lambda a, b: a.angular_velocity(b),
    lambda a, b: a.point("P", 1, 0, 0).velocity(a.parent, via=b),
    lambda a, b: a.point("P", 1, 0, 0) - b.point("Q", 0, 0, 0),
    lambda a, b: a.vector(0, 0, 0).expressed_in(b),
])  # fmt: skip
def test_frames_without_a_common_ancestor_are_named_at_both_ends(ask):
    (_, arm), (_, bench) = robot(), robot("workshop", "bench")
    with pytest.raises(FrameError, match=r"share no frame.*Build both from one ground") as error:
        ask(arm, bench)
    words = str(error.value)
    assert "arm" in words or "ground" in words
    assert "bench" in words
    assert "workshop" in words


@pytest.mark.parametrize("ask", [
    lambda ground, arm: arm.angular_velocity(ground),
    lambda ground, arm: ground.rotate("rod", "x", origin=arm.parent.point("A", 1, 0, 0)),
])  # fmt: skip
def test_the_error_names_two_trees_with_the_same_names(ask):
    (ground, _), (_, arm) = robot(), robot()
    with pytest.raises(
        FrameError, match=r"two trees with the same names.*build once and pass the frame ground"
    ):
        ask(ground, arm)


NOT_AN_AXIS = "an axis is 'x', 'y', 'z', '-x', '-y', '-z', a Vector, or three constant components"
SHAPES = r"have the shapes \[\(3,\), \(4,\)\]; all arrays must have one shape"
NO_ORIGIN = r"an origin is a Point, as (ground|arm).point\('C', 0, 1, 0\); got "
THREE, FOUR = np.zeros(3), np.zeros(4)


@pytest.mark.parametrize(("ask", "words"), [
    (lambda f: f.point("P", 1, 2, 3).velocity(), r"velocity as seen from which frame.*P.velocity\(ground\)"),
    (lambda f: f.point("P", 1, 2, 3).velocity("ground"), "got 'ground', which is not a Frame"),
    (lambda f: f.i.rate(), r"is seen from a frame.*Q.rate\(ground\)"),
    (lambda f: f.i.expressed_in(3), "expected a frame"),
    (lambda f: f.point("P", THREE, FOUR, 0), SHAPES),
    (lambda f: f.vector(THREE, 1.0, FOUR), SHAPES),
    (lambda f: f.rotate("arm", "z", angle=THREE, rate=FOUR), SHAPES),
    *[(lambda f, axis=axis: f.rotate("arm", axis), "has no direction: its length is")
      for axis in ((0, 0, 0), (mpf(0), 0, 0), (sympy.Integer(0), 0, 0), (float("nan"), 1.0, 0))],
    *[(lambda f, axis=axis: f.rotate("arm", axis), NOT_AN_AXIS)
      for axis in ("w", "--z", (1, 2), None, ("a", "b", "c"), (moving(1.0, 2.0), 0, 0))],
    (lambda f: f.rotate("rod", "x", origin=(1, 2, 3)), NO_ORIGIN + r"\(1, 2, 3\)"),
    (lambda f: f.translate("rod", f.i), NO_ORIGIN),
    (lambda f: Frame(f), "a frame has a name, as Frame"),
    (lambda f: Frame("arm", "ground"), "the parent of arm is a Frame or None; got 'ground'"),
    (lambda f: Frame("arm", f, "z", 0.3), "takes the angle of arm, a moving number; got 0.3"),
    (lambda f: f.rotate("arm", "z", 0.1).rotate("rod", "x", origin=f.point("C", 1, 0, 0)),
     "the origin C is a point of ground; give it as a point of arm"),
])  # fmt: skip
def test_what_is_not_geometry_is_refused_in_words(ask, words):
    with pytest.raises(FrameError, match=words):
        ask(Frame("ground"))


def test_the_third_rate_of_a_moving_quantity_is_not_known_nor_that_of_what_is_of_an_instant():
    v = ground.vector(moving(1.0, 2.0, 3.0), 0, 0)
    assert v.rate(ground).rate(ground).components() == (3.0, 0, 0)
    words = "the third time derivative of a moving quantity is not known"
    for changing in (v, moving(1.0, 2.0, 3.0) * ground.i, ground.j / moving(1.0, 2.0, 3.0)):
        with pytest.raises(FrameError, match=words):
            changing.rate(ground).rate(ground).rate(ground)
    with pytest.raises(FrameError, match="the third time derivative"):
        ground.point("P", moving(1.0, 2.0, 3.0), 0, 0).acceleration(ground).rate(ground)
    arm = ground.rotate("arm", "z", rate=1.0)
    a = arm.point("P", 1.0, 0, 0).acceleration(ground)
    for known in (a, arm.angular_acceleration(ground), Vector((1, 2, 3), ground)):
        with pytest.raises(FrameError, match=r"is not known; build it from moving"):
            known.rate(ground)


@pytest.fixture
def without_collector():
    """Without the collector an object is freed only when nothing refers to it, and then at once."""
    gc.disable()
    yield
    gc.enable()


USES = {
    "made": lambda arm, P, ground: arm,
    "position": lambda arm, P, ground: P.position(ground),
    "velocity": lambda arm, P, ground: P.velocity(ground).explain(),
    "acceleration": lambda arm, P, ground: P.acceleration(ground).explain(),
    "seen from the arm": lambda arm, P, ground: (
        ground.angular_acceleration(arm),
        ground.point("Q", 1.0, 0, 0).acceleration(arm).c,
    ),
    "seen from a sibling": lambda arm, P, ground: (P.acceleration(ground.rotate("other", "x", rate=2.0)).c),
    "unit vectors": lambda arm, P, ground: (arm.i.rate(ground), ground.k.expressed_in(arm), P.velocity(arm).rate(arm)),
    "origin": lambda arm, P, ground: (arm.rotate("hand", "x", 0.3, origin=P).origin.velocity(ground).c),
    "tree": lambda arm, P, ground: ground.tree,
}  # fmt: skip


@pytest.mark.parametrize("use", USES)
def test_a_frame_is_forgotten_when_nothing_refers_to_it(use, without_collector):
    ground = Frame("ground")
    arm = ground.rotate("arm", "z", 0.2, 0.6, origin=ground.point("O", 1.0, 0, 0))
    seen = weakref.ref(arm)
    USES[use](arm, arm.point("P", 0, moving(1.0, 0.5), 0), ground)
    del arm
    assert seen() is None
    assert ground.tree == [ground]


def test_a_frame_keeps_those_above_it_and_those_of_a_result_are_in_its_tree():
    rod = Frame("ground").rotate("arm", "z", rate=0.6).rotate("rod", "x", 0.3, 2.0)
    ground, arm, _ = rod.tree
    assert [f.name for f in rod.tree] == ["ground", "arm", "rod"]
    a = rod.point("P", 0, 1.0, 0).acceleration(ground).expressed_in(arm)
    twig = rod.rotate("twig", "z")
    assert arm.tree == a.frame.tree[0].tree == [ground, arm, rod, twig]
    del rod, twig
    gc.collect()
    # the terms of the acceleration keep the frames
    assert [f.name for f in a.frame.tree] == ["ground", "arm", "rod"]


small = within(2e-14, 26)


@every_kind
def test_eqn_1_1_to_1_3_position_velocity_acceleration_by_successive_differentiation(kind):
    r, v, a, t = curve(kind)
    P = ground.point("P", *along(r, t))
    assert close(P.position(ground), r(t), small(kind))
    assert close(P.velocity(ground), v(t), small(kind))
    assert close(P.acceleration(ground), a(t), small(kind))
    assert close(P.position(ground).rate(ground), P.velocity(ground), 0)
    assert close(P.velocity(ground).rate(ground), P.acceleration(ground), 0)


@every_kind
def test_eqn_2_1_to_2_3_and_3_1_to_3_3_rectangular_components_are_differentiated_one_by_one(kind):
    q, d, e = motion(kind)
    P = ground.point("P", *map(moving, q, d, e))
    assert close(P.position(ground), q, 0)
    assert close(P.velocity(ground), d, 0)
    assert close(P.acceleration(ground), e, 0)


@pytest.mark.parametrize("angle", [30, 90.0, -45, 145.0, 7, 360, np.float64(60.0)])
def test_a_whole_number_beyond_a_turn_asks_whether_degrees_are_meant(angle):
    with pytest.warns(AngleWarning, match=r"boom is .* rad.*degrees\? Write radians") as found:
        boom = Frame("ground").rotate("boom", "z", angle)
    assert found[0].filename == __file__
    assert boom.angle.value == angle  # used as given


@pytest.mark.parametrize(
    "angle",
    [0, 3, -6, 6.28, 9.0, math.pi, 10 * math.pi, 30.5, moving(40.0, rate=2.0), at(lambda t: 4 * t, 5.0),
     sympy.Integer(30), np.array([30.0, 60.0])],
)  # fmt: skip
def test_an_angle_that_is_computed_or_may_be_in_radians_is_not_asked_about(angle):
    with warnings.catch_warnings(record=True) as found:
        warnings.simplefilter("always")
        Frame("ground").rotate("boom", "z", angle)
    assert found == []

"""Named linear equations over every kind of number: values, unknowns left open, repetitions, and
contradictions.
"""

import itertools
import math
import random

import mpmath as mp
import numpy as np
import pytest
import sympy
from hypothesis import example, given, settings
from hypothesis import strategies as st

from newton_euler import Dimension, Frame, compiled, cos, sin, solve_linear, solve_rates
from newton_euler.algebra import DimensionError, FrameError, LinearError, ScalarError
from newton_euler.algebra.scalars import probe, unit_roundoff
from tests.kinds import close, every_kind, first, numbers

ground = Frame("ground")
NAMES = tuple(f"u{n}" for n in range(12))


def system(rows, right):
    """The conditions row . unknowns - right, as "e0", "e1" ..."""

    def conditions(*unknowns):
        return {
            f"e{n}": sum((c * u for c, u in zip(row, unknowns, strict=True)), start=0) - b
            for n, (row, b) in enumerate(zip(rows, right, strict=True))
        }

    return conditions


def regular(kind, count):
    """Rows, right sides and the known solution of a system of small whole numbers."""
    dice = random.Random(count)
    entry = lambda i, j: numbers(kind, dice.randint(-5, 5) + 9 * (i == j))
    rows = [[entry(i, j) for j in range(count)] for i in range(count)]
    wanted = [numbers(kind, f"{n - 3}/{n + 2}") for n in range(count)]
    return rows, [sum(c * w for c, w in zip(row, wanted, strict=True)) for row in rows], wanted


@every_kind
@pytest.mark.parametrize("count", [1, 2, 3, 4, 5, 7, 12])
def test_regular_systems_give_the_solution_they_were_made_from(kind, count):
    if kind == "sympy" and count == 12:
        pytest.skip("a full matrix of 12 exact numbers has no use and is slow")
    rows, right, wanted = regular(kind, count)
    s = solve_linear(system(rows, right), NAMES[:count])
    assert close(tuple(s), wanted, 1e-12 if kind in ("float", "array") else mp.mpf(10) ** -26)
    assert s.undetermined == ()
    assert not s.redundant
    assert s.report() == "The equations determine every unknown, and each of them is needed"


@settings(max_examples=60)
@given(st.integers(2, 5), st.integers(0, 3), st.integers(0, 10**6))
@example(2, 2, 39)  # the first two equations are 10^-10 of the others
def test_the_order_of_equations_and_their_units_do_not_matter(count, surplus, seed):
    """The equations are multiplied by powers of ten and shuffled, with sums of them added."""
    dice = np.random.default_rng(seed)
    A = dice.integers(-4, 5, size=(count, count)) + 9 * np.eye(count)
    wanted = dice.normal(size=count)
    mixed = np.vstack([A, dice.integers(-2, 3, size=(surplus, count)) @ A])
    scale = 10.0 ** dice.integers(-6, 7, size=len(mixed))
    rows = (mixed * scale[:, None])[dice.permutation(len(mixed))]
    s = solve_linear(system(rows.tolist(), (rows @ wanted).tolist()), NAMES[:count])
    assert close(tuple(s), tuple(wanted), 1e-11)
    trivial = sum(1 for row in rows if not row.any())  # 0 = 0 is not reported
    assert len(s.redundant) == surplus - trivial


@settings(max_examples=40)
@given(st.integers(2, 5), st.integers(1, 2), st.integers(0, 10**6))
def test_the_unknowns_left_open_are_those_that_the_rank_leaves_open(count, missing, seed):
    """An unknown is determined if its unit vector lies in the row space, by singular values."""
    dice = np.random.default_rng(seed)
    A = dice.integers(-2, 3, size=(max(count - missing, 1), count)).astype(float)
    s = solve_linear(system(A.tolist(), (A @ np.ones(count)).tolist()), NAMES[:count])
    rank = np.linalg.matrix_rank(A)
    with_row = lambda row: np.linalg.matrix_rank(np.vstack([A, row]))
    determined = [with_row(row) == rank for row in np.eye(count)]
    assert [name not in s.undetermined for name in s.names] == determined
    assert all(abs(x - 1) < 1e-9 for x in s.values.values())


def test_formulas_of_symbols_are_exact_and_unsimplified_ones_agree_with_sympy():
    symbols = sympy.symbols("a:4:5")
    rows = [list(symbols[5 * n : 5 * n + 4]) for n in range(4)]
    rows[0][1] = rows[0][2] = rows[2][3] = 0
    right = [symbols[5 * n + 4] for n in range(4)]
    s = solve_linear(system(rows, right), NAMES[:4])
    expected = sympy.Matrix(rows).LUsolve(sympy.Matrix(right))
    point = {x: sympy.Rational(n * n + 3, n + 7) for n, x in enumerate(symbols)}
    for mine, theirs in zip(s, expected, strict=True):
        assert sympy.simplify(mine.subs(point) - theirs.subs(point)) == 0


def test_an_unknown_that_stands_alone_is_solved_first_and_stays_short():
    m, g, mu, t = sympy.symbols("m g mu t")
    s = solve_linear(laws(m, g, mu, t))
    assert m * g * sympy.cos(t) == s.N
    assert mu * m * g * sympy.cos(t) == s.F
    assert sympy.simplify(s.a - g * (sympy.sin(t) - mu * sympy.cos(t))) == 0


def laws(m, g, mu, t):
    """A block that slides down a slope with friction."""
    return lambda N, F, a: {
        "along": m * a - m * g * sin(t) + F,
        "across": N - m * g * cos(t),
        "friction": F - mu * N,
    }


@pytest.mark.parametrize("count", [7, 8])
def test_more_symbols_than_cramer_takes_are_eliminated(count):
    """A chain with a corner: each unknown meets its neighbours, the first one the last."""

    def chain(k):
        return lambda *u: tuple(
            (2 + k) * u[n] - u[n - 1] - k * u[(n + 1) % count] - n for n in range(count)
        )

    k = sympy.Symbol("k")
    found, numeric = (solve_linear(chain(x), NAMES[:count]) for x in (k, 0.37))
    assert close([x.subs(k, sympy.Rational(37, 100)) for x in found], tuple(numeric), 1e-12)


def test_a_zero_that_only_simplification_would_reveal_is_not_a_pivot():
    """sin^2 + cos^2 - 1 multiplies B: its value must show that it is 0, no divisor."""
    t, m = sympy.symbols("t m")
    hidden = sympy.sin(t) ** 2 + sympy.cos(t) ** 2 - 1
    s = solve_linear(lambda A, B: {"p": hidden * B + A - m, "q": A + B - 3 * m})
    assert sympy.simplify(s.A - m) == 0
    assert sympy.simplify(s.B - 2 * m) == 0
    left = solve_linear(lambda A, B: {"p": hidden * B + A - m, "q": 2 * A - 2 * m})
    assert left.undetermined == ("B",)
    assert dict(left.redundant) == {"q": ("p",)}


def test_functions_of_time_and_symengine_are_seen_by_value_too():
    symengine = pytest.importorskip("symengine")
    t = sympy.Symbol("t")
    q = sympy.Function("q")(t)
    assert abs(probe(sympy.sin(q) ** 2 + sympy.cos(q) ** 2 - 1)) == 0
    assert probe(q.diff(t) - q) != 0
    x = symengine.Symbol("x")
    assert probe((x + 1) ** 2 - x**2 - 2 * x - 1) == 0
    s = solve_linear(lambda A, B: {"p": x * A + B - 1, "q": A - B})
    assert close(float(s.A.subs(x, 2)), 1 / 3)
    assert probe(1 / ((x + 1) ** 2 - x**2 - 2 * x - 1)) is None


def test_symbols_that_share_a_name_are_two_and_contradict_each_other_without_made_up_numbers():
    x, positive = sympy.Symbol("x"), sympy.Symbol("x", positive=True)
    s = solve_linear(lambda A, B: {"p": x * A + positive * B - 1, "q": positive * A + x * B})
    assert sympy.simplify(s.A - x / (x**2 - positive**2)) == 0
    a, b, c, d = (sympy.Rational(n, 10**30) for n in (1, 2, 3, 5))
    assert solve_linear(lambda A, B: (a * A + b * B - a, c * A + d * B - c)).B == 0
    g = sympy.Symbol("g")
    with pytest.raises(LinearError, match="'q' does not hold if 'p' holds"):
        solve_linear(lambda A: {"p": A - g, "q": 2 * A - g})


def test_traced_formulas_run_on_floats_and_arrays():
    slide = lambda m, g, t: tuple(solve_linear(laws(m, g, 0.1, t)))
    fast = compiled(slide)
    assert close(fast(2.0, 9.81, 0.3), slide(2.0, 9.81, 0.3), 1e-14)
    angles = np.array([0.3, 0.4])
    assert close(fast(2.0, 9.81, angles), slide(2.0, 9.81, angles), 1e-14)


def test_equations_of_different_units_prove_their_units():
    M, L, T = Dimension(1), Dimension(0, 1), Dimension(0, 0, 1)
    g = L / T**2

    def beam(R, alpha, torque=0):
        return {
            "force": R - M * g + M * (L * alpha) / 2,
            "moment": M * (L * L) / 12 * alpha - R * L / 2 + torque,
        }

    s = solve_linear(beam)
    assert M * g == s.R
    assert s.alpha == 1 / T**2
    with pytest.raises(DimensionError, match="cannot add"):
        solve_linear(lambda R, alpha: beam(R, alpha, M * g))


def test_a_statically_indeterminate_beam_reports_what_it_knows():
    """With pins at both ends the forces along the beam are undetermined, but their sum is known."""

    def pinned(A_x, A_y, B_x, B_y):
        A, B = ground.vector(A_x, A_y, 0), ground.vector(B_x, B_y, 0)
        load = ground.vector(3.0, -12.0, 0)
        r = ground.vector(2.0, 0, 0)
        return {"force": A + B + load, "moment about A": r.cross(B) + (r / 2).cross(load)}

    s = solve_linear(pinned)
    assert (s.A_y, s.B_y) == (6.0, 6.0)
    assert s.undetermined == ("A_x", "B_x")
    assert s.relations == ("A_x = -3 - B_x",)
    message = "Not determined: A_x, B_x: only A_x = -3 - B_x is known"
    with pytest.raises(LinearError, match=rf"A_x is not determined by the equations\. {message}"):
        _ = s.A_x
    with pytest.raises(LinearError, match="no unknown 'C_x'; there are A_x, A_y, B_x, B_y"):
        _ = s["C_x"]
    assert str(s).splitlines()[:2] == ["A_x = not determined", "A_y = 6"]


@every_kind
def test_a_third_moment_equation_says_nothing_new(kind):
    one, two, five = numbers(kind, 1, 2, 5)
    moment = lambda force: two * force - one * five
    laws = lambda A, B: {"force": A + B - five, "about A": moment(B), "about B": moment(A)}
    s = solve_linear(laws)
    assert close((s.A, s.B), (five / 2, five / 2), 1e-12)
    assert dict(s.redundant) == {"about B": ("force", "about A")}
    words = "The equation 'about B' is redundant: it follows from 'force' and 'about A'"
    assert words in s.report()


@every_kind
def test_contradictions_are_named(kind):
    one, two, five = numbers(kind, 1, 2, 5)
    message = "contradict each other: 'about B' .* if 'force' and 'about A' hold"
    moments = lambda A, B: {"about A": two * B - one * five, "about B": two * A - one}
    with pytest.raises(LinearError, match=message) as caught:
        solve_linear(lambda A, B, C: {"other": C - one, "force": A + B - five, **moments(A, B)})
    assert caught.value.equations == ("force", "about A", "about B")
    with pytest.raises(LinearError, match=r"'late' (is off by 2|does not hold)"):
        solve_linear(lambda A: {"force": A - one, "late": 0 * A + two})
    assert issubclass(LinearError, FrameError)


@pytest.mark.parametrize(("off", "agree"), [(8e-10, True), (2e-9, False)])
def test_equations_agree_to_nine_digits_or_contradict_each_other(off, agree):
    """To nine digits of the largest of them, in any order; that of C has nothing to do with it."""
    rows = [1, 0, 0, 1], [0, 1, 0, 1], [0, 0, 1, 1e2], [1, 100, 0, 101 * (1 + off)]
    for order in itertools.permutations(rows):
        try:
            solve_linear(system([row[:3] for row in order], [row[3] for row in order]), "A B C")
        except LinearError:
            assert not agree
        else:
            assert agree


def test_round_off_of_a_large_right_side_that_cancels_is_no_contradiction():
    rows = [1, 1, 0, 0, 0], [1, 1, 1, 1, 0], [1, 1, 1, 1, 1], [0, 0, 0, 0, 1]
    s = solve_linear(system(rows, [1e9 + 0.1, 5.03, 7.17, 7.17 - 5.03]), NAMES[:5])
    assert dict(s.redundant) == {"e3": ("e1", "e2")}


def test_neither_tiny_nor_small_units_are_taken_for_rounding():
    s = solve_linear(lambda A, B: {"tiny": 1e-15 * (A + B - 3.0), "usual": A - B - 1.0})
    assert close((s.A, s.B), (2.0, 1.0), 1e-12)
    # A watch wheel in SI units: a moment of inertia of 1e-12, lengths and forces of order
    # 1e-3
    moment = lambda F, alpha: 1e-12 * alpha - 1e-3 * F
    s = solve_linear(lambda F, alpha: {"moment": moment(F, alpha), "rolling": 1e-3 * alpha - 5.0})
    assert s.alpha == pytest.approx(5e3)
    assert pytest.approx(5e-6) == s.F


@pytest.mark.parametrize(("c", "known"), [
    (1, ("A = 3 - B",)), (-1, ("A = 3 + B",)), (2, ("A = 3 - 2 B",)), (-0.5, ("A = 3 + 0.5 B",)),
])  # fmt: skip
def test_what_is_known_of_open_unknowns_is_a_sentence_where_it_is_one_number(c, known):
    for right, relations in ((3.0, known), (np.array([3.0, 4.0]), ())):
        assert solve_linear(lambda A, B, b=right: A + c * B - b).relations == relations


def test_rounding_is_neither_a_pivot_nor_a_contradiction():
    noise = 6e-17
    force = lambda F, N: ground.vector(noise * F + noise, F - 2.0, noise * N)
    s = solve_linear(lambda F, N: {"force": force(F, N), "level": N + F - 5.0})
    assert close((s.F, s.N), (2, 3), 1e-12)
    left = solve_linear(lambda F, N: {"force": F - 2.0 + noise * N})
    assert left.undetermined == ("N",)
    assert left.F == 2.0


def test_arrays_without_a_common_pivot_are_solved_instant_by_instant():
    mixed = lambda x: lambda a, b: {"p": x * a + (1 - x) * b - 1.0, "q": (1 - x) * a + x * b - 2.0}
    x = np.array([1.0, 0.0, 2.0])
    s = solve_linear(mixed(x))
    for n, value in enumerate(map(float, x)):
        assert close((s.a[n], s.b[n]), tuple(solve_linear(mixed(value))), 1e-14)
    message = "determine a at some instants and not at others; solve these instants separately"
    with pytest.raises(LinearError, match=message):
        solve_linear(lambda a, b: {"p": x * a - 1.0 * x, "q": b - 2.0})


def test_names_come_from_the_arguments_or_are_given():
    assert solve_linear(lambda N, a: (N - 1.0, a + N)).names == ("N", "a")
    assert solve_linear(lambda *u: (u[0] - 1.0, u[1] + u[0]), "N, a")["a"] == -1.0
    assert list(solve_linear(lambda u: u - 2.0)) == [2.0]
    rows = np.array([[1.0, 2.0], [3.0, 4.0]])
    assert solve_linear(lambda u, v: {"rows": rows @ np.array([u, v]) - [1.0, 2.0]}).v == 0.5
    with pytest.raises(LinearError, match="the unknown 'a' is named twice"):
        solve_linear(lambda *u: u[0], "a a")
    with pytest.raises(LinearError, match="there are no unknowns"):
        solve_linear(lambda *u: 1.0)
    for name in ("values", "report"):
        with pytest.raises(LinearError, match=f"'{name}' is a part of the solution"):
            solve_linear(lambda u: u - 1.0, [name])
    twice = solve_linear(lambda a: {"both": (a - 1.0, 2 * a - 2.0)})
    assert dict(twice.redundant) == {"both.2": ("both.1",)}


def test_equations_of_one_name_are_all_reported():

    def laws(a, b):
        return {"F": ground.vector(a - 1.0, b - 2.0, 0), "F.x": 2 * a - 2.0, "F.y": 3 * b - 6.0}

    assert dict(solve_linear(laws).redundant) == {"F.x 2": ("F.x 1",), "F.y 2": ("F.y 1",)}
    with pytest.raises(LinearError, match=r"'F\.x 2' is off by 1 if 'F\.x 1' holds"):
        solve_linear(lambda a: {"F": ground.vector(a, 0, 0), "F.x": a + 1.0})


@pytest.mark.parametrize("conditions", [
    lambda w: w * w - 4.0, lambda w: sin(w) - 0.5, lambda w: 1 / w - 2.0, lambda w: w**2 - 1,
    abs, math.sin, round, lambda w: w % 2, lambda w: w - (w > 0), lambda w: w - 1 if w == 0 else w,
])  # fmt: skip
def test_what_is_not_linear_is_refused(conditions):
    for solve in (solve_linear, lambda f: solve_rates(f, 1)):
        with pytest.raises(ScalarError, match="must be linear in"):
            solve(conditions)


def test_thirty_digits_survive_beside_whole_numbers_and_the_coarsest_number_sets_round_off():
    third = mp.mpf(1) / 3
    laws = lambda a, b, c, d: (a + 2 * b - third, b - third * c, c + d - 1, d - third * a)
    assert max(map(abs, laws(*solve_linear(laws)))) < mp.mpf(10) ** -29
    with mp.workdps(30):
        assert unit_roundoff([1, mp.mpf(2)]) == unit_roundoff([mp.mpf(2)]) < 1e-28
    assert unit_roundoff([1.0, mp.mpf(2)]) == 2.0**-52


@every_kind
@pytest.mark.parametrize("count", [1, 2, 3])
@pytest.mark.parametrize("surplus", [0, 2])
def test_solve_rates_finds_one_to_three_rates_even_from_surplus_conditions(kind, count, surplus):
    m = [[2, 1, -1], [1, 3, "1/2"], [-1, 1, 4], [3, 4, "-1/2"], [1, 2, 7]]
    wanted = numbers(kind, "1/3", -2, "7/5")[:count]
    rows = [[numbers(kind, m[a][b]) for b in range(count)] for a in range(count + surplus)]
    right = [sum(c * w for c, w in zip(row, wanted, strict=True)) for row in rows]

    conditions = system(rows, right)
    assert close(solve_rates(lambda *r: tuple(conditions(*r).values()), count), wanted, 1e-11)


@every_kind
def test_solve_rates_says_that_conditions_contradict_each_other(kind):
    one, two = numbers(kind, 1, 2)
    message = r"contradict each other: with the rates that fit best, one of them is 0\.5 instead"
    with pytest.raises(FrameError, match=message):
        solve_rates(lambda w: (w - first(one), w - first(two)), 1)


@every_kind
def test_solve_rates_says_that_rates_are_left_open(kind):
    one = numbers(kind, 1)
    with pytest.raises(FrameError, match=r"1 conditions .*, but 2 rates are unknown: 1 more are"):
        solve_rates(lambda w, u: one * w + u - one, 2)
    with pytest.raises(FrameError, match="the conditions do not determine the rates"):
        solve_rates(lambda w, u: (one * w + u - one, 2 * w * one + 2 * u - one), 2)
    with pytest.raises(FrameError, match="the conditions do not determine the rates"):
        solve_rates(lambda w, u: (one * w - one, 3 * one * w - one), 2)


def test_what_determines_no_rate_or_unknown_is_refused_or_named():
    lever = np.array([1.0, 0.0, 2.0])
    with pytest.raises(FrameError, match="do not determine"):
        solve_rates(lambda w: lever * w - 1.0, 1)
    with pytest.raises(LinearError, match="1 conditions contain the rates, but 2"):
        solve_rates(lambda a, b: (a - 1.0, 1e-17 * b), 2)
    for size in (1e-12, 1.0, 1e12):
        found = solve_linear(lambda A, B, s=size: {"force": s * A + s * B - 1.0})
        assert found.undetermined == ("A", "B")

"""Appendix A in components, and the ledger that a vector keeps of its terms."""

import math
import re
from fractions import Fraction

import mpmath as mp
import numpy as np
import pytest
import sympy
from hypothesis import example, given
from hypothesis import strategies as st

from newton_euler import Dimension, Frame, at, cos, cross, dot, moving, sin
from newton_euler.algebra import ZERO, Explanation, FrameError, ScalarError, TermError, same
from newton_euler.algebra.trace import Trace
from newton_euler.algebra.vectors import named_sum
from tests.kinds import KINDS, close, every_kind, numbers, within

ground = Frame("ground")
turned = ground.rotate("turned", (1, 2, 2), 0.7)
triples = st.tuples(*(st.floats(-1e3, 1e3),) * 3)


def test_dividing_keeps_the_digits_of_the_dividend_and_of_its_rates():
    third = ground.vector(mp.mpf(1), 0, 0) / 3
    assert abs(third.x - mp.mpf(1) / 3) < 1e-30
    assert (ground.vector(sympy.Symbol("x"), 0, 0) / 3).x == sympy.Symbol("x") / 3
    v = ground.vector(moving(sympy.Integer(1), rate=1), 0, 0)
    assert (v / 3).rate(ground).x == sympy.Rational(1, 3)
    assert (2 * v / 3).rate(ground).x == sympy.Rational(2, 3)


def test_vectors_of_two_frames_combine_in_the_frame_of_the_left_one():
    a, b = ground.vector(1.0, 2.0, 3.0), turned.vector(-1.0, 0.5, 2.0)
    assert (a + b).frame is ground
    assert (b + a).frame is turned
    assert close(a + b, (b + a).expressed_in(ground))


def test_a_vector_is_read_measured_and_converted_like_a_sequence_of_three():
    v = ground.vector(1.0, 0, sympy.Symbol("q"))
    assert (v.x, v.y, v.z) == tuple(v) == v.components() == (1.0, 0, sympy.Symbol("q"))
    assert type(v.y) is int
    assert v.components(ground) == v.components()
    a = ground.vector(2.0, 0, -1.0)
    x, _, _ = a
    assert (x, a[0], a[-1], a[:2], len(a)) == (2.0, 2.0, -1.0, (2.0, 0), 3)
    assert abs(ground.vector(3.0, 0, 4.0)) == 5.0
    assert np.array(a).tolist() == a.to_array().tolist() == [2.0, 0.0, -1.0]
    rows = ground.vector(np.array([1.0, 2.0]), 0, 5.0).to_array()
    assert rows.tolist() == [[1.0, 2.0], [0.0, 0.0], [5.0, 5.0]]
    with pytest.raises(IndexError):
        a[3]


@pytest.mark.parametrize(("wrong", "message"), [
    (lambda a: a * a, r"two vectors have two products: write a.dot\(b\) or a.cross\(b\)"),
    (lambda a: a / a, "a vector cannot be divided by a vector"),
    (lambda a: 1 / a, "nothing can be divided by a vector: 1"),
    (lambda a: a + 1, "cannot add the vector .* and 1: both must be vectors"),
    (lambda a: 1 + a, "cannot add the vector .* and 1: both must be vectors"),
    (lambda a: a - "b", "cannot subtract the vector .* and 'b': both must be vectors"),
    (lambda a: a.dot((1, 2, 3)), r"cannot take the dot product of .* and \(1, 2, 3\)"),
    (lambda a: a.cross(3), "cannot take the cross product of the vector .* and 3"),
    (lambda a: np.zeros(3) + a, "both must be vectors"),
    (lambda a: a.angle_to(0 * a), "a zero vector makes no angle"),
    (lambda a: a.explain(), "was not computed as a named sum"),
])  # fmt: skip
def test_mistakes_with_vectors_are_refused_in_words(wrong, message):
    with pytest.raises(FrameError, match=message):
        wrong(ground.vector(1.0, 2.0, 3.0))


@pytest.mark.parametrize("wrong", [lambda a: a * "2", lambda a: a / "2", lambda a: a.rounded("0")])
def test_a_factor_that_is_no_number_is_refused(wrong):
    with pytest.raises(ScalarError, match="write numbers without quotation marks"):
        wrong(ground.vector(1.0, 2.0, 3.0))


def test_a_plain_vector_is_subtracted_from_a_velocity_and_from_it():
    v = named_sum("velocity", "P/ground", {"relative": 2.0 * ground.i}, ground)
    assert v - ground.i == -(ground.i - v) == ground.i


def test_equal_vectors_are_equal_and_others_are_not():
    ground, elsewhere = Frame("ground"), Frame("elsewhere")
    turned = ground.rotate("turned", "z", angle=0.3)
    a = ground.vector(1.0, 2.0, 2.0)
    assert a == ground.vector(1, 2, 2)
    assert a != ground.vector(1.0, 2.0, 2.0 + 1e-11)  # in one frame, compared to the last digit
    assert a == a.expressed_in(turned)  # in two frames, compared up to round-off
    assert a != ground.vector(1.0, 2.0, 2.001).expressed_in(turned)
    assert a != elsewhere.vector(1.0, 2.0, 2.0)
    assert (a == 3.0, a == (1.0, 2.0, 2.0)) == (False, False)
    x, angle = sympy.symbols("x angle")
    symbolic = ground.vector(x, 0, 0)
    assert symbolic == symbolic.expressed_in(ground.rotate("by angle", "z", angle=angle))
    with pytest.raises(TypeError, match="unhashable"):
        hash(a)


def test_alike_compares_relative_to_the_larger():
    a = ground.vector(1e6, 0, 0)
    assert same(a, a + ground.vector(0, 1e-7, 0))
    assert not same(a, a + ground.vector(0, 1e-3, 0))
    assert same(a, a.expressed_in(turned))
    assert same(ground.vector(0, 0, 0), turned.vector(0, 0, 0))
    assert not same(ground.vector(math.inf, 0, 0), a)
    assert same(a, 2 * a, 0.5)
    assert same(2 * a, a, 0.5)
    with pytest.raises(ScalarError, match="components without values"):
        same(a, ground.vector(sympy.nan, 0, 0))


def test_symbols_that_share_a_name_are_not_the_same():
    x, positive = sympy.Symbol("x"), sympy.Symbol("x", positive=True)
    for one, other in ((x, positive), (sympy.Dummy("x"), x)):
        assert not same(ground.vector(one, 0, 0), ground.vector(other, 0, 0))
        assert ground.vector(one - other, 0, 0).cleared().x != 0


@pytest.mark.parametrize("size", [5e-324, 1e-300, 1e-160, 1e160, 8.9e307])
def test_directions_and_angles_of_the_smallest_and_largest_vectors(size):
    a, b = ground.vector(size, 2 * size, 0), ground.vector(2 * size, -size, 0)
    assert close(a.direction(), ground.vector(1.0, 2.0, 0).direction(), 1e-15)
    assert close(a.angle_to(b), math.pi / 2, 1e-15)
    assert close(a.angle_to(ground.i), math.atan(2.0), 1e-15)
    exact = ground.vector(Fraction(3, 5) * Fraction(size), 0, Fraction(4, 5) * Fraction(size))
    assert abs(exact.norm() - size) <= max(1e-15 * size, 5e-324)
    both = np.array([min(size, 1e307), 1.0])
    angles = ground.vector(both, 2 * both, 0).angle_to(ground.vector(2 * both, -both, 0))
    assert np.allclose(angles, math.pi / 2, rtol=1e-15)


@pytest.mark.parametrize("size", [10**5, 2**63, 10**160, 10**300])
def test_directions_and_angles_of_whole_numbers_of_any_size(size):
    a, b = ground.vector(3 * size, 0, 4 * size), ground.vector(4 * size, 0.5, -3 * size)
    assert a.norm() == pytest.approx(5 * size, rel=1e-15)
    assert a.angle_to(b) == pytest.approx(math.pi / 2, rel=1e-15)
    assert a.angle_to(ground.vector(size, 0, 0)) == pytest.approx(math.atan2(4, 3), rel=1e-15)


def moving_arm():
    arm = ground.rotate("arm", "z", angle=0.3, rate=2.0, acceleration=0.5)
    return arm, arm.point("P", moving(1.0, rate=3.0), 0.2, 0).acceleration(ground)


def test_a_factor_a_quotient_and_another_frame_carry_the_terms_along():
    _, a = moving_arm()
    for changed, factor in ((2 * a, 2), (a / 4, 0.25), (-a, -1), (a.expressed_in(turned), 1)):
        assert list(changed.terms) == list(a.terms)
        for name, term in changed.terms.items():
            assert close(term, (factor * a.terms[name]).expressed_in(term.frame), 1e-14)
            assert term.frame is changed.frame
        assert close(sum(changed.terms.values()), changed, 1e-13)


def test_reweighted_and_without_are_sums_of_changed_terms():
    _, a = moving_arm()
    assert close(a.reweighted(), a)
    assert close(a.without("coriolis"), a - a.terms["coriolis"])
    changed = a - 0.5 * a.terms["coriolis"] - 2 * a.terms["euler"]
    assert close(a.reweighted(coriolis=0.5, euler=-1), changed)
    assert close(a.without(*a.terms), (0, 0, 0))
    assert (a + a).terms == ground.i.terms == {}  # a sum of vectors has none of its own
    known = "origin, relative, coriolis, euler, centripetal"
    with pytest.raises(TermError, match=f"no term 'corolis'; the terms are {known}"):
        a.without("corolis")
    with pytest.raises(TermError, match="no term 'coriolis'; there are no terms"):
        ground.i.without("coriolis")


def test_explain_prints_the_equation_its_number_and_every_term():
    _, a = moving_arm()
    first, *lines = str(a.explain("m/s^2")).splitlines()
    assert first == "acceleration of P in ground, by way of arm, equation (4.18), components in arm"
    assert "coriolis 2 omega x v_r [0, 12, 0] m/s^2" in (" ".join(x.split()) for x in lines)
    assert lines[-1].split() == ["sum", "[-4.1,", "11.7,", "0]", "m/s^2"]
    assert isinstance(a.explain(), Explanation)
    assert "N" in str((2 * a).expressed_in(ground).explain("N"))  # of 2 kg
    assert repr(a.explain()) == str(a.explain())


def test_explain_shows_latex_in_jupyter():
    arm, a = moving_arm()
    assert set(a.explain("m/s^2")._repr_mimebundle_()) == {"text/plain", "text/latex"}
    latex = a.explain().latex
    assert latex.count("{") == latex.count("}")
    assert r"\tag{4.18}" in latex
    rod = arm.rotate("rod", "x", rate=1.0)
    product = r"\boldsymbol{\omega}_{\text{arm}}\times\boldsymbol{\omega}_{\text{rod}}"
    assert product in rod.angular_acceleration(ground).explain().latex
    assert r"\tag{4.22}" in rod.angular_velocity(ground).explain().latex
    assert "equation (4.15)" in str(arm.i.rate(ground).explain())
    assert "equation (4.17)" in str(rod.point("Q", 1.0, 0, 0).velocity(ground).explain())


def test_no_underscore_of_a_name_is_bare_in_latex():
    """MathJax shows a formula with a bare underscore as an error."""
    wheel = ground.rotate("wheel_1", "z", rate=2.0).rotate("disk_2", "x", rate=1.0)
    P = wheel.point("P_1", 1.0, 0, 0)
    motion = (wheel.angular_acceleration(ground), P.velocity(ground), P.acceleration(ground))
    latex = " ".join(rate.explain().latex for rate in motion) + wheel.i.latex()
    assert r"disk\_2" in latex
    assert r"P\_1" in latex
    assert not re.search(r"[A-Za-z]_\d", re.sub(r"\\[A-Za-z]+", "", latex))


OTHERS = {"dimension": Dimension(length=1), "traced": Trace().new("argument", "x")}


@pytest.mark.parametrize("kind", [*KINDS, *OTHERS])
def test_every_kind_of_component_can_be_shown(kind):
    x = OTHERS[kind] if kind in OTHERS else numbers(kind, "1/3")
    v = ground.vector(x, 0, -2 * x)
    assert str(v).endswith("in ground")
    assert repr(v).startswith("Vector(")
    assert v.latex().count("{") == v.latex().count("}")
    assert v._repr_latex_() == f"${v.latex()}$"


def test_a_component_that_is_round_off_is_printed_as_zero_and_kept():
    v = ground.vector(1.0, 6.1e-17, -1e-13)
    assert str(v) == "[1, 0, -1e-13] in ground"
    assert r"\hat{\jmath}" not in v.latex()
    assert v.y == 6.1e-17


@pytest.mark.parametrize(("components", "latex"), [
    ((1.5, -2e-7, 0), r"\left(1.5\,\hat{\imath}-2\times10^{-7}\,\hat{\jmath}\right)_{\text{ground}}"),
    ((12345.678, 0, 0), r"\left(12346\,\hat{\imath}\right)_{\text{ground}}"),
    ((0, 0, 0), r"\mathbf{0}"),
    ((0, sympy.Symbol("a") + 1, 0), r"\left(\left(a + 1\right)\,\hat{\jmath}\right)_{\text{ground}}"),
])  # fmt: skip
def test_latex_writes_signs_and_powers_of_ten(components, latex):
    assert ground.vector(*components).latex() == latex


small = within(1e-14, 27)


def three_vectors(kind):
    components = ("1.5", "-0.7", "0.4"), ("-0.3", "1.2", "0.9"), ("0.8", "0.6", "-1.1")
    return [ground.vector(*numbers(kind, *c)) for c in components]


@every_kind
def test_eqn_A_1_a_vector_is_its_magnitude_times_its_direction(kind):
    P, _, _ = three_vectors(kind)
    assert close(P.norm() * P.direction(), P, small(kind))
    assert close(P.direction().norm(), 1, small(kind))
    with pytest.raises(FrameError, match="zero vector has no direction"):
        (P - P).direction()


@every_kind
def test_eqn_A_2_dot_product_is_magnitudes_times_cosine(kind):
    P, Q, _ = three_vectors(kind)
    assert close(dot(P, Q), P.norm() * Q.norm() * cos(P.angle_to(Q)), 10 * small(kind))


@every_kind
def test_eqn_A_3_and_A_5_products_of_the_unit_vectors(kind):
    one = numbers(kind, 1) if kind != "array" else np.ones(3)
    i, j, k = ground.vector(one, 0, 0), ground.vector(0, one, 0), ground.vector(0, 0, one)
    products = [[e.dot(f) for f in (i, j, k)] for e in (i, j, k)]
    assert close(products, ((1, 0, 0), (0, 1, 0), (0, 0, 1)), 0)
    for e, f, g in ((i, j, k), (j, k, i), (k, i, j)):
        assert close(e.cross(f), g, 0)
        assert close(f.cross(e), -g, 0)
        assert close(e.cross(e), (0, 0, 0), 0)


@every_kind
def test_eqn_A_4_cross_product_is_normal_to_both_and_measures_the_area(kind):
    P, Q, _ = three_vectors(kind)
    product = cross(P, Q)
    assert close((product.dot(P), product.dot(Q)), (0, 0), small(kind))
    assert close(product.norm(), P.norm() * Q.norm() * sin(P.angle_to(Q)), 10 * small(kind))
    assert close(product, -cross(Q, P), 0)


@every_kind
def test_eqn_A_6_to_A_10_components_are_projections_and_add(kind):
    P, Q, _ = three_vectors(kind)
    i, j, k = ground.i, ground.j, ground.k
    assert close((P.dot(i), P.dot(j), P.dot(k)), P.components(), 0)  # A.7
    assert close(P.x * i + P.y * j + P.z * k, P, 0)  # A.6, A.8
    assert close(P + Q, (P.x + Q.x, P.y + Q.y, P.z + Q.z), 0)  # A.9, A.10


@every_kind
def test_eqn_A_11_and_A_12_dot_product_and_magnitude_in_components(kind):
    P, Q, _ = three_vectors(kind)
    # the same in any frame
    tilted = ground.rotate("tilted", numbers(kind, 1, 2, 2), numbers(kind, "0.8"))
    pairs = zip(P.components(tilted), Q.components(tilted), strict=True)
    assert close(P.dot(Q), sum(p * q for p, q in pairs), small(kind))
    assert close(dot(P, P), P.norm() ** 2, small(kind))
    (a, b, c), (d, e, f) = P, Q
    assert close(P.dot(Q), a * d + b * e + c * f, 0)


@every_kind
def test_eqn_A_13_and_A_14_cross_product_is_the_determinant(kind):
    P, Q, _ = three_vectors(kind)
    (a, b, c), (d, e, f) = P, Q
    assert close(P.cross(Q), (b * f - c * e, -(a * f - c * d), a * e - b * d), 0)


@every_kind
def test_eqn_A_15_triple_scalar_product_is_cyclic(kind):
    P, Q, R = three_vectors(kind)
    assert close(P.dot(Q.cross(R)), Q.dot(R.cross(P)), small(kind))
    assert close(P.dot(Q.cross(R)), R.dot(P.cross(Q)), small(kind))


@every_kind
def test_eqn_A_16_triple_vector_product(kind):
    P, Q, R = three_vectors(kind)
    assert close(P.cross(Q).cross(R), R.dot(P) * Q - R.dot(Q) * P, small(kind))
    assert not close(P.cross(Q).cross(R), P.cross(Q.cross(R)), 1e-3)


@every_kind
def test_eqn_A_17_to_A_21_rates_and_product_rules(kind):
    a, b, t = numbers(kind, "0.4", "1.7", "0.6")
    P = lambda t: a * t**2, lambda t: sin(b * t), lambda t: 1 + a * t
    Q = cos, lambda t: b * t**3, lambda t: a - t
    u = lambda t: 2 + sin(a * t)
    p, q = (ground.vector(*(at(f, t) for f in fs)) for fs in (P, Q))
    v = at(u, t)
    dp, dq = p.rate(ground), q.rate(ground)
    written_out = lambda component: tuple(at(component(n), t).rate for n in range(3))
    tiny = small(kind)
    assert close((p + q).rate(ground), written_out(lambda n: lambda s: P[n](s) + Q[n](s)), tiny)
    assert close((v * p).rate(ground), written_out(lambda n: lambda s: u(s) * P[n](s)), tiny)
    assert close((v * p).rate(ground), v.value * dp + v.rate * p, tiny)
    assert close((p / v).rate(ground), written_out(lambda n: lambda s: P[n](s) / u(s)), tiny)
    product = at(lambda s: P[0](s) * Q[0](s) + P[1](s) * Q[1](s) + P[2](s) * Q[2](s), t)
    assert close(p.dot(dq) + q.dot(dp), product.rate, small(kind))

    def crossed(n):
        m, k = (n + 1) % 3, (n + 2) % 3
        return lambda s: P[m](s) * Q[k](s) - P[k](s) * Q[m](s)

    assert close(p.cross(q).rate(ground), written_out(crossed), tiny)
    assert close(p.cross(q).rate(ground), p.cross(dq) + dp.cross(q), small(kind))


@given(st.floats(-300, 300), st.floats(-300, 300), st.floats(0.3, 3.0), st.floats(-1.0, 1.0))
@example(-200.0, -200.0, 1.0, 0.5)
@example(200.0, 200.0, 1.0, 0.5)
def test_eqn_A_12_a_norm_is_right_wherever_it_is_a_float(power, other, theta, phi):
    x, y, z = 10.0**power * math.cos(theta), 10.0**other * math.sin(theta), -(10.0**power) * phi
    exact = float(mp.sqrt(mp.fsum(mp.mpf(c) ** 2 for c in (x, y, z))))
    assert ground.vector(x, y, z).norm() == pytest.approx(exact, rel=1e-15, abs=0)
    many = ground.vector(np.array([x, 3.0, 0.0]), np.array([y, 4.0, 0.0]), np.array([z, 0.0, 0.0]))
    assert many.norm() == pytest.approx([exact, 5.0, 0.0], rel=1e-15, abs=0)
    plane = ground.vector(x, np.float64(y), 0).norm()
    assert plane == pytest.approx(math.hypot(x, y), rel=1e-15, abs=0)


def test_a_norm_keeps_structural_zeros_and_the_kind_of_the_components():
    assert ground.vector(0, 0, 0).c == (ZERO,) * 3
    assert type(ground.vector(0, 0, 0).norm()) is int
    tiny = mp.mpf(10) ** -400
    assert close(ground.vector(3 * tiny, 4 * tiny, 0).norm() / tiny, 5, 1e-28)
    assert ground.vector(3, sympy.Symbol("x"), 0).norm() == sympy.sqrt(sympy.Symbol("x") ** 2 + 9)
    assert ground.vector(Dimension(0, 1), Dimension(0, 1), 0).norm() == Dimension(0, 1)


def test_a_sum_by_another_equation_keeps_its_subject_and_terms_and_its_opposite_the_unit():
    v = named_sum("velocity", "P/ground", {"origin": ground.i, "relative": ground.j}, ground)
    other = v.as_sum("angular velocity")
    assert (other.equation.kind, [*other.terms]) == ("angular velocity", ["origin", "relative"])
    assert "angular velocity P/ground" in str(other.explain())
    assert (v.equation.kind, ground.i.equation) == ("velocity", None)
    with pytest.raises(TermError, match="in m/s: it cannot be explained in 'N'"):
        (-v).explain("N")


@pytest.mark.parametrize("size", [1e-290, 1e-170, 1.0, 1e170, 1e290, mp.mpf("1e-600")])
def test_angles_do_not_depend_on_sizes_of_any_kind(size):
    expected = math.pi / 4
    for a, b in ((size, 1.0), (size, size), (1.0, size)):
        one, other = (ground.vector(x, 0, 0) for x in (a, b))
        turned = other + ground.vector(0, b, 0)
        assert float(one.angle_to(turned)) == pytest.approx(expected, rel=1e-12)
        if isinstance(size, float):
            with np.errstate(all="ignore"):
                several = ground.vector(np.array([a, 1.0]), 0, 0).angle_to(turned)
            assert several == pytest.approx([expected] * 2, rel=1e-12)
